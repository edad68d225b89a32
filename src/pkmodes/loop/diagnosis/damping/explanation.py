"""The best explanation of damping by losses that may differ from the declared ones, with its class and its rivals.

Hypotheses are the declared losses, each suspected loss alone, and each pair in which either is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb

import numpy as np
from scipy import stats

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.damping.fit import AT_BOUND_FRACTION, LossFit, LossFitter

#: No measurement separates two explanations whose squared difference is below this.
MIN_SEPARATION = 1.0


@dataclass(frozen=True, eq=False)
class LossExplanation:
    """Losses that leave noise.

    - classes: for each cause, the fits of its class, the best explanation first
    - rivals: explanations that are as good and belong to no class, the best first
    - p_values: one for each cause
    """

    best: LossFit
    classes: tuple[tuple[LossFit, ...], ...]
    rivals: tuple[LossFit, ...]
    p_values: tuple[float, ...]

    @property
    def losses_of_classes(self) -> set[int]:
        """All losses of its classes."""
        return {j for class_fits in self.classes for fit in class_fits for j in fit.causes}


def best_explanation(fitter: LossFitter) -> LossExplanation | None:
    """Return the best explanation by one loss, else by two if there are enough rows; None if none leaves noise."""
    c = fitter.criteria
    singles = [fitter.fit((j,)) for j in fitter.candidates]
    sizes = (1, 2) if int(fitter.observations.resolved_mask.sum()) >= c.claim.rows_for_two else (1,)
    for size in sizes:
        fits = singles
        if size == 2:  # pairs in which each loss is needed in addition to the other
            fits = [
                fit
                for fit in map(fitter.fit, combinations(fitter.candidates, 2))
                if all(p_of_one_more(fitter, fitter.fit((j,)), fit) <= c.claim.claimed for j in fit.causes)
            ]
        passing = [fit for fit in fits if _explains(fitter, fit, c.gate.level)]
        if passing:
            return _with_rivals(fitter, fits, min(passing, key=lambda fit: fit.criterion))
    return None


def _with_rivals(fitter: LossFitter, fits: Sequence[LossFit], best: LossFit) -> LossExplanation:
    """Return the best explanation with the others of its size."""
    c = fitter.criteria
    near_fits = [fit for fit in fits if fit.criterion < best.criterion + c.search.survives]
    survivors = [fit for fit in near_fits if fit is best or _explains(fitter, fit, c.gate.surely)]
    class_fits = [fit for fit in survivors if fitter.squared_difference(best, fit) < c.claim.told_apart]
    class_fits.sort(key=lambda fit: (not all(fitter.losses[j].effect for j in fit.causes), fit.criterion))
    # An effect names the class among explanations that no measurement separates, and in any class whose best member
    # is not a cause.
    claimable = all(fitter.losses[j].claimable for j in best.causes)
    inseparable = [
        fit for fit in class_fits if not claimable or fitter.squared_difference(best, fit) < MIN_SEPARATION
    ]
    best = inseparable[0] if inseparable else best
    classes = tuple(
        (
            best,
            *(fit for fit in class_fits if fit is not best and set(best.causes) - {cause} < set(fit.causes)),
        )
        for cause in best.causes
    )
    rivals = [
        fit
        for fit in survivors
        if not any(fit is member for class_members in classes for member in class_members)
    ]
    rivals.sort(key=lambda fit: fit.criterion)
    remaining_causes = [tuple(j for j in best.causes if j != cause) for cause in best.causes]
    p_values = tuple(
        p_of_one_more(fitter, fitter.fit(other_causes), best) for other_causes in remaining_causes
    )
    return LossExplanation(best, classes, tuple(rivals), p_values)


def _explains(fitter: LossFitter, fit: LossFit, level: float) -> bool:
    """Return whether a fit leaves noise, and each of its causes is present."""
    absent_causes = [j for j in fit.causes if j in fit.absent_losses and not fitter.declared[j]]
    at_bound = [j for j in fit.causes if fit.values[j] > AT_BOUND_FRACTION * fitter.losses[j].parameter.upper]
    return fit.p_value > level and not absent_causes and not at_bound


def p_of_loss(fitter: LossFitter, loss: int) -> float:
    """Return the p-value of one loss in addition to the declared ones, for this candidate alone."""
    return p_of_one_more(fitter, fitter.fit(), fitter.fit((loss,))) / max(len(fitter.candidates), 1)


def p_of_one_more(fitter: LossFitter, smaller: LossFit, larger: LossFit) -> float:
    """Return the p-value of a likelihood-ratio test of one more loss, corrected for the number of hypotheses.

    These are the candidates, or their pairs if the fit has two, but not fewer than the candidates.
    """
    candidates = len(fitter.candidates)
    hypothesis_count = max(comb(candidates, len(larger.causes)), candidates)
    (added_loss,) = set(larger.causes) - set(smaller.causes)
    gain = max(smaller.chi2 + smaller.price - larger.chi2 - larger.price, 0.0)
    one_sided_factor = 1.0 if fitter.declared[added_loss] else 0.5
    return min(1.0, one_sided_factor * float(stats.chi2.sf(gain, 1)) * hypothesis_count)


def nearest_loss(fitter: LossFitter) -> str:
    """Return how far the nearest single loss is from the damping, in words."""
    fits = [fit for fit in (fitter.fit((j,)) for j in fitter.candidates) if fit.causes]
    if not fits:
        return "no loss shows in these modes"
    best = min(fits, key=lambda fit: fit.chi2)
    deviation = (fitter.observations.logarithms - fitter.observations.predicted_logarithms(best.values))[
        fitter.observations.resolved_mask
    ]
    factor = float(np.exp(np.sqrt(np.mean(np.minimum(np.abs(deviation), 10.0) ** 2))))
    name = loss_names(fitter, best)
    return (
        f"no loss or pair of losses explains it; the nearest, {name}, leaves a factor of {plain(factor, 2)}"
    )


def loss_names(fitter: LossFitter, fit: LossFit) -> str:
    """Return the names of the causes of a fit."""
    return " + ".join(fitter.losses[j].candidate for j in fit.causes)
