"""What firmware makes of a recommended shaper, and what it gets instead of one that it lacks."""

from __future__ import annotations

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.firmware import (
    DEFAULT_RATIO,
    LEAST,
    MARLIN,
    MARLIN_ZV_RATIO,
    NAMES,
    NO_DAMPING,
)
from pkmodes.machine.shaping.results import Choice
from pkmodes.machine.shaping.version_lines import recommended_in, shapers_in_words


def firmware_remarks(choice: Choice) -> list[str]:
    """Return sentences on firmware that lacks the recommended shaper, or makes a different one from its lines."""
    recommended = {axis: part.best for axis, part in choice.parts.items()}
    notes, substitutes = [], dict[str, list[str]]()
    for name, title in NAMES.items():
        shapers = recommended_in(name, choice)
        if choice.by_axis and "" in shapers:
            notes.append(
                f"{title} has one shaper for all axes: its line is for {_leaving(choice, shapers[''].kind)}"
            )
        elif not shapers:
            notes.append(
                f"{title} has none of the shapers compared: --shapers zv,mzv,ei compares some that it has"
            )
        elif any(shapers[axis].kind != recommended[axis].kind for axis in shapers):
            kinds = " and ".join(
                _leaving(choice.parts[axis], shaper.kind, f" on {axis}" if axis else "")
                for axis, shaper in shapers.items()
            )
            substitutes.setdefault(kinds, []).append(title)
    lacking = shapers_in_words(recommended)
    notes += [
        f"no {lacking} in {joined(titles)}: lines are for {kinds}" for kinds, titles in substitutes.items()
    ]
    ratios = [shaper.damping_ratio for shaper in recommended.values()]
    if min(ratios) < NO_DAMPING:
        notes.append(
            f"lines of Klipper and Marlin without a damping ratio: Klipper then takes {DEFAULT_RATIO:g}, and Marlin "
            f"what is set, {DEFAULT_RATIO:g} unless changed ({MARLIN_ZV_RATIO:g} by M593)"
        )
    elif any(shaper.kind in MARLIN and shaper.damping_ratio < LEAST for shaper in recommended.values()):
        notes.append(f"Marlin takes no damping ratio below {LEAST:g}: its line has this value")
    return notes


def _leaving(choice: Choice, kind: str, on: str = "") -> str:
    """Return a kind of fixed shaper, and the most that it leaves."""
    shaper = next(
        candidate for candidate in choice.candidates if candidate.kind == kind and not candidate.follows_pose
    )
    return f"{kind}{on}, which leaves up to {plain(100 * shaper.left.worst, 2)} % {choice.ringing.share_of}"
