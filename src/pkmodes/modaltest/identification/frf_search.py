r"""Search for modes in the residual of a fit: weak ones on which the poles of no model order settle.

Matched filters for a single mode, 1/(j omega - lambda) without its smooth part, at every line and for several
dampings; the energies of the channels, each relative to its noise, add up (Kay, Fundamentals of Statistical Signal
Processing, Vol. 2, 1998, sections 7.4 and 7.6).  Where strong modes are, the residual holds their model errors as
well as noise: a few per cent of the fit at each line are taken for noise.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.signal import fftconvolve

from pkmodes.modaltest.identification.clusters import HIGHEST_DAMPING
from pkmodes.modaltest.identification.frf_lines import FrequencyLines
from pkmodes.modaltest.identification.frf_noise import MEDIAN, PARTS, correlated
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Half bandwidths tried, in line spacings: a filter loses 0.5 dB for a mode between two of them.
HALF_WIDTHS = (0.35, 0.7, 1.4, 2.8, 5.6, 11.0, 22.0)
#: Lines of a filter on each side: in half bandwidths, and the fewest.
REACH, FEWEST = 6, 20
#: Coefficients of the smooth part of each filter, as in the fit.
SMOOTH = 3
#: A residual below this fraction of the fit may be its model error: a nonlinearity, a window, a calibration.
MODEL_ERROR = 0.05


def hidden(data: FrequencyLines, fit: Complex, least: float) -> Complex:
    """Return starting poles of modes in a residual, (N,) [1/s], the strongest of each neighbourhood.

    - fit: response of the modes so far, (F, S, R)
    - least: least energy relative to noise
    """
    frequencies, place, measured = data.frequencies, data.place, data.measured
    residual, fit = (data.H - fit)[:, measured], fit[:, measured]
    correlation = np.ones(1, complex) if data.correlation is None else data.correlation
    lines = int(place[-1]) + 1
    grid = np.zeros((lines, residual.shape[1]), complex)
    grid[place] = residual / np.sqrt(_variance(residual) + (MODEL_ERROR * np.abs(fit)) ** 2)
    step = float((frequencies[-1] - frequencies[0]) / max(place[-1] - place[0], 1))
    energy, filters = np.zeros((len(HALF_WIDTHS), lines)), []
    for i, half in enumerate(HALF_WIDTHS):
        matched = _filter(half, lines)
        filters.append(matched)
        if len(matched) <= lines:
            noise = float(
                (matched.conj() @ correlated(matched[:, None], np.arange(len(matched)), correlation)).real[0]
            )
            out = fftconvolve(grid, matched[::-1, None].conj(), "same", axes=0)
            energy[i] = (np.abs(out) ** 2).sum(axis=1) / noise
    at = frequencies[0] + step * np.arange(lines)
    energy[np.array(HALF_WIDTHS)[:, None] * step > HIGHEST_DAMPING * at] = 0.0
    poles: list[complex] = []
    while energy.max() > least:
        row, line = divmod(int(energy.argmax()), lines)
        half = HALF_WIDTHS[row]
        poles.append(2.0 * math.pi * step * complex(-half, at[line] / step))
        reach = len(filters[row]) // 2
        energy[:, max(line - reach, 0) : line + reach + 1] = 0.0
    return np.array(poles, complex)


def with_poles(
    modes: IdentifiedModes, poles: Complex, frequencies: Array, remainder: Complex
) -> IdentifiedModes:
    """Return modes with further poles, whose shapes and participations are those of the remainder there."""
    remainder = np.nan_to_num(remainder)
    nearest = np.abs(frequencies - poles.imag[:, None] / (2.0 * math.pi)).argmin(axis=1)
    peaks = remainder[nearest] * -poles.real[:, None, None]
    parts = np.linalg.svd(peaks)[2][:, 0]
    return IdentifiedModes(
        np.concatenate([modes.poles, poles]),
        np.concatenate([modes.shapes, np.einsum("nsr,nr->ns", peaks, parts.conj())]),
        np.concatenate([modes.participation, parts]),
    )


def _filter(half: float, lines: int) -> Complex:
    """Return a mode of a half bandwidth, in line spacings, without its smooth part, of unit length."""
    reach = min(max(FEWEST, math.ceil(REACH * half)), max((lines - 1) // 2, 1))
    x = np.arange(-reach, reach + 1)
    g = 1.0 / (half + 1j * x)
    smooth = np.linalg.qr(np.vander(x / reach, SMOOTH))[0]
    g = g - smooth @ (smooth.T @ g)
    return np.asarray(g / np.linalg.norm(g))


def _variance(residual: Complex) -> Array:
    """Return the variance of the noise, (F, C), from medians over parts of the band, blind to peaks."""
    F = len(residual)
    parts = max(1, min(PARTS, F // 48))
    squares = np.abs(residual) ** 2 / MEDIAN
    total = np.empty(residual.shape)
    for block in np.array_split(np.arange(F), parts):
        total[block] = np.median(squares[block], axis=0)
    return np.asarray(np.maximum(total, 1e-300))
