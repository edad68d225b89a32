"""The blocks of a result on a terminal: those of its page, in characters that every terminal has."""

from __future__ import annotations

import pytest

from helpers.commands.printed_tables import printed_table
from helpers.pages.page_reading import read
from pkmodes.cli.layout import terminal_text
from pkmodes.cli.terminal import Terminal
from pkmodes.pages.report.blocks import (
    Cell,
    Column,
    Facts,
    Listing,
    Paragraph,
    Section,
    Summary,
    Table,
    VerbatimLines,
)
from pkmodes.pages.report.formatting import (
    frequency_cell,
    group_thousands,
    label_cell,
    number_cell,
    rounded_cell,
    uncertain_cell,
    unit_cell,
)
from pkmodes.pages.report.page import page

TABLE = Table(
    "Values \u00b1 \u03c3, chi\u00b2:",
    [
        Column("value", False),
        Column("f [Hz]"),
        Column("\u03c3 [Hz]"),
        Column("why", False, page_only=True),
        Column("unit", False),
    ],
    [
        [
            Cell.named("the mass", "a.mass"),
            frequency_cell(12.0),
            number_cell(-0.0, "+.2f"),
            Cell("no"),
            unit_cell("N*m^2"),
        ],
        [
            label_cell("P\u20131"),
            uncertain_cell(1.92e-4, 8.3e-5),
            rounded_cell(None),
            Cell("no"),
            unit_cell("1"),
        ],
    ],
    [("", 1), ("measured", 2), ("", 2)],
    "\u2013: none.",
)


@pytest.fixture(autouse=True)
def width(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")


def test_a_table_has_the_columns_of_the_page_and_numbers_that_can_be_copied(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Terminal().show(TABLE)
    assert capsys.readouterr().out == (
        "\n"
        "Values +- sigma, chi2:\n"
        "        measured\n"
        "value              f [Hz]  sigma [Hz]  unit\n"
        "a.mass             12.000        0.00  N*m^2\n"
        "P\u20131     (1.92 +- 0.83)e-4           -\n"
        "-: none.\n"
    )
    shown = read(page(Summary("a", "b"), [Section("all", "All", [TABLE])])).by_id("all")
    titles = [cell.text for cell in shown.all("thead")[0].all("tr")[-1].all("th")]
    assert titles == [column.title for column in TABLE.columns]
    rows = [
        [cell.text.strip() for cell in row.children if not isinstance(cell, str)] for row in shown.all("tr")
    ]
    assert rows[3] == ["P\u20131", "(1.92 \u00b1 0.83)\u2009\u00d7\u200910\u207b\u2074", "\u2013", "no", ""]


def test_columns_that_do_not_fit_are_below_and_a_wide_name_above(capsys: pytest.CaptureFixture[str]) -> None:
    columns = [Column("name", False), *(Column(f"number {k}") for k in range(7))]
    for name in ("short", "a name that is much too long"):
        Terminal().show(Table("", columns, [[label_cell(name), *(number_cell(k, ".0f") for k in range(7))]]))
        lines = capsys.readouterr().out.splitlines()
        assert max(map(len, lines)) <= 60
        # Parts of about as many columns, the first in each; digits stand below the end of their titles.
        titles = [line.split("  ") for line in lines if "number" in line]
        assert [len(part) for part in titles] == ([5, 4] if name == "short" else [4, 3])
        assert lines.count(name) == (0 if name == "short" else 2)
    Terminal().show(
        Table("", columns[:6], [[label_cell("longer name"), *(number_cell(k, ".0f") for k in range(5))]])
    )
    narrow = capsys.readouterr().out.splitlines()[1]
    assert (
        narrow == "name        number 0 number 1 number 2 number 3 number 4"
    )  # one space, so that it is one table


def test_characters_of_two_columns_move_no_number(capsys: pytest.CaptureFixture[str]) -> None:
    rows = [[label_cell(name), number_cell(1.5, ".1f")] for name in ("\u6a21\u5f0f", "P 2")]
    Terminal().show(Table("", [Column("pose", False), Column("f [Hz]")], rows))
    assert capsys.readouterr().out == "\npose  f [Hz]\n\u6a21\u5f0f     1.5\nP 2      1.5\n"


def test_names_of_one_row_are_broken_at_their_commas_where_the_table_is_too_wide(
    capsys: pytest.CaptureFixture[str],
) -> None:
    columns = [Column("name", False), *(Column(f"number {k}") for k in range(4))]
    rows = [[label_cell("first.quantity, second.quantity"), *(number_cell(k, ".0f") for k in range(4))]]
    Terminal().show(Table("", columns, rows))
    out = capsys.readouterr().out
    assert out.splitlines()[2:] == [
        "first.quantity,         0         1         2         3",
        "second.quantity",
    ]
    assert printed_table(out, *(column.title for column in columns)) == [
        ["first.quantity, second.quantity", *"0123"]
    ]


def test_a_group_that_goes_on_below_is_named_again(capsys: pytest.CaptureFixture[str]) -> None:
    columns = [Column("name", False), *(Column(f"column number {k}") for k in range(5))]
    rows = [[Cell("x"), *(number_cell(k, ".0f") for k in range(5))]]
    Terminal().show(Table("", columns, rows, [("", 1), ("first", 1), ("the rest", 4)]))
    lines = capsys.readouterr().out.splitlines()
    assert [line.split("  ")[-1].strip() for line in lines if "the rest" in line] == ["the rest", "the rest"]
    assert lines[1].index("first") == lines[2].index("column number 0")
    assert lines[1].index("the rest") == lines[2].index("column number 1")


def test_the_other_blocks_follow_each_other(capsys: pytest.CaptureFixture[str]) -> None:
    Terminal().show(
        Paragraph("These remain:"),
        Listing(["a or b", "c"]),
        Facts([("x [m\u00b2]", [number_cell(-1.5, ".1f"), Cell("or more")])]),
        VerbatimLines("File", ["a = 1", "b = 2"]),
        Listing(["one", "two"], in_columns=True),
    )
    assert capsys.readouterr().out == (
        "\nThese remain:\n  a or b\n  c\n\n  x [m^2]: -1.5 or more\n\nFile:\n  a = 1\n  b = 2\n\n  one, two\n"
    )


def test_the_head_is_that_of_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    head = Summary(
        "robot \u00b2",
        "Map",
        headline="5 \u00b5m",
        reason="Why.",
        notes=["Note."],
        facts=[("f", frequency_cell(2.0))],
    )
    terminal = Terminal()
    terminal.summary(head)
    terminal.notes(head)
    assert capsys.readouterr().out == "robot \u00b2: 5 um\n  Why.\n  f: 2.000\n\nnote: Note.\n"


def test_what_is_set_as_in_print_is_typed() -> None:
    assert [frequency_cell(value).terminal_text for value in (None, 9041462019.1, 2.0)] == [
        "-",
        "9.04e9",
        "2.000",
    ]
    assert (
        terminal_text("1.2\u2009\u00d7\u200910\u207b\u00b9\u00b2 N\u00b7m/rad\u00b2 < 10\u207b\u2076")
        == "1.2e-12 N*m/rad^2 < 1e-6"
    )
    assert terminal_text(f"{group_thousands(12345)} poses at 2\u00a0% and \u22121\u00b0, exp(+i\u03c9t)") == (
        "12,345 poses at 2 % and -1deg, exp(+i omega t)"
    )
