"""Eigenvalues and shapes of a robot at poses that can be evaluated, from any back end."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.fields import FIELDS, sizes_of, tail
from pkmodes.core.solve.numpy_solver import NumpySolver, checked_modes
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, UNSOLVED, Solver
from pkmodes.core.system.evaluation import Evaluation, number_of_modes

Array = NDArray[np.float64]


def with_fields(solver: Solver, at: RobotAtPoses, *names: str) -> RobotAtPoses:
    """Return a robot at poses with what a solver has of some fields; NumPy evaluates the others when they are read.

    Parameters
    ----------
    solver : Solver
        Of its system.
    names : str
        Of `pkmodes.core.solve.fields.FIELDS`, none of which needs the eigenproblem.
    """
    sizes = sizes_of(at.system.mechanism, number_of_modes(at.system), len(at.system.coordinates))
    arrays = {
        name: np.empty((len(at.points), *tail(FIELDS[name], sizes)))
        for name in names
        if name in solver.fields
    }
    if arrays:
        solver.compute(at, arrays)
        at.known.update(arrays)
    return at


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
