"""A column that says the same in every row is said once; what is measured or computed stays."""

from __future__ import annotations

from pkmodes.pages.report.blocks import Cell, Column
from pkmodes.pages.report.formatting import rounded_cell, uncertain_cell
from pkmodes.pages.report.tables import compact_table

COLUMNS = [
    Column("mode"),
    Column("f [Hz]"),
    Column("files"),
    Column("motors", False),
    Column("remark", False),
]


def row(mode: int, frequency: float, files: int = 3, motors: str = "held", remark: str = "") -> list[Cell]:
    return [Cell(str(mode)), rounded_cell(frequency), Cell(str(files), files), Cell(motors), Cell(remark)]


def titles(made: object) -> list[str]:
    return [column.title for column in made.columns]  # type: ignore[attr-defined]


def test_words_and_counts_that_never_change_are_said_once() -> None:
    made = compact_table(
        "Modes.", COLUMNS, [row(1, 29.98), row(2, 37.36)], [("", 2), ("record", 3)], "A note."
    )
    assert titles(made) == ["mode", "f [Hz]"]
    assert made.groups == [("", 2)]
    assert made.note == "In every row: record files 3, record motors held. A note."
    assert [[cell.text for cell in one] for one in made.rows] == [["1", "29.98"], ["2", "37.36"]]


def test_what_differs_once_stays_under_its_title() -> None:
    rows = [row(1, 29.98), row(2, 37.36, files=2), row(3, 41.5, remark="held out")]
    made = compact_table("Modes.", COLUMNS, rows, [("", 2), ("record", 3)])
    assert titles(made) == ["mode", "f [Hz]", "files", "remark"]
    assert made.groups == [("", 2), ("record", 2)]
    assert made.note == "In every row: record motors held."


def test_numbers_that_round_to_the_same_and_a_single_row_stay() -> None:
    same = [
        [Cell(str(i)), rounded_cell(0.2000001 * 1.0000001**i, 2), uncertain_cell(2.0, 1.0)] for i in range(3)
    ]
    made = compact_table("Values.", [Column("a"), Column("b"), Column("c")], same)
    assert titles(made) == ["a", "b", "c"]
    assert titles(compact_table("Modes.", COLUMNS, [row(1, 29.98)])) == ["mode", "f [Hz]", "files", "motors"]
