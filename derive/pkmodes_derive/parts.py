"""Parts of a mechanism: effects change them, and the assembler forms their energies.

Positions are expressions in coordinates and named values.  The motion of a belt, rotor or spring is a linear form in
the coordinates, the same for small displacements and for rates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sympy import Add, Expr, S, Symbol

from pkmodes_derive.effect import Coordinate

#: A displacement or rate, linear in the coordinates: the factor of each.
Form = Mapping[Symbol, Expr]
Position = Sequence[Expr]


@dataclass
class PointMass:
    """A body that translates: mass [kg] and position [m] of its centre."""

    mass: Expr
    position: Position


@dataclass
class Rod:
    """A uniform slender rod: mass [kg] and the positions [m] of both ends."""

    mass: Expr
    ends: tuple[Position, Position]


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
    """

    mass: Expr
    inertia: Expr
    angle: Symbol
    centre: Position


@dataclass
class Link:
    """A rigid link that closes a loop between the joint of an independent coordinate and the platform.

    Attributes
    ----------
    vector : tuple of sympy.Symbol
        From that joint to the platform joint [m], named in the chain.
    length : sympy.Expr
        Declared length [m].
    coordinate : sympy.Symbol
        Its independent coordinate.
    elongation : list of Coordinate
        Released coordinates that lengthen it.
    """

    vector: tuple[Symbol, ...]
    length: Expr
    coordinate: Symbol
    elongation: list[Coordinate] = field(default_factory=list)


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
    """

    coordinate: Symbol
    inertia: Expr
    name: Symbol | None = None


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


@dataclass(eq=False)
class Clamp:
    """The attachment of a belt to the body it moves; released coordinates move it relative to that body."""

    released: list[Coordinate] = field(default_factory=list)


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


@dataclass
class Reducer:
    """A torsional spring between two coordinates, with a named stiffness [N m/rad] and a loss factor."""

    stiffness: Symbol
    declared: Expr
    twist: Form
    change: Expr = S.Zero
    loss: Expr = S.Zero
