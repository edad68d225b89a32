"""What the search came to, judged: whether it is claimed, and if not, why.

A claim stands if the shapes do not prefer another cause, if no larger errors of the measurement explain the residual
nearly as well, if it takes no remote cause, if no such cause alone explains what two are claimed for, and if it
could hardly be chance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import stats

from pkmodes.diagnosis import reasons
from pkmodes.diagnosis.classes import classes, other_pairs, survivors
from pkmodes.diagnosis.fitting import Fit, Hypothesis
from pkmodes.diagnosis.gate import SURELY, Gate
from pkmodes.diagnosis.result import Verdict
from pkmodes.diagnosis.score import one_sided
from pkmodes.diagnosis.search import MOST_CAUSES, SURVIVES, Outcome, Search

#: A cause is claimed if chance would bring one as clear, among all candidates, with less than this probability.
CLAIMED = 1e-3
#: Where what one cause leaves is noise with more than this probability, no remote cause is looked for beside it.
PLAINLY = 0.2
#: A shape disagrees with its mode if 1 - MAC is above the first and so many times what is usual in these data.
STRANGE, USUAL = 0.3, 10.0
#: Times that the shapes may prefer another cause in some place.
PREFERENCES = 4


@dataclass(frozen=True)
class Judgement:
    """A verdict and what it rests on.

    Attributes
    ----------
    verdict : str
    final : Fit
    last : Gate
        At the final fit.
    grouped : tuple
        For each cause, the classes of fits with others in its place, its own first.
    others : tuple of Fit
        What survives beside a pair of causes.
    p_values : tuple of float
        Of each cause.
    doubt : str
        Why nothing is claimed though the residual would be explained.
    """

    verdict: Verdict
    final: Fit
    last: Gate
    grouped: tuple[list[list[Fit]], ...]
    others: tuple[Fit, ...]
    p_values: tuple[float, ...]
    doubt: str = ""


def judge(search: Search, outcome: Outcome) -> Judgement:
    """Judge the outcome of a search."""
    final, last = outcome.final, outcome.last
    if not last.passed:
        return Judgement("unexplained", final, last, (), (), ())
    final, places = _preferred(search, final)
    grouped = tuple(classes(search.fitter, found) for found in places)
    if any(cause.remote for cause in final.causes) and grouped[0]:
        # A plain cause that looks like it and passes the gate gives the class its name.
        plain = (fit for fit in grouped[0][0] if not fit.causes[-1].remote and search.gate(fit).passed)
        final = next(plain, final)
    last = search.gate(final)
    others = tuple(other_pairs(search, final, _pairs_like(search, final), grouped))
    p_values = tuple(_p_value(search, final, place) for place in range(len(final.causes)))
    verdict: Verdict
    kept = all(
        any(fit.causes[-1] == cause for fit in found)
        for cause, found in zip(final.causes, places, strict=True)
    )
    doubt = _doubt(search, final, last, others, p_values)
    if not last.passed or not kept or doubt:
        verdict = "unexplained"
    elif not final.causes:
        verdict = "adequate"
    elif others or any(len(groups) > 1 for groups in grouped):
        verdict = "ambiguous"
    else:
        verdict = "effect_found"
    return Judgement(verdict, final, last, grouped, others, p_values, doubt)


def _doubt(
    search: Search, final: Fit, last: Gate, others: tuple[Fit, ...], p_values: tuple[float, ...]
) -> str:
    """Why the causes of a fit are not claimed; empty where nothing speaks against them."""
    doubtful = len(final.causes) == 1 and not last.above(PLAINLY)
    better = [
        fit
        for fit in (search.alone() if doubtful else [])
        if search.criterion(fit) < search.criterion(final) - SURVIVES and search.gate(fit).passed
    ]
    remote = [cause for fit in (final, *others, *better) for cause in fit.causes if cause.remote]
    if remote:
        return reasons.remote(remote[0])
    if final.causes and _shapes_disagree(search, final):
        return reasons.shapes(final.causes)
    errors = bool(final.causes) and _explained_by_errors(search, final)
    if any(p > CLAIMED for p in p_values):
        return reasons.weak(final.causes, max(p_values), errors)
    return reasons.errors(final.causes) if errors else ""


def _shapes_disagree(search: Search, final: Fit) -> bool:
    """Whether several measured shapes are others than those of the modes that have their frequencies."""
    told = np.isfinite(final.pairing.mac) & search.fitter.used(final.hypothesis)
    lacking = final.shape_misfit[told]
    if not told.any():
        return False
    strange = lacking > max(STRANGE, USUAL * float(np.median(lacking)))
    return int(strange.sum()) > max(1, int(told.sum()) // 50)


def _explained_by_errors(search: Search, final: Fit) -> bool:
    """Whether errors of the measurement explain the residual nearly as well as the causes.

    Outliers and a shared error as the search found them, or errors larger than stated by their most likely
    factor, with the rows set aside and the shared error of the final fit.
    """
    worst = search.criterion(final) + SURVIVES
    noise = [fit for fit in search.errors() if search.p_value(fit) > SURELY]
    if any(search.criterion(fit) <= worst for fit in noise):
        return True
    h = final.hypothesis
    base = search.fit(Hypothesis(excluded=h.excluded, scatter=h.scatter))
    if base is None:
        return False
    count = len(search.fitter.log) - len(h.excluded)
    inflated = search.criterion(base) - base.chi2 + count * (1.0 + np.log(max(base.chi2 / count, 1.0)))
    return bool(inflated + np.log(len(search.fitter.log)) <= worst)


def _preferred(search: Search, final: Fit) -> tuple[Fit, list[list[Fit]]]:
    """The fit that the shapes prefer, and for each of its causes the survivors in that cause's place."""
    for _ in range(PREFERENCES):
        rivals = [search.rivals(final, place) for place in range(len(final.causes))]
        places = [survivors(search, found) for found in rivals]
        pairs = zip(final.causes, places, strict=True)
        better = next((found[0] for cause, found in pairs if found and found[0].causes[-1] != cause), None)
        if better is None:
            return final, places
        final = better
    return final, [[] for _ in final.causes]  # no preference holds: nothing is claimed


def _pairs_like(search: Search, final: Fit) -> list[Fit]:
    """Every fit with two causes that differs from the final one in nothing else, if that has two."""
    h = final.hypothesis
    return [
        fit
        for fit in search.tried()
        if len(fit.causes) == len(final.causes) == MOST_CAUSES
        and (fit.hypothesis.excluded, fit.hypothesis.scatter) == (h.excluded, h.scatter)
    ]


def _p_value(search: Search, final: Fit, place: int) -> float:
    """Likelihood-ratio test of one cause, for as many candidates as were tried."""
    cause = final.causes[place]
    less = search.without(final, place)
    gain = max(less.deviance - final.deviance, 0.0) if less is not None else 0.0
    p = float(stats.chi2.sf(gain, len(cause.parameters)))
    if one_sided(search.fitter, cause):
        p *= 0.5
    return min(1.0, p * len(search.candidates))
