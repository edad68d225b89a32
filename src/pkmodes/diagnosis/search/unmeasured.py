"""Modes that a model has where modes were looked for, and that nobody measured.

Not every mode is measured at every pose, so that a missing one says little by itself, and how many are missed is not
known.  But a cause that adds modes where others were measured, and none of its own, has to explain why these were
missed and the others were not: given how many modes a hypothesis has there and how many of them were missed, the
missed ones are among the added ones no more often than chance puts them there (hypergeometric; Fisher's exact test).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit


class Seen(NamedTuple):
    """Modes of a model where modes were looked for, and how many of them nobody measured."""

    modes: int
    unmeasured: int


def seen(fitter: Fitter, fit: Fit) -> Seen:
    """Count the modes of a fit between the lowest and highest measured ones of each setup."""
    margin, logs = fitter.criteria.margin, fit.prediction.log_frequencies
    used, visible = fitter.used(fit.hypothesis), _visible(fitter, fit)
    paired, unmeasured = int((fit.pairing.partner >= 0).sum()), 0
    for setup, rows in enumerate(fitter.noise.rows):
        if not len(rows):
            continue
        # A test may have stopped after the highest, whatever its band: what lies above says nothing.
        low, high = fitter.log[rows].min() + margin, fitter.log[rows].max() - margin
        between = np.flatnonzero((logs[setup] > low) & (logs[setup] < high) & visible[setup])
        between = between[between >= fit.prediction.rigid]
        free = between[~np.isin(between, fit.pairing.partner[rows])]
        # An excluded row may be one of them.
        unmeasured += max(len(free) - int((~used[rows]).sum()), 0)
    return Seen(paired + unmeasured, unmeasured)


def _visible(fitter: Fitter, fit: Fit) -> NDArray[np.bool_]:
    """Which modes move the sensors by more than a part of what others do; all where no sensor is known."""
    shapes, moves = fit.prediction.shapes[..., fitter.pairer.columns], fitter.pairer.moves
    if not shapes.shape[-1]:
        return np.ones(shapes.shape[:2], dtype=bool)
    peaks = np.sqrt(np.mean((shapes / np.where(moves > 0.0, moves, np.inf)[:, None]) ** 2, axis=-1))
    usual = np.median(peaks[:, fit.prediction.rigid :], axis=1)
    return np.asarray(peaks >= fitter.criteria.visible * usual[:, None])


def p_unmeasured(fitter: Fitter, declared: Fit, fit: Fit) -> float:
    """Probability that so many of the modes which a fit adds to those of the declared model were missed.

    A cause of whose modes most were measured needs no excuse for the others.  Where no sensor is known, modes may be
    missed because they do not move any, and what their absence says counts half as much.
    """
    before, after = seen(fitter, declared), seen(fitter, fit)
    missed = max(after.unmeasured - before.unmeasured, 0)
    measured = max(after.modes - after.unmeasured - before.modes + before.unmeasured, 0)
    if missed <= measured:
        return 1.0
    total = after.modes + 1  # and one that might have been there
    p = float(stats.hypergeom.sf(missed - 1, total, after.unmeasured, min(missed + measured, total)))
    return p if len(fitter.pairer.columns) else float(np.sqrt(p))


def never_measured(fitter: Fitter, fit: Fit) -> list[tuple[float, float, int]]:
    """Modes that should have been measured at half of the setups or more, and were not at any.

    Returns
    -------
    list of (lowest frequency, highest frequency, number of setups) [Hz]
    """
    margin, logs = fitter.criteria.margin, fit.prediction.log_frequencies
    visible, found = _visible(fitter, fit), []
    measured = np.zeros(logs.shape, dtype=bool)
    paired = fit.pairing.partner >= 0
    measured[fitter.data.pose[paired], fit.pairing.partner[paired]] = True
    low, high = (np.full(len(logs), value) for value in (np.inf, -np.inf))
    if fitter.data.band is None:
        np.minimum.at(low, fitter.data.pose, fitter.log)
        np.maximum.at(high, fitter.data.pose, fitter.log)
    else:
        low[:], high[:] = np.log(fitter.data.band)
    inside = (logs > low[:, None] + margin) & (logs < high[:, None] - margin) & visible
    for k in range(fit.prediction.rigid, logs.shape[1]):
        count = int(inside[:, k].sum())
        if count >= max(2, len(logs) / 2) and not measured[:, k].any():
            frequencies = np.exp(logs[inside[:, k], k])
            found.append((float(frequencies.min()), float(frequencies.max()), count))
    return found
