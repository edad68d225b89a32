"""A batch of poses: checked, evaluated once by a solver, and by NumPy where the solver cannot.

A batch that is refused leaves the caller's arrays unchanged.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.mechanism.poses import (
    CHUNK,
    CheckedPoses,
    OnError,
    check_pose_array,
    pose_codes,
    raise_first_pose_error,
)
from pkmodes.core.robot.pose_table import poses_by_name
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.field_arrays import FieldArrays, OutArrays
from pkmodes.core.solve.solver import UNSOLVED, Codes, SinglePoseFunction

Array = NDArray[Any]
Rows = Mapping[str, Array]
#: Raises the error of the first bad pose, by the codes of all.
Refuse = Callable[[Codes], None]


@dataclass(frozen=True)
class Job:
    """What to evaluate at the poses of a robot.

    - pose_shapes: shape at one pose, and type, of each field
    - reasons: the reasons that codes index: `pkmodes.core.mechanism.poses.codes_of`
    - compute: fills the fields at poses, (n, d), with at most a number of threads, and returns the codes of the
      poses, `UNSOLVED` where `by_numpy` has to evaluate them
    - by_numpy: returns the fields at poses, (n, d), that can be evaluated
    - checks_poses: whether `compute` checks the poses; without fields it only checks them.  If not, it is given some
      thousand poses at a time that can be evaluated.
    - refusable: whether a pose may be refused after it was checked: then the caller's arrays are filled at the end
    - single_pose_function: evaluates the fields at a single pose with less overhead: see
      `pkmodes.core.solve.solver.Solver.single_pose_function`
    """

    pose_shapes: Mapping[str, tuple[tuple[int, ...], str]]
    reasons: tuple[str, ...]
    compute: Callable[[NDArray[np.float64], Rows, int], Codes]
    by_numpy: Callable[[NDArray[np.float64]], Rows]
    checks_poses: bool
    refusable: bool
    single_pose_function: SinglePoseFunction | None = None


def run_job(
    job: Job,
    robot: Robot,
    max_condition: float,
    poses: ArrayLike,
    on_error: OnError,
    out: OutArrays,
    threads: int = 1,
) -> tuple[CheckedPoses, dict[str, Array]]:
    """Evaluate a job.

    Returns, in this order:
    - the poses, with the code of each
    - arrays by field, each (..., *tail); NaN where a pose cannot be evaluated

    Raises PoseError or PkmodesError as `pkmodes.Model.modes` does.
    """
    mechanism = robot.mechanism
    points, batch = check_pose_array(poses_by_name(poses, mechanism), mechanism, on_error)
    if job.single_pose_function is not None and len(points) == 1 and not out:
        arrays = job.single_pose_function(points)
        if arrays is not None:
            return CheckedPoses(points, np.zeros(1, np.int8), batch, job.reasons), {
                name: array.reshape(batch + array.shape[1:]) for name, array in arrays.items()
            }
    points = np.ascontiguousarray(points)
    refuse_bad = None
    if on_error == "raise":
        refuse_bad = partial(raise_first_pose_error, points, mechanism=mechanism, parameters=robot.parameters)
    if job.checks_poses:
        codes, fields = _in_one_piece(job, points, batch, refuse_bad, out, threads)
    else:
        codes = pose_codes(points, mechanism, robot.parameters, max_condition)
        fields = _in_parts(job, CheckedPoses(points, codes, batch, job.reasons), refuse_bad, out, threads)
    unsolved = None
    if codes.any():
        unsolved = np.flatnonzero(codes == UNSOLVED)
        codes[unsolved] = 0
        if refuse_bad is not None:  # report a pose out of reach before a joint that is too soft
            refuse_bad(codes)
        for start in range(0, len(unsolved), CHUNK):
            indices = unsolved[start : start + CHUNK]
            fields.put(indices, job.by_numpy(points[indices]))
    return CheckedPoses(points, codes, batch, job.reasons, unsolved), fields.finish()


def _in_one_piece(
    job: Job, points: Array, batch: tuple[int, ...], refuse_bad: Refuse | None, out: OutArrays, threads: int
) -> tuple[Codes, FieldArrays]:
    """Evaluate all poses in one call, which also checks them.

    - refuse_bad: raises the error of the first bad pose by the codes; None if bad poses become NaN

    Where a bad pose is refused, the caller's arrays are filled after a call that only checks the poses, which takes
    less than a tenth of the time; or at the end, if a pose may still be refused then.
    """
    deferred = refuse_bad is not None and job.refusable and bool(out)
    if refuse_bad is not None and out and not deferred:
        refuse_bad(np.maximum(job.compute(points, {}, threads), 0))
    fields = FieldArrays(batch, out, deferred=deferred, pose_shapes=job.pose_shapes)
    return job.compute(points, fields.rows, threads), fields


def _in_parts(
    job: Job, checked: CheckedPoses, refuse_bad: Refuse | None, out: OutArrays, threads: int
) -> FieldArrays:
    """Evaluate the poses that can be evaluated, in parts that fit in the cache, and store their codes.

    - checked: the poses with codes by NumPy; a bad one is refused before anything is evaluated, or becomes NaN
    - refuse_bad: as for `_in_one_piece`
    """
    if refuse_bad is not None:
        refuse_bad(checked.codes)
    deferred = refuse_bad is not None and job.refusable and bool(out)
    fields = FieldArrays(
        checked.batch,
        out,
        deferred=deferred,
        filled_with_nan=bool(checked.codes.any()),
        pose_shapes=job.pose_shapes,
    )
    for indices, points in list(checked.parts(CHUNK)) if checked.valid.any() else ():
        rows = {name: array[indices] for name, array in fields.rows.items()}
        checked.codes[indices] = job.compute(points, rows, threads)
        if not isinstance(indices, slice):  # copies instead of views
            fields.put(indices, rows)
    return fields
