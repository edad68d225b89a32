"""Stability of a verdict under other errors and priors than stated.

The explanations that the search found are refitted with all sigma halved, with all sigma doubled, and with all priors
twice as wide; there is no new search.  If another cause is then better, the cause is not claimed: it depends on
numbers that are not known to within a factor of two.  A special case of the cause, or a cause of which it is a
special case, does not count as another one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict.classes import are_nested
from pkmodes.loop.diagnosis.verdict.findings import Stability
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, UNEXPLAINED, Verdict
from pkmodes.loop.measured.scaling import with_errors

#: Factors on the errors and on the priors.
CHANGES = {"sigma x 0.5": (0.5, 1.0), "sigma x 2": (2.0, 1.0), "priors x 2": (1.0, 2.0)}


@dataclass(frozen=True)
class Trial:
    """The result of refitting the contenders under one change.

    - better_rival: an explanation outside the class of the claimed one that is better under the change, as fitted by
      the search
    - value_moved: whether wider priors change the value of the claimed cause
    """

    stability: Stability
    better_rival: Fit | None
    value_moved: bool


def trials(
    search: Search,
    final: Fit,
    classes: Sequence[Sequence[Fit]] = (),
    contenders: Sequence[Fit] | None = None,
) -> list[Trial]:
    """Refit the contenders under every change.

    - final: the claimed fit, or the last one of the search
    - classes: for each claimed cause, the fits of its class
    - contenders: other explanations; by default the best ones that were tried
    """
    store = search.store
    if contenders is None:
        others = [
            fit
            for fit in store.all_fits()
            if fit.causes
            and len(fit.causes) <= max(len(final.causes), 1)
            and not (fit.hypothesis.remote or fit.at_bound)
            and {c.name for c in fit.causes} != {c.name for c in final.causes}
            and store.criterion(fit) < store.criterion(final) + search.criteria.claim.near
        ]
        best = sorted(others, key=store.criterion)[: search.criteria.claim.contenders]
        refitted = [final, *best] if final.causes else best
    else:
        refitted = [final, *contenders]
    members = [{fit.causes[-1].name for fit in fits} for fits in classes]
    return [_run_trial(search, final, refitted, members, change) for change in CHANGES]


def unchanged_entries(verdict: Verdict) -> tuple[Stability, ...]:
    """Return entries for a verdict that does not depend on errors and priors."""
    return tuple(Stability(change, verdict.word, ()) for change in CHANGES)


def _run_trial(
    search: Search, final: Fit, contenders: list[Fit], members: Sequence[set[str]], change: str
) -> Trial:
    error_factor, prior_factor = CHANGES[change]
    as_stated = search.store.fitter
    data = as_stated.data if error_factor == 1.0 else with_errors(as_stated.data, error_factor)
    fitter = Fitter(
        as_stated.structure, data, as_stated.criteria, as_stated.shape_scatter, prior_factor=prior_factor
    )
    store, c = FitStore(fitter), fitter.criteria
    fit_without_causes = store.fit(replace(final.hypothesis, causes=()))
    refitted = [store.fit(fit.hypothesis, fit.values) for fit in contenders]
    fits = [fit for fit in refitted if fit is not None]
    claimed = refitted[0] if refitted and final.causes else None
    # Rivals with fewer causes do not count as better because they are simpler: they are not claimed.
    with_as_many_causes = [fit for fit in fits if len(fit.causes) == len(final.causes)]
    best = min(with_as_many_causes or fits, key=store.criterion, default=None)
    better_rival: Fit | None = None
    if claimed is not None and best is not None:
        ranked = sorted(with_as_many_causes, key=store.criterion)
        for fit in ranked[: [rival is claimed for rival in ranked].index(True)]:
            are_alike = fitter.squared_difference(claimed, fit) < c.claim.told_apart
            if are_alike and store.criterion(claimed) <= store.criterion(fit) + c.search.survives:
                best = claimed if fit is best else best  # one class, named after the claimed cause
                break
            fit_as_stated = contenders[[fit is refit for refit in refitted].index(True)]
            if not _is_special_case(search, final, fit_as_stated, members):
                better_rival = fit_as_stated
                break
    value_moved = claimed is not None and error_factor == 1.0 and _has_moved(fitter, final, claimed)
    if fit_without_causes is not None and store.p_value(fit_without_causes) > c.gate.level:
        return Trial(Stability(change, ADEQUATE.word, ()), better_rival, value_moved)
    if best is None or store.p_value(best) <= c.gate.surely:
        return Trial(Stability(change, UNEXPLAINED.word, ()), better_rival, value_moved)
    rivals = [
        fit
        for fit in with_as_many_causes
        if store.criterion(fit) <= store.criterion(best) + c.search.survives
        and store.p_value(fit) > c.gate.surely
        and fitter.squared_difference(best, fit) >= c.claim.told_apart
    ]
    names = tuple(cause.name for cause in best.causes)
    verdict = AMBIGUOUS if rivals else EFFECT_FOUND
    return Trial(Stability(change, verdict.word, names), better_rival, value_moved)


def _has_moved(fitter: Fitter, final: Fit, refit: Fit) -> bool:
    """Return whether the value of a claimed cause changes by far more than its standard deviation."""
    for i in (i for cause in final.causes for i in fitter.parameter_indices(cause)):
        k = final.free.index(i)
        if (
            abs(refit.values[i] - final.values[i])
            > fitter.criteria.reasons.far * final.covariance[k, k] ** 0.5
        ):
            return True
    return False


def _is_special_case(search: Search, final: Fit, rival: Fit, members: Sequence[set[str]]) -> bool:
    """Return whether one of two fits is a special case of the other, and the claimed class lists both.

    Smaller errors always favour more parameters, and larger errors fewer.  With the stated errors the simpler fit is
    adequate, the data cannot tell the two apart, and the claim covers both.
    """
    names = {c.name for c in final.causes} ^ {c.name for c in rival.causes}
    return any(names <= group for group in members) and are_nested(search.store.fitter, final, rival)
