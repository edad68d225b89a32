"""What a frequency response is by its units: a motion over a force, or a quotient that has other poles.

The poles of a motion over a force are those of the structure.  Those of a motion over a motion, a transmissibility,
are zeros of the motion below, and so are those of a force over a motion (Ewins, Modal Testing, 2nd edition, 2000,
section 2.2).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.campaign.motion import Motion, base, motion_or_none
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.signals.functions import Array, Complex, Function, computed

#: Powers of the base units of a force and of a torque, which is that of an angle.
FORCES = ({"gram": 1.0, "meter": 1.0, "second": -2.0}, {"gram": 1.0, "meter": 2.0, "second": -2.0})
#: What a force over a displacement, a velocity and an acceleration is called.
INVERSES = ("dynamic stiffness", "mechanical impedance", "dynamic mass")
UNKNOWN = "an unknown unit"


def force_factor(one: Function, source: str, said: Motion | None = None) -> float:
    """Return the factor of the denominator of a frequency response to SI units, 1 where the file does not say it.

    Parameters
    ----------
    said : Motion, optional
        What the campaign says of the sensor.

    Raises
    ------
    MeasurementError
        If the file says that it is not a motion over a force.
    """
    where, found = _place(one, source), _words(one)
    below = None if one.reference_unit is None else motion_or_none(one.reference_unit)
    if _is_force(one.unit):
        kind = f", a {INVERSES[below.derivative]}" if below else ""
        what = f"expected a motion over a force, found {found}{kind}"
        what += f", and the campaign says {shown(said.unit)}" if said else ""
        remedy = (
            "export motion over force; or, if one force acted at a time, write invert = true in the record"
        )
        raise MeasurementError(what, where, remedy if below else "leave it out: it shows no motion")
    if below:
        what = f"expected a motion over a force, found {found}, a transmissibility, whose poles are not modes"
        remedy = 'measure the force; or give the responses in time, without a force, as kind = "ambient"'
        raise MeasurementError(what, where, remedy)
    return 1.0 if one.reference_unit is None else force_in(one.reference_unit)


def force_in(unit: str) -> float:
    """Return the factor of a unit of force, or of volts, to SI units."""
    factor, powers = base(unit, "")
    return float(factor / 1000.0 ** powers.get("gram", 0.0))


def inverted(functions: Sequence[Function], source: str) -> tuple[Function, ...]:
    """Return motions over forces from forces over motions, each measured while one force acted.

    Raises
    ------
    MeasurementError
        If the file says that one is not a force over a motion, or has as many references as sensors: whether these
        are the inverse of a matrix or reciprocals of single functions, nothing tells.
    """
    for one in functions:
        force_below = _is_force(one.reference_unit)
        if force_below or (one.unit is not None and not _is_force(one.unit)):
            what = f"expected a force over a motion, as invert says, found {_words(one)}"
            raise MeasurementError(what, _place(one, source), "leave invert out")
    sensors = len({one.response for one in functions})
    if 1 < sensors == len({one.reference for one in functions}):
        what = f"cannot invert the functions of {sensors} sensors and {sensors} references: they may be reciprocals"
        what += " one by one, or the inverse of their matrix"
        raise MeasurementError(what, source, "export motion over force")
    return tuple(computed(one, _reciprocal, (one.reference_unit, one.unit)) for one in functions)


def _reciprocal(values: Array | Complex) -> Complex:
    """Return 1 / values, NaN where they are 0."""
    return np.asarray(np.divide(1.0, values, out=np.full(values.shape, np.nan, complex), where=values != 0.0))


def _is_force(unit: str | None) -> bool:
    if unit is None:
        return False
    powers = base(unit, "")[1]
    return {name: power for name, power in powers.items() if name != "radian"} in FORCES


def _place(one: Function, source: str) -> str:
    return f"{source}: {one.response}/{one.reference}".removesuffix("/")


def _words(one: Function) -> str:
    return f"{one.unit or UNKNOWN} over {one.reference_unit or UNKNOWN}"
