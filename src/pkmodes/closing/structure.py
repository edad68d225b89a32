"""A robot at measured poses, as the diagnosis sees a structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.closing import frame
from pkmodes.diagnosis.problem import Batch, Candidate, Parameter, Prediction
from pkmodes.eigen import condensed_eigh
from pkmodes.evaluation import SystemOfEffects, active_effects
from pkmodes.poses import MAX_CONDITION, check_poses
from pkmodes.robot.paths import ParameterPath, moved
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import MatrixDerivatives, locked_joints
from pkmodes.sensitivity.shapes import shape_derivatives
from pkmodes_generated.linear_delta import COORDINATES, RIGID_MODES, extended

Array = NDArray[np.float64]
PLATFORM = ("p_x", "p_y", "p_z")
#: Names of the shape components that a robot has: all coordinates, released ones included, and the platform.
CHANNELS: tuple[str, ...] = (*extended.COORDINATES, *PLATFORM)
CHANNEL_UNITS = tuple("rad" if name.startswith(("theta_", "psi_")) else "m" for name in CHANNELS)
#: Moving the platform is moving its three joints while the rails stay: nothing else of the pose enters.
SHIFTS = tuple(
    ParameterPath(f"pose.{name}", 0.0, "m", {("joint", (j, i)): 1.0 for j in range(3)})
    for i, name in enumerate("xyz")
)
#: Of robots that are evaluated together, some may have fewer parameters than others.
NOTHING = ParameterPath("", 0.0, "1", {})
#: Generated parameters that change how the platform follows the carriages, and the step of differences [m].
GEOMETRY, DIFFERENCE = ("origin", "joint", "link_length"), 1e-6
#: Where another measurement could be made: draws around the measured poses, and their seed.
DRAWS, SEED = 400, 7


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
    points : ndarray, shape (P, 3)
        Platform centres [m].
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
        self.channels, self.channel_units = CHANNELS, CHANNEL_UNITS
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
        where = [frame.true_points(self.points, self._frame(v)) for v in values]
        systems = [SystemOfEffects(robot.parameters, robot.effects) for robot in robots]
        moves = [self._moved_by(v, some) for v, some in zip(values, by, strict=True)]
        groups: dict[object, list[int]] = {}
        for k, (robot, system) in enumerate(zip(robots, systems, strict=True)):
            apart = locked_joints(system, moves[k].paths) or not self._reachable(robot, where[k]).all()
            alike = (system.free.tobytes(), _rigid(robot))
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
        return _derived(self._at_values(values), [_Moves(SHIFTS, None)], shape_rates)

    def elsewhere(self, count: int) -> tuple[Array, RobotStructure]:
        """Reachable poses in and around the measured ones, and the robot there."""
        rng = np.random.default_rng(SEED)
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        margin = 0.25 * max(float((high - low).max()), 0.1)
        drawn = rng.uniform(low - margin, high + margin, (DRAWS, 3))
        drawn = drawn[check_poses(drawn, self.robot.parameters, "nan", MAX_CONDITION / 1e5).valid][:count]
        return drawn, self.at(drawn)

    def _moved_by(self, values: Array, by: Sequence[int]) -> _Moves:
        """What some of the parameters move."""
        names = [self.parameters[i].name for i in by]
        paths = tuple(self._moves[name] for name in names if name in self._moves)
        if len(paths) == len(names):
            return _Moves(paths, None)
        # What moves the frame moves all poses, each by what it is away from the frame's origin.
        known = {path.path: k for k, path in enumerate(paths)}
        mix = np.zeros((len(self.points), len(paths) + len(SHIFTS), len(by)))
        for column, name in enumerate(names):
            if name in known:
                mix[:, known[name], column] = 1.0
            else:
                mix[:, len(paths) :, column] = frame.rate(name, self.points, self._frame(values))
        return _Moves((*paths, *SHIFTS), mix)

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
            where = frame.true_points(self.points, self._frame(values))
            valid = self._reachable(robot, where)
            system = SystemOfEffects(robot.parameters, robot.effects)
            self._last = key, self._solved([robot], system, where[valid])._replace(valid=valid)
        return self._last[1]

    def _solved(self, robots: Sequence[Robot], system: SystemOfEffects, points: Array) -> _Solved:
        M, K = system.all_coordinates(points)
        rows, columns = np.ix_(system.free, system.free)
        try:
            eigenvalues, shapes = condensed_eigh(
                M[:, rows, columns], K[:, rows, columns], len(COORDINATES), _rigid(robots[0])
            )
            channels = _channels(system, points, shapes)
        except np.linalg.LinAlgError:  # values without inertia where there must be some: no machine
            eigenvalues = np.full((len(points), len(system.free)), np.nan)
            shapes = np.zeros((*eigenvalues.shape, len(system.free)))
            channels = np.zeros((*eigenvalues.shape, len(CHANNELS)))
        valid = np.ones(len(points), dtype=bool)
        return _Solved(tuple(robots), system, valid, points, (M, K), eigenvalues, shapes, channels)

    def _reachable(self, robot: Robot, points: Array) -> NDArray[np.bool_]:
        """Which poses this robot reaches; those of the declared one were checked with the measurements."""
        if _same_geometry(robot, self.robot) and np.array_equal(points, self.points):
            return np.ones(len(points), dtype=bool)
        return check_poses(points, robot.parameters, "nan").valid


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
        _rigid(at.robots[0]),
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


def _channels(system: SystemOfEffects, points: Array, shapes: Array) -> Array:
    """Shapes at the channels, (N, m, C)."""
    found = np.zeros((*shapes.shape[:2], len(CHANNELS)))
    found[..., system.free] = shapes
    motion = extended.extended_platform_motion(points, system.parameters)[..., system.free]
    found[..., -3:] = shapes @ np.swapaxes(motion, -1, -2)
    return found


def _channel_rates(
    at: _Solved, derivatives: MatrixDerivatives, paths: Sequence[Sequence[ParameterPath]]
) -> Array:
    """Derivatives of the shapes at the channels along paths, (N, m, C, T)."""
    changes = shape_derivatives(derivatives, at.eigenvalues, at.shapes, len(COORDINATES))
    motion = extended.extended_platform_motion(at.points, at.system.parameters)
    found = np.zeros((*at.channels.shape, len(paths[0])))
    found[..., : changes.shape[-1], :] = np.moveaxis(changes, 1, -1)
    found[..., -3:, :] = np.moveaxis(changes @ np.swapaxes(motion, -1, -2)[:, None], 1, -1)
    each = len(at.points) // len(at.robots)
    for b, robot in enumerate(at.robots):
        part = slice(b * each, (b + 1) * each)
        for t, path in enumerate(paths[b]):
            # The platform's motion by the coordinates changes with the geometry, too.
            if any(field in GEOMETRY for field, _ in path.weights):
                rate = _motion_rate(robot, at.points[part], path)[..., derivatives.free]
                found[part, :, -3:, t] += at.shapes[part] @ np.swapaxes(rate, -1, -2)
    return found


def _motion_rate(robot: Robot, points: Array, path: ParameterPath) -> Array:
    """Derivative of the platform's motion by the coordinates along a path, by differences, (P, 3, e)."""
    there, back = (
        extended.extended_platform_motion(points, moved(robot, [(path, step)]).parameters)
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


def _rigid(robot: Robot) -> int:
    grounded = any(robot.kind.effects[name].grounds for name in active_effects(robot.effects))
    return 0 if grounded else RIGID_MODES


def _same_geometry(a: Robot, b: Robot) -> bool:
    geometry = ("origin", "joint", "link_length", "limits", "carriage_length")
    return all(np.array_equal(getattr(a.parameters, name), getattr(b.parameters, name)) for name in geometry)
