"""Telling modes from model errors in frequency responses of a nonlinear machine.

The fit of `frf_refinement` adds modes until only noise is left.  If a joint softens with the amplitude, a transducer
resonates or a hammer hits twice, no few linear modes fit the functions, and spurious ones fit the remainder:

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
from pkmodes.modaltest.identification.frf_noise import LAGS
from pkmodes.modaltest.identification.frf_refinement import copies, group_fit, groups, refined, settled
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]

#: One peak: similar modes closer than a bandwidth, one of which alone leaves less than this fraction of the peak.
NEAR, PEAK = 1.0, 0.1
#: A mode this much broader than the peak fits the remainder of its skirts, whatever its shape.
BROAD = 3.0
#: Fewest sensors for comparing shapes: at fewer, shapes agree by chance.
ENOUGH = 3
#: If one mode fits the peak, this many others beside it are spurious even if their shapes differ.
SEVERAL = 2
#: A mode with at least this fraction of the response of all others at its frequency is never spurious,
STRONG = 0.2
#: and a weaker one is if it is below this multiple of the error.
SPURIOUS = 8.0
#: The error is estimated from lines this far apart: between closer ones, noise is correlated too.
LAG = 2 * LAGS
#: Fewest pairs of lines, and peaks, from which an error is estimated: what is at one peak alone may be a mode.
FEWEST, PEAKS = 2 * LAG, 2
#: Number of standard deviations above which an estimated error is real.
SURE = 4.0
#: Most modes mentioned in a message.
MENTIONED = 4


class Remaining(NamedTuple):
    """Modes without spurious ones.

    - bounds: without the error
    - error: largest fraction of the functions at a peak that the modes do not explain and that is not noise
    - left_out: frequencies of the spurious ones [Hz], ascending
    """

    modes: IdentifiedModes
    bounds: Uncertainty
    error: float
    left_out: Array


def without_model_errors(
    data: FrequencyLines, modes: IdentifiedModes, bounds: Uncertainty, low: float, high: float
) -> Remaining:
    """Return the modes without those that only fit an error of the model.

    - modes, bounds: as returned by `refined`
    - low, high: range of frequencies that a mode may have [Hz]
    """
    left_out: list[float] = []
    while (drop := _beside_a_peak(data, modes)).any() or (drop := _on_skirts(data, modes)).any():
        left_out += modes.frequencies[drop].tolist()
        modes, bounds = refined(data, modes.only(~drop), low, high)
    error = float(np.nan_to_num(slow_errors(data, modes)).max(initial=0.0))
    return Remaining(modes, bounds, error, np.sort(left_out))


def with_model_error(modes: IdentifiedModes, bounds: Uncertainty, error: float) -> Uncertainty:
    """Return uncertainties including the effect of an error, a fraction of the functions, on each pole and shape.

    The shape of a weak mode beside a strong one has an error in proportion to the strong one.
    """
    width = np.abs(modes.poles.real)
    poles = np.hypot(bounds.poles, error * width[:, None])
    size = np.abs(modes.response(modes.poles.imag / (2.0 * math.pi)))
    power = np.abs(modes.participation) ** 2
    whole = np.maximum(power.sum(axis=1), 1e-300)[:, None]
    # By least squares over the references, of errors that are independent of each other.
    spread = (error * width[:, None] / whole) ** 2 * (size**2 * power[:, None, :]).sum(axis=2)
    return replace(bounds, poles=poles, shapes=bounds.shapes + spread[:, :, None] * np.eye(size.shape[1]))


def not_linear(error: float, left_out: Sequence[float]) -> str:
    """Return a message about modes that were left out.

    - error: error of the model, as a fraction of the functions at their peaks
    - left_out: [Hz]
    """
    examples = ", ".join(f"{frequency:.4g}" for frequency in left_out[:MENTIONED])
    rest = f" and {len(left_out) - MENTIONED} more" if len(left_out) > MENTIONED else ""
    single = len(left_out) == 1
    modes, are = ("a mode", "is") if single else ("modes", "are")
    part = f" (up to {plain(100 * error, 2)} % of a peak)" if error > 0.0 else ""
    return (
        f"a few linear modes do not fit the functions to noise{part}: {modes} that would fit the remainder, at "
        f"{examples}{rest} Hz, {are} left out; the machine or the measuring chain is not linear"
    )


# Beside peaks --------------------------------------------------------------------------------------------------


def _beside_a_peak(data: FrequencyLines, modes: IdentifiedModes) -> NDArray[np.bool_]:
    """Return modes that only fit the remainder of one mode at a peak, for the highest peak that has any."""
    drop = np.zeros(len(modes.poles), bool)
    if data.measured.any(axis=1).sum() < ENOUGH:
        return drop
    height = np.linalg.norm(np.nan_to_num(modes.residues), axis=(1, 2)) / np.abs(modes.poles.real)
    for k in np.argsort(-height).tolist():
        beside = _beside(modes, height, k)
        broad = modes.half_widths > BROAD * modes.half_widths[k]
        alike = np.array([i for i in beside if broad[i] or copies(modes, int(i), k, NEAR)], np.int64)
        both = len(beside) >= SEVERAL and len(beside) > len(alike)
        for subset in [beside, alike] if both else [alike]:
            if len(subset) and _left_without(data, modes, subset, k) < PEAK:
                drop[subset] = True
                return drop
    return drop


def _beside(modes: IdentifiedModes, height: Array, k: int) -> Index:
    """Return the lower modes that are within a bandwidth of a mode, directly or through others of them."""
    width, at = np.abs(modes.poles.real), modes.poles.imag
    members = np.arange(len(height)) == k
    while True:
        near = (np.abs(at[:, None] - at[members]) < NEAR * (width[:, None] + width[members])).any(axis=1)
        grown = members | (near & (height < height[k]))
        if (grown == members).all():
            return np.setdiff1d(np.flatnonzero(members), [k])
        members = grown


def _left_without(data: FrequencyLines, modes: IdentifiedModes, dropped: Index, k: int) -> float:
    """Return the remainder of a fit without some modes, relative to mode k at its peak or the functions at theirs."""
    kept = ~np.isin(np.arange(len(modes.poles)), dropped)
    fewer, place = modes.only(kept), int(kept[:k].sum())
    fitted = group_fit(data, fewer, next(group for group in groups(fewer.poles) if place in group))
    if not np.isfinite(fitted.fit.cost):
        return math.inf
    s, measured = fitted.at.s, fitted.at.weights > 0.0
    remainder = (residual(fitted.at, fitted.fit) * fitted.at.sigma[:, None, None])[:, measured]
    m = int(np.flatnonzero(fitted.members == place)[0])
    mode = (fitted.fit.residues[m] / (s - fitted.fit.poles[m])[:, None, None])[:, measured]
    functions = data.H[fitted.lines][:, measured]
    parts = [_part(remainder, mode, s, fitted.fit.poles[m])]
    parts += [_part(remainder, functions, s, pole) for pole in modes.poles[dropped]]
    return max(parts)


def _part(remainder: Complex, whole: Complex, s: Complex, pole: complex) -> float:
    """Return the remainder within the half bandwidths of a pole, relative to `whole`; inf if that is zero there."""
    near = np.abs(s.imag - pole.imag) < abs(pole.real)
    size = float(np.linalg.norm(whole[near]))
    return float(np.linalg.norm(remainder[near])) / size if near.any() and size > 0.0 else math.inf


# On their skirts -----------------------------------------------------------------------------------------------


def _on_skirts(data: FrequencyLines, modes: IdentifiedModes) -> NDArray[np.bool_]:
    """Return weak modes that are not much larger than the error of the strong ones at most peaks."""
    size = _relative_sizes(data, modes)
    strong = size >= STRONG
    if strong.all() or strong.sum() < PEAKS:
        return np.zeros(len(size), bool)
    strong_only, _ = settled(data, modes.only(strong))
    errors = slow_errors(data, strong_only)
    errors = np.sort(errors[np.isfinite(errors)])
    # The lower median, which at least half of the peaks reach; 0 if too few are known.
    median = float(errors[(len(errors) - 1) // 2]) if len(errors) >= PEAKS else 0.0
    return np.asarray(~strong & (size < SPURIOUS * median))


def _relative_sizes(data: FrequencyLines, modes: IdentifiedModes) -> Array:
    """Return the size of each mode at the line nearest to it, relative to that of all others there, (N,)."""
    measured, at = data.measured, modes.poles.imag / (2.0 * math.pi)
    nearest = np.abs(data.frequencies - at[:, None]).argmin(axis=1)
    s = 2j * math.pi * data.frequencies[nearest]
    own_response = modes.residues[:, measured] / (s - modes.poles)[:, None]
    other_sizes = np.linalg.norm(data.H[nearest][:, measured] - own_response, axis=1)
    return np.asarray(np.linalg.norm(own_response, axis=1) / np.maximum(other_sizes, 1e-300))


def slow_errors(data: FrequencyLines, modes: IdentifiedModes) -> Array:
    """Return the fraction of the functions at each peak that modes leave and that varies slowly over the lines, (N,).

    Residuals at lines some way apart are uncorrelated if they are noise, and correlated if they are a model error.
    NaN for a peak of few lines.
    """
    measured, f = data.measured, data.frequencies
    remainder = np.zeros(data.H.shape, complex)
    for members in groups(modes.poles):
        fitted = group_fit(data, modes, members)
        remainder[fitted.lines] = residual(fitted.at, fitted.fit) * fitted.at.sigma[:, None, None]
    remainder = remainder[:, measured]
    later = np.minimum(np.searchsorted(data.place, data.place + LAG), len(f) - 1)
    paired = data.place[later] == data.place + LAG
    errors = np.full(len(modes.poles), np.nan)
    for k, (centre, half) in enumerate(
        zip(modes.poles.imag / (2.0 * math.pi), modes.half_widths, strict=True)
    ):
        near = np.abs(f - centre) < 2.0 * half
        first = np.flatnonzero(near & paired & near[later])
        if len(first) < FEWEST:
            continue
        products = (remainder[first].conj() * remainder[later[first]]).real
        whole = float((np.abs(data.H[first][:, measured]) ** 2).mean())
        noise = float((np.abs(np.diff(remainder[near], axis=0)) ** 2).mean()) / 2.0
        slow = float(products.mean())
        sure = slow > SURE * noise / math.sqrt(products.size)
        errors[k] = math.sqrt(slow / whole) if sure and whole > 0.0 else 0.0
    return errors
