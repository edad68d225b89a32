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

from pkmodes.errors import shown
from pkmodes.robot.units import (
    DIMENSIONS,
    LARGEST,
    SMALLEST,
    Quantity,
    QuantityError,
    article,
    in_range,
    parse,
)

MIN_DIRECTION, MAX_DIRECTION = 0.5, 2.0
LONGEST_NAME = 80
SI_REMEDY = "write a value with its unit, or a number in SI units"


def _number(raw: Any, dimension: str) -> float:
    """A bare number in SI, or text with a unit."""
    expected = f'expected {article(dimension)} such as "{DIMENSIONS[dimension][1]}"'
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise refused(f"{expected}, found {shown(raw)}")
    try:
        value = parse(raw, dimension) if isinstance(raw, str) else float(raw)
    except QuantityError as error:
        raise refused(str(error)) from error
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise refused(f"expected a finite {dimension}, found {shown(raw)}")
    if not in_range(value):
        raise refused(
            f"expected {article(dimension)} of a magnitude between {SMALLEST:g} and {LARGEST:g} in SI units, "
            f"found {shown(raw)}",
            "check the number and its unit",
        )
    return value


def _sigma(raw: Any, value: float, dimension: str) -> float:
    """One standard deviation, absolute or relative to the value."""
    remedy = 'write an absolute standard deviation with its unit, or a relative one such as "2 %"'
    if isinstance(raw, str) and raw.strip().endswith("%"):
        try:
            relative = parse(raw, "number")
        except QuantityError as error:
            raise refused(
                f'sigma: expected a percentage such as "2 %", found {shown(raw)}', remedy
            ) from error
        if value == 0.0:
            raise refused(f"sigma: {shown(raw)} of a value of 0 says nothing", remedy)
        sigma = relative * abs(value)
    else:
        try:
            sigma = _number(raw, dimension)
        except PydanticCustomError as error:
            raise refused(f"sigma: {error.message()}", remedy) from error
    if sigma < 0:
        raise refused(f"sigma: expected a standard deviation of at least 0, found {shown(raw)}", remedy)
    return sigma


def quantity(raw: Any, dimension: str, at_least: float | None = None, above: float | None = None) -> Quantity:
    """A bare number, text with a unit, or a table with a standard deviation."""
    sigma_raw = None
    if isinstance(raw, dict):
        unknown = [key for key in raw if key not in ("value", "sigma")]
        if unknown or "value" not in raw:
            found = ", ".join(map(shown, raw)) or "an empty table"
            raise refused(
                f'expected a table with "value" and, if known, "sigma"; found {found}',
                "write { value = ..., sigma = ... }",
            )
        raw, sigma_raw = raw["value"], raw.get("sigma")
    value = _number(raw, dimension)
    unit = "" if dimension == "number" else f" {DIMENSIONS[dimension][0]}"
    remedy = "check the sign and the number"
    if at_least is not None and value < at_least:
        raise refused(
            f"expected {article(dimension)} of at least {at_least:g}{unit}, found {shown(raw)}", remedy
        )
    if above is not None and value <= above:
        raise refused(
            f"expected {article(dimension)} greater than {above:g}{unit}, found {shown(raw)}", remedy
        )
    si_unit = DIMENSIONS[dimension][0]
    return Quantity(value, si_unit, None if sigma_raw is None else _sigma(sigma_raw, value, dimension))


def _vector(raw: Any, dimension: str, length: int) -> tuple[Quantity, ...]:
    if not isinstance(raw, list) or len(raw) != length:
        found = f"{len(raw)} elements" if isinstance(raw, list) else shown(raw)
        raise refused(
            f"expected a list of {length} {dimension} values, found {found}", f"give {length} elements"
        )
    elements = []
    for name, element in zip("xyz" if length == 3 else ("min", "max"), raw, strict=True):
        try:
            elements.append(quantity(element, dimension, None, None))
        except PydanticCustomError as error:
            context = error.context or {}
            raise refused(error.message(), context["remedy"], element=name) from error
    return tuple(elements)


def _direction(raw: Any) -> tuple[float, float, float]:
    remedy = "write the components of a unit vector as numbers, such as [1, 0, 0]"
    if isinstance(raw, list) and any(isinstance(element, dict) for element in raw):
        raise refused("expected three numbers, found a table: a direction has no standard deviation", remedy)
    elements = [element.value for element in _vector(raw, "number", 3)]
    norm = math.hypot(*elements)
    if norm == 0.0:
        raise refused("expected a unit vector, found a zero direction", remedy)
    if not MIN_DIRECTION < norm < MAX_DIRECTION:
        # Rounded components are normalised; a vector of another size is rather a position or a length.
        raise refused(f"expected a unit vector, found one of length {norm:g}", remedy)
    x, y, z = (element / norm for element in elements)
    return x, y, z


def _limits(raw: Any) -> tuple[Quantity, ...]:
    low, high = _vector(raw, "length", 2)
    if low.value >= high.value:
        raise refused(
            f"expected the lower limit first, found {low.value:g} m before {high.value:g} m",
            "write limits = [min, max]",
        )
    return low, high


def _choice(raw: Any, allowed: tuple[int, ...]) -> int:
    if isinstance(raw, bool) or not isinstance(raw, int) or raw not in allowed:
        choices = " or ".join(map(str, allowed))
        raise refused(f"expected {choices}, found {shown(raw)}", f"write {choices}")
    return raw


def _name(raw: Any) -> str:
    """A name goes into comments and docstrings of generated code, so it is plain text on one line."""
    plain = isinstance(raw, str) and raw.isprintable() and raw.strip() and len(raw) <= LONGEST_NAME
    if not plain or any(mark in raw for mark in ('"', "\\", "`", "/*", "*/")):
        raise refused(
            f"expected a name in plain text, found {shown(raw)}",
            f"choose at most {LONGEST_NAME} printable characters, without quotes, backslashes or comment marks",
        )
    return str(raw)


def refused(message: str, remedy: str = SI_REMEDY, element: str = "") -> PydanticCustomError:
    """An error that carries its own remedy and, within a vector, the element's name."""
    # Braces would be taken for a template by pydantic.
    context = {"message": message, "remedy": remedy, "element": element}
    return PydanticCustomError("refused", "{message}", context)


def _of(dimension: str, at_least: float | None = None, above: float | None = None) -> BeforeValidator:
    return BeforeValidator(lambda raw: quantity(raw, dimension, at_least, above))


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

    mass: PositiveMass | None = None


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

    format: Annotated[int, BeforeValidator(lambda raw: _choice(raw, (1,)))]
    name: Annotated[str, BeforeValidator(_name)]
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
    effects: dict[str, Any] = Field(default_factory=dict)
