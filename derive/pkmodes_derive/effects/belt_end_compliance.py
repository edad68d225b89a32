"""Belt end compliance: tooth engagement and clamps, in series with every free span and independent of its length."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the compliance in series with every span: 1/k = l/(w k_sp (1 + a_j)) + c."""
    for belt in machine.belts:
        belt.compliance += parameters["compliance"]


EFFECT = Effect(
    name="belt_end_compliance",
    sentence="the teeth and clamps of the belts are compliant",
    parts=lambda machine: machine.belts,
    parameters=(
        EffectParameter("compliance", "m/N", "compliance in series with every free span", "c_E", "c_E"),
    ),
    apply=apply,
)
