"""Refinement of candidates: groups of modes are fitted in turn, and candidates that are no modes are dropped.

Modes that overlap are a group, and are fitted to the lines around them.  A candidate is dropped if

- its fit does not converge, or leaves the band or the range of damping of a mode;
- it is a copy of a neighbour: nearer than half of a bandwidth and with nearly the same shape.  Copies appear at a
  peak that no single mode fits exactly, or whose frequency differs between references;
- its energy could be that of noise.  The energy of a mode, relative to the noise of each channel, has a gamma
  distribution if there is only noise, with as many degrees of freedom as channels; and the search has tried each line
  (a matched filter over many places: Kay, Fundamentals of Statistical Signal Processing, Vol. 2, 1998, section 7.6).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import gamma

from pkmodes.modaltest.identification.clusters import HIGHEST_DAMPING
from pkmodes.modaltest.identification.estimates import complex_mac
from pkmodes.modaltest.identification.frf_covariance import (
    Uncertainty,
    channel_covariance,
    fit_uncertainty,
    poles_by_reference,
    removed_columns,
    residual,
    variance_between_groups,
)
from pkmodes.modaltest.identification.frf_lines import FrequencyLines
from pkmodes.modaltest.identification.frf_noise import line_sigma, residual_correlation
from pkmodes.modaltest.identification.frf_polish import Window, WindowFit, make_window, polish
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Modes closer than this multiple of the sum of their half bandwidths are fitted together.
OVERLAP = 4.0
#: Lines up to this many half bandwidths from a mode are used: 94 % of the information about its pole is within 10.
REACH_HALF_WIDTHS = 10.0
#: but at least this many lines on each side, so that noise can be distinguished from the smooth part,
MIN_SIDE_LINES = 24
#: and at most this many in a window: a mode over more lines is determined equally well by every second or third.
MAX_WINDOW_LINES = 400
#: Maximum number of sweeps: the fits of neighbours settle in two or three, and each dropped mode needs another.
MAX_SWEEPS = 10
#: Relative change of the poles in a sweep, in units of their damping, below which the fits have settled.
SETTLED_CHANGE = 1e-3
#: Probability that noise alone produces a mode somewhere in a measurement.
FALSE_ALARM = 0.01
#: Number of damping ratios that a search resolves at each line.
DAMPING_TRIALS = 4
#: A copy: closer than this fraction of a bandwidth, with shapes of at least this MAC.
COPY_DISTANCE, COPY_MAC = 0.5, 0.9


def group_overlapping(poles: Complex) -> list[NDArray[np.int64]]:
    """Return the indices of modes to be fitted together, each group by ascending frequency."""
    order = np.argsort(poles.imag)
    grouped: list[list[int]] = []
    for i in order:
        if grouped and any(
            abs(poles[i].imag - poles[k].imag) < OVERLAP * (abs(poles[i].real) + abs(poles[k].real))
            for k in grouped[-1]
        ):
            grouped[-1].append(int(i))
        else:
            grouped.append([int(i)])
    return [np.array(group) for group in grouped]


def lines_around(frequencies: Array, poles: Complex) -> NDArray[np.int64]:
    """Return the indices of the lines (F,) [Hz] for a group of modes."""
    centres, half_widths = poles.imag / (2.0 * math.pi), np.abs(poles.real) / (2.0 * math.pi)
    is_near = np.zeros(len(frequencies), bool)
    for centre, half_width in zip(centres, half_widths, strict=True):
        middle = int(np.searchsorted(frequencies, centre))
        is_near[max(middle - MIN_SIDE_LINES, 0) : middle + MIN_SIDE_LINES] = True
        is_near |= np.abs(frequencies - centre) <= REACH_HALF_WIDTHS * half_width
    line_indices = np.flatnonzero(is_near)
    line_indices = np.arange(line_indices[0], line_indices[-1] + 1)
    missing = 2 * MIN_SIDE_LINES - len(line_indices)
    if missing > 0:  # at an end of the band
        first = max(int(line_indices[0]) - missing, 0)
        line_indices = np.arange(first, min(first + 2 * MIN_SIDE_LINES, len(frequencies)))
    return line_indices[:: max(1, len(line_indices) // MAX_WINDOW_LINES)]


@dataclass(frozen=True, eq=False)
class GroupFit:
    """The fit of a group of modes: its members, window and lines."""

    members: NDArray[np.int64]
    window: Window
    grid_index: NDArray[np.int64]
    lines: NDArray[np.int64]
    fit: WindowFit


def refine(
    data: FrequencyLines, initial_modes: IdentifiedModes, low: float, high: float
) -> tuple[IdentifiedModes, Uncertainty]:
    """Return the modes that remain of candidates, with the uncertainty of their fit.

    - initial_modes: candidates; their shapes are not used
    - low, high: range of frequencies that a mode may have [Hz]
    """
    threshold = energy_threshold(data)
    modes, has_settled = initial_modes, False
    for _ in range(MAX_SWEEPS):
        previous = modes
        fits, modes = _sweep(data, modes)
        # Fits that failed, or left the range of frequency or damping of a mode.
        frequency, damping = modes.frequencies, -modes.poles.real / np.abs(modes.poles)
        dropped = (frequency < low) | (frequency > high) | (damping <= 0.0) | (damping > HIGHEST_DAMPING)
        for fitted in fits:
            dropped[fitted.members] |= not np.isfinite(fitted.fit.cost)
        if not dropped.any():
            uncertainty = _uncertainties(data, modes, fits)
            dropped = _redundant_mask(modes, uncertainty.strength, fits, threshold)
            has_settled = bool(
                (np.abs(modes.poles - previous.poles) < SETTLED_CHANGE * np.abs(modes.poles.real)).all()
            )
        if dropped.any():
            modes = modes.select(~dropped)
            if not len(modes.poles):
                break
        elif has_settled:
            return modes, _add_reference_scatter(modes, uncertainty, fits)
    if not len(modes.poles):
        empty, S = np.zeros(0), data.H.shape[1]
        return modes, Uncertainty(np.zeros((0, 2)), np.zeros((0, S, S), complex), empty)
    fits, modes = _sweep(data, modes)
    return modes, _add_reference_scatter(modes, _uncertainties(data, modes, fits), fits)


def fit_until_settled(
    data: FrequencyLines, initial_modes: IdentifiedModes
) -> tuple[IdentifiedModes, Uncertainty]:
    """Return modes fitted until they no longer change, none of them dropped, with the uncertainty of their fit."""
    modes = initial_modes
    for _ in range(MAX_SWEEPS):
        previous = modes
        fits, modes = _sweep(data, modes)
        if (np.abs(modes.poles - previous.poles) < SETTLED_CHANGE * np.abs(modes.poles.real)).all():
            break
    return modes, _add_reference_scatter(modes, _uncertainties(data, modes, fits), fits)


def _add_reference_scatter(
    modes: IdentifiedModes, uncertainty: Uncertainty, fits: list[GroupFit]
) -> Uncertainty:
    """Return uncertainties including the scatter between references, for modes that several of them see."""
    (N, R), magnitude = modes.participation.shape, np.abs(modes.poles)
    if R < 2:
        return uncertainty
    poles, variances = np.full((R, N), np.nan, complex), np.full((R, N), np.nan)
    for fitted in fits:
        poles[:, fitted.members], variances[:, fitted.members] = poles_by_reference(fitted.window, fitted.fit)
    pooled_modes = [m for m in range(N) if np.isfinite(variances[:, m]).sum() >= 2]
    sigmas = uncertainty.poles.copy()
    for component in range(2):
        values, relative_variances = [], []
        for m in pooled_modes:
            finite = np.isfinite(variances[:, m])
            variance = variances[finite, m]
            # The variances of one fit, with its correlations.
            variance = variance * sigmas[m, component] ** 2 * (1.0 / variance).sum()
            reference_poles = poles[finite, m]
            values.append((reference_poles.real if component == 0 else reference_poles.imag) / magnitude[m])
            relative_variances.append(variance / magnitude[m] ** 2)
        between_variance = variance_between_groups(values, relative_variances)
        reference_counts = np.maximum(np.isfinite(variances).sum(axis=0), 1)
        sigmas[:, component] = np.sqrt(
            sigmas[:, component] ** 2 + between_variance * magnitude**2 / reference_counts
        )
    return replace(uncertainty, poles=sigmas)


def energy_threshold(
    data: FrequencyLines, false_alarm: float = FALSE_ALARM, lines: int | None = None
) -> float:
    """Return the relative energy that noise alone exceeds with a given probability over lines, all by default."""
    trial_count = DAMPING_TRIALS * (len(data.frequencies) if lines is None else lines)
    return float(gamma.isf(false_alarm / trial_count, max(int(data.measured.sum()), 1)))


def _sweep(data: FrequencyLines, modes: IdentifiedModes) -> tuple[list[GroupFit], IdentifiedModes]:
    """Fit each group in turn, with the latest fits of the others subtracted."""
    fits = []
    poles, shapes, participations = modes.poles.copy(), modes.shapes.copy(), modes.participation.copy()
    for members in group_overlapping(poles):
        fitted = fit_group(data, IdentifiedModes(poles, shapes, participations), members)
        poles[members], shapes[members] = fitted.fit.poles, fitted.fit.shapes
        participations[members] = fitted.fit.participation
        fits.append(fitted)
    return fits, IdentifiedModes(poles, shapes, participations)


def fit_group(data: FrequencyLines, modes: IdentifiedModes, members: NDArray[np.int64]) -> GroupFit:
    """Fit some of the modes to the lines around them, with the others subtracted."""
    poles = modes.poles
    lines = lines_around(data.frequencies, poles[members])
    H = subtract_other_modes(data, modes, members, lines)
    variance = data.variance[lines].mean(axis=0)
    window = make_window(data.frequencies[lines], H, _inverse_variance(variance), np.ones(len(lines)))
    fit = polish(window, poles[members], modes.participation[members])
    remainder = residual(window, fit)
    squares = (np.abs(remainder) ** 2).sum(axis=0) / max(
        len(window.s) - removed_columns(window, fit).shape[1], 1
    )
    noise = np.where(window.weights > 0.0, np.maximum(squares, 1e-12 * np.abs(variance)), np.nan)
    weights = _inverse_variance(noise)
    measured = weights > 0.0
    scale = np.sqrt(weights[measured])
    sigma = line_sigma(remainder[:, measured] * scale, (data.H[lines] - remainder)[:, measured] * scale)
    window = make_window(data.frequencies[lines], H, weights, sigma)
    return GroupFit(
        members, window, data.grid_index[lines], lines, polish(window, fit.poles, fit.participation)
    )


def subtract_other_modes(
    data: FrequencyLines,
    modes: IdentifiedModes,
    members: NDArray[np.int64],
    lines: NDArray[np.int64] | NDArray[np.bool_],
) -> Complex:
    """Return the functions at some lines without the other modes, and without the conjugates of all modes."""
    other_indices = np.setdiff1d(np.arange(len(modes.poles)), members)
    s, residues = 2j * math.pi * data.frequencies[lines][:, None], modes.residues
    H = data.H[lines] - np.tensordot(1.0 / (s - modes.poles[other_indices]), residues[other_indices], 1)
    return np.asarray(H - np.tensordot(1.0 / (s - modes.poles.conj()), residues.conj(), 1))


def _inverse_variance(variance: Array) -> Array:
    return np.where(np.isfinite(variance), 1.0 / np.where(variance > 0.0, variance, np.inf), 0.0)


def _uncertainties(data: FrequencyLines, modes: IdentifiedModes, fits: list[GroupFit]) -> Uncertainty:
    """Return the uncertainty of each fit, from the noise in its residual, correlated from line to line."""
    correlation = data.correlation
    if correlation is None:
        relative = [residual(fitted.window, fitted.fit) * np.sqrt(fitted.window.weights) for fitted in fits]
        correlation = residual_correlation(
            [
                remainder[:, fitted.window.weights > 0.0]
                for remainder, fitted in zip(relative, fits, strict=True)
            ],
            [fitted.grid_index for fitted in fits],
            [removed_columns(fitted.window, fitted.fit) for fitted in fits],
        )
    N, S = modes.shapes.shape
    poles, shapes, strength = np.empty((N, 2)), np.empty((N, S, S), complex), np.empty(N)
    for fitted in fits:
        channels = channel_covariance(fitted.window, fitted.fit, fitted.grid_index, correlation)
        if data.has_absolute_variance:
            # Variances are raised to at least those of the lines; correlations are kept.
            variance = np.nan_to_num(data.variance[fitted.lines].mean(axis=0)).ravel()
            own_variance = channels.diagonal().real
            factor = np.sqrt(np.maximum(variance / np.maximum(own_variance, 1e-300), 1.0))
            factor = np.where(own_variance > 0.0, factor, 1.0)
            channels = channels * np.outer(factor, factor)
        group_uncertainty = fit_uncertainty(
            fitted.window, fitted.fit, channels, fitted.grid_index, correlation
        )
        poles[fitted.members], shapes[fitted.members] = group_uncertainty.poles, group_uncertainty.shapes
        strength[fitted.members] = group_uncertainty.strength
    return Uncertainty(poles, shapes, strength)


def _redundant_mask(
    modes: IdentifiedModes, strength: Array, fits: list[GroupFit], threshold: float
) -> NDArray[np.bool_]:
    """Return the weaker ones of copies, and the weakest mode of each group if it is not significant.

    Without that one, its neighbours become stronger.
    """
    drop = np.zeros(len(modes.poles), bool)
    for fitted in fits:
        weakest = fitted.members[np.argmin(strength[fitted.members])]
        drop[weakest] = strength[weakest] < threshold
        for a, i in enumerate(fitted.members):
            for k in fitted.members[:a]:
                if are_copies(modes, i, k):
                    drop[i if strength[i] < strength[k] else k] = True
    return drop


def are_copies(modes: IdentifiedModes, i: int, k: int, max_distance: float = COPY_DISTANCE) -> bool:
    """Return whether two modes are closer than a fraction of a bandwidth and so similar that they may be one."""
    width_sum = abs(modes.poles[i].real) + abs(modes.poles[k].real)
    close = abs(modes.poles[i].imag - modes.poles[k].imag) < max_distance * width_sum
    return bool(close and complex_mac(modes.shapes[i], modes.shapes[k]) > COPY_MAC)
