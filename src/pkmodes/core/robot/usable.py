"""The table ``[usable]`` of a robot file: where the machine is used.

It limits components of the pose, the distance from an axis along z, and the angle of every rod to its singular
direction.  Maps without a grid, pictures and proposed measurements stay inside.  The limits are not parameters:
nothing depends on them, and they have no standard deviation.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from pkmodes.core.base.errors import nearest_name, shown
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.poses import reason_meanings
from pkmodes.core.mechanism.rods import rods_of
from pkmodes.core.robot import schema
from pkmodes.core.robot.units import DISPLAY_UNITS, article, dimension_of

USABLE = "usable"
LIMIT_NAMES = ("min", "max")
#: Limits that do not belong to one component of the pose, and the components that the radius combines.
RADIUS, SINGULAR_ANGLE = "radius", "singular_angle"
RADIUS_COMPONENTS = ("x", "y")
#: Examples of these two as a file gives them.
LIMIT_EXAMPLES = {RADIUS: f'{RADIUS} = "120 mm"', SINGULAR_ANGLE: f'{SINGULAR_ANGLE} = "15 deg"'}
RADIUS_REMEDY = (
    f'write {LIMIT_EXAMPLES[RADIUS]}, or radius = {{ value = "120 mm", about = ["0 mm", "0 mm"] }}'
)
ANGLE_REMEDY = f"write {LIMIT_EXAMPLES[SINGULAR_ANGLE]}"


class Limits(NamedTuple):
    """The lower and the upper limit of a component of the pose [SI]."""

    low: float
    high: float


class Radius(NamedTuple):
    """The largest distance from an axis along z, and where the axis is, (x, y) [m]."""

    value: float
    about: tuple[float, float]


class SingularAngle(NamedTuple):
    """The least angle of a rod to its singular direction [rad]."""

    value: float


#: A limit of the table.
Bound = Limits | Radius | SingularAngle


def read_usable(mechanism: Mechanism, raw: Any, problem: Callable[[str, str, str], None]) -> dict[str, Bound]:
    """Read the table.

    - raw: the table in the parsed file
    - problem: takes the path, what is wrong, and the remedy of each problem

    Returns the bounds in SI units: components of the pose in its order, then the others.
    """
    units = {component.name: component.unit for component in mechanism.pose}
    if not isinstance(raw, Mapping):
        problem(
            USABLE,
            f"expected a table, found {shown(raw)}",
            f"write {_example(*list(units.items())[-1])} below [{USABLE}]",
        )
        return {}
    readers: dict[str, Callable[[Any], Bound]] = {
        name: partial(_limits, name=name, unit=unit) for name, unit in units.items()
    }
    special = [name for name in _special_limits(mechanism) if name not in units]
    readers |= {name: SPECIAL_READERS[name] for name in special}
    bounds: dict[str, Bound] = {}
    for name, entry in raw.items():
        if name not in readers:
            special_text = "".join(f"{' or' if limit is special[-1] else ','} {limit}" for limit in special)
            message = f"expected a component of the pose{special_text}, found {shown(name)}"
            missing = MISSING_PROPERTY.get(name, "")
            if missing:
                message = f"{mechanism.name} has {missing}"
            remedy = f"leave {name} out" if missing else nearest_name(name, readers)
            problem(f"{USABLE}.{name if schema.is_bare_key(name) else shown(name)}", message, remedy)
            continue
        try:
            bounds[name] = readers[name](entry)
        except schema.RefusedError as error:
            place = f"{USABLE}.{name}" + (f".{error.element}" if error.element else "")
            problem(place, error.what, error.remedy)
    return {name: bounds[name] for name in readers if name in bounds}


def limit_examples(mechanism: Mechanism) -> dict[str, str]:
    """Return an example, by name, of how each limit that a mechanism can have is written in the table."""
    examples = {component.name: _example(component.name, component.unit) for component in mechanism.pose}
    return examples | {
        name: LIMIT_EXAMPLES[name] for name in _special_limits(mechanism) if name not in examples
    }


def meanings_of_reason_codes(mechanism: Mechanism, usable: Mapping[str, Bound]) -> dict[str, str]:
    """Return why a pose may be left out of a result: code and meaning, in the order of the checks."""
    meanings = reason_meanings(mechanism)
    if is_box(usable):
        return meanings
    meaning = f"the pose is left out, beyond the usable limits: {limits_in_words(mechanism, usable)}"
    return {**meanings, USABLE: meaning}


def is_box(usable: Mapping[str, Bound]) -> bool:
    """Return whether all limits are of components: the usable poses then form a box, and every grid lies inside."""
    return all(map(is_component_limit, usable.values()))


def limit_in_file(bound: Bound) -> Any:
    """Return a limit as a robot file could contain it, in SI units."""
    if is_component_limit(bound):
        return list(bound)
    if isinstance(bound, Radius) and any(bound.about):
        return {"value": bound.value, "about": list(bound.about)}
    return bound[0]


def limit_values(mechanism: Mechanism, usable: Mapping[str, Bound]) -> dict[str, tuple[float, str]]:
    """Return all limits by their path, each with its SI unit, in the order of the pose and then of the others."""
    units = {component.name: component.unit for component in mechanism.pose}
    numbers: dict[str, tuple[float, str]] = {}
    for name in (*units, *SPECIAL_READERS):
        bound = usable.get(name)
        path = f"{USABLE}.{name}"
        if isinstance(bound, SingularAngle):
            numbers[path] = bound.value, "rad"
        elif isinstance(bound, Radius):
            numbers[path] = bound.value, "m"
            if any(bound.about):
                numbers |= {
                    f"{path}.about.{limit}": (bound.about[k], "m")
                    for k, limit in enumerate(RADIUS_COMPONENTS)
                }
        elif bound is not None:
            numbers |= {f"{path}.{limit}": (bound[k], units[name]) for k, limit in enumerate(LIMIT_NAMES)}
    return numbers


def limits_in_words(mechanism: Mechanism, usable: Mapping[str, Bound]) -> str:
    """Return all limits as text."""
    units = {component.name: component.unit for component in mechanism.pose}
    parts = []
    for name in (*units, *SPECIAL_READERS):
        bound = usable.get(name)
        if isinstance(bound, SingularAngle):
            parts.append(singular_angle_text(bound.value))
        elif isinstance(bound, Radius):
            axis = ", ".join(
                f"{coordinate} = {value:.4g} m"
                for coordinate, value in zip(RADIUS_COMPONENTS, bound.about, strict=True)
            )
            parts.append(f"at most {bound.value:.4g} m from {axis}")
        elif bound is not None:
            parts.append(f"{name} from {bound[0]:.4g} to {bound[1]:.4g} {units[name]}")
    return ", ".join(parts)


def singular_angle_text(angle: float) -> str:
    """Return the condition that no rod is nearer than an angle [rad] to its singular direction, as text."""
    return f"every rod at least {np.degrees(angle):.4g} deg from its singular direction"


def is_component_limit(bound: Bound) -> bool:
    """Return whether a limit is that of a component of the pose."""
    return not isinstance(bound, Radius | SingularAngle)


def _limits(raw: Any, name: str, unit: str) -> Limits:
    dimension, remedy = dimension_of(unit), f"write two limits, such as {_example(name, unit)}"
    low, high = _numbers(raw, LIMIT_NAMES, "the lower and the upper limit", dimension, remedy)
    if low >= high:
        actual = f"{low:g} {unit} twice" if low == high else f"{low:g} {unit} before {high:g} {unit}"
        problem = f"expected the lower limit first and a higher one, found {actual}"
        raise schema.RefusedError(problem, remedy if low == high else "exchange them, or check the signs")
    return Limits(low, high)


def _radius(raw: Any) -> Radius:
    value, about = raw, (0.0, 0.0)
    if isinstance(raw, Mapping):
        if "value" not in raw or not raw.keys() <= {"value", "about"}:
            keys = ", ".join(map(shown, raw)) or "an empty table"
            raise schema.RefusedError(
                f'expected a table with "value" and "about", found {keys}: a limit has no standard deviation'
                if "sigma" in raw
                else f'expected a table with "value" and "about", found {keys}',
                RADIUS_REMEDY,
            )
        value = raw["value"]
        if "about" in raw:
            try:
                x, y = _numbers(
                    raw["about"], RADIUS_COMPONENTS, "x and y of the axis", "length", RADIUS_REMEDY
                )
            except schema.RefusedError as error:
                element = f"about.{error.element}".removesuffix(".")
                raise schema.RefusedError(error.what, error.remedy, element) from None
            about = x, y
    return Radius(_number(value, "length", RADIUS_REMEDY, above=0.0), about)


def _singular_angle(raw: Any) -> SingularAngle:
    value = _number(raw, "angle", ANGLE_REMEDY, above=0.0)
    if value >= np.pi / 2:
        problem = f"expected an angle below 90 deg, found {shown(raw)}"
        raise schema.RefusedError(f"{problem}, which is {np.degrees(value):.4g} deg", ANGLE_REMEDY)
    return SingularAngle(value)


#: Readers of the limits that do not belong to one component, and the property missing in mechanisms to which a limit
#: does not apply.
SPECIAL_READERS: dict[str, Callable[[Any], Bound]] = {RADIUS: _radius, SINGULAR_ANGLE: _singular_angle}
MISSING_PROPERTY = {
    RADIUS: "no radius: its pose has no lengths x and y",
    SINGULAR_ANGLE: "no singular angle: it has no rods between a carriage or arm and the platform",
}


def _special_limits(mechanism: Mechanism) -> list[str]:
    """Return the limits that do not belong to one component of the pose and that a mechanism can have."""
    lengths = {component.name for component in mechanism.pose if component.unit == "m"}
    available = {RADIUS: lengths >= set(RADIUS_COMPONENTS), SINGULAR_ANGLE: bool(rods_of(mechanism))}
    return [name for name in SPECIAL_READERS if available[name]]


def _numbers(raw: Any, elements: Sequence[str], expected: str, dimension: str, remedy: str) -> list[float]:
    """Read a list of quantities without standard deviations."""
    if not isinstance(raw, list) or len(raw) != len(elements):
        actual = f"a list of {len(raw)}" if isinstance(raw, list) else shown(raw)
        raise schema.RefusedError(f"expected {expected}, found {actual}", remedy)
    values = []
    for name, element in zip(elements, raw, strict=True):
        try:
            values.append(_number(element, dimension, remedy))
        except schema.RefusedError as error:
            raise schema.RefusedError(error.what, error.remedy, name) from None
    return values


def _number(raw: Any, dimension: str, remedy: str, above: float | None = None) -> float:
    """Read a quantity without a standard deviation."""
    if isinstance(raw, Mapping):
        problem = f"expected {article(dimension)}, found a table: a limit has no standard deviation"
        raise schema.RefusedError(problem, remedy)
    return schema.parse_quantity(raw, dimension, above=above).value


def _example(name: str, unit: str) -> str:
    unit = DISPLAY_UNITS.get(unit, (unit, 1.0))[0]
    return f'{name} = ["-100 {unit}", "100 {unit}"]'
