"""Mistakes visible in all measurements, including held-out ones: copied shapes, and poses with a wrong label."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.verdict.all_setups import AllSetups, Stage
from pkmodes.diagnosis.verdict.mistakes import all_alike
from pkmodes.measured.measurements import Measurements

#: Positions nearer than this are the same [m].
NEAR = 1e-6
#: Largest number of remarks of each kind.
MOST = 4


def remarks(setups: AllSetups, fit: Fit) -> tuple[str, ...]:
    """Return sentences about the measurements.

    Parameters
    ----------
    fit : Fit
        Its values determine which rows are the same mode.
    """
    copies, criteria = [], setups.fitter.criteria
    if not all_alike(setups.data, criteria.readings.same_shape):  # reported separately
        copies = [
            f"the shapes in lines {one} and {other} are identical: was one copied?"
            for one, other in copied(setups.data)
        ]
    displaced = list(_same_place(setups.stage(fit.values), criteria.readings.same_place))
    return *displaced[:MOST], *copies[:MOST]


def copied(data: Measurements) -> list[tuple[int, int]]:
    """Return pairs of lines whose shapes are identical, which never happens in real measurements."""
    first: dict[bytes, int] = {}
    pairs = []
    for row, shape in enumerate(data.shapes):
        if np.count_nonzero(np.nan_to_num(shape)) < 2:
            continue
        before = first.setdefault(shape.tobytes(), row)
        if before != row:
            pairs.append((int(data.lines[before]), int(data.lines[row])))
    return pairs


def _same_place(stage: Stage, clearly: tuple[float, float]) -> Iterator[str]:
    """Yield a sentence for each pair of poses, measured alike at one position, whose common modes mostly differ."""
    data = stage.data
    if not data.points.any():  # setups without positions
        return
    order = np.argsort(data.points[:, 0], kind="stable")
    along = data.points[order, 0]
    ends = np.searchsorted(along, along + NEAR, side="right")
    conditions = data.conditions  # held motors and another load change the frequencies
    for place, (i, end) in enumerate(zip(order, ends, strict=True)):
        rest = order[place + 1 : end]
        rest = rest[conditions[rest] == conditions[i]]
        apart = np.linalg.norm(data.points[rest] - data.points[i], axis=1)
        for k in rest[apart <= NEAR]:
            one, other = sorted((int(i), int(k)))
            most = _difference(stage, clearly, one, other)
            if most:
                yield (
                    f"poses {data.labels[one]} and {data.labels[other]} are at the same position, but their "
                    f"frequencies differ by up to {100 * most:.2g} %: is one of them somewhere else?"
                )


def _difference(stage: Stage, clearly: tuple[float, float], one: int, other: int) -> float:
    """Return the largest relative difference of the modes that two poses have in common; 0 if most agree."""
    data, sigma, (sigmas, least) = stage.data, stage.sigma, clearly
    partner = stage.pairing.partner
    rows = [{int(partner[r]): r for r in np.flatnonzero(data.pose == p)} for p in (one, other)]
    common = sorted({mode for mode in rows[0] if mode >= 0} & set(rows[1]))
    if not common:
        return 0.0
    a, b = (np.array([each[mode] for mode in common]) for each in rows)
    apart = np.abs(np.log(data.frequency[a] / data.frequency[b]))
    clear = (apart > sigmas * np.hypot(sigma[a], sigma[b])) & (apart > least)
    return float(np.expm1(apart.max())) if clear.mean() >= 0.5 else 0.0
