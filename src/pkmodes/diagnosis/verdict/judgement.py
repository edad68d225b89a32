"""Judgement of a search result: whether its causes are claimed, and if not, why.

Causes are claimed unless

* another explanation fits the shapes significantly better, or the residual points to a more general cause,
* measurement errors explain the residual nearly as well,
* a remote cause is needed, or one in a single joint explains as much, or what two causes would be claimed for,
* the improvement may be chance, or the data are too few to be specific, or
* a value does not support the claim (`values`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import comb

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.search.ranges import plausible_sizes
from pkmodes.diagnosis.search.score import one_sided
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import reasons
from pkmodes.diagnosis.verdict.classes import classes, more_general, other_pairs, survivors
from pkmodes.diagnosis.verdict.notes import drift
from pkmodes.diagnosis.verdict.possible import possible
from pkmodes.diagnosis.verdict.shapes import better_by_shape, shapes_disagree
from pkmodes.diagnosis.verdict.specificity import p_coincidence
from pkmodes.diagnosis.verdict.values import doubt_of_values
from pkmodes.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, UNEXPLAINED, Verdict

#: Largest number of times that a cause is replaced by a better survivor.
PREFERENCES = 4
#: Largest number of other causes that a reason mentions.
MENTIONED = 4
#: For each cause, the classes of fits that have another cause in its place.
Grouped = tuple[list[list[Fit]], ...]


@dataclass(frozen=True)
class Judgement:
    """A verdict and its evidence.

    Attributes
    ----------
    last : Gate
        Gate of the final fit.
    grouped : tuple
        For each cause, the classes of fits that have another cause in its place; its own class is first.
    others : tuple of Fit
        Survivors beside a pair of causes.
    p_values : tuple of float
        One for each cause.
    doubt : str
        Why nothing is claimed although the residual would be explained.
    instead : Fit or None
        The explanation that is better with other errors or priors.
    left_out : tuple of str
        Sentences about what left a class, because its value is impossible.
    plausible : mapping of int to float
        Largest plausible deviations of the values of all members from the declared ones, by parameter.
    """

    verdict: Verdict
    final: Fit
    last: Gate
    grouped: Grouped
    others: tuple[Fit, ...]
    p_values: tuple[float, ...]
    doubt: str = ""
    instead: Fit | None = None
    left_out: tuple[str, ...] = ()
    plausible: Mapping[int, float] = field(default_factory=dict)


def judge(search: Search, outcome: Outcome) -> Judgement:
    """Judge the outcome of a search."""
    final, last = outcome.final, outcome.last
    if not last.passed:
        return Judgement(UNEXPLAINED, final, last, (), (), ())
    if not final.causes:
        doubt = _doubt_of_adequacy(search, final)
        return Judgement(UNEXPLAINED if doubt else ADEQUATE, final, last, (), (), (), doubt)
    final, places = _preferred(search, final)
    grouped = tuple(classes(search.store.fitter, fits) for fits in places)
    if final.hypothesis.remote and grouped[0]:
        # A cause of the same class that is not remote and passes the gate names the class.
        plain = (fit for fit in grouped[0][0] if not fit.causes[-1].remote and search.gate(fit).passed)
        final = next(plain, final)
        if not final.causes[-1].remote:  # remote causes that are not nameable are not listed in a class
            named = [fit for fit in grouped[0][0] if fit.causes[-1].nameable]
            grouped = ([named, *grouped[0][1:]], *grouped[1:])
    plausible, alike = _plausible(search, outcome.nuisances, grouped), grouped
    final, grouped, left_out = _possible(search, final, grouped, plausible)
    last = search.gate(final)
    others = tuple(other_pairs(search, final, _pairs_like(search, final), alike))
    p_values = tuple(_p_value(search, final, place) for place in range(len(final.causes)))
    kept = all(
        any(fit.causes[-1] == cause for fit in fits) for cause, fits in zip(final.causes, places, strict=True)
    )
    doubt = _doubt(search, final, last, others, p_values)
    if not last.passed or not kept or doubt:
        verdict = UNEXPLAINED
    elif others or any(len(groups) > 1 for groups in grouped) or _too_many(search, grouped):
        verdict = AMBIGUOUS
    else:
        verdict = EFFECT_FOUND
    return Judgement(verdict, final, last, grouped, others, p_values, doubt, None, left_out, plausible)


def _plausible(search: Search, plain: Fit, grouped: Sequence[Sequence[Sequence[Fit]]]) -> dict[int, float]:
    """Return the largest plausible deviations of the values of the members of all classes that would be claimed."""
    members = dict.fromkeys(fit.causes[-1] for groups in grouped if groups for fit in groups[0])
    return plausible_sizes(search.store.fitter, plain, list(members))


def _possible(
    search: Search, final: Fit, grouped: Grouped, plausible: Mapping[int, float]
) -> tuple[Fit, Grouped, tuple[str, ...]]:
    """Return the claim and its classes without members whose value is impossible, and what is said of these.

    If the one that names the class of a single cause is one of them, the best of the others names it.
    """
    classes, left_out = [], list[str]()
    for cause, groups in zip(final.causes, grouped, strict=True):
        kept, left = possible(search.store.fitter, groups[0] if groups else [], plausible)
        if left and all(fit.causes[-1] != cause for fit in kept):
            if len(final.causes) > 1 or not search.gate(kept[0]).passed:
                kept, left = groups[0], []
            else:
                final = kept[0]
        classes.append([kept, *groups[1:]] if groups else groups)
        left_out += left
    return final, tuple(classes), tuple(left_out)


def _doubt_of_adequacy(search: Search, final: Fit) -> str:
    """Return why the declared model is not adequate although its residual passes the gate; empty if it is."""
    if shapes_disagree(search.store, final):
        return reasons.shapes(())
    lines = _extra_modes(search, final)
    if lines:
        return reasons.extra(lines)
    # An error that nobody stated may just as well be an effect that the model lacks.
    if final.hypothesis.scatter:
        return reasons.shared(final.scatter, drift(search.store.fitter, final))
    return ""


def _extra_modes(search: Search, final: Fit) -> list[int]:
    """Return the lines of rows set aside where the model has no mode left near them: no error moved one there."""
    fitter, c = search.store.fitter, search.criteria
    lines = []
    for row in sorted(final.hypothesis.excluded):
        setup = fitter.data.pose[row]
        near = np.abs(final.prediction.log_frequencies[setup] - fitter.log[row]) < c.reach
        near[: final.prediction.rigid] = False
        partner = final.pairing.partner[fitter.noise.rows[setup]]
        near[partner[partner >= 0]] = False
        if not near.any():
            lines.append(int(fitter.data.lines[row]))
    return lines


def _too_many(search: Search, grouped: tuple[list[list[Fit]], ...]) -> bool:
    """Return whether a class has too many members to be informative."""
    return any(len(groups[0]) > search.criteria.most_members for groups in grouped if groups)


def _doubt(
    search: Search, final: Fit, last: Gate, others: tuple[Fit, ...], p_values: tuple[float, ...]
) -> str:
    """Return why the causes of a fit are not claimed; empty if nothing contradicts them."""
    store, c = search.store, search.criteria
    doubtful = len(final.causes) == 1 and not last.above(c.plainly)
    better = search.better_alone(final) if doubtful else []
    remote = [cause for fit in (final, *others, *better) for cause in fit.causes if cause.remote]
    if remote:
        return reasons.remote(remote[0])
    single = _in_one_joint(search, final)
    if single is not None:
        return reasons.in_one_joint(final.causes, single.causes)
    if shapes_disagree(store, final):
        return reasons.shapes(final.causes)
    rival = better_by_shape(store, final)
    if rival is not None:
        return reasons.shapes_prefer(final.causes, rival.causes)
    unlike = more_general(search, final)
    if unlike is not None:
        return reasons.unlike(*unlike)
    errors = explained_by_errors(search, final)
    if any(p > c.claimed for p in p_values):
        return reasons.weak(final.causes, max(p_values), errors)
    if len(final.causes) > 1 and len(store.fitter.log) < c.rows_for_two:
        return reasons.two_of_few(final.causes, len(store.fitter.log), c.rows_for_two)
    if errors:
        return reasons.errors(final.causes, errors)
    coincidence = p_coincidence(search, final)
    if coincidence > c.specific:
        return reasons.unspecific(final.causes, _also(search, final), coincidence)
    return doubt_of_values(search, final)


def _in_one_joint(search: Search, final: Fit) -> Fit | None:
    """Return the fit with a claimed cause in one of its joints alone that explains as much, or None.

    A claim for all joints needs the same evidence against each joint alone as against another class.
    """
    store, c = search.store, search.criteria
    if len(final.causes) != 1:
        return None
    fits = search.in_one_joint(final)
    limit = final.deviance + c.told_apart
    return next((fit for fit in fits if fit.deviance < limit and store.p_value(fit) > c.surely), None)


def _also(search: Search, final: Fit) -> list[str]:
    """Return the names of other single causes that would explain the residual, best first."""
    store = search.store
    fits = [
        fit
        for fit in store.tried()
        if len(fit.causes) == 1 and not (fit.hypothesis.remote or fit.at_bound) and fit.causes != final.causes
    ]
    passing = [fit for fit in fits if store.p_value(fit) > search.criteria.surely]
    return [fit.causes[0].name for fit in sorted(passing, key=store.criterion)[:MENTIONED]]


def _preferred(search: Search, final: Fit) -> tuple[Fit, list[list[Fit]]]:
    """Return the best survivor, and for each of its causes the survivors with another cause in its place."""
    for _ in range(PREFERENCES):
        rivals = [search.rivals(final, place) for place in range(len(final.causes))]
        places = [survivors(search, fits) for fits in rivals]
        pairs = zip(final.causes, places, strict=True)
        better = next((fits[0] for cause, fits in pairs if fits and fits[0].causes[-1] != cause), None)
        if better is None:
            return final, places
        final = better
    return final, [[] for _ in final.causes]  # the preferences do not settle: nothing is claimed


def _pairs_like(search: Search, final: Fit) -> list[Fit]:
    """Return all fits that differ from the final one only in their two causes; empty if that has fewer."""
    h = final.hypothesis
    return [
        fit
        for fit in search.store.tried()
        if len(fit.causes) == len(final.causes) == search.criteria.most_causes
        and (fit.hypothesis.excluded, fit.hypothesis.scatter) == (h.excluded, h.scatter)
    ]


def _p_value(search: Search, final: Fit, place: int) -> float:
    """Return the p-value of a likelihood-ratio test of one cause, corrected for the number of candidates."""
    cause = final.causes[place]
    less = search.store.without(final, place)
    gain = max(less.deviance - final.deviance, 0.0) if less is not None else 0.0
    p = float(stats.chi2.sf(gain, len(cause.parameters)))
    if one_sided(search.store.fitter, cause):
        p *= 0.5
    # The two causes of a pair were chosen together, from all pairs.
    return min(1.0, p * comb(len(search.candidates), len(final.causes)))


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
