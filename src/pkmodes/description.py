"""Words of a mechanism's description: its tables and keys, what a pose and a robot need, its effects.

They are read from the ``description.json`` that is generated with the code; `pkmodes.mechanism` has the whole.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Named:
    """A component of the pose, a coordinate or a drive: name, SI unit and a noun phrase."""

    name: str
    unit: str
    description: str


@dataclass(frozen=True)
class Key:
    """A key of a table of the robot file.

    Attributes
    ----------
    name, kind : str
        The kind is ``quantity``; ``vector`` of quantities; ``pair`` of quantities, the lower one first;
        ``direction``, a unit vector that is normalised on reading; ``choice``, one of some numbers; ``one_of``, one
        of some numbers, whose place has a 1 in the field; ``signs``, numbers that are each +1 or -1.
    field : str
        Of the generated `Parameters`; empty for a constant that an effect takes.
    dimension, description : str
    index : tuple of int
        Where in the field, after the index of a repeated table.
    elements : tuple of str
        Names of the elements of a vector or pair, in paths.
    choices : tuple of int
    at_least, above, at_most : float or None
        Bounds in SI units.
    default : float or None
        In SI units; without one the key is needed.
    effect : str
        The parameter of an effect that takes this value, ``<effect>.<parameter>``; empty for none.
    signed : bool
        Whether a quantity may have either sign, or be zero.
    suspected : bool
        Whether it is a candidate where it has no standard deviation.
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
    """A table of the robot file: ``count`` times if repeated, else 0; perhaps shared by the entries of another."""

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
    """Something that a pose needs, as one result of a generated function.

    Attributes
    ----------
    code, meaning : str
        What `reason` says of a pose without it, and what that means.
    function : str
    output : int
    rule : str
        ``at_least_zero``, ``above_zero``, or ``at_most_limit`` of a condition number.
    sentence : str
        With ``{0}``, ``{1}`` for the names of the place of the smallest, ``{missing}``, ``{short}`` and ``{value}``.
    remedy : str
    names : tuple of tuple of str
        What the places of each axis of the result are called.
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
    """What a coordinate's component of a shape is divided by where a person sees it, and its symbol."""

    coordinate: str
    field: str
    index: tuple[int, ...]
    symbol: str


@dataclass(frozen=True)
class Requirement:
    """Something that a robot needs at any pose: a function of its parameters, an entry for each of the places."""

    function: str
    rule: str
    places: tuple[str, ...]
    sentence: str
    remedy: str
    unit: str


@dataclass(frozen=True)
class EffectParameter:
    """A parameter of an effect: 0 for none, otherwise above its bound, if there is one."""

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
        Whether it ties the platform to ground, so that no rigid-body mode is left.
    coordinates : tuple of Named
        That it releases.
    parameters : tuple of EffectParameter
    requirements : tuple of Requirement
        What it needs of them: functions of the generated effects.
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
