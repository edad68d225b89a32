"""How far the platform gives way to a force while the motors are held."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.drives import HELD
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.linalg import statics
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.system.motors import MotorsHeld

Array = NDArray[np.float64]


def compliance(model: Model, poses: ArrayLike, on_error: OnError = "raise") -> Array:
    """Compute how far the platform gives way to a force while the motors are held (docs/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        In SI units.
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
    held = model.solved(HELD)
    if held.rigid_modes:
        raise PkmodesError(
            f"with motors held the machine still has {held.rigid_modes} rigid modes: a force moves it without end",
            model.robot.source,
            "check the drives of the mechanism",
        )
    (found,) = model.evaluated(partial(_at_points, model), model.checked(poses, on_error))
    return np.asarray(found)


def _at_points(model: Model, points: Array) -> Array:
    """Return the displacement of the platform per force [m/N] at N poses, (N, components, components)."""
    held, solver = model.solved(HELD), model.solver(AUTO, HELD).inner
    at = RobotAtPoses(held, points, model.robot.source, {})
    if solver.fields.issuperset(("stiffness_matrix", "platform_motion")):
        n, components = len(held.coordinates), len(model.mechanism.platform)
        found = {
            "stiffness_matrix": np.empty((len(points), n, n)),
            "platform_motion": np.empty((len(points), components, n)),
        }
        solver.compute(at, found)
        return statics.compliance(found["stiffness_matrix"], found["platform_motion"])
    moved = model.system.platform_motion(points)
    if isinstance(held, MotorsHeld):
        moved = moved @ held.motions()[0]
    return statics.compliance(at.stiffness_matrix, moved)
