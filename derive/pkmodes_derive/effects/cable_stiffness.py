"""Cable stiffness: a hose or cable acts on the platform centre like an isotropic spring to ground."""

from collections.abc import Mapping, Sequence

from sympy import Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine
from pkmodes_derive.vectors import dot


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add a spring on the platform's absolute displacement, relaxed at the pose."""
    displacement = machine.delta_p
    machine.add_elastic(Rational(1, 2) * parameters["stiffness"] * dot(displacement, displacement))


EFFECT = Effect(
    name="cable_stiffness",
    sentence="a cable or hose ties the platform to ground",
    parts=lambda machine: machine.directions,
    parameters=(
        EffectParameter(
            "stiffness", "N/m", "isotropic stiffness from the platform centre to ground", "k_C", "k_C"
        ),
    ),
    apply=apply,
    grounds=True,
)
