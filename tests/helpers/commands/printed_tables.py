"""Tables on the terminal, read as they are printed."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence

#: A sentence below the rows: a word with a capital, perhaps behind a mark, and another word.
NOTE = re.compile(r"(\* )?[A-Z][a-z]+ [a-z0-9]+[ :]")


def printed_table(out: str, *titles: str) -> list[list[str]]:
    """Return the cells of the only table with these titles.

    Its parts may stand below each other, and the first cell of a row on a line above it or broken at its commas.
    Every part has the same rows, and the columns that are repeated the same cells.
    """
    lines, found, table = [*out.splitlines(), ""], 0, list[dict[int, str]]()
    for place, line in enumerate(lines):
        columns = _columns(line, titles, found % len(titles))
        if not columns:
            continue
        assert found < len(titles), f"a second table begins with {line!r}"
        end = next(k for k in range(place + 1, len(lines)) if not lines[k] or NOTE.match(lines[k]))
        part = _rows(lines[place + 1 : end], columns)
        table = table or [{} for _ in part]
        for row, cells in zip(table, part, strict=True):
            assert all(row.setdefault(k, cell) == cell for k, cell in cells.items())
        found = max(found, columns[-1][0] + 1)
    assert found == len(titles), f"no column {titles[found]!r}"
    return [[row[k] for k in range(len(titles))] for row in table]


def _columns(line: str, titles: Sequence[str], found: int) -> list[tuple[int, int, int]]:
    """Return column, begin and end of each title; empty if it is no line of titles that goes on after those found."""
    columns: list[tuple[int, int, int]] = []
    begin, following = len(line) - len(line.lstrip()), found
    while begin < len(line):
        # The first title is missing where the names stand above their rows.
        tried = [following, *([1] if not following else []), *range(found)]
        fitting = [k for k in tried if k < len(titles) and f"{line} ".startswith(f"{titles[k]} ", begin)]
        if not fitting:
            return []
        end = begin + len(titles[fitting[0]])
        columns.append((fitting[0], begin, end))
        following = max(following, fitting[0] + 1)
        begin = len(line) - len(line[end:].lstrip())
    return columns if following > found else []


def _rows(lines: Sequence[str], columns: Sequence[tuple[int, int, int]]) -> list[dict[int, str]]:
    """Return the cells of each row of a part by their column."""
    names, rows = list[str](), list[str]()
    for line in lines:
        if columns[0][0] == 0 or "  " in line:
            rows.append(line)
            names.extend(names[-1:] if len(names) < len(rows) else ())
        else:
            names.append(line)
    edges = [0]
    for (_, _, end), (_, begin, _) in itertools.pairwise(columns):
        between = "".join(
            "x" if any(row[k : k + 1].strip() for row in rows) else " " for k in range(end, begin)
        )
        # Cells may have spaces, too, but fewer.
        edges.append(end + between.index(max(re.findall(" +", between), key=len)))
    found: list[dict[int, str]] = []
    for number, row in enumerate(rows):
        cells = [row[a:b].strip() for a, b in zip(edges, [*edges[1:], None], strict=True)]
        if found and not any(cells[1:]) and found[-1][0].endswith(","):
            found[-1][0] += f" {cells[0]}"
            continue
        of = {k: cell for (k, _, _), cell in zip(columns, cells, strict=True)}
        found.append(of if columns[0][0] == 0 else {0: names[number], **of})
    return found
