"""Mass and stiffness matrices in 60 digits, for any mechanism that says where its bodies are.

A mechanism gives what its contract (mechanisms.md, effects.md) says and nothing else: positions of particles as
functions of all coordinates, inertias that turn, and energies.  Everything else is differences: Jacobians of the
positions, the mass matrix from them, Hessians of the energies.  No formula of the derivation is used.

Accuracy.  With 60 digits and a step of 1e-12, a first or second difference errs by 1e-24 of truncation, and by
1e-48 and 1e-36 of rounding.  Truncation is smooth in the parameters, so that a further difference by a
parameter, with the same step, errs by 1e-24 again: all far below the 1e-16 of a double.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import mpmath
import numpy as np

DIGITS = 60
# A context of its own: the precision of mpmath.mp belongs to whoever else uses it.
mp = mpmath.mp.clone()
mp.dps = DIGITS
STEP = mp.mpf(10) ** -12
# The last Newton step, a few orders above the rounding of 60 digits; convergence is quadratic there.
CONVERGED = mp.mpf(10) ** -54

Number = Any  # mpmath publishes no types
Vector = Sequence[Number]
Values = dict[str, Any]

# Gauss-Legendre on [0, 1] with three points: exact to degree 5, and the energy density of a rod has degree 2.
_REACH = mp.sqrt(mp.mpf(3) / 5) / 2
GAUSS = (
    (mp.mpf(1) / 2 - _REACH, mp.mpf(5) / 18),
    (mp.mpf(1) / 2, mp.mpf(8) / 18),
    (mp.mpf(1) / 2 + _REACH, mp.mpf(5) / 18),
)


def exact(value: Any) -> Any:
    """Doubles to mpf without rounding, nested tuples for arrays; mpf as they are."""
    if isinstance(value, mp.mpf):
        return value
    if np.ndim(value) == 0:
        return mp.mpf(float(value))
    return tuple(exact(row) for row in value)


def exact_values(values: Mapping[str, Any]) -> Values:
    return {name: exact(value) for name, value in values.items()}


def shifted(values: Values, field: str, index: tuple[int, ...], change: Number) -> Values:
    """The same with one number changed."""

    def moved(value: Any, index: tuple[int, ...]) -> Any:
        if not index:
            return value + change
        first, *rest = index
        return tuple(moved(v, tuple(rest)) if i == first else v for i, v in enumerate(value))

    return {**values, field: moved(values[field], index)}


def dot(a: Vector, b: Vector) -> Number:
    return mp.fdot(zip(a, b, strict=True))


def cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a: Vector, b: Vector) -> Vector:
    return [x + y for x, y in zip(a, b, strict=True)]


def minus(a: Vector, b: Vector) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def combine(a: Vector, factor: Number, b: Vector) -> Vector:
    """Vector a + factor b."""
    return [x + factor * y for x, y in zip(a, b, strict=True)]


def solve_three(rows: Sequence[Vector], right: Vector) -> Vector:
    """Three linear equations by Cramer's rule: at 60 digits its cancellation does not matter."""
    planes = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])]
    determinant = dot(rows[0], planes[0])
    return [dot(right, [plane[i] for plane in planes]) / determinant for i in range(3)]


class Particle(NamedTuple):
    """A mass at a place, in whatever frame its velocity counts in."""

    mass: Number
    position: Vector


class Turning(NamedTuple):
    """A moment of inertia, and its angle by the coordinates."""

    inertia: Number
    angle: Mapping[int, int]


class HighPrecision:
    """A robot at a pose: subclasses say where its parts are and what energies it has.

    Displacements q of all coordinates, released ones included, count from the pose.
    """

    coordinates: tuple[str, ...]
    #: How many coordinates the base model has, how many of these the pose determines; the drives' come after.
    base: int
    independent: int

    def particles(self, q: Vector) -> list[Particle]:
        raise NotImplementedError

    def turning(self) -> list[Turning]:
        raise NotImplementedError

    def platform(self, q: Vector) -> Vector:
        """Absolute position of the platform."""
        raise NotImplementedError

    def weight(self, q: Vector) -> Number:
        """Potential energy of gravity."""
        raise NotImplementedError

    def transmission(self, q: Vector) -> Number:
        """Energy of belts or reducers, unstrained at q = 0."""
        raise NotImplementedError

    def other_springs(self, q: Vector) -> Number:
        """Energy of the springs that effects add, but for the released joints' own."""
        raise NotImplementedError

    # Differences

    @property
    def size(self) -> int:
        return len(self.coordinates)

    def at(self, **displacements: Number) -> Vector:
        return [displacements.get(name, mp.mpf(0)) for name in self.coordinates]

    def columns(self, positions: Callable[[Vector], Sequence[Vector]]) -> list[list[Vector]]:
        """Derivatives of several positions by each coordinate: [coordinate][position][component]."""
        found: list[list[Vector]] = []
        for name in self.coordinates:
            ahead, behind = positions(self.at(**{name: STEP})), positions(self.at(**{name: -STEP}))
            pairs = zip(ahead, behind, strict=True)
            found.append([[(u - v) / (2 * STEP) for u, v in zip(a, b, strict=True)] for a, b in pairs])
        return found

    def gradient(self, energy: Callable[[Vector], Number]) -> list[Number]:
        return [row[0][0] for row in self.columns(lambda q: [[energy(q)]])]

    def hessian(self, energy: Callable[[Vector], Number]) -> np.ndarray:
        """Second differences along each coordinate, and along each pair for the mixed ones."""
        n, h = self.size, STEP
        here = energy(self.at())

        def curvature(*names: str) -> Number:
            ahead, behind = (energy(self.at(**dict.fromkeys(names, step))) for step in (h, -h))
            return (ahead - 2 * here + behind) / h**2

        single = [curvature(name) for name in self.coordinates]
        H = np.empty((n, n), dtype=object)
        for i in range(n):
            H[i, i] = single[i]
            for j in range(i):
                both = curvature(self.coordinates[i], self.coordinates[j])
                H[i, j] = H[j, i] = (both - single[i] - single[j]) / 2
        return H

    # What is compared

    def mass_matrix(self) -> np.ndarray:
        """Sum of m J^T J over the particles, and of the inertias that turn."""
        masses = [particle.mass for particle in self.particles(self.at())]
        J = self.columns(lambda q: [particle.position for particle in self.particles(q)])
        M = np.empty((self.size, self.size), dtype=object)
        for i in range(self.size):
            for j in range(i + 1):
                terms = zip(masses, J[i], J[j], strict=True)
                M[i, j] = M[j, i] = mp.fsum(m * dot(a, b) for m, a, b in terms)
        for inertia, angle in self.turning():
            for i, a in angle.items():
                for j, b in angle.items():
                    M[i, j] += inertia * a * b
        return M

    def gravity_hessian(self) -> np.ndarray:
        return self.hessian(self.weight)

    def elastic_hessian(self) -> np.ndarray:
        return self.hessian(lambda q: self.transmission(q) + self.other_springs(q))

    def platform_motion(self) -> np.ndarray:
        """Derivatives of the platform's absolute position, shape (components, coordinates)."""
        columns = self.columns(lambda q: [self.platform(q)])
        return np.array([column[0] for column in columns], dtype=object).T

    def static_equilibrium(self) -> tuple[np.ndarray, np.ndarray]:
        """Torques on the drives, and the displacements of the drives that strain the transmissions so much.

        Force balance at the pose: gravity and transmissions at the coordinates that the pose determines, and the
        torques beside them at the drives.
        """
        n, end = self.independent, self.base
        G = self.gradient(self.weight)
        strain = self.hessian(self.transmission)
        displacements = mp.lu_solve(mp.matrix(strain[:n, n:end].tolist()), -mp.matrix(G[:n]))
        torques = mp.matrix(strain[n:end, n:end].tolist()) * displacements + mp.matrix(G[n:end])
        return np.array(list(torques), dtype=object), np.array(list(displacements), dtype=object)


class Reference(NamedTuple):
    """What the generated functions should return, as doubles."""

    M: np.ndarray
    K_el: np.ndarray
    K_g: np.ndarray
    platform: np.ndarray
    torques: np.ndarray
    displacements: np.ndarray


class Compared:
    """Doubles of what an oracle finds, computed once."""

    def __init__(self, oracle: HighPrecision) -> None:
        self.oracle = oracle

    @cached_property
    def reference(self) -> Reference:
        it = self.oracle
        found = (
            it.mass_matrix(),
            it.elastic_hessian(),
            it.gravity_hessian(),
            it.platform_motion(),
            *it.static_equilibrium(),
        )
        return Reference(*(array.astype(float) for array in found))
