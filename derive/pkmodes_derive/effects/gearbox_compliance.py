"""Gearbox compliance: wind-up between the reflected motor inertia and the driven pulley."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Released
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Turn the motor side by theta_driven + psi_j, on the output side of the gearbox."""
    for drive, coordinate in zip(machine.drives, released, strict=True):
        drive.wind_up.append(coordinate)


EFFECT = Effect(
    name="gearbox_compliance",
    sentence="the gearboxes wind up",
    parts=lambda machine: [drive for drive in machine.drives if drive.winds_up],
    parameters=(
        EffectParameter("compliance", "rad/(N m)", "compliance of every gearbox, output side", "c_G", "c_G"),
    ),
    apply=apply,
    released=Released("psi_{j}", "rad", "wind-up of gearbox {j}", r"\psi_{j}", order=1),
)
