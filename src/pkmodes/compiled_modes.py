"""Modes by the compiled evaluator; what it leaves, a stiff joint or an M that is not positive definite, by NumPy."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.compiled.evaluator import UNSOLVED, Evaluator
from pkmodes.eigen import has_stiff_joint
from pkmodes.evaluation import Evaluation
from pkmodes.gathering import Out, allotted
from pkmodes.poses import CHUNK, CheckedPoses, OnError, codes_of, given_poses, refuse
from pkmodes.results import CARRIAGES, JOINTS
from pkmodes.robot.robot import Robot
from pkmodes.solving import check_resolved, fields_of_modes

Array = NDArray[np.float64]
FREQUENCIES = "frequencies"


def compiled_modes(
    evaluator: Evaluator,
    robot: Robot,
    evaluation: Evaluation,
    poses: ArrayLike,
    on_error: OnError,
    asked: Sequence[str],
    out: Out,
    threads: int,
) -> tuple[CheckedPoses, dict[str, Array]]:
    """Evaluate fields of `pkmodes.Modes` at poses.

    Parameters
    ----------
    evaluator : Evaluator
    robot : Robot
    evaluation : Evaluation
        Of the robot.
    poses, on_error, out
        As for `pkmodes.Model.modes`.
    asked : sequence of str
        Fields.
    threads : int

    Returns
    -------
    CheckedPoses
        With what became of each pose.
    dict of str to ndarray, shape (..., *tail)
        By field; NaN where a pose cannot be evaluated.

    Raises
    ------
    PoseError, PkmodesError
        As `pkmodes.Model.modes` does.
    """
    kind = robot.kind
    points, batch = given_poses(poses, kind, on_error)
    points = np.ascontiguousarray(points)
    arrays, rows = allotted({name: _tail(name, robot, evaluator) for name in asked}, batch, out)
    if out and on_error == "raise":  # before anything of the caller's is overwritten
        refuse(points, evaluator.run(points, {}, threads), kind, robot.parameters)
    written = {JOINTS if name == CARRIAGES else name: array for name, array in rows.items()}
    released = evaluator.coordinates > evaluation.first
    solves = bool({FREQUENCIES, "shapes", "platform_shapes"} & written.keys())
    if (
        released and solves and FREQUENCIES not in written
    ):  # they tell whether a joint is too stiff for the solver
        written[FREQUENCIES] = np.empty((len(points), evaluator.modes))
    codes = evaluator.run(points, written, threads)
    left = codes == UNSOLVED
    if released and solves:
        eigenvalues = written[FREQUENCIES] * np.abs(written[FREQUENCIES]) * (2.0 * np.pi) ** 2
        left |= (codes == 0) & has_stiff_joint(eigenvalues, evaluation.first, evaluation.rigid_modes)
        if evaluation.rigid_modes and not left.all():
            check_resolved(
                eigenvalues[(codes == 0) & ~left], evaluation.first, evaluation.rigid_modes, robot.source
            )
    if left.any():
        places = np.flatnonzero(left)
        for start in range(0, len(places), CHUNK):
            some = places[start : start + CHUNK]
            for name, values in fields_of_modes(robot, evaluation, points[some], asked).items():
                rows[name][some] = values
        codes[places] = 0
    if on_error == "raise":
        refuse(points, codes, kind, robot.parameters)
    for name, array in arrays.items():
        if not np.may_share_memory(array, rows[name]):
            array[...] = rows[name].reshape(array.shape)
    return CheckedPoses(points, codes, batch, codes_of(kind)), arrays


def _tail(name: str, robot: Robot, evaluator: Evaluator) -> tuple[int, ...]:
    """Shape of a field at one pose."""
    m, n, kind = evaluator.modes, evaluator.coordinates, robot.kind
    return {
        FREQUENCIES: (m,),
        "shapes": (m, n),
        "platform_shapes": (m, len(kind.directions)),
        JOINTS: (len(kind.independent),),
        CARRIAGES: (len(kind.independent),),
        "mass_matrix": (n, n),
        "stiffness_matrix": (n, n),
    }[name]
