"""Payload: a point mass with its weight, at the centre of the platform or on another body that carries payloads."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import PointMass


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the body."""
    machine.loads.append(PointMass(parameters["mass"], machine.carries.position))


EFFECT = Effect(
    name="payload",
    sentence="{carrier} carries a mass that is not declared",
    parts=lambda machine: machine.directions,
    parameters=(EffectParameter("mass", "kg", "point mass {on_carrier}", "m_L", "m_L"),),
    apply=apply,
)
