"""The back ends that evaluate modes, and which of them is used.

For held motors, each of them solves the system without the coordinates of the motors; shapes are given in all
coordinates.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import POSITIVE_INTEGER, alternatives, check_argument
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.compiled_solver import CompiledSolver
from pkmodes.core.solve.numpy_solver import NumpySolver
from pkmodes.core.solve.solver import SHAPES, Codes, SinglePoseFunction, Solver, UnavailableError
from pkmodes.core.system.evaluation import Evaluation
from pkmodes.core.system.motors import MotorsHeld

AUTO = "auto"
#: The back ends by name, as the user gives it.
SOLVERS: dict[str, type[Solver]] = {solver.name: solver for solver in (NumpySolver, CompiledSolver)}
#: What "auto" tries, in this order; the last one can always be used.
PREFERRED = (CompiledSolver.name, NumpySolver.name)
#: Environment variable with the back end to use where the caller names none.
BACKEND_VARIABLE = "PKMODES_BACKEND"
#: Fields in the coordinates with free motors, which the inner solver does not have.
FREE_MOTOR_FIELDS = frozenset({"mass_matrix", "stiffness_matrix", "platform_motion"})
NUMBER_WORDS = {3: "three", 4: "four", 5: "five"}


def choose_backend(backend: str) -> str:
    """Return the back end that the caller or the environment selects.

    - backend: a name of `SOLVERS`; with "auto", the environment variable ``PKMODES_BACKEND`` decides

    Raises PkmodesError if either is not the name of a back end.
    """
    name, where = backend, "backend"
    if isinstance(backend, str) and backend == AUTO:
        name, where = os.environ.get(BACKEND_VARIABLE, "") or AUTO, f"environment variable {BACKEND_VARIABLE}"
    choices = (AUTO, *SOLVERS)
    if not (isinstance(name, str) and name in choices):
        expected = alternatives(f'"{choice}"' for choice in choices)
        count = NUMBER_WORDS.get(len(choices), str(len(choices)))
        raise PkmodesError(f"expected {expected}, found {shown(name)}", where, f"choose one of the {count}")
    return name


def checked_threads(threads: int | None) -> int:
    """Check a number of threads; by default one for each core that this process may use.

    Raises PkmodesError if it is not a positive integer.
    """
    if threads is None:
        return available_cores()
    check_argument(threads, POSITIVE_INTEGER, "threads", "leave it out for all cores")
    return int(threads)


@cache
def available_cores() -> int:
    """Cores that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on this system
        return os.cpu_count() or 1


class HeldSolver(Solver):
    """Solves for held motors, by another solver of their system.

    - solver: of `system`
    - free: solver of the robot with free motors, for fields in its coordinates; None if NumPy evaluates these
    """

    takes_several_robots = False

    def __init__(self, solver: Solver, system: MotorsHeld, free: Solver | None = None) -> None:
        self._inner, self._system, self._free_solver = solver, system, free
        self.name = solver.name  # type: ignore[misc]
        self._free_fields = frozenset[str]() if free is None else FREE_MOTOR_FIELDS & free.fields
        self.fields = (solver.fields - FREE_MOTOR_FIELDS) | self._free_fields  # type: ignore[misc]
        self.checks_poses = solver.checks_poses  # type: ignore[misc]

    @property
    def inner(self) -> Solver:
        """The solver of the system without the coordinates of the motors."""
        return self._inner

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Not used: a solver is wrapped."""
        raise NotImplementedError

    def compute(
        self, state: RobotAtPoses, arrays: Mapping[str, NDArray[np.float64]], threads: int = 1
    ) -> Codes:
        """Fill arrays; `state` is the robot with free motors."""
        held_state = RobotAtPoses(self._system, state.points, state.source, {})
        inner_arrays = {name: array for name, array in arrays.items() if name not in self._free_fields}
        if SHAPES in arrays:
            inner_arrays[SHAPES] = np.empty((*arrays[SHAPES].shape[:-1], len(self._system.coordinates)))
        if self._free_solver is not None and len(inner_arrays) < len(arrays):
            codes = self._free_solver.compute(
                state, {name: arrays[name] for name in arrays if name not in inner_arrays}, threads
            )
            if not inner_arrays:
                return codes
        codes = self._inner.compute(held_state, inner_arrays, threads)
        if SHAPES in arrays:
            arrays[SHAPES][...] = self._system.to_free_motor_coordinates(inner_arrays[SHAPES])
        return codes

    def single_pose_function(self, pose_shapes: Mapping[str, tuple[int, ...]]) -> SinglePoseFunction | None:
        """Return what fills arrays at a single pose, if the inner solver has it."""
        inner_shapes = {name: shape for name, shape in pose_shapes.items() if name not in self._free_fields}
        if SHAPES in inner_shapes:
            inner_shapes[SHAPES] = (*inner_shapes[SHAPES][:-1], len(self._system.coordinates))
        evaluate_inner = self._inner.single_pose_function(inner_shapes)
        evaluate_free = None
        if self._free_solver is not None and len(inner_shapes) < len(pose_shapes):
            evaluate_free = self._free_solver.single_pose_function(
                {name: shape for name, shape in pose_shapes.items() if name not in inner_shapes}
            )
            if not inner_shapes or evaluate_free is None:
                return evaluate_free
        if evaluate_inner is None or (evaluate_free is None and SHAPES not in inner_shapes):
            return evaluate_inner
        system = self._system

        def evaluate_held(point: NDArray[np.float64]) -> dict[str, NDArray[np.float64]] | None:
            fields = evaluate_inner(point)
            if fields is None:
                return None
            if SHAPES in fields:
                fields[SHAPES] = system.to_free_motor_coordinates(fields[SHAPES])
            if evaluate_free is None:
                return fields
            free_fields = evaluate_free(point)
            return None if free_fields is None else {**fields, **free_fields}

        return evaluate_held


def solver_of(
    system: Evaluation, largest_condition: float, backend: str, free: Solver | None = None
) -> Solver:
    """Return the solver of a robot.

    - largest_condition: poses with a larger condition number are singular
    - backend: from `choose_backend`; with "auto", the first of `PREFERRED` that can be used
    - free: for held motors: see `HeldSolver`

    Raises UnavailableError if it cannot be used here.
    """
    if isinstance(system, MotorsHeld):
        return HeldSolver(_solver_of(system, largest_condition, backend), system, free)
    return _solver_of(system, largest_condition, backend)


def _solver_of(system: Evaluation, largest_condition: float, backend: str) -> Solver:
    if backend != AUTO:
        return SOLVERS[backend].init(system, largest_condition)
    for name in PREFERRED[:-1]:
        with suppress(UnavailableError):
            return SOLVERS[name].init(system, largest_condition)
    return SOLVERS[PREFERRED[-1]].init(system, largest_condition)
