"""Belt tension stiffness: cords straighten and teeth seat, so the stiffness of a belt increases with its tension."""

from collections.abc import Mapping, Sequence

from sympy import Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Positive
from pkmodes_derive.machine import Machine


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Multiply the specific stiffness of every belt by 1 + coefficient * tension."""
    for belt in machine.belts:
        belt.factor *= 1 + parameters["coefficient"] * parameters["tension"]


EFFECT = Effect(
    name="belt_tension_stiffness",
    sentence="the stiffness of the belts increases with their tension",
    parts=lambda machine: machine.belts,
    parameters=(
        EffectParameter(
            "coefficient", "1/N", "relative change of the belt stiffness with tension", "c_T", "c_T", None
        ),
        EffectParameter(
            "tension",
            "N",
            "measured tension of every belt",
            "F_T",
            "F_T",
            fitted=False,
        ),
    ),
    apply=apply,
    needs=Positive(
        lambda parameters: 1 + parameters["coefficient"] * parameters["tension"],
        "coefficient",
        "expected 1 + coefficient * tension above 0, found {value}: a belt without stiffness",
        "check coefficient and tension",
    ),
)
