"""The rule of a verdict for frequencies that depend on the level of excitation."""

from __future__ import annotations

import math

from pkmodes.loop.diagnosis.readings.amplitude import format_level_dependence
from pkmodes.loop.diagnosis.verdict import misfit
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Evidence

#: A dependence decides if its chi2 is at least this part of what causes explain, and the best explanation leaves.
MIN_PART_OF_CHI2 = 0.1


def depends_on_amplitude(e: Evidence) -> Answer | None:
    """Frequencies depend on the level, by a tenth of the chi2 that causes explain, and of that which they leave."""
    trend = e.amplitude
    if trend is None or not trend.significant or trend.squares < MIN_PART_OF_CHI2 * _chi2_to_compare(e):
        return None
    description = format_level_dependence(trend, e.fitter.data)
    return Answer(
        f"the residual depends on amplitude, and no candidate of a linear model does: {description}; no cause is "
        "claimed from levels that contradict each other: diagnose those of the lowest level by themselves",
        decided_by_reading=True,
    )


def _chi2_to_compare(e: Evidence) -> float:
    """Return the chi2 with which a dependence is compared; infinite if the data show nothing else."""
    final, declared = e.final, e.outcome.nuisance_fit
    if not e.outcome.last_gate.passed:
        # The best explanation without errors of the measurement and without remote causes.
        fits = [
            fit
            for fit in e.store.all_fits()
            if not ((h := fit.hypothesis).remote or h.excluded_rows or h.has_shared_error)
        ]
        best = min(fits, key=e.store.criterion, default=declared)
        unexplained = misfit.frequency_misfit_without_priors(e.store, best).squares
        return max(
            unexplained, misfit.frequency_misfit_without_priors(e.store, declared).squares - unexplained
        )
    if final.causes:
        return declared.deviance - final.deviance
    errors = final.hypothesis.excluded_rows or final.hypothesis.has_shared_error
    return misfit.frequency_misfit_without_priors(e.store, declared).squares if errors else math.inf
