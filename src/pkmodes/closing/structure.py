"""A robot at measured poses, as the diagnosis sees a structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.closing import frame
from pkmodes.diagnosis.problem import Batch, Candidate, Parameter, Prediction
from pkmodes.evaluation import SystemOfEffects
from pkmodes.mechanism import Mechanism
from pkmodes.poses import MAX_CONDITION, check_poses
from pkmodes.regular import declared
from pkmodes.robot.paths import ParameterPath, moved
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import POSE, MatrixDerivatives, geometry_of, locked_joints
from pkmodes.sensitivity.shapes import shape_derivatives
from pkmodes.solving import solve

Array = NDArray[np.float64]
#: Prefix of the channels that are the platform's absolute motion.
PLATFORM = "p_"
#: Of robots that are evaluated together, some may have fewer parameters than others.
NOTHING = ParameterPath("", 0.0, "1", {})
#: Step of differences by a parameter, in its unit.
DIFFERENCE = 1e-6
#: Where another measurement could be made: draws around the measured poses, and their seed.
DRAWS, SEED = 400, 7
#: Kinds of keys of the robot file that say where something is, whatever their dimension.
WHERE = ("direction", "choice", "signs", "pair")


def channels(kind: Mechanism) -> dict[str, str]:
    """Shape components that a robot has, with their units: all coordinates, released ones included, and the platform.

    Parameters
    ----------
    kind : Mechanism
    """
    units = {component.name: component.unit for component in kind.pose}
    found = dict(zip(kind.extended.COORDINATES, kind.extended.COORDINATE_UNITS, strict=True))
    return found | {f"{PLATFORM}{name}": units[name] for name in kind.directions}


class _Solved(NamedTuple):
    """Modes of a robot, or of several that are alike, at those of its poses that it reaches."""

    robots: tuple[Robot, ...]
    system: SystemOfEffects
    valid: NDArray[np.bool_]
    points: Array
    matrices: tuple[Array, Array]
    eigenvalues: Array
    shapes: Array
    channels: Array


class _Moves(NamedTuple):
    """What parameters of one robot move: T paths, and (P, T, k) how much along each of them, where it is not I."""

    paths: tuple[ParameterPath, ...]
    mix: Array | None


class RobotStructure:
    """A robot at P platform poses.

    Parameters
    ----------
    robot : Robot
    points : ndarray, shape (P, d)
        Poses.
    parameters, candidates, moves
        From `pkmodes.closing.suspects.suspects`; parameters of the measurement frame have no move.
    """

    def __init__(
        self,
        robot: Robot,
        points: Array,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
        moves: Mapping[str, ParameterPath],
    ) -> None:
        self.robot, self.points = robot, np.asarray(points, dtype=float)
        self.parameters: tuple[Parameter, ...] = tuple(parameters)
        self.candidates: tuple[Candidate, ...] = tuple(candidates)
        self._kind = robot.kind
        known = channels(self._kind)
        self.channels, self.channel_units = tuple(known), tuple(known.values())
        self._shifts = tuple(
            ParameterPath(f"{POSE}.{component.name}", 0.0, component.unit, {(POSE, (i,)): 1.0})
            for i, component in enumerate(self._kind.pose)
        )
        self._moves = dict(moves)
        self._last: tuple[bytes, _Solved] | None = None
        self._latest: tuple[object, Prediction] | None = None

    def at(self, points: Array) -> RobotStructure:
        """Return the same robot at other poses."""
        return RobotStructure(self.robot, points, self.parameters, self.candidates, self._moves)

    def subset(self, setups: Sequence[int]) -> RobotStructure:
        """Return the same robot at some of its poses."""
        return self.at(self.points[list(setups)])

    def with_values(self, values: Array) -> Robot:
        """Return the robot with these values of the parameters."""
        changes = [
            (self._moves[p.name], value - self._moves[p.name].value)
            for p, value in zip(self.parameters, values, strict=True)
            if p.name in self._moves and value != self._moves[p.name].value
        ]
        return moved(self.robot, changes)

    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Modes at all poses, with derivatives with respect to some of the parameters."""
        asked = values.tobytes(), tuple(by), shape_rates
        if (
            self._latest is not None and self._latest[0] == asked
        ):  # a fit asks more than once at the same values
            return self._latest[1]
        found = _derived(self._at_values(values), [self._moved_by(values, by)], shape_rates)
        if by:
            self._latest = asked, found
        return found

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Modes at all poses for several sets of values; those are one batch that differ in numbers only.

        What differs otherwise, in the joints that are locked or in the poses that can be reached, is evaluated by
        itself.
        """
        robots = [self.with_values(v) for v in values]
        where = [frame.true_points(self._kind, self.points, self._frame(v)) for v in values]
        systems = [SystemOfEffects.of(robot) for robot in robots]
        moves = [self._moved_by(v, some) for v, some in zip(values, by, strict=True)]
        groups: dict[object, list[int]] = {}
        for k, (robot, system) in enumerate(zip(robots, systems, strict=True)):
            apart = locked_joints(system, moves[k].paths) or not self._reachable(robot, where[k]).all()
            alike = (system.free.tobytes(), system.rigid_modes)
            groups.setdefault(k if apart else alike, []).append(k)
        found = []
        for some in groups.values():
            together = None
            if len(some) > 1:
                system = SystemOfEffects.stacked([systems[k] for k in some], len(self.points))
                points = np.concatenate([where[k] for k in some])
                together = self._solved([robots[k] for k in some], system, points)
            if together is None or not np.isfinite(together.eigenvalues).all():
                found += [
                    Batch(np.array([k]), self.predict(values[k], by[k], shape_rates=shape_rates))
                    for k in some
                ]
            else:
                prediction = _derived(together, [moves[k] for k in some], shape_rates)
                found.append(Batch(np.array(some), prediction))
        return found

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Modes at all poses, with derivatives with respect to the platform's position."""
        return _derived(self._at_values(values), [_Moves(self._shifts, None)], shape_rates)

    def elsewhere(self, count: int) -> tuple[Array, RobotStructure]:
        """Reachable poses in and around the measured ones, and the robot there."""
        rng = np.random.default_rng(SEED)
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        margin = 0.25 * max(float((high - low).max()), 0.1)
        drawn = rng.uniform(low - margin, high + margin, (DRAWS, len(low)))
        found = check_poses(drawn, self._kind, self.robot.parameters, "nan", MAX_CONDITION / 1e5)
        drawn = drawn[found.valid][:count]
        return drawn, self.at(drawn)

    def _moved_by(self, values: Array, by: Sequence[int]) -> _Moves:
        """What some of the parameters move."""
        names = [self.parameters[i].name for i in by]
        paths = tuple(self._moves[name] for name in names if name in self._moves)
        if len(paths) == len(names):
            return _Moves(paths, None)
        # What moves the frame moves all poses, each by what it is away from the frame's origin.
        known = {path.path: k for k, path in enumerate(paths)}
        mix = np.zeros((len(self.points), len(paths) + len(self._shifts), len(by)))
        for column, name in enumerate(names):
            if name in known:
                mix[:, known[name], column] = 1.0
            else:
                mix[:, len(paths) :, column] = frame.rate(self._kind, name, self.points, self._frame(values))
        return _Moves((*paths, *self._shifts), mix)

    def _frame(self, values: Array) -> dict[str, float]:
        """Values of the parameters of the measurement frame."""
        named = zip(self.parameters, values, strict=True)
        return {p.name: float(value) for p, value in named if p.name not in self._moves}

    def _at_values(self, values: Array) -> _Solved:
        """Modes for one set of values."""
        key = values.tobytes()
        if (
            self._last is None or self._last[0] != key
        ):  # derivatives are mostly asked for where the modes were
            robot = self.with_values(values)
            where = frame.true_points(self._kind, self.points, self._frame(values))
            valid = self._reachable(robot, where)
            system = SystemOfEffects.of(robot)
            self._last = key, self._solved([robot], system, where[valid])._replace(valid=valid)
        return self._last[1]

    def _solved(self, robots: Sequence[Robot], system: SystemOfEffects, points: Array) -> _Solved:
        try:
            at = solve(system, points)
            every, eigenvalues, shapes = at.every, at.eigenvalues, at.shapes
        except np.linalg.LinAlgError:  # values without inertia where there must be some: no machine
            every = system.all_coordinates(points)
            eigenvalues = np.full((len(points), len(system.free)), np.nan)
            shapes = np.zeros((*eigenvalues.shape, len(system.free)))
        valid = np.ones(len(points), dtype=bool)
        at_channels = _at_channels(system, points, shapes)
        return _Solved(tuple(robots), system, valid, points, every, eigenvalues, shapes, at_channels)

    def _reachable(self, robot: Robot, points: Array) -> NDArray[np.bool_]:
        """Which poses this robot reaches; those of the declared one were checked with the measurements."""
        if _same_geometry(self._kind, robot, self.robot) and np.array_equal(points, self.points):
            return np.ones(len(points), dtype=bool)
        return check_poses(points, self._kind, robot.parameters, "nan").valid


def _derived(at: _Solved, moves: Sequence[_Moves], shape_rates: bool) -> Prediction:
    """Modes with their derivatives along what parameters of each robot move."""
    most = max(len(one.paths) for one in moves)
    paths = [(*one.paths, *[NOTHING] * (most - len(one.paths))) for one in moves]
    rates = np.zeros((*at.eigenvalues.shape, most))
    along = np.zeros((*at.channels.shape, most)) if shape_rates else None
    if most and np.isfinite(at.eigenvalues).all():
        derivatives = MatrixDerivatives(at.system, at.points, paths, at.matrices)
        rates = derivatives.eigenvalues(at.eigenvalues, at.shapes)
        if along is not None:
            along = _channel_rates(at, derivatives, paths)
    if any(one.mix is not None for one in moves):
        mix = _mixed(moves, most, len(at.valid) // len(moves))[at.valid]
        rates, along = rates @ mix, None if along is None else along @ mix[:, None]
    return Prediction(
        _scattered(at.eigenvalues, at.valid),
        _scattered(rates, at.valid),
        _scattered(at.channels, at.valid),
        at.system.rigid_modes,
        None if along is None else _scattered(along, at.valid),
    )


def _mixed(moves: Sequence[_Moves], most: int, poses: int) -> Array:
    """How much each parameter moves along each path, (N, T, k)."""
    columns = max(len(one.paths) if one.mix is None else one.mix.shape[-1] for one in moves)
    found = np.zeros((len(moves), poses, most, columns))
    for one, part in zip(moves, found, strict=True):
        each = np.eye(len(one.paths)) if one.mix is None else one.mix
        part[:, : each.shape[-2], : each.shape[-1]] = each
    return found.reshape(-1, most, columns)


def _at_channels(system: SystemOfEffects, points: Array, shapes: Array) -> Array:
    """Shapes at the channels, (N, m, C)."""
    directions = len(system.kind.directions)
    found = np.zeros((*shapes.shape[:2], system.joints.shape[-1] + directions))
    found[..., system.free] = shapes
    found[..., -directions:] = shapes @ np.swapaxes(system.platform_motion(points), -1, -2)
    return found


def _channel_rates(
    at: _Solved, derivatives: MatrixDerivatives, paths: Sequence[Sequence[ParameterPath]]
) -> Array:
    """Derivatives of the shapes at the channels along paths, (N, m, C, T)."""
    kind = at.system.kind
    directions, geometry = len(kind.directions), geometry_of(kind)
    changes = shape_derivatives(derivatives, at.eigenvalues, at.shapes, at.system.first)
    motion = at.system.motion_of_all(at.points)
    found = np.zeros((*at.channels.shape, len(paths[0])))
    found[..., : changes.shape[-1], :] = np.moveaxis(changes, 1, -1)
    found[..., -directions:, :] = np.moveaxis(changes @ np.swapaxes(motion, -1, -2)[:, None], 1, -1)
    each = len(at.points) // len(at.robots)
    for b, robot in enumerate(at.robots):
        part = slice(b * each, (b + 1) * each)
        for t, path in enumerate(paths[b]):
            # The platform's motion by the coordinates changes with the geometry and the pose, too.
            if any(field in geometry or field == POSE for field, _ in path.weights):
                rate = _motion_rate(at.system, robot, at.points[part], path)[..., derivatives.free]
                found[part, :, -directions:, t] += at.shapes[part] @ np.swapaxes(rate, -1, -2)
    return found


def _motion_rate(system: SystemOfEffects, robot: Robot, points: Array, path: ParameterPath) -> Array:
    """Derivative of the platform's motion by the coordinates along a path, by differences, (P, directions, e)."""
    shift = np.zeros(points.shape[-1])
    for (field, index), weight in path.weights.items():
        if field == POSE:
            shift[index] = weight
    there, back = (
        system.motion_of_all(
            points + step * shift,
            robot.parameters if shift.any() else moved(robot, [(path, step)]).parameters,
        )
        for step in (DIFFERENCE, -DIFFERENCE)
    )
    found: Array = (there - back) / (2.0 * DIFFERENCE)
    return found


def _scattered(values: Array, valid: NDArray[np.bool_]) -> Array:
    """Put the results of reachable poses in their places, NaN in the others."""
    if valid.all():
        return values
    found = np.full((len(valid), *values.shape[1:]), np.nan)
    found[valid] = values
    return found


def _same_geometry(kind: Mechanism, a: Robot, b: Robot) -> bool:
    """Whether two robots reach the same poses: nothing else of them enters the margins."""
    names = {key.field for key in declared(kind) if key.kind in WHERE or key.dimension in ("length", "angle")}
    return all(np.array_equal(getattr(a.parameters, name), getattr(b.parameters, name)) for name in names)
