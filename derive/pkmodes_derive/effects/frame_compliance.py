"""Frame compliance: the frame, with rails and bearings, translates on an isotropic spring or on one by direction."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Released
from pkmodes_derive.machine import Machine
from pkmodes_derive.vectors import dot


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Move every body except pulley rotation and belts with the frame, and add the frame's mass."""
    for coordinate in released:
        machine.frame[machine.directions.index(coordinate.place)].append(coordinate)
    rate = tuple(coordinate.rate for coordinate in released)
    machine.add_kinetic(Rational(1, 2) * parameters["mass"] * dot(rate, rate))


EFFECT = Effect(
    name="frame_compliance",
    sentence="the frame moves",
    parts=lambda machine: machine.directions,
    parameters=(
        EffectParameter("compliance", "m/N", "isotropic compliance of the frame", "c_F", "c_F"),
        EffectParameter("mass", "kg", "mass of the frame", "m_F", "m_F", fitted=False),
        EffectParameter(
            "compliance_{i}",
            "m/N",
            "compliance of the frame along {i}",
            "c_F_{i}",
            "c_{{F,{i}}}",
            in_place_of="compliance",
        ),
    ),
    apply=apply,
    released=Released("u_{i}", "m", "displacement of the frame along {i}", "u_{i}", order=4),
)
