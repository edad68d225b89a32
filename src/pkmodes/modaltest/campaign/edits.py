"""The user's edits of the modes of a record: modes that are struck out, and modes that are added."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NoReturn

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import Record
from pkmodes.modaltest.campaign.grouping import group_modes
from pkmodes.modaltest.campaign.kinds import RecordKind
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate
from pkmodes.modaltest.campaign.results import IdentifiedMode
from pkmodes.modaltest.identification.requested_modes import RequestedModes, nearest_frequency

#: Two added modes are the same if their frequencies differ by less, relative: separate fits do not end so close.
SAME_MODE_DIFFERENCE = 1e-4


def check_requests(edits: RequestedModes, record: Record, kind: RecordKind, source: str) -> None:
    """Refuse frequencies at which no mode can be added, before anything is read.

    Raises MeasurementError if the record has no signals, or a frequency is outside its band.
    """
    for frequency in edits.add:
        if not kind.signals:
            reason = f"the record of {record.pose} has no signals to fit"
            refuse_request(frequency, reason, source, "add it to the file of modes")
        low, high = record.band
        if not low <= frequency <= high:
            refuse_request(frequency, f"the band of {record.pose} is {low:g} Hz to {high:g} Hz", source)


def select_requested(
    candidates: Sequence[ModeEstimate | str], frequency: float, min_files: float
) -> dict[int, ModeEstimate] | str:
    """Return a mode that the user adds, by the files in which it is found, or why there is none.

    - candidates: the result of each file
    - frequency: requested by the user [Hz]
    - min_files: number of files in which it must be found
    """
    groups = group_modes([[] if isinstance(candidate, str) else [candidate] for candidate in candidates])
    if not groups:
        return next(candidate for candidate in candidates if isinstance(candidate, str))
    best = max(groups, key=lambda group: (len(group), -abs(next(iter(group.values())).frequency - frequency)))
    if len(best) < min_files:
        return f"it is found in {len(best)} of {len(candidates)} files only"
    return best


def apply_edits(
    modes: Sequence[IdentifiedMode],
    added: Sequence[IdentifiedMode],
    edits: RequestedModes,
    pose: str,
    source: str,
) -> tuple[list[IdentifiedMode], list[float]]:
    """Return the modes that the user keeps and adds, and the frequencies of those struck out.

    Strikes apply first; then an added mode replaces a reported one within 1 % of it.

    Raises MeasurementError if there is no mode to strike out at a frequency, or two added modes are the same.
    """
    kept, struck = list(modes), []
    for frequency in edits.strike:
        i = nearest_frequency([mode.frequency for mode in kept], frequency)
        if i is None:
            frequencies = ", ".join(f"{mode.frequency:.4g}" for mode in kept) or "none"
            problem = f"no mode of {pose} lies within 1 % of {frequency:g} Hz, found {frequencies} Hz"
            raise MeasurementError(problem, f"{source}: edit", "correct the frequency, or leave it out")
        struck.append(kept.pop(i).frequency)
    for (i, first), (k, second) in combinations(enumerate(added), 2):
        if abs(np.log(first.frequency / second.frequency)) < SAME_MODE_DIFFERENCE:
            problem = f"its fit converges to the mode at {first.frequency:.4g} Hz"
            refuse_request(edits.add[k], f"{problem}, as does that from {edits.add[i]:g} Hz ({pose})", source)
    for mode in added:
        i = nearest_frequency([reported.frequency for reported in kept], mode.frequency)
        if i is not None:
            del kept[i]
    return sorted([*kept, *added], key=lambda mode: mode.frequency), struck


def refuse_request(
    frequency: float, reason: str, source: str, remedy: str = "correct the frequency, or leave it out"
) -> NoReturn:
    """Refuse to add a mode at a frequency [Hz]."""
    problem = f"no mode can be added at {frequency:g} Hz: {reason}"
    raise MeasurementError(problem, f"{source}: edit", remedy)
