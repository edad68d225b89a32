"""The places of terms: the bodies that a mechanism declares, by table and index, and how each can move."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sympy import Expr, Rational, Symbol

from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Arm, Position, Seat
from pkmodes_derive.vocabulary import AXES

#: The place of the frame, which moves with the effect ``frame_compliance``.
FRAME, PLATFORM = "frame", "platform"
HALF = Rational(1, 2)


@dataclass(frozen=True)
class Place:
    """A body that a term acts on.

    Attributes
    ----------
    name, words : str
        Such as "pulley_2_1", and "pulley 1 of axis 2".
    directions : tuple of str
        Directions in which it moves, x, y, z, or rx, ry, rz of a platform that turns; empty for a body with one
        freedom.
    position : sequence of sympy.Expr
        Of its centre [m]; empty for a body whose freedom is a coordinate.
    coordinate : sympy.Symbol or None
        That coordinate.
    along : sequence of sympy.Expr
        Unit vector along which a body with one freedom slides; empty for others.
    rotates : bool
        Whether its one freedom is a rotation.
    part : object
        The part of the machine; None for the frame.
    seat : Seat or None
        What holds it, if a term may let that yield.
    """

    name: str
    words: str
    directions: tuple[str, ...] = ()
    position: Position = ()
    coordinate: Symbol | None = None
    along: Position = ()
    rotates: bool = False
    part: object = None
    seat: Seat | None = None

    @property
    def mass(self) -> Expr | None:
        """Its declared mass or, of a body that rotates, moment of inertia; None if it has none of its own."""
        if isinstance(self.part, Arm):
            return self.part.inertia
        return getattr(self.part, "inertia" if self.rotates else "mass", None)

    @property
    def translations(self) -> tuple[str, ...]:
        """Directions along which it is displaced, without rotations."""
        return tuple(d for d in self.directions if d in AXES)


def places(machine: Machine) -> dict[str, Place]:
    """Return the places of a machine by name, in the order of its parts."""
    return {place.name: place for place in _places(machine)}


def strained_directions(ends: Sequence[Place]) -> tuple[str, ...]:
    """Return the directions in which an isotropic spring acts: one, empty, for bodies with one freedom each."""
    return max((place.translations for place in ends), key=len) or ("",)


def _places(m: Machine) -> Iterator[Place]:
    """Yield the platform, other bodies, rods, arms, legs, rotors and the frame."""
    seats = {seat.place: seat for seat in m.seats}
    at_platform = [tuple(point.position) == tuple(m.platform) for point in m.points]
    if m.bodies or not (m.carrier or any(at_platform)):
        rotations = m.components[len(m.directions) :]
        yield Place(PLATFORM, "the platform", (*m.directions, *rotations), m.platform)
    for number, point in enumerate(m.points, start=1):
        name = point.place or (PLATFORM if at_platform[number - 1] else f"body_{number}")
        slides = _slide_direction(m, point.position)
        yield Place(
            name,
            point.words or ("the platform" if name == PLATFORM else _words(name)),
            () if slides else m.directions,
            point.position,
            along=slides,
            part=point,
            seat=seats.get(name),
        )
    for number, rod in enumerate(m.rods, start=1):
        name = rod.place or f"rod_{number}"
        middle = tuple((a + b) * HALF for a, b in zip(*rod.ends, strict=True))
        yield Place(name, rod.words or _words(name), m.directions, middle, part=rod)
    for number, arm in enumerate(m.arms, start=1):
        name = arm.place or f"arm_{number}"
        words = arm.words or _words(name)
        yield Place(name, words, coordinate=arm.angle, rotates=True, part=arm, seat=seats.get(name))
    for leg_number, leg in enumerate(m.legs, start=1):
        direction = tuple(component / leg.length for component in leg.vector)
        for number, part in enumerate(leg.parts, start=1):
            name = part.place or f"leg_{leg_number}_{number}"
            centre = tuple(a + part.along * u for a, u in zip(leg.ends[part.end], direction, strict=True))
            words = part.words or _words(name)
            yield Place(name, words, m.directions, centre, part=part, seat=seats.get(name))
    for number, rotor in enumerate(m.rotors, start=1):
        name = rotor.place or f"rotor_{number}"
        rotates = m.vocabulary[rotor.coordinate].unit == "rad"
        words = rotor.words or _words(name)
        yield Place(name, words, coordinate=rotor.coordinate, rotates=rotates, part=rotor)
    yield Place(FRAME, "the frame", m.directions)


def _slide_direction(m: Machine, position: Position) -> tuple[Expr, ...]:
    """Return the unit vector along which a body slides whose position is linear in one coordinate; else nothing."""
    moving = {s for c in position for s in c.free_symbols} & {
        *m.independent,
        *m.dependent,
        *m.chain.definitions,
    }
    if len(moving) != 1 or not moving <= set(m.independent):
        return ()
    (q,) = moving
    along = tuple(component.diff(q) for component in position)
    return () if any(q in component.free_symbols for component in along) else along


def _words(name: str) -> str:
    stem, *numbers = name.split("_")
    return " ".join([stem, *numbers])
