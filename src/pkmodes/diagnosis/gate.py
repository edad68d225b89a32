"""The gate: whether what a fit leaves is noise."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.diagnosis.score import Scores

#: The gate's tests, each at this level: is there more left than noise, does it point at a candidate, and could the
#: modes that a cause adds have been missed?
ALPHA = 0.01
#: The level of the gate where one cause was found: what it leaves must surely be more than noise to refuse it
#: and to seek a second, and a rival that does not reach it is none.
SURELY = 1e-3


@dataclass(frozen=True)
class Gate:
    """Whether what a fit leaves is noise.

    Attributes
    ----------
    p_value : float
        Of the sum of squares.
    p_candidates : float
        Of the best candidate, calibrated for their number.
    unpaired : int
        Measured modes that the model has no mode for.
    p_missing : float
        Of the modes that causes add among the measured ones and that were not measured.
    scores : Scores
    level : float
        Of the tests.
    """

    p_value: float
    p_candidates: float
    unpaired: int
    p_missing: float
    scores: Scores
    level: float = ALPHA

    @property
    def passed(self) -> bool:
        """Nothing is left beyond noise."""
        return self.above(self.level)

    def above(self, level: float) -> bool:
        """All tests pass at a level."""
        return self.unpaired == 0 and min(self.p_value, self.p_candidates, self.p_missing) > level
