"""Measurement files that are refused: errors with file, line, column and reason."""

from __future__ import annotations

import os
import pickle
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.diagnoses.measurement_files import CHANNELS, FULL, HEADER, ROW, read, refusal
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.reading import read_measurements


@pytest.mark.parametrize(
    ("header", "place", "expected", "remedy"),
    [
        ("pose,x,y,z,frequency", "line 1)", 'column "sigma" is missing', HEADER),
        (f"{HEADER},dampin", "line 1, column 7)", 'unknown column "dampin"', 'mean "damping"?'),
        (f"{HEADER},sigmax", "line 1, column 7)", 'unknown column "sigmax"', 'mean "sigma_x"?'),
        (
            f"{HEADER},x_1",
            "line 1, column 7)",
            'unknown column "x_1"',
            "write shape:x_1; otherwise remove it",
        ),
        (f"{HEADER},temperature", "line 1, column 7)", 'unknown column "temperature"', "known: pose,"),
        (f"{HEADER},shape:theta_11", "line 1, column 7)", "is not a coordinate", 'mean "shape:theta_1_1"?'),
        (f"{HEADER},sigma", "line 1, column 7)", "is repeated, first as column 6", "remove one"),
        (f"{HEADER},", "line 1, column 7)", "name of a column, found nothing", "remove it"),
        (
            HEADER.replace(",", ";"),
            "line 2, column x)",
            "expected 6 cells",
            "by semicolons, as in the header",
        ),
        (HEADER.replace(",", "\t"), "line 2, column x)", "expected 6 cells", "by tabs, as in the header"),
        (HEADER.replace(",", "|"), "line 1)", "separated by commas, semicolons or tabs", "uses bars"),
        (
            f'{HEADER.replace(",", ";")};"shape:x_1, left"',
            "line 1, column 7)",
            "is not a coordinate",
            "shape:x_1",
        ),
        (f'{HEADER.replace(",", ";")};"mode', "line 1)", "not valid CSV", "put a semicolon right after it"),
        ("sep=,", "line 2)", "expected the names of the columns", HEADER),
        (f"{HEADER},temperature", "line 1, column 7)", "unknown column", "remove it or correct the name"),
        ("A,0.6,0,-0.245,55.5,0.05", "line 1)", "expected the names of the columns", HEADER),
        (f'{HEADER},"mode', "line 1)", "not valid CSV", "close every quote"),
    ],
)
def test_a_wrong_header_is_refused(
    tmp_path: Path, header: str, place: str, expected: str, remedy: str
) -> None:
    line = refusal(tmp_path, f"{header}\n{ROW}\n")
    assert place in line, line
    assert expected in line, line
    assert remedy in line.partition("; ")[2], line


BAD_ROWS = [
    ("A,0.6,0,-0.245,55.5", "sigma", "expected 13 cells, found 5"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,,,,", "14", "expected 13 cells, found 14"),
    (",0.6,0,-0.245,55.5,0.05,,,,,,,", "pose", "expected a label"),
    ("A\x07,0.6,0,-0.245,55.5,0.05,,,,,,,", "pose", "expected a label"),
    ("A,0.6 m,0,-0.245,55.5,0.05,,,,,,,", "x", 'finite number, found "0.6 m"'),
    ("A,0.6,,-0.245,55.5,0.05,,,,,,,", "y", "finite number, found nothing"),
    ("A,0.6,0,nan,55.5,0.05,,,,,,,", "z", 'finite number, found "nan"'),
    ("A,0.6,0,1e99,55.5,0.05,,,,,,,", "z", "finite coordinate, found 1e+99"),
    ("A,0.6,0,-0.245,inf,0.05,,,,,,,", "frequency", 'finite number, found "inf"'),
    ("A,0.6,0,-0.245,1e999,0.05,,,,,,,", "frequency", 'finite number, found "1e999"'),
    ("A,0.6,0,-0.245,1_0,0.05,,,,,,,", "frequency", 'finite number, found "1_0"'),
    ("A,0.6,0,-0.245,\u0665,0.05,,,,,,,", "frequency", "finite number"),
    ("A,0.6,0,-0.245,0,0.05,,,,,,,", "frequency", "above 0 Hz, found 0"),
    ("A,0.6,0,-0.245,0,0.05,,,,,,,", "frequency", "; leave out rigid-body modes"),
    ("A,0.6,0,-0.245,-3,0.05,,,,,,,", "frequency", "above 0 Hz, found -3"),
    ("A,0.6,0,-0.245,1e300,0.05,,,,,,,", "frequency", "above 0 Hz (at most 1e+30), found 1e+300"),
    ("A,0.6,0,-0.245,55.5,0,,,,,,,", "sigma", "above 0 Hz, found 0"),
    ("A,0.6,0,-0.245,55.5,-1,,,,,,,", "sigma", "above 0 Hz, found -1"),
    ("A,0.6,0,-0.245,55.5,1e31,,,,,,,", "sigma", "above 0 Hz (at most 1e+30), found 1e+31"),
    ("A,0.6,0,-0.245,55.5,,,,,,,,", "sigma", "found nothing"),
    ("A,0.6,0,-0.245,55.5,55.5,,,,,,,", "sigma", "below the frequency, found 55.5"),
    ("A,0.6,0,-0.245,55.5,0.05,-1e-4,,,,,,", "sigma_x", "at least 0 m, found -0.0001"),
    ("A,0.6,0,-0.245,55.5,0.05,,,x,,,,", "sigma_z", 'found "x"'),
    ("A,0.6,0,-0.245,55.5,0.05,,,,1,,,", "damping", "below 1, found 1"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,-0.1,,,", "damping", "at least 0 and below 1, found -0.1"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,nan,,,", "damping", 'found "nan"'),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,a\x07b,,", "mode", "\\x07"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,,-,", "shape:x_1", 'found "-"'),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,,1e99,", "shape:x_1", "finite shape component, found 1e+99"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,,0,-0.0", "shape:x_1", "only zeros"),
    ("A,0.6,0,-0.245,55.5,0.05,,,,,,,0", "shape:p_z", "only zeros"),
    ("B,0.7,0,-0.245,55.5,0.05,,,,,,,", "x", 'pose "B" has two positions: x is 0.6 in line 3 and 0.7'),
    ("B,0.6,0,-0.245,55.5,0.05,,1e-4,,,,,", "sigma_y", 'pose "B" has two standard deviations'),
    ("B,0.6,0,-0.245,50,0.05,,,,,,,", "frequency", "repeats line 3"),
    ("B,0.6,0,-0.245,50.0,5e-2,0,0,0,,,,", "frequency", "repeats line 3"),
]


def test_a_bad_row_is_refused_with_line_and_column(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for row, column, expected in BAD_ROWS:
        with subtests.test(row=row):
            line = refusal(tmp_path, f"{FULL}\n# comment\nB,0.6,0,-0.245,50,0.05,,,,,,,\n\n{row}\n")
            assert f"modes.csv: line 5, column {column})" in line, line
            assert expected in line, line


def test_a_quote_that_is_not_closed_is_refused_on_its_line(tmp_path: Path) -> None:
    assert "modes.csv: line 3)" in refusal(tmp_path, f'{HEADER}\n{ROW}\n"B,0.6,0,-0.2,1,0.1\n{ROW}\n')


def test_the_first_of_several_problems_is_told_with_their_number(tmp_path: Path) -> None:
    line = refusal(tmp_path, f"{HEADER}\n{ROW}\nA,0.6,0,-0.245,x,0.05\nA,0.6,0\nA,y,0,-0.245,1,0.1\n")
    assert "line 3, column frequency, the first of 3 problems)" in line
    line = refusal(tmp_path, f"{HEADER}\n{ROW}\nA,0.6,0,-0.245,50,-1\nA,0.6,0,-0.245,-50,1\n")
    assert "line 3, column sigma, the first of 2 problems)" in line


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "expected a header"),
        ("\ufeff \n# nothing\n", "expected a header"),
        (f"{HEADER}\n# nothing\n", "found only a header"),
    ],
)
def test_a_file_without_rows_is_refused(tmp_path: Path, text: str, expected: str) -> None:
    assert expected in refusal(tmp_path, text)


def test_a_file_that_cannot_be_read_is_refused(tmp_path: Path) -> None:
    (tmp_path / "latin.csv").write_bytes(f"{HEADER}\n{ROW}\n".encode() + b"B\xe4,1,1,1,1,1\n")
    (tmp_path / "book.xlsx").write_bytes(b"PK\x03\x04\x14\x00rest")
    (tmp_path / "book.xls").write_bytes(b"\xd0\xcf\x11\xe0rest")
    os.mkfifo(tmp_path / "fifo")
    with (tmp_path / "large.csv").open("wb") as file:
        file.truncate(60_000_000)
    for name, expected in {
        "absent.csv": "no such file",
        "": "a folder",
        "fifo": "not a regular file",
        "large.csv": "larger than 50 MB",
        "latin.csv": "0xe4 (",
        "a\0b": "null",
        "book.xlsx": "found an Excel workbook",
        "book.xls": "found an Excel workbook",
    }.items():
        with pytest.raises(MeasurementError, match=expected.replace("(", r"\(")) as error:
            read_measurements(tmp_path / name, CHANNELS)
        assert str(tmp_path / name) in error.value.where
        assert name != "latin.csv" or "line 3" in error.value.where
    assert pickle.loads(pickle.dumps(error.value)).lines == error.value.lines


def test_a_file_that_may_not_be_read_is_told_as_such(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(f"{HEADER}\n{ROW}\n")

    def refuse(*_: object) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", refuse)
    with pytest.raises(MeasurementError, match="permission denied") as error:
        read_measurements(path, CHANNELS)
    assert error.value.remedy == "check its permissions"


def test_rows_of_commas_alone_are_blank_and_decimal_commas_are_named(tmp_path: Path) -> None:
    assert read(tmp_path, f"{HEADER}\n,,,,,\n{ROW}\n, ,,,,\n").lines.tolist() == [3]
    line = refusal(tmp_path, f"{HEADER}\nA,0,6,0,-0,245,55,5,0,05\n")
    assert (
        "decimal commas, export the table with semicolons between the cells, or with decimal points" in line
    )


@pytest.mark.parametrize("separator", [";", "\t"])
@pytest.mark.parametrize(
    ("cells", "place", "expected", "remedy"),
    [
        (
            "A 0,6 0 -0,245 55.5.5 0,05",
            "column frequency)",
            'found "55.5.5"',
            "in Hz, with a decimal point or comma",
        ),
        (
            "A 0,6 0 -0,245 1.234,5 0,05",
            "column frequency)",
            'found "1.234,5"',
            "with a decimal point or comma",
        ),
        (
            "A 0,6 0 -0,245 55,5 -0,05",
            "column sigma)",
            "standard deviation above 0 Hz, found -0.05",
            "write the standard",
        ),
        ("A 0,6 0 -0,245 55,5", "column sigma)", "expected 6 cells, found 5", "keep their "),
        ("A 0,6 0 -0,245 55,5 0,05 1", "column 7)", "expected 6 cells, found 7", "remove the extra cells"),
    ],
)
def test_a_bad_cell_between_semicolons_or_tabs_is_named(
    tmp_path: Path, separator: str, cells: str, place: str, expected: str, remedy: str
) -> None:
    header = HEADER.replace(",", separator)
    line = refusal(tmp_path, f"{header}\n{cells.replace(' ', separator)}\n")
    assert f"line 2, {place}" in line
    assert expected in line
    assert remedy in line


@settings(max_examples=100)
@given(st.lists(st.sampled_from([*'A,,,,0.1-e#" \n\t\r;', HEADER, ROW, "\n"]), max_size=30).map("".join))
def test_any_text_is_read_or_refused_clearly(tmp_path: Path, text: str) -> None:
    try:
        read(tmp_path, f"{HEADER}\n{ROW}\n{text}")
    except MeasurementError as error:
        assert "modes.csv: line" in str(error)
