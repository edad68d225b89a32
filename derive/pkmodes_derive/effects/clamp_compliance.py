"""Clamp compliance: the belt clamp, itself massless, moves relative to its carriage."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Released
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Clamp


def clamps(machine: Machine) -> list[Clamp]:
    """Return the clamps of all belts."""
    return [belt.clamp for belt in machine.belts if belt.clamp is not None]


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """End the two spans at the carriage at x_j + eps_j."""
    for clamp, coordinate in zip(clamps(machine), released, strict=True):
        clamp.released.append(coordinate)


EFFECT = Effect(
    name="clamp_compliance",
    sentence="the belt clamps are compliant",
    parts=clamps,
    parameters=(EffectParameter("compliance", "m/N", "compliance of every belt clamp", "c_K", "c_K"),),
    apply=apply,
    released=Released(
        "eps_{j}",
        "m",
        "displacement of the clamp of belt {j} relative to the body it moves",
        r"\varepsilon_{j}",
        order=3,
    ),
)
