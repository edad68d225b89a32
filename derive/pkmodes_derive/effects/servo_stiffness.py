"""Servo stiffness: a position loop, or a stepper motor, holds every motor to ground like a torsional spring."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add a spring on the motor of each drive, relaxed at the pose."""
    for drive in machine.drives:
        for rotor, selected in drive.rotors:
            angle = machine.rotation(rotor) + drive.wound
            machine.add_elastic(Rational(1, 2) * parameters["stiffness"] * selected * angle**2)


EFFECT = Effect(
    name="servo_stiffness",
    sentence="the position loops hold the motors",
    parts=lambda machine: machine.drives,
    parameters=(
        EffectParameter(
            "stiffness",
            "N m/rad",
            "torsional stiffness to ground at every motor, seen at the driven rotor",
            "k_S",
            "k_S",
            along_legs=("N/m", "stiffness to ground at every drive, along its leg"),
        ),
    ),
    apply=apply,
    grounds=True,
)
