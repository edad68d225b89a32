"""Belt loss: material damping of the belts, a complex stiffness k (1 + i eta) in every free span."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Give every span the loss factor; a compliance in series with it is lossless."""
    for belt in machine.belts:
        belt.loss += parameters["loss_factor"]


EFFECT = Effect(
    name="belt_loss",
    sentence="the belts dissipate",
    parts=lambda machine: machine.belts,
    parameters=(
        EffectParameter(
            "loss_factor", "1", "loss factor of every free span", "eta_B", r"\eta_B", less_than=1.0
        ),
    ),
    apply=apply,
    dissipates=True,
)
