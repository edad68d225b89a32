"""A robot at measured poses, as the diagnosis sees a structure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.closing import frame
from pkmodes.diagnosis.problem import Candidate, Parameter, Prediction
from pkmodes.eigen import condensed_eigh
from pkmodes.evaluation import SystemOfEffects, active_effects
from pkmodes.poses import MAX_CONDITION, check_poses
from pkmodes.robot.effects import CATALOGUE
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.paths import ParameterPath, moved
from pkmodes.sensitivity.shapes import shape_derivatives
from pkmodes_generated.linear_delta import COORDINATES, RIGID_MODES, Parameters, extended

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
#: Generated parameters that change how the platform follows the carriages, and the step of differences [m].
GEOMETRY, DIFFERENCE = ("origin", "joint", "link_length"), 1e-6
#: Where another measurement could be made: draws around the measured poses, and their seed.
DRAWS, SEED = 400, 7


class _Solved(NamedTuple):
    """Modes of a robot at those of its poses that it reaches."""

    robot: Robot
    valid: NDArray[np.bool_]
    points: Array
    matrices: tuple[Array, Array]
    eigenvalues: Array
    shapes: Array
    channels: Array


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
        self._rates: tuple[object, tuple[Array, Array | None]] | None = None

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
        names = [self.parameters[i].name for i in by]
        paths = [self._moves[name] for name in names if name in self._moves]
        of_frame = [name for name in names if name not in self._moves]
        found = self._along(values, [*paths, *(SHIFTS if of_frame else ())], shape_rates=shape_rates)
        if not of_frame:
            return found
        # What moves the frame moves all poses, each by what it is away from the frame's origin.
        known = {path.path: k for k, path in enumerate(paths)}
        mix = np.zeros((len(self.points), len(paths) + len(SHIFTS), len(by)))
        for column, name in enumerate(names):
            if name in known:
                mix[:, known[name], column] = 1.0
            else:
                mix[:, len(paths) :, column] = frame.rate(name, self.points, self._frame(values))
        along = None if found.shape_rates is None else found.shape_rates @ mix[:, None]
        return replace(found, rates=found.rates @ mix, shape_rates=along)

    def predict_many(self, values: Array) -> Prediction | None:
        """Modes at all poses for several values of the parameters at once, without derivatives.

        Parameters
        ----------
        values : ndarray, shape (B, number of parameters)

        Returns
        -------
        Prediction or None
            Of B times P setups, those of the first values first.  None where they differ in more than numbers: in
            the joints that are locked, or in the poses that can be reached.
        """
        robots = [self.with_values(v) for v in values]
        where = [frame.true_points(self.points, self._frame(v)) for v in values]
        systems = [SystemOfEffects(robot.parameters, robot.effects) for robot in robots]
        free, rigid = systems[0].free, {_rigid(robot) for robot in robots}
        alike = all(np.array_equal(system.free, free) for system in systems) and len(rigid) == 1
        if not alike or not all(self._reachable(r, p).all() for r, p in zip(robots, where, strict=True)):
            return None
        count = len(self.points)
        parameters = robots[0].parameters._replace(**_different([r.parameters for r in robots], count))
        effects = systems[0].effects._replace(**_different([system.effects for system in systems], count))
        points = np.concatenate(where)
        M, K_el, K_g = extended.extended_matrices(points, parameters, effects)
        K = K_el + K_g
        diagonal = np.arange(K.shape[-1])
        K[..., diagonal, diagonal] += np.repeat([system.joints for system in systems], count, axis=0)
        rows, columns = np.ix_(free, free)
        try:
            eigenvalues, shapes = condensed_eigh(
                M[:, rows, columns], K[:, rows, columns], len(COORDINATES), min(rigid)
            )
        except np.linalg.LinAlgError:
            return None
        channels = self._channels(parameters, points, free, shapes)
        return Prediction(eigenvalues, np.zeros((*eigenvalues.shape, 0)), channels, min(rigid))

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Modes at all poses, with derivatives with respect to the platform's position."""
        return self._along(values, SHIFTS, shape_rates=shape_rates)

    def elsewhere(self, count: int) -> tuple[Array, RobotStructure]:
        """Reachable poses in and around the measured ones, and the robot there."""
        rng = np.random.default_rng(SEED)
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        margin = 0.25 * max(float((high - low).max()), 0.1)
        drawn = rng.uniform(low - margin, high + margin, (DRAWS, 3))
        drawn = drawn[check_poses(drawn, self.robot.parameters, "nan", MAX_CONDITION / 1e5).valid][:count]
        return drawn, self.at(drawn)

    def _along(self, values: Array, paths: Sequence[ParameterPath], *, shape_rates: bool) -> Prediction:
        """Modes at all poses, with derivatives along paths."""
        key = values.tobytes()
        if (
            self._last is None or self._last[0] != key
        ):  # derivatives are mostly asked for where the modes were
            self._last = key, self._solved(values)
        at = self._last[1]
        asked = key, tuple(path.path for path in paths), shape_rates
        if not paths:
            rates, along = self._derived(at, paths, shape_rates)
        elif (
            self._rates is not None and self._rates[0] == asked
        ):  # a fit asks more than once at the same values
            rates, along = self._rates[1]
        else:
            rates, along = self._derived(at, paths, shape_rates)
            self._rates = asked, (rates, along)
        return Prediction(
            _scattered(at.eigenvalues, at.valid),
            _scattered(rates, at.valid),
            _scattered(at.channels, at.valid),
            _rigid(at.robot),
            None if along is None else _scattered(along, at.valid),
        )

    def _derived(
        self, at: _Solved, paths: Sequence[ParameterPath], shape_rates: bool
    ) -> tuple[Array, Array | None]:
        """Derivatives of eigenvalues, and of shapes where they are asked for."""
        rates = np.zeros((*at.eigenvalues.shape, len(paths)))
        along = np.zeros((*at.channels.shape, len(paths))) if shape_rates else None
        if paths and np.isfinite(at.eigenvalues).all():
            derivatives = MatrixDerivatives(at.robot, at.points, paths, at.matrices)
            rates = derivatives.eigenvalues(at.eigenvalues, at.shapes)
            if along is not None:
                along = self._channel_rates(at, derivatives, paths)
        return rates, along

    def _frame(self, values: Array) -> dict[str, float]:
        """Values of the parameters of the measurement frame."""
        named = zip(self.parameters, values, strict=True)
        return {p.name: float(value) for p, value in named if p.name not in self._moves}

    def _solved(self, values: Array) -> _Solved:
        robot = self.with_values(values)
        where = frame.true_points(self.points, self._frame(values))
        valid = self._reachable(robot, where)
        points = where[valid]
        system = SystemOfEffects(robot.parameters, robot.effects)
        M, K = system.all_coordinates(points)
        rows, columns = np.ix_(system.free, system.free)
        try:
            eigenvalues, shapes = condensed_eigh(
                M[:, rows, columns], K[:, rows, columns], len(COORDINATES), _rigid(robot)
            )
            channels = self._channels(robot.parameters, points, system.free, shapes)
        except np.linalg.LinAlgError:  # values without inertia where there must be some: no machine
            eigenvalues = np.full((len(points), len(system.free)), np.nan)
            shapes = np.zeros((*eigenvalues.shape, len(system.free)))
            channels = np.zeros((*eigenvalues.shape, len(self.channels)))
        return _Solved(robot, valid, points, (M, K), eigenvalues, shapes, channels)

    def _reachable(self, robot: Robot, points: Array) -> NDArray[np.bool_]:
        """Which poses this robot reaches; those of the declared one were checked with the measurements."""
        if _same_geometry(robot, self.robot) and np.array_equal(points, self.points):
            return np.ones(len(points), dtype=bool)
        return check_poses(points, robot.parameters, "nan").valid

    def _channels(
        self, parameters: Parameters, points: Array, free: NDArray[np.intp], shapes: Array
    ) -> Array:
        found = np.zeros((*shapes.shape[:2], len(self.channels)))
        found[..., free] = shapes
        motion = extended.extended_platform_motion(points, parameters)[..., free]
        found[..., -3:] = shapes @ np.swapaxes(motion, -1, -2)
        return found

    def _channel_rates(
        self, at: _Solved, derivatives: MatrixDerivatives, paths: Sequence[ParameterPath]
    ) -> Array:
        """Derivatives of the shapes at the channels along paths, (P, m, C, T)."""
        changes = shape_derivatives(derivatives, at.eigenvalues, at.shapes, len(COORDINATES))
        motion = extended.extended_platform_motion(at.points, at.robot.parameters)
        found = np.zeros((*at.channels.shape, len(paths)))
        found[..., : changes.shape[-1], :] = np.moveaxis(changes, 1, -1)
        found[..., -3:, :] = np.moveaxis(changes @ np.swapaxes(motion, -1, -2)[:, None], 1, -1)
        for t, path in enumerate(paths):
            # The platform's motion by the coordinates changes with the geometry, too.
            if any(field in GEOMETRY for field, _ in path.weights):
                rate = self._motion_rate(at, path)
                found[..., -3:, t] += at.shapes @ np.swapaxes(rate[..., derivatives.free], -1, -2)
        return found

    def _motion_rate(self, at: _Solved, path: ParameterPath) -> Array:
        """Derivative of the platform's motion by the coordinates along a path, by differences, (P, 3, e)."""
        there, back = (
            extended.extended_platform_motion(at.points, moved(at.robot, [(path, step)]).parameters)
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
    grounded = any(CATALOGUE[name].grounds for name in active_effects(robot.effects))
    return 0 if grounded else RIGID_MODES


def _same_geometry(a: Robot, b: Robot) -> bool:
    geometry = ("origin", "joint", "link_length", "limits", "carriage_length")
    return all(np.array_equal(getattr(a.parameters, name), getattr(b.parameters, name)) for name in geometry)


def _different(sets: Sequence[tuple[Any, ...]], count: int) -> dict[str, Array]:
    """Fields in which named tuples of numbers differ, with an axis in front that repeats each so many times."""
    found = {}
    for name in sets[0]._fields:  # type: ignore[attr-defined]
        values = [np.asarray(getattr(one, name), dtype=float) for one in sets]
        if any(not np.array_equal(value, values[0]) for value in values):
            found[name] = np.repeat(np.stack(values), count, axis=0)
    return found
