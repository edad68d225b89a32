"""What the data can tell apart: survivors of the comparison, and classes of them that are one to these data.

A rival survives if it explains the measurements nearly as well as the best.  Two survivors whose predictions
differ by less than the data would show with some certainty are one class: no claim goes beyond it.  Where shapes
were measured they vote too, with the scatter that the best fit leaves.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.diagnosis.fitting import Fit, Fitter
from pkmodes.diagnosis.gate import SURELY
from pkmodes.diagnosis.search import SURVIVES, Search

#: Predictions that differ by less than this sum of squares are not told apart by these data: had one been true,
#: the other would have survived too often.
TOLD_APART = 25.0
#: Pairs of causes that are one to these data, at most, for two causes to be claimed.
MOST_ALIKE = 4
#: Scatter of measured shapes that is taken as the least, as a fraction of a shape.
LEAST_SHAPE_SCATTER = 0.01


def survivors(search: Search, rivals: Sequence[Fit]) -> list[Fit]:
    """Rivals that these data do not exclude, best first.

    Parameters
    ----------
    search : Search
    rivals : sequence of Fit
        Best first, by the criterion.
    """
    fitting = [
        fit for fit in rivals if min(search.p_value(fit), search.p_missing(fit)) > SURELY and not fit.at_bound
    ]
    if not fitting:
        return []
    votes = _votes(search.fitter, fitting)
    total = np.array([search.criterion(fit) + vote for fit, vote in zip(fitting, votes, strict=True)])
    order = np.argsort(total, kind="stable")
    found = [fitting[i] for i in order if total[i] <= total.min() + SURVIVES and search.predicts(fitting[i])]
    # More parameters cost nothing where the predictions are the same: what says more is not excluded by that.
    alike = {
        i: fitting[i].deviance + votes[i]
        for i in order
        if found and search.fitter.difference(found[0], fitting[i]) < TOLD_APART
    }
    least = min(alike.values(), default=0.0)
    also = [fitting[i] for i, deviance in alike.items() if deviance <= least + SURVIVES]
    return found + [fit for fit in also if all(fit is not other for other in found)]


def other_pairs(
    search: Search, final: Fit, pairs: Sequence[Fit], grouped: Sequence[Sequence[Sequence[Fit]]]
) -> list[Fit]:
    """What survives beside a pair of causes: pairs that are not of its classes, and single remote causes.

    Those of its classes survive too, each on its own, where they are many.
    """
    if len(final.causes) < 2:
        return []
    members = [{fit.causes[-1].name for fit in groups[0]} for groups in grouped if groups]
    many = int(np.prod([len(names) for names in members])) > MOST_ALIKE
    found = []
    for pair in survivors(search, sorted(pairs, key=search.criterion)):
        a, b = (cause.name for cause in pair.causes)
        known = len(members) == 2 and (
            (a in members[0] and b in members[1]) or (b in members[0] and a in members[1])
        )
        if (not known and search.fitter.difference(final, pair) >= TOLD_APART) or (
            many and {a, b} != {cause.name for cause in final.causes}
        ):
            found.append(pair)
    alone = [fit for fit in search.alone() if search.criterion(fit) <= search.criterion(final) + SURVIVES]
    return found + [fit for fit in alone if search.p_value(fit) > SURELY and not fit.at_bound]


def classes(fitter: Fitter, found: Sequence[Fit]) -> list[list[Fit]]:
    """Group survivors that these data cannot tell apart, the best one's class first."""
    groups: list[list[Fit]] = []
    for fit in found:
        home = next(
            (group for group in groups if any(fitter.difference(fit, g) < TOLD_APART for g in group)), None
        )
        if home is None:
            groups.append([fit])
        else:
            home.append(fit)
    return groups


def _votes(fitter: Fitter, rivals: Sequence[Fit]) -> list[float]:
    """Differences of the shapes' misfit, in units of the scatter that the best of the rivals leaves.

    No row counts more than a rival may differ from the best: where two modes come close, small errors of the
    parameters turn one shape by more than its own error.
    """
    count = fitter.pairer.shape_components
    if count == 0:
        return [0.0] * len(rivals)
    misfits = np.array([fit.shape_misfit for fit in rivals])
    variance = max(float(misfits.sum(axis=1).min()) / count, LEAST_SHAPE_SCATTER**2)
    votes = np.minimum((misfits - misfits.min(axis=0)) / variance, SURVIVES).sum(axis=1)
    return [float(vote) for vote in votes - votes.min()]
