"""The elements of a picture of a machine: lines, wheels, blocks, plates and balls between points that move with it.

A mechanism may declare them through ``m.draw``.  Positions are expressions in coordinates and named values, as those
of bodies are, so their motion is derived, not written.  A mechanism that declares nothing is drawn from its parts:
rods, legs, point masses, arms, bodies and the platform.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from sympy import Expr, Symbol, sympify

from pkmodes_derive.parts import Arm, Body, Clamp, Leg, PointMass, Reducer, Rod, Run
from pkmodes_derive.vocabulary import AXES, DeclarationError, Vocabulary
from pkmodes_description import ElementShape

Vector = tuple[Expr, ...]


@dataclass(frozen=True)
class Point:
    """A point of a body, or of a belt fastened to one.

    Attributes
    ----------
    position : tuple of sympy.Expr
        Three components [m].
    clamp : Clamp or None
        The clamp that carries it, whose released coordinates move it along a direction.
    along : tuple of sympy.Expr
        That direction, a unit vector.
    """

    position: Vector
    clamp: Clamp | None = None
    along: Vector = ()


#: A point as a declaration gives it: a `Point`, or only its position.
Place = Point | Sequence[object]


@dataclass(frozen=True)
class Element:
    """One element of a drawing.

    Attributes
    ----------
    shape : str
        ``line`` through all its points; ``wheel`` about its first point, whose axis and radius are the direction and
        length to the second; ``block`` about its first point, whose direction and half length are those to the
        second; ``plate``, the convex hull of its points; ``ball``, one point.
    kind : str
        What it is: ``rail``, ``carriage``, ``link``, ``arm``, ``belt``, ``pulley``, ``platform`` ...
    spring : Run or Reducer or None
        The spring that it is.
    turns : sympy.Symbol or None
        The coordinate by which a wheel turns, right-handed about its axis.
    place : str
        The body that it shows, as a place of terms; empty for the one whose words are its name, or none.
    """

    shape: ElementShape
    kind: str
    name: str
    points: tuple[Point, ...]
    spring: Run | Reducer | None = None
    turns: Symbol | None = None
    place: str = ""


@dataclass(frozen=True)
class Upright:
    """A unit vector that the robot leaves open: any perpendicular to a direction, which a viewer chooses.

    Attributes
    ----------
    direction : tuple of sympy.Expr
        The unit vector to which it is perpendicular.
    place : tuple of sympy.Expr
        Where it is used [m].
    """

    symbols: tuple[Symbol, ...]
    direction: Vector
    place: Vector


@dataclass
class Drawing:
    """The elements that a mechanism declares, in order.

    Attributes
    ----------
    vocabulary : Vocabulary
        Symbols of the drawing, which are no part of the model.
    """

    elements: list[Element] = field(default_factory=list)
    uprights: list[Upright] = field(default_factory=list)
    vocabulary: Vocabulary = field(default_factory=Vocabulary)

    def upright(self, direction: Sequence[object], place: Sequence[object]) -> tuple[Symbol, ...]:
        """Return a unit vector perpendicular to a direction, as upright as the viewer can choose it."""
        name, what = "up_{j}", "unit vector {j} that the robot leaves open, perpendicular to a given one"
        number = len(self.uprights) + 1
        symbols = self.vocabulary.vector(name, "1", what, "u_{j}", j=number)
        self.uprights.append(Upright(symbols, _exact_point(direction), _exact_point(place)))
        return symbols

    def fastened(self, position: Sequence[object], clamp: Clamp, along: Sequence[object]) -> Point:
        """Return the point at which a belt is clamped; the clamp yields along the belt."""
        return Point(_exact_point(position), clamp, _exact_point(along))

    def line(
        self,
        kind: str,
        name: str,
        *points: Place,
        spring: Run | Reducer | None = None,
        place: str = "",
    ) -> None:
        """Draw a line through points: a rail, a rod, an arm, a belt span."""
        self._add("line", kind, name, points, spring, place=place)

    def wheel(
        self,
        kind: str,
        name: str,
        centre: Sequence[object],
        axis: Sequence[object],
        radius: object,
        *,
        turns: Symbol | None = None,
        spring: Run | Reducer | None = None,
        place: str = "",
    ) -> None:
        """Draw a wheel with a unit vector as its axis; `turns` is the coordinate by which it turns."""
        self._add("wheel", kind, name, (centre, _displaced_point(centre, axis, radius)), spring, turns, place)

    def block(
        self, kind: str, name: str, centre: Sequence[object], along: Sequence[object], half: object
    ) -> None:
        """Draw a block of a half length along a unit vector: a carriage, a tool head."""
        self._add("block", kind, name, (centre, _displaced_point(centre, along, half)))

    def plate(self, kind: str, name: str, *points: Sequence[object]) -> None:
        """Draw the flat body that connects some points: a platform, a base."""
        self._add("plate", kind, name, points)

    def ball(self, kind: str, name: str, centre: Sequence[object], *, place: str = "") -> None:
        """Draw a body without a direction at a point."""
        self._add("ball", kind, name, (centre,), place=place)

    def move(self, new_position: Callable[[Vector], Vector]) -> None:
        """Replace all positions of the elements by functions of them."""
        self.elements = [
            replace(
                element, points=tuple(replace(p, position=new_position(p.position)) for p in element.points)
            )
            for element in self.elements
        ]

    def _add(
        self,
        shape: ElementShape,
        kind: str,
        name: str,
        points: Sequence[Place],
        spring: Run | Reducer | None = None,
        turns: Symbol | None = None,
        place: str = "",
    ) -> None:
        exact_points = tuple(p if isinstance(p, Point) else Point(_exact_point(p)) for p in points)
        self.elements.append(Element(shape, kind, name, exact_points, spring, turns, place))


def from_parts(
    vocabulary: Vocabulary,
    points: Sequence[PointMass],
    rods: Sequence[Rod],
    arms: Sequence[Arm],
    legs: Sequence[Leg],
    bodies: Sequence[Body],
    platform: Sequence[Expr],
    joints: Sequence[Vector] = (),
) -> list[Element]:
    """Return the elements of a machine that declares no drawing, from its parts; each is named after its mass.

    `joints` are those on a platform that turns: it is the plate between them.
    """
    drawing = Drawing()
    for number, rod in enumerate(rods, start=1):
        name = _name_of_body(vocabulary, rod.mass, f"rod {number}")
        drawing.line("link", name, *rod.ends, place=rod.place or f"rod_{number}")
    for number, leg in enumerate(legs, start=1):
        drawing.line("link", f"leg {number}", *leg.ends)
    for number, arm in enumerate(arms, start=1):
        name = _name_of_body(vocabulary, arm.mass, f"arm {number}")
        drawing.ball("arm", name, arm.centre, place=arm.place or f"arm_{number}")
    for number, body in enumerate(points, start=1):
        kind = "platform" if tuple(body.position) == tuple(platform) else "body"
        name = _name_of_body(vocabulary, body.mass, f"body {number}")
        drawing.ball(kind, name, body.position, place=body.place)
    for platform_body in bodies:
        drawing.ball("body", "centre of mass of the platform", platform_body.centre)
    if joints:
        drawing.plate("platform", "platform", *joints)
    if not any(element.kind == "platform" for element in drawing.elements):
        drawing.ball("platform", "platform", platform)
    return drawing.elements


def _name_of_body(vocabulary: Vocabulary, mass: Expr, default: str) -> str:
    """Return the name of a body from the description of its mass: "mass of arm 1" is that of arm 1."""
    text = vocabulary[mass].description if isinstance(mass, Symbol) and mass in vocabulary else ""
    name = text.removeprefix("mass of ").removeprefix("the ")
    return name if name != text else default


def _displaced_point(point: Sequence[object], direction: Sequence[object], distance: object) -> Vector:
    return tuple(sympify(a) + sympify(distance) * sympify(d) for a, d in zip(point, direction, strict=True))


def _exact_point(vector: Sequence[object]) -> Vector:
    exact = tuple(sympify(component) for component in vector)
    if len(exact) != len(AXES):
        what = f"a point or direction of a drawing has three components, found {len(exact)}"
        raise DeclarationError(what, "write, for example, (x, y, 0)")
    return exact
