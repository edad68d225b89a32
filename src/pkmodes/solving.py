"""Modes of one robot at some poses: matrices, eigenvalues and shapes, and what is asked for of them."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from pkmodes.eigen import condensed_eigh, natural_frequencies
from pkmodes.errors import PoseError
from pkmodes.evaluation import Evaluation
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta as generated

Array = NDArray[np.float64]
OF_MATRICES = frozenset({"mass_matrix", "stiffness_matrix"})
OF_MODES = frozenset({"frequencies", "shapes", "platform_shapes"})


def solved(evaluation: Evaluation, p: Array, source: str) -> tuple[Array, Array, Array, Array]:
    """Evaluate M, K, eigenvalues (N, m) and shapes (N, m, n) at poses (N, 3) that can be evaluated.

    Raises
    ------
    PoseError
        If the robot of this `source` has no inertia where there must be some, or magnitudes that overflow.
    """
    M, K = evaluation.matrices(p)
    try:
        eigenvalues, shapes = condensed_eigh(
            M,
            K,
            len(generated.COORDINATES),
            evaluation.rigid_modes,
            None if len(p) else evaluation.massless(),
        )
    except np.linalg.LinAlgError:
        raise PoseError(
            "the mass matrix is not positive definite",
            source,
            "give every body that moves a mass: platform or links, carriages, pulleys",
        ) from None
    if not np.isfinite(eigenvalues).all():
        raise PoseError("the eigenvalues are not finite", source, "check the robot's magnitudes")
    return M, K, eigenvalues, shapes


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
