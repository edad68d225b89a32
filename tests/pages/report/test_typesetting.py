"""Numbers, counts and units of reports are set as in print, within sentences too."""

from __future__ import annotations

import datetime
from dataclasses import replace

import msgspec
import numpy as np
import pytest

from helpers.pages.report_examples import made_up
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined, Limit, Value
from pkmodes.pages.report import explanations, numbers
from pkmodes.pages.report.blocks import Cell, Facts, Section, Summary, Table, TextDifference, VerbatimLines
from pkmodes.pages.report.formatting import (
    display_unit,
    group_thousands,
    plural,
    three_digit_cell,
    typeset_sentences,
    unit_text,
)
from pkmodes.pages.report.page import date_of_page, page
from pkmodes.pages.report.report_context import ReportContext


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "not noise (p < 1e-6); explanation: it winds up.",
            "not noise (p < 10\u207b\u2076); explanation: it winds up.",
        ),
        ("p = 2.4e-3.", "p = 2.4\u2009\u00d7\u200910\u207b\u00b3."),
        ("up to 5.9e4 N/m", "up to 5.9\u2009\u00d7\u200910\u2074 N/m"),
        ("pose 1e-6b, file a1e-6", "pose 1e-6b, file a1e-6"),  # names
        ("2.9 times, at 50 Hz", "2.9 times, at 50 Hz"),
        (
            "along y, (7.996 +- 0.010)e-7 m/N",
            "along y, (7.996 \u00b1 0.010)\u2009\u00d7\u200910\u207b\u2077 m/N",
        ),
        ("a ratio of 3.09 +- 0.63 %", "a ratio of 3.09 \u00b1 0.63 %"),
        ("from 15 to 9.285 N*m/rad, 2 rad/(N*m)", "from 15 to 9.285 N\u00b7m/rad, 2 rad/(N\u00b7m)"),
        ("zv*zv leaves 9 %", "zv*zv leaves 9 %"),  # a kind of shaper
    ],
)
def test_powers_of_ten_within_sentences(text: str, expected: str) -> None:
    assert typeset_sentences(text) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("kg*m^2", "kg\u00b7m\u00b2"),
        ("kg m^2", "kg\u00b7m\u00b2"),
        ("rad/(N*m)", "rad/(N\u00b7m)"),
        ("N m/rad", "N\u00b7m/rad"),
        ("m/s^2", "m/s\u00b2"),
        ("1", ""),
    ],
)
def test_units_have_points_and_raised_powers(name: str, expected: str) -> None:
    assert unit_text(name) == expected


def test_counts_have_thin_spaces_between_thousands() -> None:
    assert group_thousands(492) == "492"
    assert group_thousands(6583) == "6\u202f583"
    assert plural(1234567, "pose") == "1\u202f234\u202f567 poses"


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (5.3, "5.30"),
        (12.7, "12.7"),
        (0.755, "0.755"),
        (134.2, "134"),
        (99.96, "100"),
        (0.0, "0"),
        (None, "\u2013"),
    ],
)
def test_three_digits_keep_their_zeros(value: float | None, expected: str) -> None:
    assert three_digit_cell(value).text == expected


@pytest.mark.parametrize(
    ("name", "values", "expected"),
    [
        ("m", (0.0, 8e-4), ("mm", 1e3)),
        ("m", (0.4, 0.401), ("m", 1.0)),
        ("m", (0.0, 0.0), ("m", 1.0)),
        ("rad", (1e-4,), ("rad", 1.0)),
        ("m/N", (1e-4,), ("m/N", 1.0)),
    ],
)
def test_short_lengths_are_read_in_mm(
    name: str, values: tuple[float, ...], expected: tuple[str, float]
) -> None:
    assert display_unit(name, *values) == expected


def test_a_row_of_fitted_values_has_one_unit() -> None:
    """0, then 0.8 mm +- 0.1 mm within 2 mm: not 8e-4 m."""
    result, _ = made_up(3, 2)
    value = Corrected("measurement.offset.z", 8e-4, 1e-4, "m", 0.0, 2e-3, False)
    few = replace(result, corrected=(value,), refitted=(), effects=())
    (block,) = numbers.fitted_value_tables(few, ReportContext("s", None, None, (), None))
    assert isinstance(block, Table)
    texts = [cell.text for cell in block.rows[0]]
    assert "0.80 \u00b1 0.10" in texts
    assert {"mm", "2"} <= set(texts)


def test_a_row_of_candidates_has_one_unit() -> None:
    """Visible from 2.4 mm, limit 0.8 mm: not 0.0024 and 8e-4 m."""
    result, _ = made_up(3, 2)
    name = "parameter:link.length"
    visible = Value("link.length", 2.4e-3, 1e-3, "m")
    few = replace(
        result,
        candidates=(Examined(name, 0.1, (visible,), True),),
        limits={"link.length": Limit(name, 8e-4, "m")},
    )
    (block,) = (block for block in explanations.candidate_blocks(few) if isinstance(block, Table))
    assert {"2.4", "0.8", "mm"} <= {cell.text for cell in block.rows[0]}


def test_fitted_modes_without_a_partner_are_told_beside_the_errors() -> None:
    """They make a chi-square of thousands beside an rms of half a per cent."""
    result, _ = made_up(6, 4)
    whole = replace(
        result,
        rows=tuple(msgspec.structs.replace(row, before=1.0, refit=1.0, after=1.0) for row in result.rows),
    )
    assert not any("no partner" in getattr(block, "text", "") for block in numbers.error_blocks(whole))
    fitted = [i for i, row in enumerate(whole.rows) if not (row.held_out or row.outlier)]
    lost = {fitted[0], fitted[2], next(i for i, row in enumerate(whole.rows) if row.held_out)}
    rows = tuple(
        msgspec.structs.replace(row, before=None) if i in lost else row for i, row in enumerate(whole.rows)
    )
    texts = [getattr(block, "text", "") for block in numbers.error_blocks(replace(whole, rows=rows))]
    assert (
        "2 fitted modes have no partner in the model (as declared): each counts in chi\u00b2 as a difference by a "
        "factor of 1.8, and not in the rms. The model has no mode left for them."
    ) in texts
    assert result.stages is not None
    nearest = np.full(len(rows), np.nan)
    nearest[fitted[2]] = 138.1
    before = replace(result.stages.before, nearest_frequency=nearest)
    mixed = replace(whole, rows=rows, stages=replace(result.stages, before=before))
    texts = [getattr(block, "text", "") for block in numbers.error_blocks(mixed)]
    assert (
        "2 fitted modes have no partner in the model (as declared). In chi\u00b2, 1 counts as a difference by a "
        "factor of 1.8, because no mode is left, and 1 counts as the difference from the nearest mode, which has "
        "another shape (MAC below 0.5). None counts in the rms."
    ) in texts


@pytest.mark.parametrize(("epoch", "date"), [("1700000000", "2023-11-14"), ("0", "1970-01-01")])
def test_a_page_has_the_date_of_its_source(epoch: str, date: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", epoch)
    assert f'Map<time datetime="{date}">, {date}</time>' in page(Summary("robot", "Map", headline="h"), [])


def test_a_page_has_the_date_of_the_day(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SOURCE_DATE_EPOCH")
    days = {str(datetime.datetime.now().astimezone().date())}
    found = date_of_page()
    assert found in days | {str(datetime.datetime.now().astimezone().date())}
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "yesterday")
    with pytest.raises(PkmodesError, match="expected whole seconds since 1970"):
        date_of_page()


def test_a_line_does_not_end_between_a_number_and_its_unit() -> None:
    """Nor after a minus sign; lines to copy have the plain spaces, and names break after dots and underscores."""
    summary = Summary(
        "robot",
        "Report",
        "It leaves 10 % of 5 kHz",
        reason='By 3 mm, 2 sigma; model / measurement \u2212 1, write "2 %".',
    )
    blocks = [
        VerbatimLines("firmware", ["ratio = 2 % # leaves 3 %"]),
        TextDifference("file", ["-sigma = 2 %"]),
        Facts([("value", [Cell("", identifier="effects.servo_stiffness.k<1>")])]),
    ]
    text = page(summary, [Section("lines", "Lines", blocks)])
    for kept in (
        "It leaves 10\u00a0% of 5\u00a0kHz",
        "By 3\u00a0mm, 2\u00a0sigma; model / measurement \u2212\u00a01,",
        "write &#34;2 %&#34;",
        "ratio = 2 % # leaves 3 %",
        "-sigma = 2 %",
        "effects.<wbr>servo_<wbr>stiffness.<wbr>k&lt;1&gt;",
    ):
        assert kept in text
