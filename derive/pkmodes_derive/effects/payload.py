"""Payload: a point mass at the platform centre, or elsewhere on a platform that turns, with its weight."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.vectors import cross, dot


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the kinetic energy and the weight."""
    mass, velocity, position = parameters["mass"], tuple(machine.v_p), machine.platform_position
    if machine.turning is not None:
        names = machine.vector("o_L", "m", "payload from the platform's origin, base frame", "o_L")
        lever = machine.fixed_in_platform(names, [parameters[f"offset_{i}"] for i in machine.directions])
        turned = cross(machine.turning.spatial(machine.turning.rates), (*lever, 0, 0)[:3])
        velocity = tuple(v + w for v, w in zip(velocity, turned, strict=False))
        position = tuple(p + o for p, o in zip(position, (*lever, 0, 0), strict=False))
    machine.add_kinetic(Rational(1, 2) * mass * dot(velocity, velocity))
    machine.add_weight(mass, position)


EFFECT = Effect(
    name="payload",
    sentence="{carrier} carries a mass that is not declared",
    parts=lambda machine: machine.directions,
    parameters=(
        EffectParameter("mass", "kg", "point mass at the platform centre", "m_L", "m_L"),
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
