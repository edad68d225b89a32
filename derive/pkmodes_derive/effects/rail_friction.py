"""Rail friction: a viscous force on every body that slides along a rail."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add b v^2 / 2 for the velocity of each body along its rail."""
    for coordinate in machine.rails:
        rate = machine.velocities[machine.coordinates.index(coordinate)]
        machine.add_dissipation(Rational(1, 2) * parameters["viscous"] * rate**2)


EFFECT = Effect(
    name="rail_friction",
    sentence="the rails have viscous friction",
    parts=lambda machine: machine.rails,
    parameters=(
        EffectParameter("viscous", "N s/m", "viscous friction of every body along its rail", "b_R", "b_R"),
    ),
    apply=apply,
    dissipates=True,
)
