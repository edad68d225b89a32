"""Read the modes measured on a robot: the columns of its mechanism, or of any mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Any

from pkmodes.core.base.drives import checked_drives
from pkmodes.core.base.errors import MeasurementError, PkmodesError, shown
from pkmodes.core.mechanism.registry import Mechanism, mechanism, names
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.measured.columns import joined_with
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.updating.channels import channels
from pkmodes.updating.load_cases import settable
from pkmodes.updating.measured_robot import columns_of_others, robot_of


def read(
    path: str | Path,
    band: tuple[float, float] | None = None,
    robot: Robot | Model | None = None,
    *,
    drives: str | None = None,
    priors: Mapping[str, float | str] = MappingProxyType({}),
    usable: Mapping[str, Any] = MappingProxyType({}),
) -> Measurements:
    """Read the modes measured on a robot.

    Parameters
    ----------
    path : path-like
        A CSV file with one row for each identified mode (docs/diagnosis.md, "What goes in").
    band : tuple of two floats, optional
        Lowest and highest frequency of the test [Hz], if the file does not state it.
    robot : Robot or Model, optional
        Robot whose mechanism defines the allowed columns; by default those of any mechanism.
    drives : {"free", "held"}, optional
        What the motors did in the test, if the file does not state it: they turned freely, which is the default, or
        position loops held them.
    priors : mapping of str to float or str, optional
        Standard deviations of candidates of a diagnosis by name, numbers in SI units or text with a unit, beside
        those that the file states.
    usable : mapping of str to value, optional
        Where the next measurement may be, as in ``[usable]`` of a robot file, ``{"z": ["0 mm", "200 mm"]}``, whose
        limits of the same name it replaces; beside what the file states.

    Returns
    -------
    Measurements
        In SI units and Hz.

    Raises
    ------
    MeasurementError
        If anything in the file is wrong, it states something else than an argument, or a row lies outside the band.
    """
    if not isinstance(path, str | PathLike):
        raise PkmodesError(f"expected a path, found {shown(path)}", "read", "give the name of a CSV file")
    of = None if robot is None else robot_of(robot)
    mechanisms = [mechanism(name) for name in names()] if of is None else [of.mechanism]
    data = read_measurements(
        path,
        {name: unit for one in mechanisms for name, unit in channels(one).items()},
        components=[_components(one) for one in mechanisms],
        settings={name: unit for one in mechanisms for name, unit in settable(one, of).items()},
        drives=None if drives is None else checked_drives(drives),
        others=dict if of is None else partial(columns_of_others, of.mechanism),
    )
    if band is not None and data.band not in (None, band):
        stated = f"{data.band[0]:g} Hz to {data.band[1]:g} Hz"
        what = f"the file states the band {stated}, not {band[0]:g} Hz to {band[1]:g} Hz"
        raise MeasurementError(what, data.source, "leave the band out, or correct the file")
    return replace(
        data,
        band=data.band if band is None else band,
        priors=joined_with(data.priors, priors, "priors"),
        usable=joined_with(data.usable, usable, "usable"),
    )


def _components(mechanism: Mechanism) -> dict[str, str]:
    """Return the components of a pose and their units: columns of a measurement file."""
    return {component.name: component.unit for component in mechanism.pose}
