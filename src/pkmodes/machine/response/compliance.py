"""How far the platform gives way to a force while the motors are held."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.drives import HELD
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.linalg import statics
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.support.solutions import with_fields

Array = NDArray[np.float64]


def compliance(model: Model, poses: ArrayLike, on_error: OnError = "raise") -> Array:
    """Compute how far the platform gives way to a force while the motors are held (docs/how-to/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        Poses in SI units.
    on_error : {"raise", "nan"}
        As for `modes`.

    Returns
    -------
    ndarray, shape (..., d, d)
        In m/N: displacement (rows) per force (columns), of the whole potential energy, gravity included.  Where the
        platform turns, its rotations [rad] and the moments on it [N m] about base axes follow.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml")
    >>> (1e6 * model.compliance([0.6, 0.0, -0.245])).diagonal().round(2)  # um/N
    array([2.98, 6.24, 3.51])
    """
    held_system = model.solved(HELD)
    if rigid_modes := held_system.rigid_modes:
        raise PkmodesError(
            f"with motors held the machine still has {rigid_modes} rigid modes: a force moves it without end",
            model.robot.source,
            "check the drives of the mechanism",
        )

    def at_points(points: Array) -> Array:
        robot_at_poses = RobotAtPoses(held_system, points, model.robot.source, {})
        with_fields(model.solver(AUTO, HELD).inner, robot_at_poses, "stiffness_matrix", "platform_motion")
        return statics.compliance(robot_at_poses["stiffness_matrix"], robot_at_poses["platform_motion"])

    (values,) = model.evaluated(at_points, model.checked(poses, on_error))
    return np.asarray(values)
