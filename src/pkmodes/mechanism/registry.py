"""A mechanism at runtime: its description and its generated functions.

Everything that differs between mechanisms comes from here: the description that is generated with the code
(``description.json``) and the generated modules.  No other module refers to a mechanism by name.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib import import_module
from importlib.resources import files
from os import PathLike
from types import ModuleType
from typing import Any

from pkmodes.base.errors import PkmodesError, nearest, shown
from pkmodes.mechanism.description import (
    Drawing,
    Effect,
    EffectParameter,
    Element,
    Key,
    Margin,
    Named,
    Requirement,
    Scale,
    Table,
    Whole,
)
from pkmodes.mechanism.packages import OPTION, again, folder_of, imported, installed, place_of

__all__ = [
    "Drawing",
    "Effect",
    "EffectParameter",
    "Element",
    "Key",
    "Margin",
    "Mechanism",
    "Named",
    "Requirement",
    "Scale",
    "Table",
    "Whole",
    "add",
    "add_folder",
    "meanwhile",
    "mechanism",
    "names",
    "supplied",
]

#: The package of the generated models.
GENERATED = "pkmodes_generated"
DESCRIPTION = "description.json"
#: Packages of other mechanisms, by mechanism name: see `add`.
_added: dict[str, str] = {}


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A mechanism: its description and its generated functions.

    Attributes
    ----------
    name, title : str
    pose : tuple of Named
        Components of a pose; their names are columns of measurement files.
    pose_is : str
        Noun phrase that describes a pose.
    coordinates : tuple of Named
        Coordinates without effects.
    independent : tuple of str
        Coordinates that are determined by the pose and move the platform.
    independent_are : str
        Noun phrase for the independent coordinates.
    directions : tuple of str
        Components of the platform's motion.
    drives : tuple of Named
        The drives on which the static torques act.
    rigid_modes : int
        Number of rigid-body modes of the model without effects.
    tables : tuple of Table
    wholes : tuple of Whole
    margins : tuple of Margin
    requirements : tuple of Requirement
    effects : mapping of str to Effect
        Effects that apply, in the order of the generated model.
    sample : mapping of str to number or nested list
        Parameters of an asymmetric robot.
    package : str
        Package with the generated functions.
    scales : tuple of Scale
        For coordinates whose unit differs from that of most coordinates.
    differences : mapping of str to str
        Fields that enter only as the difference from another field, which carries the sensitivities.
    drawing : Drawing or None
        None for code that was generated before there were drawings.
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
    drawing: Drawing | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.package, folder_of(self.package))

    @cached_property
    def model(self) -> ModuleType:
        """The generated model without effects."""
        return import_module(self.package)

    @cached_property
    def extended(self) -> ModuleType:
        """The generated model with effects."""
        return import_module(f"{self.package}.extended")

    @cached_property
    def drawn(self) -> ModuleType:
        """The generated points and springs of the drawing."""
        return import_module(f"{self.package}.drawing")


def names() -> tuple[str, ...]:
    """Return the names of all known mechanisms: supplied with pkmodes, added, or installed as a package.

    Returns
    -------
    tuple of str
        In alphabetical order.
    """
    return tuple(sorted({*_generated(), *_added, *installed()}))


def supplied() -> tuple[str, ...]:
    """Return the names of the mechanisms that come with pkmodes."""
    return tuple(sorted(_generated()))


def mechanism(name: str) -> Mechanism:
    """Return the mechanism with a given name.

    Parameters
    ----------
    name : str
        As in the robot file.

    Returns
    -------
    Mechanism
        Its description and its generated functions.

    Raises
    ------
    PkmodesError
        If there is none (the message suggests the nearest), or the package installed under that name cannot be read.
    """
    if name in _added:
        return _read(_added[name])
    if name in _generated():
        return _read(f"{GENERATED}.{name}")
    if name in installed():
        return _described_in(installed()[name])
    remedy = nearest(name, names(), f"known: {', '.join(names())}; add one of your own with {OPTION}")
    raise PkmodesError(f"unknown mechanism {shown(name)}", "mechanism", remedy)


def add(package: str) -> Mechanism:
    """Register a mechanism whose description and functions were generated into a separate package.

    Parameters
    ----------
    package : str
        Import name of the package, which contains a ``description.json`` and a module ``extended``.

    Raises
    ------
    PkmodesError
        If it cannot be imported, or has the name of a mechanism of pkmodes.
    """
    found = _described_in(package)
    if found.name in _generated() and package != f"{GENERATED}.{found.name}":
        what = f"{shown(found.name)} is a mechanism of pkmodes already"
        raise PkmodesError(what, place_of(package), "give your mechanism another name")
    _added[found.name] = package
    return found


def add_folder(path: str | PathLike[str]) -> Mechanism:
    """Register a mechanism that ``pkmodes generate --mechanism FILE.py ...`` wrote into a folder.

    Robot files can then name it.  If the name was added before, the present content of the folder replaces it.

    Parameters
    ----------
    path : path-like
        The folder of the mechanism, ``DIR/<mechanism>``.

    Returns
    -------
    Mechanism
        Its description and its generated functions.

    Raises
    ------
    PkmodesError
        If it is not such a folder, cannot be imported, or has the name of a mechanism of pkmodes.
    """
    return add(imported(path))


@contextmanager
def meanwhile(path: str | PathLike[str]) -> Iterator[Mechanism]:
    """Register the mechanism in a folder for the duration of the context."""
    before = dict(_added)
    try:
        yield add_folder(path)
    finally:
        _added.clear()
        _added.update(before)


def _unpickled(package: str, folder: str | None) -> Mechanism:
    """Restore a mechanism from another process and register it, as it was registered there."""
    if folder is not None:
        package = again(package, folder)
    found = _read(package)
    if found.name not in names():
        _added[found.name] = package
    return found


def _described_in(package: str) -> Mechanism:
    try:
        return _read(package)
    except (ImportError, OSError, ValueError, LookupError, TypeError) as error:
        what = f"cannot read the description of a mechanism: {type(error).__name__}: {error}"
        remedy = "generate it again, or name the package that has its description.json"
        raise PkmodesError(what, place_of(package), remedy) from None


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
            tuple(_parameter(p) for p in e["parameters"]),
            tuple(Requirement(**_tuples(r)) for r in e.get("requirements", ())),
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
        drawing=_drawing(data["drawing"]) if "drawing" in data else None,
    )


def _drawing(data: dict[str, Any]) -> Drawing:
    return Drawing(
        tuple(data["motions"]),
        tuple(Element(**_tuples(e)) for e in data["elements"]),
        tuple(Named(**s) for s in data["springs"]),
        data["uprights"],
    )


def _parameter(data: dict[str, Any]) -> EffectParameter:
    """Return a parameter of an effect; no bound becomes minus infinity, which JSON cannot express."""
    bound = data["greater_than"]
    return EffectParameter(**{**data, "greater_than": -math.inf if bound is None else bound})


def _tuples(data: dict[str, Any]) -> dict[str, Any]:
    """Return the data with tuples in place of lists."""

    def frozen(value: Any) -> Any:
        return tuple(map(frozen, value)) if isinstance(value, list) else value

    return {name: frozen(value) for name, value in data.items()}
