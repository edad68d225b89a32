"""Survivors of the comparison, and their equivalence classes.

A rival survives if it explains the measurements nearly as well as the best fit.  Survivors whose predictions differ
by less than the data can resolve form one class: a claim always concerns the whole class.

Causes may be nested, such as one value for all joints and one value for each joint: the signature of the special
cause lies in the span of the signatures of the general one.  Nested causes do not contradict each other: the general
one always fits at least as well.  It is needed only if it fits better than its additional parameters would by chance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pkmodes.core.support.grouping import grouped
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, orthonormal
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array, Candidate
from pkmodes.loop.diagnosis.search.score import score
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.search.unmeasured import p_unmeasured

#: Largest part of the signature of a special case outside the span of the general cause's signatures: difference
#: derivatives are this accurate, and a random direction in a space with two more dimensions than the span is this
#: close to it once in a million.
MAX_PART_OUTSIDE_SPAN = 1e-3


def survivors(search: Search, rivals: Sequence[Fit]) -> list[Fit]:
    """Return the rivals that these data do not exclude, best first."""
    store, c = search.store, search.criteria
    passing_fits = [
        fit
        for fit in rivals
        if not fit.at_bound and store.p_value(fit) > c.gate.surely and are_added_modes_credible(search, fit)
    ]
    if not passing_fits:
        return []
    criteria = np.array([store.criterion(fit) for fit in passing_fits])
    order = np.argsort(criteria, kind="stable")
    best_fits = [
        passing_fits[i]
        for i in order
        if criteria[i] <= criteria.min() + c.search.survives and store.improves_prediction(passing_fits[i])
    ]
    # If predictions are equal, additional parameters are not penalised: they must not exclude a general rival.
    deviance_of_alike = {
        i: passing_fits[i].deviance
        for i in order
        if best_fits and store.fitter.squared_difference(best_fits[0], passing_fits[i]) < c.claim.told_apart
    }
    lowest_deviance = min(deviance_of_alike.values(), default=0.0)
    further_fits = [
        passing_fits[i]
        for i, deviance in deviance_of_alike.items()
        if deviance <= lowest_deviance + c.search.survives
    ]
    if best_fits:
        further_fits += [fit for fit in passing_fits if _remains_beside(store, fit, best_fits[0])]
    return best_fits + [fit for fit in further_fits if all(fit is not survivor for survivor in best_fits)]


def _remains_beside(store: FitStore, part: Fit, whole: Fit) -> bool:
    """Return whether a part, such as one direction of a frame, remains where the whole explains the data best.

    The whole brings modes close to each other, whose shapes follow noise: it may fit shapes better although only the
    part is true, by 12 at most on the rig.  Frequencies have no such freedom: where the part explains these better,
    it remains however it fits the shapes.
    """
    c = store.fitter.criteria
    if not _is_part_of_cause(part, whole):
        return False
    is_near = store.criterion(part) <= store.criterion(whole) + c.claim.told_apart
    return (
        is_near
        or store.frequency_misfit(part).squares < store.frequency_misfit(whole).squares - c.search.survives
    )


def _is_part_of_cause(part: Fit, whole: Fit) -> bool:
    """Return whether the last cause of a fit is a part of that of another, such as one direction of a frame."""
    return bool(part.causes and whole.causes) and part.causes[-1].part_of == whole.causes[-1].name


def are_added_modes_credible(search: Search, fit: Fit) -> bool:
    """Return whether unmeasured modes that the causes of a fit add may have been missed by chance."""
    store = search.store
    declared = store.fit(Hypothesis()) or fit
    return p_unmeasured(store.fitter, declared, fit) > search.criteria.gate.surely


def other_pairs(search: Search, final: Fit, classes_by_cause: Sequence[Sequence[Sequence[Fit]]]) -> list[Fit]:
    """Return the survivors other than a pair of causes: pairs outside its classes, and single remote causes.

    Both causes may differ at once, as between a structure and its mirror image.  If there are many pairs within its
    classes, each of them also survives separately.
    """
    if len(final.causes) < 2:
        return []
    store, c, h = search.store, search.criteria, final.hypothesis
    pairs = [
        fit
        for fit in store.all_fits()
        if len(fit.causes) == len(final.causes) == c.search.most_causes
        and (fit.hypothesis.excluded_rows, fit.hypothesis.has_shared_error)
        == (h.excluded_rows, h.has_shared_error)
    ]
    names_by_cause = [{fit.causes[-1].name for fit in groups[0]} for groups in classes_by_cause if groups]
    are_many = int(np.prod([len(names) for names in names_by_cause])) > c.claim.most_pairs
    remaining_pairs = []
    for pair in survivors(search, sorted(pairs, key=store.criterion)):
        a, b = (cause.name for cause in pair.causes)
        is_within_classes = len(names_by_cause) == 2 and (
            (a in names_by_cause[0] and b in names_by_cause[1])
            or (b in names_by_cause[0] and a in names_by_cause[1])
        )
        # A pair of other causes is another explanation, even if its predictions are the same.
        if {a, b} != {cause.name for cause in final.causes} and (are_many or not is_within_classes):
            remaining_pairs.append(pair)
    remote = [
        fit
        for fit in search.single_remote_causes()
        if store.criterion(fit) <= store.criterion(final) + c.search.survives
    ]
    return remaining_pairs + [
        fit for fit in remote if store.p_value(fit) > c.gate.surely and not fit.at_bound
    ]


def classes(store: FitStore, fits: Sequence[Fit]) -> list[list[Fit]]:
    """Group survivors that these data cannot tell apart, the class of the best one first.

    A whole and a part of it that fit nearly as well are not told apart by differences in the shapes of close modes.
    """
    max_difference = store.fitter.criteria.claim.told_apart

    def are_alike(member: Fit, fit: Fit) -> bool:
        is_whole_and_part = _is_part_of_cause(fit, member) or _is_part_of_cause(member, fit)
        difference = abs(store.criterion(fit) - store.criterion(member)) if is_whole_and_part else math.inf
        return min(difference, store.fitter.squared_difference(fit, member)) < max_difference

    return grouped(fits, are_alike)


def count_distinct_causes(members: Sequence[Fit]) -> int:
    """Return the number of causes in a class, a whole and its parts counted once."""
    causes = [fit.causes[-1] for fit in members]
    names = {cause.name for cause in causes}
    return sum(cause.part_of not in names for cause in causes)


def lacks_whole(members: Sequence[Fit]) -> bool:
    """Return whether a class has several parts of a whole that is not in it, such as two directions of a frame.

    Data that do not show along which direction a frame yields do not show either that it yields along one of them
    rather than obliquely, or by rocking.
    """
    causes = [fit.causes[-1] for fit in members]
    names = {cause.name for cause in causes}
    names_of_wholes = [cause.part_of for cause in causes if cause.part_of and cause.part_of not in names]
    return len(set(names_of_wholes)) < len(names_of_wholes)


def are_nested(fitter: Fitter, a: Fit, b: Fit) -> bool:
    """Return whether two fits differ in one cause, and one of these is a special case of the other at both fits."""
    of_a = [cause for cause in a.causes if cause not in b.causes]
    of_b = [cause for cause in b.causes if cause not in a.causes]
    if len(of_a) != 1 or len(of_b) != 1:
        return False
    pairs = ((of_a[0], of_b[0]), (of_b[0], of_a[0]))
    return any(
        all(_is_special(fitter, fit, special, general) for fit in (a, b)) for special, general in pairs
    )


def find_more_general(search: Search, final: Fit) -> tuple[Candidate, Candidate] | None:
    """Return a cause of a fit and the more general one to which the residual points significantly, or None.

    A score test: its degrees of freedom are the additional parameters of the general cause.  The general cause is not
    fitted, because close modes could then be paired differently, a gain that the null distribution does not include.
    """
    for cause in final.causes:
        for general in search.general_candidates:
            if general.general_of != cause.name:
                continue
            scores = score(search.store.fitter, final, [general])
            if scores.by_candidate[0].p_value < search.criteria.gate.surely:
                return cause, general
    return None


def _is_special(fitter: Fitter, fit: Fit, special: Candidate, general: Candidate) -> bool:
    """Return whether the signature of one cause lies in the span of another's, and the data can resolve this."""
    used_row_mask = fitter.used_row_mask(fit.hypothesis)
    if (
        fitter.observations.degrees_of_freedom(used_row_mask)
        < len(general.parameters) + fitter.criteria.claim.redundancy
    ):
        return False
    rates, basis = _rates(fitter, fit, special), orthonormal(_rates(fitter, fit, general))
    residual = np.linalg.norm(rates - basis @ (basis.T @ rates), axis=0)
    return bool((residual <= MAX_PART_OUTSIDE_SPAN * np.linalg.norm(rates, axis=0)).all())


def _rates(fitter: Fitter, fit: Fit, cause: Candidate) -> Array:
    """Return the whitened derivatives of the data, without priors, with respect to a cause's parameters."""
    return fitter.signatures(fit, fitter.parameter_indices(cause))[1][: fitter.prior_slice.start]
