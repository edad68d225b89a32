"""Tables without the columns that are the same in every row: a sentence states them once."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import MISSING

#: Texts that carry no information.
BLANK_TEXTS = ("", MISSING)


def compact_table(
    caption: str,
    columns: Sequence[Column],
    rows: Sequence[Sequence[Cell]],
    groups: Sequence[tuple[str, int]] = (),
    note: str = "",
    key_columns: int = 1,
) -> Table:
    """Return a table of the columns that differ between rows.

    The first column, which names the rows, always stays.  Measured or computed numbers stay too, even where they
    round to the same: only words and counts are stated once, in the note.

    - groups, note, key_columns: as those of `Table`
    """
    group_of_column = [k for k, (_, count) in enumerate(groups) for _ in range(count)]
    uniform = [
        c
        for c in range(1, len(columns))
        if not columns[c].page_only and _is_uniform([row[c] for row in rows])
    ]
    kept_columns = [c for c in range(len(columns)) if c not in uniform]
    titles = [
        f"{groups[group_of_column[c]][0] if group_of_column else ''} {column.title}".strip()
        for c, column in enumerate(columns)
    ]
    uniform_texts = [f"{titles[c]} {rows[0][c].text}" for c in uniform if rows[0][c].text not in BLANK_TEXTS]
    kept_groups = (
        [
            (groups[k][0], len(list(run)))
            for k, run in groupby(group_of_column[c] for c in kept_columns)
            if group_of_column
        ]
        if group_of_column
        else []
    )
    sentences = [f"In every row: {', '.join(uniform_texts)}."] if uniform_texts else []
    sentences += [note] if note else []
    return Table(
        caption,
        [columns[c] for c in kept_columns],
        [[row[c] for c in kept_columns] for row in rows],
        kept_groups,
        " ".join(sentences),
        sum(c < key_columns for c in kept_columns),
    )


def _is_uniform(cells: Sequence[Cell]) -> bool:
    """Return whether the cells of a column are all the same, and are words, counts or blank."""
    texts = {cell.text for cell in cells}
    if len(texts) > 1 or not texts:
        return False
    if texts <= set(BLANK_TEXTS):
        return True
    are_words_or_counts = all(cell.value is None or cell.text.isdigit() for cell in cells)
    return len(cells) > 1 and are_words_or_counts and not any(cell.spread for cell in cells)
