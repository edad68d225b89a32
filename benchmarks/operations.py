"""Floating-point operations of the compiled evaluator, counted by formula, and the rotations of QL, by running it.

Sums, differences, products, quotients and roots count one each; comparisons, selections, signs and memory nothing.
"""

from __future__ import annotations

import json
import math
from importlib.resources import files

import numpy as np
from scipy.linalg import hessenberg

from published import published

#: Operations of a rotation without vectors, and of Wilkinson's shift (src/pkmodes/core/compiled/eigen.h).
ROTATION, SHIFT = 19, 9


def of_matrices() -> int:
    """M and K, checks and joint positions: what the manifest of the generated code says."""
    text = files(published().mechanism.package).joinpath("manifest.json").read_text(encoding="utf-8")
    counts = json.loads(text)["operations"]
    return counts["lanes_base"]["emitted"] + counts["lanes_position"]["emitted"]


def of_reduction(n: int) -> int:
    """Scale, Cholesky factor, and the two triangular reductions of K: about 4/3 n^3."""
    scale = 2 * n + 2 * n * (n + 1)
    factor = sum(2 * j + 2 + (n - 1 - j) * (2 * j + 1) for j in range(n))
    right = sum((n - j) * (2 * j + 1) for j in range(n))
    left = sum(2 * i + 1 for j in range(n) for i in range(j, n))
    return scale + factor + right + left


def of_tridiagonal(n: int) -> int:
    """Householder reflections: about 4/3 n^3."""
    sizes = range(n - 1, 1, -1)
    return sum(2 * (m - 1) + 6 + 2 * m * m + 3 * m + 2 + 2 * m + 2 * m * (m + 1) for m in sizes)


def of_iteration(iterations: float, rotations: float, width: int = 0) -> float:
    """QL, turning vectors of a width with it."""
    return SHIFT * iterations + (ROTATION + 6 * width) * rotations


def of_vectors(n: int) -> int:
    """L^-T times the reflections."""
    return n**3 // 3 + sum(n * (4 * m + 1) for m in range(n - 1, 1, -1))


def rotations_of(poses: np.ndarray, together: int) -> tuple[float, float, float]:
    """Run the implicit QL method on the poses and count.

    Parameters
    ----------
    poses : ndarray, shape (N, 3)
    together : int
        Poses that are iterated together: each waits for the slowest.

    Returns
    -------
    iterations, rotations, rotations_together : float
        Per pose, alone, and the rotations that it takes part in if it is not alone.
    """
    M, K = published().matrices(poses)
    scale = 1.0 / np.sqrt(np.diagonal(M, axis1=1, axis2=2))
    both = scale[:, :, None] * scale[:, None]
    inverse = np.linalg.inv(np.linalg.cholesky(M * both))
    sweeps = [_sweeps(hessenberg(A)) for A in inverse @ (K * both) @ np.swapaxes(inverse, 1, 2)]
    groups = [sweeps[i : i + together] for i in range(0, len(sweeps) - together + 1, together)]
    slowest = []
    for group in groups:
        keys = {key for one in group for key in one}
        slowest.append(sum(max(one.get(key, 0) for one in group) for key in keys))
    alone = [sum(one.values()) for one in sweeps]
    return float(np.mean([len(one) for one in sweeps])), float(np.mean(alone)), float(np.mean(slowest))


def _sweeps(H: np.ndarray) -> dict[tuple[int, int], int]:
    """Return the rotations of each sweep, by eigenvalue and iteration."""
    n = len(H)
    d, e = np.diag(H).tolist(), [*np.diag(H, -1).tolist(), 0.0]
    found: dict[tuple[int, int], int] = {}
    for i in range(n - 1):
        iteration = 0
        while True:
            end = next(
                (k for k in range(i, n - 1) if abs(e[k]) <= 2.2e-16 * (abs(d[k]) + abs(d[k + 1]))), n - 1
            )
            if end == i:
                break
            found[i, iteration] = end - i
            iteration += 1
            _sweep(d, e, i, end)
    return found


def _sweep(d: list[float], e: list[float], first: int, end: int) -> None:
    half = (d[first + 1] - d[first]) / (2.0 * e[first])
    g = d[end] - d[first] + e[first] / (half + math.copysign(math.hypot(half, 1.0), half))
    s = c = 1.0
    p = 0.0
    for i in range(end - 1, first - 1, -1):
        f, b = s * e[i], c * e[i]
        r = math.hypot(f, g)
        e[i + 1] = r
        s, c = f / r, g / r
        h = d[i + 1] - p
        t = (d[i] - h) * s + 2.0 * c * b
        p = s * t
        d[i + 1] = h + p
        g = c * t - b
    d[first] -= p
    e[first], e[end] = g, 0.0
