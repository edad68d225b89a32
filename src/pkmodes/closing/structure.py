"""A robot at measured poses, as the diagnosis sees a structure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.problem import Candidate, Parameter, Prediction
from pkmodes.eigen import condensed_eigh
from pkmodes.evaluation import SystemOfEffects, active_effects
from pkmodes.poses import MAX_CONDITION, check_poses
from pkmodes.robot.effects import CATALOGUE
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.paths import ParameterPath, moved
from pkmodes_generated.linear_delta import COORDINATES, RIGID_MODES, extended

Array = NDArray[np.float64]
PLATFORM = ("p_x", "p_y", "p_z")
#: Names of the shape components that a robot has: all coordinates, released ones included, and the platform.
CHANNELS: tuple[str, ...] = (*extended.COORDINATES, *PLATFORM)
#: Moving the platform is moving its three joints while the rails stay: nothing else of the pose enters.
SHIFTS = tuple(
    ParameterPath(f"pose.{name}", 0.0, "m", {("joint", (j, i)): 1.0 for j in range(3)})
    for i, name in enumerate("xyz")
)
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
        From `pkmodes.closing.suspects.suspects`.
    """

    def __init__(
        self,
        robot: Robot,
        points: Array,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
        moves: Sequence[ParameterPath],
    ) -> None:
        self.robot, self.points = robot, np.asarray(points, dtype=float)
        self.parameters: tuple[Parameter, ...] = tuple(parameters)
        self.candidates: tuple[Candidate, ...] = tuple(candidates)
        self.channels = CHANNELS
        self._moves = tuple(moves)
        self._declared = np.array([move.value for move in moves])
        self._last: tuple[bytes, _Solved] | None = None

    def at(self, points: Array) -> RobotStructure:
        """Return the same robot at other poses."""
        return RobotStructure(self.robot, points, self.parameters, self.candidates, self._moves)

    def subset(self, setups: Sequence[int]) -> RobotStructure:
        """Return the same robot at some of its poses."""
        return self.at(self.points[list(setups)])

    def with_values(self, values: Array) -> Robot:
        """Return the robot with these values of the parameters."""
        steps = values - self._declared
        return moved(
            self.robot, [(move, step) for move, step in zip(self._moves, steps, strict=True) if step]
        )

    def predict(self, values: Array, by: Sequence[int]) -> Prediction:
        """Modes at all poses, with derivatives by some of the parameters."""
        key = values.tobytes()
        if (
            self._last is None or self._last[0] != key
        ):  # derivatives are mostly asked for where the modes were
            self._last = key, self._solved(values)
        at = self._last[1]
        rates = np.zeros((*at.eigenvalues.shape, len(by)))
        if by and np.isfinite(at.eigenvalues).all():
            moves = [self._moves[i] for i in by]
            rates = MatrixDerivatives(at.robot, at.points, moves, at.matrices).eigenvalues(
                at.eigenvalues, at.shapes
            )
        eigenvalues, rates, channels = (_scattered(a, at.valid) for a in (at.eigenvalues, rates, at.channels))
        return Prediction(eigenvalues, rates, channels, _rigid(at.robot))

    def _solved(self, values: Array) -> _Solved:
        robot = self.with_values(values)
        valid = self._reachable(robot)
        points = self.points[valid]
        system = SystemOfEffects(robot.parameters, robot.effects)
        M, K = system.all_coordinates(points)
        rows, columns = np.ix_(system.free, system.free)
        try:
            eigenvalues, shapes = condensed_eigh(
                M[:, rows, columns], K[:, rows, columns], len(COORDINATES), _rigid(robot)
            )
            channels = self._channels(robot, points, system, shapes)
        except np.linalg.LinAlgError:  # values without inertia where there must be some: no machine
            eigenvalues = np.full((len(points), len(system.free)), np.nan)
            shapes = np.zeros((*eigenvalues.shape, len(system.free)))
            channels = np.zeros((*eigenvalues.shape, len(self.channels)))
        return _Solved(robot, valid, points, (M, K), eigenvalues, shapes, channels)

    def position_rates(self, values: Array) -> Array:
        """Derivatives of the eigenvalues by the platform's position, (P, m, 3)."""
        robot = self.with_values(values)
        system = SystemOfEffects(robot.parameters, robot.effects)
        derivatives = MatrixDerivatives(robot, self.points, SHIFTS)
        rows, columns = np.ix_(system.free, system.free)
        M, K = derivatives.M[:, rows, columns], derivatives.K[:, rows, columns]
        return derivatives.eigenvalues(*condensed_eigh(M, K, len(COORDINATES), _rigid(robot)))

    def elsewhere(self, count: int) -> tuple[Array, RobotStructure]:
        """Reachable poses in and around the measured ones, and the robot there."""
        rng = np.random.default_rng(SEED)
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        margin = 0.25 * max(float((high - low).max()), 0.1)
        drawn = rng.uniform(low - margin, high + margin, (DRAWS, 3))
        drawn = drawn[check_poses(drawn, self.robot.parameters, "nan", MAX_CONDITION / 1e5).valid][:count]
        return drawn, self.at(drawn)

    def _reachable(self, robot: Robot) -> NDArray[np.bool_]:
        """Which poses this robot reaches; those of the declared one were checked with the measurements."""
        if _same_geometry(robot, self.robot):
            return np.ones(len(self.points), dtype=bool)
        return check_poses(self.points, robot.parameters, "nan").valid

    def _channels(self, robot: Robot, points: Array, system: SystemOfEffects, shapes: Array) -> Array:
        found = np.zeros((*shapes.shape[:2], len(self.channels)))
        found[..., system.free] = shapes
        motion = extended.extended_platform_motion(points, robot.parameters)[..., system.free]
        found[..., -3:] = shapes @ np.swapaxes(motion, -1, -2)
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
