r"""Telling resonances from lines without bandwidth in frequency responses.

Mains, fans and motors are not driven by the measured force: their contribution is on one line, or on the few over
which a spectral window spreads it.  A pole can be fitted to it as well, or several, with half bandwidths below the
line spacing.  But a mode extends further: its skirts fall with the distance only, r/(j omega - lambda), and where the
peak of a lightly damped mode stands out of the noise its skirts do as well.  So the residue is estimated from the
lines of the skirts alone.  For a tone this residue is noise, or differs from that of the peak.

A tone in a record that has had no window has skirts as well, those of a pole without damping: the damping of a mode
is more than its standard deviation.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import gamma

from pkmodes.modaltest.identification.frf_lines import TONE_SPREAD, FrequencyLines
from pkmodes.modaltest.identification.frf_noise import MEDIAN_SQUARE
from pkmodes.modaltest.identification.frf_polish import make_window, pole_basis, polish
from pkmodes.modaltest.identification.frf_refinement import subtract_other_modes
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Half bandwidth, in line spacings, below which a pole may be that of a tone.
NARROW_HALF_WIDTH = 1.0
#: Poles closer to each other than this, in line spacings, may have been fitted to one tone.
MAX_CLUSTER_GAP = 5.0
#: Lines used on each side.
SIDE_LINES = 24
#: Minimum number of lines from which skirts can be judged.
MIN_LINES = 8
#: Probability that noise alone produces skirts, and that it produces a line that is reported.
FALSE_ALARM, TONE_FALSE_ALARM = 1e-3, 1e-9
#: Largest relative difference between the residues of a mode's skirts and its peak: halfway from a mode to a tone.
MAX_RESIDUE_DIFFERENCE = 0.5
#: Minimum ratio of a damping to its standard deviation.
MIN_DAMPING_SIGMAS = 2.0


@dataclass(frozen=True)
class ToneLine:
    """A line without bandwidth.

    - frequency: [Hz]
    - significant: whether it exceeds the noise by enough to be a tone, and no bump of the noise
    """

    frequency: float
    significant: bool


def find_tone_lines(data: FrequencyLines, modes: IdentifiedModes) -> list[ToneLine]:
    """Return the lines without bandwidth among narrow modes."""
    step = data.step
    positions = modes.poles.imag / (2.0 * math.pi * step)
    narrow = np.flatnonzero(modes.half_widths < NARROW_HALF_WIDTH * step)
    narrow = narrow[np.argsort(positions[narrow])]
    lines: list[ToneLine] = []
    if not len(narrow):
        return lines
    # Modes that may have been fitted to one tone are taken together.
    for cluster in np.split(narrow, np.flatnonzero(np.diff(positions[narrow]) > MAX_CLUSTER_GAP) + 1):
        centre = float(modes.poles[cluster].imag.mean()) / (2.0 * math.pi)
        is_near = np.abs(data.frequencies - centre) < SIDE_LINES * step
        f, H = data.frequencies[is_near], subtract_other_modes(data, modes, cluster, is_near)
        if len(f) < MIN_LINES:  # all lines around it are left out already
            lines.append(ToneLine(float(modes.frequencies[cluster[0]]), significant=False))
            continue
        pole = complex(modes.poles[cluster[0]])
        if len(cluster) > 1:  # one pole that fits them all
            variance = np.where(np.isfinite(H).all(axis=0), (np.abs(H) ** 2).mean(axis=0), np.inf)
            window = make_window(f, H, 1.0 / variance, np.ones(len(f)))
            strongest = cluster[np.argmax(np.linalg.norm(modes.residues[cluster], axis=(1, 2)))]
            fit = polish(window, modes.poles[[strongest]], modes.participation[[strongest]])
            if not np.isfinite(fit.cost):
                continue
            pole = complex(fit.poles[0])
        if not _is_resonance(f, H, pole, step):
            frequency = pole.imag / (2.0 * math.pi)
            lines.append(ToneLine(frequency, _exceeds_noise(f, H, frequency, step)))
    return lines


def distinct_tones(lines: Sequence[ToneLine], step: float) -> tuple[float, ...]:
    """Return the frequencies of the tones [Hz]: of those found close together, in line spacings, the first."""
    frequencies: list[float] = []
    for line in lines:
        if line.significant and all(
            abs(line.frequency - earlier) > MAX_CLUSTER_GAP * step for earlier in frequencies
        ):
            frequencies.append(line.frequency)
    return tuple(sorted(frequencies))


def _is_resonance(f: Array, H: Complex, pole: complex, step: float) -> bool:
    """Return whether a pole is that of a mode: its lines have its skirts, and damping."""
    measured = np.isfinite(H).all(axis=0)
    values = H[:, measured]
    on_skirts = np.abs(f - pole.imag / (2.0 * math.pi)) > TONE_SPREAD * step
    skirt_residues, skirt_variance, factor = _residues(f[on_skirts], values[on_skirts], pole)
    residues, residual_variance, _ = _residues(f, values, pole)
    energy = float((np.abs(skirt_residues) ** 2 / (skirt_variance * factor)).sum())
    if energy < gamma.isf(FALSE_ALARM, len(skirt_residues)):
        return False
    ratio = float(
        ((residues.conj() * skirt_residues).real / skirt_variance).sum()
        / (np.abs(residues) ** 2 / skirt_variance).sum()
    )
    damping = abs(pole.real) * math.sqrt(
        2.0 * _information(f, pole) * float((np.abs(residues) ** 2 / residual_variance).sum())
    )
    return abs(ratio - 1.0) < MAX_RESIDUE_DIFFERENCE and damping > MIN_DAMPING_SIGMAS


def _exceeds_noise(f: Array, H: Complex, frequency: float, step: float) -> bool:
    """Return whether one of the lines near a frequency is above the noise of the others."""
    values = H[:, np.isfinite(H).all(axis=0)]
    is_near = np.abs(f - frequency) < TONE_SPREAD * step
    noise = np.maximum(np.median(np.abs(values[~is_near]) ** 2, axis=0) / MEDIAN_SQUARE, 1e-300)
    return bool(
        (np.abs(values[is_near]) ** 2 / noise).sum(axis=1).max(initial=0.0)
        > gamma.isf(TONE_FALSE_ALARM, len(noise))
    )


def _information(f: Array, pole: complex) -> float:
    """Return the information of lines of unit noise on a pole of unit residue, with a free smooth part [s^2]."""
    window = make_window(f, np.zeros((len(f), 1, 1), complex), np.ones((1, 1)), np.ones(len(f)))
    g, slope = pole_basis(window, np.array([pole])).T
    remainder = slope - g * (np.vdot(g, slope) / np.vdot(g, g))
    return float(np.vdot(remainder, remainder).real)


def _residues(f: Array, values: Complex, pole: complex) -> tuple[Complex, Array, float]:
    """Return residues (C,), the variance of the lines (C,) and the factor from it to that of the residues."""
    middle, half = f.mean(), 0.5 * float(np.ptp(f))
    g = 1.0 / (2j * math.pi * f - pole)
    smooth = np.linalg.qr(np.vander((f - middle) / half, 4))[0]
    g = g - smooth @ (smooth.T @ g)
    remainder = values - smooth @ (smooth.T @ values)
    size = float(np.vdot(g, g).real)
    residues = (g.conj() @ remainder) / size
    residual = remainder - np.outer(g, residues)
    variance = (np.abs(residual) ** 2).sum(axis=0) / max(len(f) - 5, 1)
    return residues, np.maximum(variance, 1e-300), 1.0 / size
