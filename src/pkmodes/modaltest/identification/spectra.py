r"""Frequencies from power spectra without phase, whose lines may be far apart.

Klipper's spectra have lines 1.6 Hz apart, from averaged windowed pieces of a sweep.  The width of a peak is then that
of the window as much as that of the mode, so that no damping is found.  Around each peak of the sum over directions,
the power of a mode of one degree of freedom over a flat background,

.. math:: P(f) = \frac{a\, f^n / (f + f_0)^2}{1 + (f - f_0)^2 / w^2} + b ,

is fitted to a few lines, one mode at a time.  The slow factor depends on what drives the machine: n = 4 for a force
that is as strong at all frequencies, 2 for motors that sweep with an acceleration proportional to the frequency, as
Klipper's, and 0 for a constant one.  The spectrum does not show which; n = 2 is taken, and the change that the others
would make is part of the standard deviation.  A spectrum from averages has relative errors, so that logarithms are
fitted.  The standard deviation is at least 0.29 of the distance of the lines, that of a uniform error of a line:
other modes, which the same force drives, shift a peak coherently, and without phase this cannot be seen.  The model
is that of Brandt (Noise and Vibration Analysis, Wiley, 2011) for an accelerance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.clusters import HIGHEST_DAMPING
from pkmodes.modaltest.identification.estimates import Estimate, Mode, Stabilisation
from pkmodes.modaltest.identification.requested_modes import (
    MAX_SHIFT,
    NO_EDITS,
    RequestedModes,
    index_to_replace,
    near_request,
)

Array = NDArray[np.float64]
#: Minimum standard deviation in line spacings.
MIN_SIGMA = 0.29
#: Power of the frequency in the slow factor, and its minimum and maximum.
SLOPE, SLOPE_LIMITS = 2, (0, 4)
#: Lines on either side of a peak that are fitted.
SIDE_LINES = 4
#: Largest median of the absolute second difference of ln P over the lines: 1.34 for a single record with Hann's
#: window and 1.95 without one, 0.85 for two averages with it, 0.4 for ten; peaks span too few lines to matter.
MAX_SCATTER = 1.1
#: Minimum ratio of a peak to the higher of the two lowest points between it and higher power on either side.
MIN_PROMINENCE = 1.6
#: Minimum height of a peak that the user requests, relative to the background it stands on.
MIN_REQUESTED_HEIGHT = 0.25
#: Minimum power of a mode, relative to the highest in the band.
MIN_POWER = 3e-3


@dataclass(frozen=True)
class _Peak:
    frequency: float
    sigma: float
    height: float
    width: float
    floor: float


def identify_spectrum(
    frequencies: Array, power: Array, *, band: tuple[float, float], edits: RequestedModes = NO_EDITS
) -> tuple[Estimate, tuple[str, ...]]:
    """Identify frequencies from power spectra.

    - frequencies: ascending, (F,) [Hz]
    - power: power spectral densities of S responses, at any scale, (F, S)
    - band: where modes are wanted [Hz]
    - edits: modes that the user adds: a maximum of any height near the frequency suffices

    Returns, in this order:
    - the estimate: poles are imaginary, as no damping is known, shapes and their standard deviations NaN; the
      functions are the spectra, (F, S, 1)
    - messages about findings other than modes

    Raises MeasurementError if the band has fewer than eight lines, or the spectrum is that of a single record without
    averages.
    """
    in_band = (frequencies >= band[0]) & (frequencies <= band[1])
    f, P = frequencies[in_band], np.asarray(power, float)[in_band]
    if len(f) < 8:
        raise MeasurementError(
            f"expected at least eight lines between {band[0]:g} and {band[1]:g} Hz, found {len(f)}",
            "band",
            "widen it, or measure with a finer resolution",
        )
    _check_averaged(P)
    total = P.sum(axis=1)
    peaks = [_fit_peak(f, total, k) for k in _prominent_maxima(total)]
    merged_peaks, messages = _merge_peaks(
        [peak for peak in peaks if peak is not None], float(np.median(np.diff(f)))
    )
    added = tuple(_fit_requested(f, total, target) for target in edits.add)
    added_peaks = [peak for peak in added if isinstance(peak, _Peak)]
    for peak in added_peaks:
        replaced_index = index_to_replace(
            [kept_peak.frequency for kept_peak in merged_peaks], edits, peak.frequency
        )
        if replaced_index is not None:
            del merged_peaks[replaced_index]
    modes = tuple(_to_mode(peak, P.shape[1]) for peak in merged_peaks)
    stabilisation = Stabilisation(np.zeros(0, np.int64), ())
    fitted_power = np.array([_peak_density(f, peak) - peak.floor for peak in (*merged_peaks, *added_peaks)])
    fitted_power = fitted_power.reshape(len(merged_peaks) + len(added_peaks), len(f)).sum(axis=0)
    share = P / np.where(total > 0.0, total, 1.0)[:, None]
    synthesised = (fitted_power[:, None] * share)[:, :, None].astype(complex)
    added_modes = tuple(
        candidate if isinstance(candidate, str) else _to_mode(candidate, P.shape[1]) for candidate in added
    )
    return Estimate(
        modes, stabilisation, f, P[:, :, None].astype(complex), synthesised, added_modes
    ), messages


def _fit_requested(f: Array, total: Array, target: float) -> _Peak | str:
    """Return the peak fitted to the maximum nearest to a frequency, or why there is none."""
    inner_lines = np.arange(1, len(total) - 1)
    maxima = inner_lines[
        (total[inner_lines] > total[inner_lines - 1]) & (total[inner_lines] >= total[inner_lines + 1])
    ]
    for k in sorted(maxima, key=lambda k: abs(f[k] - target)):
        if abs(f[k] - target) > MAX_SHIFT * target + 0.5 * (f[k + 1] - f[k - 1]):
            break
        peak = _fit_peak(f, total, int(k))
        if (
            peak is not None
            and near_request(peak.frequency, target)
            and peak.height > MIN_REQUESTED_HEIGHT * peak.floor
        ):
            return peak
    return "the spectrum has no peak within 3 % of it"


def _check_averaged(P: Array) -> None:
    """Refuse spectra (F, S) whose neighbouring lines scatter as those of a single record."""
    nonzero_spectra = P[:, (P > 0.0).all(axis=0)]
    scatter = np.median(np.abs(np.diff(np.log(nonzero_spectra), 2, axis=0))) if nonzero_spectra.size else 0.0
    if scatter > MAX_SCATTER:
        raise MeasurementError(
            "expected an averaged spectrum, found lines that scatter as those of a single record do",
            "band",
            "average over ten pieces of the record or more: the peaks of a single one are not modes",
        )


def _prominent_maxima(total: Array) -> list[int]:
    """Return the lines that are prominent maxima."""
    maxima = []
    for k in range(1, len(total) - 1):
        if total[k] <= MIN_POWER * total.max() or total[k] < total[k - 1] or total[k] <= total[k + 1]:
            continue
        higher = np.flatnonzero(total > total[k])
        higher_before, higher_after = higher[higher < k], higher[higher > k]
        left_min = total[(higher_before[-1] if higher_before.size else 0) : k].min()
        right_min = total[k + 1 : (higher_after[0] + 1 if higher_after.size else len(total))].min()
        if total[k] > MIN_PROMINENCE * max(left_min, right_min):
            maxima.append(k)
    return maxima


def _peak_density(f: Array, peak: _Peak, slope: int = SLOPE) -> Array:
    slow_factor = (f / peak.frequency) ** slope * (2.0 * peak.frequency / (f + peak.frequency)) ** 2
    return np.asarray(
        peak.height * slow_factor / (1.0 + ((f - peak.frequency) / peak.width) ** 2) + peak.floor
    )


def _fit_peak(f: Array, total: Array, k: int) -> _Peak | None:
    """Return the peak around line k, None if it is not a mode."""
    indices = slice(max(k - SIDE_LINES, 0), k + SIDE_LINES + 1)
    f_fit, P_fit, step = f[indices], total[indices], float(f[min(k + 1, len(f) - 1)] - f[k - 1]) / 2.0

    def peak(p: Array) -> _Peak:
        return _Peak(float(p[0]), 0.0, math.exp(p[1]), math.exp(p[2]), math.exp(p[3]))

    # the least width is about half a line: narrower peaks are not resolved
    log_top, log_lowest = math.log(total[k]), math.log(max(P_fit.min(), 1e-9 * total[k]))
    start = np.array([f[k], log_top, math.log(step), log_lowest - 0.5])
    lower_bounds = [f[k] - step, log_top - 3.0, math.log(0.3 * step), log_lowest - 20.0]
    upper_bounds = [f[k] + step, log_top + 5.0, math.log(8.0 * step), log_top + 1.0]

    def misfit(p: Array, slope: int) -> Array:
        return np.asarray(
            np.log(_peak_density(f_fit, peak(p), slope)) - np.log(np.maximum(P_fit, 1e-9 * total[k]))
        )

    def solve(slope: int) -> Any:
        return least_squares(misfit, start, bounds=(lower_bounds, upper_bounds), args=(slope,))

    result = solve(SLOPE)
    best = peak(result.x)
    if best.width > HIGHEST_DAMPING * best.frequency and best.width > 2.0 * step:
        return None
    freedom = max(len(f_fit) - 4, 1)
    jacobian = np.asarray(result.jac)
    covariance = np.linalg.pinv(jacobian.T @ jacobian) * 2.0 * result.cost / freedom
    smallest, largest = sorted(float(solve(slope).x[0]) for slope in SLOPE_LIMITS)
    uniform = (largest - smallest) / math.sqrt(12.0)
    sigma = math.hypot(MIN_SIGMA * step, min(math.sqrt(max(covariance[0, 0], 0.0)), step), uniform)
    return _Peak(best.frequency, sigma, best.height, best.width, best.floor)


def _merge_peaks(peaks: list[_Peak], step: float) -> tuple[list[_Peak], tuple[str, ...]]:
    """Return the peaks with those closer than a line merged, and messages about the ones dropped."""
    distinct: list[_Peak] = []
    messages: list[str] = []
    for peak in sorted(peaks, key=lambda candidate: -candidate.height):
        merged_into = [earlier for earlier in distinct if abs(earlier.frequency - peak.frequency) < step]
        if merged_into:
            messages.append(
                f"peaks at {peak.frequency:.4g} and {merged_into[0].frequency:.4g} Hz are closer than a line: one row"
            )
        else:
            distinct.append(peak)
    return sorted(distinct, key=lambda peak: peak.frequency), tuple(messages)


def _to_mode(peak: _Peak, sensors: int) -> Mode:
    pole = complex(0.0, 2.0 * math.pi * peak.frequency)  # the size is what is known
    return Mode(pole, np.full(sensors, complex(math.nan, math.nan)), peak.sigma, math.nan, math.nan, (1, 1))
