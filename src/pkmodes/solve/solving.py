"""Modes of one robot at given poses: matrices, eigenvalues and shapes, and the requested fields."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import PoseError
from pkmodes.linalg.eigen import condensed_eigh, natural_frequencies
from pkmodes.mechanism.generated import Generated
from pkmodes.robot.robot import Robot
from pkmodes.solve.results import CARRIAGES, JOINTS
from pkmodes.system.evaluation import Evaluation, matrices

Array = NDArray[np.float64]
#: Eigenvalues have an error of some 1e-16 of the largest.  Below this fraction of the largest, a vibration frequency
#: no longer has nine correct digits.
RESOLVED = 1e-7
OF_MATRICES = frozenset({"mass_matrix", "stiffness_matrix"})
OF_MODES = frozenset({"frequencies", "shapes", "platform_shapes"})
OF_JOINTS = frozenset({JOINTS, CARRIAGES})


class Solved(NamedTuple):
    """Matrices and modes of N poses.

    Attributes
    ----------
    M, K : ndarray, shape (N, n, n)
    eigenvalues, shapes : ndarray, shapes (N, m) and (N, m, n)
    every : tuple of ndarray, each (N, e, e)
        M and K including the coordinates of locked joints.
    """

    M: Array
    K: Array
    eigenvalues: Array
    shapes: Array
    every: tuple[Array, Array]


def solve(evaluation: Evaluation, p: Array) -> Solved:
    """Evaluate the matrices at some poses and solve the eigenproblem.

    Parameters
    ----------
    evaluation : Evaluation
    p : ndarray, shape (N, d)
        Valid poses; N may be 0.

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite.
    """
    every = evaluation.all_coordinates(p)
    M, K = (evaluation.free_part(matrix) for matrix in every)
    massless = None if len(p) else evaluation.massless()
    eigenvalues, shapes = condensed_eigh(M, K, evaluation.first, evaluation.rigid_modes, massless)
    return Solved(M, K, eigenvalues, shapes, every)


def solved(evaluation: Evaluation, p: Array, source: str) -> Solved:
    """Solve as `solve` does and reject unphysical systems; `source` names the robot in messages.

    Raises
    ------
    PoseError
        If M is not positive definite, the eigenvalues are not finite, or a released joint is so soft that its
        frequency is lost in rounding.
    """
    try:
        found = solve(evaluation, p)
    except np.linalg.LinAlgError:
        raise PoseError(
            "the mass matrix is not positive definite", source, "give every moving body a mass"
        ) from None
    if not np.isfinite(found.eigenvalues).all():
        raise PoseError("the eigenvalues are not finite", source, "check the robot's magnitudes")
    first, rigid = evaluation.first, evaluation.rigid_modes
    if rigid and found.M.shape[-1] > first:
        _check_resolved(found.eigenvalues, first, rigid, source)
    return found


def _check_resolved(eigenvalues: Array, first: int, rigid: int, source: str) -> None:
    """Reject a vibration near zero frequency: a robot with rigid-body modes has one only if a joint is too soft."""
    lost = np.abs(eigenvalues[:, rigid]) < RESOLVED * eigenvalues[:, first - 1]
    if lost.any():
        low, high = natural_frequencies(eigenvalues[int(np.argmax(lost)), [rigid, first - 1]])
        raise PoseError(
            f"a joint is so soft that its vibration at {abs(low):.2g} Hz is lost in rounding against {high:.4g} Hz",
            source,
            "check the compliances under [effects]: make the joint stiffer",
        )


def fields_of_modes(
    robot: Robot, evaluation: Evaluation, p: Array, asked: Collection[str]
) -> dict[str, Array]:
    """Evaluate the requested fields of `pkmodes.Modes` at valid poses (N, d).

    A field is computed in the same way whatever else is requested, so its digits do not change.
    """
    found: dict[str, Array] = {}
    if OF_MODES & set(asked):
        at = solved(evaluation, p, robot.source)
        found = {"mass_matrix": at.M, "stiffness_matrix": at.K, "shapes": at.shapes}
        found["frequencies"] = natural_frequencies(at.eigenvalues)
        if "platform_shapes" in asked:
            found["platform_shapes"] = at.shapes @ np.swapaxes(evaluation.platform_motion(p), -1, -2)
    elif OF_MATRICES & set(asked):
        found["mass_matrix"], found["stiffness_matrix"] = matrices(evaluation, p)
    if OF_JOINTS & set(asked):
        joints = Generated(robot.mechanism.model, robot.parameters).inverse_kinematics(p)
        found |= dict.fromkeys(OF_JOINTS, joints)
    return {name: found[name] for name in asked}
