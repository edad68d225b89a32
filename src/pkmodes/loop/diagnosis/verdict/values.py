"""Tests of the value of a cause: significant, inside its bounds, and not determined by a single row."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.core.base.numbers import plain, round_to_sigma
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.search import Search

#: A cause shows in one row if that has more than this part of the sum of squares of its changes.
ONCE = 0.5


def no_value(search: Search, final: Fit) -> str:
    """Return which cause has a value at a bound, or one not distinct from the declared one; empty if none has."""
    fitter, c = search.store.fitter, search.criteria
    for cause in final.causes:
        for i in fitter.indices(cause):
            p, value, sigma = fitter.parameters[i], float(final.values[i]), final.sigma_of(i)
            for bound in (p.lower, p.upper):
                if bound != p.value and np.isfinite(bound) and abs(value - bound) < c.claim.bounded * sigma:
                    return (
                        f"{cause.name} would explain the residual, but its value, "
                        f"{round_to_sigma(value, sigma)}, is at its bound {plain(bound, 4)}: "
                        "something else may be the cause"
                    )
        if p_absent(search, final, cause) > c.claim.absent:
            return (
                f"{cause.name} would explain the residual, but its value is not significantly different from the "
                "declared one: something else must be the cause"
            )
    return ""


def p_absent(search: Search, final: Fit, cause: Candidate) -> float:
    """Return the p-value of a Wald test that the values of a cause are the declared ones.

    If the sum of squares has no smooth minimum, it may fall by far more than such a change of values can explain.
    """
    fitter = search.store.fitter
    index = list(fitter.indices(cause))
    sigma = np.array([final.sigma_of(i) or 1.0 for i in index])
    away = (final.values[index] - fitter.declared[index]) / sigma
    information = np.linalg.pinv(final.covariance_of(index) / np.outer(sigma, sigma), hermitian=True)
    if cause.form:  # a term is absent without its first parameter, whatever the others are
        away, information = away[:1], information[:1, :1]
    return float(stats.chi2.sf(float(away @ information @ away), len(away)))


def rests_on_one_row(search: Search, final: Fit) -> str:
    """Return which single row determines a cause or its value; empty if none does."""
    store, c = search.store, search.criteria
    fitter, h = store.fitter, final.hypothesis
    used = fitter.used(h)
    leverage = np.where(used, final.leverage[fitter.observations.frequency_rows], 0.0)
    rows = [int(row) for row in np.argsort(leverage)[::-1] if leverage[row] > c.search.redundant]
    for cause in final.causes:
        index = list(fitter.indices(cause))
        sigma = [final.sigma_of(i) for i in index]
        for row in rows:
            if shows_once(search, final, cause, row):
                continue
            with_cause = replace(h, excluded=h.excluded | {row})
            without = replace(with_cause, causes=tuple(kept for kept in h.causes if kept != cause))
            here, less = store.fit(with_cause, final.values), store.fit(without, store.undone(final, without))
            if here is None or less is None:
                continue
            gone = float(stats.chi2.sf(max(less.deviance - here.deviance, 0.0), len(index))) > c.claim.claimed
            both = np.hypot(sigma, [here.sigma_of(i) for i in index])
            moved = np.abs(here.values[index] - final.values[index]) > c.claim.moved * both
            if gone or moved.any():
                data = fitter.data
                there = float(here.values[index[int(np.argmax(moved))]])
                so = "it would not be detected" if gone else f"its value would be {plain(there, 4)}"
                return (
                    f"{cause.name} would explain the residual, but depends on line {data.lines[row]} "
                    f"({data.labels[data.pose[row]]}, {data.frequency[row]:g} Hz) alone: without that row, {so}; "
                    "check the row"
                )
    return ""


def shows_once(search: Search, final: Fit, cause: Candidate, row: int) -> bool:
    """Return whether a cause by nature shows in one row: it hardly changes other modes, all measured at one setup.

    No other row could then tell a mistaken row from the cause.  Where the mode was measured at several setups, or
    the cause changes other modes as much, they could.
    """
    store, fitter = search.store, search.store.fitter
    if not search.criteria.claim.once or len(fitter.data.labels) > 1:
        return False
    less = replace(final.hypothesis, causes=tuple(kept for kept in final.causes if kept != cause))
    without = fitter.evaluated(less, store.undone(final, less), final.scatter)
    if without is None:
        return False
    rows, used = fitter.observations.frequency_rows, fitter.used(final.hypothesis)
    change = (without.residual - final.residual)[rows] / fitter.observations.sigma
    squares = np.where(used, change**2, 0.0)
    return bool(squares[row] > ONCE * squares.sum())


def once(search: Search, final: Fit) -> str:
    """Return which single row by nature shows a cause, as a clause; empty if none does."""
    data = search.store.fitter.data
    lines = {
        int(data.lines[row])
        for cause in final.causes
        for row in range(len(data.lines))
        if shows_once(search, final, cause, row)
    }
    if not lines:
        return ""
    return (
        f"it shows mostly in line {min(lines)}, a mode that was measured only once: measure it again to rule out a "
        "mistaken row"
    )
