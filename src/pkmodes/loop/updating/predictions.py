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
NO_PATH = ParameterPath("", 0.0, "1", {})
#: Eigenvalue of the first missing mode of a setup, far above all others, and ratio of successive ones.
MISSING_EIGENVALUE, MISSING_RATIO = 1e40, 100.0


class Motions(NamedTuple):
    """Motions of k parameters of one robot along T paths.

    - weights: change along each path per unit of each parameter, (n, T, k); None for the identity
    """

    paths: tuple[ParameterPath, ...]
    weights: Array | None


class SolvedRobots(NamedTuple):
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

    def of_robot(self, robot: int) -> SolvedRobots:
        """Return the modes of one robot."""
        count = len(self.points) // len(self.robots)
        part = slice(robot * count, (robot + 1) * count)
        matrices = None if self.matrices is None else (self.matrices[0][part], self.matrices[1][part])
        return SolvedRobots(
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
def solve_together(
    robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array
) -> SolvedRobots: ...
@overload
def solve_together(
    robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array, *, checked: bool
) -> SolvedRobots | None: ...
def solve_together(
    robots: Sequence[Robot], systems: Sequence[ExtendedSystem], points: Array, *, checked: bool = True
) -> SolvedRobots | None:
    """Solve robots with the same free coordinates together, at (B n, d) poses.

    If the poses were not checked, the solver must check them; the result is None if there is no such solver, or it
    refuses a pose.
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
    return SolvedRobots(*fields)


def predict_along(solved: SolvedRobots, motions: Sequence[Motions], shape_rates: bool) -> Prediction:
    """Return modes with their derivatives along the motions of each robot's parameters."""
    if len(motions) > 1 and any(
        locked_joints(solved.system, robot_motions.paths).paths for robot_motions in motions
    ):
        predictions = [
            predict_along(solved.of_robot(b), [robot_motions], shape_rates)
            for b, robot_motions in enumerate(motions)
        ]
        return concatenate_predictions(predictions)
    path_count = max(len(robot_motions.paths) for robot_motions in motions)
    padded_paths = {
        id(robot_motions.paths): (*robot_motions.paths, *[NO_PATH] * (path_count - len(robot_motions.paths)))
        for robot_motions in motions
    }
    paths = [padded_paths[id(robot_motions.paths)] for robot_motions in motions]
    rates = np.zeros((*solved.eigenvalues.shape, path_count))
    channel_rates = np.zeros((*solved.channels.shape, path_count)) if shape_rates else None
    if path_count and np.isfinite(solved.eigenvalues).all():
        modes = solved.eigenvalues, solved.shapes
        terms = None if solved.solver is None else terms_of_all(solved.systems, paths)
        derivatives = derivatives_of(
            solved.solver,
            solved.system,
            solved.points,
            paths,
            modes,
            terms,
            MODE_RATE_FIELDS,
            matrices=solved.matrices,
        )
        rates = derivatives.eigenvalues(solved.eigenvalues, solved.shapes)
        if channel_rates is not None:
            channel_rates = _channel_rates(solved, derivatives, paths)
    if any(robot_motions.weights is not None for robot_motions in motions):
        combined_weights = _weights_of_robots(motions, path_count, len(solved.points) // len(motions))
        rates, channel_rates = (
            rates @ combined_weights,
            None if channel_rates is None else channel_rates @ combined_weights[:, None],
        )
    return Prediction(solved.eigenvalues, rates, solved.channels, solved.system.rigid_modes, channel_rates)


def join_modes(parts: Sequence[tuple[Index, Prediction]], setups: int) -> Prediction:
    """Join the modes of parts of the setups; NaN for a setup that is in no part.

    Robots of different load cases may differ in their numbers of modes and rigid modes.  Rigid modes come first,
    padded to the largest number; missing elastic modes are placed far above (`MISSING_EIGENVALUE`).

    - parts: setups and their modes
    - setups: number of all setups
    """
    rows, single_part = parts[0]
    if len(parts) == 1 and np.array_equal(rows, np.arange(setups)):
        return single_part
    rigid = max(part.rigid for _, part in parts)
    count = rigid + max(part.eigenvalues.shape[1] - part.rigid for _, part in parts)
    eigenvalues = np.full((setups, count), np.nan)
    arrays = [np.full((setups, count, *a.shape[2:]), np.nan) for a in _arrays(single_part)]
    for rows, part in parts:
        elastic = part.eigenvalues.shape[1] - part.rigid
        missing_eigenvalues = MISSING_EIGENVALUE * MISSING_RATIO ** np.arange(count - rigid - elastic)
        columns = np.r_[: part.rigid, rigid : rigid + elastic]
        eigenvalues[np.ix_(rows, np.arange(part.rigid, rigid))] = 0.0
        eigenvalues[np.ix_(rows, np.arange(rigid + elastic, count))] = missing_eigenvalues
        eigenvalues[np.ix_(rows, columns)] = part.eigenvalues
        for array, values in zip(arrays, _arrays(part), strict=True):
            array[rows] = 0.0
            array[np.ix_(rows, columns)] = values
    rates, shapes, *shape_rates = arrays
    return Prediction(eigenvalues, rates, shapes, rigid, *shape_rates)


def _arrays(part: Prediction) -> list[Array]:
    """Return the derivatives of the eigenvalues, the shapes and, if there are any, their derivatives."""
    return [part.rates, part.shapes, *([] if part.shape_rates is None else [part.shape_rates])]


def concatenate_predictions(parts: Sequence[Prediction]) -> Prediction:
    """Join the predictions of several robots with equally many modes, one after the other."""
    shape_rates = [part.shape_rates for part in parts if part.shape_rates is not None]
    return Prediction(
        np.concatenate([part.eigenvalues for part in parts]),
        np.concatenate([part.rates for part in parts]),
        np.concatenate([part.shapes for part in parts]),
        parts[0].rigid,
        np.concatenate(shape_rates) if shape_rates else None,
    )


def _weights_of_robots(motions: Sequence[Motions], path_count: int, poses: int) -> Array:
    """Return the change along each path per unit of each parameter, (N, T, k)."""
    columns = max(
        len(robot_motions.paths) if robot_motions.weights is None else robot_motions.weights.shape[-1]
        for robot_motions in motions
    )
    all_weights = np.zeros((len(motions), poses, path_count, columns))
    for robot_motions, padded_weights in zip(motions, all_weights, strict=True):
        weights = np.eye(len(robot_motions.paths)) if robot_motions.weights is None else robot_motions.weights
        padded_weights[:, : weights.shape[-2], : weights.shape[-1]] = weights
    return all_weights.reshape(-1, path_count, columns)


def _channel_rates(
    solved: SolvedRobots, derivatives: MatrixDerivatives, paths: Sequence[tuple[ParameterPath, ...]]
) -> Array:
    """Return the derivatives of the shapes at the channels along paths, (N, m, C, T)."""
    mechanism = solved.system.mechanism
    components, geometry = len(mechanism.platform), geometry_of(mechanism)
    motion = partial(solved.system.full_platform_motion, solved.points)
    changes = shape_derivatives(
        derivatives, solved.eigenvalues, solved.shapes, solved.channels[..., -components:], motion
    )
    rates = np.ascontiguousarray(np.moveaxis(changes, 1, -1))
    platform_rates = derivatives.motions(solved.shapes)
    if platform_rates is not None:
        rates[..., -components:, :] += np.moveaxis(platform_rates, 1, -1)
        return rates
    pose_count = len(solved.points) // len(solved.robots)
    equal_robots: dict[tuple[int, int], list[int]] = {}
    for b, robot in enumerate(solved.robots):
        equal_robots.setdefault((id(robot), id(paths[b])), []).append(b)
    for members in equal_robots.values():
        robot = solved.robots[members[0]]
        part = np.concatenate([np.arange(b * pose_count, (b + 1) * pose_count) for b in members])
        for t, path in enumerate(paths[members[0]]):
            # The Jacobian of the platform also changes with the geometry and the pose.
            if any(field in geometry or field == POSE for field, _ in path.weights):
                numbers = robot.parameters, ExtendedSystem.of(robot).effects
                parameters, effects, shift = stepped_along(mechanism, *numbers, path)
                stepped = solved.system.full_platform_motion(
                    solved.points[part] + COMPLEX_STEP * 1j * shift, parameters, effects
                )
                rate = (stepped.imag / COMPLEX_STEP)[..., derivatives.free]
                rates[part, :, -components:, t] += solved.shapes[part] @ np.swapaxes(rate, -1, -2)
    return rates


def stepped_along(
    mechanism: Mechanism, parameters: Any, effects: Any, path: ParameterPath
) -> tuple[Any, Any, Array]:
    """Return the parameters and effects of a robot with a complex step along a path, and the rates of the pose."""
    pose_rates = np.zeros(len(mechanism.pose))
    values: dict[str, NDArray[np.complex128]] = {}
    dotted = {name: field for field, name in effect_fields(mechanism).items()}
    for (field, index), weight in path.weights.items():
        if field == POSE:
            pose_rates[index] = weight
        elif field in parameters._fields:
            values.setdefault(field, np.array(getattr(parameters, field), dtype=complex))
            values[field][index] += COMPLEX_STEP * 1j * weight
        elif field in dotted:
            stepped_effect = getattr(effects, dotted[field]) + COMPLEX_STEP * 1j * weight
            effects = effects._replace(**{dotted[field]: stepped_effect})
    return parameters._replace(**values), effects, pose_rates
