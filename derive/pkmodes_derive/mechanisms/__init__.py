"""The mechanisms: every package in this folder is one, nothing else lists them; and those that a user adds.

A mechanism's module has a function ``declare(machine)``, which reads like the description of the machine in a paper:
tables, coordinates, closures, bodies, transmissions, and what a pose needs.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

from pkmodes_derive import definition
from pkmodes_derive.assembly import models
from pkmodes_derive.declared import check_declared, check_model
from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.description import Description
from pkmodes_derive.effect import Effect
from pkmodes_derive.effects import catalogue
from pkmodes_derive.functions import Model
from pkmodes_derive.machine import Machine

#: Definitions of a user's own mechanisms by name: text and module.
_added: dict[str, tuple[str, ModuleType]] = {}
MEND = "mend the declaration"


def names() -> tuple[str, ...]:
    """Every mechanism that comes with pkmodes."""
    return tuple(sorted(module.name for module in iter_modules(__path__)))


def add(name: str, text: str, place: str) -> None:
    """Add a user's own mechanism, or replace it by what its definition says now.

    Parameters
    ----------
    name : str
    text : str
        The definition: a Python source.
    place : str
        Its file, for messages.

    Raises
    ------
    DefinitionError
        If the name is taken or anything in the definition is wrong, as far as that is seen without deriving it.
    """
    definition.check_name(name, place)
    if name in names():
        raise DefinitionError(
            f'"{name}" is a mechanism of pkmodes already', place, "give the file another name"
        )
    if name in _added and _added[name][0] == text:
        return
    module = definition.read(name, text, place)
    _added[name] = text, module
    for known in (base, extended, single):
        known.cache_clear()
    machine(name)


def source(name: str) -> str | None:
    """The definition of a user's own mechanism, None for one that comes with pkmodes."""
    return _added[name][0] if name in _added else None


def machine(name: str, effects: Sequence[Effect] = ()) -> Machine:
    """A machine as its mechanism declares it, with some effects."""
    if name not in _added:
        return _machine(import_module(f"{__name__}.{name}"), name, effects)
    module = _added[name][1]
    with definition.told(str(module.__file__), MEND):
        check_declared(_machine(module, name, ()))
    during = f", with the effects {', '.join(effect.name for effect in effects)}" if effects else ""
    with definition.told(str(module.__file__), MEND, during):
        return _machine(module, name, effects)


def _machine(module: ModuleType, name: str, effects: Sequence[Effect]) -> Machine:
    declared = Machine(name, module.TITLE, module.DIRECTIONS)
    module.declare(declared)
    declared.finish()
    declared.apply(effects)
    return declared


def effects(name: str) -> tuple[Effect, ...]:
    """Effects that apply to a mechanism: it has the parts that they act on."""
    bare = machine(name)
    return tuple(effect for effect in catalogue() if effect.parts(bare))


@cache
def base(name: str) -> Model:
    """The model of a mechanism without effects, derived once in a process."""
    if name not in _added:
        return models.base(machine(name), getattr(import_module(f"{__name__}.{name}"), "relations", None))
    declared, place = machine(name), str(_added[name][1].__file__)
    with definition.told(place, MEND, ", as it is derived"):
        model = models.base(declared)
    with definition.told(place, MEND):
        check_model(declared, model)
    return model


@cache
def extended(name: str) -> Model:
    """The model of a mechanism with every effect that applies, derived once in a process."""
    declared = machine(name, effects(name))
    if name not in _added:
        return models.extended(declared)
    with definition.told(str(_added[name][1].__file__), MEND, ", as it is derived with every effect"):
        return models.extended(declared)


@cache
def single(name: str, chosen: tuple[str, ...], zeros: frozenset[tuple[str, int]]) -> Model:
    """The model of a mechanism with some effects, by name, for one robot; derived once in a process.

    `zeros` are the (field, index) of the robot's parameters that are zero: without inertia a coordinate has no mode.
    """
    some = tuple(effect for effect in effects(name) if effect.name in chosen)
    return models.single(machine(name, some), zeros)


def description(name: str) -> Description:
    """What the runtime has to know of a mechanism."""
    return models.describe(machine(name, effects(name)), base(name).rigid_modes)
