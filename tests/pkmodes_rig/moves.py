"""A linear delta on the rig while its motors follow a move: integration of its nonlinear equations of motion.

The rotors of the motors turn as the command says; carriages and the other pulleys are free, and belts of the present
length pull them.  MuJoCo supplies positions, inertia, velocity forces and weight.  Weight is balanced at the
commanded pose, as by a controller that knows the static sag.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp

from pkmodes_generated.linear_delta import Parameters
from pkmodes_rig.mujoco_engine import AXES, Engine, carriage_positions

#: Of the integrator: displacements of some 1e-3 m to 1e-7 m.
RELATIVE, ABSOLUTE = 1e-6, 1e-8
#: The longest step [s], short beside the vibrations, so that no corner of the command is stepped over.
LONGEST = 2e-3


@dataclass(frozen=True)
class StraightMove:
    """A straight move from rest to rest, as fast as a speed and an acceleration allow.

    Attributes
    ----------
    start, target : ndarray, shape (3,)
        Platform centre [m].
    speed, acceleration : float
        In m/s and m/s^2.
    """

    start: np.ndarray
    target: np.ndarray
    speed: float = 1.0
    acceleration: float = 15.0

    @cached_property
    def distance(self) -> float:
        """In m."""
        return float(np.linalg.norm(self.target - self.start))

    @cached_property
    def corners(self) -> np.ndarray:
        """Times at which the acceleration changes [s]."""
        ramp = min(self.speed / self.acceleration, np.sqrt(self.distance / self.acceleration))
        end = self.distance / (self.acceleration * ramp) + ramp
        return np.array([0.0, ramp, end - ramp, end])

    @property
    def duration(self) -> float:
        """In s."""
        return float(self.corners[-1])

    def poses(self, time: np.ndarray) -> np.ndarray:
        """Return the platform centre at times, (..., 3)."""
        _, ramp, brake, end = self.corners
        t = np.clip(np.asarray(time, dtype=float), 0.0, end)
        a = self.acceleration
        travel = np.where(
            t < ramp,
            0.5 * a * t**2,
            np.where(t < brake, a * ramp * (t - 0.5 * ramp), self.distance - 0.5 * a * (end - t) ** 2),
        )
        return np.asarray(self.start + (travel / self.distance)[..., None] * (self.target - self.start))


def deviation(
    parameters: Parameters,
    command: Callable[[float], np.ndarray],
    time: np.ndarray,
    corners: np.ndarray,
    friction: float = 0.0,
) -> np.ndarray:
    """Integrate the motion, at rest at first, and return how far the platform is from the command, (T, 3) [m].

    Parameters
    ----------
    parameters : Parameters
        One robot, without batch axes.
    command : callable
        The platform centre at a time, which the motors follow.
    time : ndarray, shape (T,)
        Ascending [s].
    corners : ndarray
        Times at which the acceleration of the command jumps.
    friction : float
        Viscous friction of each carriage on its rail [N s/m].
    """
    motion = _Motion(parameters, command, friction)
    state, found = np.zeros(12), [np.zeros((0, 12))]
    edges = np.unique(
        np.concatenate([[time[0]], corners[(corners > time[0]) & (corners < time[-1])], [time[-1]]])
    )
    for first, last in pairwise(edges):
        inside = time[(time > first) & (time <= last)]
        result = solve_ivp(
            motion.rates,
            (first, last),
            state,
            method="DOP853",
            t_eval=np.unique(np.append(inside, last)),
            rtol=RELATIVE,
            atol=ABSOLUTE,
            max_step=LONGEST,
        )
        if not result.success:
            raise ValueError(result.message)
        found.append(result.y.T[: len(inside)])
        state = result.y[:, -1]
    states = np.vstack([np.zeros((1, 12)), *found])
    return np.array([motion.platform(s) - command(t) for t, s in zip(time, states, strict=True)])


class _Motion:
    """Displacements of three carriages and of the three pulleys without motors, then their rates."""

    def __init__(
        self, parameters: Parameters, command: Callable[[float], np.ndarray], friction: float
    ) -> None:
        self.parameters, self.command, self.friction = parameters, command, friction
        self.engine = Engine(parameters, command(0.0))
        self.start = self.engine.x.copy()
        self.driven = np.argmax(np.asarray(parameters.drive), axis=1)  # 0: pulley 1, 1: pulley 2
        self.other = [3 + 3 * (1 - int(self.driven[j])) + j for j in AXES]

    def platform(self, state: np.ndarray) -> np.ndarray:
        """Return the platform centre."""
        self._place(state[:3])
        return self.engine.platform()

    def _place(self, x: np.ndarray) -> None:
        q = np.concatenate([x, np.zeros(6)])
        self.engine.move(q)

    def rates(self, time: float, state: np.ndarray) -> np.ndarray:
        x, theta, x_dot, theta_dot = state.reshape(4, 3)
        commanded = carriage_positions(self.parameters, self.command(time)) - self.start
        with_weight = self._weight(commanded)
        self._place(x)
        M = self.engine.mass_matrix()
        force = with_weight - self._gradient() - self.engine.velocity_forces(x_dot)[0] - self.friction * x_dot
        turning = np.empty(3)
        for j in AXES:
            pull, torque = self._belt(j, x[j], theta[j], commanded[j])
            force[j] += pull
            turning[j] = torque / M[self.other[j], self.other[j]]
        return np.concatenate([x_dot, theta_dot, np.linalg.solve(M[:3, :3], force), turning])

    def _weight(self, x: np.ndarray) -> np.ndarray:
        self._place(x)
        return self._gradient()

    def _gradient(self) -> np.ndarray:
        """Return the gradient of the weight's energy by the carriages: the belts of the engine are left out."""
        return (self.engine.allowed().T @ self.engine.data.qfrc_bias)[:3]

    def _belt(self, j: int, x: float, theta: float, commanded: float) -> tuple[float, float]:
        """Return the force of the belt on a carriage, and the torque on the pulley without a motor."""
        q = self.parameters
        low, high = q.limits[j]
        half, radius = q.carriage_length[j] / 2, q.pulley_radius[j]
        at = self.start[j] + x
        rim = [0.0, 0.0]
        rim[int(self.driven[j])], rim[1 - int(self.driven[j])] = commanded, radius * theta
        around, behind, ahead = (
            q.belt_width[j] * q.belt_specific_stiffness[j] / length * elongation
            for length, elongation in (
                (high - low, rim[1] - rim[0]),
                (at - low - half, x - rim[1]),
                (high - at - half, rim[0] - x),
            )
        )
        pulls = (around - ahead, behind - around)  # of the belt on the rims of pulleys 1 and 2
        return ahead - behind, radius * pulls[1 - int(self.driven[j])]
