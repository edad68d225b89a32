"""How far the platform gives way to a force while the motors are held."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.drives import HELD
from pkmodes.base.errors import PkmodesError
from pkmodes.linalg import statics
from pkmodes.mechanism.poses import OnError
from pkmodes.solve.dynamics import Dynamics
from pkmodes.system.evaluation import Evaluation, matrices
from pkmodes.system.motors import MotorsHeld

Array = NDArray[np.float64]


def compliance(dynamics: Dynamics, poses: ArrayLike, on_error: OnError = "raise") -> Array:
    """Compute the compliance of the platform: see `pkmodes.Model.compliance`."""
    held = dynamics.solved(HELD)
    if held.rigid_modes:
        raise PkmodesError(
            f"with motors held the machine still has {held.rigid_modes} rigid modes: a force moves it without end",
            dynamics.robot.source,
            "check the drives of the mechanism",
        )
    kinematics = dynamics.kinematics
    (found,) = kinematics.evaluated(
        lambda points: platform_compliance(dynamics.system, held, points), kinematics.checked(poses, on_error)
    )
    return np.asarray(found)


def platform_compliance(system: Evaluation, held: Evaluation, points: Array) -> Array:
    """Return the displacement of the platform per force [m/N] at N poses, (N, d, d).

    Parameters
    ----------
    system, held : Evaluation
        With free and with held motors.
    """
    _, K = matrices(held, points)
    moved = system.platform_motion(points)  # N, d, n
    if isinstance(held, MotorsHeld):
        moved = moved @ held.motions()[0]
    return statics.compliance(K, moved)
