"""Modal measurements: the meaning of a file, and errors with file, line, column and reason."""

from __future__ import annotations

import csv
import io
import os
import pickle
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pkmodes
from pkmodes import updating
from pkmodes.errors import MeasurementError
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.updating.poses import check_measured
from robot_text import PUBLISHED

CHANNELS = ("x_1", "x_2", "x_3", "theta_1_1", "theta_2_1", "p_x", "p_y", "p_z")
HEADER = "pose,x,y,z,frequency,sigma"
FULL = f"{HEADER},sigma_x,sigma_y,sigma_z,damping,mode,shape:x_1,shape:p_z"
ROW = "A,0.6,0,-0.245,55.5,0.05"


def read(tmp_path: Path, text: str) -> Measurements:
    path = tmp_path / "modes.csv"
    path.write_bytes(text.encode("utf-8"))
    return read_measurements(path, CHANNELS)


def refusal(tmp_path: Path, text: str) -> str:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, text)
    (line,) = error.value.lines
    assert str(tmp_path / "modes.csv") in line
    assert "\n" not in line
    assert "; " in line, "what to do is missing"
    return line


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


def test_optional_columns_may_be_absent_and_columns_are_in_any_order(tmp_path: Path) -> None:
    found = read(tmp_path, "sigma,frequency,z,y,x,pose\n0.05,55.5,-0.245,0,0.6,A\n")
    plain = read(tmp_path, f"{HEADER}\n{ROW}\n")
    for one, other in zip(vars(found).values(), vars(plain).values(), strict=True):
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


@pytest.mark.parametrize(
    ("header", "place", "expected", "remedy"),
    [
        ("pose,x,y,z,frequency", "line 1)", 'column "sigma" is missing', HEADER),
        (f"{HEADER},dampin", "line 1, column 7)", 'unknown column "dampin"', 'mean "damping"?'),
        (f"{HEADER},Sigma_x", "line 1, column 7)", 'unknown column "Sigma_x"', 'mean "sigma_x"?'),
        (f"{HEADER},temperature", "line 1, column 7)", 'unknown column "temperature"', "known: pose,"),
        (f"{HEADER},shape:theta_11", "line 1, column 7)", "is not a coordinate", 'mean "shape:theta_1_1"?'),
        (f"{HEADER},sigma", "line 1, column 7)", "is repeated, first as column 6", "remove one"),
        (f"{HEADER},", "line 1, column 7)", "name of a column, found nothing", "remove it"),
        (HEADER.replace(",", ";"), "line 1)", "separated by commas", HEADER),
        (HEADER.replace(",", "\t"), "line 1)", "separated by commas", HEADER),
        (HEADER.replace(",", "\t"), "line 1)", "separated by commas", "the file uses tabs: replace them"),
        (
            f'{HEADER.replace(",", ";")};"shape:x_1, left"',
            "line 1)",
            "separated by",
            "the file uses semicolons",
        ),
        ("sep=,", "line 1)", 'found "sep=,", a line for spreadsheet programs', "remove this line"),
        (f"sep=;\n{HEADER}", "line 1)", 'found "sep=;", a line for spreadsheet programs', "remove this line"),
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


@pytest.mark.parametrize(
    ("row", "column", "expected"),
    [
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
    ],
)
def test_a_bad_row_is_refused_with_line_and_column(
    tmp_path: Path, row: str, column: str, expected: str
) -> None:
    line = refusal(tmp_path, f"{FULL}\n# comment\nB,0.6,0,-0.245,50,0.05,,,,,,,\n\n{row}\n")
    assert f"modes.csv: line 5, column {column})" in line, line
    assert expected in line, line


def test_a_quote_that_is_not_closed_is_refused_on_its_line(tmp_path: Path) -> None:
    assert "modes.csv: line 3)" in refusal(tmp_path, f'{HEADER}\n{ROW}\n"B,0.6,0,-0.2,1,0.1\n{ROW}\n')


def test_two_modes_of_one_frequency_are_not_a_repetition(tmp_path: Path) -> None:
    found = read(tmp_path, f"{HEADER},mode\n{ROW},4\n{ROW},5\n")
    assert found.mode == ("4", "5")


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
    assert "if numbers have decimal commas, write points" in line


def test_positions_in_millimetres_are_recognised(tmp_path: Path) -> None:
    model = pkmodes.load(PUBLISHED)
    for header, place, remedy in (
        (HEADER, "600,0,-245", "look like millimetres: write x [mm],y [mm],z [mm] in the header"),
        (HEADER.replace("x,y,z", "x [mm],y [mm],z [mm]"), "0.6,0,-0.245", "look like metres"),
    ):
        with pytest.raises(MeasurementError) as error:
            check_measured(read(tmp_path, f"{header}\nA,{place},55.5,0.1\nA,{place},60,0.1\n"), model)
        assert remedy in error.value.remedy
    mixed = read(tmp_path, f"{HEADER}\nA,600,0,-245,55.5,0.1\nB,0.6,0,-0.245,60,0.1\n")
    with pytest.raises(MeasurementError, match="out of reach"):
        check_measured(mixed, model)


@pytest.mark.parametrize(("x", "recognised"), [(250.0, True), (0.31, False)])
def test_small_numbers_are_not_taken_for_millimetres(tmp_path: Path, x: float, recognised: bool) -> None:
    """The workspace of a CoreXY has the origin in it: a thousandth of any pose can be reached."""
    model = pkmodes.load(PUBLISHED.parent / "corexy-printer.toml")
    text = f"pose,x,y,frequency,sigma\nA,{x},{min(x, 0.2)},111,1\n"
    (tmp_path / "modes.csv").write_text(text)
    data = updating.read(tmp_path / "modes.csv", robot=model)
    with pytest.raises(MeasurementError) as error:
        check_measured(data, model)
    assert ("millimetres" in error.value.remedy) == recognised


def test_a_pose_that_the_robot_cannot_take_is_refused(tmp_path: Path) -> None:
    model = pkmodes.load(PUBLISHED)
    check_measured(read(tmp_path, f"{HEADER}\n{ROW}\n"), model)
    for place, reason in (("0.6,0,-0.5", "out of reach: link"), ("0.1,0,-0.245", "beyond its limits")):
        found = read(tmp_path, f"{HEADER}\n{ROW}\n# far\nC 3,{place},50,0.1\nC 3,{place},60,0.1\n")
        with pytest.raises(MeasurementError) as error:
            check_measured(found, model)
        line = str(error.value)
        assert f"{tmp_path / 'modes.csv'}: line 4, columns x, y and z)" in line
        assert f'"C 3" at [{place.replace(",", ", ")}] m' in line
        assert reason in line
        assert str(PUBLISHED) in error.value.remedy
    found = read(tmp_path, f"{HEADER}\nC,9,9,9,1,0.1\n{ROW}\nD,0.6,0,9,2,0.1\n")
    with pytest.raises(MeasurementError, match="line 2, columns x, y and z, the first of 2 bad poses"):
        check_measured(found, model)
    check_measured(found.at([1]), model)
    check_measured(found.at([]), model)


def test_a_part_of_the_poses_keeps_rows_and_numbers_poses_anew(tmp_path: Path) -> None:
    rows = ["C,3,0,0,30,0.1,1", "A,1,0,0,10,0.1,2", "C,3,0,0,31,0.1,3", "B,2,0,0,20,0.1,", "A,1,0,0,11,0.1,4"]
    found = read(tmp_path, "\n".join([f"{HEADER},shape:x_1", *rows]))
    assert found.labels == ("C", "A", "B")
    part = found.at([2, 0])
    assert part.labels == ("C", "B")
    assert part.points[:, 0].tolist() == [3.0, 2.0]
    assert part.pose.tolist() == [0, 0, 1]
    assert part.frequency.tolist() == [30.0, 31.0, 20.0]
    assert part.lines.tolist() == [2, 4, 5]
    np.testing.assert_array_equal(part.shapes, [[1.0], [3.0], [np.nan]])
    assert found.at(np.array([], dtype=int)).labels == ()
    for bad in ([3], [-1], [0, 0], [0.5], [True, False, True]):
        with pytest.raises(MeasurementError, match="pose indices"):
            found.at(bad)


def test_measurements_are_made_by_hand_and_cannot_be_written_to() -> None:
    found = Measurements.from_rows(["rig", "rig"], [10, 20.5], [0.1, 0.1], shapes={"m_1": [1, np.nan]})
    assert found.points.tolist() == [[0.0, 0.0, 0.0]]
    assert found.lines.tolist() == [1, 2]
    assert found.channels == ("m_1",)
    with pytest.raises(ValueError, match="read-only"):
        found.frequency[0] = 1.0
    points = np.zeros((2, 3))
    placed = Measurements.from_rows(["a", "b"], [1, 2], [0.1, 0.1], points=points)
    points[0] = 7.0
    assert (placed.points == 0.0).all()


@pytest.mark.parametrize(
    ("changes", "place", "expected"),
    [
        ({"sigma": [0.1, 0.0]}, "rig: line 2, column sigma", "above 0 Hz"),
        ({"sigma": [0.1]}, "rig: sigma", r"shape \(2,\), found \(1,\)"),
        ({"frequency": ["a", "b"]}, "rig: frequency", "numbers"),
        ({"frequency": 3.0}, "rig: frequency", "shape"),
        ({"frequency": [np.nan, 1.0]}, "rig: line 1, column frequency", "above 0 Hz"),
        ({"mode": ["1"]}, "rig: mode", "expected 2 mode numbers, found 1"),
        ({"pose": "ab"}, "rig: pose", "one label for each row"),
        ({"points": [[0, 0, 0]]}, "rig: points", "shape"),
        ({"points": [[0, 0, 0], [0, 0, 1]]}, "rig: line 2, column z", "two positions"),
        ({"points": [[0, 0, np.inf], [0, 0, np.inf]]}, "rig: line 1, column z", "finite"),
        ({"point_sigma": [[0, 0, -1.0], [0, 0, -1.0]]}, "rig: line 1, column sigma_z", "at least 0 m"),
        ({"shapes": {"m_1": [1.0]}}, "rig: shape:m_1", "shape"),
        ({"shapes": {"m_1": [1.0, np.inf]}}, "rig: line 2, column shape:m_1", "finite"),
        ({"lines": [1.5, 2.5]}, "rig: lines", "whole numbers"),
        ({"shape_sigma": [0.1, 2.0]}, "rig: line 2, argument shape_sigma", "below 1, .* found 2"),
        ({"shape_sigma": 5}, "rig: line 1, argument shape_sigma, the first of 2 problems", "found 5"),
        ({"damping_sigma": [0.1, -1.0]}, "rig: line 2, argument damping_sigma", "found -1"),
        ({"unit": "mm"}, "rig: unit", '"mm" is not a unit of frequency'),
        ({"sigma_shape": 0.02}, "from_rows", 'unknown argument "sigma_shape"'),
    ],
)
def test_measurements_made_by_hand_obey_the_same_rules(
    changes: dict[str, object], place: str, expected: str
) -> None:
    columns = {"pose": ["a", "a"], "frequency": [1.0, 2.0], "sigma": [0.1, 0.1], "source": "rig", **changes}
    with pytest.raises(MeasurementError, match=expected) as error:
        Measurements.from_rows(**columns)
    assert error.value.where == place


def test_one_number_states_the_deviation_of_all_shapes() -> None:
    found = Measurements.from_rows(["a", "a"], [1, 2], [0.1, 0.1], shape_sigma=0.02, damping_sigma=0.1)
    assert found.shape_sigma.tolist() == [0.02, 0.02]
    with pytest.raises(MeasurementError) as error:
        Measurements.from_rows(["a"], [1], [0.1], sigma_shape=[0.02])
    assert error.value.remedy == 'did you mean "shape_sigma"?'


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


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=60, deadline=None)
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


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=100, deadline=None)
@given(st.lists(st.sampled_from([*'A,,,,0.1-e#" \n\t\r;', HEADER, ROW, "\n"]), max_size=30).map("".join))
def test_any_text_is_read_or_refused_clearly(tmp_path: Path, text: str) -> None:
    try:
        read(tmp_path, f"{HEADER}\n{ROW}\n{text}")
    except MeasurementError as error:
        assert "modes.csv: line" in str(error)
