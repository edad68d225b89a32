"""The mechanisms: every package in this folder is one; nothing else lists them.

A mechanism's module has a function ``declare(machine)``, which reads like the description of the machine in a paper:
tables, coordinates, closures, bodies, transmissions, and what a pose needs.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from pkmodes_derive.assembly import models
from pkmodes_derive.description import Description
from pkmodes_derive.effect import Effect
from pkmodes_derive.effects import catalogue
from pkmodes_derive.functions import Model
from pkmodes_derive.machine import Machine


def names() -> tuple[str, ...]:
    """Every mechanism."""
    return tuple(sorted(module.name for module in iter_modules(__path__)))


def machine(name: str, effects: Sequence[Effect] = ()) -> Machine:
    """A machine as its mechanism declares it, with some effects."""
    module = import_module(f"{__name__}.{name}")
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
    return models.base(machine(name), getattr(import_module(f"{__name__}.{name}"), "relations", None))


@cache
def extended(name: str) -> Model:
    """The model of a mechanism with every effect that applies, derived once in a process."""
    return models.extended(machine(name, effects(name)))


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
