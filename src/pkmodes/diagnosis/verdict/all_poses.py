r"""Test of a result on all setups, the held-out ones included.

Held-out setups take no part in any choice or fit, so they can refuse a result.  The prediction errors :math:`r_h` of
their frequencies, and of shapes with stated errors, have the predictive covariance

.. math:: V_h + J_h C J_h^T

with the covariance :math:`V_h` of these data, their derivatives :math:`J_h` and the covariance :math:`C` of the
fitted parameters.  Remote causes are tried again on all setups: with more data, one of these may be better.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.search.search import Search
from pkmodes.diagnosis.verdict import reasons
from pkmodes.diagnosis.verdict.all_setups import AllSetups


@dataclass(frozen=True)
class HeldOut:
    """What held-out setups say about a result.

    Attributes
    ----------
    doubt : str
        Why they contradict it; empty if they do not.
    notes : tuple of str
        Sentences about their rows.
    """

    doubt: str = ""
    notes: tuple[str, ...] = ()


def tested(setups: AllSetups, search: Search, final: Fit) -> HeldOut:
    """Test a result on all setups.

    Parameters
    ----------
    search : Search
        Of the fitted setups.
    final : Fit
        Its result, with or without causes.
    """
    if not setups.is_held.any():
        return HeldOut()
    c = search.criteria
    every, again = _fitted_to_all(setups, search, final)
    if again is None:
        return HeldOut(reasons.not_everywhere(final.causes))
    aside: frozenset[int] = frozenset()
    p_value = p_held_out(setups, every.store.fitter, again, final, aside)
    if p_value <= c.surely:
        again, aside, p_value = _without_one_row(setups, every.store, again, final, p_value)
    better = _better(every, again)
    if p_value > c.surely:
        if better is not None:
            return HeldOut(reasons.together(final.causes, better.causes))
        return HeldOut(notes=tuple(_check(setups, row) for row in sorted(aside)))
    instead = better or _explaining(every, again)
    return HeldOut(reasons.held_out(final.causes, p_value, instead.causes if instead else ()))


def p_held_out(setups: AllSetups, every: Fitter, again: Fit, final: Fit, aside: frozenset[int]) -> float:
    """Return the p-value of the prediction errors of the held-out setups.

    Parameters
    ----------
    every : Fitter
        At all setups.
    again, final : Fit
        The same hypothesis fitted to all setups, and to those that are not held out.
    aside : frozenset of int
        Held-out rows that are left out.
    """
    held = setups.is_held.copy()
    held[list(aside)] = False
    stated = every.shapes.known & every.shapes.stated & held
    rows = np.concatenate([held, np.repeat(stated, every.shapes.sigma.shape[1])])
    predicted = every.evaluated(again.hypothesis, final.values, final.scatter)
    if predicted is None:
        return 0.0
    data = slice(0, len(rows))
    white, rates = predicted.white[data][rows], predicted.jacobian[data][rows]
    # (1 + J C J^T)^-1 = 1 - J (C^-1 + J^T J)^-1 J^T
    inside = np.linalg.pinv(final.covariance, hermitian=True) + rates.T @ rates
    squares = float(white @ white - (rates.T @ white) @ np.linalg.lstsq(inside, rates.T @ white)[0])
    count = int(held.sum()) + int(every.shapes.count[stated].sum())
    return float(stats.chi2.sf(max(squares, 0.0), max(count, 1)))


def _fitted_to_all(setups: AllSetups, search: Search, final: Fit) -> tuple[Search, Fit | None]:
    """Return a search with the same candidates at all setups, and the same hypothesis fitted to them.

    The scatter of shapes without stated errors may be larger at the held-out setups.
    """
    fitter = search.store.fitter
    hypothesis = _in_all(setups, fitter, final.hypothesis)

    def fitted(scatter: float) -> tuple[FitStore, Fit | None]:
        store = FitStore(Fitter(setups.structure, setups.data, fitter.criteria, scatter))
        return store, store.fit(hypothesis, final.values)

    store, again = fitted(fitter.shape_scatter)
    scatter = None if again is None else store.shape_scatter(again)
    if scatter is not None and scatter > fitter.shape_scatter:
        store, again = fitted(scatter)
    return Search(store, setups.structure.candidates), again


def _in_all(setups: AllSetups, fitter: Fitter, hypothesis: Hypothesis) -> Hypothesis:
    """Return a hypothesis with the indices of its excluded rows among all rows."""
    lines = fitter.data.lines[sorted(hypothesis.excluded)]
    return replace(hypothesis, excluded=frozenset(np.flatnonzero(np.isin(setups.data.lines, lines)).tolist()))


def _without_one_row(
    setups: AllSetups, store: FitStore, again: Fit, final: Fit, p_value: float
) -> tuple[Fit, frozenset[int], float]:
    """Return the fit and the p-value without the worst held-out row, if that row alone contradicts the fit.

    A gross error in a held-out row is set aside on the same terms as in a fitted one: there are enough rows, and the
    others predict it.
    """
    fitter, c = store.fitter, store.fitter.criteria
    kept = again, frozenset[int](), p_value
    if len(fitter.log) < c.rows_to_set_aside:
        return kept
    worst, sigmas = fitter.worst_rows(again)
    row = next((int(r) for r in worst if setups.is_held[r]), None)
    if row is None or sigmas[row] <= c.far or again.leverage[row] >= c.redundant:
        return kept
    h = again.hypothesis
    without = store.fit(replace(h, excluded=h.excluded | {row}), again.values)
    if without is None:
        return kept
    left = p_held_out(setups, fitter, without, final, frozenset({row}))
    return (without, frozenset({row}), left) if left > c.surely else kept


def _check(setups: AllSetups, row: int) -> str:
    data = setups.data
    return (
        f"line {data.lines[row]} (held-out {data.labels[data.pose[row]]}, {data.frequency[row]:g} Hz) does not agree "
        "with the other held-out rows: check it"
    )


def _better(every: Search, again: Fit) -> Fit | None:
    """Return the remote cause that explains all setups better than one claimed cause does; None if none does."""
    c, store = every.criteria, every.store
    plain = len(again.causes) == 1 and not again.hypothesis.excluded
    if not again.causes or (plain and every.gate(again).above(c.plainly)):
        return None
    limit = store.criterion(again) - c.survives
    # One with the same predictions is listed in the class of the cause.
    others = (fit for fit in every.alone() if store.fitter.difference(again, fit) >= c.told_apart)
    return next((fit for fit in others if store.criterion(fit) < limit and every.gate(fit).passed), None)


def _explaining(every: Search, again: Fit) -> Fit | None:
    """Return the best single cause, remote ones included, that explains all setups; None if none does."""
    fits = sorted([*every.additions.singles(), *every.alone()], key=every.store.criterion)
    return next((fit for fit in fits if fit.causes != again.causes and every.gate(fit).passed), None)
