"""Plausible ranges of candidates: beyond them, the model would describe another machine.

A limit outside its plausible range is meaningless.  The range of a parameter ends

* at its bounds, such as a third of and three times a robot parameter's declared value;
* at three standard deviations of its prior, if the candidate has one;
* otherwise, mainly for absent effects, at the size that, in the linear model, changes some frequency of the model,
  measured or not, by the largest change from which a search starts (`START_FREQUENCY_CHANGES[-1]`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Array, Candidate, Prediction
from pkmodes.loop.diagnosis.search.starts import START_FREQUENCY_CHANGES


def largest_rates(prediction: Prediction) -> Array:
    """Return the largest derivatives of ln f of any vibration mode with respect to the requested parameters, (T,)."""
    rates = np.abs(prediction.log_rates[:, prediction.rigid :])
    rates[~np.isfinite(rates)] = 0.0
    return np.asarray(rates.max(axis=(0, 1), initial=0.0))


def max_plausible_deviation(
    fitter: Fitter, candidate: Candidate, parameter_index: int, side: int, max_rate: float
) -> float:
    """Return the largest plausible deviation of a parameter of a candidate from its declared value, on one side.

    - side: 1 for larger values than the declared one, -1 for smaller ones
    - max_rate: entry of `largest_rates` for this parameter
    """
    p = fitter.parameters[parameter_index]
    distance_to_bound = p.upper - p.value if side > 0 else p.value - p.lower
    if candidate.sigma is not None:
        sigma = candidate.sigma[candidate.parameters.index(p.name)]
        max_deviation = fitter.criteria.reasons.far * sigma * (abs(p.value) if p.log else 1.0)
    elif np.isfinite(p.lower) and np.isfinite(p.upper):
        max_deviation = np.inf  # the bounds are the plausible range
    else:
        max_deviation = START_FREQUENCY_CHANGES[-1] / max_rate if max_rate > 0.0 else np.inf
    return float(min(distance_to_bound, max_deviation))


def max_plausible_deviations(fitter: Fitter, fit: Fit, candidates: Sequence[Candidate]) -> dict[int, float]:
    """Return the largest plausible deviation of each parameter of some candidates, on either side."""
    indices = list(dict.fromkeys(i for candidate in candidates for i in fitter.parameter_indices(candidate)))
    if not indices:
        return {}
    prediction = fitter.structure.predict(fit.values, indices, shape_rates=False)
    rates = dict(zip(indices, largest_rates(prediction).tolist(), strict=True))
    return {
        i: max(max_plausible_deviation(fitter, candidate, i, side, rates[i]) for side in (1, -1))
        for candidate in candidates
        for i in fitter.parameter_indices(candidate)
    }
