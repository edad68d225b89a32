"""Whether measured shapes speak against an explanation."""

from __future__ import annotations

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore


def shapes_disagree(store: FitStore, fit: Fit) -> bool:
    """Whether measured shapes are others than those of the modes that have their frequencies.

    More than a few that are plainly those of another mode, or a scatter of all that no measurement has.
    """
    fitter, c = store.fitter, store.fitter.criteria
    told = np.isfinite(fit.pairing.mac) & fitter.used(fit.hypothesis)
    strange = int((fit.pairing.mac[told] < c.strange_mac).sum())
    scatter = store.shape_scatter(fit)
    return strange > int(told.sum()) // c.strange_allowed or (
        scatter is not None and scatter > c.most_shape_scatter
    )


def better_by_shape(store: FitStore, fit: Fit) -> Fit | None:
    """The explanation that fits the shapes best, if it does so significantly better.

    By the difference of the sums of squares in units of the scatter that the better one leaves, judged as generously
    as between two causes; that a pair of causes has one parameter more is counted.
    """
    fitter, c = store.fitter, store.fitter.criteria
    if not fitter.shapes.known.any():
        return None

    def squares(of: Fit) -> float:
        white = of.white[fitter.shape_rows]
        return float(white @ white)

    known = len(fit.hypothesis.excluded)
    tried = [
        other
        for other in store.tried()
        if len(other.causes) <= len(fit.causes) and len(other.hypothesis.excluded) == known
    ]
    best = min(tried, key=squares, default=fit)
    degrees = max(fitter.shape_misfit(best, True)[1] + fitter.shape_misfit(best, False)[1], 1.0)
    # A scatter larger than assumed is the same for both; a smaller one is not believed.
    variance = max(squares(best) / degrees, 1.0)
    gain = (squares(fit) - squares(best)) / variance
    needed = c.told_apart + stats.chi2.isf(c.surely, c.most_causes)
    return best if gain > needed else None
