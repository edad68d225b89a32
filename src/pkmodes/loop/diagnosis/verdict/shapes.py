"""Measured shapes that contradict an explanation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore


def shapes_disagree(store: FitStore, fit: Fit) -> bool:
    """Return whether the measured shapes differ from those of the modes at their frequencies.

    Either more than a few are clearly shapes of another mode, or all of them scatter implausibly.
    """
    fitter, c = store.fitter, store.fitter.criteria
    is_compared = np.isfinite(fit.pairing.mac) & fitter.used_row_mask(fit.hypothesis)
    scatter = store.shape_scatter(fit)
    return len(strange_shapes(store, fit)) > int(is_compared.sum()) // c.shapes.strange_allowed or (
        scatter is not None and scatter > c.shapes.most_scatter
    )


def strange_shapes(store: FitStore, fit: Fit) -> NDArray[np.intp]:
    """Return the rows whose shapes are not those of the modes at their frequencies.

    The MAC is low, or it is moderate and the misfit is far beyond that of all other rows: a bad shape must not be
    accepted because it raises the estimated scatter itself.
    """
    fitter, c = store.fitter, store.fitter.criteria
    used_row_mask = fitter.used_row_mask(fit.hypothesis)
    mac = np.where(used_row_mask, np.nan_to_num(fit.pairing.mac, nan=1.0), 1.0)
    observations = fitter.observations
    squares = (observations.by_row(SHAPE, fit.white) ** 2).sum(axis=1)
    degrees = observations.shapes.count * used_row_mask - observations.by_row(SHAPE, fit.leverage).sum(axis=1)
    other_degrees = np.maximum(degrees.sum() - degrees, 1e-9)
    ratio = (squares / np.maximum(degrees, 1e-9)) / np.maximum(
        (squares.sum() - squares) / other_degrees, 1e-300
    )
    testable = (degrees > 0.5) & (other_degrees > 0.5)
    p_value = np.where(
        testable, stats.f.sf(ratio, np.maximum(degrees, 0.5), np.maximum(other_degrees, 0.5)), 1.0
    )
    outlying = p_value * max(int(testable.sum()), 1) < c.gate.surely
    return np.flatnonzero((mac < c.shapes.strange_mac) | (outlying & (mac < c.shapes.good_mac)))


def better_by_shape(store: FitStore, fit: Fit) -> Fit | None:
    """Return the explanation that fits the shapes best, if it fits significantly better than this one; else None.

    The difference of the sums of squares, in units of the scatter of the better fit, is compared with the threshold
    for telling two causes apart; the additional parameter of a pair of causes is accounted for.
    """
    fitter, c = store.fitter, store.fitter.criteria
    if not fitter.observations.shapes.known.any():
        return None

    def squares(compared_fit: Fit) -> float:
        white = compared_fit.white[fitter.observations.data_slice(SHAPE)]
        return float(white @ white)

    excluded_count = len(fit.hypothesis.excluded_rows)
    options = [
        option
        for option in store.all_fits()
        if len(option.causes) <= len(fit.causes) and len(option.hypothesis.excluded_rows) == excluded_count
    ]
    best = min(options, key=squares, default=fit)
    misfits = (fitter.misfit(best, SHAPE, stated=stated) for stated in (True, False))
    degrees = max(sum(misfit.degrees for misfit in misfits), 1.0)
    # A scatter larger than assumed applies to both; a smaller one is not credible.
    variance = max(squares(best) / degrees, 1.0)
    gain = (squares(fit) - squares(best)) / variance
    min_gain = c.claim.told_apart + stats.chi2.isf(c.gate.surely, c.search.most_causes)
    return best if gain > min_gain else None
