"""Tables without the columns that are the same in every row: a sentence states them once."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import NOTHING

#: Texts that carry no information.
BLANK = ("", NOTHING)


def table(
    caption: str,
    columns: Sequence[Column],
    rows: Sequence[Sequence[Cell]],
    groups: Sequence[tuple[str, int]] = (),
    note: str = "",
    heads: int = 1,
) -> Table:
    """Return a table of the columns that differ between rows.

    The first column, which names the rows, always stays.  Measured or computed numbers stay too, even where they
    round to the same: only words and counts are said once, in the note.

    - groups, note, heads: as those of `Table`
    """
    over = [k for k, (_, count) in enumerate(groups) for _ in range(count)]
    same = [c for c in range(1, len(columns)) if not columns[c].page_only and _same([row[c] for row in rows])]
    kept = [c for c in range(len(columns)) if c not in same]
    titles = [
        f"{groups[over[c]][0] if over else ''} {column.title}".strip() for c, column in enumerate(columns)
    ]
    shared = [f"{titles[c]} {rows[0][c].text}" for c in same if rows[0][c].text not in BLANK]
    kept_groups = (
        [(groups[k][0], len(list(run))) for k, run in groupby(over[c] for c in kept) if over] if over else []
    )
    sentences = [f"In every row: {', '.join(shared)}."] if shared else []
    sentences += [note] if note else []
    return Table(
        caption,
        [columns[c] for c in kept],
        [[row[c] for c in kept] for row in rows],
        kept_groups,
        " ".join(sentences),
        sum(c < heads for c in kept),
    )


def _same(cells: Sequence[Cell]) -> bool:
    """Return whether the cells of a column are all the same, and are words, counts or blank."""
    texts = {cell.text for cell in cells}
    if len(texts) > 1 or not texts:
        return False
    if texts <= set(BLANK):
        return True
    plain = all(cell.value is None or cell.text.isdigit() for cell in cells)
    return len(cells) > 1 and plain and not any(cell.spread for cell in cells)
