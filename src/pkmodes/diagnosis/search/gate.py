"""The gate: whether what a fit leaves is noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.score import Scores, score
from pkmodes.diagnosis.search.unmeasured import p_unmeasured


@dataclass(frozen=True)
class Gate:
    """Whether what a fit leaves is noise.

    Attributes
    ----------
    p_value : float
        Of the sum of squares: the smaller one of frequencies with priors, and of shapes with stated errors.
    p_candidates : float
        Of the best candidate, calibrated for their number.
    unpaired : int
        Measured modes that the model has no mode for.
    p_unmeasured : float
        Of the modes that causes add among the measured ones and that were not measured.
    scores : Scores
    level : float
        Of the tests.
    """

    p_value: float
    p_candidates: float
    unpaired: int
    p_unmeasured: float
    scores: Scores
    level: float

    @property
    def passed(self) -> bool:
        """Nothing is left beyond noise."""
        return self.above(self.level)

    def above(self, level: float) -> bool:
        """All tests pass at a level."""
        return self.unpaired == 0 and min(self.p_value, self.p_candidates, self.p_unmeasured) > level


def gate(store: FitStore, fit: Fit, candidates: Sequence[Candidate]) -> Gate:
    """Test what a fit leaves.

    Parameters
    ----------
    store : FitStore
    fit : Fit
    candidates : sequence of Candidate
        Those that what is left may point at.
    """
    fitter, criteria = store.fitter, store.fitter.criteria
    scores = score(fitter, fit, [candidate for candidate in candidates if candidate not in fit.causes])
    unpaired = int((fit.pairing.partner[fitter.used(fit.hypothesis)] < 0).sum())
    found = len(fit.causes) == 1 and not fit.causes[0].remote
    level = criteria.surely if found else criteria.gate
    unmeasured = p_unmeasured(fitter, store.fit(Hypothesis()) or fit, fit)
    p_value = store.p_value(fit)
    # Whatever the residual points at, where it is already too large for noise nothing has to be drawn.
    candidate = scores.p_value if p_value > criteria.surely else scores.bound
    return Gate(p_value, candidate, unpaired, unmeasured, scores, level)
