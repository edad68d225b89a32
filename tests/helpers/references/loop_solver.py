"""A back end that is as simple as can be: SciPy's solver for one pose after the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

import numpy as np
import scipy.linalg

from pkmodes.core.linalg.eigen import TIE_TOLERANCE
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, Codes, Solver
from pkmodes.core.system.evaluation import Evaluation


class LoopSolver(Solver):
    """Solves K phi = lambda M phi with `scipy.linalg.eigh` after condensing the coordinates without inertia."""

    name = "loop"

    def __init__(self, massless: np.ndarray) -> None:
        self._q, self._r = np.flatnonzero(~massless), np.flatnonzero(massless)

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        return cls(system.massless)

    def compute(self, at: RobotAtPoses, arrays: Mapping[str, np.ndarray], threads: int = 1) -> Codes:
        q, r = self._q, self._r
        for i, (M, K) in enumerate(zip(at.mass_matrix, at.stiffness_matrix, strict=True)):
            follow = -np.linalg.solve(K[np.ix_(r, r)], K[np.ix_(r, q)])
            eigenvalues, shapes = scipy.linalg.eigh(
                K[np.ix_(q, q)] + K[np.ix_(q, r)] @ follow, M[np.ix_(q, q)]
            )
            if EIGENVALUES in arrays:
                arrays[EIGENVALUES][i] = eigenvalues
            if SHAPES in arrays:
                size = np.abs(shapes) * np.sqrt(np.diagonal(M)[q])[:, None]
                first = np.argmax(size >= (1.0 - TIE_TOLERANCE) * size.max(axis=0), axis=0)
                shapes *= np.sign(shapes[first, np.arange(len(q))])
                arrays[SHAPES][i][:, q], arrays[SHAPES][i][:, r] = shapes.T, (follow @ shapes).T
        return np.zeros(len(at.points), dtype=np.int8)
