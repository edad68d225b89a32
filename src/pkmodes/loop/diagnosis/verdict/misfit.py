"""Where a fit is poor: the frequencies without the priors, a value far from its declared one, a shape."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import stats

from pkmodes.core.base.numbers import p_in_words, three_digits
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Misfit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.verdict.reasons import ratio_in_words


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


def larger_misfit(store: FitStore, fit: Fit) -> tuple[Misfit, str]:
    """Return the larger misfit per degree of freedom, and words for whose it is; empty for the one that pages have.

    Pages have that of the frequencies and priors; the other is that of the shapes with stated errors.
    """
    frequencies = store.frequency_misfit(fit)
    shapes = store.fitter.misfit(fit, SHAPE, stated=True)
    return (shapes, " of the shapes") if shapes.ratio > frequencies.ratio else (frequencies, "")


def residual_in_words(store: FitStore, fit: Fit, p_value: float | None = None) -> str:
    """Return the size of a residual relative to the stated errors: the root of chi-square, which stands beside it."""
    return size_in_words(*larger_misfit(store, fit), p_value)


def size_in_words(
    part: Misfit, whose: str = "", p_value: float | None = None, stated: str = "the stated errors"
) -> str:
    """Return the size of a misfit relative to the stated errors, with the chi-square of which it is the root.

    - whose: " of the shapes", or empty for the frequencies and priors of the model that is told
    """
    p_clause = "" if p_value is None else f"; {p_in_words(p_value)}"
    return (
        f"{ratio_in_words(part.ratio**0.5)} {stated} (the root of chi2 per degree of freedom{whose}, "
        f"{three_digits(part.ratio)}{p_clause})"
    )


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
