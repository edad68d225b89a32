"""Where to measure next: the pose at which two explanations that remain differ most."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.verdict.result import NextMeasurement

#: Poses that are looked at.
POSES = 80


def next_measurement(fitter: Fitter, contested: Sequence[tuple[str, Fit]]) -> NextMeasurement | None:
    """Propose a pose.

    Parameters
    ----------
    fitter : Fitter
    contested : sequence of (str, Fit)
        Names and fits of the explanations that the data do not tell apart, the best first.

    Returns
    -------
    NextMeasurement or None
        None where no pose separates any of them from the best.
    """
    if len(contested) < 2:
        return None
    others = fitter.structure.elsewhere(POSES)
    if others is None or not len(others[0]):
        return None
    points, structure = others
    modes = int(np.median(np.bincount(fitter.data.pose)))
    noise = float(np.median(fitter.sigma))
    predictions = [
        _lowest(structure.predict(fit.values, ()).log_frequencies, modes, fit) for _, fit in contested
    ]
    best: NextMeasurement | None = None
    for (name, _), prediction in zip(contested[1:], predictions[1:], strict=True):
        away = np.sqrt(np.sum(((prediction - predictions[0]) / noise) ** 2, axis=1))
        if not np.isfinite(away).any():
            continue
        k = int(np.nanargmax(away))
        if away[k] >= fitter.criteria.worth_measuring and (best is None or away[k] > best.sigmas):
            names = (contested[0][0], name)
            best = NextMeasurement(tuple(points[k].tolist()), names, float(away[k]))
    return best


def _lowest(logs: Array, modes: int, fit: Fit) -> Array:
    """The lowest modes that are measured; a formerly rigid one counts when it is paired."""
    rigid = fit.prediction.rigid
    paired = fit.pairing.partner[fit.pairing.partner >= 0]
    first = int(paired.min()) if len(paired) else rigid
    return logs[:, first : first + modes]
