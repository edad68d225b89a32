"""Matrices, eigenvalues and shapes from NumPy, without the checks of a solver."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.numpy_solver import modes_of
from pkmodes.core.system.evaluation import Evaluation


class Solution(NamedTuple):
    """Of N poses: matrices (N, n, n), eigenvalues (N, m), shapes (N, m, n)."""

    M: np.ndarray
    K: np.ndarray
    eigenvalues: np.ndarray
    shapes: np.ndarray


def solve(evaluation: Evaluation, p: np.ndarray) -> Solution:
    at = RobotAtPoses(evaluation, p, "a test", {})
    return Solution(at.mass_matrix, at.stiffness_matrix, *modes_of(at))
