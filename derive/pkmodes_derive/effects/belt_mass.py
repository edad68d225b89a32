"""Belt mass: the displacement of a free span is linear between its ends; the wraps are neglected."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add rho l / 6 (a^2 + a b + b^2) for each span with end velocities a and b, relative to the frame.

    The weight of a closed loop does no work, so there is no potential energy.
    """
    for belt in machine.belts:
        for run in belt.runs:
            a, b = (machine.rate(*end) for end in run.ends)
            span_mass = parameters["linear_density"] * run.length
            machine.add_kinetic(Rational(1, 6) * span_mass * (a**2 + a * b + b**2))


EFFECT = Effect(
    name="belt_mass",
    sentence="the belts have mass",
    parts=lambda machine: machine.belts,
    parameters=(
        EffectParameter("linear_density", "kg/m", "mass of a belt per unit length", "rho_b", r"\rho_b"),
    ),
    apply=apply,
)
