"""Axis reducer stiffness: each reducer has its own deviation from the declared stiffness."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Change the stiffness of reducer j to k_r (1 + a_j)."""
    for j, reducer in enumerate(machine.reducers, start=1):
        reducer.change += parameters[f"factor_{j}"]


EFFECT = Effect(
    name="axis_reducer_stiffness",
    sentence="the reducers of the axes are not equally stiff",
    parts=lambda machine: machine.reducers,
    parameters=(
        EffectParameter(
            "factor_{j}",
            "1",
            "relative change of the stiffness of reducer {j}",
            "a_R_{j}",
            "a_{{R,{j}}}",
            -1.0,
        ),
    ),
    apply=apply,
)
