"""Tables with many columns in a terminal: the columns are split over several tables that fit."""

from __future__ import annotations

from collections.abc import Sequence

#: Between two columns, as `pkmodes.cli.terminal.Terminal` sets them.
GAP = 2
Part = tuple[list[str], list[list[str]]]


def split(titles: Sequence[str], rows: Sequence[Sequence[str]], fixed: int, width: int) -> list[Part]:
    """Split a table into parts that are no wider than a terminal, if their columns allow it.

    Parameters
    ----------
    titles, rows : sequence
        Of the whole table.
    fixed : int
        Columns that describe a row: all of them are in the first part, only the very first in the others.
    width : int
        Of the terminal, in characters.

    Returns
    -------
    list of (titles, rows)
        At least one, each with at least one further column.
    """
    sizes = [max(map(len, column)) + GAP for column in zip(titles, *rows, strict=True)]
    count = len(titles) - fixed
    parts = _parts(sizes, fixed, width, count)
    # As many columns in each, if that takes no further part.
    even = _parts(sizes, fixed, width, -(-count // len(parts)))
    parts = even if len(even) == len(parts) else parts
    return [([titles[k] for k in part], [[row[k] for k in part] for row in rows]) for part in parts]


def _parts(sizes: Sequence[int], fixed: int, width: int, most: int) -> list[list[int]]:
    """Return the columns of each part, filled one after the other with at most so many further columns."""
    parts: list[list[int]] = []
    here, first = list(range(fixed)), fixed
    for column in range(fixed, len(sizes)):
        filled = sum(sizes[k] for k in here) + sizes[column] - GAP
        if here[-1] >= fixed and (filled > width or column - first >= most):
            parts.append(here)
            here, first = [0], column
        here.append(column)
    return [*parts, here]
