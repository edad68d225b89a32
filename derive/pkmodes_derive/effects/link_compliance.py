"""Link compliance: axial elongation of every linkage; its mass still follows its two ends."""

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """Close the loop at the distance l_d + delta_j."""
    for j in range(3):
        machine.elongation[j].append(released[j])


EFFECT = Effect(
    name="link_compliance",
    sentence="the linkages stretch",
    parameters=(EffectParameter("compliance", "m/N", "axial compliance of every linkage", "c_L", "c_L"),),
    apply=apply,
    coordinates=("delta_1", "delta_2", "delta_3"),
    coordinate_unit="m",
    coordinate_description="axial elongation of linkage",
    order=2,
)
