"""The 3-RRR of docs/how-to/adding-a-mechanism-that-turns.md by hand: positions at a pose, everything else by
differences.

Nothing here is shared with the derivation.  What moves is a function of the pose, the elongations of the links and
the displacement of the frame; all that the coordinates need is how the arms' angles depend on these.  Nothing is
solved but linear systems.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from helpers.references.five_bar_by_hand import POINTS, differentiated

#: Pose x, y, rz; elongations of the links; displacement of the frame along x, y.
POSE, LONGER, FRAME = slice(0, 3), slice(3, 6), slice(6, 8)


@dataclass(frozen=True)
class ThreeRRR:
    """A robot, its values as in the robot file, in SI units; effects are absent at 0."""

    mass: float
    centre: np.ndarray
    inertia: float
    gravity: np.ndarray
    origins: np.ndarray
    joints: np.ndarray
    branches: tuple[int, int, int]
    arm_length: float
    arm_mass: float
    link_length: float
    link_mass: float
    stiffness: float
    motor: float
    payload: float = 0.0
    offset: np.ndarray = field(default_factory=lambda: np.zeros(2))
    link_compliance: float = np.inf
    frame_compliance: float = np.inf
    frame_mass: float = 0.0

    def angles(self, v: np.ndarray) -> np.ndarray:
        """Angles of the arms, by the law of cosines."""
        found = []
        for origin, joint, longer, branch in zip(
            self.origins, self._turned(v, self.joints), v[LONGER], self.branches, strict=True
        ):
            r = joint - origin
            distance, length = np.hypot(*r), self.link_length + longer
            cosine = (self.arm_length**2 + distance**2 - length**2) / (2.0 * self.arm_length * distance)
            found.append(np.arctan2(r[1], r[0]) + branch * np.arccos(cosine))
        return np.asarray(found)

    def coordinates(self, v: np.ndarray) -> np.ndarray:
        """theta_1..3, then elongations and displacements."""
        return np.concatenate([self.angles(v), v[LONGER], v[FRAME]])

    def masses(self, v: np.ndarray) -> list[tuple[float, np.ndarray]]:
        """Every mass as points; the inertia of the platform as two masses on either side of its centre."""
        half, radius = self.mass / 2, np.sqrt(self.inertia / self.mass)
        on_platform = self.centre + radius * np.array([[0.6, 0.8], [-0.6, -0.8]])
        found = [(half, x) for x in self._turned(v, on_platform)]
        found.append((self.payload, self._turned(v, self.offset)))
        angles = self.angles(v)
        elbows = self.origins + self.arm_length * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        for origin, elbow, joint in zip(self.origins, elbows, self._turned(v, self.joints), strict=True):
            for place, weight in POINTS:
                found.append((weight * self.arm_mass, origin + place * (elbow - origin)))
                found.append((weight * self.link_mass, elbow + place * (joint - elbow)))
        return [(mass, x + v[FRAME]) for mass, x in found]

    def matrices(self, pose: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """M and K for theta_1..3, phi_1..3, delta_1..3, u_x, u_y."""
        at = np.concatenate([pose, np.zeros(5)])
        back = np.linalg.inv(differentiated(self.coordinates, at))  # of v by the coordinates
        velocities = differentiated(lambda v: np.stack([x for _, x in self.masses(v)]), at) @ back
        weights = np.array([mass for mass, _ in self.masses(at)])
        moving = np.einsum("n,nik,nil->kl", weights, velocities, velocities)
        moving[6:, 6:] += self.frame_mass * np.eye(2)
        falling = differentiated(self.forces, at) @ back
        springs = np.diag([0.0] * 3 + [1 / self.link_compliance] * 3 + [1 / self.frame_compliance] * 2)
        M, K = np.zeros((11, 11)), np.zeros((11, 11))
        others = [0, 1, 2, *range(6, 11)]
        M[np.ix_(others, others)], K[np.ix_(others, others)] = moving, falling + springs
        M[3:6, 3:6] += self.motor * np.eye(3)
        K[:6, :6] += self.stiffness * np.kron([[1, -1], [-1, 1]], np.eye(3))
        return M, K

    def forces(self, v: np.ndarray) -> np.ndarray:
        """What holds the pose against gravity, conjugate to the coordinates: first the torques of the motors."""
        return np.linalg.solve(
            differentiated(self.coordinates, v).T, differentiated(lambda w: self._weight(w), v)
        )

    def _weight(self, v: np.ndarray) -> np.ndarray:
        return -np.sum([mass * self.gravity @ x for mass, x in self.masses(v)], axis=0)

    def _turned(self, v: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        x, y, angle = v[POSE]
        c, s = np.cos(angle), np.sin(angle)
        return np.array([x, y]) + vectors @ np.array([[c, s], [-s, c]])
