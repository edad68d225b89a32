"""Checks of the arguments of `diagnose`, `update` and `compare`, before anything is computed."""

from __future__ import annotations

import numpy as np

from pkmodes.core.base.drives import HELD
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.matrices import at_measured_setups
from pkmodes.loop.diagnosis.problem import Driven, Structure
from pkmodes.loop.measured.measurements import Measurements


def checked_structure(structure: Structure, data: Measurements) -> Structure:
    """Return a structure at the measured setups; refuse invalid structures, data and priors, and unnamed setups."""
    if not callable(getattr(structure, "predict", None)) or not hasattr(structure, "candidates"):
        remedy = "give a structure, such as a MatrixStructure; for a robot, use pkmodes.loop.updating"
        raise PkmodesError(f"expected a structure, found {shown(structure)}", "structure", remedy)
    check_measurements(data, "pkmodes.loop.diagnosis.read_measurements(path, channels)")
    if getattr(structure, "setups", None) == ("",) and len(data.labels) > 1:
        labels = ", ".join(f'"{label}"' for label in data.labels[:3]) + (
            ", ..." if len(data.labels) > 3 else ""
        )
        problem = f"{len(data.labels)} setups were measured, but the structure names none"
        raise PkmodesError(problem, "setups", f"pass setups=[{labels}] to MatrixStructure")
    for name in data.settings:
        if name not in getattr(structure, "settings", ()):
            problem = f"the measurements set {shown(name)}, which the structure does not have"
            raise PkmodesError(
                problem, data.source, "leave it out, or model it in the setups of the structure"
            )
    if HELD in data.drives and not isinstance(structure, Driven):
        problem = "the measurements say that motors were held, but the structure has no motors"
        raise PkmodesError(
            problem, data.source, "leave drives out, or model it in the setups of the structure"
        )
    for candidate in structure.candidates:
        _check_prior(candidate.name, candidate.sigma, len(candidate.parameters))
    return at_measured_setups(structure, data.labels)


def check_measurements(data: object, reader: str) -> None:
    """Refuse an object that is not measurements, or has no rows.

    - reader: call that reads measurements, for the message
    """
    if not isinstance(data, Measurements):
        problem = f"expected measurements, found {shown(data)}"
        raise PkmodesError(
            problem, "data", f"read them with {reader}, or build them with Measurements.from_rows"
        )
    if not len(data.frequency):
        raise PkmodesError("expected measurements, found no rows", data.source, "add at least one row")


def _check_prior(name: str, sigma: object, parameter_count: int) -> None:
    """Refuse a candidate's prior unless it is one positive number for each of its parameters."""
    if sigma is None:
        return
    where = f"candidate {shown(name)}: sigma"
    if not isinstance(sigma, list | tuple | np.ndarray) or len(sigma) != parameter_count:
        actual = f"{len(sigma)}" if isinstance(sigma, list | tuple | np.ndarray) else shown(sigma)
        plural = "s" if parameter_count > 1 else ""
        problem = f"expected a tuple of {parameter_count} standard deviation{plural}, found {actual}"
        is_single_number = isinstance(sigma, int | float) and parameter_count == 1
        raise PkmodesError(
            problem, where, f"write ({sigma},)" if is_single_number else "give one for each of its parameters"
        )
    for deviation in sigma:
        is_number = isinstance(deviation, int | float | np.integer | np.floating) and not isinstance(
            deviation, bool
        )
        if not is_number or not 0.0 < deviation < np.inf:
            problem = f"expected a standard deviation above 0, found {shown(deviation)}"
            raise PkmodesError(problem, where, "leave it out if unknown")
