"""Modes from the compiled evaluator, and from NumPy at poses that it cannot solve accurately."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.compiled.evaluator import UNSOLVED, Evaluator
from pkmodes.compiled.lanes import Terms
from pkmodes.linalg.eigen import has_stiff_joint
from pkmodes.mechanism.poses import CHUNK, CheckedPoses, OnError, codes_of, given_poses, refuse
from pkmodes.robot.robot import Robot
from pkmodes.solve.gathering import Out, allotted
from pkmodes.solve.results import CARRIAGES, JOINTS
from pkmodes.solve.solving import OF_MODES, Solved, fields_of_modes, solved
from pkmodes.system.evaluation import Evaluation

Array = NDArray[np.float64]
EIGENVALUES = "eigenvalues"
#: Very soft and very stiff released joints cost digits: NumPy solves where the lowest eigenvalue of vibration is
#: below this fraction, or the highest one above this multiple, of the highest one of the base coordinates.
SOFT, STIFF = 1e-5, 1e3


@dataclass(frozen=True)
class Job:
    """What to evaluate at poses.

    Attributes
    ----------
    tails : mapping of str to tuple of int
        Shape of each field at one pose.
    kernel : mapping of str to str
        The kernel's name of each field.
    evaluation : Evaluation
        Of the robot.
    by_eigenvalues : bool
        Whether `left` needs the eigenvalues.
    terms : Terms or None
        Paths along which to differentiate.
    left : callable
        From the codes and the fields of the kernel, the indices of the poses that NumPy has to solve or refuse.
    redone : callable
        Evaluates the fields at such poses, (n, d), with NumPy.
    """

    tails: Mapping[str, tuple[int, ...]]
    kernel: Mapping[str, str]
    evaluation: Evaluation
    by_eigenvalues: bool
    terms: Terms | None
    left: Callable[[NDArray[np.int8], Mapping[str, Array]], NDArray[np.intp]]
    redone: Callable[[Array], Mapping[str, Array]]


def evaluated(
    evaluator: Evaluator, robot: Robot, poses: ArrayLike, on_error: OnError, job: Job, out: Out, threads: int
) -> tuple[CheckedPoses, dict[str, Array]]:
    """Evaluate a job with the compiled evaluator, and with NumPy where it cannot.

    Returns
    -------
    CheckedPoses
        With the code of each pose.
    dict of str to ndarray, shape (..., *tail)
        By field; NaN where a pose cannot be evaluated.

    Raises
    ------
    PoseError, PkmodesError
        As `pkmodes.Model.modes` does.
    """
    mechanism = robot.mechanism
    points, batch = given_poses(poses, mechanism, on_error)
    points = np.ascontiguousarray(points)
    arrays, rows = allotted(job.tails, batch, out)
    size, known = (len(points), evaluator.modes), None
    if out and on_error == "raise":  # before the arrays of the caller are overwritten
        released = evaluator.coordinates > job.evaluation.first  # NumPy may refuse one of the joints
        first = {EIGENVALUES: np.empty(size)} if job.by_eigenvalues and released else {}
        codes = evaluator.run(points, first, threads)
        refuse(points, np.where(codes == UNSOLVED, 0, codes), mechanism, robot.parameters)
        if first:
            known = _redone(job, points[job.left(codes, first)])
    written = {job.kernel[name]: array for name, array in rows.items()}
    if job.by_eigenvalues:
        written[EIGENVALUES] = np.empty(size)
    codes = evaluator.run(points, written, threads, terms=job.terms)
    left = job.left(codes, written)
    if on_error == "raise" and codes.any():  # report a pose out of reach before a joint that is too soft
        refuse(points, np.where(codes == UNSOLVED, 0, codes), mechanism, robot.parameters)
    if len(left):
        for name, values in (_redone(job, points[left]) if known is None else known).items():
            rows[name][left] = values
        codes[left] = 0
    for name, array in arrays.items():
        if not np.may_share_memory(array, rows[name]):
            array[...] = rows[name].reshape(array.shape)
    return CheckedPoses(points, codes, batch, codes_of(mechanism)), arrays


def _redone(job: Job, points: Array) -> dict[str, Array]:
    """Evaluate poses with NumPy, part by part."""
    parts = [job.redone(points[start : start + CHUNK]) for start in range(0, len(points), CHUNK)]
    return {name: np.concatenate([part[name] for part in parts]) for name in (parts[0] if parts else ())}


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
        With the code of each pose.
    dict of str to ndarray, shape (..., *tail)
        By field; NaN where a pose cannot be evaluated.

    Raises
    ------
    PoseError, PkmodesError
        As `pkmodes.Model.modes` does.
    """
    job = Job(
        tails={name: _tail(name, robot, evaluator) for name in asked},
        kernel={name: JOINTS if name == CARRIAGES else name for name in asked},
        evaluation=evaluation,
        # They show joints that are too stiff or too soft for the kernel.
        by_eigenvalues=evaluator.coordinates > evaluation.first and bool(OF_MODES & set(asked)),
        terms=None,
        left=lambda codes, written: left_to_numpy(evaluation, codes, written.get(EIGENVALUES)),
        redone=lambda points: fields_of_modes(robot, evaluation, points, asked),
    )
    return evaluated(evaluator, robot, poses, on_error, job, out, threads)


def compiled_solution(evaluator: Evaluator, evaluation: Evaluation, p: Array, source: str) -> Solved:
    """Evaluate the matrices with NumPy and take the modes from the compiled evaluator: those of `compiled_modes`.

    Parameters
    ----------
    evaluator : Evaluator
    evaluation : Evaluation
        Of the same robot.
    p : ndarray, shape (N, d)
        Poses that can be evaluated.
    source : str
        The robot, for messages.

    Raises
    ------
    PoseError
        As `pkmodes.solve.solving.solved` does.
    """
    n, m = evaluator.coordinates, evaluator.modes
    eigenvalues, shapes = np.empty((len(p), m)), np.empty((len(p), m, n))
    codes = evaluator.run(np.ascontiguousarray(p), {EIGENVALUES: eigenvalues, "shapes": shapes})
    left = left_to_numpy(evaluation, codes, eigenvalues)
    every = evaluation.all_coordinates(p)
    M, K = (evaluation.free_part(matrix) for matrix in every)
    if len(left):
        found = solved(evaluation, p[left], source)
        eigenvalues[left], shapes[left] = found.eigenvalues, found.shapes
    return Solved(M, K, eigenvalues, shapes, every)


def left_to_numpy(
    evaluation: Evaluation, codes: NDArray[np.int8], eigenvalues: Array | None
) -> NDArray[np.intp]:
    """Return the poses that NumPy has to solve or refuse.

    Parameters
    ----------
    evaluation : Evaluation
    codes : ndarray of int8, shape (N,)
        From the compiled evaluator.
    eigenvalues : ndarray, shape (N, m), optional
        Needed where joints may be too stiff or too soft.

    Returns
    -------
    ndarray of int
    """
    left = codes == UNSOLVED
    first, rigid = evaluation.first, evaluation.rigid_modes
    if eigenvalues is not None and len(evaluation.coordinates) > first:
        last = np.abs(eigenvalues[:, first - 1])
        soft, stiff = np.abs(eigenvalues[:, rigid]) < SOFT * last, eigenvalues[:, -1] > STIFF * last
        left |= (codes == 0) & (has_stiff_joint(eigenvalues, first, rigid) | soft | stiff)
    return np.flatnonzero(left)


def _tail(name: str, robot: Robot, evaluator: Evaluator) -> tuple[int, ...]:
    """Return the shape of a field at one pose."""
    m, n, mechanism = evaluator.modes, evaluator.coordinates, robot.mechanism
    return {
        "frequencies": (m,),
        "shapes": (m, n),
        "platform_shapes": (m, len(mechanism.directions)),
        JOINTS: (len(mechanism.independent),),
        CARRIAGES: (len(mechanism.independent),),
        "mass_matrix": (n, n),
        "stiffness_matrix": (n, n),
    }[name]
