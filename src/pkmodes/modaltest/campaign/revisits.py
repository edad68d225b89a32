"""How well frequencies repeat when a pose is left and approached again: from poses measured under several labels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.averaging import group_by_mode
from pkmodes.modaltest.campaign.campaign import Record
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate

#: Minimum number of modes that must have been measured again.
MIN_MODES = 3


def estimate_repeatability(
    records: Sequence[tuple[Record, Sequence[ModeEstimate]]], source: str
) -> tuple[float, str]:
    """Return the relative standard deviation of a frequency over approaches, and a message about it.

    The variance of the means from repeats, or from the fit of a single file, is subtracted from that between labels.

    Raises MeasurementError if fewer than three modes were measured again.
    """
    visits_by_pose: dict[object, list[Sequence[ModeEstimate]]] = {}
    for record, modes in records:
        key = (tuple(record.point.items()), tuple(sorted(record.settings.items())), record.drives)
        visits_by_pose.setdefault(key, []).append(modes)
    squares, freedom, count = 0.0, 0, 0
    for visits in visits_by_pose.values():
        for group in group_by_mode(visits):
            if len(group) < 2:
                continue
            members = list(group.values())
            logs = np.log([mode.frequency for mode in members])
            variances = [
                mode.variance if np.isfinite(mode.variance) else (mode.sigma_frequency / mode.frequency) ** 2
                for mode in members
            ]
            squares += (len(members) - 1) * (float(np.var(logs, ddof=1)) - float(np.mean(variances)))
            freedom += len(members) - 1
            count += 1
    if count < MIN_MODES:
        problem = f'expected at least {MIN_MODES} modes measured again for repeatability = "revisits", found {count}'
        remedy = 'measure a pose again under another label, or write a number such as "0.2 %"'
        raise MeasurementError(problem, f"{source}: repeatability", remedy)
    value = float(np.sqrt(max(squares, 0.0) / freedom))
    return (
        value,
        f"repeatability {plain(100.0 * value, 2)} %, from {count} modes that were measured again",
    )
