"""The next measurement: the pose, perhaps with a load, at which two remaining explanations differ most."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array, Loadable, Structure
from pkmodes.diagnosis.verdict.result import NextMeasurement

#: Number of poses to choose from.
POSES = 80


def next_measurement(fitter: Fitter, contested: Sequence[tuple[str, Fit]]) -> NextMeasurement | None:
    """Propose a pose, with a load if that separates far better than any pose alone.

    Parameters
    ----------
    contested : sequence of (str, Fit)
        Names and fits of the explanations that the data cannot tell apart, best first.

    Returns
    -------
    NextMeasurement or None
        None if no pose separates any of them from the best.
    """
    if len(contested) < 2:
        return None
    others = fitter.structure.elsewhere(POSES)
    if others is None or not len(others[0]):
        return None
    points, structure = others
    best = _best(fitter, contested, points, structure, {})
    for load, loaded in structure.loaded() if isinstance(structure, Loadable) else ():
        proposed = _best(fitter, contested, points, loaded, load)
        gain = 1.0 if best is None or best.load else fitter.criteria.worth_loading
        if proposed is not None and (best is None or proposed.sigmas > gain * best.sigmas):
            best = proposed
    return best


def _best(
    fitter: Fitter,
    contested: Sequence[tuple[str, Fit]],
    points: Array,
    structure: Structure,
    load: Mapping[str, float],
) -> NextMeasurement | None:
    """Return the pose that separates most, if it is worth measuring."""
    modes = int(np.median(np.bincount(fitter.data.pose)))
    noise = float(np.median(fitter.sigma))
    # A load cannot be a parameter of an explanation: setting it would not remove that cause.
    some = [(name, fit) for name, fit in contested if not load.keys() & _names(fit)]
    if not some or some[0][1] is not contested[0][1]:
        return None
    predictions = [_lowest(structure, fit, modes) for _, fit in some]
    best: NextMeasurement | None = None
    for (name, _), prediction in zip(some[1:], predictions[1:], strict=True):
        away = np.sqrt(np.sum(((prediction - predictions[0]) / noise) ** 2, axis=1))
        if not np.isfinite(away).any():
            continue
        k = int(np.nanargmax(away))
        if away[k] >= fitter.criteria.worth_measuring and (best is None or away[k] > best.sigmas):
            names = (some[0][0], name)
            best = NextMeasurement(tuple(points[k].tolist()), names, float(away[k]), dict(load))
    return best


def _names(fit: Fit) -> set[str]:
    """Return the names of the parameters of a fit's causes."""
    return {name for cause in fit.causes for name in cause.parameters}


def _lowest(structure: Structure, fit: Fit, modes: int) -> Array:
    """Return the log frequencies of the lowest measurable modes; a formerly rigid mode counts if it is paired."""
    prediction = structure.predict(fit.values, ())
    rigid = fit.prediction.rigid
    paired = fit.pairing.partner[fit.pairing.partner >= 0]
    first = (int(paired.min()) if len(paired) else rigid) - rigid + prediction.rigid
    return prediction.log_frequencies[:, first : first + modes]
