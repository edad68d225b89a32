"""The mechanisms: every package in this folder defines one (there is no other list), and users can add their own.

The module of a mechanism has a function ``declare(machine)``, which reads like the description of a machine in a
paper: tables, coordinates, closures, bodies, transmissions, and conditions on a pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

from pkmodes_derive import definition
from pkmodes_derive.applying import apply_effects
from pkmodes_derive.assembly import drawing as drawn
from pkmodes_derive.assembly import models
from pkmodes_derive.declared import check_declared, check_model, check_names
from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.description import Description, DrawingData
from pkmodes_derive.effect import Effect
from pkmodes_derive.effects import catalogue
from pkmodes_derive.functions import Model
from pkmodes_derive.machine import Machine

#: User-defined mechanisms by name: text and module of the definition.
_added: dict[str, tuple[str, ModuleType]] = {}
REMEDY = "fix the declaration"


def names() -> tuple[str, ...]:
    """Return the names of the mechanisms that come with pkmodes."""
    return tuple(sorted(module.name for module in iter_modules(__path__)))


def add(name: str, text: str, place: str) -> None:
    """Add a user-defined mechanism, or replace it by its current definition.

    Parameters
    ----------
    name : str
    text : str
        The definition, as Python source.
    place : str
        Its file, for messages.

    Raises
    ------
    DefinitionError
        If the name is taken, or the definition has a mistake that shows before the derivation.
    """
    definition.check_name(name, place)
    if name in names():
        raise DefinitionError(
            f'"{name}" is already a mechanism of pkmodes', place, "give the file another name"
        )
    if name in _added and _added[name][0] == text:
        return
    module = definition.read(name, text, place)
    _added[name] = text, module
    for known in (base, extended, drawing, single):
        known.cache_clear()
    machine(name)


def source(name: str) -> str | None:
    """Return the definition of a user-defined mechanism, None for one that comes with pkmodes."""
    return _added[name][0] if name in _added else None


def machine(name: str, effects: Sequence[Effect] = ()) -> Machine:
    """Return the machine that a mechanism declares, with some effects."""
    if name not in _added:
        return _machine(import_module(f"{__name__}.{name}"), name, effects)
    module = _added[name][1]
    with definition.told(str(module.__file__), REMEDY):
        check_declared(_machine(module, name, ()))
    during = f", with the effects {', '.join(effect.name for effect in effects)}" if effects else ""
    with definition.told(str(module.__file__), REMEDY, during):
        return _machine(module, name, effects)


def _machine(module: ModuleType, name: str, effects: Sequence[Effect]) -> Machine:
    declared = Machine(name, module.TITLE, module.DIRECTIONS)
    module.declare(declared)
    declared.finish()
    apply_effects(declared, effects)
    return declared


def effects(name: str) -> tuple[Effect, ...]:
    """Return the effects that apply to a mechanism, which are those with parts to act on."""
    bare = machine(name)
    return tuple(effect for effect in catalogue() if effect.parts(bare))


@cache
def base(name: str) -> Model:
    """Return the model of a mechanism without effects, derived once per process."""
    if name not in _added:
        return models.base(machine(name), getattr(import_module(f"{__name__}.{name}"), "relations", None))
    declared, place = machine(name), str(_added[name][1].__file__)
    with definition.told(place, REMEDY, ", during the derivation"):
        model = models.base(declared)
    with definition.told(place, REMEDY):
        check_model(declared, model)
        check_names(declared, model)
    return model


@cache
def extended(name: str) -> Model:
    """Return the model of a mechanism with every effect that applies, derived once per process."""
    declared = machine(name, effects(name))
    if name not in _added:
        return models.extended(declared)
    with definition.told(str(_added[name][1].__file__), REMEDY, ", during the derivation with every effect"):
        model = models.extended(declared)
    with definition.told(str(_added[name][1].__file__), REMEDY):
        check_names(declared, model)
    return model


@cache
def drawing(name: str) -> tuple[Model, DrawingData]:
    """Return the model of a mechanism's drawing, with every effect, and its description; derived once per process."""
    declared = machine(name, effects(name))
    if name not in _added:
        return drawn.drawing(declared)
    with definition.told(str(_added[name][1].__file__), REMEDY, ", during the derivation of its drawing"):
        return drawn.drawing(declared)


@cache
def single(name: str, chosen: tuple[str, ...], zeros: frozenset[tuple[str, int]]) -> Model:
    """Return the model of a mechanism with some effects, by name, for one robot; derived once per process.

    `zeros` are the (field, index) of the robot's zero parameters: a coordinate without inertia has no mode.
    """
    some = tuple(effect for effect in effects(name) if effect.name in chosen)
    return models.single(machine(name, some), zeros)


def description(name: str) -> Description:
    """Return what the runtime needs to know about a mechanism."""
    described = models.describe(machine(name, effects(name)), base(name).rigid_modes)
    return replace(described, drawing=drawing(name)[1])
