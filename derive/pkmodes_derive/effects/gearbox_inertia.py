"""Gearbox inertia: extra inertia on every driven pulley."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Add the inertia to the driven pulley."""
    for drive in machine.drives:
        drive.inertia += parameters["inertia"]


EFFECT = Effect(
    name="gearbox_inertia",
    sentence="the gearboxes have inertia",
    parts=lambda machine: machine.drives,
    parameters=(
        EffectParameter(
            "inertia",
            "kg m^2",
            "extra inertia on every driven pulley",
            "I_G",
            "I_G",
            along_legs=("kg", "extra mass that every drive moves along its leg"),
        ),
    ),
    apply=apply,
)
