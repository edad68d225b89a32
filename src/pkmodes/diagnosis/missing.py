"""Modes that a model has among the measured ones and that nobody measured.

Not every mode is measured at every pose, so that a missing one says little by itself.  But a cause that adds modes
where others were measured, and none of its own, has to explain why they were missed: with the part q of modes that
the declared model misses among the measured ones, n more of them have the probability q^n.
"""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fitting import Fit, Fitter

#: A mode is among the measured ones of its setup if it is farther than this from the outer ones, in ln f.
MARGIN = 0.01


def not_measured(fitter: Fitter, fit: Fit) -> int:
    """Number of the fit's modes between the lowest and highest measured ones of their setup that nobody measured."""
    count, logs, used = 0, fit.prediction.log_frequencies, fitter.used(fit.hypothesis)
    for setup, rows in enumerate(fitter.noise.rows):
        if not len(rows):
            continue
        low, high = fitter.log[rows].min() + MARGIN, fitter.log[rows].max() - MARGIN
        between = np.flatnonzero((logs[setup] > low) & (logs[setup] < high))
        free = between[(between >= fit.prediction.rigid) & ~np.isin(between, fit.pairing.partner[rows])]
        count += max(len(free) - int((~used[rows]).sum()), 0)  # an excluded row may be one of them
    return count


def p_missing(fitter: Fitter, declared: Fit, fit: Fit) -> float:
    """Probability that the modes which a fit adds to those of the declared model were all missed."""
    before = not_measured(fitter, declared)
    added = max(not_measured(fitter, fit) - before, 0)
    part = (before + 0.5) / (before + len(fitter.log) + 1.0)  # Jeffreys' prior
    return float(part**added)
