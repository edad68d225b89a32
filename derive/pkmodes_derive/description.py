"""Description of a mechanism for the runtime: its robot file, its poses and the meaning of its functions.

It is emitted as data (``description.json``), so the runtime can read robot files, check poses, name parameter paths
and write reports without code for any particular mechanism.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field


@dataclass(frozen=True)
class Named:
    """A component of the pose, a coordinate or a direction.

    Attributes
    ----------
    name : str
    unit : str
        SI unit.
    description : str
        A noun phrase.
    """

    name: str
    unit: str
    description: str


#: Kinds of keys that are choices: nothing is differentiated with respect to them.
CHOICES = ("direction", "choice", "one_of", "signs")


@dataclass(frozen=True)
class Key:
    """A key of a table of the robot file.

    Attributes
    ----------
    name : str
    kind : str
        ``quantity``; ``vector`` of quantities; ``pair`` of quantities, the lower one first; ``direction``, a unit
        vector that is normalised on reading; ``choice``, one of several numbers, stored as its value; ``one_of``, one
        of several numbers, stored as a 1 at its place in the field; ``signs``, a list of numbers, each +1 or -1.
    field : str
        Field of the generated `Parameters`; empty for a constant used by an effect.
    index : tuple of int
        Index in the field, after that of a repeated table.
    dimension : str
        Dimension of a quantity, as named in messages: ``mass``, ``length``, ``moment of inertia`` ...
    description : str
        A noun phrase.
    elements : tuple of str
        Names of the elements of a vector or pair, in paths.
    choices : tuple of int
    at_least, above, at_most : float, optional
        Bounds of each quantity in SI units.
    default : float, optional
        In SI units; without one the key is required.
    effect : str
        The effect parameter that takes this value, ``<effect>.<parameter>``.
    signed : bool
        Whether a quantity may be negative or zero.
    suspected : bool
        Whether it is a candidate if it has no standard deviation; a quantity that belongs to a `Whole` is not.
    """

    name: str
    kind: str
    field: str
    dimension: str
    description: str
    index: tuple[int, ...] = ()
    elements: tuple[str, ...] = ()
    choices: tuple[int, ...] = ()
    at_least: float | None = None
    above: float | None = None
    at_most: float | None = None
    default: float | None = None
    effect: str = ""
    signed: bool = False
    suspected: bool = True


@dataclass(frozen=True)
class Table:
    """A table of the robot file.

    Attributes
    ----------
    name : str
    description : str
    keys : tuple of Key
    count : int
        Number of entries of a repeated table, ``[[axis]]``; 0 for a single table.
    shared_by : str
        The repeated table whose entries share these values and may override them; empty for none.
    """

    name: str
    description: str
    keys: tuple[Key, ...]
    count: int = 0
    shared_by: str = ""


@dataclass(frozen=True)
class Whole:
    """Several numbers that one path changes together.

    Attributes
    ----------
    path : str
    kind : str
        ``span``: moves both ends of every pair evenly apart; ``radius``: scales every vector.  The value is that of
        the first entry.
    field, unit : str
    description : str
    """

    path: str
    kind: str
    field: str
    unit: str
    description: str


@dataclass(frozen=True)
class Margin:
    """A condition on a pose, given as a function that is positive where it holds.

    Attributes
    ----------
    code : str
        The code in `reason`: ``reachable``, ``singular``, ``limits``.  Margins are checked in order.
    function, output : str and int
        Function of the generated model, and the index of its result.
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

    code: str
    function: str
    output: int
    rule: str
    meaning: str
    sentence: str
    remedy: str
    names: tuple[tuple[str, ...], ...] = ()
    unit: str = "m"


@dataclass(frozen=True)
class Scale:
    """The divisor of a mode shape component in displayed shapes.

    Attributes
    ----------
    coordinate : str
    field, index : str and tuple of int
        The divisor's place in the generated `Parameters`.
    symbol : str
    """

    coordinate: str
    field: str
    index: tuple[int, ...]
    symbol: str


@dataclass(frozen=True)
class Requirement:
    """A condition on a robot at any pose, given as a function of its parameters.

    Attributes
    ----------
    function : str
        Function of the generated model, with one entry for each of the places.
    rule : str
        ``at_least_zero`` or ``above_zero``.
    places : tuple of str
        Paths of the robot file, one for each entry.
    sentence : str
        With ``{missing}`` for the shortfall, ``{value}`` for the function's value, and paths in the table of the
        place, such as ``{limits.min}``, for quantities of the file.
    remedy : str
    unit : str
    """

    function: str
    rule: str
    places: tuple[str, ...]
    sentence: str
    remedy: str
    unit: str


@dataclass(frozen=True)
class EffectParameterData:
    """A parameter of an effect: 0, its null value, or greater than the bound."""

    name: str
    unit: str
    description: str
    greater_than: float | None
    fitted: bool


@dataclass(frozen=True)
class EffectData:
    """An effect that applies to the mechanism, with the coordinates that it releases."""

    name: str
    sentence: str
    grounds: bool
    coordinates: tuple[Named, ...]
    parameters: tuple[EffectParameterData, ...]
    requirements: tuple[Requirement, ...] = ()


@dataclass(frozen=True)
class ElementData:
    """An element of a drawing.

    Attributes
    ----------
    shape : str
        ``line``, ``wheel``, ``block``, ``plate`` or ``ball``; the meaning of their points is that of
        `pkmodes_derive.drawing.Element`.
    kind, name : str
    points : tuple of int
        Indices of its points.
    spring : int
        Index of the spring that it is, -1 for none.
    turns : str
        The coordinate by which a wheel turns; empty for none.
    """

    shape: str
    kind: str
    name: str
    points: tuple[int, ...]
    spring: int = -1
    turns: str = ""


@dataclass(frozen=True)
class DrawingData:
    """What a picture of the mechanism shows.

    Attributes
    ----------
    motions : tuple of int
        For each point, the index of its motion.
    elements : tuple of ElementData
    springs : tuple of Named
        Name, unit of the stiffness, and description.
    uprights : int
        Number of unit vectors that the robot leaves open.
    """

    motions: tuple[int, ...] = ()
    elements: tuple[ElementData, ...] = ()
    springs: tuple[Named, ...] = ()
    uprights: int = 0


@dataclass(frozen=True)
class Description:
    """A mechanism.

    Attributes
    ----------
    mechanism, title : str
    pose : tuple of Named
        Components of a pose.
    pose_is : str
        The point that a pose describes, such as "platform centre in the base frame".
    coordinates : tuple of Named
        The generalised coordinates without effects.
    independent : tuple of str
        Coordinates that the pose determines and that move the platform.
    independent_are : str
        Plural noun for them, such as "arm angles".
    directions : tuple of str
        Components of the platform's motion.
    drives : tuple of Named
        The rotors that the static torques act on.
    rigid_modes : int
        Number of motions that strain no elastic part.
    tables : tuple of Table
    wholes : tuple of Whole
    margins : tuple of Margin
    requirements : tuple of Requirement
    effects : tuple of EffectData
    sample : mapping
        Parameters by field of a robot without symmetry, which the checks evaluate.
    scales : tuple of Scale
        For coordinates whose unit differs from that of most others.
    differences : tuple of (str, str)
        A field that enters only through its difference from another, and the other, which has the sensitivities.
    drawing : DrawingData
    """

    mechanism: str
    title: str
    pose: tuple[Named, ...]
    pose_is: str
    coordinates: tuple[Named, ...]
    independent: tuple[str, ...]
    independent_are: str
    directions: tuple[str, ...]
    drives: tuple[Named, ...]
    rigid_modes: int
    tables: tuple[Table, ...]
    wholes: tuple[Whole, ...]
    margins: tuple[Margin, ...]
    requirements: tuple[Requirement, ...] = ()
    effects: tuple[EffectData, ...] = ()
    sample: Mapping[str, object] = field(default_factory=dict)
    scales: tuple[Scale, ...] = ()
    differences: tuple[tuple[str, str], ...] = ()
    drawing: DrawingData = field(default_factory=DrawingData)


def as_data(description: Description) -> dict[str, object]:
    """Return the description as plain data for JSON."""
    return asdict(description)
