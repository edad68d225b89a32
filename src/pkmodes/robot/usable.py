"""The table ``[usable]`` of a robot file: where the machine is used, as limits of components of the pose.

Maps without a grid, pictures and proposed measurements stay inside.  The limits are no parameters: nothing depends on
them, and they have no standard deviation.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import nearest, shown
from pkmodes.mechanism.described import Mechanism
from pkmodes.robot import schema
from pkmodes.robot.units import SHOWN, article, dimension_of

USABLE = "usable"
ENDS = ("min", "max")

#: The lower and the upper limit of a component of the pose [SI].
Limits = tuple[float, float]


def read_usable(
    mechanism: Mechanism, raw: Any, problem: Callable[[str, str, str], None]
) -> dict[str, Limits]:
    """Read the table.

    Parameters
    ----------
    raw : object
        The table in the parsed file.
    problem : callable
        Takes the path, what is wrong, and the remedy of each problem.

    Returns
    -------
    dict of str to tuple of float
        Lower and upper limit [SI] of the components that the table names, in the order of the pose.
    """
    units = {component.name: component.unit for component in mechanism.pose}
    if not isinstance(raw, Mapping):
        problem(
            USABLE,
            f"expected a table, found {shown(raw)}",
            f"write {_example(*list(units.items())[-1])} below [{USABLE}]",
        )
        return {}
    limits: dict[str, Limits] = {}
    for name, given in raw.items():
        if name not in units:
            what = f"expected a component of the pose, found {shown(name)}"
            problem(f"{USABLE}.{_key(name)}", what, nearest(name, units))
            continue
        try:
            limits[name] = _limits(given, name, units[name])
        except schema.RefusedError as error:
            place = f"{USABLE}.{name}" + (f".{error.element}" if error.element else "")
            problem(place, error.what, error.remedy)
    return {name: limits[name] for name in units if name in limits}


def limits_of(
    mechanism: Mechanism, usable: Mapping[str, Limits]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the lower and the upper limits of all components, (d,) each, infinite where there are none."""
    ends = [usable.get(component.name, (-np.inf, np.inf)) for component in mechanism.pose]
    return np.array([low for low, _ in ends]), np.array([high for _, high in ends])


def _limits(raw: Any, name: str, unit: str) -> Limits:
    dimension, remedy = dimension_of(unit), f"write two limits, such as {_example(name, unit)}"
    if not isinstance(raw, list) or len(raw) != len(ENDS):
        found = f"a list of {len(raw)}" if isinstance(raw, list) else shown(raw)
        raise schema.RefusedError(f"expected the lower and the upper limit, found {found}", remedy)
    ends = []
    for end, element in zip(ENDS, raw, strict=True):
        if isinstance(element, Mapping):
            what = f"expected {article(dimension)}, found a table: a limit has no standard deviation"
            raise schema.RefusedError(what, remedy, end)
        try:
            ends.append(schema.quantity(element, dimension).value)
        except schema.RefusedError as error:
            raise schema.RefusedError(error.what, error.remedy, end) from None
    low, high = ends
    if low >= high:
        found = f"{low:g} {unit} twice" if low == high else f"{low:g} {unit} before {high:g} {unit}"
        what = f"expected the lower limit first and a higher one, found {found}"
        raise schema.RefusedError(what, remedy if low == high else "exchange them, or check the signs")
    return low, high


def _example(name: str, unit: str) -> str:
    unit = SHOWN.get(unit, (unit, 1.0))[0]
    return f'{name} = ["-100 {unit}", "100 {unit}"]'


def _key(name: str) -> str:
    """Return a key as it can stand in a path."""
    return name if schema.is_bare(name) else shown(name)
