"""Modes of several robots at once, for a diagnosis: with one solver for all of them if there is one.

They have the same free coordinates and differ only in numbers, so that they are solved as one system.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import Lanes, flattened
from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.backends import AUTO, choose_backend, solver_of
from pkmodes.core.solve.numpy_solver import NumpySolver, modes_of
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, UNSOLVED, Solver, UnavailableError
from pkmodes.core.system.evaluation import ExtendedSystem, number_of_modes

Array = NDArray[np.float64]
MOTIONS = "platform_shapes"


class StackedSystems(ExtendedSystem):
    """Several robots, evaluated at equally many poses each, robot by robot.

    - systems: with the same free coordinates and rigid-body modes, length B
    - count: number of poses of each robot

    Its attributes:
    - parameters, effects: numbers that differ between the robots have a leading axis for the N poses
    - joints, joint_rates: as for `ExtendedSystem`, at each pose, (N, e)
    """

    def __init__(self, systems: Sequence[ExtendedSystem], count: int) -> None:
        first = systems[0]
        self.mechanism, self.base_count, self.rigid_modes = (
            first.mechanism,
            first.base_count,
            first.rigid_modes,
        )
        self.free, self.coordinates = first.free, first.coordinates
        self.held_motions, self.springs_to_ground = first.held_motions, first.springs_to_ground
        self.basis = first.basis
        self._systems, self._count = tuple(systems), count

    @cached_property
    def parameters(self) -> Any:
        """The robots, as the generated model takes them."""
        sets = [s.parameters for s in self._systems]
        return sets[0]._replace(**_differing_fields(sets, self._count))

    @cached_property
    def effects(self) -> Any:
        """Their effects."""
        sets = [s.effects for s in self._systems]
        return sets[0]._replace(**_differing_fields(sets, self._count))

    @cached_property
    def joints(self) -> Array:  # type: ignore[override]
        """Stiffnesses of the released joints."""
        return np.repeat([s.joints for s in self._systems], self._count, axis=0)

    @cached_property
    def joint_rates(self) -> Array:  # type: ignore[override]
        """Their derivatives with respect to the compliances."""
        return np.repeat([s.joint_rates for s in self._systems], self._count, axis=0)

    @cached_property
    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have inertia in none of the robots."""
        return np.asarray(np.all([s.massless for s in self._systems], axis=0))

    def lanes(self) -> Lanes:
        """The robots as the compiled evaluator takes them."""
        return Lanes(
            _flat_rows([s.parameters for s in self._systems]),
            _flat_rows([s.effects for s in self._systems]),
            np.array([s.joints for s in self._systems]),
            self.free.astype(np.int32),
            self.massless.astype(np.int8),
            self.fold(),
        )


def stack_systems(systems: Sequence[ExtendedSystem], count: int) -> ExtendedSystem:
    """Combine robots, see `StackedSystems`; a single one is returned as it is."""
    return systems[0] if len(systems) == 1 else StackedSystems(systems, count)


def _differing_fields(sets: Sequence[tuple[Any, ...]], count: int) -> dict[str, Array]:
    """Return the fields in which the named tuples differ, each value repeated `count` times along a leading axis."""
    repeated = {}
    for name in sets[0]._fields:  # type: ignore[attr-defined]
        values = np.array([getattr(numbers, name) for numbers in sets], dtype=float)
        if (values != values[0]).any():
            repeated[name] = np.repeat(values, count, axis=0)
    return repeated


def _flat_rows(sets: Sequence[tuple[Any, ...]]) -> Array:
    """Return the fields of each named tuple in a row; most of them are the same objects."""
    rows = np.tile(flattened(sets[0]), (len(sets), 1))
    ends = np.cumsum([np.size(value) for value in sets[0]]).tolist()
    for row, numbers in zip(rows[1:], sets[1:], strict=True):
        for value, first, end in zip(numbers, sets[0], ends, strict=True):
            if value is not first:
                row[end - np.size(value) : end] = np.ravel(value)
    return rows


class ModesOfSystems(NamedTuple):
    """Modes of B robots with the same free coordinates at n poses each, robot by robot.

    - system: all robots
    - eigenvalues: (B n, m); NaN if the matrices are not those of a machine
    - shapes: (B n, m, n)
    - motions: of the platform, (B n, m, components)
    - matrices: M and K in all coordinates, if they were evaluated
    - solver: of all robots together, if there is one
    """

    system: ExtendedSystem
    eigenvalues: Array
    shapes: Array
    motions: Array
    matrices: tuple[Array, Array] | None
    solver: Solver | None


def modes_of_systems(systems: Sequence[ExtendedSystem], points: Array) -> ModesOfSystems:
    """Evaluate the modes of robots with the same free coordinates, for a diagnosis.

    - systems: length B
    - points: n poses of each robot, robot by robot, (B n, d)
    """
    system = stack_systems(systems, len(points) // len(systems))
    modes = _by_solvers(systems, system, np.ascontiguousarray(points))
    if modes is not None:
        return modes
    robot_at_poses = RobotAtPoses(system, points, "", {})
    matrices = None
    try:
        eigenvalues, shapes = modes_of(robot_at_poses)
        matrices = robot_at_poses.all_coordinates
    except np.linalg.LinAlgError:  # a required inertia is missing: these values are not a machine
        eigenvalues = np.full((len(points), len(system.free)), np.nan)
        shapes = np.zeros((*eigenvalues.shape, len(system.free)))
    return ModesOfSystems(system, eigenvalues, shapes, _motions(robot_at_poses, shapes), matrices, None)


def modes_where_reached(systems: Sequence[ExtendedSystem], points: Array) -> ModesOfSystems | None:
    """Evaluate the modes at poses that may be out of reach; None if one is, or if no solver checks poses."""
    system = stack_systems(systems, len(points) // len(systems))
    return _by_solvers(systems, system, np.ascontiguousarray(points), checked=False)


def _by_solvers(
    systems: Sequence[ExtendedSystem], system: ExtendedSystem, points: Array, *, checked: bool = True
) -> ModesOfSystems | None:
    """Evaluate all robots with one solver, or each with its own; None if NumPy has to evaluate them together."""
    backend = choose_backend(AUTO)
    if any((member.massless != system.massless).any() for member in systems):
        return None
    try:
        solver = solver_of(system, MAX_CONDITION, backend).inner
        solvers = (
            []
            if solver.takes_several_robots
            else [solver_of(s, MAX_CONDITION, backend).inner for s in systems]
        )
    except UnavailableError:
        return None
    if isinstance(solver, NumpySolver) or not (checked or solver.checks_poses):
        return None
    n, m, count = len(system.coordinates), number_of_modes(system), len(points) // len(systems)
    tails = {EIGENVALUES: (m,), SHAPES: (m, n), MOTIONS: (m, len(system.mechanism.platform))}
    arrays = {name: np.empty((len(points), *tail)) for name, tail in tails.items()}
    codes = np.empty(len(points), dtype=np.int8)
    solver_arrays = {name: array for name, array in arrays.items() if name in solver.fields}
    if solver.takes_several_robots:
        codes[:] = solver.compute(RobotAtPoses(system, points, "", {}), solver_arrays)
    else:
        for b, (member, member_solver) in enumerate(zip(systems, solvers, strict=True)):
            part = slice(b * count, (b + 1) * count)
            part_arrays = {name: array[part] for name, array in solver_arrays.items()}
            codes[part] = member_solver.compute(RobotAtPoses(member, points[part], "", {}), part_arrays)
    if (codes > 0).any():
        return None
    if MOTIONS not in solver_arrays:
        arrays[MOTIONS] = _motions(RobotAtPoses(system, points, "", {}), arrays[SHAPES])
    failed = np.unique(np.flatnonzero(codes == UNSOLVED) // count)
    if len(failed):  # all poses of these robots
        rows = (failed[:, None] * count + np.arange(count)).ravel()
        failed_robots = RobotAtPoses(stack_systems([systems[b] for b in failed], count), points[rows], "", {})
        try:
            eigenvalues, shapes = modes_of(failed_robots)
        except np.linalg.LinAlgError:
            return None
        arrays[EIGENVALUES][rows], arrays[SHAPES][rows] = eigenvalues, shapes
        arrays[MOTIONS][rows] = _motions(failed_robots, shapes)
    return ModesOfSystems(
        system,
        arrays[EIGENVALUES],
        arrays[SHAPES],
        arrays[MOTIONS],
        None,
        solver if solver.takes_several_robots else None,
    )


def solver_of_several(systems: Sequence[ExtendedSystem]) -> Solver | None:
    """Return the solver of several robots together, if there is one."""
    try:
        solver = solver_of(stack_systems(systems, 1), MAX_CONDITION, choose_backend(AUTO)).inner
    except UnavailableError:
        return None
    return solver if solver.takes_several_robots else None


def _motions(robot_at_poses: RobotAtPoses, shapes: Array) -> Array:
    return np.asarray(shapes @ np.swapaxes(robot_at_poses.platform_motion, -1, -2))
