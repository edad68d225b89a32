"""Telling modes from model errors in frequency responses of a nonlinear machine.

The fit of `frf_refinement` adds modes until only noise is left.  If a joint softens with the amplitude, a transducer
resonates or a hammer hits twice, a few linear modes do not fit the functions, and spurious ones fit the remainder:

- beside a peak: one mode alone leaves a small part of the peak there;
- between peaks: at most peaks the strong modes leave a small part of the functions which, unlike noise, varies slowly
  over many lines, and the mode is not much larger than that.

These are left out.  An error of one per cent of a peak can displace its pole by one per cent of the half bandwidth,
which counts as uncertainty.  A displaced pole absorbs much of the error at its own peak, so that the largest error of
all peaks counts for each.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.identification.frf_covariance import Uncertainty, residual
from pkmodes.modaltest.identification.frf_lines import FrequencyLines
from pkmodes.modaltest.identification.frf_noise import MAX_LAG
from pkmodes.modaltest.identification.frf_refinement import (
    are_copies,
    fit_group,
    fit_until_settled,
    group_overlapping,
    refine,
)
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]

#: One peak: similar modes closer than a bandwidth, one of which alone leaves less than this fraction of the peak.
NEIGHBOUR_DISTANCE, MAX_PEAK_REMAINDER = 1.0, 0.1
#: A mode this much broader than the peak fits the remainder of its skirts, whatever its shape.
BROAD_RATIO = 3.0
#: Minimum number of sensors for comparing shapes: at fewer, shapes agree by chance.
MIN_SENSORS = 3
#: If one mode fits the peak, this many others beside it are spurious even if their shapes differ.
MIN_SPURIOUS_NEIGHBOURS = 2
#: A mode with at least this fraction of the response of all others at its frequency is never spurious,
STRONG_SHARE = 0.2
#: and a weaker one is if it is below this multiple of the error.
SPURIOUS_RATIO = 8.0
#: The error is estimated from lines this far apart: between closer ones, noise is correlated too.
LAG = 2 * MAX_LAG
#: Minimum number of pairs of lines, and peaks, from which an error is estimated: what is at one peak alone may be a
#: mode.
MIN_PAIRS, MIN_PEAKS = 2 * LAG, 2
#: Number of standard deviations above which an estimated error is real.
SIGNIFICANT_SIGMAS = 4.0
#: Maximum number of modes mentioned in a message.
MAX_FREQUENCIES_NAMED = 4


class ModesWithoutErrors(NamedTuple):
    """Modes without spurious ones.

    - uncertainty: uncertainty without the error
    - error: largest fraction of the functions at a peak that the modes do not explain and that is not noise
    - spurious_frequencies: frequencies of the spurious ones [Hz], ascending
    """

    modes: IdentifiedModes
    uncertainty: Uncertainty
    error: float
    spurious_frequencies: Array


def drop_model_errors(
    data: FrequencyLines, modes: IdentifiedModes, uncertainty: Uncertainty, low: float, high: float
) -> ModesWithoutErrors:
    """Return the modes without those that only fit an error of the model.

    - modes, uncertainty: as returned by `refine`
    - low, high: range of frequencies that a mode may have [Hz]
    """
    spurious: list[float] = []
    while (drop := _spurious_beside_peak(data, modes)).any() or (
        drop := _spurious_on_skirts(data, modes)
    ).any():
        spurious += modes.frequencies[drop].tolist()
        modes, uncertainty = refine(data, modes.select(~drop), low, high)
    error = float(np.nan_to_num(peak_errors(data, modes)).max(initial=0.0))
    return ModesWithoutErrors(modes, uncertainty, error, np.sort(spurious))


def add_model_error(modes: IdentifiedModes, uncertainty: Uncertainty, error: float) -> Uncertainty:
    """Return uncertainties including the effect of an error, a fraction of the functions, on each pole and shape.

    The shape of a weak mode beside a strong one has an error in proportion to the strong one.
    """
    half_width = np.abs(modes.poles.real)
    poles = np.hypot(uncertainty.poles, error * half_width[:, None])
    response_size = np.abs(modes.response(modes.poles.imag / (2.0 * math.pi)))
    power = np.abs(modes.participation) ** 2
    total_power = np.maximum(power.sum(axis=1), 1e-300)[:, None]
    # By least squares over the references, of errors that are independent of each other.
    spread = (error * half_width[:, None] / total_power) ** 2 * (response_size**2 * power[:, None, :]).sum(
        axis=2
    )
    return replace(
        uncertainty,
        poles=poles,
        shapes=uncertainty.shapes + spread[:, :, None] * np.eye(response_size.shape[1]),
    )


def nonlinearity_message(error: float, spurious: Sequence[float]) -> str:
    """Return a message about modes that were left out.

    - error: error of the model, as a fraction of the functions at their peaks
    - spurious: [Hz]
    """
    examples = ", ".join(f"{frequency:.4g}" for frequency in spurious[:MAX_FREQUENCIES_NAMED])
    remainder = (
        f" and {len(spurious) - MAX_FREQUENCIES_NAMED} more" if len(spurious) > MAX_FREQUENCIES_NAMED else ""
    )
    single = len(spurious) == 1
    modes, are = ("a mode", "is") if single else ("modes", "are")
    error_text = f" (up to {plain(100 * error, 2)} % of a peak)" if error > 0.0 else ""
    return (
        f"a few linear modes do not fit the functions to noise{error_text}: {modes} that would fit the remainder, at "
        f"{examples}{remainder} Hz, {are} left out; the machine or the measuring chain is not linear"
    )


# Beside peaks --------------------------------------------------------------------------------------------------


def _spurious_beside_peak(data: FrequencyLines, modes: IdentifiedModes) -> NDArray[np.bool_]:
    """Return modes that only fit the remainder of one mode at a peak, for the highest peak that has any."""
    drop = np.zeros(len(modes.poles), bool)
    if data.measured.any(axis=1).sum() < MIN_SENSORS:
        return drop
    height = np.linalg.norm(np.nan_to_num(modes.residues), axis=(1, 2)) / np.abs(modes.poles.real)
    for k in np.argsort(-height).tolist():
        neighbours = _lower_neighbours(modes, height, k)
        broad = modes.half_widths > BROAD_RATIO * modes.half_widths[k]
        similar = np.array(
            [i for i in neighbours if broad[i] or are_copies(modes, int(i), k, NEIGHBOUR_DISTANCE)], np.int64
        )
        try_all = len(neighbours) >= MIN_SPURIOUS_NEIGHBOURS and len(neighbours) > len(similar)
        for subset in [neighbours, similar] if try_all else [similar]:
            if len(subset) and _remainder_without(data, modes, subset, k) < MAX_PEAK_REMAINDER:
                drop[subset] = True
                return drop
    return drop


def _lower_neighbours(modes: IdentifiedModes, height: Array, k: int) -> Index:
    """Return the lower modes that are within a bandwidth of a mode, directly or through others of them."""
    half_width, centre = np.abs(modes.poles.real), modes.poles.imag
    members = np.arange(len(height)) == k
    while True:
        is_near = (
            np.abs(centre[:, None] - centre[members])
            < NEIGHBOUR_DISTANCE * (half_width[:, None] + half_width[members])
        ).any(axis=1)
        grown = members | (is_near & (height < height[k]))
        if (grown == members).all():
            return np.setdiff1d(np.flatnonzero(members), [k])
        members = grown


def _remainder_without(data: FrequencyLines, modes: IdentifiedModes, dropped: Index, k: int) -> float:
    """Return the remainder of a fit without some modes, relative to mode k at its peak or the functions at theirs."""
    kept_mask = ~np.isin(np.arange(len(modes.poles)), dropped)
    remaining, index = modes.select(kept_mask), int(kept_mask[:k].sum())
    fitted = fit_group(
        data, remaining, next(group for group in group_overlapping(remaining.poles) if index in group)
    )
    if not np.isfinite(fitted.fit.cost):
        return math.inf
    s, measured = fitted.window.s, fitted.window.weights > 0.0
    remainder = (residual(fitted.window, fitted.fit) * fitted.window.sigma[:, None, None])[:, measured]
    m = int(np.flatnonzero(fitted.members == index)[0])
    mode = (fitted.fit.residues[m] / (s - fitted.fit.poles[m])[:, None, None])[:, measured]
    functions = data.H[fitted.lines][:, measured]
    ratios = [_relative_remainder(remainder, mode, s, fitted.fit.poles[m])]
    ratios += [_relative_remainder(remainder, functions, s, pole) for pole in modes.poles[dropped]]
    return max(ratios)


def _relative_remainder(remainder: Complex, reference: Complex, s: Complex, pole: complex) -> float:
    """Return the remainder within the half bandwidths of a pole, relative to a reference; inf if that is zero."""
    is_near = np.abs(s.imag - pole.imag) < abs(pole.real)
    size = float(np.linalg.norm(reference[is_near]))
    return float(np.linalg.norm(remainder[is_near])) / size if is_near.any() and size > 0.0 else math.inf


# On their skirts -----------------------------------------------------------------------------------------------


def _spurious_on_skirts(data: FrequencyLines, modes: IdentifiedModes) -> NDArray[np.bool_]:
    """Return weak modes that are not much larger than the error of the strong ones at most peaks.

    The size of a mode is that at the line nearest to it, relative to that of all others there.
    """
    measured, centres = data.measured, modes.poles.imag / (2.0 * math.pi)
    nearest = np.abs(data.frequencies - centres[:, None]).argmin(axis=1)
    s = 2j * math.pi * data.frequencies[nearest]
    own_response = modes.residues[:, measured] / (s - modes.poles)[:, None]
    other_sizes = np.linalg.norm(data.H[nearest][:, measured] - own_response, axis=1)
    size = np.linalg.norm(own_response, axis=1) / np.maximum(other_sizes, 1e-300)
    strong = size >= STRONG_SHARE
    if strong.all() or strong.sum() < MIN_PEAKS:
        return np.zeros(len(size), bool)
    strong_modes, _ = fit_until_settled(data, modes.select(strong))
    errors = peak_errors(data, strong_modes)
    errors = np.sort(errors[np.isfinite(errors)])
    # The lower median, which at least half of the peaks reach; 0 if too few are known.
    median = float(errors[(len(errors) - 1) // 2]) if len(errors) >= MIN_PEAKS else 0.0
    return np.asarray(~strong & (size < SPURIOUS_RATIO * median))


def peak_errors(data: FrequencyLines, modes: IdentifiedModes) -> Array:
    """Return the fraction of the functions at each peak that modes leave and that varies slowly over the lines, (N,).

    Residuals at lines some way apart are uncorrelated if they are noise, and correlated if they are a model error.
    NaN for a peak of few lines.
    """
    measured, f = data.measured, data.frequencies
    remainder = np.zeros(data.H.shape, complex)
    for members in group_overlapping(modes.poles):
        fitted = fit_group(data, modes, members)
        remainder[fitted.lines] = residual(fitted.window, fitted.fit) * fitted.window.sigma[:, None, None]
    remainder = remainder[:, measured]
    later = np.minimum(np.searchsorted(data.grid_index, data.grid_index + LAG), len(f) - 1)
    paired = data.grid_index[later] == data.grid_index + LAG
    errors = np.full(len(modes.poles), np.nan)
    for k, (centre, half_width) in enumerate(
        zip(modes.poles.imag / (2.0 * math.pi), modes.half_widths, strict=True)
    ):
        is_near = np.abs(f - centre) < 2.0 * half_width
        first = np.flatnonzero(is_near & paired & is_near[later])
        if len(first) < MIN_PAIRS:
            continue
        products = (remainder[first].conj() * remainder[later[first]]).real
        power = float((np.abs(data.H[first][:, measured]) ** 2).mean())
        noise = float((np.abs(np.diff(remainder[is_near], axis=0)) ** 2).mean()) / 2.0
        slow = float(products.mean())
        significant = slow > SIGNIFICANT_SIGMAS * noise / math.sqrt(products.size)
        errors[k] = math.sqrt(slow / power) if significant and power > 0.0 else 0.0
    return errors
