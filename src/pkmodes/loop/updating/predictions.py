"""Modes of robots at poses, with their derivatives along parameter paths.

Robots with the same free coordinates are evaluated together; robots of other load cases may have more modes.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import MODE_RATE_FIELDS
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.stepped import COMPLEX_STEP
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.solver import Solver
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.diagnosis.problem import Prediction
from pkmodes.loop.sensitivity.compiled import derivatives_of, terms_of_all
from pkmodes.loop.sensitivity.locked import locked_joints
from pkmodes.loop.sensitivity.matrices import POSE, MatrixDerivatives, effect_fields, geometry_of
from pkmodes.loop.sensitivity.paths import ParameterPath
from pkmodes.loop.sensitivity.shapes import shape_derivatives
from pkmodes.loop.updating.modes_of_systems import modes_of_systems, modes_where_reached, solver_of_several

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Padding for robots with fewer parameters than others that are evaluated with them.
NOTHING = ParameterPath("", 0.0, "1", {})
#: Eigenvalue of the first missing mode of a setup, far above all others, and the ratio between successive ones.
LACKING, FARTHER = 1e40, 100.0


class Moves(NamedTuple):
    """Moves of k parameters of one robot: T paths, and the motion along each, (n, T, k); None for the identity."""

    paths: tuple[ParameterPath, ...]
    mix: Array | None


class Solved(NamedTuple):
    """Modes of B robots that can be evaluated together, at n reachable poses each, the first robot first.

    The matrices, in all coordinates, are None where the modes were found without them.  The solver is that of all
    robots together, if there is one.
    """

    robots: tuple[Robot, ...]
    systems: tuple[ExtendedSystem, ...]
    system: ExtendedSystem
    points: Array
    matrices: tuple[Array, Array] | None
    eigenvalues: Array
    shapes: Array
    channels: Array
    solver: Solver | None

    def of(self, robot: int) -> Solved:
        """Return the modes of one robot."""
        count = len(self.points) // len(self.robots)
        part = slice(robot * count, (robot + 1) * count)
        matrices = None if self.matrices is None else (self.matrices[0][part], self.matrices[1][part])
        return Solved(
            self.robots[robot : robot + 1],
            self.systems[robot : robot + 1],
            self.systems[robot],
            self.points[part],
            matrices,
            self.eigenvalues[part],
            self.shapes[part],
            self.channels[part],
            None if self.solver is None else solver_of_several(self.systems[robot : robot + 1]),
        )


@overload
def solved_together(robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array) -> Solved: ...
@overload
def solved_together(
    robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array, *, checked: bool
) -> Solved | None: ...
def solved_together(
    robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array, *, checked: bool = True
) -> Solved | None:
    """Solve robots with the same free coordinates together, at (B n, d) poses.

    Poses that were not checked are only solved by a solver that does; the result is None if there is no such
    solver, or it refuses a pose.
    """
    modes = modes_of_systems(systems, points) if checked else modes_where_reached(systems, points)
    if modes is None:
        return None
    system, eigenvalues, shapes, motions, matrices, solver = modes
    channels = np.zeros((*shapes.shape[:2], system.joints.shape[-1] + motions.shape[-1]))
    channels[..., system.free] = shapes
    of_model = slice(system.joints.shape[-1])
    channels[..., of_model] = system.to_model_coordinates(channels[..., of_model])
    channels[..., -motions.shape[-1] :] = motions
    fields = tuple(robots), tuple(systems), system, points, matrices, eigenvalues, shapes, channels, solver
    return Solved(*fields)


def derived(at: Solved, moves: Sequence[Moves], shape_rates: bool) -> Prediction:
    """Return modes with their derivatives along the moves of each robot's parameters."""
    if len(moves) > 1 and any(locked_joints(at.system, robot_moves.paths).paths for robot_moves in moves):
        predictions = [derived(at.of(b), [robot_moves], shape_rates) for b, robot_moves in enumerate(moves)]
        return concatenated(predictions)
    longest = max(len(robot_moves.paths) for robot_moves in moves)
    filled = {
        id(robot_moves.paths): (*robot_moves.paths, *[NOTHING] * (longest - len(robot_moves.paths)))
        for robot_moves in moves
    }
    paths = [filled[id(robot_moves.paths)] for robot_moves in moves]
    rates = np.zeros((*at.eigenvalues.shape, longest))
    along = np.zeros((*at.channels.shape, longest)) if shape_rates else None
    if longest and np.isfinite(at.eigenvalues).all():
        modes = at.eigenvalues, at.shapes
        terms = None if at.solver is None else terms_of_all(at.systems, paths)
        derivatives = derivatives_of(
            at.solver, at.system, at.points, paths, modes, terms, MODE_RATE_FIELDS, matrices=at.matrices
        )
        rates = derivatives.eigenvalues(at.eigenvalues, at.shapes)
        if along is not None:
            along = _channel_rates(at, derivatives, paths)
    if any(robot_moves.mix is not None for robot_moves in moves):
        mix = _mixed(moves, longest, len(at.points) // len(moves))
        rates, along = rates @ mix, None if along is None else along @ mix[:, None]
    return Prediction(at.eigenvalues, rates, at.channels, at.system.rigid_modes, along)


def joined_modes(parts: Sequence[tuple[Index, Prediction]], setups: int) -> Prediction:
    """Join the modes of parts of the setups; NaN for a setup that is in no part.

    Robots of different load cases may differ in their numbers of modes and rigid modes.  Rigid modes come first,
    padded to the largest number; missing elastic modes are placed far above (`LACKING`).

    - parts: setups and their modes
    - setups: number of all setups
    """
    rows, only = parts[0]
    if len(parts) == 1 and np.array_equal(rows, np.arange(setups)):
        return only
    rigid = max(part.rigid for _, part in parts)
    count = rigid + max(part.eigenvalues.shape[1] - part.rigid for _, part in parts)
    eigenvalues = np.full((setups, count), np.nan)
    arrays = [np.full((setups, count, *a.shape[2:]), np.nan) for a in _arrays(only)]
    for rows, part in parts:
        elastic = part.eigenvalues.shape[1] - part.rigid
        lacking = LACKING * FARTHER ** np.arange(count - rigid - elastic)
        place = np.r_[: part.rigid, rigid : rigid + elastic]
        eigenvalues[np.ix_(rows, np.arange(part.rigid, rigid))] = 0.0
        eigenvalues[np.ix_(rows, np.arange(rigid + elastic, count))] = lacking
        eigenvalues[np.ix_(rows, place)] = part.eigenvalues
        for whole, values in zip(arrays, _arrays(part), strict=True):
            whole[rows] = 0.0
            whole[np.ix_(rows, place)] = values
    rates, shapes, *along = arrays
    return Prediction(eigenvalues, rates, shapes, rigid, *along)


def _arrays(part: Prediction) -> list[Array]:
    """Return the derivatives of the eigenvalues, the shapes and, if there are any, their derivatives."""
    return [part.rates, part.shapes, *([] if part.shape_rates is None else [part.shape_rates])]


def concatenated(parts: Sequence[Prediction]) -> Prediction:
    """Join the predictions of several robots with equally many modes, one after the other."""
    along = [part.shape_rates for part in parts if part.shape_rates is not None]
    return Prediction(
        np.concatenate([part.eigenvalues for part in parts]),
        np.concatenate([part.rates for part in parts]),
        np.concatenate([part.shapes for part in parts]),
        parts[0].rigid,
        np.concatenate(along) if along else None,
    )


def _mixed(moves: Sequence[Moves], longest: int, poses: int) -> Array:
    """Return the motion of each parameter along each path, (N, T, k)."""
    columns = max(
        len(robot_moves.paths) if robot_moves.mix is None else robot_moves.mix.shape[-1]
        for robot_moves in moves
    )
    mix = np.zeros((len(moves), poses, longest, columns))
    for robot_moves, part in zip(moves, mix, strict=True):
        motion = np.eye(len(robot_moves.paths)) if robot_moves.mix is None else robot_moves.mix
        part[:, : motion.shape[-2], : motion.shape[-1]] = motion
    return mix.reshape(-1, longest, columns)


def _channel_rates(
    at: Solved, derivatives: MatrixDerivatives, paths: Sequence[tuple[ParameterPath, ...]]
) -> Array:
    """Return the derivatives of the shapes at the channels along paths, (N, m, C, T)."""
    mechanism = at.system.mechanism
    components, geometry = len(mechanism.platform), geometry_of(mechanism)
    motion = partial(at.system.full_platform_motion, at.points)
    changes = shape_derivatives(
        derivatives, at.eigenvalues, at.shapes, at.channels[..., -components:], motion
    )
    rates = np.ascontiguousarray(np.moveaxis(changes, 1, -1))
    moved = derivatives.motions(at.shapes)
    if moved is not None:
        rates[..., -components:, :] += np.moveaxis(moved, 1, -1)
        return rates
    for robot, robot_paths, part in _alike(at, paths):
        for t, path in enumerate(robot_paths):
            # The Jacobian of the platform also changes with the geometry and the pose.
            if any(field in geometry or field == POSE for field, _ in path.weights):
                numbers = robot.parameters, ExtendedSystem.of(robot).effects
                parameters, effects, shift = stepped_along(mechanism, *numbers, path)
                stepped = at.system.full_platform_motion(
                    at.points[part] + COMPLEX_STEP * 1j * shift, parameters, effects
                )
                rate = (stepped.imag / COMPLEX_STEP)[..., derivatives.free]
                rates[part, :, -components:, t] += at.shapes[part] @ np.swapaxes(rate, -1, -2)
    return rates


def _alike(
    at: Solved, paths: Sequence[tuple[ParameterPath, ...]]
) -> list[tuple[Robot, tuple[ParameterPath, ...], Index]]:
    """Group equal robots with equal paths, with the indices of all their poses."""
    count = len(at.points) // len(at.robots)
    groups: dict[tuple[int, int], list[int]] = {}
    for b, robot in enumerate(at.robots):
        groups.setdefault((id(robot), id(paths[b])), []).append(b)
    return [
        (
            at.robots[members[0]],
            paths[members[0]],
            np.concatenate([np.arange(b * count, (b + 1) * count) for b in members]),
        )
        for members in groups.values()
    ]


def stepped_along(
    mechanism: Mechanism, parameters: Any, effects: Any, path: ParameterPath
) -> tuple[Any, Any, Array]:
    """Return the parameters and effects of a robot with a complex step along a path, and the rates of the pose."""
    shift = np.zeros(len(mechanism.pose))
    values: dict[str, NDArray[np.complex128]] = {}
    dotted = {name: field for field, name in effect_fields(mechanism).items()}
    for (field, index), weight in path.weights.items():
        if field == POSE:
            shift[index] = weight
        elif field in parameters._fields:
            values.setdefault(field, np.array(getattr(parameters, field), dtype=complex))
            values[field][index] += COMPLEX_STEP * 1j * weight
        elif field in dotted:
            moved = getattr(effects, dotted[field]) + COMPLEX_STEP * 1j * weight
            effects = effects._replace(**{dotted[field]: moved})
    return parameters._replace(**values), effects, shift
