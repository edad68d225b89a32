"""The rotary delta on the virtual test rig: in MuJoCo if it has the coordinates, otherwise with loops closed here.

The MuJoCo model (`mujoco_rotary_delta`) has rigid links and a frame that slides.  For elastic links and a rocking
frame the loops are closed here, from the specification only: bodies are point masses with rotational inertias, the
platform is found by Newton's method, and the Hessian of the gravity potential by differences of its gradient.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.mujoco_rotary_delta import Engine, arm_angles
from pkmodes_rig.rows import Rows, completed, frame_compliance, without

AXES = range(3)
#: Steps of the eighth-order differences in MuJoCo and of the fourth-order differences here [rad, m].
STEP, OWN_STEP = 0.01, 2e-3
#: Weights of fourth-order first derivatives.
FOURTH = ((1, 2 / 3), (2, -1 / 12))
BASE = [f"{name}_{j + 1}" for name in ("theta", "phi") for j in AXES]
DELTA, FRAME = [f"delta_{j + 1}" for j in AXES], ["u_x", "u_y", "u_z"]
#: Axis of a rocking frame, a point on it, and the frame's inertia about it.
ROCKING, FLOOR, ROCKING_INERTIA = np.array([0.6, 0.8, 0.0]), np.array([0.0, 0.0, -1.2]), 40.0
#: A uniform rod as three points, exact for a velocity that is linear along it (Simpson's rule).
ROD = ((0.0, 1 / 6), (0.5, 2 / 3), (1.0, 1 / 6))


def rotary_delta(
    q: Any,
    p: np.ndarray,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    *,
    held: bool = False,
) -> TrueModes:
    """Compute the modes of a rotary delta at one pose; the arguments are those of `corexy`."""
    links = effects.get("link_compliance.compliance", 0.0)
    single, rocking = outside.get("one_link", 0.0), outside.get("rocking_frame", 0.0)
    payload = effects.get("payload.mass", 0.0)
    of_absorber = outside.get("tuned_absorber", 0.0)
    build = by_hand if links or single or rocking else by_engine
    rows = build(q, p, payload, of_absorber)
    for j in AXES:
        stiffness = q.reducer_stiffness[j] * (
            1.0 + effects.get(f"axis_reducer_stiffness.factor_{j + 1}", 0.0)
        )
        rows.spring(rows.row(**{f"theta_{j + 1}": 1.0, f"phi_{j + 1}": -1.0}), stiffness)
    rows.spring(rows.row(theta_1=1.0), outside.get("arm_hose", 0.0))
    locked = [name for name in FRAME if not frame_compliance(name, effects)]
    if build is by_hand:
        for j, name in enumerate(DELTA):
            if compliance := links + (single if j == 0 else 0.0):
                rows.spring(rows.row(**{name: 1.0}), 1.0 / compliance)
            else:
                locked.append(name)
        if rocking:
            rows.spring(rows.row(rock=1.0), 1.0 / rocking)
        else:
            locked.append("rock")
    completed(rows, "phi", effects, outside)
    return rows.modes([*locked, *without(outside)], rows.motors("phi") if held else ())


def by_engine(q: Any, p: np.ndarray, payload: float = 0.0, hanging: float = 0.0) -> Rows:
    """Return inertia and gravity terms from MuJoCo, without springs and without the mass of the frame.

    Of `hanging`, a mass at the platform, only the weight counts.
    """
    ghost = 1e-3  # the engine requires a frame with mass
    engine = Engine(q, p, frame=ghost, payload=payload)
    engine.relax()
    rows = Rows([*BASE, *FRAME, "absorber"], np.column_stack([engine.platform_motion(), np.zeros(3)]))
    own = slice(0, -1)
    rows.M[own, own] = engine.mass_matrix()
    for name in FRAME:
        rows.inertia(rows.row(**{name: 1.0}), -ghost)
    # The motor rotors add no mass to the frame, because in the engine they are on the ground.
    if hanging:
        engine = Engine(q, p, frame=ghost, payload=payload + hanging)
        engine.relax()
    hessian = engine.hessian(STEP)
    rows.weights[own, own] = (hessian + hessian.T) / 2
    return rows


def by_hand(q: Any, p: np.ndarray, payload: float = 0.0, hanging: float = 0.0) -> Rows:
    """Return the same for elastic links and a rocking frame, without MuJoCo."""
    loops = Loops(q, p, payload)
    names = [*BASE, *DELTA, *FRAME, "rock", "absorber"]
    at_rest = loops.points(np.zeros(9))
    moved = np.zeros((len(at_rest), 3, len(names)))
    moved[:, :, :9] = loops.jacobians(np.zeros(9))
    moved[:, :, 9:12] = np.eye(3)
    moved[:, :, 12] = np.cross(ROCKING, at_rest - FLOOR)
    rows = Rows(names, moved[0])
    for mass, motion in zip(loops.masses, moved, strict=True):
        rows.inertia(motion, mass)
    for j in AXES:
        turning = float(q.axis[j] @ ROCKING)
        about_centre = q.arm_inertia[j] - q.arm_mass[j] * q.arm_center[j] ** 2
        rows.inertia(rows.row(**{f"theta_{j + 1}": 1.0, "rock": turning}), about_centre)
        ratio = q.gear_ratio[j]
        rows.inertia(rows.row(**{f"phi_{j + 1}": ratio, "rock": turning}), q.motor_inertia[j])
    rows.inertia(rows.row(rock=1.0), ROCKING_INERTIA)
    loops.weigh(hanging)
    columns = []
    for unit in np.eye(10):
        column = np.zeros(10)
        for k, weight in FOURTH:
            for sign in (1, -1):
                column += sign * weight / OWN_STEP * loops.weight_gradient(sign * k * OWN_STEP * unit)
        columns.append(column)
    hessian = np.array(columns)
    own = [*range(9), 12]
    rows.weights[np.ix_(own, own)] = (hessian + hessian.T) / 2
    return rows


class Loops:
    """Point masses of a rotary delta: the platform first, then the arm and the link's points of each axis.

    Coordinates are displacements of theta_1..3, phi_1..3 and delta_1..3.
    """

    def __init__(self, q: Any, p: np.ndarray, payload: float) -> None:
        self.q, self.p, self.theta = q, np.asarray(p, dtype=float), arm_angles(q, p)
        each = [[q.arm_mass[j], *(share * q.link_mass[j] for _, share in ROD)] for j in AXES]
        self.masses = np.array([q.platform_mass + payload, *np.ravel(each)])
        self.weighing = self.masses.copy()

    def weigh(self, hanging: float) -> None:
        """Add the weight of a mass at the platform."""
        self.weighing[0] += hanging

    def _rays(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        angles, square = (self.theta + x[:3])[:, None], np.cross(self.q.axis, self.q.zero)
        ray = np.cos(angles) * self.q.zero + np.sin(angles) * square
        return ray, -np.sin(angles) * self.q.zero + np.cos(angles) * square

    def platform(self, x: np.ndarray) -> np.ndarray:
        """Compute the platform centre at which the links close."""
        ends = self.q.origin + self.q.arm_length[:, None] * self._rays(x)[0]
        lengths, platform = self.q.link_length + x[6:9], self.p.copy()
        for _ in range(30):
            links = platform + self.q.joint - ends
            step = np.linalg.solve(2 * links, np.sum(links**2, axis=1) - lengths**2)
            platform = platform - step
            if np.abs(step).max() < 1e-15:
                break
        return platform

    def points(self, x: np.ndarray) -> np.ndarray:
        """Return the positions of all points relative to the frame."""
        ray, platform = self._rays(x)[0], self.platform(x)
        points = [platform]
        for j in AXES:
            points.append(self.q.origin[j] + self.q.arm_center[j] * ray[j])
            first, last = self.q.origin[j] + self.q.arm_length[j] * ray[j], platform + self.q.joint[j]
            points += [first + part * (last - first) for part, _ in ROD]
        return np.array(points)

    def jacobians(self, x: np.ndarray) -> np.ndarray:
        """Return the velocities of all points per velocity of the nine coordinates."""
        ray, ahead = self._rays(x)
        ends = self.q.origin + self.q.arm_length[:, None] * ray
        links = self.platform(x) + self.q.joint - ends
        moved = np.zeros((3, 3, 9))  # ends of the arms
        for j in AXES:
            moved[j, :, j] = self.q.arm_length[j] * ahead[j]
        right = np.einsum("ji,jik->jk", links, moved)
        right[:, 6:9] += np.diag(self.q.link_length + x[6:9])
        platform = np.linalg.solve(links, right)
        velocities = [platform]
        for j in AXES:
            velocities.append(moved[j] * self.q.arm_center[j] / self.q.arm_length[j])
            velocities += [moved[j] + part * (platform - moved[j]) for part, _ in ROD]
        return np.array(velocities)

    def weight_gradient(self, x: np.ndarray) -> np.ndarray:
        """Compute the gradient of the gravity potential in the nine coordinates and the rocking angle."""
        turn = _rotation(ROCKING, x[9])
        pull = turn.T @ self.q.gravity
        by_nine = -np.einsum("m,i,mik->k", self.weighing, pull, self.jacobians(x))
        moment = self.weighing @ (self.points(x) - FLOOR)
        return np.append(by_nine, -self.q.gravity @ np.cross(ROCKING, turn @ moment))


def _rotation(axis: np.ndarray, angle: float) -> np.ndarray:
    cross = np.cross(np.eye(3), axis).T  # cross @ v is axis x v
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
