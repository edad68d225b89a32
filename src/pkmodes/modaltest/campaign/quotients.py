"""The kind of a frequency response by its units: a motion over a force, or a quotient that has other poles.

The poles of a motion over a force are those of the structure.  Those of a motion over a motion, a transmissibility,
are zeros of the motion in the denominator, and so are those of a force over a motion (Ewins, Modal Testing, 2nd
edition, 2000, section 2.2).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.modaltest.campaign.motion import Motion, base_factor, motion_or_none
from pkmodes.modaltest.signals.functions import Array, Complex, Function, derived_function

#: Powers of the base units of a force and of a torque, the force of an angle.
FORCES = ({"gram": 1.0, "meter": 1.0, "second": -2.0}, {"gram": 1.0, "meter": 2.0, "second": -2.0})
#: Names of a force over a displacement, a velocity and an acceleration.
INVERSES = ("dynamic stiffness", "mechanical impedance", "dynamic mass")
UNKNOWN_UNIT = "an unknown unit"


def force_factor(function: Function, source: str, declared: Motion | None = None) -> float:
    """Return the factor of the denominator of a frequency response to SI units, 1 if the file does not state it.

    - declared: motion of the sensor as declared in the campaign

    Raises MeasurementError if the file states that it is not a motion over a force.
    """
    where, unit_text = _function_name(function, source), _unit_text(function)
    denominator = None if function.reference_unit is None else motion_or_none(function.reference_unit)
    if _is_force(function.unit):
        kind = f", a {INVERSES[denominator.derivative]}" if denominator else ""
        problem = f"expected a motion over a force, found {unit_text}{kind}"
        problem += f", and the campaign says {shown(declared.unit)}" if declared else ""
        remedy = (
            "export motion over force; or, if one force acted at a time, write invert = true in the record"
        )
        raise MeasurementError(problem, where, remedy if denominator else "leave it out: it shows no motion")
    if denominator:
        problem = f"expected a motion over a force, found {unit_text}, a transmissibility, whose poles are not modes"
        remedy = 'measure the force; or give the responses in time, without a force, as kind = "ambient"'
        raise MeasurementError(problem, where, remedy)
    return 1.0 if function.reference_unit is None else force_unit_factor(function.reference_unit)


def force_unit_factor(unit: str) -> float:
    """Return the factor of a unit of force, or of volts, to SI units."""
    factor, powers = base_factor(unit, "")
    return float(factor / 1000.0 ** powers.get("gram", 0.0))


def invert_functions(functions: Sequence[Function], source: str) -> tuple[Function, ...]:
    """Return motions over forces from forces over motions, each measured while one force acted.

    Raises MeasurementError if the file states that one is not a force over a motion, or has as many references as
    sensors: these may be the inverse of a matrix or reciprocals of single functions.
    """
    for function in functions:
        force_in_denominator = _is_force(function.reference_unit)
        if force_in_denominator or (function.unit is not None and not _is_force(function.unit)):
            problem = f"expected a force over a motion, as invert says, found {_unit_text(function)}"
            raise MeasurementError(problem, _function_name(function, source), "leave invert out")
    sensors = len({function.response for function in functions})
    if 1 < sensors == len({function.reference for function in functions}):
        problem = f"cannot invert the functions of {sensors} sensors and {sensors} references: they may be"
        problem += " reciprocals one by one, or the inverse of their matrix"
        raise MeasurementError(problem, source, "export motion over force")
    return tuple(
        derived_function(function, _reciprocal, (function.reference_unit, function.unit))
        for function in functions
    )


def _reciprocal(values: Array | Complex) -> Complex:
    """Return 1 / values, NaN where they are 0."""
    return np.asarray(np.divide(1.0, values, out=np.full(values.shape, np.nan, complex), where=values != 0.0))


def _is_force(unit: str | None) -> bool:
    if unit is None:
        return False
    powers = base_factor(unit, "")[1]
    return {name: power for name, power in powers.items() if name != "radian"} in FORCES


def _function_name(function: Function, source: str) -> str:
    return f"{source}: {function.response}/{function.reference}".removesuffix("/")


def _unit_text(function: Function) -> str:
    return f"{function.unit or UNKNOWN_UNIT} over {function.reference_unit or UNKNOWN_UNIT}"
