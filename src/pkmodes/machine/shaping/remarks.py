"""What firmware makes of a recommended shaper, and what is used instead where firmware lacks it."""

from __future__ import annotations

from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.firmware import (
    DEFAULT_RATIO,
    FIRMWARE_TITLES,
    MARLIN_MIN_RATIO,
    MARLIN_NUMBERS,
    MARLIN_ZV_RATIO,
    MIN_WRITTEN_RATIO,
)
from pkmodes.machine.shaping.results import Choice
from pkmodes.machine.shaping.version_lines import recommended_in, shapers_in_words


def firmware_remarks(choice: Choice) -> list[str]:
    """Return sentences on firmware that lacks the recommended shaper, or whose lines set another damping ratio."""
    recommended = {axis: axis_choice.best for axis, axis_choice in choice.parts.items()}
    notes, substitutes = [], dict[str, list[str]]()
    for name, title in FIRMWARE_TITLES.items():
        shapers = recommended_in(name, choice)
        if choice.by_axis and "" in shapers:
            notes.append(
                f"{title} has one shaper for all axes: its line sets {shapers[''].kind}, and says beside it what "
                "that leaves there"
            )
        elif not shapers:
            notes.append(
                f"{title} has none of the shapers compared: --shapers zv,mzv,ei compares some that it has"
            )
        elif any(shapers[axis].kind != recommended[axis].kind for axis in shapers):
            kinds = " and ".join(
                f"{shaper.kind} on {axis}" if axis else shaper.kind for axis, shaper in shapers.items()
            )
            substitutes.setdefault(kinds, []).append(title)
    recommended_kinds = shapers_in_words(recommended)
    for kinds, titles in substitutes.items():
        have, their = ("has", "its") if len(titles) == 1 else ("have", "their")
        notes.append(
            f"{joined(titles)} {have} no {recommended_kinds}: {their} lines set {kinds}, and say beside it what that "
            "leaves there"
        )
    ratios = [shaper.damping_ratio for shaper in recommended.values()]
    if min(ratios) < MIN_WRITTEN_RATIO:
        notes.append(
            f"the lines for Klipper and Marlin set no damping ratio: Klipper then uses {DEFAULT_RATIO:g}, and Marlin "
            f"its configured value (default {DEFAULT_RATIO:g}; {MARLIN_ZV_RATIO:g} for M593)"
        )
    elif any(
        shaper.kind in MARLIN_NUMBERS and shaper.damping_ratio < MARLIN_MIN_RATIO
        for shaper in recommended.values()
    ):
        notes.append(
            f"Marlin accepts no damping ratio below {MARLIN_MIN_RATIO:g}, so its line sets {MARLIN_MIN_RATIO:g}"
        )
    return notes
