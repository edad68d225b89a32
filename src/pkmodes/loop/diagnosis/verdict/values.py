"""Tests of the value of a cause: significant, inside its bounds, and not determined by a single row."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.core.base.numbers import plain, round_to_sigma
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.search import Search

#: A cause shows in one row only if this row contributes more than this fraction of the squared changes that the cause
#: produces.
MIN_FRACTION_IN_ONE_ROW = 0.5


def value_objection(search: Search, final: Fit) -> str:
    """Return which cause has a value at a bound, or one not distinct from the declared one; empty if none has."""
    fitter, c = search.store.fitter, search.criteria
    for cause in final.causes:
        for i in fitter.parameter_indices(cause):
            p, value, sigma = fitter.parameters[i], float(final.values[i]), final.sigma_of(i)
            for bound in (p.lower, p.upper):
                if bound != p.value and np.isfinite(bound) and abs(value - bound) < c.claim.bounded * sigma:
                    return (
                        f"{cause.name} would explain the residual, but its value, "
                        f"{round_to_sigma(value, sigma)}, is at its bound {plain(bound, 4)}: "
                        "something else may be the cause"
                    )
        if wald_p_value(search, final, cause) > c.claim.absent:
            return (
                f"{cause.name} would explain the residual, but its value is not significantly different from the "
                "declared one: something else must be the cause"
            )
    return ""


def wald_p_value(search: Search, final: Fit, cause: Candidate) -> float:
    """Return the p-value of a Wald test that the values of a cause are the declared ones.

    The likelihood ratio is not used: without a smooth minimum, chi2 can fall by more than the values explain.
    """
    fitter = search.store.fitter
    index = list(fitter.parameter_indices(cause))
    sigma = np.array([final.sigma_of(i) or 1.0 for i in index])
    deviations = (final.values[index] - fitter.declared[index]) / sigma
    information = np.linalg.pinv(final.covariance_of(index) / np.outer(sigma, sigma), hermitian=True)
    if cause.form:  # a term is absent without its first parameter, whatever the others are
        deviations, information = deviations[:1], information[:1, :1]
    return float(stats.chi2.sf(float(deviations @ information @ deviations), len(deviations)))


def single_row_objection(search: Search, final: Fit) -> str:
    """Return which single row determines a cause or its value; empty if none does."""
    store, c = search.store, search.criteria
    fitter, h = store.fitter, final.hypothesis
    used_row_mask = fitter.used_row_mask(h)
    leverage = np.where(used_row_mask, final.leverage[fitter.observations.frequency_slice], 0.0)
    rows = [int(row) for row in np.argsort(leverage)[::-1] if leverage[row] > c.search.redundant]
    for cause in final.causes:
        index = list(fitter.parameter_indices(cause))
        sigma = [final.sigma_of(i) for i in index]
        for row in rows:
            if shows_in_one_row_only(search, final, cause, row):
                continue
            hypothesis = replace(h, excluded_rows=h.excluded_rows | {row})
            hypothesis_without_cause = replace(
                hypothesis, causes=tuple(other for other in h.causes if other != cause)
            )
            fit_with_cause = store.fit(hypothesis, final.values)
            fit_without_cause = store.fit(
                hypothesis_without_cause, store.values_without(final, hypothesis_without_cause)
            )
            if fit_with_cause is None or fit_without_cause is None:
                continue
            gain = max(fit_without_cause.deviance - fit_with_cause.deviance, 0.0)
            is_lost = float(stats.chi2.sf(gain, len(index))) > c.claim.claimed
            sigma_of_change = np.hypot(sigma, [fit_with_cause.sigma_of(i) for i in index])
            change = np.abs(fit_with_cause.values[index] - final.values[index])
            has_moved = change > c.claim.moved * sigma_of_change
            if is_lost or has_moved.any():
                data = fitter.data
                value_without_row = float(fit_with_cause.values[index[int(np.argmax(has_moved))]])
                consequence = f"its value would be {plain(value_without_row, 4)}"
                if is_lost:
                    consequence = "it would not be detected"
                return (
                    f"{cause.name} would explain the residual, but depends on line {data.lines[row]} "
                    f"({data.labels[data.pose[row]]}, {data.frequency[row]:g} Hz) alone: without that row, "
                    f"{consequence}; check the row"
                )
    return ""


def shows_in_one_row_only(search: Search, final: Fit, cause: Candidate, row: int) -> bool:
    """Return whether a cause can show only in one row: it hardly changes other modes, all measured at one setup.

    Only then can no other row tell an erroneous row from the cause: there is a single setup, and the cause hardly
    changes its other modes.
    """
    store, fitter = search.store, search.store.fitter
    if not search.criteria.claim.one_row_suffices or len(fitter.data.labels) > 1:
        return False
    hypothesis = replace(final.hypothesis, causes=tuple(other for other in final.causes if other != cause))
    fit_without_cause = fitter.fit_at_values(
        hypothesis, store.values_without(final, hypothesis), final.shared_error
    )
    if fit_without_cause is None:
        return False
    rows, used_row_mask = fitter.observations.frequency_slice, fitter.used_row_mask(final.hypothesis)
    change = (fit_without_cause.residual - final.residual)[rows] / fitter.observations.sigma
    squares = np.where(used_row_mask, change**2, 0.0)
    return bool(squares[row] > MIN_FRACTION_IN_ONE_ROW * squares.sum())


def single_row_in_words(search: Search, final: Fit) -> str:
    """Return, as a clause, the only row in which a cause can show; empty if there is none."""
    data = search.store.fitter.data
    lines = {
        int(data.lines[row])
        for cause in final.causes
        for row in range(len(data.lines))
        if shows_in_one_row_only(search, final, cause, row)
    }
    if not lines:
        return ""
    return (
        f"it shows mostly in line {min(lines)}, a mode that was measured only once: measure it again to rule out a "
        "mistaken row"
    )
