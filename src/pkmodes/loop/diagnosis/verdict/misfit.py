"""Where a fit is poor: the frequencies without the priors, a value far from its declared one, a shape."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Misfit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore


def frequency_misfit_without_priors(store: FitStore, fit: Fit) -> Misfit:
    """Return the misfit of the measured frequencies, without the priors."""
    fitter = store.fitter
    rows = fitter.observations.frequency_slice
    count = (
        len(fitter.observations.log_frequencies)
        - len(fit.hypothesis.excluded_rows)
        - int(fit.hypothesis.has_shared_error)
    )
    return Misfit(float(fit.white[rows] @ fit.white[rows]), count - float(fit.leverage[rows].sum()))


def p_declared(store: FitStore, fit: Fit) -> float:
    """Return the p-value of the frequencies of the model as declared, over the rows that a fit used."""
    fitter = store.fitter
    used_row_mask = fitter.used_row_mask(fit.hypothesis)
    *_, chi2 = fitter.evaluate(fitter.declared, used_row_mask)
    return float(stats.chi2.sf(chi2, max(int(used_row_mask.sum()), 1)))


def farthest_value(store: FitStore, fit: Fit, indices: Sequence[int]) -> tuple[str, float]:
    """Return which of the given parameters is farthest from its declared value, and how far in sigma of its prior."""
    fitter = store.fitter
    sigmas = np.abs(fitter.priors.distances(fit.values))
    distances = [
        (fitter.parameters[i].name, float(sigmas[row]))
        for i in indices
        if (row := fitter.priors.row_of(i)) is not None
    ]
    return max(distances, key=lambda distance: distance[1], default=("", 0.0))


def worst_shape(store: FitStore, fit: Fit) -> int:
    """Return the line of the measured shape that fits worst."""
    fitter = store.fitter
    white = fitter.observations.by_row(SHAPE, fit.white)
    return int(fitter.data.lines[int((white**2).sum(axis=1).argmax())])
