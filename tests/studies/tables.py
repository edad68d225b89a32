"""Tables of outcomes, and the CSV files that keep them."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from studies.running import Outcome

#: All states of an outcome, in the order of the columns; see `running.Outcome`.
STATES = ("named", "partly", "wrong", "abstained", "adequate", "failed")

J = TypeVar("J", bound=Outcome[Any])


class Table(NamedTuple):
    """A table of text: its columns, and its rows."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    @classmethod
    def of(cls, head: Iterable[str], rows: Iterable[Iterable[object]]) -> Table:
        """Return a table of anything that has a text."""
        return cls(tuple(head), tuple(tuple(map(str, row)) for row in rows))

    def records(self) -> list[dict[str, str]]:
        """Return the rows by the names of the columns."""
        return [dict(zip(self.head, row, strict=True)) for row in self.rows]

    def values(self) -> dict[str, str]:
        """Return the second cell of each row by the first, as of a summary."""
        return {row[0]: row[1] for row in self.rows}


#: The tables of a suite by the names of their files.
Tables = dict[str, Table]


def count(outcomes: Iterable[Outcome[Any]], state: str) -> int:
    """Count the outcomes with a state."""
    return sum(o.state == state for o in outcomes)


def grouped(outcomes: Iterable[J], key: Callable[[J], str]) -> dict[str, list[J]]:
    """Group outcomes by a name, in the order of their first ones."""
    groups: dict[str, list[J]] = {}
    for outcome in outcomes:
        groups.setdefault(key(outcome), []).append(outcome)
    return groups


def confusion(groups: Mapping[str, Sequence[J]], states: Sequence[str] = STATES) -> Table:
    """Return how often each state occurred, a row a group."""
    rows = [[name, len(group), *(count(group, state) for state in states)] for name, group in groups.items()]
    return Table.of(["group", "cases", *states], rows)


def stacked(title: str, tables: Mapping[str, Table]) -> Table:
    """Return tables as one, whose first column has their names; a cell without a column is empty."""
    head = tuple(dict.fromkeys(name for table in tables.values() for name in table.head))
    rows = [
        [name, *(record.get(column, "") for column in head)]
        for name, table in tables.items()
        for record in table.records()
    ]
    return Table.of([title, *head], rows)


def in_words(outcome: Outcome[Any]) -> str:
    """Return the classes of an outcome."""
    return "; ".join(" or ".join(members) for members in outcome.classes)


def markdown(table: Table) -> list[str]:
    """Return the lines of a table on a page."""
    first, *others = (f"|{'|'.join(cells)}|" for cells in (table.head, *table.rows))
    return [first, f"|{'---|' * len(table.head)}", *others]


def read(folder: Path) -> Tables:
    """Return the tables of a suite."""
    tables = {}
    for path in sorted(folder.glob("*.csv")):
        with path.open(encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
        tables[path.stem] = Table.of(head, rows)
    return tables


def publish(tables: Tables, out: Path | None) -> None:
    """Write each table to a CSV file in a folder, or print all of them."""
    for name, table in tables.items():
        if out is None:
            print("\n".join([f"## {name}", "", *markdown(table), ""]))
            continue
        out.mkdir(parents=True, exist_ok=True)
        with (out / f"{name}.csv").open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([table.head, *table.rows])
