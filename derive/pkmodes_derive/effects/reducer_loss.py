"""Reducer loss: material damping of elastic reducers and of gearboxes that wind up, k (1 + i eta)."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Give every reducer and every gearbox that may wind up the loss factor."""
    for reducer in machine.reducers:
        reducer.loss += parameters["loss_factor"]
    for drive in machine.drives:
        drive.loss += parameters["loss_factor"]


EFFECT = Effect(
    name="reducer_loss",
    sentence="the reducers dissipate",
    parts=lambda machine: [*machine.reducers, *(drive for drive in machine.drives if drive.winds_up)],
    parameters=(
        EffectParameter(
            "loss_factor",
            "1",
            "loss factor of every reducer, or gearbox that winds up",
            "eta_G",
            r"\eta_G",
            less_than=1.0,
        ),
    ),
    apply=apply,
    dissipates=True,
)
