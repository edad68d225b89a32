"""Structures with known modes, and their frequency responses solved line by line from mass, damping and stiffness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.signal import StateSpace, lsim

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Structure:
    """Proportionally damped: the truth is exact."""

    M: Array
    C: Array
    K: Array
    frequencies: Array
    damping: Array
    shapes: Array  # (n, n), columns

    def response(self, frequencies: Array, outputs: list[int], inputs: list[int], power: int) -> Complex:
        """Solve (K - w^2 M + j w C) x = f at each line."""
        w = 2.0 * np.pi * frequencies[:, None, None]
        forces = np.eye(len(self.M))[:, inputs].astype(complex)
        x = np.linalg.solve(
            self.K - w**2 * self.M + 1j * w * self.C, np.tile(forces, (len(frequencies), 1, 1))
        )
        return np.asarray((1j * w) ** power * x[:, outputs])


def structure(frequencies: Array, damping: Array, rng: np.random.Generator) -> Structure:
    """Build matrices of a structure with random mass-normalised modes."""
    n = len(frequencies)
    phi = np.linalg.qr(rng.standard_normal((n, n)))[0] @ np.diag(rng.uniform(0.7, 1.4, n))
    back = np.linalg.inv(phi)
    w = 2.0 * np.pi * np.asarray(frequencies)
    M = back.T @ back
    C = back.T @ np.diag(2.0 * np.asarray(damping) * w) @ back
    K = back.T @ np.diag(w**2) @ back
    return Structure(M, C, K, np.asarray(frequencies, float), np.asarray(damping, float), phi)


def random_structure(
    rng: np.random.Generator, modes: int = 6, lo: float = 20.0, hi: float = 380.0
) -> Structure:
    """Frequencies at random, at least 3 % apart, damping from 0.3 to 3 %, and two modes above the band."""
    while True:
        f = np.sort(rng.uniform(lo, hi, modes))
        if np.all(np.diff(f) > 0.03 * f[1:]):
            break
    f = np.concatenate([f, [1.3 * hi, 1.8 * hi]])
    return structure(f, np.exp(rng.uniform(np.log(0.003), np.log(0.03), len(f))), rng)


def noise(rng: np.random.Generator, like: Complex, sigma: Array | float) -> Complex:
    """Complex circular noise of standard deviation sigma (of the complex number)."""
    parts = rng.standard_normal((2, *like.shape))
    return np.asarray(sigma * (parts[0] + 1j * parts[1]) / np.sqrt(2.0))


def mac(a: Complex, b: Complex) -> float:
    """Return the modal assurance criterion of two shapes (S,)."""
    return float(abs(np.vdot(a, b)) ** 2 / (np.vdot(a, a).real * np.vdot(b, b).real))


def impact(
    s: Structure, outputs: list[int], at: int, power: int, rate: float, length: float, start: float = 0.02
) -> tuple[Array, Array]:
    """Return the force of a blow (N,) and the responses (N, S), exact for a force linear between samples."""
    n = len(s.M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(s.M, s.K), -np.linalg.solve(s.M, s.C)]])
    B = np.concatenate([np.zeros(n), np.linalg.inv(s.M)[:, at]])[:, None]
    rows = np.block([[np.eye(n), np.zeros((n, n))], [np.zeros((n, n)), np.eye(n)], [A[n:]]])
    feed = np.concatenate([np.zeros(2 * n), B[n:, 0]])[:, None]
    pick = [power * n + k for k in outputs]
    t = np.arange(round(length * rate)) / rate
    width = 0.002
    force = np.where((t >= start) & (t <= start + width), np.sin(np.pi * (t - start) / width), 0.0)
    system: Any = StateSpace(A, B, rows[pick], feed[pick])
    y = lsim(system, force, t)[1]
    return force, np.asarray(y).reshape(len(t), -1)
