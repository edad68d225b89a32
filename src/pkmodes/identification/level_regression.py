r"""Regression of a frequency on the level of the vibration.

.. math:: f = c_0 + c_1 \ln a + c_2 a^2

holds for joints, which slip over a wide range of amplitudes (the logarithm), and for stiffening or softening springs
(the square: the backbone curve of Duffing's equation).  Segments scatter by their noise, which is known, and by what
neighbours and the excitation add, which is estimated (Paule and Mandel, Journal of Research of the National Bureau of
Standards 87, 1982).  The frequency changes if the last two terms reduce the sum of squares by more than scatter does,
by an F test.  Probabilities are those of one mode.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import f as fisher

Array = NDArray[np.float64]

#: Probability that the scatter of a linear mode is taken for a change.
FALSE_ALARM = 1e-4
#: The change must go on, to this probability, after the first part of the fall of the logarithmic level: what a blow
#: or the force of a sweep adds at the beginning of a decay moves the frequency there only.
FIRST, LATER = 0.3, 0.01
#: Least relative change of a frequency that is reported: less is below what neighbours leave in a band-pass.
LEAST = 1e-4
#: Relative noise of the frequency of a segment at least.
ROUNDING = 1e-9


@dataclass(frozen=True)
class LevelShift:
    """A frequency that changes with the level.

    Attributes
    ----------
    high, low : float
        Frequency at the highest and at the lowest level [Hz].
    fall : float
        Ratio of these levels.
    """

    high: float
    low: float
    fall: float

    @property
    def spread(self) -> float:
        """Range of the frequency [Hz]."""
        return abs(self.high - self.low)


@dataclass(frozen=True, eq=False)
class Segments:
    """Segments of a decay, (n,).

    Attributes
    ----------
    frequency : ndarray
        Less that of the mode [Hz].
    variance : ndarray
        By the noise [Hz^2].
    level : ndarray
        Logarithm of the amplitude.
    """

    frequency: Array
    variance: Array
    level: Array


def shift_over(f0: float, decays: Sequence[Segments]) -> LevelShift | None:
    """Return the change of a frequency f0 [Hz] over all decays, None if their scatter explains it."""
    if not decays:
        return None
    level, frequency, variance = (
        np.concatenate([getattr(one, name) for one in decays]) for name in ("level", "frequency", "variance")
    )
    variance = np.maximum(variance, (ROUNDING * f0) ** 2)  # signals without noise
    highest, lowest = float(level.max()), float(level.min())
    chance, found = _regression(level, frequency, variance, highest)
    later = level < highest - FIRST * (highest - lowest)
    again, of_later = _regression(level[later], frequency[later], variance[later], highest)
    ends = _laws(np.array([highest, highest - FIRST * (highest - lowest), lowest]), highest)
    high, middle, low = f0 + ends @ found
    shift = LevelShift(float(high), float(low), math.exp(highest - lowest))
    same = (middle - low) * float(np.diff(ends[[2, 1]] @ of_later)[0]) > 0.0
    sure = chance < FALSE_ALARM and again < LATER and same
    return shift if sure and shift.spread > LEAST * f0 else None


def _regression(level: Array, frequency: Array, variance: Array, highest: float) -> tuple[float, Array]:
    """Return the probability that scatter explains the regression, and its coefficients."""
    laws = _laws(level, highest)
    terms, freedom = laws.shape[1] - 1, len(level) - laws.shape[1]
    if freedom < 1:
        return 1.0, np.zeros(laws.shape[1])
    variance = variance + _excess(laws, frequency, variance)
    constant = _squares(laws[:, :1], frequency, variance)[0]
    left, found = _squares(laws, frequency, variance)
    return float(fisher.sf((constant - left) / terms / max(left / freedom, 1e-300), terms, freedom)), found


def _laws(level: Array, highest: float) -> Array:
    """Return 1, ln a and a^2 relative to the highest level, (n, 3)."""
    above = level - highest
    return np.stack([np.ones(len(level)), above, np.exp(2.0 * above)], axis=1)


def _squares(A: Array, b: Array, variance: Array) -> tuple[float, Array]:
    """Return the weighted sum of squares that a fit leaves, and its coefficients."""
    scale = 1.0 / np.sqrt(variance)
    found = np.linalg.lstsq(A * scale[:, None], b * scale, rcond=None)[0]
    return float((((b - A @ found) * scale) ** 2).sum()), np.asarray(found)


def _excess(A: Array, b: Array, variance: Array) -> float:
    """Return the variance of segments beyond that of their noise.

    References
    ----------
    Paule and Mandel 1982.
    """
    freedom = len(b) - A.shape[1]
    if _squares(A, b, variance)[0] <= freedom:
        return 0.0
    low, high = 0.0, float(np.ptp(b) ** 2)
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _squares(A, b, variance + middle)[0] > freedom else (low, middle)
    return high
