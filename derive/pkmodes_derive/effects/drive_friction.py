"""Drive friction: a viscous torque on every motor."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add b omega^2 / 2 for the speed of each motor, seen at the rotor that it drives."""
    for drive in machine.drives:
        for rotor, selected in drive.rotors:
            speed = machine.rotation_rate(rotor) + drive.wound_rate
            machine.add_dissipation(Rational(1, 2) * parameters["viscous"] * selected * speed**2)


EFFECT = Effect(
    name="drive_friction",
    sentence="the motors have viscous friction",
    parts=lambda machine: machine.drives,
    parameters=(
        EffectParameter(
            "viscous",
            "N m s/rad",
            "viscous friction of every motor, seen at the driven rotor",
            "b_D",
            "b_D",
            along_legs=("N s/m", "viscous friction of every drive, along its leg"),
        ),
    ),
    apply=apply,
    dissipates=True,
)
