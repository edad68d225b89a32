"""Apply effects to a machine: declare their parameters, release their coordinates, and let each change its parts."""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace

from sympy import Add, Symbol, oo

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.vocabulary import Field


def apply_effects(
    machine: Machine, effects: Sequence[Effect], zeros: Set[tuple[str, int]] = frozenset()
) -> None:
    """Apply effects that all apply to the machine.

    Parameters
    ----------
    machine : Machine
        Declared, and changed here.
    zeros : set of (field, index)
        Parameters that are zero for a robot: coordinates without any compliance stay locked.
    """
    if not effects:
        return
    machine.delta_p = machine.of_platform(
        "delta_p", "m", "small displacement of the platform from the pose", r"(\Delta p)_{i}"
    )
    machine.effects = tuple(_without_locked_coordinates(effect.on(machine), zeros) for effect in effects)
    # Two passes: each effect sees every released coordinate, whatever the order of application.
    applications = [
        (effect, _parameters(machine, effect), _release(machine, effect)) for effect in machine.effects
    ]
    for effect, parameters, released in applications:
        for coordinate in released:
            softening = (parameters[p.name] for p in effect.softening(coordinate.place))
            sprung = effect.released is not None and effect.released.sprung
            machine.compliances += (Add(*softening) if sprung else oo,)
    for effect, parameters, released in sorted(applications, key=lambda item: not item[2]):
        effect.apply(machine, parameters, released)
        machine.elastic_of += [effect.name] * (len(machine.elastic) - len(machine.elastic_of))


def _field_name(effect: Effect, parameter: EffectParameter) -> str:
    return f"{effect.name}_{parameter.name}"


def _without_locked_coordinates(effect: Effect, zeros: Set[tuple[str, int]]) -> Effect:
    """Return an effect with only those coordinates that some compliance frees."""

    def releasing_parameters(place: str) -> tuple[EffectParameter, ...]:
        return (
            effect.softening(place) or effect.parameters[:1]
        )  # without a spring of its own: the first makes it

    locked = [
        place
        for place in effect.places
        if all((_field_name(effect, p), 0) in zeros for p in releasing_parameters(place))
    ]
    return replace(effect, places=tuple(place for place in effect.places if place not in locked))


def _parameters(machine: Machine, effect: Effect) -> dict[str, Symbol]:
    symbols = {}
    for p in effect.parameters:
        symbols[p.name] = machine.vocabulary.declare(p.symbol, p.unit, p.description, p.latex)
        field = Field(_field_name(effect, p), (), (symbols[p.name],), p.unit, p.description)
        machine.effect_fields += (field,)
    return symbols


def _release(machine: Machine, effect: Effect) -> tuple[Coordinate, ...]:
    q, coordinates = effect.released, []
    if q is None:
        return ()
    declare = machine.vocabulary.declare
    for place in effect.places:
        index, latex = ({q.letter: place} if q.letter else {}), q.latex
        stem = latex.removesuffix(f"_{{{q.letter}}}")
        rate = rf"\dot{{{{{stem}}}}}_{{{q.letter}}}" if index else rf"\dot{{{stem}}}"
        coordinates.append(
            Coordinate(
                declare(q.name, q.unit, q.description, latex, **index),
                declare(f"{q.name}_dot", f"{q.unit}/s", f"rate of change: {q.description}", rate, **index),
                place,
            )
        )
    machine.released += tuple(coordinates)
    return tuple(coordinates)
