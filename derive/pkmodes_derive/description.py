"""What a mechanism tells the runtime about itself: its robot file, its poses, and what its functions stand for.

It is emitted as data (``description.json``), so that the runtime reads robot files, checks poses, names parameter
paths and reports without knowing any mechanism by name.
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


@dataclass(frozen=True)
class Key:
    """A key of a table of the robot file.

    Attributes
    ----------
    name : str
    kind : str
        ``quantity``; ``vector`` of quantities; ``pair`` of quantities, the lower one first; ``direction``, a unit
        vector that is normalised on reading; ``choice``, one of some numbers, which is its value; ``one_of``, one of
        some numbers, whose place has a 1 in the field; ``signs``, a list of numbers each +1 or -1.
    field : str
        Of the generated `Parameters`; empty for a constant that an effect takes.
    index : tuple of int
        Where in the field, after the index of a repeated table.
    dimension : str
        Of a quantity, in the words of messages: ``mass``, ``length``, ``moment of inertia`` ...
    description : str
        A noun phrase.
    elements : tuple of str
        Names of the elements of a vector or pair, in paths.
    choices : tuple of int
    at_least, above, at_most : float, optional
        Bounds of each quantity in SI units.
    default : float, optional
        In SI units; without one the key is needed.
    effect : str
        The parameter of an effect that takes this value, ``<effect>.<parameter>``.
    signed : bool
        Whether a quantity may have either sign, or be zero.
    suspected : bool
        Whether it is a candidate where it has no standard deviation; what belongs to a whole is not.
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
        Of a repeated table, ``[[axis]]``; 0 for a single one.
    shared_by : str
        The repeated table that takes these values, each entry of which may override them; empty for none.
    """

    name: str
    description: str
    keys: tuple[Key, ...]
    count: int = 0
    shared_by: str = ""


@dataclass(frozen=True)
class Whole:
    """Several numbers that one path moves together.

    Attributes
    ----------
    path : str
    kind : str
        ``span``: both ends of every pair evenly apart; ``radius``: every vector along itself.  The value is that of
        the first.
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
    """Something that a pose needs, as a function that is positive where it is so.

    Attributes
    ----------
    code : str
        What `reason` says: ``reachable``, ``singular``, ``limits``.  Margins are asked in their order.
    function, output : str and int
        Of the generated model, and which of its results.
    rule : str
        ``at_least_zero``, ``above_zero``, or ``at_most_limit`` of a condition number.
    meaning : str
        What a pose without it is, in a few words.
    sentence : str
        The same with ``{0}``, ``{1}`` for the names of the place of the smallest margin, and ``{missing}``, what it
        lacks, ``{short}``, how a length that lacks it is ("0.01 m too short", "of no length"), or ``{value}``.
    remedy : str
    names : tuple of tuple of str
        For each axis of the result, what its places are called.
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
    """What a component of a shape is divided by where shapes are shown to a person.

    Attributes
    ----------
    coordinate : str
    field, index : str and tuple of int
        The number of the generated `Parameters`.
    symbol : str
    """

    coordinate: str
    field: str
    index: tuple[int, ...]
    symbol: str


@dataclass(frozen=True)
class Requirement:
    """Something that a robot needs, whatever its pose, as a function of its parameters.

    Attributes
    ----------
    function : str
        Of the generated model; one entry for each of the places.
    rule : str
        ``at_least_zero`` or ``above_zero``.
    places : tuple of str
        Paths of the robot file, one for each entry.
    sentence : str
        With ``{missing}`` for what is missing, ``{value}`` for the function's value, and paths beside the place, such
        as ``{limits.min}``, for quantities of the file.
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
    """A parameter of an effect; its null value is 0, otherwise it is greater than the bound."""

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
class Description:
    """A mechanism.

    Attributes
    ----------
    mechanism, title : str
    pose : tuple of Named
        Components of a pose.
    pose_is : str
        What a pose is, such as "platform centre in the base frame".
    coordinates : tuple of Named
        The generalised coordinates without effects.
    independent : tuple of str
        Those of them that the pose determines and that move the platform.
    independent_are : str
        What they are, in the plural.
    directions : tuple of str
        Components of the platform's motion.
    drives : tuple of Named
        What the static torques act on.
    rigid_modes : int
        Motions that strain nothing elastic.
    tables : tuple of Table
    wholes : tuple of Whole
    margins : tuple of Margin
    requirements : tuple of Requirement
    effects : tuple of EffectData
    sample : mapping
        Parameters of a robot without any symmetry, by field: what checks evaluate.
    scales : tuple of Scale
        For coordinates of another unit than most.
    differences : tuple of (str, str)
        A field that enters only by its difference from another one, and that one, which has the sensitivities.
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


def as_data(description: Description) -> dict[str, object]:
    """The description as it is written."""
    return asdict(description)
