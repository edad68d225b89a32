"""The functions of the extended model for dissipation."""

from pkmodes_derive.assembly.derived import (
    Derived,
    flattened,
    joint_losses,
    units_of_damping,
    units_of_stiffness,
)
from pkmodes_derive.functions import Function, Output


def dissipation(d: Derived) -> Function:
    """Return the function of the damping and the loss matrix in all coordinates."""
    n = len(d.machine.rates)
    return Function(
        "extended_dissipation",
        "Viscous damping matrix and loss matrix in the base and all released coordinates, with free joints.",
        "dissipation function R = 1/2 sum b v^2, C_v = d2R/dq_dot2; complex stiffnesses k (1 + i eta)",
        (d.pose,),
        (
            Output("C_v", (n, n), flattened(d.C_v), units_of_damping(d.machine), "viscous damping matrix"),
            Output(
                "K_loss",
                (n, n),
                flattened(d.K_loss),
                units_of_stiffness(d.machine),
                "imaginary part of the elastic stiffness; the springs of released joints add theirs",
            ),
        ),
        d.kin.definitions,
        in_c=False,
    )


def loss_of_joints(d: Derived) -> Function:
    """Return the function of the loss factors of released joints, whose stiffnesses are not in these matrices."""
    losses = joint_losses(d.machine)
    return Function(
        "joint_loss",
        "Loss factors of the springs of the released joints.",
        "complex stiffness k (1 + i eta) of each",
        (),
        (Output("eta", (len(losses),), losses, "1", "loss factor of each released coordinate, in order"),),
        {},
        in_c=False,
    )
