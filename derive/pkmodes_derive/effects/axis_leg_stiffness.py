"""Axis leg stiffness: each leg has its own deviation from the declared stiffness of its transmission."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Change the stiffness of leg j to k (1 + a_j)."""
    for j, spring in enumerate(machine.leg_springs, start=1):
        spring.change += parameters[f"factor_{j}"]


EFFECT = Effect(
    name="axis_leg_stiffness",
    sentence="the legs are not equally stiff",
    parts=lambda machine: machine.leg_springs,
    parameters=(
        EffectParameter(
            "factor_{j}",
            "1",
            "relative change of the stiffness of leg {j}",
            "a_S_{j}",
            "a_{{S,{j}}}",
            -1.0,
        ),
    ),
    apply=apply,
)
