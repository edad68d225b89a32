"""Link compliance: axial elongation of every linkage; its mass still follows its two ends."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Released
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Close the loop at the distance l_d + delta_j."""
    for link, coordinate in zip(machine.links, released, strict=True):
        link.elongation.append(coordinate)


EFFECT = Effect(
    name="link_compliance",
    sentence="the linkages stretch",
    parts=lambda machine: machine.links,
    parameters=(EffectParameter("compliance", "m/N", "axial compliance of every linkage", "c_L", "c_L"),),
    apply=apply,
    released=Released("delta_{j}", "m", "axial elongation of linkage {j}", r"\delta_{j}", order=2),
)
