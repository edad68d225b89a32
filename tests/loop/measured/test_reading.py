"""The meaning of a measurement file: columns, optional cells, lines, and that all tables read back exactly."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.diagnoses.measurement_files import FULL, HEADER, ROW, read
from pkmodes.loop.measured.measurements import Measurements


def test_every_column_is_read(tmp_path: Path) -> None:
    text = (
        "# measured on Monday\n"
        "\n"
        f"{FULL}\n"
        "B, 0.6, 0, -0.245, 55.5, 0.05, 1e-4, , 2e-4, 0.02, first, 0.5, \n"
        "  # the hammer slipped\n"
        '"A, corner",.5,1e-1,-0.3,60,0.5,,,,,,,-1.0\n'
        "B,0.60,0,-0.245,61,0.05,1e-4,,2e-4,,2,,\n"
    )
    found = read(tmp_path, text)
    assert found.source == str(tmp_path / "modes.csv")
    assert found.labels == ("B", "A, corner")
    assert found.points.tolist() == [[0.6, 0.0, -0.245], [0.5, 0.1, -0.3]]
    assert found.point_sigma.tolist() == [[1e-4, 0.0, 2e-4], [0.0, 0.0, 0.0]]
    assert found.pose.tolist() == [0, 1, 0]
    assert found.frequency.tolist() == [55.5, 60.0, 61.0]
    assert found.sigma.tolist() == [0.05, 0.5, 0.05]
    np.testing.assert_array_equal(found.damping, [0.02, np.nan, np.nan])
    assert found.mode == ("first", "", "2")
    assert found.lines.tolist() == [4, 6, 7]
    assert found.channels == ("x_1", "p_z")
    np.testing.assert_array_equal(found.shapes, [[0.5, np.nan], [np.nan, -1.0], [np.nan, np.nan]])


#: What a German spreadsheet program makes of a file: quoted comments, separators at the ends of lines.
SPREADSHEET = """\ufeff"# band: 10,5 Hz; 400 Hz"||||||
pose|x [mm]|y [mm]|z|frequency|sigma|mode|shape:x_1|shape:p_z
||||||
A|600|0|-0,245|55,5|5,0e-2||1,037|
"B, corner"|500,5|100|-,3|60|0,5|first||-1
"""


@pytest.mark.parametrize("separator", [";", "\t"])
@pytest.mark.parametrize("decimal", [",", "."])
def test_semicolons_and_tabs_separate_and_decimals_may_have_commas(
    tmp_path: Path, separator: str, decimal: str
) -> None:
    comment, _, rows = SPREADSHEET.replace("|", separator).partition("\n")
    text = f"{comment}\n{rows if decimal == ',' else rows.replace(',', '.')}"
    found = read(tmp_path, text)
    assert found.labels == ("A", "B, corner" if decimal == "," else "B. corner")
    assert found.points.tolist() == [[0.6, 0.0, -0.245], [0.5005, 0.1, -0.3]]
    assert found.frequency.tolist() == [55.5, 60.0]
    assert found.sigma.tolist() == [0.05, 0.5]
    assert found.mode == ("", "first")
    assert found.lines.tolist() == [4, 5]
    assert found.band == (10.5, 400.0)
    np.testing.assert_array_equal(found.shapes, [[1.037, np.nan], [np.nan, -1.0]])


def test_a_header_has_one_separator_whatever_else_is_in_it(tmp_path: Path) -> None:
    aligned = read(tmp_path, f"{HEADER}\n{ROW}\n".replace(",", ",\t"))
    assert aligned.points.tolist() == [[0.6, 0.0, -0.245]]
    assert read(tmp_path, f'"{HEADER.replace(",", "#,#")}"\n{ROW}\n'.replace("#", '"')).labels == ("A",)


def test_optional_columns_may_be_absent_and_columns_are_in_any_order(tmp_path: Path) -> None:
    found = read(tmp_path, "sigma,frequency,z,y,x,pose\n0.05,55.5,-0.245,0,0.6,A\n")
    plain = read(tmp_path, f"{HEADER}\n{ROW}\n")
    for one, other in zip(vars(found).values(), vars(plain).values(), strict=True):
        np.testing.assert_array_equal(one, other)
    for one, other in zip(found.numbers.values(), plain.numbers.values(), strict=True):
        np.testing.assert_array_equal(one, other)
    assert found.channels == ()
    assert found.shapes.shape == (1, 0)
    assert found.point_sigma.tolist() == [[0.0, 0.0, 0.0]]
    assert np.isnan(found.damping).all()
    assert np.isnan(found.damping_sigma).all()
    assert np.isnan(found.shape_sigma).all()
    assert found.band is None
    assert found.mode == ("",)


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_lines_are_counted_whatever_ends_them(tmp_path: Path, newline: str, mark: str) -> None:
    text = mark + newline.join(["# one", "", HEADER, "", ROW, "A,0.6,0,-0.245,60,0.1"])
    assert read(tmp_path, text).lines.tolist() == [5, 6]
    # A character that only Python treats as a line ending is not one.
    assert read(tmp_path, text.replace("# one", "# o\x0b\x85\u2028ne")).lines.tolist() == [5, 6]


def test_two_modes_of_one_frequency_are_not_a_repetition(tmp_path: Path) -> None:
    found = read(tmp_path, f"{HEADER},mode\n{ROW},4\n{ROW},5\n")
    assert found.mode == ("4", "5")


labels = st.text(st.characters(codec="utf-8", exclude_categories=["C", "Z"]), min_size=1, max_size=5)
coordinates = st.floats(-10, 10)
poses = st.dictionaries(labels, st.tuples(coordinates, coordinates, coordinates), min_size=1, max_size=4)
components = st.none() | st.floats(1e-3, 10) | st.floats(-10, -1e-3)


@st.composite
def tables(draw: st.DrawFn) -> list[tuple[object, ...]]:
    """Rows of a valid file, None for a blank cell."""
    points = draw(poses)
    spreads = {label: draw(st.none() | st.floats(0, 1)) for label in points}
    rows = []
    for number in range(draw(st.integers(1, 8))):
        label = draw(st.sampled_from(list(points)))
        frequency = draw(st.floats(1.0, 1e3))
        sigma = draw(st.floats(1e-9, 0.9))
        damping = draw(st.none() | st.floats(0, 0.99))
        shape = (draw(components), draw(components))
        rows.append((label, *points[label], frequency, sigma, spreads[label], damping, number, *shape))
    return rows


def text_of(rows: list[tuple[object, ...]]) -> str:
    file = io.StringIO()
    writer = csv.writer(file, quoting=csv.QUOTE_NONNUMERIC)
    writer.writerow([*HEADER.split(","), "sigma_y", "damping", "mode", "shape:p_x", "shape:x_3"])
    writer.writerows([["" if cell is None else cell for cell in row] for row in rows])
    return file.getvalue()


def plain(found: Measurements) -> list[tuple[object, ...]]:
    """Return the measurements as rows of the file."""

    def cell(value: float) -> float | None:
        return None if np.isnan(value) else float(value)

    return [
        (
            found.labels[p],
            *found.points[p].tolist(),
            found.frequency[i],
            found.sigma[i],
            found.point_sigma[p, 1],
            cell(found.damping[i]),
            int(found.mode[i]),
            *map(cell, found.shapes[i]),
        )
        for i, p in enumerate(found.pose)
    ]


@settings(max_examples=60)
@given(tables(), st.randoms(use_true_random=False))
def test_valid_tables_read_back_exactly_in_any_order(tmp_path: Path, rows, random) -> None:
    expected = [tuple(0.0 if k == 6 and c is None else c for k, c in enumerate(row)) for row in rows]
    found = read(tmp_path, text_of(rows))
    assert plain(found) == expected
    assert list(found.labels) == list(dict.fromkeys(row[0] for row in rows))
    assert found.lines.tolist() == list(range(2, len(rows) + 2))
    order = list(range(len(rows)))
    random.shuffle(order)
    assert plain(read(tmp_path, text_of([rows[i] for i in order]))) == [expected[i] for i in order]
