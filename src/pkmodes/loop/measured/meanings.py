"""What the columns of other programs are likely to mean: ``Frequency in Hz`` is ``frequency [Hz]``.

They are suggested in errors, never assumed.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterator, Sequence

from pkmodes.loop.measured.rules import SET, SHAPE

#: A name with its unit, in words or in brackets.
WITH_UNIT = re.compile(r"(.*?)(?:\s+in\s+(\S+)|\s*[\[(]([^\[\]()]*)[\])])")
#: Names that other programs give to the columns of a measurement file, in lower case and without punctuation.
SYNONYMS = {
    "frequency": (
        "freq",
        "f",
        "fn",
        "f0",
        "natural frequency",
        "eigenfrequency",
        "modal frequency",
        "frequenz",
    ),
    "sigma": (
        "standard deviation",
        "std",
        "std dev",
        "stdev",
        "sd",
        "uncertainty",
        "sigma f",
        "sigma frequency",
    ),
    "damping": ("damping ratio", "modal damping", "damp", "zeta", "xi"),
    "sigma_damping": ("sigma zeta", "std damping", "standard deviation of damping", "damping uncertainty"),
    "pose": ("position", "point", "label", "pose name", "pose label"),
    "level": ("excitation", "excitation level", "drive level"),
    "mode": ("mode number", "mode no", "no", "nr", "number"),
}
SHAPE_NAME = re.compile(r"(?:mode ?)?shape (.+)")
POSE_NAME = re.compile(r"(?:pos|position|pose) (.+)|(.+) (?:pos|position)")
#: Smallest similarity of a name to a known one for it to be suggested.
MIN_SIMILARITY = 0.51


def split_unit(cell: str) -> tuple[str, str]:
    """Return the name in a cell and its unit, in words or brackets; "" without one."""
    match = WITH_UNIT.fullmatch(cell)
    return (cell, "") if match is None else (match[1], match[2] or match[3] or "")


def likely_meaning(cell: str, column_names: Sequence[str], taken: Collection[str] = ()) -> str:
    """Return the column that a cell probably means, with its unit; "" if there is none.

    - column_names: names that a column may have
    - taken: those that other columns have already
    """
    name, unit = split_unit(cell)
    free_names = [column for column in column_names if column not in taken]
    meant = next((column for column in _meanings(name, free_names) if column in free_names), "")
    return f"{meant} [{unit}]" if meant and unit else meant


def _meanings(name: str, column_names: Sequence[str]) -> Iterator[str]:
    """Yield what a name may mean, the likeliest first."""
    words = " ".join(re.split(r"[\s_:.\-]+", name.strip().lower()))
    yield from (
        column for column, synonyms in SYNONYMS.items() if words in (column.replace("_", " "), *synonyms)
    )
    if (match := SHAPE_NAME.fullmatch(words)) is not None:
        yield from _shape_columns(match[1])
    yield from _shape_columns(words)
    if (match := POSE_NAME.fullmatch(words)) is not None:
        yield match[1] or match[2]
    # There are very many values that can be set: a name means one only with the prefix, or if it lacks only that.
    yield f"{SET}{name}"
    same_kind = [column for column in column_names if column.startswith(SET) is name.startswith(SET)]
    yield from difflib.get_close_matches(name, same_kind, n=1, cutoff=MIN_SIMILARITY)


def _shape_columns(words: str) -> Iterator[str]:
    """Yield the columns of a shape that some words may mean, such as ``x``, ``p x`` and ``rx``."""
    channel = words.replace(" ", "_")
    yield f"{SHAPE}{channel}"
    yield f"{SHAPE}p_{channel}"
    if len(channel) == 2:
        yield f"{SHAPE}{channel[0]}_{channel[1]}"
