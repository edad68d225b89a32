"""Eigenvalues and shapes of a robot at poses that can be evaluated, from any back end."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import FULL_MATRIX_FIELDS, flattened, no_paths
from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.fields import FIELDS, axis_lengths, pose_shape
from pkmodes.core.solve.numpy_solver import NumpySolver, checked_modes
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, UNSOLVED, Solver
from pkmodes.core.system.evaluation import Evaluation, ExtendedSystem, number_of_modes

Array = NDArray[np.float64]


def with_fields(solver: Solver, state: RobotAtPoses, *names: str) -> RobotAtPoses:
    """Return a robot at poses with what a solver has of some fields; NumPy evaluates the others when they are read.

    - solver: of its system
    - names: of `pkmodes.core.solve.fields.FIELDS`, none of which needs the eigenproblem
    """
    arrays = _arrays(solver, state.system, len(state.points), names)
    if arrays:
        solver.compute(state, arrays)
        state.quantities.update(arrays)
    return state


def with_all_coordinates(solver: Solver, state: RobotAtPoses) -> RobotAtPoses:
    """Return a robot at poses with M and K in all coordinates, from one call of a compiled solver if it is one.

    - solver: of its system
    """
    system = state.system
    if isinstance(system, ExtendedSystem) and len(state.points):
        matrices = solver.along(state, None, no_paths(flattened(system.effects)), FULL_MATRIX_FIELDS)
        if matrices is not None:
            M, K = (matrices[name] for name in FULL_MATRIX_FIELDS)
            state.quantities["all_coordinates"] = system.from_generated_matrices(M, K)
    return state


def _arrays(solver: Solver, system: Evaluation, count: int, names: Sequence[str]) -> dict[str, Array]:
    """Return arrays for those fields that a solver fills."""
    sizes = axis_lengths(system.mechanism, number_of_modes(system), len(system.coordinates))
    return {
        name: np.empty((count, *pose_shape(FIELDS[name], sizes))) for name in names if name in solver.fields
    }


def solve_modes(
    solver: Solver, system: Evaluation, p: Array, source: str, *further_fields: str
) -> RobotAtPoses:
    """Return a robot at poses with its ``eigenvalues``, (N, m), and ``shapes``, (N, m, n): those of `Model.modes`.

    Where a compiled solver solves, it evaluates other fields in the same call.

    - solver: of the robot
    - p: poses that can be evaluated, (N, d); N may be 0
    - source: the robot, for messages
    - further_fields: further fields that will be read, of `pkmodes.core.solve.fields.FIELDS`

    Raises PoseError as `NumpySolver.compute` does.
    """
    state = RobotAtPoses(system, np.ascontiguousarray(p), source, {})
    if isinstance(solver, NumpySolver) or not len(p):  # the layout decides how products of shapes round
        state.quantities.update(zip((EIGENVALUES, SHAPES), checked_modes(state), strict=True))
        return state
    arrays = {EIGENVALUES: np.empty((len(p), number_of_modes(system)))}
    arrays |= _arrays(solver, system, len(p), (SHAPES, *further_fields))
    codes = solver.compute(state, arrays)
    unsolved = np.flatnonzero(codes == UNSOLVED)
    if len(unsolved):
        arrays = {name: arrays[name] for name in (EIGENVALUES, SHAPES)}
        solutions = {name: array[unsolved] for name, array in arrays.items()}
        NumpySolver.init(system, MAX_CONDITION).compute(
            RobotAtPoses(system, p[unsolved], source, {}), solutions
        )
        for name, array in solutions.items():
            arrays[name][unsolved] = array
    state.quantities.update(arrays)
    return state
