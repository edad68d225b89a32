"""Measurement errors that explain a residual nearly as well as causes."""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.search.search import Search
from pkmodes.diagnosis.verdict import reasons


def explained_by_errors(search: Search, final: Fit) -> str:
    """Name the errors that explain the residual nearly as well as the causes of a fit; empty if none do.

    These are outliers and a shared error as found by the search, or frequency errors larger than stated by their
    most likely factor, with the outliers and the shared error of the final fit.
    """
    store, c = search.store, search.criteria
    worst = store.criterion(final) + c.survives
    noise = [fit for fit in search.additions.errors(worst) if store.p_value(fit) > c.surely]
    best = min(noise, key=store.criterion, default=None)
    if best is not None and store.criterion(best) <= worst:
        what = reasons.noise(best, store.fitter.data.lines)
        plain = store.fit(Hypothesis())
        pattern = reasons.uneven(store.fitter, plain) if plain is not None and best.hypothesis.scatter else ""
        return f"{what}; {pattern}" if pattern else what
    h = final.hypothesis
    base = store.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    if base is None:
        return ""
    rows = len(store.fitter.log)
    squares, count = store.frequency_misfit(base)[0], rows - len(h.excluded)
    ratio = max(squares / count, 1.0)
    inflated = store.criterion(base) - squares + count * (1.0 + np.log(ratio))
    if inflated + np.log(rows) > worst:
        return ""
    return f"errors {reasons.larger(ratio**0.5)} the stated ones"
