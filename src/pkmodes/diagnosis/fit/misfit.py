"""Goodness of fit of a part of the data."""

from __future__ import annotations

from typing import NamedTuple

from scipy import stats


class Misfit(NamedTuple):
    """Sum of squares of a part of the data, and its degrees of freedom."""

    squares: float
    degrees: float

    @property
    def ratio(self) -> float:
        """Squares per degree of freedom: about 1 for noise."""
        return self.squares / max(self.degrees, 1.0)

    @property
    def p_value(self) -> float:
        """Probability of a sum at least as large for noise."""
        return float(stats.chi2.sf(self.squares, max(self.degrees, 1.0))) if self.degrees > 0.0 else 1.0
