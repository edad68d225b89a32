"""The five-bar of docs/how-to/adding-a-mechanism.md by hand: positions and energies, derivatives by differences.

Nothing here is shared with the derivation: two circles meet where the tool is, the rods are cut into points, and what
is differentiated is differentiated numerically.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

#: Steps of central differences, in radians, and their weights: eighth order.
STEP = 4e-3
WEIGHTS = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
#: A uniform rod as points: Gauss, exact for squares.
POINTS = ((0.5 - 0.5 / np.sqrt(3.0), 0.5), (0.5 + 0.5 / np.sqrt(3.0), 0.5))


@dataclass(frozen=True)
class FiveBar:
    """A robot, its values as in the robot file, in SI units."""

    tool: float
    gravity: np.ndarray
    origins: np.ndarray
    branches: tuple[int, int]
    arm_length: float
    arm_mass: float
    link_length: float
    link_mass: float
    stiffness: tuple[float, float]
    inertia: float

    def angles(self, tool: np.ndarray) -> np.ndarray:
        """Angles of the arms, by the law of cosines."""
        found = []
        for origin, branch in zip(self.origins, self.branches, strict=True):
            r = np.asarray(tool) - origin
            distance = np.hypot(*r)
            cosine = (self.arm_length**2 + distance**2 - self.link_length**2) / (
                2.0 * self.arm_length * distance
            )
            # The arm is ahead of the direction to the tool, counterclockwise, or behind it.
            found.append(np.arctan2(r[1], r[0]) + branch * np.arccos(cosine))
        return np.asarray(found)

    def elbows(self, angles: np.ndarray) -> np.ndarray:
        return self.origins + self.arm_length * np.stack([np.cos(angles), np.sin(angles)], axis=-1)

    def tool_at(self, angles: np.ndarray, near: np.ndarray) -> np.ndarray:
        """Where the two links meet: of two points the one that is nearer."""
        a, b = self.elbows(angles)
        middle, apart = 0.5 * (a + b), b - a
        height = np.sqrt(self.link_length**2 - 0.25 * apart @ apart)
        normal = np.array([-apart[1], apart[0]]) / np.linalg.norm(apart)
        both = [middle + side * height * normal for side in (1.0, -1.0)]
        return min(both, key=lambda point: float(np.linalg.norm(point - near)))

    def masses(self, angles: np.ndarray, near: np.ndarray) -> list[tuple[float, np.ndarray]]:
        """Every mass as points."""
        tool, elbows = self.tool_at(angles, near), self.elbows(angles)
        found = [(self.tool, tool)]
        for origin, elbow in zip(self.origins, elbows, strict=True):
            for place, weight in POINTS:
                found.append((weight * self.arm_mass, origin + place * (elbow - origin)))
                found.append((weight * self.link_mass, elbow + place * (tool - elbow)))
        return found

    def matrices(self, tool: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """M and K for the coordinates theta_1, theta_2, phi_1, phi_2."""
        at = self.angles(tool)
        positions = differentiated(lambda q: np.stack([x for _, x in self.masses(q, tool)]), at)
        weights = np.array([mass for mass, _ in self.masses(at, tool)])
        M = np.zeros((4, 4))
        M[:2, :2] = np.einsum("n,nik,nil->kl", weights, positions, positions)
        M[2:, 2:] = self.inertia * np.eye(2)
        K = np.zeros((4, 4))
        K[:2, :2] = differentiated(lambda q: differentiated(lambda w: self.weight(w, tool), q), at)
        springs = np.diag(self.stiffness)
        return M, K + np.block([[springs, -springs], [-springs, springs]])

    def weight(self, angles: np.ndarray, near: np.ndarray) -> np.ndarray:
        """Potential energy of gravity."""
        return -np.sum([mass * self.gravity @ x for mass, x in self.masses(angles, near)], axis=0)

    def torques(self, tool: np.ndarray) -> np.ndarray:
        """What the motors hold against gravity, positive with their angles."""
        return differentiated(lambda q: self.weight(q, tool), self.angles(tool))

    def jacobian(self, tool: np.ndarray) -> np.ndarray:
        return differentiated(lambda q: self.tool_at(q, tool), self.angles(tool))

    def modes(self, tool: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Frequencies [Hz] with the sign of the eigenvalue, and shapes, one row for each mode."""
        M, K = self.matrices(tool)
        root = np.linalg.cholesky(M)
        half = np.linalg.solve(root, K)
        eigenvalues, vectors = np.linalg.eigh(np.linalg.solve(root, half.T))
        shapes = np.linalg.solve(root.T, vectors).T
        return np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2.0 * np.pi), shapes


def differentiated(function: Callable[[np.ndarray], np.ndarray], at: np.ndarray) -> np.ndarray:
    """Central differences of eighth order; the index of the derivative is the last one."""
    columns = []
    for unit in np.eye(len(at)):
        terms = (
            w * (function(at + k * STEP * unit) - function(at - k * STEP * unit)) for k, w in WEIGHTS.items()
        )
        columns.append(sum(terms) / STEP)
    return np.stack(columns, axis=-1)
