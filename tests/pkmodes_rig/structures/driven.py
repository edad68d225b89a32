"""Responses simulated exactly from mass, damping and stiffness matrices, to identify modes from.

The truth is that of the complex eigenproblem of the matrices.  Forces are held between samples, so that the matrix
exponential of the state space is exact; they are flat to 2 % in the lower fifth of the sampling rate, and the poles
of the samples are those of the system whatever the force.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig, expm

Array = NDArray[np.float64]
G = 9.80665


@dataclass(frozen=True)
class Structure:
    """Matrices (n, n), and the places of the forces."""

    M: Array
    C: Array
    K: Array
    driven: NDArray[np.intp]

    @property
    def state(self) -> tuple[Array, Array]:
        """Matrices A and B of the state space: displacements, then velocities."""
        n = len(self.M)
        inverse = np.linalg.inv(self.M)
        A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ self.K, -inverse @ self.C]])
        B = np.vstack([np.zeros((n, len(self.driven))), inverse[:, self.driven]])
        return A, B

    def modes(self) -> tuple[Array, Array, Array]:
        """Frequencies [Hz], damping ratios and real shapes (m, n) relative to their largest component."""
        values, vectors = eig(self.state[0])
        upper = values.imag > 0
        values, vectors = values[upper], vectors[: len(self.M), upper]
        order = np.argsort(np.abs(values))
        values, vectors = values[order], vectors[:, order]
        largest = vectors[np.argmax(np.abs(vectors), axis=0), np.arange(len(order))]
        shapes = np.real(vectors / largest).T
        return np.abs(values) / (2 * np.pi), -values.real / np.abs(values), shapes


def structure(
    frequencies: Array, ratios: Array, rng: np.random.Generator, driven: int | None = None
) -> Structure:
    """A random structure with given modes: M is random and definite, the shapes are real and orthogonal in M."""
    n = len(frequencies)
    root = rng.normal(size=(n, n)) * 0.2 + np.diag(rng.uniform(0.7, 1.5, n))
    M = root @ root.T
    Q, _ = np.linalg.qr(rng.normal(size=(n, n)))
    phi = np.linalg.solve(np.linalg.cholesky(M).T, Q)
    omega = 2 * np.pi * np.asarray(frequencies)
    back = M @ phi
    K = back @ np.diag(omega**2) @ back.T
    C = back @ np.diag(2 * np.asarray(ratios) * omega) @ back.T
    places = rng.permutation(n)[: driven or n]
    return Structure(M, C, K, places)


def random_structure(rng: np.random.Generator, driven: int | None = None, n: int = 6) -> Structure:
    """Six modes between 12 and 170 Hz, 3 % apart or more, with ratios between 0.3 and 3 %."""
    while True:
        f = np.sort(np.exp(rng.uniform(np.log(12.0), np.log(170.0), n)))
        if (np.diff(f) > 0.03 * f[:-1]).all():
            break
    return structure(f, np.exp(rng.uniform(np.log(0.003), np.log(0.03), n)), rng, driven)


def accelerations(system: Structure, force: Array, rate: float, state: Array | None = None) -> Array:
    """Accelerations (N, n) under forces (N, driven) that are held between samples."""
    A, B = system.state
    n = len(A)
    step = expm(np.block([[A, B], [np.zeros((B.shape[1], n + B.shape[1]))]]) / rate)
    values, vectors = np.linalg.eig(step[:n, :n])
    inputs = np.linalg.solve(vectors, step[:n, n:].astype(complex)) @ force.T
    x = np.linalg.solve(vectors, (np.zeros(n) if state is None else state).astype(complex))
    states = np.empty((len(force), n), dtype=complex)
    for k in range(len(force)):
        states[k] = x
        x = values * x + inputs[:, k]
    return np.asarray((states @ vectors.T).real @ A[n // 2 :].T + force @ B[n // 2 :].T)


def ambient(
    system: Structure,
    rng: np.random.Generator,
    seconds: float = 40.0,
    rate: float = 1000.0,
    noise: float = 0.05,
) -> Array:
    """Accelerations (N, n) under white noise, in the steady state, with sensor noise relative to each rms."""
    before = int(10 * rate)
    force = rng.normal(size=(before + int(seconds * rate), len(system.driven)))
    clean = accelerations(system, force, rate)[before:]
    return clean + noise * clean.std(axis=0) * rng.normal(size=clean.shape)


def decay(system: Structure, rng: np.random.Generator, seconds: float = 4.0, rate: float = 1000.0) -> Array:
    """Accelerations after a blow at the first driven place 0.1 s after the start, with 0.5 % noise."""
    force = np.zeros((int(seconds * rate), len(system.driven)))
    force[int(0.1 * rate), 0] = 1.0
    clean = accelerations(system, force, rate)
    return clean + 0.005 * clean[: int(rate)].std(axis=0) * rng.normal(size=clean.shape)


def sweep(system: Structure, rng: np.random.Generator, rate: float = 3200.0) -> Array:
    """Accelerations under a force whose frequency runs from 5 to 130 Hz at 1 Hz/s, with 2 % noise."""
    t = np.arange(int(127 * rate)) / rate
    phase = 2 * np.pi * (5.0 * t + 0.5 * t**2)
    force = np.where(t < 125.0, np.sin(phase), 0.0)[:, None] * np.ones(len(system.driven))
    clean = accelerations(system, force, rate)
    return clean + 0.02 * clean.std(axis=0) * rng.normal(size=clean.shape)


def adxl345(signals: Array, rng: np.random.Generator) -> Array:
    """What an ADXL345 makes of accelerations [mm/s^2]: noise of 200 mm/s^2, steps of 74 mm/s^2."""
    return np.round((signals + 200.0 * rng.normal(size=signals.shape)) / 74.0) * 74.0
