"""Modes of all parts of the band: one of each that two overlapping parts found, fitted beside the others."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from pkmodes.identification.asked import Asked, replaced
from pkmodes.identification.estimates import alike
from pkmodes.identification.ssi_parts import PartMode, Wanted
from pkmodes.identification.ssi_records import PreparedRecord
from pkmodes.identification.ssi_selection import Refined, refined
from pkmodes.identification.tones import Tone

#: Rate of decay times length of record below which a mode at a tone is what its subtraction left.
REST = 12.0


def distinct(found: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes by frequency, one of those that two overlapping parts found: the more central one."""
    kept: list[PartMode] = []
    for one in sorted(found, key=_eccentricity):
        f, rate = one.mode.frequency, one.mode.rate
        for other in kept:
            if other.part is one.part:
                continue
            apart = 2 * math.pi * abs(f - other.mode.frequency) / (rate + other.mode.rate)
            near = 2 * math.pi * abs(f - other.mode.frequency) < 0.5 * (rate + other.mode.rate)
            if near or (apart < 2.0 and alike(one.mode.shape, other.mode.shape) > 0.8):
                break
        else:
            if one.part.low <= f <= one.part.high or _eccentricity(one) < 1.3:
                kept.append(one)
    return sorted(kept, key=lambda one: one.mode.frequency)


def beside_all(record: PreparedRecord, found: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes fitted again beside those of all parts of the band."""
    again = list(found)
    for one in sorted(found, key=lambda one: one.mode.gain):
        again.remove(one)
        mode = refined(
            one.mode, [other.mode for other in again], record.plain, (one.part.start, one.part.stop)
        )
        if mode is not None:
            again.append(replace(one, mode=mode))
    return sorted(again, key=lambda one: one.mode.frequency)


def with_wanted(
    record: PreparedRecord, found: Sequence[PartMode], wanted: Wanted, tones: Sequence[Tone], asked: Asked
) -> tuple[list[PartMode], Wanted]:
    """Return the modes that those asked for do not replace, and these without what is left of a tone."""
    kept, more = list(found), dict(wanted)
    for frequency, one in wanted.items():
        if isinstance(one, str):
            continue
        if rest_of_tone(one.mode, tones, record):
            more[frequency] = "what is fitted there is left of a tone"
            continue
        before = replaced(
            [abs(each.mode.pole) / (2 * math.pi) for each in kept], asked, abs(one.mode.pole) / (2 * math.pi)
        )
        if before is not None:
            del kept[before]
    return kept, more


def rest_of_tone(mode: Refined, found: Sequence[Tone], record: PreparedRecord) -> bool:
    """Return whether a mode is as narrow as lines and at a tone: what its subtraction left."""
    near = any(abs(mode.frequency - tone.frequency) * record.seconds < 3.0 for tone in found)
    return near and mode.rate * record.seconds < REST


def _eccentricity(one: PartMode) -> float:
    middle, half = 0.5 * (one.part.low + one.part.high), 0.5 * (one.part.high - one.part.low)
    return abs(one.mode.frequency - middle) / half
