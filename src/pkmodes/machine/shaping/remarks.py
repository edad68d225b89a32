"""What firmware makes of a recommended shaper, and what it offers instead of one that it lacks."""

from __future__ import annotations

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.choice import lines_of, recommended_of
from pkmodes.machine.shaping.firmware import LEAST, MARLIN, NAMES
from pkmodes.machine.shaping.results import Choice


def firmware_remarks(choice: Choice) -> list[str]:
    """Return sentences on firmware that lacks the recommended shaper, or makes a different one from its lines."""
    best = choice.candidates[choice.recommended]
    # For a firmware that lacks it, what would be recommended of the shapers that it has.
    lacking: dict[str, list[str]] = {}
    for name in (name for name, line in lines_of(best).items() if line is None):
        index, good = recommended_of(choice.candidates, choice.left, choice.length, name)
        if index is not None:
            substitute = choice.candidates[index]
            worst = f"{plain(100 * substitute.left.worst, 2)} % {choice.ringing.where_most}"
            limit = f"{plain(100 * choice.left, 3)} %"
            which = f"is the shortest that leaves at most {limit}" if good else "leaves least"
            instead = f"of those compared that it has, {substitute.kind} {which}: {worst}"
            lacking.setdefault(f"{instead} (--shapers {substitute.kind} prints its lines)", []).append(
                NAMES[name]
            )
    notes = [f"no {best.kind} in {joined(names)}; {instead}" for instead, names in lacking.items()]
    if best.kind in MARLIN and best.damping_ratio < LEAST:
        notes.append(f"Marlin takes no damping ratio below {LEAST:g}: its line has this value")
    return notes
