"""The mechanisms: every package in this folder defines one (there is no other list), and users can add their own.

The module of a mechanism has a function ``declare(machine)``, which reads like the description of a machine in a
paper: tables, coordinates, closures, bodies, transmissions, and conditions on a pose.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from functools import _lru_cache_wrapper, cache, wraps
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType
from typing import TypeVar

from pkmodes_derive import definition, effect_file
from pkmodes_derive.assembly import models
from pkmodes_derive.assembly.drawing import drawing as model_and_drawing
from pkmodes_derive.assembly.held import held_motors
from pkmodes_derive.assembly.terms import terms_model
from pkmodes_derive.declaration_checks import check_declared, check_model, check_names
from pkmodes_derive.definition import DefinitionError, as_definition_errors
from pkmodes_derive.effect import Effect
from pkmodes_derive.effect_application import apply_effects
from pkmodes_derive.effects import catalogue
from pkmodes_derive.functions import HeldMotors, Model
from pkmodes_derive.kept import derive_once
from pkmodes_derive.machine import Machine
from pkmodes_description import Description, Drawing
from pkmodes_description import Term as DescribedTerm

T = TypeVar("T")
#: The field and the index of every parameter that is zero for a robot.
Zeros = frozenset[tuple[str, int]]

#: User-defined mechanisms by name: text and module of the definition.
_added: dict[str, tuple[str, ModuleType]] = {}
#: Effects of one's own by mechanism: text and effect of each file.
_own_effects: dict[str, tuple[tuple[str, Effect], ...]] = {}


def names() -> tuple[str, ...]:
    """Return the names of the mechanisms that come with pkmodes."""
    return tuple(sorted(module.name for module in iter_modules(__path__)))


def add(name: str, text: str, place: str) -> None:
    """Add a user-defined mechanism, or replace it by its current definition.

    Parameters
    ----------
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
    _clear_derived()
    machine(name)


def add_effects(name: str, files: Sequence[tuple[str, str]]) -> None:
    """Add effects of one's own to a mechanism, in place of those that it has; with none it has its catalogue's.

    Parameters
    ----------
    name : str
        The mechanism.
    files : sequence of (str, str)
        Text of each file, and its place for messages.

    Raises
    ------
    DefinitionError
        If a file has a mistake, or its effect does not apply to the mechanism or is not null at 0.
    """
    if [text for text, _ in files] == [text for text, _ in own_effects(name)]:
        return
    _own_effects.pop(name, None)
    _clear_derived()
    accepted: dict[str, tuple[str, Effect]] = {}
    for text, place in files:
        effect = effect_file.read(text, place)
        if effect.name in accepted:
            what = f'two effects have the name "{effect.name}"'
            raise DefinitionError(what, place, "give one of them another name")
        plain_machine = machine(name)
        with as_definition_errors(place, "fix the effect", f", applied to {name}"):
            with_effect = machine(name, [effect]) if effect.parts(plain_machine) else plain_machine
        effect_file.check(effect, plain_machine, with_effect, place)
        accepted[effect.name] = text, effect
    _own_effects[name] = tuple(accepted.values())


def own_effects(name: str) -> tuple[tuple[str, Effect], ...]:
    """Return the effects of one's own that a mechanism has, each after the text of its file."""
    return _own_effects.get(name, ())


def _clear_derived() -> None:
    """Derive everything again."""
    for derivation in (base, extended, drawing, terms_beyond_catalogue, single, held):
        derivation.cache_clear()


def source(name: str) -> str | None:
    """Return the definition of a user-defined mechanism, None for one that comes with pkmodes."""
    return _added[name][0] if name in _added else None


def origin(name: str) -> tuple[str | None, tuple[str, ...]]:
    """Return the texts from which a mechanism is derived beside this package: its definition, and effects."""
    return source(name), tuple(text for text, _ in own_effects(name))


def machine(name: str, effects: Sequence[Effect] = (), zeros: Zeros = frozenset()) -> Machine:
    """Return the machine that a mechanism declares, with some effects; `zeros` are a robot's zero parameters."""
    if name not in _added:
        return _declared_machine(import_module(f"{__name__}.{name}"), name, effects, zeros)
    module = _added[name][1]
    with _mistakes_reported(name):
        check_declared(_declared_machine(module, name, ()))
    with _mistakes_reported(
        name, f", with the effects {', '.join(e.name for e in effects)}" if effects else ""
    ):
        return _declared_machine(module, name, effects, zeros)


def _mistakes_reported(name: str, during: str = "") -> AbstractContextManager[None]:
    """Report mistakes in the definition of a user-defined mechanism, not those in one that comes with pkmodes."""
    if name not in _added:
        return nullcontext()
    return as_definition_errors(str(_added[name][1].__file__), "fix the declaration", during)


def _declared_machine(
    module: ModuleType, name: str, effects: Sequence[Effect], zeros: Zeros = frozenset()
) -> Machine:
    result = Machine(name, module.TITLE, module.DIRECTIONS, getattr(module, "ROTATIONS", ()))
    module.declare(result)
    result.finish()
    apply_effects(result, effects, zeros)
    return result


def effects(name: str) -> tuple[Effect, ...]:
    """Return the effects that apply to a mechanism, which are those with parts to act on."""
    plain_machine = machine(name)
    # In an order that does not depend on that of the files.
    own = sorted((effect for _, effect in own_effects(name)), key=lambda effect: effect.name)
    applicable = [effect for effect in (*catalogue(), *own) if effect.parts(plain_machine)]
    # Those that release coordinates are last, in the order of their coordinates.
    return tuple(sorted(applicable, key=lambda effect: (effect.released is not None, effect.order)))


def _derived_once(derive: Callable[..., T]) -> _lru_cache_wrapper[T]:
    """Derive once per process, and keep the result where a folder is named for it."""

    @cache
    @wraps(derive)
    def cached(name: str, *choice: object) -> T:
        inputs = name, *origin(name), [sorted(c) if isinstance(c, frozenset) else c for c in choice]
        return derive_once(derive.__name__, inputs, lambda: derive(name, *choice))

    return cached


@_derived_once
def base(name: str) -> Model:
    """Return the model of a mechanism without effects, derived once per process."""
    if name not in _added:
        return models.base(machine(name), getattr(import_module(f"{__name__}.{name}"), "relations", None))
    declared = machine(name)
    with _mistakes_reported(name, ", during the derivation"):
        model = models.base(declared)
    with _mistakes_reported(name):
        check_model(declared, model)
        check_names(declared, model)
    return model


@_derived_once
def extended(name: str) -> Model:
    """Return the model of a mechanism with every effect that applies, derived once per process."""
    declared = machine(name, effects(name))
    with _mistakes_reported(name, ", during the derivation with every effect"):
        model = models.extended(declared)
    if name in _added:
        with _mistakes_reported(name):
            check_names(declared, model)
    return model


@_derived_once
def drawing(name: str) -> tuple[Model, Drawing]:
    """Return the model of a mechanism's drawing, with every effect, and its description; derived once per process."""
    declared = machine(name, effects(name))
    with _mistakes_reported(name, ", during the derivation of its drawing"):
        return model_and_drawing(declared)


@_derived_once
def terms_beyond_catalogue(name: str) -> tuple[Model, tuple[DescribedTerm, ...]]:
    """Return the functions of a mechanism's terms beyond the catalogue, and the terms; derived once per process."""

    def with_effects(mounts: Sequence[Effect]) -> Machine:
        return machine(name, (*effects(name), *mounts))

    with _mistakes_reported(name, ", during the derivation of its terms"):
        return terms_model(machine(name), with_effects, [effect.name for effect in effects(name)])


@_derived_once
def single(name: str, effect_names: tuple[str, ...], zeros: Zeros) -> Model:
    """Return the model of a mechanism with some effects, by name, for one robot; derived once per process.

    `zeros` are the (field, index) of the robot's zero parameters: a coordinate without inertia has no mode.
    """
    return models.single(machine(name, _effects_by_name(name, effect_names), zeros), zeros)


@_derived_once
def held(name: str, effect_names: tuple[str, ...], zeros: Zeros, springs: str = "") -> HeldMotors:
    """Return a robot with some effects as it is in use, for one robot; derived once per process.

    `springs` is the effect through which its motors hang on springs; without one they are held.
    """
    declared = machine(name, _effects_by_name(name, effect_names), zeros)
    with _mistakes_reported(name, ", during the derivation with held motors"):
        return held_motors(declared, models.zero_symbols(declared, zeros), springs)


def _effects_by_name(name: str, effect_names: tuple[str, ...]) -> tuple[Effect, ...]:
    return tuple(effect for effect in effects(name) if effect.name in effect_names)


def description(name: str) -> Description:
    """Return what the runtime needs to know about a mechanism."""
    (_, picture), (_, terms) = drawing(name), terms_beyond_catalogue(name)
    return models.describe(machine(name, effects(name)), base(name).rigid_modes, picture, terms)
