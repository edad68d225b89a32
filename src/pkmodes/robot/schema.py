"""The robot file's schema: which tables, which keys, which kind of value each key takes.

Only the shape of the file is described here, for pydantic; `reading` turns it into a `Robot`.  Every value is
optional in a table because an axis may override what it shares with the others; what is missing in the
end is reported when the tables are merged.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from pkmodes.robot.units import DIMENSIONS, Quantity, QuantityError, parse

MIN_DIRECTION, MAX_DIRECTION = 0.5, 2.0


def _number(raw: Any, dimension: str) -> float:
    """A bare number in SI, or text with a unit."""
    _, example = DIMENSIONS[dimension]
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise _refused(f'expected a {dimension} such as "{example}", found {described(raw)}')
    if isinstance(raw, str):
        try:
            return parse(raw, dimension)
        except QuantityError as error:
            raise _refused(str(error)) from error
    try:
        value = float(raw)
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise _refused(f'expected a finite {dimension} such as "{example}", found {raw}')
    return value


def _sigma(raw: Any, value: float, dimension: str) -> float:
    """One standard deviation, absolute or relative to the value."""
    if isinstance(raw, str) and raw.strip().endswith("%"):
        try:
            sigma = parse(raw, "number") * abs(value)
        except QuantityError as error:
            raise _refused(f'sigma: expected a percentage such as "2 %", found "{raw}"') from error
    else:
        try:
            sigma = _number(raw, dimension)
        except PydanticCustomError as error:
            raise _refused(f"sigma: {error.message()}") from error
    if sigma < 0:
        raise _refused(f"sigma: expected a standard deviation of at least 0, found {raw}")
    return sigma


def _quantity(raw: Any, dimension: str, at_least: float | None, above: float | None) -> Quantity:
    sigma_raw = None
    if isinstance(raw, dict):
        unknown = [key for key in raw if key not in ("value", "sigma")]
        if unknown or "value" not in raw:
            found = ", ".join(map(str, raw)) or "an empty table"
            raise _refused(f'expected a table with "value" and, if known, "sigma"; found {found}')
        raw, sigma_raw = raw["value"], raw.get("sigma")
    value = _number(raw, dimension)
    unit = DIMENSIONS[dimension][0]
    if at_least is not None and value < at_least:
        raise _refused(f"expected a {dimension} of at least {at_least:g} {unit}, found {described(raw)}")
    if above is not None and value <= above:
        raise _refused(f"expected a {dimension} greater than {above:g} {unit}, found {described(raw)}")
    return Quantity(value, unit, None if sigma_raw is None else _sigma(sigma_raw, value, dimension))


def _vector(raw: Any, dimension: str, length: int) -> tuple[Quantity, ...]:
    if not isinstance(raw, list) or len(raw) != length:
        found = f"{len(raw)} elements" if isinstance(raw, list) else described(raw)
        raise _refused(f"expected a list of {length} {dimension} values, found {found}")
    elements = []
    for name, element in zip("xyz" if length == 3 else ("min", "max"), raw, strict=True):
        try:
            elements.append(_quantity(element, dimension, None, None))
        except PydanticCustomError as error:
            raise _refused(f"element {name}: {error.message()}") from error
    return tuple(elements)


def _direction(raw: Any) -> tuple[float, float, float]:
    elements = [element.value for element in _vector(raw, "number", 3)]
    norm = math.hypot(*elements)
    if norm == 0.0:
        raise _refused("expected a unit vector, found a zero direction")
    if not MIN_DIRECTION < norm < MAX_DIRECTION:
        # Rounded components are normalised; a vector of another size is rather a position or a length.
        raise _refused(f"expected a unit vector such as [1, 0, 0], found one of length {norm:g}")
    x, y, z = (element / norm for element in elements)
    return x, y, z


def _limits(raw: Any) -> tuple[Quantity, ...]:
    low, high = _vector(raw, "length", 2)
    if low.value >= high.value:
        raise _refused(f"expected the lower limit first, found {low.value:g} m before {high.value:g} m")
    return low, high


def _choice(raw: Any, allowed: tuple[int, ...]) -> int:
    if isinstance(raw, bool) or raw not in allowed:
        raise _refused(f"expected {' or '.join(map(str, allowed))}, found {described(raw)}")
    return int(raw)


def _refused(message: str) -> PydanticCustomError:
    # Braces would be taken for a template by pydantic.
    return PydanticCustomError("refused", "{message}", {"message": message})


def described(raw: Any) -> str:
    """How a value found in a file is shown in a message."""
    if isinstance(raw, str):
        return f'"{raw}"'
    if isinstance(raw, bool):
        return str(raw).lower()
    if isinstance(raw, dict):
        return "a table"
    if isinstance(raw, list):
        return "a list"
    return str(raw)


def _of(dimension: str, at_least: float | None = None, above: float | None = None) -> BeforeValidator:
    return BeforeValidator(lambda raw: _quantity(raw, dimension, at_least, above))


Mass = Annotated[Quantity, _of("mass", at_least=0.0)]
PositiveMass = Annotated[Quantity, _of("mass", above=0.0)]
Inertia = Annotated[Quantity, _of("moment of inertia", at_least=0.0)]
PositiveInertia = Annotated[Quantity, _of("moment of inertia", above=0.0)]
NonNegativeLength = Annotated[Quantity, _of("length", at_least=0.0)]
PositiveLength = Annotated[Quantity, _of("length", above=0.0)]
Stiffness = Annotated[Quantity, _of("specific stiffness", above=0.0)]
Ratio = Annotated[Quantity, _of("number", above=0.0)]
Point = Annotated[tuple[Quantity, ...], BeforeValidator(lambda raw: _vector(raw, "length", 3))]
Acceleration = Annotated[tuple[Quantity, ...], BeforeValidator(lambda raw: _vector(raw, "acceleration", 3))]
Direction = Annotated[tuple[float, float, float], BeforeValidator(_direction)]
Limits = Annotated[tuple[Quantity, ...], BeforeValidator(_limits)]
PulleyNumber = Annotated[int, BeforeValidator(lambda raw: _choice(raw, (1, 2)))]
Branch = Annotated[int, BeforeValidator(lambda raw: _choice(raw, (1, -1)))]


class Table(BaseModel):
    """A table that knows all its keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True)


class Platform(Table):
    """The moving platform."""

    mass: PositiveMass


class Link(Table):
    """One distal linkage: both rods of the parallelogram together."""

    length: PositiveLength | None = None
    mass: Mass | None = None


class Carriage(Table):
    """One carriage."""

    mass: Mass | None = None
    length: NonNegativeLength | None = None


class Belt(Table):
    """One timing belt."""

    specific_stiffness: Stiffness | None = None
    width: PositiveLength | None = None


class Pulley(Table):
    """Each of the two pulleys of an axis."""

    radius: PositiveLength | None = None
    inertia: PositiveInertia | None = None


class Motor(Table):
    """Motor and gearbox of an axis."""

    inertia: Inertia | None = None
    gear_ratio: Ratio | None = None


class Frame(Table):
    """The frame; used by the effect frame_compliance only."""

    mass: PositiveMass = Quantity(50.0, "kg")


class Axis(Table):
    """One axis: a rail, its pulleys, and what it does not share with the others."""

    origin: Point
    direction: Direction
    joint: Point
    limits: Limits
    driven_pulley: PulleyNumber
    branch: Branch
    link: Link = Link()
    carriage: Carriage = Carriage()
    belt: Belt = Belt()
    pulley: Pulley = Pulley()
    motor: Motor = Motor()


class RobotFile(Table):
    """A robot file, format 1."""

    format: Literal[1]
    name: Annotated[str, Field(min_length=1, max_length=80)]
    mechanism: Literal["linear_delta"]
    gravity: Acceleration
    platform: Platform
    link: Link = Link()
    carriage: Carriage = Carriage()
    belt: Belt = Belt()
    pulley: Pulley = Pulley()
    motor: Motor = Motor()
    frame: Frame = Frame()
    axis: Annotated[tuple[Axis, ...], Field(min_length=3, max_length=3)]
    effects: dict[str, dict[str, Any]] = Field(default_factory=dict)
