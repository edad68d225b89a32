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
from pkmodes.modaltest.identification.frf_noise import BAND_PARTS, MEDIAN_SQUARE, apply_correlation
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Half bandwidths tried, in line spacings: a filter loses 0.5 dB for a mode between two of them.
HALF_WIDTHS = (0.35, 0.7, 1.4, 2.8, 5.6, 11.0, 22.0)
#: Lines of a filter on each side: in half bandwidths, and the minimum number.
FILTER_REACH, MIN_FILTER_LINES = 6, 20
#: Coefficients of the smooth part of each filter, as in the fit.
SMOOTH_TERMS = 3
#: A residual below this fraction of the fit may be its model error: a nonlinearity, a window, a calibration.
MODEL_ERROR_SHARE = 0.05


def find_hidden_poles(data: FrequencyLines, fit: Complex, min_energy: float) -> Complex:
    """Return starting poles of modes in a residual, (N,) [1/s], the strongest of each neighbourhood.

    - fit: response of the modes so far, (F, S, R)
    - min_energy: least energy relative to noise
    """
    frequencies, grid_index, measured = data.frequencies, data.grid_index, data.measured
    residual, fit = (data.H - fit)[:, measured], fit[:, measured]
    correlation = np.ones(1, complex) if data.correlation is None else data.correlation
    lines = int(grid_index[-1]) + 1
    grid = np.zeros((lines, residual.shape[1]), complex)
    grid[grid_index] = residual / np.sqrt(_noise_variance(residual) + (MODEL_ERROR_SHARE * np.abs(fit)) ** 2)
    step = float((frequencies[-1] - frequencies[0]) / max(grid_index[-1] - grid_index[0], 1))
    energy, filters = np.zeros((len(HALF_WIDTHS), lines)), []
    for i, half_width in enumerate(HALF_WIDTHS):
        template = _matched_filter(half_width, lines)
        filters.append(template)
        if len(template) <= lines:
            noise = float(
                (
                    template.conj()
                    @ apply_correlation(template[:, None], np.arange(len(template)), correlation)
                ).real[0]
            )
            filtered = fftconvolve(grid, template[::-1, None].conj(), "same", axes=0)
            energy[i] = (np.abs(filtered) ** 2).sum(axis=1) / noise
    grid_frequencies = frequencies[0] + step * np.arange(lines)
    energy[np.array(HALF_WIDTHS)[:, None] * step > HIGHEST_DAMPING * grid_frequencies] = 0.0
    poles: list[complex] = []
    while energy.max() > min_energy:
        row, line = divmod(int(energy.argmax()), lines)
        half_width = HALF_WIDTHS[row]
        poles.append(2.0 * math.pi * step * complex(-half_width, grid_frequencies[line] / step))
        reach = len(filters[row]) // 2
        energy[:, max(line - reach, 0) : line + reach + 1] = 0.0
    return np.array(poles, complex)


def append_poles(
    modes: IdentifiedModes, poles: Complex, frequencies: Array, remainder: Complex
) -> IdentifiedModes:
    """Return modes with further poles, whose shapes and participations are those of the remainder there."""
    remainder = np.nan_to_num(remainder)
    nearest = np.abs(frequencies - poles.imag[:, None] / (2.0 * math.pi)).argmin(axis=1)
    peaks = remainder[nearest] * -poles.real[:, None, None]
    participations = np.linalg.svd(peaks)[2][:, 0]
    return IdentifiedModes(
        np.concatenate([modes.poles, poles]),
        np.concatenate([modes.shapes, np.einsum("nsr,nr->ns", peaks, participations.conj())]),
        np.concatenate([modes.participation, participations]),
    )


def _matched_filter(half_width: float, lines: int) -> Complex:
    """Return a mode of a half bandwidth, in line spacings, without its smooth part, of unit length."""
    reach = min(max(MIN_FILTER_LINES, math.ceil(FILTER_REACH * half_width)), max((lines - 1) // 2, 1))
    x = np.arange(-reach, reach + 1)
    g = 1.0 / (half_width + 1j * x)
    smooth = np.linalg.qr(np.vander(x / reach, SMOOTH_TERMS))[0]
    g = g - smooth @ (smooth.T @ g)
    return np.asarray(g / np.linalg.norm(g))


def _noise_variance(residual: Complex) -> Array:
    """Return the variance of the noise, (F, C), from medians over parts of the band, blind to peaks."""
    F = len(residual)
    part_count = max(1, min(BAND_PARTS, F // 48))
    squares = np.abs(residual) ** 2 / MEDIAN_SQUARE
    variance = np.empty(residual.shape)
    for block in np.array_split(np.arange(F), part_count):
        variance[block] = np.median(squares[block], axis=0)
    return np.asarray(np.maximum(variance, 1e-300))
