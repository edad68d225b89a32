"""Survivors of the comparison, and their equivalence classes.

A rival survives if it explains the measurements nearly as well as the best fit.  Survivors whose predictions differ
by less than the data can resolve form one class: a claim always concerns the whole class.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.search.search import Search
from pkmodes.diagnosis.search.unmeasured import p_unmeasured


def survivors(search: Search, rivals: Sequence[Fit]) -> list[Fit]:
    """Return the rivals that these data do not exclude, best first."""
    store, c = search.store, search.criteria
    fitting = [
        fit for fit in rivals if not fit.at_bound and store.p_value(fit) > c.surely and measured(search, fit)
    ]
    if not fitting:
        return []
    total = np.array([store.criterion(fit) for fit in fitting])
    order = np.argsort(total, kind="stable")
    surviving = [
        fitting[i] for i in order if total[i] <= total.min() + c.survives and store.predicts(fitting[i])
    ]
    # If predictions are equal, additional parameters are not penalised: they must not exclude a general rival.
    alike = {
        i: fitting[i].deviance
        for i in order
        if surviving and store.fitter.difference(surviving[0], fitting[i]) < c.told_apart
    }
    least = min(alike.values(), default=0.0)
    also = [fitting[i] for i, deviance in alike.items() if deviance <= least + c.survives]
    return surviving + [fit for fit in also if all(fit is not other for other in surviving)]


def measured(search: Search, fit: Fit) -> bool:
    """Return whether unmeasured modes that the causes of a fit add may have been missed by chance."""
    store = search.store
    declared = store.fit(Hypothesis()) or fit
    return p_unmeasured(store.fitter, declared, fit) > search.criteria.surely


def other_pairs(
    search: Search, final: Fit, pairs: Sequence[Fit], grouped: Sequence[Sequence[Sequence[Fit]]]
) -> list[Fit]:
    """Return the survivors beside a pair of causes: pairs outside its classes, and single remote causes.

    Both causes may differ at once, as between a structure and its mirror image.  If there are many pairs within its
    classes, each of them also survives separately.
    """
    if len(final.causes) < 2:
        return []
    store, c = search.store, search.criteria
    members = [{fit.causes[-1].name for fit in groups[0]} for groups in grouped if groups]
    many = int(np.prod([len(names) for names in members])) > c.most_pairs
    others = []
    for pair in survivors(search, sorted(pairs, key=store.criterion)):
        a, b = (cause.name for cause in pair.causes)
        known = len(members) == 2 and (
            (a in members[0] and b in members[1]) or (b in members[0] and a in members[1])
        )
        # A pair of other causes is another explanation, even if its predictions are the same.
        if {a, b} != {cause.name for cause in final.causes} and (many or not known):
            others.append(pair)
    alone = [fit for fit in search.alone() if store.criterion(fit) <= store.criterion(final) + c.survives]
    return others + [fit for fit in alone if store.p_value(fit) > c.surely and not fit.at_bound]


def classes(fitter: Fitter, fits: Sequence[Fit]) -> list[list[Fit]]:
    """Group survivors that these data cannot tell apart, the class of the best one first."""
    groups: list[list[Fit]] = []
    for fit in fits:
        home = next(
            (
                group
                for group in groups
                if any(fitter.difference(fit, g) < fitter.criteria.told_apart for g in group)
            ),
            None,
        )
        if home is None:
            groups.append([fit])
        else:
            home.append(fit)
    return groups
