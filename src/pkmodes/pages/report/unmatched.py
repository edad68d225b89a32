"""Measured modes without a partner, in words: why they have none, and what leaves them out or counts them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from pkmodes.core.base.numbers import format_frequency
from pkmodes.core.support.mac import MIN_MAC_OF_PAIR
from pkmodes.loop.diagnosis.compare import ComparedRow
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.pages.report.formatting import plural

#: How far the frequencies of partners may be apart, and below which MAC a mode is no partner.
FARTHEST = f"a factor of {math.exp(Criteria.pairing.reach):.1f}"
OTHER_SHAPE = f"another shape (MAC below {MIN_MAC_OF_PAIR:g})"


def nearest_in_words(row: Row | ComparedRow) -> str:
    """Return why the nearest mode of the model is no partner; empty where none is left near the measured one."""
    if row.nearest is None or row.nearest_mac is None:
        return ""
    return (
        f"the nearest mode, {format_frequency(row.nearest)} Hz, has another shape, MAC {row.nearest_mac:.3f}"
    )


def kinds_in_words(unmatched: Sequence[Row | ComparedRow]) -> str:
    """Return how many unmatched modes have no mode left, and for how many the nearest one has another shape."""
    other_shape_count = sum(row.nearest is not None for row in unmatched)
    count = len(unmatched) - other_shape_count
    kinds = []
    if count:
        kinds.append(f"{plural(count, 'mode')} for which the model has none left within {FARTHEST}")
    if other_shape_count:
        kinds.append(f"{plural(other_shape_count, 'mode')} whose nearest mode has {OTHER_SHAPE}")
    return ", and ".join(kinds)


def counting_in_words(count: int, other_shape_count: int, stage: str) -> str:
    """Return how fitted modes without a partner at a stage count in chi-square.

    - count: modes without a partner
    - other_shape_count: those of them whose nearest mode has another shape
    """
    is_one = count == 1
    opening = f"{count} fitted {'mode has' if is_one else 'modes have'} no partner in the model ({stage})"
    pronoun, no_mode_count = "it" if is_one else "each", count - other_shape_count
    if not other_shape_count:
        return (
            f"{opening}: {pronoun} counts in chi\u00b2 as a difference by {FARTHEST}, and not in the rms. The model "
            f"has no mode left for {'it' if is_one else 'them'}."
        )
    if not no_mode_count:
        return (
            f"{opening}: the nearest mode has {OTHER_SHAPE}. {pronoun.capitalize()} counts in chi\u00b2 as its "
            "difference from that mode, and not in the rms."
        )
    first, second = (f"{n} count{'s' if n == 1 else ''}" for n in (no_mode_count, other_shape_count))
    return (
        f"{opening}. In chi\u00b2, {first} as a difference by {FARTHEST}, because no mode is left, and {second} as "
        f"the difference from the nearest mode, which has {OTHER_SHAPE}. None counts in the rms."
    )
