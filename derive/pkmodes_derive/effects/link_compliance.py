"""Link compliance: axial elongation of every linkage; its mass still follows its two ends."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Released
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Link


def rigid_links(machine: Machine) -> list[Link]:
    """Return the links of fixed length; a leg that changes its length has a spring of its own."""
    return [link for link in machine.links if link.rigid]


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Close the loop at the distance l_d + delta_j."""
    for link, coordinate in zip(rigid_links(machine), released, strict=True):
        link.elongation.append(coordinate)


EFFECT = Effect(
    name="link_compliance",
    sentence="the linkages stretch",
    parts=rigid_links,
    parameters=(EffectParameter("compliance", "m/N", "axial compliance of every linkage", "c_L", "c_L"),),
    apply=apply,
    released=Released("delta_{j}", "m", "axial elongation of linkage {j}", r"\delta_{j}", order=2),
)
