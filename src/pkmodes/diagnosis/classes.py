"""What the data can tell apart: survivors of the comparison, and classes of them that are one to these data.

A rival survives if it explains the measurements nearly as well as the best.  Two survivors whose predictions
differ by less than the data would show with some certainty are one class: no claim goes beyond it.  Where shapes
were measured they vote too, with the scatter that the best fit leaves.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.diagnosis.fitting import Fit, Fitter
from pkmodes.diagnosis.search import SURVIVES, Search

#: Predictions that differ by less than this sum of squares are not told apart by these data: had one been true,
#: the other would have survived too often.
TOLD_APART = 25.0
#: A rival must bring the residual to the noise as well, at a level below that of the gate.
LEFT_BY_A_RIVAL = 1e-3
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
    if not rivals:
        return []
    fitting = [fit for fit in rivals if search.p_value(fit) > LEFT_BY_A_RIVAL and not fit.at_bound]
    if not fitting:
        return []
    votes = _votes(search.fitter, fitting)
    total = [search.criterion(fit) + vote for fit, vote in zip(fitting, votes, strict=True)]
    best = min(total)
    found = [fitting[i] for i in np.argsort(total, kind="stable") if total[i] <= best + SURVIVES]
    return [fit for fit in found if search.predicts(fit)]


def other_pairs(
    search: Search, final: Fit, pairs: Sequence[Fit], grouped: Sequence[Sequence[Sequence[Fit]]]
) -> list[Fit]:
    """Pairs of causes that survive beside the one that was found and are not of its classes."""
    members = [{fit.causes[-1].name for fit in groups[0]} for groups in grouped if groups]
    found = []
    for pair in survivors(search, sorted(pairs, key=search.criterion)):
        a, b = (cause.name for cause in pair.causes)
        known = len(members) == 2 and (
            (a in members[0] and b in members[1]) or (b in members[0] and a in members[1])
        )
        if not known and search.fitter.difference(final, pair) >= TOLD_APART:
            found.append(pair)
    return found


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
    """Differences of the shapes' misfit, in units of the scatter that the best fit leaves."""
    count = fitter.pairer.shape_components
    if count == 0:
        return [0.0] * len(rivals)
    misfits = np.array([fit.shape_misfit for fit in rivals])
    variance = max(float(misfits.min()) / count, LEAST_SHAPE_SCATTER**2)
    return [float(vote) for vote in (misfits - misfits.min()) / variance]
