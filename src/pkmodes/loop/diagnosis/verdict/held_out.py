r"""Held-out setups as a test of the predictions of a result, and notes on their rows.

Held-out setups take no part in any choice or fit, so they can refuse a result.  The prediction errors :math:`r_h` of
their frequencies, and of shapes with stated errors, have the predictive covariance

.. math:: V_h + J_h C J_h^T

with the covariance :math:`V_h` of these data, their derivatives :math:`J_h` and the covariance :math:`C` of the
fitted parameters.  Remote causes are tried again on all setups: with more data, one of these may be better.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.core.base.numbers import p_in_words, plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.reasons import explains, names
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.measured.measurements import Measurements

#: A held-out error that a claim increases by this factor is reported.
MIN_INCREASE = 2.0


@dataclass(frozen=True)
class HeldOut:
    """Result of the test by held-out setups.

    - doubt: why they contradict it; empty if they do not
    - notes: sentences about their rows
    """

    doubt: str = ""
    notes: tuple[str, ...] = ()


def check_held_out(
    setups: AllSetups, search: Search, final: Fit, rivals: Sequence[Fit] | None = None
) -> HeldOut:
    """Test whether a result predicts the held-out setups.

    - search: the search at the fitted setups
    - final: the fit that it ends with, with or without causes
    - rivals: other explanations of the fitted setups; by default remote causes are tried
    """
    if not setups.is_held_out.any():
        return HeldOut()
    c, clause = search.criteria, f"{explains(final.causes)} the fitted poses"
    full_search, full_fit = _fit_all_setups(setups, search, final)
    if full_fit is None:
        return HeldOut(f"{clause}, but with these values the held-out ones cannot be evaluated")
    p_value = p_held_out(setups, full_search.store.fitter, full_fit.hypothesis, final)
    if p_value <= c.gate.surely:
        full_fit, p_value = _without_one_row(setups, full_search.store, full_fit, final, p_value)
    better_fit = (
        _better_remote_cause(full_search, full_fit)
        if rivals is None
        else _best_rival(full_search, full_fit, rivals)
    )
    if p_value > c.gate.surely:
        if better_fit is not None:
            return HeldOut(
                f"{names(final.causes)} would explain all poses, but {names(better_fit.causes)} explains them "
                "better: look there"
            )
        excluded_rows = (row for row in sorted(full_fit.hypothesis.excluded_rows) if setups.is_held_out[row])
        remark = "does not agree with the other held-out rows: check it"
        return HeldOut(notes=tuple(f"{_row_in_words(setups.data, row)} {remark}" for row in excluded_rows))
    other_cause = better_fit
    if other_cause is None and rivals is None:
        # The best single cause, remote ones included, that explains all setups.
        single_causes = [*full_search.additions.single_causes(), *full_search.single_remote_causes()]
        other_cause = next(
            (
                fit
                for fit in sorted(single_causes, key=full_search.store.criterion)
                if fit.causes != full_fit.causes and full_search.gate(fit).passed
            ),
            None,
        )
    other_cause_clause = (
        f"; {names(other_cause.causes)} would explain all poses: look there" if other_cause else ""
    )
    return HeldOut(f"{clause}, but not the held-out ones ({p_in_words(p_value)}){other_cause_clause}")


def p_of_held_out(setups: AllSetups, search: Search, final: Fit) -> float:
    """Return the p-value of the prediction errors of the held-out setups at a fit, as in the test of a result.

    - search: the search at the fitted setups
    - final: the final fit to these setups
    """
    if not setups.is_held_out.any():
        return 1.0
    full_search, full_fit = _fit_all_setups(setups, search, final)
    if full_fit is None:
        return 0.0
    p_value = p_held_out(setups, full_search.store.fitter, full_fit.hypothesis, final)
    if p_value <= search.criteria.gate.surely:
        _, p_value = _without_one_row(setups, full_search.store, full_fit, final, p_value)
    return p_value


def p_held_out(setups: AllSetups, fitter: Fitter, hypothesis: Hypothesis, final: Fit) -> float:
    """Return the p-value of the prediction errors of the held-out setups, without excluded rows.

    - fitter: at all setups
    - hypothesis: about all setups; the causes are those of the fit
    - final: to the setups that are not held out
    """
    is_tested = setups.is_held_out & fitter.used_row_mask(hypothesis)
    rows, count = fitter.observations.mask_of_stated(is_tested)
    predictions = fitter.fit_at_values(hypothesis, final.values, final.shared_error)
    if predictions is None:
        return 0.0
    data_part = slice(0, len(rows))
    white, rates = predictions.white[data_part][rows], predictions.jacobian[data_part][rows]
    # (1 + J C J^T)^-1 = 1 - J (C^-1 + J^T J)^-1 J^T
    inner_matrix = np.linalg.pinv(final.covariance, hermitian=True) + rates.T @ rates
    squares = float(white @ white - (rates.T @ white) @ np.linalg.lstsq(inner_matrix, rates.T @ white)[0])
    return float(stats.chi2.sf(max(squares, 0.0), max(count, 1)))


def _fit_all_setups(setups: AllSetups, search: Search, final: Fit) -> tuple[Search, Fit | None]:
    """Return a search with the same candidates at all setups, and the same hypothesis fitted to them.

    The scatter of shapes without stated errors may be larger at the held-out setups.
    """
    fitter = search.store.fitter
    # Excluded rows have other indices among all rows.
    lines = fitter.data.lines[sorted(final.hypothesis.excluded_rows)]
    excluded_rows = frozenset(np.flatnonzero(np.isin(setups.data.lines, lines)).tolist())
    hypothesis = replace(final.hypothesis, excluded_rows=excluded_rows)

    def fit_with_scatter(scatter: float) -> tuple[FitStore, Fit | None]:
        store = FitStore(Fitter(setups.structure, setups.data, fitter.criteria, scatter))
        return store, store.fit(hypothesis, final.values)

    store, full_fit = fit_with_scatter(fitter.shape_scatter)
    scatter = None if full_fit is None else store.shape_scatter(full_fit)
    if scatter is not None and scatter > fitter.shape_scatter:
        store, full_fit = fit_with_scatter(scatter)
    return Search(store, setups.structure.candidates), full_fit


def _without_one_row(
    setups: AllSetups, store: FitStore, full_fit: Fit, final: Fit, p_value: float
) -> tuple[Fit, float]:
    """Return the fit and the p-value without the worst held-out row, if that row alone contradicts the fit.

    A gross error in a held-out row is set aside under the same conditions as in a fitted one: there are enough rows,
    and the others predict it.
    """
    fitter, c, h = store.fitter, store.fitter.criteria, full_fit.hypothesis
    ranked_rows, normalised_residuals = fitter.rows_by_residual(full_fit)
    row = next(int(r) for r in ranked_rows if setups.is_held_out[r])
    has_enough_rows = len(fitter.observations.log_frequencies) >= c.search.rows_to_set_aside
    if (
        not has_enough_rows
        or normalised_residuals[row] <= c.reasons.far
        or full_fit.leverage[row] >= c.search.redundant
    ):
        return full_fit, p_value
    fit_without_row = store.fit(replace(h, excluded_rows=h.excluded_rows | {row}), full_fit.values)
    p_without_row = (
        0.0 if fit_without_row is None else p_held_out(setups, fitter, fit_without_row.hypothesis, final)
    )
    return (
        (fit_without_row, p_without_row)
        if fit_without_row is not None and p_without_row > c.gate.surely
        else (full_fit, p_value)
    )


def _better_remote_cause(search: Search, full_fit: Fit) -> Fit | None:
    """Return the remote cause that explains all setups better than the claimed causes do; None if none does."""
    c = search.criteria
    has_single_cause = len(full_fit.causes) == 1 and not full_fit.hypothesis.excluded_rows
    if not full_fit.causes or (has_single_cause and search.gate(full_fit).passes_at(c.gate.plainly)):
        return None
    # A remote cause with the same predictions is listed in the class of the cause.
    difference = search.store.fitter.squared_difference
    return next(
        (
            fit
            for fit in search.better_remote_causes(full_fit)
            if difference(full_fit, fit) >= c.claim.told_apart
        ),
        None,
    )


def _best_rival(search: Search, full_fit: Fit, rivals: Sequence[Fit]) -> Fit | None:
    """Return the rival that explains all setups significantly better than the claimed causes; None if none does."""
    store, c, hypothesis = search.store, search.criteria, full_fit.hypothesis
    fits = [
        store.fit(replace(hypothesis, causes=rival.causes), rival.values)
        for rival in rivals
        if rival.causes != full_fit.causes
    ]
    limit = store.criterion(full_fit) - c.search.survives
    fitted_rivals = sorted((fit for fit in fits if fit is not None), key=store.criterion)
    difference = store.fitter.squared_difference
    return next(
        (
            fit
            for fit in fitted_rivals
            if store.criterion(fit) < limit
            and store.p_value(fit) > c.gate.surely
            and difference(full_fit, fit) >= c.claim.told_apart
        ),
        None,
    )


def held_out_remarks(
    data: Measurements,
    is_held_out: NDArray[np.bool_],
    predicted_frequencies: Array,
    before: Error,
    after: Error | None,
) -> Iterator[str]:
    """Yield sentences about the held-out rows of a result that they do not contradict.

    - is_held_out: rows of held-out poses, (R,)
    - predicted_frequencies: frequencies of the last stage, (R,) [Hz], NaN where the model has no mode
    - before, after: errors after refitting the nuisance parameters, and with the claimed causes
    """
    for i in np.flatnonzero(is_held_out & np.isnan(predicted_frequencies)):
        yield f"{_row_in_words(data, int(i))} is unmatched: the held-out error does not include it"
    if after is None or before.held_out_rms_relative is None or after.held_out_rms_relative is None:
        return
    if after.held_out_rms_relative > MIN_INCREASE * before.held_out_rms_relative:
        log_errors = np.where(
            is_held_out, np.nan_to_num(np.abs(np.log(predicted_frequencies / data.frequency))), 0.0
        )
        yield (
            "the error of the held-out poses grows from "
            f"{plain(100 * before.held_out_rms_relative, 2)} to {plain(100 * after.held_out_rms_relative, 2)} %; "
            f"the worst is {_row_in_words(data, int(log_errors.argmax()))}"
        )


def _row_in_words(data: Measurements, i: int) -> str:
    return f"line {data.lines[i]} (held-out {data.labels[data.pose[i]]}, {data.frequency[i]:g} Hz)"
