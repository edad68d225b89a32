"""Payload: a point mass with its weight, on the body that carries payloads.

It is at the centre of the platform, or elsewhere on one that turns.
"""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import PointMass
from pkmodes_derive.vectors import placed


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the body."""
    position = machine.carries.position
    if machine.turning is not None:
        names = machine.vector("o_L", "m", "payload from the platform's origin, base frame", "o_L")
        lever = machine.fixed_in_platform(names, [parameters[f"offset_{i}"] for i in machine.directions])
        position = tuple(a + b for a, b in zip(position, placed(machine.directions, lever), strict=True))
    machine.loads.append(PointMass(parameters["mass"], position))


EFFECT = Effect(
    name="payload",
    sentence="{carrier} carries a mass that is not declared",
    parts=lambda machine: machine.directions,
    parameters=(
        EffectParameter("mass", "kg", "point mass {on_carrier}", "m_L", "m_L"),
        EffectParameter(
            "offset_{i}",
            "m",
            "component {i} of the payload's place from the platform's origin, platform axes",
            "b_L_{i}",
            "b_{{L,{i}}}",
            greater_than=None,
            fitted=False,
            turning=True,
        ),
    ),
    apply=apply,
)
