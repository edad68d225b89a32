"""Derivatives of modes from the compiled evaluator, and from NumPy where modes coincide or joints are locked.

The evaluator takes parameter paths as weighted entries of the gradient of an eigenvalue.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import FULL_MATRIX_FIELDS, MATRIX_RATE_FIELDS, UNSOLVED, Terms, flattened
from pkmodes.core.linalg.eigen import rounding_scale
from pkmodes.core.mechanism.poses import CHUNK, codes_of
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import sample_parameters
from pkmodes.core.robot.layout import Slot
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.batch import Job
from pkmodes.core.solve.solver import EIGENVALUES, Codes, Solver
from pkmodes.core.system.evaluation import Evaluation, ExtendedSystem, may_be_refused, number_of_modes
from pkmodes.loop.sensitivity.locked import LockedJoints, joints_of
from pkmodes.loop.sensitivity.matrices import POSE, MatrixDerivatives, effect_fields
from pkmodes.loop.sensitivity.modes import ROUNDING, are_separate
from pkmodes.loop.sensitivity.paths import ParameterPath

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: The compiled evaluator's names of the fields of `sensitivity.sensitivities.Sensitivities` that it evaluates.
RATES = {"eigenvalues": "eigenvalue_rates", "frequencies": "frequency_rates"}


def terms_of(system: ExtendedSystem, paths: Sequence[ParameterPath]) -> Terms:
    """Return the terms of parameter paths.

    - system: of the robot, with or without effects
    """
    terms = terms_of_all([system], [paths])
    return terms._replace(first=terms.first[0], effects=terms.effects[0])


def terms_of_all(systems: Sequence[ExtendedSystem], paths: Sequence[Sequence[ParameterPath]]) -> Terms:
    """Return the terms of several robots with the same free coordinates, each with equally many paths."""
    system = systems[0]
    values, parameters = _gradient_indices(system.mechanism)
    pose = len(values)
    joints, free = pose + len(system.mechanism.pose), frozenset(system.free.tolist())
    terms_by_path = [
        list(_path_terms(robot_system, path, values, free))
        for robot_system, robot_paths in zip(systems, paths, strict=True)
        for path in robot_paths
    ]
    gradient_indices = [index for terms in terms_by_path for index, _ in terms]
    count, ends = len(paths[0]), np.cumsum([0, *map(len, terms_by_path)], dtype=np.int32)
    return Terms(
        first=ends[np.arange(len(systems))[:, None] * count + np.arange(count + 1)],
        places=np.array(gradient_indices, dtype=np.int32),
        weights=np.array([weight for terms in terms_by_path for _, weight in terms], dtype=float),
        effects=np.array([flattened(robot_system.effects) for robot_system in systems]),
        all_coordinates=any(parameters <= index < pose or index >= joints for index in gradient_indices),
        locked_joints=any(index >= joints and index - joints not in free for index in gradient_indices),
    )


def _path_terms(
    system: ExtendedSystem, path: ParameterPath, values: Mapping[Slot, int], free: frozenset[int]
) -> Iterator[tuple[int, float]]:
    """Yield place and weight of the terms of a path."""
    pose = len(values)
    joints, of_slot = pose + len(system.mechanism.pose), joints_of(system.mechanism)
    for slot, weight in path.weights.items():
        if slot in of_slot:
            for joint in of_slot[slot]:
                rate = float(system.joint_rates[joint]) if joint in free else 1.0
                yield joints + joint, weight * rate
        elif slot[0] == POSE:
            yield pose + slot[1][0], weight
        else:
            yield values[slot], weight


@cache
def _gradient_indices(mechanism: Mechanism) -> tuple[dict[Slot, int], int]:
    """Return the place of each number of a robot in a gradient, and how many of them are parameters."""
    dotted, parameters = effect_fields(mechanism), 0
    slots: list[Slot] = []
    for numbers in (sample_parameters(mechanism), mechanism.extended.Effects()):
        parameters = len(slots)
        slots += [
            (dotted.get(name, name), index)
            for name, value in zip(numbers._fields, numbers, strict=True)
            for index in np.ndindex(np.shape(value))
        ]
    return {slot: place for place, slot in enumerate(slots)}, parameters


def rates_job(
    solver: Solver,
    system: Evaluation,
    source: str,
    terms: Terms,
    close: float,
    requested: Sequence[str],
    by_numpy: Callable[[Array], Mapping[str, Array]],
) -> Job:
    """Return the job that evaluates derivatives of eigenvalues and frequencies.

    - solver: that differentiates
    - system: of the robot
    - source: the robot, for messages
    - terms: of T paths
    - close: as for `pkmodes.Model.sensitivities`
    - requested: fields
    - by_numpy: evaluates the fields at some poses, (n, d)
    """
    modes = number_of_modes(system)

    def compute(points: Array, rows: Mapping[str, Array], threads: int) -> Codes:
        robot_at_poses = RobotAtPoses(system, points, source, {})
        if not rows:
            return solver.compute(robot_at_poses, rows, threads)
        eigenvalues = np.empty((len(points), modes))
        written = {RATES[name]: array for name, array in rows.items()}
        codes = solver.rates(robot_at_poses, {**written, EIGENVALUES: eigenvalues}, terms, threads)
        for start in range(0, len(codes), CHUNK):
            chunk = slice(start, start + CHUNK)
            values = eigenvalues[chunk]
            sizes = rounding_scale(values, system.base_count, system.rigid_modes, system.loose_motions)
            coincident = ~are_separate(values, close, sizes)
            if "eigenvalues" not in requested:
                # Those of frequencies that are zero to rounding are NaN, whatever the group.
                is_nonzero = np.abs(values) > ROUNDING * sizes
                coincident &= is_nonzero[:, 1:] | is_nonzero[:, :-1]
            codes[chunk][(codes[chunk] == 0) & coincident.any(axis=1)] = UNSOLVED
        return codes

    tail = (len(terms.first) - 1, modes)
    return Job(
        pose_shapes=dict.fromkeys(requested, (tail, "f8")),
        reasons=codes_of(system.mechanism),
        compute=compute,
        by_numpy=by_numpy,
        checks_poses=True,
        refusable=may_be_refused(system),
    )


class CompiledDerivatives(MatrixDerivatives):
    """Derivatives of given modes, evaluated together for all poses, robots and paths.

    - system, p, paths, matrices, locked: as for `MatrixDerivatives`
    - evaluated: what the kernel evaluated of the modes for which derivatives will be requested
      (`pkmodes.core.compiled.evaluator.Evaluator.along`).  NumPy evaluates other fields where they are read.
    """

    def __init__(
        self,
        system: ExtendedSystem,
        p: Array,
        paths: Sequence[Sequence[ParameterPath]],
        evaluated: Mapping[str, Array],
        matrices: tuple[Array, Array] | None = None,
        locked: LockedJoints | None = None,
    ) -> None:
        super().__init__(system, p, paths, matrices, locked)
        self._compiled = evaluated

    @cached_property
    def _all_coordinates(self) -> tuple[Array, Array]:
        if not self._compiled.keys() >= set(FULL_MATRIX_FIELDS):
            return super()._all_coordinates
        M, K = (self._compiled[name] for name in FULL_MATRIX_FIELDS)
        return self.system.from_generated_matrices(M, K)

    @cached_property
    def _dense(self) -> tuple[Array, Array]:
        if not self._compiled.keys() >= set(MATRIX_RATE_FIELDS):
            return super()._dense
        dM, dK = (self._compiled[name] for name in MATRIX_RATE_FIELDS)
        for matrix in (dM, dK):
            matrix[:, list(self.locked_paths)] = np.nan
        return dM, dK

    def eigenvalues(self, eigenvalues: Array, shapes: Array) -> Array:
        """Return derivatives of simple eigenvalues, (N, m, T)."""
        rates = np.ascontiguousarray(np.swapaxes(self._compiled["mode_rates"], 1, 2))
        self._add_locked(rates, eigenvalues, shapes)
        return rates

    def changes(self, eigenvalues: Array, shapes: Array, poses: Index | None = None) -> tuple[Array, Array]:
        """Return (dK - lambda dM) phi, (N, T, m, n), and phi^T dM phi, (N, T, m), along each path."""
        if poses is not None or "changes" not in self._compiled:
            return super().changes(eigenvalues, shapes, poses)
        change, norm = self._compiled["changes"], self._compiled["norms"]
        return self._with_locked(change, norm, eigenvalues, shapes)

    def motions(self, shapes: Array) -> Array | None:
        """Return the derivatives of the platform's motion in fixed shapes, (N, T, m, components)."""
        return self._compiled["motions"]


def derivatives_of(
    solver: Solver | None,
    system: ExtendedSystem,
    p: Array,
    paths: Sequence[Sequence[ParameterPath]],
    modes: tuple[Array, Array] | None,
    terms: Terms | None,
    fields: Sequence[str],
    *,
    matrices: tuple[Array, Array] | None = None,
    locked: LockedJoints | None = None,
) -> MatrixDerivatives:
    """Return the derivatives of modes along paths, from one call of a compiled solver if it has them.

    - solver: of the robots
    - system, p, paths, matrices, locked: as for `MatrixDerivatives`
    - modes: eigenvalues and shapes, (N, m) and (N, m, n); m may be 0
    - terms: of the paths, if there is a solver
    - fields: what the solver evaluates, as of `pkmodes.core.solve.solver.Solver.along`; nothing, if empty
    """
    evaluated = None
    if solver is not None and terms is not None and fields:
        evaluated = solver.along(RobotAtPoses(system, p, "", {}), modes, terms, fields)
    if evaluated is None:
        return MatrixDerivatives(system, p, paths, matrices, locked)
    return CompiledDerivatives(system, p, paths, evaluated, matrices, locked)
