"""Modes told from errors of the model in frequency responses of a machine that is not linear.

The fit of `frf_refinement` adds modes until noise is left.  Where the functions are not those of a few linear modes,
because a joint softens with the amplitude, a transducer resonates or a hammer hits twice, modes that fit this error
are added:

- beside a peak, with its shape: what one mode leaves there is a small part of the peak, and no second mode;
- on the skirts of peaks: what is left at most peaks is a small part of the functions that varies slowly over many
  lines, as no noise does, and a mode that is hardly larger may be more of this.

They are left out.  An error of a part of a peak displaces its pole by as large a part of the half bandwidth, which
counts as uncertainty.  The displaced pole explains most of the error itself, so that the largest one of all peaks
counts for each.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.identification.frf_covariance import Uncertainty, residual
from pkmodes.identification.frf_lines import Lines
from pkmodes.identification.frf_noise import LAGS
from pkmodes.identification.frf_refinement import copies, group_fit, groups, refined, settled
from pkmodes.identification.modes import Modes
from pkmodes.support.numbers import plain

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]

#: One peak: modes nearer than a bandwidth and alike, of which one leaves less than this part of the peak.
NEAR, PEAK = 1.0, 0.1
#: Shapes of fewer functions are alike by chance.
ENOUGH = 3
#: So many modes beside a peak are errors of the model, if one mode does, even if they are not alike.
SEVERAL = 2
#: A mode that is at least this part of the others where it is may not be an error of theirs,
STRONG = 0.2
#: and one that is less than so many times the error may.
GHOST = 8.0
#: The error is estimated from lines this far apart: the noise of nearer ones is correlated, too.
LAG = 2 * LAGS
#: Fewer pairs of lines tell no error, nor do fewer peaks: what is at one peak alone may be a mode.
FEWEST, PEAKS = 2 * LAG, 2
#: Standard deviations of its estimate from which on there is an error.
SURE = 4.0
#: Modes that a sentence mentions at most.
MENTIONED = 4


class Linear(NamedTuple):
    """Modes without those that fit an error of the model.

    Attributes
    ----------
    modes : Modes
        (N,).
    bounds : Uncertainty
    error : float
        What they leave at a peak that is no noise, as a part of the functions there: the largest.
    left_out : ndarray
        Frequencies of those that fit an error [Hz], ascending.
    """

    modes: Modes
    bounds: Uncertainty
    error: float
    left_out: Array


def without_model_errors(data: Lines, modes: Modes, bounds: Uncertainty, low: float, high: float) -> Linear:
    """Return the modes without those that fit an error of the model.

    Parameters
    ----------
    data : Lines
    modes, bounds
        As returned by `refined`.
    low, high : float
        Range of frequencies that a mode may have [Hz].
    """
    left_out: list[float] = []
    while (drop := _beside_a_peak(data, modes)).any() or (drop := _on_skirts(data, modes)).any():
        left_out += modes.frequencies[drop].tolist()
        modes, bounds = refined(data, modes.only(~drop), low, high)
    error = float(np.nan_to_num(slow_errors(data, modes)).max(initial=0.0))
    displaced = error * np.abs(modes.poles.real)
    return Linear(
        modes,
        replace(bounds, poles=np.hypot(bounds.poles, displaced[:, None])),
        error,
        np.sort(left_out),
    )


def not_linear(error: float, left_out: Sequence[float]) -> str:
    """Return a sentence on modes that are left out.

    Parameters
    ----------
    error : float
        What the modes leave, as a part of the functions at their peaks.
    left_out : sequence of float
        [Hz].
    """
    some = ", ".join(f"{one:.4g}" for one in left_out[:MENTIONED])
    more = f" and {len(left_out) - MENTIONED} more" if len(left_out) > MENTIONED else ""
    one = len(left_out) == 1
    modes, are = ("a mode", "is") if one else ("modes", "are")
    part = f" (up to {plain(100 * error, 2)} % of a peak)" if error > 0.0 else ""
    return (
        f"the functions are not those of a few linear modes{part}: {modes} that would fit the rest, at "
        f"{some}{more} Hz, {are} left out; the machine is not linear, or what measures it"
    )


# Beside peaks --------------------------------------------------------------------------------------------------


def _beside_a_peak(data: Lines, modes: Modes) -> NDArray[np.bool_]:
    """Return modes that only fit what one mode at a peak leaves there, for the highest peak that has such ones."""
    drop = np.zeros(len(modes.poles), bool)
    if data.known.sum() < ENOUGH:
        return drop
    height = np.linalg.norm(np.nan_to_num(modes.residues), axis=(1, 2)) / np.abs(modes.poles.real)
    for k in np.argsort(-height).tolist():
        beside = _beside(modes, height, k)
        alike = np.array([i for i in beside if copies(modes, int(i), k, NEAR)], np.int64)
        for some in (beside if len(beside) >= SEVERAL else alike, alike):
            if len(some) and _left_without(data, modes, some, k) < PEAK:
                drop[some] = True
                return drop
    return drop


def _beside(modes: Modes, height: Array, k: int) -> Index:
    """Return the lower modes that are nearer to a mode than a bandwidth, or to one of these."""
    width, at = np.abs(modes.poles.real), modes.poles.imag
    found = np.arange(len(height)) == k
    while True:
        near = (np.abs(at[:, None] - at[found]) < NEAR * (width[:, None] + width[found])).any(axis=1)
        more = found | (near & (height < height[k]))
        if (more == found).all():
            return np.setdiff1d(np.flatnonzero(found), [k])
        found = more


def _left_without(data: Lines, modes: Modes, some: Index, k: int) -> float:
    """Return what a fit without some modes leaves, as a part of mode k at its peak, or of the functions at theirs."""
    kept = np.setdiff1d(np.arange(len(modes.poles)), some)
    fewer = modes.only(np.isin(np.arange(len(modes.poles)), kept))
    place = int(np.searchsorted(kept, k))
    one = group_fit(data, fewer, next(group for group in groups(fewer.poles) if place in group))
    if not np.isfinite(one.fit.cost):
        return math.inf
    s, known = one.at.s, one.at.weights > 0.0
    left = (residual(one.at, one.fit) * one.at.sigma[:, None, None])[:, known]
    m = int(np.flatnonzero(one.members == place)[0])
    mode = (one.fit.residues[m] / (s - one.fit.poles[m])[:, None, None])[:, known]
    functions = data.H[one.lines][:, known]
    parts = [_part(left, mode, s, one.fit.poles[m])]
    parts += [_part(left, functions, s, pole) for pole in modes.poles[some]]
    return max(parts)


def _part(left: Complex, whole: Complex, s: Complex, pole: complex) -> float:
    """Return what is left within the half bandwidths of a pole, as a part of something there; inf where it is not."""
    near = np.abs(s.imag - pole.imag) < abs(pole.real)
    size = float(np.linalg.norm(whole[near]))
    return float(np.linalg.norm(left[near])) / size if near.any() and size > 0.0 else math.inf


# On their skirts -----------------------------------------------------------------------------------------------


def _on_skirts(data: Lines, modes: Modes) -> NDArray[np.bool_]:
    """Return modes that are hardly larger than the error of the others, which is at most peaks."""
    size = _relative_sizes(data, modes)
    strong = size >= STRONG
    if strong.all() or strong.sum() < PEAKS:
        return np.zeros(len(size), bool)
    alone, _ = settled(data, modes.only(strong))
    return np.asarray(~strong & (size < GHOST * _at_most_peaks(slow_errors(data, alone))))


def _at_most_peaks(errors: Array) -> float:
    """Return the error that half of the peaks or more have; 0 where it is known at too few."""
    known = np.sort(errors[np.isfinite(errors)])
    return float(known[(len(known) - 1) // 2]) if len(known) >= PEAKS else 0.0


def _relative_sizes(data: Lines, modes: Modes) -> Array:
    """Return the size of each mode at the line nearest to it as a part of that of all others there, (N,)."""
    known, at = data.known, modes.poles.imag / (2.0 * math.pi)
    nearest = np.abs(data.frequencies - at[:, None]).argmin(axis=1)
    s = 2j * math.pi * data.frequencies[nearest]
    own = modes.residues[:, known] / (s - modes.poles)[:, None]
    others = np.linalg.norm(data.H[nearest][:, known] - own, axis=1)
    return np.asarray(np.linalg.norm(own, axis=1) / np.maximum(others, 1e-300))


def slow_errors(data: Lines, modes: Modes) -> Array:
    """Return what modes leave that varies slowly over the lines of each, as a part of the functions there, (N,).

    Noise is as often of one sign as of the other some lines on; an error of the model is not.  NaN for a peak of few
    lines.
    """
    known, f = data.known, data.frequencies
    left = _left(data, modes)[:, known]
    later = np.minimum(np.searchsorted(data.place, data.place + LAG), len(f) - 1)
    paired = data.place[later] == data.place + LAG
    found = np.full(len(modes.poles), np.nan)
    for k, (centre, half) in enumerate(
        zip(modes.poles.imag / (2.0 * math.pi), modes.half_widths, strict=True)
    ):
        near = np.abs(f - centre) < 2.0 * half
        first = np.flatnonzero(near & paired & near[later])
        if len(first) < FEWEST:
            continue
        products = (left[first].conj() * left[later[first]]).real
        whole = float((np.abs(data.H[first][:, known]) ** 2).mean())
        noise = float((np.abs(np.diff(left[near], axis=0)) ** 2).mean()) / 2.0
        slow = float(products.mean())
        sure = slow > SURE * noise / math.sqrt(products.size)
        found[k] = math.sqrt(slow / whole) if sure and whole > 0.0 else 0.0
    return found


def _left(data: Lines, modes: Modes) -> Complex:
    """Return what modes leave of the functions, without what is smooth, at the lines of their groups, (F, S, R)."""
    left = np.zeros(data.H.shape, complex)
    for members in groups(modes.poles):
        one = group_fit(data, modes, members)
        left[one.lines] = residual(one.at, one.fit) * one.at.sigma[:, None, None]
    return left
