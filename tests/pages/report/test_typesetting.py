"""Numbers, counts and units of reports are set as in print, within sentences too."""

from __future__ import annotations

import datetime

import pytest

from pkmodes.core.base.errors import PkmodesError
from pkmodes.pages.report.blocks import Summary
from pkmodes.pages.report.formatting import plural, prose, thousands, three_digits, unit
from pkmodes.pages.report.page import date_of_page, page


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
    ],
)
def test_powers_of_ten_within_sentences(text: str, expected: str) -> None:
    assert prose(text) == expected


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
    assert unit(name) == expected


def test_counts_have_thin_spaces_between_thousands() -> None:
    assert thousands(492) == "492"
    assert thousands(6583) == "6\u202f583"
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
    assert three_digits(value).text == expected


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
