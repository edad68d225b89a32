"""Eigenvalues and shapes of a robot at poses that can be evaluated, from any back end."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.numpy_solver import NumpySolver, checked_modes
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, UNSOLVED, Solver
from pkmodes.core.system.evaluation import Evaluation, number_of_modes

Array = NDArray[np.float64]


def solved(solver: Solver, system: Evaluation, p: Array, source: str) -> RobotAtPoses:
    """Return a robot at poses with its ``eigenvalues``, (N, m), and ``shapes``, (N, m, n): those of `Model.modes`.

    Parameters
    ----------
    solver : Solver
        Of the robot.
    p : ndarray, shape (N, d)
        Poses that can be evaluated; N may be 0.
    source : str
        The robot, for messages.

    Raises
    ------
    PoseError
        As `NumpySolver.compute` does.
    """
    at = RobotAtPoses(system, np.ascontiguousarray(p), source, {})
    if isinstance(solver, NumpySolver) or not len(p):  # the layout decides how products of shapes round
        at.known.update(zip((EIGENVALUES, SHAPES), checked_modes(at), strict=True))
        return at
    n, m = len(system.coordinates), number_of_modes(system)
    arrays = {EIGENVALUES: np.empty((len(p), m)), SHAPES: np.empty((len(p), m, n))}
    codes = solver.compute(at, arrays)
    left = np.flatnonzero(codes == UNSOLVED)
    if len(left):
        some = {name: array[left] for name, array in arrays.items()}
        NumpySolver.init(system, MAX_CONDITION).compute(RobotAtPoses(system, p[left], source, {}), some)
        for name, array in some.items():
            arrays[name][left] = array
    at.known.update(arrays)
    return at
