"""Scatter of the poles between references: what one reference's residual cannot show.

A mode that is not at the same place for all references, since the structure or its sensors have changed in between,
leaves each reference with a good fit of its own.  Poles are therefore fitted for each reference alone as well.  What
their scatter exceeds that of their fits by, pooled over all modes relative to frequency as there are only two or
three references, is a variance between references (Paule and Mandel, Journal of Research of the National Bureau of
Standards 87, 1982).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.identification.frf_polish import Fit, Window, basis, polish

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: A reference whose mode is this much weaker than at its best reference says nothing about it.
WEAK = 0.05
#: The variance is sought below the square of this relative difference.
LARGEST = 0.1


def by_reference(at: Window, fit: Fit) -> tuple[Complex, Array]:
    """Return the poles of each reference alone, (R, N) [1/s], NaN where unknown, and their variances (R, N)."""
    (N, R), S = fit.participation.shape, fit.shapes.shape[1]
    poles, variances = np.full((R, N), np.nan, complex), np.full((R, N), np.nan)
    for r in range(R):
        weights = np.zeros((S, R))
        weights[:, r] = at.weights[:, r]
        alone = replace(at, H=at.H[..., r : r + 1], weights=weights[:, r : r + 1])
        if not weights.any() or (np.abs(fit.participation[:, r]) < WEAK).any():
            continue
        one = polish(alone, fit.poles, np.ones((N, 1), complex))
        if not one.converged or (np.abs(one.poles - fit.poles) > np.abs(fit.poles.real)).any():
            continue
        E = basis(at, one.poles)
        for m in range(N):
            others = np.delete(E, N + m, axis=1)
            left = E[:, N + m] - others @ np.linalg.lstsq(others, E[:, N + m], rcond=1e-12)[0]
            energy = float((weights[:, r] * np.abs(one.shapes[m]) ** 2).sum())
            variances[r, m] = 0.5 / max(energy * float(np.vdot(left, left).real), 1e-300)
        poles[r] = one.poles
    return poles, variances


def between(values: Sequence[Array], variances: Sequence[Array]) -> float:
    """Return the variance between groups, beyond their own variances, pooled over several quantities.

    Parameters
    ----------
    values, variances : sequence of ndarray, shape (k,)
        Of each quantity, k of at least 2.

    References
    ----------
    Paule and Mandel 1982.
    """
    freedom = sum(len(one) - 1 for one in values)

    def excess(more: float) -> float:
        total = 0.0
        for value, variance in zip(values, variances, strict=True):
            weights = 1.0 / (variance + more)
            total += float((weights * (value - (weights @ value) / weights.sum()) ** 2).sum())
        return total - freedom

    if not freedom or excess(0.0) <= 0.0:
        return 0.0
    low, high = 0.0, LARGEST**2
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return high
