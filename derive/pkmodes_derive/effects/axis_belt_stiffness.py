"""Axis belt stiffness: each belt has its own deviation from the declared specific stiffness."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Change the specific stiffness of belt j to k_sp (1 + a_j)."""
    for j, belt in enumerate(machine.belts, start=1):
        belt.change += parameters[f"factor_{j}"]


EFFECT = Effect(
    name="axis_belt_stiffness",
    sentence="the belts of the axes are not equally stiff",
    parts=lambda machine: machine.belts,
    parameters=(
        EffectParameter(
            "factor_{j}", "1", "relative change of the stiffness of belt {j}", "a_B_{j}", "a_{j}", -1.0
        ),
    ),
    apply=apply,
)
