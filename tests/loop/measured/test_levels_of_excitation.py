"""Levels of excitation in measurement files: one level for each label, wrong ones with their place."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

from pkmodes import read_robot, updating
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.diagnosis import Measurements
from pkmodes.loop.measured.reading import read_measurements, read_modes
from pkmodes.loop.measured.writing import as_csv

ROBOTS = Path(__file__).parents[3] / "robots"
HEADER = "pose,x,y,z,frequency,sigma"


def read(folder: Path, text: str) -> Measurements:
    path = folder / "modes.csv"
    path.write_text(text, encoding="utf-8")
    return read_measurements(path, ("x_1",))


@pytest.mark.parametrize(
    ("column", "unit"),
    [("level", ""), ("level [N]", "N"), ("Level (m/s^2)", "m/s^2"), ("level [%]", "%"), ("level [V]", "V")],
)
def test_a_level_is_read_in_the_unit_of_its_header_and_written_back(
    tmp_path: Path, column: str, unit: str
) -> None:
    text = (
        f"{HEADER},{column}\nA low,0.6,0,0,55,0.1,0.1\nA high,0.6,0,0,54,0.1,1\nA low,0.6,0,0,60,0.1,0.10\n"
    )
    data = read(tmp_path, f"{text}B,0.6,0.1,0,54,0.1,\n")
    np.testing.assert_array_equal(data.level, [0.1, 1.0, np.nan])
    assert data.level_unit == unit
    assert [data.level_at(pose) for pose in range(3)] == [0.1, 1.0, None]
    assert not data.level.flags.writeable
    np.testing.assert_array_equal(data.at([2, 1]).level, [1.0, np.nan])
    twin = pickle.loads(pickle.dumps(data))
    np.testing.assert_array_equal(twin.level, data.level)
    again = read(tmp_path, as_csv(data))
    np.testing.assert_array_equal(again.level, data.level)
    assert again.level_unit == unit
    assert "level" not in as_csv(data.at([2]))


def test_the_same_position_at_two_levels_is_two_poses_with_the_same_conditions(tmp_path: Path) -> None:
    data = read(tmp_path, f"{HEADER},level\nA low,0.6,0,0,55,0.1,0.1\nA high,0.6,0,0,55,0.1,1\n")
    assert data.labels == ("A low", "A high")
    assert data.conditions.tolist() == [0, 0]


@pytest.mark.parametrize(
    ("text", "expected", "remedy"),
    [
        (
            f"{HEADER},level [N]\nA,0,0,0,55,1,0.1\nA,0,0,0,54,1,1\n",
            'pose "A" has two values: level is 0.1 in line 2 and 1 here',
            '"P1 low" and "P1 high"',
        ),
        (f"{HEADER},level\nA,0,0,0,55,1,0.1\nA,0,0,0,54,1,\n", "0.1 in line 2 and blank here", "P1 low"),
        (f"{HEADER},level\nA,0,0,0,55,1,0\n", "a level of excitation above 0, found 0", "rms or the peak"),
        (f"{HEADER},level\nA,0,0,0,55,1,-20\n", "line 2, column level", "leave it blank"),
        (f"{HEADER},level [N]\nA,0,0,0,55,1,low\n", 'found "low"', "a plain number in N"),
        (f"{HEADER},level [dBV]\nA,0,0,0,55,1,20\n", 'the unit "dBV"', "rms or the peak"),
        (f"{HEADER},level,Level\nA,0,0,0,55,1,20,20\n", "is repeated", "remove one"),
        (f"{HEADER},levels\nA,0,0,0,55,1,20\n", "unknown column", 'mean "level"'),
        (f"{HEADER},excitation level\nA,0,0,0,55,1,20\n", "unknown column", 'mean "level"'),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, text: str, expected: str, remedy: str) -> None:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, text)
    (line,) = error.value.lines
    assert expected in line
    assert remedy in line
    assert str(tmp_path / "modes.csv") in line


def test_levels_of_a_script_are_checked_alike() -> None:
    rows = {"pose": ["A", "A", "B"], "frequency": [50.0, 60.0, 55.0], "sigma": [1.0] * 3}
    assert np.isnan(Measurements.from_rows(**rows).level).all()
    assert Measurements.from_rows(**rows, level=2.0).level.tolist() == [2.0, 2.0]
    data = Measurements.from_rows(**rows, level=[1.0, 1.0, 2.0], level_unit=" N ")
    assert (data.level.tolist(), data.level_unit) == ([1.0, 2.0], "N")
    for given, what in (
        ({"level": [1.0, 2.0, 3.0]}, 'pose "A" has two values: level is 1 in line 1 and 2 here'),
        ({"level": [1.0, 2.0]}, "expected an array of shape (3,), found (2,)"),
        ({"level": ["low", "low", "high"]}, "expected an array of numbers: found values of type"),
        ({"level": np.inf}, "a level of excitation above 0, found inf"),
        ({"level": 1.0, "level_unit": "dB"}, "not logarithmic"),
        ({"level": 1.0, "level_unit": "[N]"}, "expected a unit"),
        ({"level": 1.0, "level_unit": 3}, "expected a unit, found 3"),
        ({"levels": 1.0}, 'did you mean "level"?'),
    ):
        with pytest.raises(MeasurementError) as error:
            Measurements.from_rows(**rows, **given)
        assert what in error.value.lines[0]


def test_a_structure_that_is_no_robot_may_have_levels(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("pose,frequency,sigma,level [N]\nA,55,1,3\n", encoding="utf-8")
    assert read_modes(path, ("floor",)).level.tolist() == [3.0]


def test_a_comparison_with_a_robot_notes_frequencies_that_change_with_the_level(tmp_path: Path) -> None:
    robot, rows = read_robot(ROBOTS / "linear-delta-2022.toml"), [f"{HEADER},level [N],sigma_x"]
    for label, level, change in (("P1 low", 0.1, 1.0), ("P1 high", 1.0, 0.98)):
        rows += [f"{label},0.6,0,-0.245,{f * change},0.05,{level},1e-4" for f in (55.559, 60.376, 61.498)]
    path = tmp_path / "modes.csv"
    path.write_text("\n".join(rows), encoding="utf-8")
    found = updating.compare(robot, updating.read(path, robot=robot))
    assert any("from a level of 0.1 to 1 N" in note and "by -2 %" in note for note in found.notes)
    assert [row["level"] for row in found.as_json("delta")["rows"]] == [0.1] * 3 + [1.0] * 3
