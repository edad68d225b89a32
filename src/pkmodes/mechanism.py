"""A mechanism as the runtime sees it: what it says about itself, and its generated functions.

Everything that differs between mechanisms comes from here: the description that is generated with the code
(``description.json``) and the modules beside it.  No other module knows a mechanism by name.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib import import_module
from importlib.resources import files
from types import ModuleType
from typing import Any

from pkmodes.errors import PkmodesError, nearest, shown

#: The package of the generated models.
GENERATED = "pkmodes_generated"
DESCRIPTION = "description.json"
#: Packages of mechanisms that are not among them, by the mechanism's name: see `add`.
_added: dict[str, str] = {}


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
    """

    name: str
    sentence: str
    grounds: bool
    coordinates: tuple[Named, ...]
    parameters: tuple[EffectParameter, ...]

    @property
    def fitted(self) -> tuple[EffectParameter, ...]:
        """Parameters that can be estimated from measurements."""
        return tuple(parameter for parameter in self.parameters if parameter.fitted)


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A mechanism: its description and its generated functions.

    Attributes
    ----------
    name, title : str
    pose : tuple of Named
        Components of a pose; their names are columns of measurement files.
    pose_is : str
        What a pose is.
    coordinates : tuple of Named
        Without effects.
    independent : tuple of str
        Coordinates that the pose determines and that move the platform.
    independent_are : str
    directions : tuple of str
        Components of the platform's motion.
    drives : tuple of Named
        What the static torques act on.
    rigid_modes : int
        Of the model without effects.
    tables : tuple of Table
    wholes : tuple of Whole
    margins : tuple of Margin
    requirements : tuple of Requirement
    effects : mapping of str to Effect
        Those that apply, in the order of the generated model.
    sample : mapping of str to number or nested list
        Parameters of a robot without any symmetry.
    package : str
        That has the generated functions.
    scales : tuple of Scale
        For coordinates of another unit than most.
    differences : mapping of str to str
        Fields that enter only by their difference from another one, which has the sensitivities.
    """

    name: str
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
    requirements: tuple[Requirement, ...]
    effects: dict[str, Effect]
    sample: dict[str, Any]
    package: str
    scales: tuple[Scale, ...] = ()
    differences: dict[str, str] = field(default_factory=dict)

    def __reduce__(self) -> tuple[Any, ...]:
        return _read, (self.package,)

    @cached_property
    def model(self) -> ModuleType:
        """The generated model without effects."""
        return import_module(self.package)

    @cached_property
    def extended(self) -> ModuleType:
        """The generated model with effects."""
        return import_module(f"{self.package}.extended")


def names() -> tuple[str, ...]:
    """Every mechanism that is known."""
    return tuple(sorted({*_generated(), *_added}))


def mechanism(name: str) -> Mechanism:
    """The mechanism of a name.

    Raises
    ------
    PkmodesError
        If there is none, with the nearest.
    """
    if name in _added:
        return _read(_added[name])
    if name in _generated():
        return _read(f"{GENERATED}.{name}")
    remedy = nearest(name, names())
    raise PkmodesError(f"unknown mechanism {shown(name)}", "mechanism", remedy)


def add(package: str) -> Mechanism:
    """Make a mechanism known whose description and functions were generated into a package of their own.

    Parameters
    ----------
    package : str
        Its name, as one would import it; it has a ``description.json`` and a module ``extended``.
    """
    found = _read(package)
    _added[found.name] = package
    return found


@cache
def _generated() -> tuple[str, ...]:
    return tuple(entry.name for entry in files(GENERATED).iterdir() if (entry / DESCRIPTION).is_file())


@cache
def _read(package: str) -> Mechanism:
    return _described(json.loads((files(package) / DESCRIPTION).read_text(encoding="utf-8")), package)


def _described(data: dict[str, Any], package: str) -> Mechanism:
    effects = [
        Effect(
            e["name"],
            e["sentence"],
            e["grounds"],
            tuple(Named(**q) for q in e["coordinates"]),
            tuple(EffectParameter(**p) for p in e["parameters"]),
        )
        for e in data["effects"]
    ]
    return Mechanism(
        name=data["mechanism"],
        title=data["title"],
        pose=tuple(Named(**c) for c in data["pose"]),
        pose_is=data["pose_is"],
        coordinates=tuple(Named(**q) for q in data["coordinates"]),
        independent=tuple(data["independent"]),
        independent_are=data["independent_are"],
        directions=tuple(data["directions"]),
        drives=tuple(Named(**d) for d in data["drives"]),
        rigid_modes=data["rigid_modes"],
        tables=tuple(
            Table(
                t["name"],
                t["description"],
                tuple(Key(**_tuples(key)) for key in t["keys"]),
                t["count"],
                t["shared_by"],
            )
            for t in data["tables"]
        ),
        wholes=tuple(Whole(**w) for w in data["wholes"]),
        margins=tuple(Margin(**_tuples(m)) for m in data["margins"]),
        requirements=tuple(Requirement(**_tuples(r)) for r in data["requirements"]),
        effects={effect.name: effect for effect in effects},
        sample=data["sample"],
        package=package,
        scales=tuple(Scale(**_tuples(s)) for s in data["scales"]),
        differences=dict(data["differences"]),
    )


def _tuples(data: dict[str, Any]) -> dict[str, Any]:
    """The same with tuples in place of lists."""

    def frozen(value: Any) -> Any:
        return tuple(map(frozen, value)) if isinstance(value, list) else value

    return {name: frozen(value) for name, value in data.items()}
