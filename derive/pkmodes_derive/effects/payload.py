"""Payload: a point mass at the platform centre, with its weight."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.vectors import dot


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the kinetic energy and the weight."""
    mass = parameters["mass"]
    machine.add_kinetic(Rational(1, 2) * mass * dot(machine.v_p, machine.v_p))
    machine.add_weight(mass, machine.platform_position)


EFFECT = Effect(
    name="payload",
    sentence="the platform carries a mass that is not declared",
    parts=lambda machine: machine.directions,
    parameters=(EffectParameter("mass", "kg", "point mass at the platform centre", "m_L", "m_L"),),
    apply=apply,
)
