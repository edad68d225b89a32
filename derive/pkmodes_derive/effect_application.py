"""Apply effects to a machine: declare their parameters, release their coordinates, and let each change its parts."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect
from pkmodes_derive.machine import Machine
from pkmodes_derive.vocabulary import Field


def apply_effects(machine: Machine, effects: Sequence[Effect]) -> None:
    """Apply effects that all apply to the machine.

    Parameters
    ----------
    machine : Machine
        Declared, and changed here.
    """
    if not effects:
        return
    machine.delta_p = machine.of_platform(
        "delta_p", "m", "small displacement of the platform from the pose", r"(\Delta p)_{i}"
    )
    machine.effects = tuple(effect.in_words_of(machine).on(machine) for effect in effects)
    # Two passes: each effect sees every released coordinate, whatever the order of application.
    prepared = [
        (effect, _parameters(machine, effect), _release(machine, effect)) for effect in machine.effects
    ]
    for _, parameters, released in prepared:
        if released:
            machine.compliances += (parameters["compliance"],) * len(released)
    for effect, parameters, released in sorted(prepared, key=lambda item: not item[2]):
        effect.apply(machine, parameters, released)
        machine.elastic_of += [effect.name] * (len(machine.elastic) - len(machine.elastic_of))


def _parameters(machine: Machine, effect: Effect) -> dict[str, Symbol]:
    symbols = {}
    for p in effect.parameters:
        symbols[p.name] = machine.vocabulary.declare(p.symbol, p.unit, p.description, p.latex)
        name = f"{effect.name}_{p.name}"
        machine.effect_fields += (Field(name, (), (symbols[p.name],), p.unit, p.description),)
    return symbols


def _release(machine: Machine, effect: Effect) -> tuple[Coordinate, ...]:
    q, coordinates = effect.released, []
    if q is None:
        return ()
    declare = machine.vocabulary.declare
    for place in effect.places:
        index, latex = {q.letter: place}, q.latex
        stem = latex.removesuffix(f"_{{{q.letter}}}")
        rate = rf"\dot{{{{{stem}}}}}_{{{q.letter}}}"
        coordinates.append(
            Coordinate(
                declare(q.name, q.unit, q.description, latex, **index),
                declare(f"{q.name}_dot", f"{q.unit}/s", f"rate of change: {q.description}", rate, **index),
            )
        )
    machine.released += tuple(coordinates)
    return tuple(coordinates)
