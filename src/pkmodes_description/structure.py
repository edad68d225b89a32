"""Parts of a mechanism's description: tables and keys, conditions on a pose and on a robot, effects, a drawing."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

#: SI unit of each dimension; messages use these names.
UNITS = {
    "length": "m",
    "mass": "kg",
    "moment of inertia": "kg m^2",
    "acceleration": "m/s^2",
    "specific stiffness": "N/m",
    "stiffness": "N/m",
    "torsional stiffness": "N m/rad",
    "compliance": "m/N",
    "torsional compliance": "rad/(N m)",
    "linear density": "kg/m",
    "angle": "rad",
    "force": "N",
    "reciprocal force": "1/N",
    "viscous friction": "N s/m",
    "torsional viscous friction": "N m s/rad",
    "frequency": "Hz",
    "number": "1",
}
#: Kinds of keys that are choices: nothing is differentiated with respect to them.
CHOICES = ("direction", "choice", "one_of", "signs")

Name = Annotated[str, Meta(min_length=1)]
Count = Annotated[int, Meta(ge=0)]
Index = tuple[Count, ...]
Sign = Literal["at_least_zero", "above_zero"]
Axis = Literal["x", "y", "z"]
ElementShape = Literal["line", "wheel", "block", "plate", "ball"]


class Part(Struct, frozen=True, forbid_unknown_fields=True):
    """A part of a description: immutable; another key than its attributes is an error."""


class Named(Part, frozen=True):
    """A pose component, a coordinate, a drive or a spring: name, SI unit and a noun phrase."""

    name: Name
    unit: Name
    description: str


class Key(Part, frozen=True):
    """A key of a table of the robot file.

    Attributes
    ----------
    name : str
    kind : str
        ``quantity``; ``vector`` of quantities; ``pair`` of quantities, the lower one first; ``direction``, a unit
        vector that is normalised on reading; ``choice``, one of `choices`, stored as its value; ``one_of``, one of
        `choices`, stored as a 1 at its place in the field; ``signs``, numbers that are each +1 or -1.
    field : str
        Field of the generated `Parameters`; empty for a constant used by an effect only.
    dimension : str
        One of `UNITS`.
    description : str
        A noun phrase.
    index : tuple of int
        Index into the field, after that of a repeated table.
    elements : tuple of str
        Names of the elements of a vector or pair, in paths.
    choices : tuple of int
    at_least, above, at_most, below : float or None
        Bounds of each quantity in SI units.
    default : float or None
        In SI units, of every element of a vector; a key without a default is required.
    effect : str
        The effect parameter that takes this value, ``<effect>.<parameter>``; empty for none.
    signed : bool
        Whether a quantity may have either sign or be zero.
    suspected : bool
        Whether a quantity without a standard deviation is a diagnosis candidate; one of a `ParameterGroup` is not.
    middle_of : str
        Path of the pair whose middle is the default, in place of `default`; empty for none.
    """

    name: Name
    kind: Literal["quantity", "vector", "pair", "direction", "choice", "one_of", "signs"]
    field: str
    dimension: Name
    description: str
    index: Index = ()
    elements: tuple[Name, ...] = ()
    choices: tuple[int, ...] = ()
    at_least: float | None = None
    above: float | None = None
    at_most: float | None = None
    below: float | None = None
    default: float | None = None
    effect: str = ""
    signed: bool = False
    suspected: bool = True
    middle_of: str = ""

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of its numbers in the field."""
        if self.kind == "direction":
            return (3,)
        if self.kind == "one_of":
            return (len(self.choices),)
        return () if self.kind in ("quantity", "choice") else (len(self.elements),)


class Table(Part, frozen=True):
    """A table of the robot file.

    Attributes
    ----------
    name, description : str
    keys : tuple of Key
    count : int
        Number of entries of a repeated table, ``[[axis]]``; 0 for a single table.
    shared_by : str
        The repeated table whose entries share these values and may override them; empty for none.
    """

    name: Name
    description: str
    keys: tuple[Key, ...]
    count: Annotated[int, Meta(ge=0, le=1000)] = 0
    shared_by: str = ""


class ParameterGroup(Part, frozen=True):
    """Several numbers that one path changes together.

    Attributes
    ----------
    path : str
    kind : str
        ``span``: moves both ends of every pair evenly apart; ``radius``: scales every vector.  Its value: the first.
    field, unit, description : str
    """

    path: Name
    kind: Literal["span", "radius"]
    field: Name
    unit: Name
    description: str


class Margin(Part, frozen=True):
    """A condition on a pose, given as a function that is positive where it holds.

    Attributes
    ----------
    code : str
        The `reason` of a pose that violates it: ``reachable``, ``singular``, ``limits``.  They are checked in order.
    function : str
        Function of the generated model.
    output : int
        Index of its result.
    rule : str
        ``at_least_zero``, ``above_zero``, or ``at_most_limit`` of a condition number.
    meaning : str
        Short statement about a pose that violates it.
    sentence : str
        The statement with ``{0}``, ``{1}`` for the names of the entry with the smallest margin, and ``{missing}`` for
        the shortfall, ``{short}`` for a length with that shortfall ("0.01 m too short"), or ``{value}``.
    remedy : str
    names : tuple of tuple of str
        Names of the entries along each axis of the result.
    unit : str
    """

    code: Name
    function: Name
    output: Count
    rule: Literal["at_least_zero", "above_zero", "at_most_limit"]
    meaning: str
    sentence: str
    remedy: str
    names: tuple[tuple[str, ...], ...] = ()
    unit: Name = "m"


class Scale(Part, frozen=True):
    """The parameter, with its symbol, that divides a coordinate's shape component in printed tables."""

    coordinate: Name
    field: Name
    index: Index
    symbol: Name


class Requirement(Part, frozen=True):
    """A condition on a robot at any pose, given as a function of its parameters.

    Attributes
    ----------
    function : str
        Function of the generated model, or of its effects, with one entry for each of the places.
    rule : str
        ``at_least_zero`` or ``above_zero``.
    places : tuple of str
        Paths of the robot file, one for each entry.
    sentence : str
        With ``{missing}`` for the shortfall, ``{value}`` for the function's value, and paths in the table of the
        place, such as ``{limits.min}``, for quantities of the file.
    remedy, unit : str
    """

    function: Name
    rule: Sign
    places: tuple[Name, ...]
    sentence: str
    remedy: str
    unit: Name


class EffectParameter(Part, frozen=True):
    """A parameter of an effect: 0 for no effect, otherwise within its bounds, if it has any.

    Attributes
    ----------
    releases : tuple of str
        Coordinates of the effect whose springs have this compliance.
    in_place_of : str
        The parameter that a robot file may have instead, but not as well; empty for none.
    """

    name: Name
    unit: Name
    description: str
    greater_than: float | None
    fitted: bool
    less_than: float | None = None
    releases: tuple[Name, ...] = ()
    in_place_of: str = ""


class Effect(Part, frozen=True):
    """An effect that applies to the mechanism.

    Attributes
    ----------
    name, sentence : str
    grounds : bool
        Whether it ties the machine to ground; how many rigid-body modes are left follows from its energy.
    coordinates : tuple of Named
        The coordinates that it releases.
    parameters : tuple of EffectParameter
    requirements : tuple of Requirement
        Conditions on the parameters.
    dissipates : bool
        Whether it only dissipates: M, K and the frequencies are those without it.
    """

    name: Name
    sentence: str
    grounds: bool
    coordinates: tuple[Named, ...]
    parameters: Annotated[tuple[EffectParameter, ...], Meta(min_length=1)]
    requirements: tuple[Requirement, ...]
    dissipates: bool = False

    @property
    def fitted(self) -> tuple[EffectParameter, ...]:
        """Parameters that can be estimated from measurements."""
        return tuple(parameter for parameter in self.parameters if parameter.fitted)

    @property
    def forms(self) -> dict[str, tuple[EffectParameter, ...]]:
        """What can be estimated at once, by name: the effect, and each parameter that stands in place of others."""
        alone = {f"{self.name}.{p.name}": (p,) for p in self.fitted if p.in_place_of}
        return {self.name: tuple(p for p in self.fitted if not p.in_place_of), **alone}

    def excluded(self, name: str) -> tuple[EffectParameter, ...]:
        """Return the parameters that a robot file cannot have together with a parameter of this name."""
        (own,) = (p for p in self.parameters if p.name == name)
        return tuple(p for p in self.parameters if p.in_place_of == name or p.name == own.in_place_of)


class Element(Part, frozen=True):
    """An element of a drawing.

    Attributes
    ----------
    shape : str
        ``line`` through its points; ``wheel`` about the first point, the second giving axis and radius; ``block``
        about the first point, the second giving direction and half length; ``plate``, the convex hull of its points;
        ``ball``, one point.
    kind, name : str
        What it is, such as ``belt``, and which one.
    points : tuple of int
        Indices of its points.
    spring : int
        Index of the spring that it is, -1 for none.
    turns : str
        The coordinate by which a wheel turns, right-handed about its axis; empty for none.
    place : str
        The body that it shows, as a place of terms; empty for none.
    """

    shape: ElementShape
    kind: Name
    name: str
    points: Annotated[Index, Meta(min_length=1)]
    spring: Annotated[int, Meta(ge=-1)] = -1
    turns: str = ""
    place: str = ""


class Drawing(Part, frozen=True):
    """What a picture of the mechanism shows, and its springs.

    Attributes
    ----------
    motions : tuple of int
        For each point, the index of its motion; points of one body move alike.
    elements : tuple of Element
    springs : tuple of Named
        Name, unit of the stiffness, and description; without the springs of released joints.
    uprights : int
        Number of unit vectors that the robot leaves open and a viewer chooses.
    """

    motions: Index
    elements: tuple[Element, ...]
    springs: tuple[Named, ...]
    uprights: Count


class Term(Part, frozen=True, omit_defaults=True):
    """A form at a place, which no effect of the catalogue has: what a diagnosis tries beyond it.

    The displacements that it uses are rows of the generated ``place_motion``.

    Attributes
    ----------
    name : str
        "spring:pulley_2_1/pulley_2_2".
    form : str
        ``mass``, ``spring``, ``mount`` or ``resonator``.
    sentence : str
        A noun phrase.
    parameters : tuple of Named
        The first one determines its size: at 0 the term is absent.
    rows : tuple of int
        Of a mass or resonator: its inertia is the sum of the squares of these displacements.
    strains : tuple of tuple of int
        Of a spring: in each direction the displacement that strains it, or the two whose difference does.
    swings : int
        Of a resonator: the displacement along which it swings; -1 for none.
    declared : tuple of str and int, or None
        The field and index of the declared inertia that a mass adds to, or whose weight it has; None where the place
        moves along a straight line, so that a weight does not matter.
    mount : int
        Of a mount: its row of the generated ``mount_matrices``; -1 for none.
    """

    name: Name
    form: Literal["mass", "spring", "mount", "resonator"]
    sentence: Name
    parameters: Annotated[tuple[Named, ...], Meta(min_length=1)]
    rows: Index = ()
    strains: tuple[Index, ...] = ()
    swings: Annotated[int, Meta(ge=-1)] = -1
    declared: tuple[str, int] | None = None
    mount: Annotated[int, Meta(ge=-1)] = -1


class Description(Part, frozen=True, omit_defaults=True):
    """A mechanism.

    Attributes
    ----------
    name, title : str
    pose : tuple of Named
        Components of a pose; their names are columns of measurement files.
    pose_is : str
        The point that a pose describes, such as "platform centre in the base frame".
    coordinates : tuple of Named
        The generalised coordinates without effects.
    independent : tuple of str
        Coordinates that the pose determines and that move the platform.
    independent_are : str
        Plural noun for them, such as "arm angles".
    directions : tuple of str
        Axes along which the platform moves; pose components of these names are its position.
    drives : tuple of Named
        The drives on which the static torques act.
    rigid_modes : int
        Number of motions that strain no elastic part, without effects.
    tables : tuple of Table
    parameter_groups : tuple of ParameterGroup
    margins : tuple of Margin
    requirements : tuple of Requirement
    effects_in_order : tuple of Effect
        Effects that apply, in the order of the generated model.
    sample : dict
        Parameters by field, numbers or nested lists, of a robot without symmetry, which the checks evaluate.
    scales : tuple of Scale
        For coordinates whose unit differs from that of most others.
    difference_pairs : tuple of (str, str)
        A field that enters only through its difference from another, and the other, which has the sensitivities.
    drawing : Drawing
    rotations : tuple of str
        Axes about which the platform turns, if any: see `components`.
    terms : tuple of Term
        What a diagnosis tries beyond the effects.
    moving_bodies : tuple of str
        What moves along each of the directions, such as "tool head"; empty where it is the platform.
    """

    name: Name = field(name="mechanism")
    title: Name
    pose: Annotated[tuple[Named, ...], Meta(min_length=1)]
    pose_is: Name
    coordinates: tuple[Named, ...]
    independent: Annotated[tuple[str, ...], Meta(min_length=1)]
    independent_are: Name
    directions: Annotated[tuple[str, ...], Meta(min_length=1)]
    drives: Annotated[tuple[Named, ...], Meta(min_length=1)]
    rigid_modes: Count
    tables: tuple[Table, ...]
    parameter_groups: tuple[ParameterGroup, ...] = field(name="wholes")
    margins: tuple[Margin, ...]
    requirements: tuple[Requirement, ...]
    effects_in_order: tuple[Effect, ...] = field(name="effects")
    sample: dict[str, Any]
    scales: tuple[Scale, ...]
    difference_pairs: tuple[tuple[str, str], ...] = field(name="differences")
    drawing: Drawing
    rotations: tuple[Axis, ...] = ()
    terms: tuple[Term, ...] = ()
    moving_bodies: tuple[Name, ...] = ()

    @property
    def components(self) -> tuple[Name, ...]:
        """The pose components that say where the platform is and how it is turned, in the order of `platform`."""
        return self.directions + tuple(f"r{axis}" for axis in self.rotations)

    @property
    def platform(self) -> tuple[Named, ...]:
        """The components of the platform's motion, the rows of its Jacobian: displacements, then small rotations."""
        moved = tuple(Named(f"p_{axis}", "m", f"displacement along {axis}") for axis in self.directions)
        return moved + tuple(Named(f"r_{a}", "rad", f"small rotation about {a}") for a in self.rotations)
