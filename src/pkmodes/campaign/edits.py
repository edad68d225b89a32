"""What the user decides about the modes of a record: which are struck out, and where one is added."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NoReturn

import numpy as np

from pkmodes.campaign.campaign import Record
from pkmodes.campaign.found import Found
from pkmodes.campaign.grouping import grouped
from pkmodes.campaign.kinds import Kind
from pkmodes.campaign.results import IdentifiedMode
from pkmodes.core.base.errors import MeasurementError
from pkmodes.identification.asked import Asked, nearest

#: Two added modes are one if their frequencies differ by less, relative: fits do not end so near by chance.
SAME = 1e-4


def check_asked(asked: Asked, record: Record, kind: Kind, source: str) -> None:
    """Refuse frequencies at which no mode can be added, before anything is read.

    Raises
    ------
    MeasurementError
        If the record has no signals, or a frequency is outside its band.
    """
    for wanted in asked.add:
        if not kind.signals:
            reason = f"the record of {record.pose} has no signals to fit"
            refuse_added(wanted, reason, source, "add it to the file of modes")
        low, high = record.band
        if not low <= wanted <= high:
            refuse_added(wanted, f"the band of {record.pose} is {low:g} Hz to {high:g} Hz", source)


def added_group(found: Sequence[Found | str], wanted: float, least: float) -> dict[int, Found] | str:
    """Return a mode that the user adds, by the files in which it is found, or why there is none.

    Parameters
    ----------
    found : sequence of Found or str
        What each file gives.
    wanted : float
        Where the user asks for it [Hz].
    least : float
        In how many files it must be found.
    """
    groups = grouped([[] if isinstance(one, str) else [one] for one in found])
    if not groups:
        return next(one for one in found if isinstance(one, str))
    best = max(groups, key=lambda group: (len(group), -abs(next(iter(group.values())).frequency - wanted)))
    if len(best) < least:
        return f"it is found in {len(best)} of {len(found)} files only"
    return best


def edited(
    modes: Sequence[IdentifiedMode],
    added: Sequence[IdentifiedMode],
    asked: Asked,
    pose: str,
    source: str,
) -> tuple[list[IdentifiedMode], list[float]]:
    """Return the modes that the user leaves and adds, and the frequencies of those struck out.

    Strikes apply first; then an added mode replaces a reported one within 1 % of it.

    Raises
    ------
    MeasurementError
        If no mode is where one is to be struck out, or two added modes are one.
    """
    kept, struck = list(modes), []
    for wanted in asked.strike:
        i = nearest([mode.frequency for mode in kept], wanted)
        if i is None:
            found = ", ".join(f"{mode.frequency:.4g}" for mode in kept) or "none"
            what = f"no mode of {pose} lies within 1 % of {wanted:g} Hz, found {found} Hz"
            raise MeasurementError(what, f"{source}: edit", "correct the frequency, or leave it out")
        struck.append(kept.pop(i).frequency)
    for (i, one), (k, other) in combinations(enumerate(added), 2):
        if abs(np.log(one.frequency / other.frequency)) < SAME:
            what = (
                f"its fit becomes the mode at {one.frequency:.4g} Hz, as does that from {asked.add[i]:g} Hz"
            )
            refuse_added(asked.add[k], f"{what} ({pose})", source)
    for mode in added:
        i = nearest([one.frequency for one in kept], mode.frequency)
        if i is not None:
            del kept[i]
    return sorted([*kept, *added], key=lambda mode: mode.frequency), struck


def refuse_added(
    wanted: float, reason: str, source: str, remedy: str = "correct the frequency, or leave it out"
) -> NoReturn:
    """Refuse to add a mode at a frequency [Hz]."""
    what = f"no mode can be added at {wanted:g} Hz: {reason}"
    raise MeasurementError(what, f"{source}: edit", remedy)
