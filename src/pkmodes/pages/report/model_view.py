"""The interactive view of a robot inside a report."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.core.robot.pose_table import poses_by_name
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.pages.report.measured_view import MAX_POSES, measured_scene, shown_robot
from pkmodes.pages.report.places import marked_elements
from pkmodes.pages.view import assets, fragment, poses_around, scene, typical_pose


def view_of(
    model: Model,
    poses: ArrayLike | None = None,
    *,
    start: ArrayLike | None = None,
    drives: str | None = None,
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
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Returns
    -------
    str or None
        None if no pose can be shown.
    """
    try:
        if poses is None:
            drawn_scene = poses_around(model, typical_pose(model) if start is None else start, drives=drives)
        else:
            points = np.asarray(poses_by_name(poses, model.mechanism), dtype=float)
            points = points[model.check(points).valid][:MAX_POSES]
            if not len(points):
                return None
            drawn_scene = scene(model, points, drives=drives)
    except PkmodesError:
        return None
    return fragment(drawn_scene) + assets()


def view_of_result(
    result: Diagnosis | Comparison, robot: Robot, data: Measurements | NDArray[np.float64]
) -> str | None:
    """Return the view of a measured robot at the measured poses, with the measured modes beside those of the model.

    The model is the one with which a diagnosis ends if its verdict is settled, otherwise the declared one; values
    that the measurements set at a pose are set.  The motors do what they did in most of the rows, and poses with
    other rows are left out.

    Parameters
    ----------
    result : Diagnosis or Comparison
        From ``pkmodes.loop.updating``.
    robot : Robot
        As declared.
    data : Measurements, or ndarray of shape (N, d)
        The measurements of the result, or only their poses, ``Measurements.points``: without measured modes.

    Returns
    -------
    str or None
        As for `view_of`.
    """
    if isinstance(result, Change) and result.by_state:
        return None  # poses of several states, of each of which the view is that of its own result
    robot_to_show = shown_robot(result, robot)
    drives = Counter(row.drives or FREE for row in result.rows).most_common(1)[0][0]
    if not isinstance(data, Measurements):
        return view_of(Model(robot_to_show.robot), data, drives=drives)
    try:
        drawn_scene = measured_scene(result, robot_to_show, data, drives)
    except PkmodesError:
        return None
    if drawn_scene is None:
        return None
    marks = marked_elements(result, robot) if isinstance(result, Diagnosis) else frozenset[int]()
    return fragment(replace(drawn_scene, marked=marks)) + assets()
