"""The comparison with golden outcomes sees a changed word, key or digit, and not the rounding of another machine."""

from __future__ import annotations

import json

import pytest

from helpers.golden.agreement import differences

TEXT = "mode 1: 72.351 Hz, p = 1.2e-7\nchi2 = 60.3\n"
DOCUMENT = {
    "f": [[0.0, 72.35], [1.5, 2.0]],
    "verdict": "adequate",
    "count": 12,
    "sigma": 0.25,
    "note": "by 3.5 %",
}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("72.351", "72.353"),
        ("1.2e-7", "1.2e-6"),
        ("mode 1", "mode 2"),
        ("chi2", "chi"),
        ("60.3\n", "60.3\n\n"),
        ("60.3", "-60.3"),
    ],
)
def test_a_changed_line_is_seen(old: str, new: str) -> None:
    assert differences("terminal.txt", TEXT, TEXT.replace(old, new, 1))


def test_the_last_digit_of_a_line_may_differ() -> None:
    assert not differences("terminal.txt", TEXT, TEXT.replace("72.351", "72.352").replace("1.2e-7", "1.3e-7"))


@pytest.mark.parametrize(
    "changed",
    [
        {"f": [[0.0, 72.35], [1.5, 2.1]]},
        {"f": [0.0, 72.35, 1.5, 2.0]},
        {"verdict": "ambiguous"},
        {"count": 13},
        {"count": 12.0},
        {"sigma": 0.2501},
        {"sigma": None},
        {"note": "by 4.5 %"},
        {"further": 1},
    ],
)
def test_a_changed_document_is_seen(changed: dict[str, object]) -> None:
    assert differences("out.json", json.dumps(DOCUMENT), json.dumps(DOCUMENT | changed))


def test_the_order_of_keys_is_part_of_a_document() -> None:
    assert differences("out.json", json.dumps(DOCUMENT), json.dumps(dict(reversed(DOCUMENT.items()))))


def test_rounding_in_a_document_is_not_seen() -> None:
    near = DOCUMENT | {"f": [[1e-9, 72.35 + 1e-9], [1.5, 2.0]], "sigma": 0.25 + 1e-10}
    assert not differences("out.json", json.dumps(DOCUMENT), json.dumps(near))


def test_cells_of_a_table_are_compared_by_their_column() -> None:
    table = 'x,f,why\n1,72.35,""\n2,1e-17,"far, off"\n'
    assert not differences("table.csv", table, table.replace("1e-17", "-3e-16"))
    for old, new in (("72.35", "72.36"), ("far, off", "far"), ("x,f", "x,g"), ('2,1e-17,"far, off"\n', "")):
        assert differences("table.csv", table, table.replace(old, new)), old
