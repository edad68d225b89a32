"""Axis belt stiffness: the belts of the axes differ from the declared specific stiffness, each in its own way."""

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """Change the specific stiffness of axis j to k_sp (1 + a_j)."""
    for j in range(3):
        machine.stiffness_change[j] += parameters[f"factor_{j + 1}"]


EFFECT = Effect(
    name="axis_belt_stiffness",
    sentence="the belts of the three axes are not equally stiff",
    parameters=tuple(
        EffectParameter(
            f"factor_{j}",
            "1",
            f"relative change of the belt stiffness of axis {j}",
            f"a_B_{j}",
            f"a_{j}",
            -1.0,
        )
        for j in (1, 2, 3)
    ),
    apply=apply,
)
