"""Modes of one robot at some poses: matrices, eigenvalues and shapes, and what is asked for of them."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.eigen import condensed_eigh, natural_frequencies
from pkmodes.errors import PoseError
from pkmodes.evaluation import Evaluation
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta as generated

Array = NDArray[np.float64]
#: Eigenvalues come with an error of some 1e-16 of those of the belts: below this fraction of them, a frequency of
#: vibration has lost the nine digits that it should have.
RESOLVED = 1e-7
OF_MATRICES = frozenset({"mass_matrix", "stiffness_matrix"})
OF_MODES = frozenset({"frequencies", "shapes", "platform_shapes"})


class Solved(NamedTuple):
    """M, K (N, n, n), eigenvalues (N, m) and shapes (N, m, n) of N poses."""

    M: Array
    K: Array
    eigenvalues: Array
    shapes: Array


def solved(evaluation: Evaluation, p: Array, source: str) -> Solved:
    """Solve the eigenproblem at some poses.

    Parameters
    ----------
    evaluation : Evaluation
    p : ndarray, shape (N, 3)
        Platform centres that can be evaluated [m]; there may be none.
    source : str
        The robot, for messages.

    Raises
    ------
    PoseError
        If M is not positive definite, the eigenvalues are not finite, or a released joint is so soft that its
        frequency is lost in rounding.
    """
    first, rigid = len(generated.COORDINATES), evaluation.rigid_modes
    M, K = evaluation.matrices(p)
    massless = None if len(p) else evaluation.massless()
    try:
        eigenvalues, shapes = condensed_eigh(M, K, first, rigid, massless)
    except np.linalg.LinAlgError:
        raise PoseError(
            "the mass matrix is not positive definite",
            source,
            "give every body that moves a mass: platform or links, carriages, pulleys",
        ) from None
    if not np.isfinite(eigenvalues).all():
        raise PoseError("the eigenvalues are not finite", source, "check the robot's magnitudes")
    if rigid and M.shape[-1] > first:
        _check_resolved(eigenvalues, first, rigid, source)
    return Solved(M, K, eigenvalues, shapes)


def _check_resolved(eigenvalues: Array, first: int, rigid: int, source: str) -> None:
    """A robot that stands free has no vibration near zero, unless a joint hardly holds."""
    lost = np.abs(eigenvalues[:, rigid]) < RESOLVED * eigenvalues[:, first - 1]
    if lost.any():
        low, high = natural_frequencies(eigenvalues[int(np.argmax(lost)), [rigid, first - 1]])
        raise PoseError(
            f"a joint is so soft that its vibration, at {abs(low):.2g} Hz, is lost in rounding beside {high:.4g} Hz",
            source,
            "check the compliances under [effects]: a joint of smaller compliance holds",
        )


def fields_of_modes(
    robot: Robot, evaluation: Evaluation, p: Array, asked: Collection[str]
) -> dict[str, Array]:
    """Evaluate those fields of `pkmodes.Modes` that are asked for, at poses (N, 3) that can be evaluated.

    The route to a field is the same whatever else is asked for, and so are its digits.
    """
    found: dict[str, Array] = {}
    if OF_MODES & set(asked):
        M, K, eigenvalues, shapes = solved(evaluation, p, robot.source)
        found = {"mass_matrix": M, "stiffness_matrix": K, "shapes": shapes}
        found["frequencies"] = natural_frequencies(eigenvalues)
        if "platform_shapes" in asked:
            found["platform_shapes"] = shapes @ np.swapaxes(evaluation.platform_motion(p), -1, -2)
    elif OF_MATRICES & set(asked):
        found["mass_matrix"], found["stiffness_matrix"] = evaluation.matrices(p)
    if "carriage_positions" in asked:
        found["carriage_positions"] = generated.inverse_kinematics(p, robot.parameters)
    return {name: found[name] for name in asked}
