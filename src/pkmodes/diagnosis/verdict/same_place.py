"""Poses at one position whose frequencies differ: one of them was probably somewhere else."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array

#: Positions nearer than this are one [m].
NEAR = 1e-6


def same_place(fitter: Fitter, fit: Fit) -> Iterator[str]:
    """Name pairs of poses at the same position where most of the modes that both have differ clearly.

    Parameters
    ----------
    fitter : Fitter
    fit : Fit
        Says which rows are the same mode.
    """
    data = fitter.data
    if not data.points.any():  # setups without positions
        return
    sigma = _errors(fitter, fit)
    order = np.argsort(data.points[:, 0], kind="stable")
    along = data.points[order, 0]
    ends = np.searchsorted(along, along + NEAR, side="right")
    for place, (i, end) in enumerate(zip(order, ends, strict=True)):
        rest = order[place + 1 : end]
        apart = np.linalg.norm(data.points[rest] - data.points[i], axis=1)
        for k in rest[apart <= NEAR]:
            one, other = sorted((int(i), int(k)))
            most = _differ(fitter, fit, sigma, one, other)
            if most:
                yield (
                    f"poses {data.labels[one]} and {data.labels[other]} are at the same position, but their "
                    f"frequencies differ by up to {100 * most:.2g} %: is one of them somewhere else?"
                )


def _errors(fitter: Fitter, fit: Fit) -> Array:
    """Relative standard deviations of the frequencies, (R,), those of the positions included."""
    data = fitter.data
    variance: Array = (data.sigma / data.frequency) ** 2
    moved = fitter.structure.position_rates(fit.values) if data.point_sigma.any() else None
    if moved is not None:
        rates = moved.log_rates[data.pose, np.maximum(fit.pairing.partner, 0)]
        variance = variance + ((rates * data.point_sigma[data.pose]) ** 2).sum(axis=1)
    return np.sqrt(variance)


def _differ(fitter: Fitter, fit: Fit, sigma: Array, one: int, other: int) -> float:
    """Largest relative difference of the modes that two poses both have; 0 where most agree."""
    data, (sigmas, least) = fitter.data, fitter.criteria.same_place
    rows = [{int(fit.pairing.partner[r]): r for r in np.flatnonzero(data.pose == p)} for p in (one, other)]
    common = sorted({mode for mode in rows[0] if mode >= 0} & set(rows[1]))
    if not common:
        return 0.0
    a, b = (np.array([each[mode] for mode in common]) for each in rows)
    apart = np.abs(np.log(data.frequency[a] / data.frequency[b]))
    clearly = (apart > sigmas * np.hypot(sigma[a], sigma[b])) & (apart > least)
    return float(np.expm1(apart.max())) if clearly.mean() >= 0.5 else 0.0
