"""The interactive view of a robot inside a report."""

from __future__ import annotations

import tomllib
from collections import Counter
from contextlib import suppress

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.drives import FREE
from pkmodes.base.errors import PkmodesError
from pkmodes.diagnosis.compare import Comparison
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.measured.pose_table import poses_by_name
from pkmodes.model.model import Model
from pkmodes.robot.reading import robot_from_document
from pkmodes.robot.robot import Robot
from pkmodes.updating.corrected_robot import corrected_robot
from pkmodes.view import assets, fragment, poses_around, scene, typical_pose

#: Poses of a measurement that are shown at most.
MOST = 60


def view_of(
    model: Model,
    poses: ArrayLike | None = None,
    *,
    start: ArrayLike | None = None,
    drives: str = FREE,
) -> str | None:
    """Return the view of a robot as HTML.

    Parameters
    ----------
    model : Model
        The robot.
    poses : array_like, shape (N, d), optional
        By default a grid over the workspace.
    start : array_like, shape (d,), optional
        The pose of the grid to show first, by default from `pkmodes.view.typical_pose`.
    drives : {"free", "held"}
        As for `pkmodes.Model.modes`.

    Returns
    -------
    str or None
        None if no pose can be shown.
    """
    try:
        if poses is None:
            shown = poses_around(model, typical_pose(model) if start is None else start, drives=drives)
        else:
            points = np.asarray(poses_by_name(poses, model.mechanism), dtype=float)
            points = points[model.check(points).valid][:MOST]
            if not len(points):
                return None
            shown = scene(model, points, drives=drives)
    except PkmodesError:
        return None
    return fragment(shown) + assets()


def view_of_result(result: Diagnosis | Comparison, robot: Robot, points: NDArray[np.float64]) -> str | None:
    """Return the view of a measured robot at the measured poses: with the cause, if one was found.

    The motors do what they did in most of the rows.

    Parameters
    ----------
    result : Diagnosis or Comparison
        From ``pkmodes.updating``.
    robot : Robot
        As declared.
    points : ndarray, shape (N, d)
        The measured poses, ``Measurements.points``.

    Returns
    -------
    str or None
        As for `view_of`.
    """
    if isinstance(result, Diagnosis) and result.effects:
        with suppress(PkmodesError):  # a cause that no robot file can hold
            robot = robot_from_document(tomllib.loads(corrected_robot(robot, result)), robot.source)
    drives = Counter(row.drives or FREE for row in result.rows).most_common(1)[0][0]
    return view_of(Model(robot), points, drives=drives)
