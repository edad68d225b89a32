r"""Noise of frequency responses: from differences of neighbouring lines, from coherence, and its correlation.

The H1 estimate of n averages has the variance

.. math:: \sigma_H^2 = |H|^2 \frac{1 - \gamma^2}{\gamma^2 (n - 1)}

per line (Bendat and Piersol, Random Data, 4th edition, 2010, section 9.1.4, with the n - 1 degrees of freedom that
the estimated coherence leaves).  Without coherence, the third difference of neighbouring lines cancels what is smooth
and leaves 20 times the variance; its median is not affected by narrow peaks.

An exponential window exp(-t/tau) on a response that is as noisy at its end as at its beginning correlates the noise
of neighbouring lines: their covariance is the Fourier transform of the window's square.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Parts of the band in which the noise is estimated, as it may vary over the band like the force.
BAND_PARTS = 12
#: Noise assumed for a function without any, relative to the mean square of a channel.
NOISE_FLOOR = 1e-16
#: Sum of squares of the coefficients 1, -3, 3, -1; and the median of |e|^2 for circular noise of unit variance.
DIFFERENCE_GAIN, MEDIAN_SQUARE = 20.0, math.log(2.0)
#: Noise coloured by overlapping or tapered blocks is correlated over two lines; a few more lags show other causes.
MAX_LAG = 5


def difference_variance(H: Complex) -> Array:
    """Return the variance of the noise of each line, (F, S, R), from third differences of the lines; NaN as in H.

    - H: F at least 8, (F, S, R)
    """
    F = len(H)
    squares = np.abs(np.diff(H, 3, axis=0)) ** 2 / (DIFFERENCE_GAIN * MEDIAN_SQUARE)
    part_count = max(1, min(BAND_PARTS, len(squares) // 16))
    blocks = np.array_split(np.arange(len(squares)), part_count)
    middles = np.array([block.mean() + 1.5 for block in blocks])
    medians = np.stack([np.median(squares[block], axis=0) for block in blocks]).reshape(part_count, -1)
    lines = np.arange(F)
    interpolated = np.stack([np.interp(lines, middles, column) for column in medians.T], axis=1).reshape(
        H.shape
    )
    floor = NOISE_FLOOR * (np.abs(H) ** 2).mean(axis=0)
    return np.asarray(np.where(np.isfinite(H), np.maximum(interpolated, np.maximum(floor, 1e-300)), np.nan))


def coherence_variance(H: Complex, coherence: Array, averages: int) -> Array:
    """Return the variance of the noise of each line, (F, S, R), of an H1 estimate.

    References
    ----------
    Bendat and Piersol 2010, section 9.1.4.
    """
    gamma_squared = np.clip(coherence, 1e-6, 1.0)
    return np.asarray(np.abs(H) ** 2 * (1.0 - gamma_squared) / (gamma_squared * max(averages - 1, 1)))


def exponential_correlation(step: float, tau: float, lags: int) -> Complex:
    """Return the correlation of the noise at lags 0 ... of lines, under an exponential window.

    - step: line spacing, the inverse of the length of the record [Hz]
    - tau: time constant of the window, that the responses were multiplied with [s]
    - lags: the highest lag
    """
    length = 1.0 / step
    rate = 2.0 / tau + 2j * math.pi * step * np.arange(lags + 1)
    values = (1.0 - np.exp(-rate * length)) / rate
    return np.asarray(values / values[0])


def line_sigma(residual: Complex, fit: Complex) -> Array:
    """Return the relative noise of each line, (F,), of variance a + b |fit|^2 with non-negative a and b, rms 1.

    Noise of the force, or of the gain, is proportional to the response: it is largest at the peak, which carries most
    of the information.

    - residual, fit: relative to the noise of each channel, (F, C)
    """
    squares, size = (np.abs(residual) ** 2).mean(axis=1), (np.abs(fit) ** 2).mean(axis=1)
    if not size.any() or not squares.any():
        return np.ones(len(residual))
    A = np.stack([np.ones(len(size)), size / size.max()], axis=1)
    variance = np.full(len(size), squares.mean())
    for _ in range(4):  # each line's square scatters by its own variance
        coefficients = nnls(A / variance[:, None], squares / variance)[0]
        variance = np.maximum(A @ coefficients, 1e-3 * squares.mean())
    return np.asarray(np.sqrt(variance / variance.mean()))


def residual_correlation(
    residuals: Sequence[Complex], grid_indices: Sequence[NDArray[np.int64]], removed_spaces: Sequence[Complex]
) -> Complex:
    """Return the correlation of the noise at lags 0 to `MAX_LAG` of lines, from the residuals of several fits.

    A fit removes the part of the noise that its columns span, which leaves negative correlation in its residual even
    if the noise has none.  That part is as strong as the slowly varying part of the noise, by which the correction is
    scaled.

    - residuals: relative to the noise of each channel, each (F, C)
    - grid_indices: indices of the lines on the grid, ascending, each (F,)
    - removed_spaces: orthonormal columns that each fit has removed, each (F, K)
    """
    sums, removed_sums, pairs = (
        np.zeros(MAX_LAG + 1, complex),
        np.zeros(MAX_LAG + 1, complex),
        np.zeros(MAX_LAG + 1),
    )
    for residual, grid_index, removed_space in zip(residuals, grid_indices, removed_spaces, strict=True):
        for lag in range(MAX_LAG + 1):
            later, earlier = _line_pairs(grid_index, lag)
            sums[lag] += (residual[later] * residual[earlier].conj()).sum()
            removed_sums[lag] += (
                residual.shape[1] * (removed_space[later] * removed_space[earlier].conj()).sum()
            )
            pairs[lag] += residual.shape[1] * len(earlier)
    if not len(residuals) or sums[0].real <= 0.0:
        return np.array([1.0] + [0.0] * MAX_LAG, complex)
    raw, removed = sums / np.maximum(pairs, 1.0), removed_sums / np.maximum(pairs, 1.0)
    correlation = raw / raw[0].real
    for _ in range(10):  # a contraction: each pass shrinks the change by the factor `removed`
        slow_power = max(1.0 + 2.0 * float((_taper(MAX_LAG) * correlation)[1:].real.sum()), 0.0)
        estimate = raw + slow_power * removed * raw[0].real / (1.0 - slow_power * removed[0].real)
        correlation = estimate / estimate[0].real
    return np.asarray(_taper(MAX_LAG) * correlation, dtype=complex)


def apply_correlation(functions: Complex, grid_index: NDArray[np.int64], correlation: Complex) -> Complex:
    """Return the correlation matrix of the lines (F, F) times functions (F, K)."""
    total = functions * correlation[0]
    for lag in range(1, len(correlation)):
        later, earlier = _line_pairs(grid_index, lag)
        total[later] += correlation[lag] * functions[earlier]
        total[earlier] += correlation[lag].conj() * functions[later]
    return np.asarray(total)


def _line_pairs(grid_index: NDArray[np.int64], lag: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the indices of the lines that have another one `lag` places before, and of those earlier lines."""
    earlier = np.searchsorted(grid_index, grid_index - lag)
    exists = grid_index[np.minimum(earlier, len(grid_index) - 1)] == grid_index - lag
    return np.flatnonzero(exists), earlier[exists].astype(np.int64)


def _taper(lags: int) -> Array:
    """Bartlett's window, which keeps the variance of every sum positive (Newey and West, Econometrica 55, 1987)."""
    return np.asarray(1.0 - np.arange(lags + 1) / (lags + 1.0))
