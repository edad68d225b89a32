"""Goodness of fit of each part of the data: frequencies, shapes, declared values of uncertain parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore


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


def of_frequencies(store: FitStore, fit: Fit) -> Misfit:
    """Return the misfit of the measured frequencies, without the priors."""
    fitter = store.fitter
    rows = fitter.frequency_rows
    count = len(fitter.log) - len(fit.hypothesis.excluded) - int(fit.hypothesis.scatter)
    return Misfit(float(fit.white[rows] @ fit.white[rows]), count - float(fit.leverage[rows].sum()))


def of_shapes(store: FitStore, fit: Fit) -> Misfit:
    """Return the misfit of the shapes with stated errors."""
    return Misfit(*store.fitter.shape_misfit(fit, stated=True))


def far_away(store: FitStore, fit: Fit, among: Sequence[int]) -> tuple[str, float]:
    """Return which of some parameters is farthest from its declared value, and how far in sigma of its prior."""
    fitter = store.fitter
    away = np.abs(fitter.priors.residual(fit.values))
    distances = [
        (fitter.parameters[i].name, float(away[row]))
        for i in among
        if (row := fitter.priors.of(i)) is not None
    ]
    return max(distances, key=lambda one: one[1], default=("", 0.0))


def worst_shape(store: FitStore, fit: Fit) -> int:
    """Return the line of the measured shape that fits worst."""
    fitter = store.fitter
    white = fit.white[fitter.shape_rows].reshape(fitter.shapes.sigma.shape)
    return int(fitter.data.lines[int((white**2).sum(axis=1).argmax())])
