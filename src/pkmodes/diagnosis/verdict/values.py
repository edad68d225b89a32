"""Tests of the value of a cause: significant, inside its bounds, and not determined by a single row."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.search import Search
from pkmodes.diagnosis.verdict import reasons


def doubt_of_values(search: Search, final: Fit) -> str:
    """Return why the value of some cause does not support a claim; empty if all values do."""
    fitter, c = search.store.fitter, search.criteria
    for cause in final.causes:
        index = fitter.indices(cause)
        for i in index:
            p, value, sigma = fitter.parameters[i], float(final.values[i]), final.sigma_of(i)
            for bound in (p.lower, p.upper):
                if bound != p.value and np.isfinite(bound) and abs(value - bound) < c.bounded * sigma:
                    return reasons.at_bound(cause, value, sigma, bound)
        if p_absent(search, final, cause) > c.absent:
            return reasons.near_absence(cause)
    return next((text for cause in final.causes if (text := _rests_on(search, final, cause))), "")


def p_absent(search: Search, final: Fit, cause: Candidate) -> float:
    """Return the p-value of a Wald test that the values of a cause are the declared ones.

    If the sum of squares has no smooth minimum, it may fall by far more than this change of values can explain.
    """
    fitter = search.store.fitter
    index = fitter.indices(cause)
    away = final.values[list(index)] - fitter.declared[list(index)]
    squares = float(away @ np.linalg.pinv(final.covariance_of(index), hermitian=True) @ away)
    return float(stats.chi2.sf(squares, len(index)))


def _rests_on(search: Search, final: Fit, cause: Candidate) -> str:
    """Return a reason if a single row determines a cause or its value; else empty."""
    store, c = search.store, search.criteria
    fitter, h = store.fitter, final.hypothesis
    used, index = fitter.used(h), list(fitter.indices(cause))
    leverage = np.where(used, final.leverage[fitter.frequency_rows], 0.0)
    sigma = [final.sigma_of(i) for i in index]
    for row in np.argsort(leverage)[::-1]:
        if leverage[row] <= c.redundant:
            break
        with_cause = replace(h, excluded=h.excluded | {int(row)})
        without = replace(with_cause, causes=tuple(other for other in h.causes if other != cause))
        here, less = store.fit(with_cause, final.values), store.fit(without, store.undone(final, without))
        if here is None or less is None:
            continue
        gone = float(stats.chi2.sf(max(less.deviance - here.deviance, 0.0), len(index))) > c.claimed
        both = np.hypot(sigma, [here.sigma_of(i) for i in index])
        moved = np.abs(here.values[index] - final.values[index]) > c.moved * both
        if gone or moved.any():
            data = fitter.data
            value = None if gone else float(here.values[index[int(np.argmax(moved))]])
            return reasons.rests_on(
                cause, int(data.lines[row]), data.labels[data.pose[row]], float(data.frequency[row]), value
            )
    return ""
