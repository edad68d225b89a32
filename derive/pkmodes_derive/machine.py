"""A machine: the tables, coordinates and parts that a mechanism declares, and what effects add to them.

The function ``declare`` of a mechanism fills an empty machine from top to bottom.  Effects are then applied before
anything is derived: they refer to names, whose definitions follow from the complete machine.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from sympy import Add, Expr, Integer, Symbol, sympify

from pkmodes_derive.chain import Chain
from pkmodes_derive.drawing import Drawing
from pkmodes_derive.effect import Coordinate, Effect
from pkmodes_derive.functions import Argument, Output
from pkmodes_derive.parts import (
    Arm,
    Beam,
    Belt,
    Body,
    Carrier,
    Clamp,
    Drive,
    Form,
    Leg,
    LegPart,
    Link,
    PlacedSpring,
    PointMass,
    Reducer,
    Rod,
    Rotor,
    Run,
    Seat,
)
from pkmodes_derive.tables import Declared, Tables
from pkmodes_derive.turning import Turning
from pkmodes_derive.vectors import placed
from pkmodes_derive.vocabulary import AXES, DeclarationError, Field, Vocabulary
from pkmodes_description import Axis, Margin, ParameterGroup, Requirement, Scale

#: Meaning of the index letters; a mechanism may override it.
LETTERS = {
    "j": "axis j",
    "k": "coordinate k of a derivative",
    "l": "coordinate l of a second derivative",
    "s": "belt span s",
    "i": "component i = x, y, z",
    "r": "rows r of a minor",
    "c": "columns c of a minor",
}
SMALL = "small displacement from the reference configuration: "


@dataclass(frozen=True)
class Extra:
    """A function specific to a mechanism.

    Attributes
    ----------
    name, summary, source, details : str
        As in `Function`.
    arguments : tuple of Argument, optional
        By default the pose.
    definitions : mapping, optional
        By default the definitions of the chain and the inverse kinematics.
    """

    name: str
    summary: str
    source: str
    outputs: tuple[Output, ...]
    details: str = ""
    arguments: tuple[Argument, ...] | None = None
    definitions: Mapping[Symbol, Expr] | None = None


class Machine:
    """The declaration of a mechanism, which effects read and change.

    Attributes
    ----------
    chain : Chain
        Named values as functions of coordinates and parameters.
    inverse : dict
        The independent coordinates and auxiliary values as functions of the pose.
    gravity : tuple of sympy.Symbol
        Acceleration [m/s^2].
    dependent : tuple of sympy.Symbol
        Coordinates of the platform that the closures determine.
    independent : tuple of sympy.Symbol
        Coordinates that move the platform.
    coordinates, velocities, displacements : tuple of sympy.Symbol
        All generalised coordinates without effects, their rates and small displacements.
    follows : dict
        The other coordinates as functions of the independent ones with rigid transmissions, also valid for rates.
    points, rods, arms, bodies, legs, links, rotors, drives, belts, reducers, leg_springs : lists
        Its parts; the springs of reducers twist, those of legs stretch.
    turning : Turning or None
        The rotation of the platform, if it turns.
    units : set of tuple
        Unit vectors.
    differences : dict
        Parameter fields that enter only through their difference from another field.
    turned : dict
        Values that depend on one independent coordinate alone, with that coordinate and their derivative.
    directions : tuple of str
        Directions in which the platform and the frame move.
    components : tuple of str
        The components of the platform's motion: the directions, then "r" and the axis for each rotation.
    moving_bodies : tuple of str
        What moves along each of the directions, such as "tool head", if it is not the platform.
    carrier : Carrier or None
        The body that carries payloads, if it is not the platform.
    loads : list of PointMass
        Bodies that effects add.
    frame : list of lists of Coordinate
        Released coordinates of the frame, for each direction.
    v_p, delta_p : tuple of sympy.Symbol
        Absolute velocity and small displacement of the platform.
    beam : Beam or None
        The beam of a gantry, which may turn.
    rails : list of sympy.Symbol
        Coordinates of the bodies that slide along rails.
    seats : list of Seat
        What holds bodies of closed loops.
    yielding, swinging : list of Coordinate
        Released coordinates on which positions depend: of seats, which move closures, and of what swings on a body.
    along_rails : dict of sympy.Symbol to list of (Coordinate, sympy.Expr)
        By the coordinate of a carriage those of its seat, and the cosine of the angle between each and the rail.
    springs : list of PlacedSpring
        Springs that effects add between bodies, or from one to ground.
    kinetic, elastic : lists of sympy.Expr
        Energies [J] that effects add: quadratic forms in rates and in small displacements.
    dissipation : list of sympy.Expr
        Dissipation functions [W] that effects add: half the power that viscous friction takes, quadratic in rates.
    elastic_of : list of str
        The effect that added each elastic energy.
    compliances : tuple of sympy.Expr
        Spring compliance of each released coordinate: a parameter, or the sum of several.
    effects : tuple of Effect
        Applied effects, with the parameters and coordinates they have on this machine.
    draw : Drawing
        The elements of the picture of the machine, if the mechanism declares it.
    """

    def __init__(
        self, name: str, title: str, directions: Sequence[str] = AXES, rotations: Sequence[Axis] = ()
    ) -> None:
        self.name, self.title, self.directions = name, title, tuple(directions)
        self.rotations = tuple(rotations)
        self.components = (*self.directions, *(f"r{axis}" for axis in self.rotations))
        self.turning: Turning | None = None
        self.vocabulary = Vocabulary(LETTERS)
        self.tables, self.chain = Tables(self.vocabulary), Chain()
        self.inverse: dict[Symbol, Expr] = {}
        self.gravity: tuple[Symbol, ...] = ()
        self.pose: tuple[Symbol, ...] = ()
        self.pose_is, self.independent_are, self.argument = "", "", ""
        self.dependent: tuple[Symbol, ...] = ()
        self.independent: tuple[Symbol, ...] = ()
        self.coordinates: tuple[Symbol, ...] = ()
        self.velocities: tuple[Symbol, ...] = ()
        self.displacements: tuple[Symbol, ...] = ()
        self.follows: dict[Symbol, Expr] = {}
        self.differences: dict[str, str] = {}
        self.turned: dict[Symbol, tuple[Symbol, Expr]] = {}
        self.units: set[tuple[Expr, ...]] = set()
        self.platform: tuple[Expr, ...] = ()
        self.moving_bodies: tuple[str, ...] = ()
        self.carrier: Carrier | None = None
        self.points: list[PointMass] = []
        self.loads: list[PointMass] = []
        self.rods: list[Rod] = []
        self.arms: list[Arm] = []
        self.bodies: list[Body] = []
        self.legs: list[Leg] = []
        self.links: list[Link] = []
        self.rotors: list[Rotor] = []
        self.drives: list[Drive] = []
        self.belts: list[Belt] = []
        self.reducers: list[Reducer] = []
        self.leg_springs: list[Reducer] = []
        self.frame: list[list[Coordinate]] = [[] for _ in self.directions]
        self.v_p: tuple[Symbol, ...] = ()
        self.delta_p: tuple[Symbol, ...] = ()
        self.beam: Beam | None = None
        self.rails: list[Symbol] = []
        self.seats: list[Seat] = []
        self.yielding: list[Coordinate] = []
        self.along_rails: dict[Symbol, list[tuple[Coordinate, Expr]]] = {}
        self.swinging: list[Coordinate] = []
        self.springs: list[PlacedSpring] = []
        self.kinetic: list[Expr] = []
        self.dissipation: list[Expr] = []
        self.elastic: list[Expr] = []
        self.elastic_of: list[str] = []
        self.released: tuple[Coordinate, ...] = ()
        self.compliances: tuple[Expr, ...] = ()
        self.effects: tuple[Effect, ...] = ()
        self.effect_fields: tuple[Field, ...] = ()
        self.parameter_groups: tuple[ParameterGroup, ...] = ()
        self.margins: tuple[Margin, ...] = ()
        self.requirements: tuple[Requirement, ...] = ()
        self.scales: tuple[Scale, ...] = ()
        self.extras: list[Extra] = []
        self.draw = Drawing()
        self.sample: Mapping[str, object] = {}

    # Declarations of a mechanism ---------------------------------------------------------------------------

    def define(self, symbol: Symbol, expression: Expr) -> Symbol:
        """Name an expression in coordinates and parameters."""
        return self.chain.define(symbol, expression)

    def define_all(self, symbols: Iterable[Symbol], expressions: Iterable[Expr]) -> None:
        """Name several expressions."""
        for symbol, expression in zip(symbols, expressions, strict=True):
            self.define(symbol, expression)

    def generalised(self, *groups: Sequence[tuple[str, str, str, str, Mapping[str, object]]]) -> None:
        """Declare all generalised coordinates in order, each as (name, unit, description, LaTeX, indices)."""

        def declare_group(before: str, after: str, per: str, what: str, tex: str) -> tuple[Symbol, ...]:
            return tuple(
                self.vocabulary.declare(
                    f"{before}{name}{after}", f"{unit}{per}", f"{what}{description}", tex % latex, **index
                )
                for group in groups
                for name, unit, description, latex, index in group
            )

        self.coordinates = declare_group("", "", "", "", "%s")
        self.velocities = declare_group("", "_dot", "/s", "rate of change: ", r"\dot%s")
        self.displacements = declare_group("delta_", "", "", SMALL, r"\Delta %s")

    def add_gravity(self) -> None:
        """Declare gravity, which every robot file contains."""
        self.gravity = self.vocabulary.vector("g", "m/s^2", "gravitational acceleration", "g")
        self.tables.field("gravity", (3,), self.gravity, "m/s^2", "gravitational acceleration g, base frame")

    def add_frame(self) -> None:
        """Declare the mass of the frame, used only by the effect ``frame_compliance``."""
        what = "the frame; used only by the effect frame_compliance"
        self.tables.constant("frame", "mass", what, 50.0, "frame_compliance.mass")

    def add_beam(
        self, table: Declared, travel: str, body: PointMass, *, along: Symbol, across: Symbol
    ) -> None:
        """Declare a beam on two guides that carries the platform, and the keys that only ``gantry_racking`` uses.

        Parameters
        ----------
        table : Declared
            The table of the beam, which receives these keys.
        travel : str
            Path of the platform's travel along the beam, whose middle is by default that of the beam.
        body : PointMass
            The mass of the beam.
        along, across : sympy.Symbol
            Coordinates along x, in which the platform moves on the beam, and along y, in which it moves with it.

        Raises
        ------
        DeclarationError
            If there is one already, or the platform does not move along x and y with these coordinates.
        """
        if self.beam is not None:
            raise DeclarationError("there are two beams", "declare the one that carries the platform")
        if tuple(self.platform[:2]) != (along, across):
            what = f"the platform moves along x and y by {', '.join(map(str, self.platform[:2]))}"
            raise DeclarationError(what, "declare a beam after the platform, with these coordinates")
        what = "; used only by the effect gantry_racking"
        table.constant(
            "inertia",
            "moment of inertia",
            f"moment of inertia of the {table.name} about its middle{what}",
            "gantry_racking.inertia",
            above=0.0,
        )
        table.constant(
            "center",
            "length",
            f"position of the middle of the {table.name} along it{what}",
            "gantry_racking.center",
            middle_of=travel,
        )
        self.beam = Beam(body, along, across)

    def vector(
        self, name: str, unit: str, description: str, latex: str, **index: object
    ) -> tuple[Symbol, ...]:
        """Declare a vector with components in the directions in which the mechanism moves."""
        return self.vocabulary.vector(name, unit, description, latex, axes=self.directions, **index)

    def vectors(self, name: str, unit: str, description: str, latex: str) -> tuple[tuple[Symbol, ...], ...]:
        """Declare one vector for each entry of the repeated table, such as an axis; index letter j."""
        return tuple(self.vector(f"{name}_{{j}}", unit, description, latex, j=j) for j in self.tables.numbers)

    def each(self, name: str, unit: str, description: str, latex: str) -> tuple[Symbol, ...]:
        """Declare one scalar for each entry of the repeated table; index letter j."""
        declare = self.vocabulary.declare
        return tuple(declare(f"{name}_{{j}}", unit, description, latex, j=j) for j in self.tables.numbers)

    def platform_pose(self, name: str, pose_is: str, latex: str) -> tuple[Symbol, ...]:
        """Declare the platform centre as the pose, related to the independent coordinates by closures."""
        position = self.vector(name, "m", pose_is, latex)
        self.pose = self.dependent = position
        self.pose_is = pose_is
        if self.rotations:
            self.turning = Turning(self.rotations, self.directions, self.vocabulary, self.chain)
            self.pose = (*position, *self.turning.vector)
            self.dependent = (*position, *self.turning.small)
        return position

    def fixed_in_platform(self, names: Sequence[Symbol], vector: Sequence[Expr]) -> tuple[Symbol, ...]:
        """Name a vector that is fixed in the platform, given in platform axes."""
        if not self.rotations:
            what = "the platform does not turn: the file has no ROTATIONS"
            raise DeclarationError(what, 'write, for example, ROTATIONS = ("z",)')
        if self.turning is None:
            what = "a vector is fixed in the platform before the pose is declared"
            raise DeclarationError(what, "call m.platform_pose(...) first")
        for given, what in ((names, "names"), (vector, "components")):
            if len(given) != len(self.directions):
                raise DeclarationError(
                    f"a vector that is fixed in the platform has {len(given)} {what}, "
                    f"expected {len(self.directions)}",
                    f"give one for each of {', '.join(self.directions)}",
                )
        return self.turning.fix(names, vector)

    def body(
        self, mass: Expr, centre: Sequence[Expr], inertia: Sequence[Expr], products: Sequence[Expr] = ()
    ) -> Body:
        """Add a body that turns with the platform.

        Parameters
        ----------
        mass : sympy.Expr
            Mass [kg].
        centre : sequence of sympy.Expr
            Its centre of mass from the origin of the platform, in platform axes [m].
        inertia : sequence of sympy.Expr
            Moments of inertia about the centre of mass, one for each axis of rotation, platform axes [kg m^2].
        products : sequence of sympy.Expr
            I_xy, I_xz and I_yz of the tensor, which are its entries; none in a plane.
        """
        if self.bodies:
            what = "the platform has a body already"
            raise DeclarationError(what, "give m.body the mass, centre and inertia of both together")
        v = self.vocabulary
        names = self.vector("c", "m", "centre of mass of the platform from its origin", "c")
        self.fixed_in_platform(names, centre)
        assert self.turning is not None
        axes = len(self.rotations)
        if len(inertia) != axes or len(products) not in {0, axes * (axes - 1) // 2}:
            what = f"a body has {len(inertia)} moments and {len(products)} products of inertia"
            three = "I_xx, I_yy, I_zz and, or none, I_xy, I_xz, I_yz"
            one_moment = f"one moment, I_{self.rotations[0] * 2}, in a sequence, and no products"
            raise DeclarationError(what, f"give {three if axes == 3 else one_moment}")
        product_at = dict(zip(((0, 1), (0, 2), (1, 2)), products, strict=False))
        entries = [
            [
                moment if i == k else product_at.get((min(i, k), max(i, k)), Integer(0))
                for k in range(len(inertia))
            ]
            for i, moment in enumerate(inertia)
        ]
        what = "inertia tensor of the platform about its centre of mass, base frame, entry {i}{a}"
        tensor = self.turning.tensor(
            lambda i, k: v.declare("J_{i}_{a}", "kg m^2", what, "J_{{{i}{a}}}", i=AXES[i], a=AXES[k]), entries
        )
        position = tuple(p + c for p, c in zip(self.dependent, names, strict=False))
        self.bodies.append(Body(sympify(mass), placed(self.directions, position), tensor))
        return self.bodies[-1]

    def independent_pose(self, coordinates: Sequence[Symbol], pose_is: str) -> None:
        """Declare the independent coordinates themselves as the pose."""
        self.pose, self.pose_is = tuple(coordinates), pose_is
        self.inverse = {}

    def moves_platform(self, coordinates: Sequence[Symbol], argument: str, are: str) -> None:
        """Declare the independent coordinates, the argument name for their values, and a plural noun for them."""
        self.independent, self.argument, self.independent_are = tuple(coordinates), argument, are

    @property
    def independent_argument(self) -> Argument:
        """The independent coordinates as an argument of a function."""
        unit = self.vocabulary[self.independent[0]].unit
        names = ", ".join(q.name for q in self.independent)
        return Argument(self.argument, self.independent, unit, f"{self.independent_are} {names}")

    def unit_vector(self, vector: Sequence[Symbol]) -> None:
        """Declare a vector to be a unit vector, whose square is replaced by 1."""
        self.units.add(tuple(vector))

    def link(
        self, vector: Sequence[Symbol], length: Expr, coordinate: Symbol, lever: Sequence[Symbol] = ()
    ) -> Link:
        """Close a loop with a rigid link, or with a leg whose length is its coordinate.

        Where the platform turns, `lever` is its joint from the platform's origin, from `fixed_in_platform`.
        """
        self.links.append(Link(tuple(vector), length, coordinate, tuple(lever)))
        return self.links[-1]

    def leg(
        self,
        link: Link,
        ends: tuple[Sequence[Expr], Sequence[Expr]],
        parts: Sequence[LegPart],
        **index: object,
    ) -> Leg:
        """Give a leg that changes its length its bodies; its length is the coordinate of its link."""
        v = self.vocabulary
        inertia_text = "inertia of leg {j} at its platform joint, perpendicular to the leg"
        weight_text = "mass that is lifted with the vector of leg {j}"
        leg = Leg(
            link,
            placed(self.directions, link.vector),
            (ends[0], ends[1]),
            tuple(parts),
            v.declare("m_perp_{j}", "kg", inertia_text, r"m_{{\perp,{j}}}", **index),
            v.declare("m_lift_{j}", "kg", weight_text, r"m_{{\uparrow,{j}}}", **index),
        )
        self.define(leg.inertia, leg.perpendicular_inertia)
        self.define(leg.weight, leg.moving_mass + leg.moment / leg.length)
        self.legs.append(leg)
        return leg

    def turns(self, symbol: Symbol, coordinate: Symbol, derivative: Expr) -> None:
        """Declare a value that depends on one independent coordinate alone, by its derivative."""
        self.chain.rule(symbol, coordinate, derivative)
        self.turned[symbol] = coordinate, derivative

    def rotor(
        self,
        coordinate: Symbol,
        inertia: Expr,
        name: Symbol | None = None,
        place: str = "",
        words: str = "",
        along: Sequence[Expr] = (),
    ) -> Rotor:
        """Add a body that turns on a bearing of the frame; in metres, what it moves along a leg.

        Parameters
        ----------
        name : sympy.Symbol, optional
            Of its moment of inertia including the drive.
        place, words : str, optional
            Its name as a place of terms, such as "pulley_2_1", and in words.
        along : sequence of sympy.Expr, optional
            Unit vector of the belt that leaves it, along which its bearing may yield, base frame.
        """
        self.rotors.append(Rotor(coordinate, inertia, name, place, words, along=tuple(along)))
        return self.rotors[-1]

    def drive(
        self, rotors: Sequence[tuple[Rotor, Expr]], motor: Expr, torque: Symbol, *, winds_up: bool = True
    ) -> None:
        """Add a motor with its gearbox on a rotor, or on one of a pair: [(driven, 1), (idler, 0)].

        Raises
        ------
        DeclarationError
            If there are more than two rotors: the equilibrium is solved pair by pair.
        """
        if len(rotors) not in (1, 2):
            raise DeclarationError(
                f"a drive acts on one rotor or on one of a pair, found {len(rotors)} rotors",
                "write m.drive([(driven, 1)], ...) or m.drive([(driven, 1), (idler, 0)], ...)",
            )
        self.drives.append(Drive(tuple(rotors), motor, torque, winds_up))

    @property
    def linear_drives(self) -> bool:
        """Whether the drives move along legs, in metres, rather than turn."""
        units = {self.vocabulary[r.coordinate].unit for drive in self.drives for r, _ in drive.rotors}
        return units == {"m"}

    def rail(self, coordinate: Symbol) -> None:
        """Declare that a body slides along a rail, its position a coordinate."""
        self.rails.append(coordinate)

    def belt(self, modulus: Expr, runs: Sequence[Run], clamp: Clamp | None = None) -> None:
        """Add a belt with its free spans."""
        self.belts.append(Belt(modulus, tuple(runs), clamp))

    # Queries by effects and the assembler ------------------------------------------------------------------

    def unit_by(self, coordinate: Symbol, for_length: str, for_angle: str) -> str:
        """Return the unit for a length or for an angle, depending on a coordinate."""
        unit: str = self.vocabulary[coordinate].unit
        return for_length if unit == "m" else for_angle

    @property
    def stem(self) -> str:
        """Common stem of the names of the independent coordinates, used in descriptions of derivatives."""
        first: str = self.independent[0].name
        return first.rsplit("_", 1)[0]

    @property
    def transmissions(self) -> list[Reducer]:
        """The springs between two coordinates: those of reducers, then those of legs."""
        return [*self.reducers, *self.leg_springs]

    @property
    def base(self) -> int:
        """Number of coordinates without effects."""
        return len(self.coordinates)

    @property
    def rates(self) -> tuple[Symbol, ...]:
        """Rates of all coordinates, including released ones."""
        return (*self.velocities, *(c.rate for c in self.released))

    @property
    def small(self) -> tuple[Symbol, ...]:
        """Small displacements of all coordinates; a released coordinate is its own small displacement."""
        return (*self.displacements, *(c.position for c in self.released))

    @property
    def all_coordinates(self) -> tuple[Symbol, ...]:
        """All coordinates, including released ones."""
        return (*self.coordinates, *(c.position for c in self.released))

    def rate(self, form: Form, clamp: Clamp | None = None) -> Expr:
        """Return the rate of a linear form."""
        return self._evaluate_form(form, self.velocities, clamp, lambda c: c.rate)

    def displacement(self, form: Form, clamp: Clamp | None = None) -> Expr:
        """Return a linear form in small displacements."""
        return self._evaluate_form(form, self.displacements, clamp, lambda c: c.position)

    def _evaluate_form(
        self,
        form: Form,
        values: Sequence[Symbol],
        clamp: Clamp | None,
        of_released: Callable[[Coordinate], Symbol],
    ) -> Expr:
        value_of = dict(zip(self.coordinates, values, strict=True))
        terms = [factor * value_of[q] for q, factor in form.items()]
        for q, factor in form.items():  # the end of a belt on a carriage whose rail yields
            terms += [factor * cosine * of_released(c) for c, cosine in self.along_rails.get(q, ())]
        beam = self.beam
        if beam is not None and beam.along in form:  # the end of a belt on what slides along the beam
            terms += [form.get(beam.across, 0) * beam.lever * of_released(c) for c in beam.released]
        if clamp is not None:
            terms += [clamp.sign * of_released(c) for c in clamp.released]
        return Add(*terms)

    def rotation(self, rotor: Rotor) -> Symbol:
        """Return the small rotation of a rotor from the reference configuration [rad]."""
        return self.displacements[self.coordinates.index(rotor.coordinate)]

    def rotation_rate(self, rotor: Rotor) -> Symbol:
        """Return the rate of a rotor [rad/s]."""
        return self.velocities[self.coordinates.index(rotor.coordinate)]

    @property
    def frame_rate(self) -> tuple[Expr, ...]:
        """Velocity of the frame in the base frame, three components [m/s]."""
        return self._frame_vector(lambda c: c.rate)

    @property
    def frame_position(self) -> tuple[Expr, ...]:
        """Displacement of the frame, three components [m]."""
        return self._frame_vector(lambda c: c.position)

    def _frame_vector(self, component_of: Callable[[Coordinate], Symbol]) -> tuple[Expr, ...]:
        sums = [Add(*map(component_of, coordinates)) for coordinates in self.frame]
        by_axis = dict(zip(self.directions, sums, strict=True))
        return tuple(by_axis.get(axis, Integer(0)) for axis in AXES)

    @property
    def carries(self) -> Carrier:
        """The body that carries payloads."""
        return self.carrier or Carrier("the platform", "at the platform centre", self.platform)

    @property
    def moving(self) -> tuple[Coordinate, ...]:
        """Released coordinates that move the platform: elongations of links, rotation of a beam, yielding seats."""
        of_links = (c for link in self.links for c in link.elongation)
        return (*of_links, *(self.beam.released if self.beam else ()), *self.yielding)

    def add_kinetic(self, energy: Expr) -> None:
        """Add kinetic energy, a quadratic form in rates."""
        self.kinetic.append(energy)

    def add_elastic(self, energy: Expr) -> None:
        """Add elastic energy, a quadratic form in small displacements."""
        self.elastic.append(energy)

    def add_dissipation(self, function: Expr) -> None:
        """Add half the power that viscous friction takes, a quadratic form in rates."""
        self.dissipation.append(function)

    # The end of a declaration ---------------------------------------------------------------------------------

    def finish(self) -> None:
        """Complete a declaration: convert plain numbers in positions, and name the platform velocity."""
        self.platform = _exact(self.platform)
        if self.carrier:
            self.carrier = replace(self.carrier, position=_exact(self.carrier.position))
        for point in self.points:
            point.position = _exact(point.position)
        for rod in self.rods:
            rod.ends = _exact(rod.ends[0]), _exact(rod.ends[1])
        for arm in self.arms:
            arm.centre = _exact(arm.centre)
        for leg in self.legs:
            leg.ends = _exact(leg.ends[0]), _exact(leg.ends[1])
        self.v_p = self.of_platform("v_p", "m/s", "velocity of the platform", r"(\dot{{p}})_{i}")

    def of_platform(self, name: str, unit: str, description: str, latex: str) -> tuple[Symbol, ...]:
        """Declare a vector of the platform, one component for each of its directions."""
        return tuple(
            self.vocabulary.declare(f"{name}_{{i}}", unit, f"{description}, component {{i}}", latex, i=axis)
            for axis in self.directions
        )


def _exact(position: Sequence[object]) -> tuple[Expr, ...]:
    return tuple(sympify(component) for component in position)
