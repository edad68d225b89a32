"""Servo stiffness: the position loop holds every driven pulley to ground like a torsional spring."""

from sympy import Rational

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """Add the spring on the driven pulley of each axis, relaxed at the pose."""
    for j in range(3):
        for selected, rotation in zip(machine.drive[j], machine.pulley_displacements(j), strict=True):
            machine.add_elastic(Rational(1, 2) * parameters["stiffness"] * selected * rotation**2)


EFFECT = Effect(
    name="servo_stiffness",
    sentence="the position loops hold the driven pulleys",
    parameters=(
        EffectParameter(
            "stiffness", "N m/rad", "torsional stiffness to ground at every driven pulley", "k_S", "k_S"
        ),
    ),
    apply=apply,
    grounds=True,
)
