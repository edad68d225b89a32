"""Parts of a mechanism's description: tables and keys, conditions on a pose and on a robot, effects.

They are read from the ``description.json`` that is generated with the code; see `pkmodes.mechanism.registry`.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Named:
    """A pose component, a coordinate or a drive: name, SI unit and a noun phrase."""

    name: str
    unit: str
    description: str


@dataclass(frozen=True)
class Key:
    """A key of a table of the robot file.

    Attributes
    ----------
    name, kind : str
        The kind is ``quantity``; ``vector``, several quantities; ``pair``, two quantities, the lower one first;
        ``direction``, a unit vector that is normalised on reading; ``choice``, one of `choices`; ``one_of``, one of
        `choices`, stored as a one-hot vector; ``signs``, numbers that are each +1 or -1.
    field : str
        Field of the generated `Parameters`; empty for a constant used by an effect only.
    dimension, description : str
    index : tuple of int
        Index into the field, after the index of a repeated table.
    elements : tuple of str
        Names of the elements of a vector or pair, in paths.
    choices : tuple of int
    at_least, above, at_most : float or None
        Bounds in SI units.
    default : float or None
        In SI units; a key without a default is required.
    effect : str
        The effect parameter that takes this value, ``<effect>.<parameter>``; empty for none.
    signed : bool
        Whether a quantity may have either sign or be zero.
    suspected : bool
        Whether a quantity without a standard deviation is a diagnosis candidate.
    """

    name: str
    kind: str
    field: str
    dimension: str
    description: str
    index: tuple[int, ...]
    elements: tuple[str, ...]
    choices: tuple[int, ...]
    at_least: float | None
    above: float | None
    at_most: float | None
    default: float | None
    effect: str
    signed: bool
    suspected: bool


@dataclass(frozen=True)
class Table:
    """A table of the robot file.

    ``count`` is the number of entries of a repeated table, else 0; ``shared_by`` names the repeated table whose
    entries share its values, if any.
    """

    name: str
    description: str
    keys: tuple[Key, ...]
    count: int
    shared_by: str


@dataclass(frozen=True)
class Whole:
    """Several numbers that one path moves together: pairs as ``span``, vectors as ``radius``."""

    path: str
    kind: str
    field: str
    unit: str
    description: str


@dataclass(frozen=True)
class Margin:
    """A condition on a pose, given by one result of a generated function.

    Attributes
    ----------
    code, meaning : str
        The `reason` of a pose that violates it, and its meaning.
    function : str
    output : int
    rule : str
        ``at_least_zero``, ``above_zero``, or ``at_most_limit`` for a condition number.
    sentence : str
        With placeholders: ``{0}``, ``{1}`` are the `names` of the smallest entry; ``{missing}``, ``{short}`` and
        ``{value}`` are numbers.
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
    names: tuple[tuple[str, ...], ...]
    unit: str


@dataclass(frozen=True)
class Scale:
    """The parameter, with its symbol, that divides a coordinate's shape component in printed tables."""

    coordinate: str
    field: str
    index: tuple[int, ...]
    symbol: str


@dataclass(frozen=True)
class Element:
    """An element of a drawing of the mechanism.

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
    """

    shape: str
    kind: str
    name: str
    points: tuple[int, ...]
    spring: int
    turns: str


@dataclass(frozen=True)
class Drawing:
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

    motions: tuple[int, ...]
    elements: tuple[Element, ...]
    springs: tuple[Named, ...]
    uprights: int


@dataclass(frozen=True)
class Requirement:
    """A condition on a robot at any pose: a function of its parameters with one entry for each of `places`."""

    function: str
    rule: str
    places: tuple[str, ...]
    sentence: str
    remedy: str
    unit: str


@dataclass(frozen=True)
class EffectParameter:
    """A parameter of an effect: 0 for no effect, otherwise above its bound, if it has one."""

    name: str
    unit: str
    description: str
    greater_than: float | None
    fitted: bool


@dataclass(frozen=True)
class Effect:
    """An effect that applies to the mechanism.

    Attributes
    ----------
    name, sentence : str
    grounds : bool
        Whether it ties the platform to ground, so that there are no rigid-body modes.
    coordinates : tuple of Named
        The coordinates that it releases.
    parameters : tuple of EffectParameter
    requirements : tuple of Requirement
        Conditions on the parameters: functions of the generated effects.
    """

    name: str
    sentence: str
    grounds: bool
    coordinates: tuple[Named, ...]
    parameters: tuple[EffectParameter, ...]
    requirements: tuple[Requirement, ...] = ()

    @property
    def fitted(self) -> tuple[EffectParameter, ...]:
        """Parameters that can be estimated from measurements."""
        return tuple(parameter for parameter in self.parameters if parameter.fitted)
