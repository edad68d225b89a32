"""The solver for held motors: it solves the system without their coordinates, and gives shapes in all of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.solve.at_poses import RobotAtPoses
from pkmodes.solve.solver import SHAPES, Codes, Solver
from pkmodes.system.evaluation import Evaluation
from pkmodes.system.motors import MotorsHeld

#: Fields in the coordinates with free motors, which the inner solver does not know.
IN_ALL = frozenset({"mass_matrix", "stiffness_matrix"})


class HeldSolver(Solver):
    """Solves for held motors, by another solver of their system.

    Parameters
    ----------
    solver : Solver
        Of `system`.
    """

    together = False

    def __init__(self, solver: Solver, system: MotorsHeld) -> None:
        self._inner, self._system = solver, system
        self.name = solver.name  # type: ignore[misc]
        self.fields = solver.fields - IN_ALL  # type: ignore[misc]
        self.checks_poses = solver.checks_poses  # type: ignore[misc]

    @property
    def inner(self) -> Solver:
        """The solver of the system without the coordinates of the motors."""
        return self._inner

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Not used: a solver is wrapped."""
        raise NotImplementedError

    def compute(self, at: RobotAtPoses, arrays: Mapping[str, NDArray[np.float64]], threads: int = 1) -> Codes:
        """Fill arrays; the poses of `at` count, and not its system."""
        held = RobotAtPoses(self._system, at.points, at.source, {})
        own = dict(arrays)
        if SHAPES in arrays:
            own[SHAPES] = np.empty((*arrays[SHAPES].shape[:-1], len(self._system.coordinates)))
        codes = self._inner.compute(held, own, threads)
        if SHAPES in arrays:
            arrays[SHAPES][...] = self._system.part_with_free_motors(own[SHAPES])
        return codes
