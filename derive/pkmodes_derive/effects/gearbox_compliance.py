"""Gearbox compliance: wind-up between the reflected motor inertia and the driven pulley."""

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """Turn the motor side by theta_driven + psi_j, on the output side of the gearbox."""
    for j in range(3):
        machine.wind_up[j].append(released[j])


EFFECT = Effect(
    name="gearbox_compliance",
    sentence="the gearboxes wind up",
    parameters=(
        EffectParameter("compliance", "rad/(N m)", "compliance of every gearbox, output side", "c_G", "c_G"),
    ),
    apply=apply,
    coordinates=("psi_1", "psi_2", "psi_3"),
    coordinate_unit="rad",
    coordinate_description="wind-up of the gearbox of axis",
    order=1,
)
