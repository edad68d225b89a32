"""Servo stiffness: the position loop holds every driven pulley to ground like a torsional spring."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add a spring on the driven pulley of each axis, relaxed at the pose."""
    for drive in machine.drives:
        for rotor, selected in drive.rotors:
            energy = Rational(1, 2) * parameters["stiffness"] * selected * machine.rotation(rotor) ** 2
            machine.add_elastic(energy)


EFFECT = Effect(
    name="servo_stiffness",
    sentence="the position loops hold the driven pulleys",
    parts=lambda machine: machine.drives,
    parameters=(
        EffectParameter(
            "stiffness", "N m/rad", "torsional stiffness to ground at every driven pulley", "k_S", "k_S"
        ),
    ),
    apply=apply,
    grounds=True,
)
