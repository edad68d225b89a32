"""Fields of one robot at poses: those that its solver fills, and those that follow from them.

What a call for modes does is worked out once for a model: which fields it computes, and which are evaluated when they
are read.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import HELD
from pkmodes.core.mechanism.poses import CHUNK, CheckedPoses, codes_of
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.backends import solver_of
from pkmodes.core.solve.batch import Job, Rows, run_job
from pkmodes.core.solve.fields import DISSIPATION, FIELDS, MODE, axis_lengths, missing_value
from pkmodes.core.solve.fields import pose_shape as tail_of
from pkmodes.core.solve.numpy_solver import NumpySolver
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, Codes, SinglePoseFunction, Solver
from pkmodes.core.system.evaluation import Evaluation, may_be_refused, number_of_modes
from pkmodes.core.system.motors import MotorsHeld, springs_on_motors
from pkmodes.core.system.strain_free import StrainFreeMotions

Array = NDArray[np.float64]
#: Poses for each thread for which intermediate quantities are kept.
POSES_PER_THREAD = 4800


class ModeFields:
    """How a solver and NumPy evaluate some fields of a robot: worked out once, for any number of calls.

    A field that is the same for any robot, such as damping where nothing dissipates, is filled instead of computed.

    - solved: the system that the solver solves: that of the robot, or the one with held motors
    - source: the robot, for messages
    - names: of `pkmodes.core.solve.fields.FIELDS`
    - quantities: quantities that fields need and a robot does not have, such as the normal of a plane

    Its attributes:
    - job: evaluates the fields
    """

    def __init__(
        self,
        solver: Solver,
        system: Evaluation,
        solved: Evaluation,
        source: str,
        names: Iterable[str],
        quantities: Mapping[str, Any],
    ) -> None:
        self._solver, self._system, self._solved = solver, system, solved
        self._source, self._quantities = source, {**_motor_quantities(system, solved), **quantities}
        self._names = tuple(names)
        self._filled = [name for name in self._names if not self._depends_on_robot(name)]
        self._computed = computed = [name for name in self._names if name not in self._filled]
        self._derived = [name for name in computed if name not in solver.fields]
        self._needed = _needed(self._derived, solver.fields) - {*self._names}
        if _of_modes(self._filled) and not _of_modes(computed):
            self._needed |= {EIGENVALUES}  # they decide whether the robot is refused
        modes = number_of_modes(solved)
        sizes = axis_lengths(system.mechanism, modes, len(system.coordinates))
        fields = {name: FIELDS[name] for name in (*self._names, *self._needed) if name in FIELDS}
        self._pose_shapes = {name: (tail_of(field, sizes), field.dtype) for name, field in fields.items()}
        self._pose_shapes[EIGENVALUES] = (modes,), "f8"
        self.job = Job(
            pose_shapes={name: self._pose_shapes[name] for name in self._names},
            reasons=codes_of(system.mechanism),
            compute=self.compute,
            by_numpy=self.by_numpy,
            checks_poses=solver.checks_poses,
            refusable=_of_modes(self._names) and may_be_refused(solved),
            single_pose_function=self._single_pose_function(),
        )

    def _depends_on_robot(self, name: str) -> bool:
        """Return whether a field depends on this robot."""
        field = FIELDS.get(name)
        if field is None:
            return True
        if field.only == DISSIPATION:
            return bool(self._quantities["dissipation"])
        return field.only != HELD or self._quantities["strain_free_motions"] is not None

    def _single_pose_function(self) -> SinglePoseFunction | None:
        """Return what evaluates the fields at a single pose with less overhead; None if nothing does."""
        solver_fields = [*(name for name in self._computed if name not in self._derived), *self._needed]
        if self._filled or not (solver_fields or self._solver.checks_poses):
            return None
        evaluate_solver = self._solver.single_pose_function(
            {name: self._pose_shapes[name][0] for name in solver_fields}
        )
        if evaluate_solver is None or not self._derived:
            return evaluate_solver

        def evaluate(point: Array) -> dict[str, Array] | None:
            fields = evaluate_solver(point)
            if fields is None:
                return None
            state = RobotAtPoses(self._system, point, self._source, {**self._quantities, **fields})
            return {name: state[name] for name in self._names}

        return evaluate

    def pose_shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of a field at one pose."""
        return self._pose_shapes[name][0]

    def evaluate_again(
        self, robot: Robot, max_condition: float, checked: CheckedPoses, threads: int
    ) -> dict[str, NDArray[Any]]:
        """Evaluate the fields, (N, *tail), at poses of an earlier evaluation: see `batch.run_job`."""
        if not self._computed:
            if len(checked.codes) == 1 and not checked.codes[0]:
                return {name: values.copy() for name, values in self._filled_at_a_pose.items()}
            return self._filled_at(checked.codes)
        has_unsolved = checked.unsolved is not None and len(checked.unsolved) > 0
        if (
            self.job.single_pose_function is not None
            and len(checked.points) == 1
            and not (checked.codes[0] or has_unsolved)
        ):
            arrays = self.job.single_pose_function(checked.points)
            if arrays is not None:
                return arrays
        _, rows = run_job(self.job, robot, max_condition, checked.points, "nan", None, threads)
        if checked.unsolved is not None and has_unsolved:
            for name, values in self.by_numpy(checked.points[checked.unsolved]).items():
                rows[name][checked.unsolved] = values
        return rows

    def compute(self, points: Array, rows: Rows, threads: int) -> Codes:
        """Fill the fields at poses, all or none of them, and return the codes."""
        if not rows or not self._needed:
            return self._part(points, rows, threads)
        codes = np.empty(len(points), dtype=np.int8)
        for start in range(0, len(points), POSES_PER_THREAD * threads):
            part = slice(start, start + POSES_PER_THREAD * threads)
            codes[part] = self._part(
                points[part], {name: array[part] for name, array in rows.items()}, threads
            )
        return codes

    def by_numpy(self, points: Array) -> Rows:
        """Return the fields at poses, solved by NumPy."""
        rows = {name: _empty(len(points), *self._pose_shapes[name]) for name in self._names}
        self._by_numpy.compute(points, rows, 1)
        return rows

    @cached_property
    def _by_numpy(self) -> ModeFields:
        if self._solver.name == NumpySolver.name:
            return self
        solver = solver_of(self._solved, np.inf, NumpySolver.name)
        return ModeFields(solver, self._system, self._solved, self._source, self._names, self._quantities)

    def _part(self, points: Array, rows: Rows, threads: int) -> Codes:
        state = RobotAtPoses(self._system, points, self._source, self._quantities)
        filled = {name: array for name, array in rows.items() if name in self._solver.fields}
        if rows:
            for name in self._needed:
                filled[name] = _empty(len(points), *self._pose_shapes[name])
        if filled or self._solver.checks_poses:
            codes = self._solver.compute(state, filled, threads)
        else:
            codes = np.zeros(len(points), dtype=np.int8)
        if rows and self._derived:
            self._derive(state, filled, rows, codes)
        if rows:
            for name in self._filled:
                self._fill(name, rows[name], codes)
        return codes

    @cached_property
    def _filled_at_a_pose(self) -> dict[str, NDArray[Any]]:
        return self._filled_at(np.zeros(1, np.int8))

    def _filled_at(self, codes: Codes) -> dict[str, NDArray[Any]]:
        """Return the fields that do not depend on the robot, (N, *tail)."""
        rows: dict[str, NDArray[Any]] = {
            name: _empty(len(codes), *self._pose_shapes[name]) for name in self._filled
        }
        for name, array in rows.items():
            self._fill(name, array, codes)
        return rows

    def _fill(self, name: str, array: Array, codes: Codes) -> None:
        """Fill a field that does not depend on the robot; NaN where there is none."""
        array[...] = FIELDS[name].fallback
        if FIELDS[name].dims[:1] == (MODE,):
            array[:, : self._solved.rigid_modes] = np.nan
        if codes.any():
            array[codes != 0] = np.nan

    def _derive(self, state: RobotAtPoses, filled: Rows, rows: Rows, codes: Codes) -> None:
        """Fill the fields that follow from those of the solver; NaN where there are none."""
        if not codes.any() and len(codes) <= CHUNK:  # `state` may have matrices already
            state.quantities.update(filled)
            for name in self._derived:
                rows[name][...] = state[name]
            return
        for name in self._derived:
            rows[name][codes != 0] = missing_value(rows[name].dtype)
        valid = np.flatnonzero(codes == 0)
        for start in range(0, len(valid), CHUNK):
            chunk = valid[start : start + CHUNK]
            quantities = {**self._quantities, **{name: array[chunk] for name, array in filled.items()}}
            part = RobotAtPoses(self._system, state.points[chunk], self._source, quantities)
            for name in self._derived:
                rows[name][chunk] = part[name]


@dataclass(frozen=True, eq=False)
class FieldPlan:
    """What a call for some fields does, for given drives and one back end.

    - fields: those that are computed at once
    - shared: those that share the array of another one, by name
    - deferred: those that are evaluated when they are read, one by one
    - deferred_pairs: the same at a few poses, where fields that are usually read together are evaluated together
    - backend: of the result
    """

    fields: ModeFields
    shared: Mapping[str, str]
    deferred: Mapping[str, ModeFields]
    deferred_pairs: Mapping[str, ModeFields]
    rigid_modes: int
    backend: str


class DeferredFields:
    """The fields of a result that are evaluated when they are read; their values are those of an evaluation at once.

    - plan: of the result
    - max_condition: as for the result
    - checked: the poses of the result.  They are copied: the caller may change what the result shows.
    - threads: as for the result
    """

    __slots__ = ("_checked", "_evaluated", "_fields", "_max_condition", "_robot", "_threads")

    def __init__(
        self,
        plan: FieldPlan,
        robot: Robot,
        max_condition: float,
        checked: CheckedPoses,
        threads: int,
    ) -> None:
        self._fields = plan.deferred_pairs if len(checked.points) <= CHUNK else plan.deferred
        self._robot, self._max_condition, self._threads = robot, max_condition, threads
        self._evaluated: dict[str, NDArray[Any]] = {}
        self._checked = CheckedPoses(
            checked.points.copy(), checked.codes.copy(), checked.batch, checked.reasons, checked.unsolved
        )

    def __contains__(self, name: object) -> bool:
        return name in self._fields

    def shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of a field."""
        return self._checked.batch + self._fields[name].pose_shape(name)

    def __call__(self, name: str) -> NDArray[Any]:
        """Evaluate a field."""
        array = self._evaluated.pop(name, None)
        if array is None:
            rows = self._fields[name].evaluate_again(
                self._robot, self._max_condition, self._checked, self._threads
            )
            array = rows.pop(name)
            self._evaluated.update(rows)
        return array.reshape(self.shape(name))


def _motor_quantities(system: Evaluation, solved: Evaluation) -> dict[str, Any]:
    """Return the quantities of fields that depend on the motors.

    - `rigid_modes`: number of rigid modes
    - `strain_free_motions`: function that returns the motions of all coordinates from the elastic stiffness and the
      platform Jacobian at N poses; None if the motors follow no command: they are free, and no spring holds them
    - `held_basis`: all coordinates per unit of those that remain with held motors, (n, r); None with free motors, or
      if a motion remains that nothing elastic resists
    """
    quantities: dict[str, Any] = {
        "rigid_modes": solved.rigid_modes,
        "strain_free_motions": None,
        "held_basis": None,
    }
    is_held = isinstance(solved, MotorsHeld)
    if is_held or springs_on_motors(system.mechanism, system.springs_to_ground):
        quantities["strain_free_motions"] = StrainFreeMotions(system)
    if isinstance(solved, MotorsHeld):
        quantities["held_basis"] = None if solved.rigid_modes else solved.kept_and_motor_motions()[0]
    return quantities


def _empty(count: int, shape: tuple[int, ...], dtype: str) -> Array:
    return np.empty((count, *shape), dtype)


def _of_modes(names: Iterable[str]) -> bool:
    """Return whether any of the fields follows from modes."""
    return bool(_needed(names, frozenset({EIGENVALUES, SHAPES})))


def _needed(names: Iterable[str], fields: frozenset[str]) -> frozenset[str]:
    """Return which of a solver's fields some names need, directly or through others."""
    needed: set[str] = set()
    for name in names:
        if name in fields:
            needed.add(name)
        elif name in FIELDS:
            needed |= _needed((quantity for quantity in FIELDS[name].needs if quantity != name), fields)
    return frozenset(needed)
