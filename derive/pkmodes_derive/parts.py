"""Parts of a mechanism: effects change them, and the assembler forms their energies.

Positions are expressions in coordinates and named values.  The motion of a belt, rotor or spring is a linear form in
the coordinates, the same for small displacements and for rates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Add, Expr, S, Symbol

from pkmodes_derive.effect import Coordinate

#: A displacement or rate, linear in the coordinates: the factor of each.
Form = Mapping[Symbol, Expr]
Position = Sequence[Expr]


@dataclass
class PointMass:
    """A body that translates: mass [kg] and position [m] of its centre; as a place of terms, its name and words."""

    mass: Expr
    position: Position
    place: str = ""
    words: str = ""


@dataclass(frozen=True)
class Carrier:
    """The body on which a payload lies: a noun phrase, a phrase for the place on it, and its position [m]."""

    name: str
    place: str
    position: Position


@dataclass
class Rod:
    """A uniform slender rod: mass [kg] and positions [m] of both ends; as a place of terms, its name and words."""

    mass: Expr
    ends: tuple[Position, Position]
    place: str = ""
    words: str = ""


@dataclass
class Arm:
    """A body that turns about a fixed axis.

    Attributes
    ----------
    mass, inertia : sympy.Expr
        Mass [kg], and moment of inertia about the axis [kg m^2].
    angle : sympy.Symbol
        Its coordinate.
    centre : sequence of sympy.Expr
        Position of its centre of mass [m].
    place, words : str
        Its name and words as a place of terms.
    shift : sequence of sympy.Expr
        Velocity of its axis relative to the frame [m/s], if its seat yields.
    """

    mass: Expr
    inertia: Expr
    angle: Symbol
    centre: Position
    place: str = ""
    words: str = ""
    shift: Position = (S.Zero, S.Zero, S.Zero)


@dataclass(eq=False)
class Beam:
    """A beam on two guides, along which something slides: it may turn about the vertical through its middle.

    What moves with the beam lies on it, and turns with it.

    Attributes
    ----------
    body : PointMass
        The beam itself, whose centre of mass is its middle: it turns on the spot.
    along : sympy.Symbol
        Coordinate of what slides along the beam, which is parallel to x.
    across : sympy.Symbol
        Coordinate of the beam, which moves along y.
    released : list of Coordinate
        Released coordinates by which it turns [rad], positive from x to y.
    middle, lever : sympy.Expr
        Position of its middle along x [m], and that of what slides along it, from there.
    """

    body: PointMass
    along: Symbol
    across: Symbol
    released: list[Coordinate] = field(default_factory=list)
    middle: Expr = S.Zero
    lever: Expr = S.Zero

    def turned(self, position: Position) -> tuple[Expr, ...]:
        """Return a position on the beam, displaced by psi x (r - r_c): to first order in the angle psi."""
        x, y, z = position
        psi = Add(*(c.position for c in self.released))
        lever = self.lever if x == self.along else x - self.middle
        return x - psi * (y - self.across), y + psi * lever, z


@dataclass
class Body:
    """A body that turns with the platform.

    Attributes
    ----------
    mass : sympy.Expr
        Mass [kg].
    centre : sequence of sympy.Expr
        Position of its centre of mass [m].
    inertia : tuple of tuple of sympy.Expr
        Inertia tensor about the centre of mass [kg m^2], for the axes about which the platform turns, base frame.
    """

    mass: Expr
    centre: Position
    inertia: tuple[tuple[Expr, ...], ...]


@dataclass(frozen=True)
class LegPart:
    """A body that lies along a leg and turns with it, but not about it.

    Attributes
    ----------
    mass, inertia : sympy.Expr
        Mass [kg], and moment of inertia about its centre of mass, perpendicular to the leg [kg m^2].
    end : int
        The joint from which it keeps its distance: 0 at the frame, 1 at the platform.
    along : sympy.Expr
        Coordinate of its centre of mass from that joint [m], in the direction from the frame to the platform.
    place, words : str
        Its name and words as a place of terms.
    """

    mass: Expr
    inertia: Expr
    end: int
    along: Expr
    place: str = ""
    words: str = ""


@dataclass
class Leg:
    """A leg that changes its length, with its bodies.

    Attributes
    ----------
    link : Link
        Closes the loop: its vector goes from the joint on the frame to that on the platform.
    vector : Position
        That vector with three components [m].
    ends : tuple of Position
        Positions of both joints [m].
    parts : tuple of LegPart
    inertia, weight : sympy.Symbol
        Names of what the platform joint feels perpendicular to the leg [kg], and of the mass that is lifted where
        `vector` grows [kg].
    """

    link: Link
    vector: Position
    ends: tuple[Position, Position]
    parts: tuple[LegPart, ...]
    inertia: Symbol
    weight: Symbol

    @property
    def length(self) -> Symbol:
        """Its coordinate, which is the distance of the joints [m]."""
        return self.link.coordinate

    @property
    def mass(self) -> Expr:
        """Mass of all its parts [kg]."""
        return Add(*(part.mass for part in self.parts))

    @property
    def moving_mass(self) -> Expr:
        """Mass of the parts that move along it [kg]."""
        return Add(*(part.mass for part in self.parts if part.end == 1))

    @property
    def moment(self) -> Expr:
        """Sum of mass times distance along the leg, each from its own joint [kg m]."""
        return Add(*(part.mass * part.along for part in self.parts))

    @property
    def perpendicular_inertia(self) -> Expr:
        """Twice the kinetic energy per squared speed of the platform joint perpendicular to the leg [kg]."""
        shares = [
            part.mass * ((1 if part.end == 1 else 0) + part.along / self.length) ** 2
            + part.inertia / self.length**2
            for part in self.parts
        ]
        return Add(*shares)


@dataclass
class Link:
    """A link that closes a loop between the joint of an independent coordinate and the platform.

    It is rigid, or a leg whose length is its coordinate.

    Attributes
    ----------
    vector : tuple of sympy.Symbol
        From that joint to the platform joint [m], named in the chain.
    length : sympy.Expr
        Declared length [m].
    coordinate : sympy.Symbol
        Its independent coordinate.
    lever : tuple of sympy.Symbol
        Its joint from the origin of a platform that turns [m], base frame; empty for one that does not.
    elongation : list of Coordinate
        Released coordinates that lengthen it.
    """

    vector: tuple[Symbol, ...]
    length: Expr
    coordinate: Symbol
    lever: tuple[Symbol, ...] = ()
    elongation: list[Coordinate] = field(default_factory=list)

    @property
    def rigid(self) -> bool:
        """Whether its length is fixed."""
        return bool(self.length != self.coordinate)


@dataclass(eq=False)
class Seat:
    """What holds a body of a closed loop: a rail, or a base joint, which a term may let yield.

    Attributes
    ----------
    place : str
        The body, as a place of terms.
    link : Link
        Its vector starts at the body.
    points, ends, arms, legs : lists
        Bodies that move with the seat: point masses, ends of rods (0 or 1), arms, and legs with their base joint.
    """

    place: str
    link: Link
    points: list[PointMass] = field(default_factory=list)
    ends: list[tuple[Rod, int]] = field(default_factory=list)
    arms: list[Arm] = field(default_factory=list)
    legs: list[Leg] = field(default_factory=list)


@dataclass(eq=False)
class Clamp:
    """What holds the end of a belt span: released coordinates move it along the span, with sign -1 against it."""

    released: list[Coordinate] = field(default_factory=list)
    sign: int = 1

    @property
    def reversed(self) -> Clamp:
        """The same for an end that moves the other way."""
        return Clamp(self.released, -self.sign)


@dataclass
class Rotor:
    """A body that turns on a bearing of the frame.

    Attributes
    ----------
    coordinate : sympy.Symbol
        Its rotation.
    inertia : sympy.Expr
        Moment of inertia without its drive [kg m^2].
    name : sympy.Symbol or None
        Name of the moment of inertia including the drive; None for no name.
    place, words : str
        Its name and words as a place of terms.
    bearing : Clamp
        Holds the ends of belt spans that it carries; released coordinates displace it.
    along : sequence of sympy.Expr
        Unit vector of that displacement, base frame; empty if the mechanism does not say.
    """

    coordinate: Symbol
    inertia: Expr
    name: Symbol | None = None
    place: str = ""
    words: str = ""
    bearing: Clamp = field(default_factory=Clamp)
    along: Position = ()


@dataclass
class Drive:
    """A motor with its gearbox, which turns one of several rotors.

    Attributes
    ----------
    rotors : tuple of (Rotor, sympy.Expr)
        Rotors that it may turn, each with 1 if it does, else 0.
    motor : sympy.Expr
        Moment of inertia of the motor, reflected to the rotor [kg m^2].
    torque : sympy.Symbol
        Name of the static torque on the rotor.
    inertia : sympy.Expr
        Moment of inertia that effects add to the rotor [kg m^2].
    winds_up : bool
        Whether gearbox compliance is distinct from that of the following transmission.
    wind_up : list of Coordinate
        Released coordinates by which the motor turns further than the rotor.
    loss : sympy.Expr
        Loss factor of the gearbox where it winds up.
    """

    rotors: tuple[tuple[Rotor, Expr], ...]
    motor: Expr
    torque: Symbol
    winds_up: bool = True
    inertia: Expr = S.Zero
    wind_up: list[Coordinate] = field(default_factory=list)
    loss: Expr = S.Zero

    @property
    def wound(self) -> Expr:
        """Angle by which the motor turns further than the rotor [rad]."""
        return Add(*(coordinate.position for coordinate in self.wind_up))

    @property
    def wound_rate(self) -> Expr:
        """Rate of this angle [rad/s]."""
        return Add(*(coordinate.rate for coordinate in self.wind_up))


@dataclass
class Run:
    """A free span of a belt.

    Attributes
    ----------
    length, stiffness : sympy.Symbol
        Names of its free length [m] and of its stiffness [N/m].
    free_length : sympy.Expr
        Free length in the reference configuration [m].
    ends : tuple of (Form, Clamp or None)
        Motion of both ends along the span.
    """

    length: Symbol
    stiffness: Symbol
    free_length: Expr
    ends: tuple[tuple[Form, Clamp | None], tuple[Form, Clamp | None]]


@dataclass
class Belt:
    """A belt with its free spans.

    Attributes
    ----------
    modulus : sympy.Expr
        Stiffness times free length, as declared [N].
    clamp : Clamp or None
    change : sympy.Expr
        Relative change of the modulus by effects.
    factor : sympy.Expr
        Factor by which effects multiply the modulus.
    compliance : sympy.Expr
        Compliance in series with every span [m/N].
    loss : sympy.Expr
        Loss factor of every span, without that compliance.
    """

    modulus: Expr
    runs: tuple[Run, ...]
    clamp: Clamp | None = None
    change: Expr = S.Zero
    factor: Expr = S.One
    compliance: Expr = S.Zero
    loss: Expr = S.Zero

    @property
    def effective_modulus(self) -> Expr:
        """Stiffness of a span times its length, with what effects change [N]."""
        return self.modulus * (1 + self.change) * self.factor


@dataclass(frozen=True)
class PlacedSpring:
    """A spring that an effect adds, relaxed at the pose: from a place to ground, or between two places.

    Attributes
    ----------
    stiffness : sympy.Expr
        [N/m] or [N m/rad].
    places : tuple of Place
        One, or two whose relative displacement strains it.
    directions : tuple of str
        Those in which it acts, each alike; one, empty, between bodies with one freedom each.
    """

    stiffness: Expr
    places: tuple[Any, ...]
    directions: tuple[str, ...]


@dataclass
class Reducer:
    """A spring between two coordinates, with a named stiffness [N m/rad, N/m] and a loss factor."""

    stiffness: Symbol
    declared: Expr
    twist: Form
    change: Expr = S.Zero
    loss: Expr = S.Zero
