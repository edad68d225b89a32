r"""Maximum-likelihood frequency and damping, from the spectral lines around each mode.

Correlations use a record poorly: errors of frequency and damping from subspace identification are three to five times
the least possible ones, and their standard deviations are as uncertain as those errors.  The lines of a stationary
record are independent and their power is exponentially distributed about the spectral density P, so that

.. math:: -\log L = \sum_f \log P(f) + I(f) / P(f)

(Whittle, Arkiv foer Matematik 2, 1953; for modes: Au, Mechanical Systems and Signal Processing 25(1), 2011).  I is
the power of the modal coordinate, which the shapes of the subspace identification separate from its neighbours.  P is
a peak for each mode and a background.  A peak is the expected periodogram of the decaying correlation over the length
of the record, which resolves light damping (Sykulski et al., Biometrika 106(2), 2019), times the slow factor
omega^4 / (omega + omega_d)^2 of an acceleration: without it, frequencies are off by twice the square of the damping
ratio.  The inverse of the Fisher information is the covariance of the estimate.

The response of other modes to the same force adds to a peak coherently: |r / s + c|^2 has an odd part Im(1 / s)
besides.  It would shift the frequency, and is fitted too; in noise, with a prior of its size.

Decays and sweeps are not random: their I follows P smoothly.  The peak is then that of an infinite record, and the
mean square of I / P - 1, times the number of lines over which it is correlated, replaces the exponential
distribution in the covariance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Variance of I / P below which the response is a transient: it is 1 for noise.
MAX_TRANSIENT_SCATTER = 0.25
#: Largest odd part of a peak relative to the even one.
MAX_ODD_PART = 2.0
#: Prior standard deviation of the odd part if the response is to noise, which mostly drives several modes.
ODD_PART_PRIOR = 0.2
#: Maximum number of iterations, and the change of the log-likelihood that ends them.
MAX_STEPS, CONVERGED_CHANGE = 40, 1e-4
#: Minimum decay rate, relative to the inverse of the record length.
MIN_RATE = 1e-2


@dataclass(frozen=True, eq=False)
class Powers:
    """Power of a modal coordinate on the lines of all pieces.

    - frequencies: in Hz, (F,)
    - values: values of a spectral density, at any scale, (F,)
    - seconds: length of the piece of each line, (F,)
    """

    frequencies: Array
    values: Array
    seconds: Array


@dataclass(frozen=True, eq=False)
class PeakFit:
    """Peaks of a modal coordinate.

    - frequencies, rates: frequencies of the damped vibrations [Hz], and rates of decay [1/s], (m,)
    - covariance: covariance of frequency and logarithm of the rate, (m, 2, 2)
    - likelihood: the log-likelihood
    - scatter: variance of I / P: 1 for noise
    - density: P, (F,)
    """

    frequencies: Array
    rates: Array
    covariance: Array
    likelihood: float
    scatter: float
    density: Array


def fit_peaks(powers: Powers, frequencies: Sequence[float], rates: Sequence[float]) -> PeakFit:
    """Return the maximum-likelihood fit of peaks and a background whose logarithm is linear in frequency.

    - frequencies, rates: where to start [Hz], [1/s]
    """
    fit = _fit(powers, frequencies, rates, False)
    if fit.scatter < MAX_TRANSIENT_SCATTER:
        fit = _fit(powers, fit.frequencies.tolist(), fit.rates.tolist(), True)
    return fit


def _fit(powers: Powers, frequencies: Sequence[float], rates: Sequence[float], transient: bool) -> PeakFit:
    m, power = len(frequencies), powers.values
    ends = powers.frequencies[[0, -1]]
    middle, half_range = float(ends.mean()), float(0.5 * np.ptp(ends))
    x = (powers.frequencies - middle) / half_range
    level = math.log(np.median(power) + 1e-300)
    heights = [
        math.log(power[np.argsort(np.abs(powers.frequencies - f))[:3]].mean() + 1e-300) for f in frequencies
    ]
    p = np.array([*frequencies, *np.log(rates), *heights, level - 0.7, 0.0, *([0.0] * m)])
    low = np.array([ends[0]] * m + [math.log(MIN_RATE / powers.seconds.max())] * m + [level - 40.0] * m)
    high = np.array([ends[1]] * m + [math.log(2.0 * math.pi * half_range)] * m + [level + 40.0] * m)
    odd_limits = [MAX_ODD_PART] * m
    low = np.concatenate([low, [level - 40.0, -5.0], [-limit for limit in odd_limits]])
    high = np.concatenate([high, [level + 40.0, 5.0], odd_limits])
    p = np.clip(p, low, high)
    density, slopes = _density(p, m, powers, x, transient)
    prior = np.zeros(len(p))
    prior[3 * m + 2 :] = 0.0 if transient else ODD_PART_PRIOR**-2
    value, damping = _likelihood(power, density) - 0.5 * float(prior @ p**2), 1e-3
    for _ in range(MAX_STEPS):
        gradient = slopes.T @ (power / density - 1.0) - prior * p
        fisher = slopes.T @ slopes + np.diag(prior)
        scale = np.diag(fisher) + 1e-9
        step = np.linalg.solve(fisher + np.diag(damping * scale + 1e-9), gradient)
        step[:m] = np.clip(step[:m], -0.3 * half_range, 0.3 * half_range)
        step[m:] = np.clip(step[m:], -1.5, 1.5)
        trial = np.clip(p + step, low, high)
        new_density, new_slopes = _density(trial, m, powers, x, transient)
        new_value = _likelihood(power, new_density) - 0.5 * float(prior @ trial**2)
        if new_value > value:
            converged = new_value - value < CONVERGED_CHANGE
            p, density, slopes, value, damping = (
                trial,
                new_density,
                new_slopes,
                new_value,
                max(damping / 5.0, 1e-6),
            )
            if converged:
                break
        elif damping > 1e4:
            break
        else:
            damping *= 10.0
    relative = power / density
    scatter = 0.5 * float(np.mean(np.diff(relative) ** 2)) if len(relative) > 1 else 1.0
    fisher = slopes.T @ slopes + np.diag(prior)
    covariance = np.linalg.pinv(fisher + 1e-9 * np.diag(np.diag(fisher) + 1e-12), hermitian=True)
    covariance *= _correlated_square(relative - 1.0) if transient else 1.0
    parameter_pairs = np.arange(m)[:, None] + np.array([0, m])
    return PeakFit(
        p[:m],
        np.exp(p[m : 2 * m]),
        covariance[parameter_pairs[:, :, None], parameter_pairs[:, None, :]],
        value,
        scatter,
        density,
    )


def _correlated_square(misfit: Array) -> float:
    """Return the mean square of a misfit times the number of lines over which it is correlated."""
    products = np.correlate(misfit, misfit, "full")[len(misfit) - 1 :] / len(misfit)
    non_positive = np.flatnonzero(products <= 0.0)
    reach = int(non_positive[0]) if non_positive.size else len(products)
    return float(products[0] + 2.0 * products[1:reach].sum())


def _likelihood(power: Array, density: Array) -> float:
    return -float(np.sum(np.log(density) + power / density))


def _density(p: Array, m: int, powers: Powers, x: Array, transient: bool) -> tuple[Array, Array]:
    """Return P (F,) and the derivatives of its logarithm by the parameters (F, P)."""
    background = np.exp(p[3 * m] + p[3 * m + 1] * x)
    total, slopes = background.copy(), np.empty((len(x), len(p)))
    slopes[:, 3 * m], slopes[:, 3 * m + 1] = background, background * x
    for j in range(m):
        detuning = 2.0 * math.pi * (powers.frequencies - p[j])
        rate, height = math.exp(p[m + j]), math.exp(p[2 * m + j])
        s = rate + 1j * detuning
        if transient:
            peak, slope_by_s = rate / s, -rate / s**2
        else:
            T = powers.seconds
            end_decay = np.exp(-s * T)
            peak = rate * (1.0 / s - (1.0 - end_decay) / (s**2 * T))
            slope_by_s = rate * (-1.0 / s**2 - end_decay / s**2 + 2.0 * (1.0 - end_decay) / (s**3 * T))
        factor = height * (powers.frequencies / p[j]) ** 4 * (2.0 * p[j] / (powers.frequencies + p[j])) ** 2
        slopes[:, 3 * m + 2 + j] = factor * -peak.imag
        skew = 1.0 + 1j * p[3 * m + 2 + j]
        peak, slope_by_s = skew * peak, skew * slope_by_s
        slope_by_frequency = -2.0 / p[j] - 2.0 / (powers.frequencies + p[j])
        total += factor * peak.real
        slopes[:, 2 * m + j] = factor * peak.real
        slopes[:, m + j] = factor * (peak.real + slope_by_s.real * rate)
        slopes[:, j] = factor * ((slope_by_s * -2j * math.pi).real + slope_by_frequency * peak.real)
    total = np.maximum(total, 1e-6 * powers.values.max() + 1e-300)  # the odd part may exceed the even one
    return total, slopes / total[:, None]
