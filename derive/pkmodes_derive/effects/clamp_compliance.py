"""Clamp compliance: the belt's clamp moves relative to its carriage; the clamp itself has no mass."""

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """End the two spans at the carriage at x_j + eps_j."""
    for j in range(3):
        machine.clamp[j].append(released[j])


EFFECT = Effect(
    name="clamp_compliance",
    sentence="the belts' clamps yield on their carriages",
    parameters=(EffectParameter("compliance", "m/N", "compliance of every belt clamp", "c_K", "c_K"),),
    apply=apply,
    coordinates=("eps_1", "eps_2", "eps_3"),
    coordinate_unit="m",
    coordinate_description="displacement of the belt clamp relative to carriage",
    order=3,
)
