"""The solver for held motors: it solves the system without their coordinates, and gives shapes in all of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import SHAPES, Alone, Codes, Solver
from pkmodes.core.system.evaluation import Evaluation
from pkmodes.core.system.motors import MotorsHeld

#: Fields in the coordinates with free motors, which the inner solver does not know.
IN_ALL = frozenset({"mass_matrix", "stiffness_matrix"})


class HeldSolver(Solver):
    """Solves for held motors, by another solver of their system.

    Parameters
    ----------
    solver : Solver
        Of `system`.
    free : Solver, optional
        Of the robot with free motors, for the fields in its coordinates, if its digits are those of NumPy.
    """

    together = False

    def __init__(self, solver: Solver, system: MotorsHeld, free: Solver | None = None) -> None:
        self._inner, self._system, self._free = solver, system, free
        self.name = solver.name  # type: ignore[misc]
        self._of_free = frozenset[str]() if free is None else IN_ALL & free.fields
        self.fields = (solver.fields - IN_ALL) | self._of_free  # type: ignore[misc]
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
        """Fill arrays; `at` is the robot with free motors."""
        held = RobotAtPoses(self._system, at.points, at.source, {})
        own = {name: array for name, array in arrays.items() if name not in self._of_free}
        if SHAPES in arrays:
            own[SHAPES] = np.empty((*arrays[SHAPES].shape[:-1], len(self._system.coordinates)))
        if self._free is not None and len(own) < len(arrays):
            codes = self._free.compute(
                at, {name: arrays[name] for name in arrays if name not in own}, threads
            )
            if not own:
                return codes
        codes = self._inner.compute(held, own, threads)
        if SHAPES in arrays:
            arrays[SHAPES][...] = self._system.part_with_free_motors(own[SHAPES])
        return codes

    def alone(self, tails: Mapping[str, tuple[int, ...]]) -> Alone | None:
        """Return what fills arrays at a single pose, if the inner solver has such a thing."""
        if not self._of_free.isdisjoint(tails):
            return None
        if SHAPES not in tails:
            return self._inner.alone(tails)
        own = {**tails, SHAPES: (*tails[SHAPES][:-1], len(self._system.coordinates))}
        inner, system = self._inner.alone(own), self._system
        if inner is None:
            return None

        def of_held(point: NDArray[np.float64]) -> dict[str, NDArray[np.float64]] | None:
            found = inner(point)
            if found is not None:
                found[SHAPES] = system.part_with_free_motors(found[SHAPES])
            return found

        return of_held
