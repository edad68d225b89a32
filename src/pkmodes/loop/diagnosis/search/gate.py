"""The gate: tests whether the residual of a fit is noise."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.search.score import Scores
from pkmodes.loop.diagnosis.search.unmeasured import p_unmeasured


@dataclass(frozen=True)
class Gate:
    """The tests whether the residual of a fit is noise.

    - p_value: p-value of the sum of squares: the smaller one of frequencies with priors, and of shapes with stated
      errors
    - p_candidates: p-value of the best candidate, calibrated for their number
    - unpaired_count: number of unmatched measured modes
    - p_unmeasured: p-value of the unmeasured modes that causes add between the measured ones
    - level: level of the tests
    """

    p_value: float
    p_candidates: float
    unpaired_count: int
    p_unmeasured: float
    scores: Scores
    level: float

    @property
    def passed(self) -> bool:
        """Whether the residual is noise."""
        return self.passes_at(self.level)

    def passes_at(self, level: float) -> bool:
        """Return whether all tests pass at a level."""
        return self.unpaired_count == 0 and min(self.p_value, self.p_candidates, self.p_unmeasured) > level


def gate(store: FitStore, fit: Fit, scores: Scores) -> Gate:
    """Test the residual of a fit.

    - scores: scores of the candidates to which the residual may point
    """
    fitter, criteria = store.fitter, store.fitter.criteria
    unpaired_count = int((fit.pairing.partner[fitter.used_row_mask(fit.hypothesis)] < 0).sum())
    one_cause = len(fit.causes) == 1 and not fit.hypothesis.remote
    level = criteria.gate.surely if one_cause else criteria.gate.level
    p_unmeasured_modes = p_unmeasured(fitter, store.fit(Hypothesis()) or fit, fit)
    p_value = store.p_value(fit)
    # If the residual is already too large for noise, the bound suffices and no draws are needed.
    p_candidates = scores.p_value if p_value > criteria.gate.surely else scores.bound
    return Gate(p_value, p_candidates, unpaired_count, p_unmeasured_modes, scores, level)
