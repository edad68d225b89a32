"""What the motors did in a measurement: a line, a column or an argument, and errors with line and column."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.measurement_files import HEADER
from pkmodes import Robot, read_robot, updating
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, Measurements, Parameter, compare
from pkmodes.loop.measured.reading import read_measurements, read_modes

ROBOTS = Path(__file__).parents[3] / "robots"
COLUMN = "pose,drives,x,y,z,frequency,sigma"


@pytest.fixture(scope="module")
def robot() -> Robot:
    return read_robot(ROBOTS / "linear-delta-2022.toml")


def read(folder: Path, text: str, drives: str | None = None) -> Measurements:
    path = folder / "modes.csv"
    path.write_text(text, encoding="utf-8")
    return read_measurements(path, ("x_1",), drives=drives)


def refusal(folder: Path, text: str, drives: str | None = None) -> str:
    with pytest.raises(MeasurementError) as error:
        read(folder, text, drives)
    (line,) = error.value.lines
    assert str(folder / "modes.csv") in line
    assert error.value.remedy
    return line


ROWS = "A,0.6,0,-0.245,55,0.1\nB,0.5,0,-0.245,54,0.1\n"


@pytest.mark.parametrize(
    ("text", "given", "expected"),
    [
        (f"{HEADER}\n{ROWS}", None, ("free", "free")),
        (f"{HEADER}\n{ROWS}", "held", ("held", "held")),
        (f"# drives: held\n{HEADER}\n{ROWS}", None, ("held", "held")),
        (f"# drives: held\n{HEADER}\n{ROWS}", "held", ("held", "held")),
        (f"{HEADER}\n{ROWS}#Drives: Held\n", None, ("held", "held")),
        (f"# drives: held,,,,\n{HEADER}\n{ROWS}", None, ("held", "held")),
        (f"# drives were switched on\n{HEADER}\n{ROWS}", None, ("free", "free")),
        (f"{COLUMN}\nA,held,0.6,0,0,55,1\nB,,0.6,0,0,55,1\n", None, ("held", "free")),
        (f"{COLUMN}\nA,FREE,0.6,0,0,55,1\nB,held,0.6,0,0,55,1\n", None, ("free", "held")),
        (f"# drives: held\n{COLUMN}\nA,held,0.6,0,0,55,1\nB,,0.6,0,0,55,1\n", None, ("held", "held")),
    ],
)
def test_a_line_a_column_or_an_argument_says_it(
    tmp_path: Path, text: str, given: str | None, expected: tuple[str, str]
) -> None:
    data = read(tmp_path, text, given)
    assert data.drives == expected
    assert data.at([1]).drives == expected[1:]
    assert pickle.loads(pickle.dumps(data)).drives == expected


@pytest.mark.parametrize(
    ("text", "given", "what"),
    [
        (f"# drives = held\n{HEADER}\n{ROWS}", None, 'line 1): write "# drives: free"'),
        (f"# drives held\n{HEADER}\n{ROWS}", None, 'expected a colon after "drives"'),
        (f"# drives: on\n{HEADER}\n{ROWS}", None, 'expected "free" or "held", found "on"'),
        (
            f"# drives: held\n# drives: free\n{HEADER}\n{ROWS}",
            None,
            "this drives differs from that in line 1",
        ),
        (f"# drives: held\n{HEADER}\n{ROWS}", "free", "the file states that the motors were held, not free"),
        (f"{COLUMN}\nA,off,0,0,0,55,1\n", None, 'found "off" (FILE: line 2, column drives)'),
        (f"{COLUMN}\nA,held,0,0,0,55,1\nA,free,0,0,0,56,1\n", None, "line 3, column drives"),
        (f"{COLUMN}\nA,held,0,0,0,55,1\nA,,0,0,0,56,1\n", None, "drives is held in line 2 and free here"),
        (f"# drives: held\n{COLUMN}\nA,free,0,0,0,55,1\n", None, "expected held, as stated for all rows"),
        (f"{COLUMN}\nA,held,0,0,0,55,1\n", "free", "expected free, as stated for all rows"),
        (f"{HEADER},drive\nA,0,0,0,55,1,held\n", None, 'did you mean "drives"?'),
        (f"{HEADER},drives [Hz]\nA,0,0,0,55,1,held\n", None, "is not a quantity"),
    ],
)
def test_contradictions_are_refused(tmp_path: Path, text: str, given: str | None, what: str) -> None:
    found = refusal(tmp_path, text, given).replace("; ", ": ")
    assert what.replace("FILE", str(tmp_path / "modes.csv")) in found.replace("): ", "): ")


def test_a_structure_that_is_no_robot_has_no_motors(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("pose,drives,frequency,sigma\nA,held,55,1\n", encoding="utf-8")
    with pytest.raises(MeasurementError, match='unknown column "drives"'):
        read_modes(path, ("floor",))
    spring = MatrixStructure(
        [Parameter("k", 1e5)], [], lambda v, _: (np.eye(1), v["k"] * np.eye(1)), channels=["floor"]
    )
    held = Measurements.from_rows(["A"], [50.0], [0.1], drives="held")
    with pytest.raises(PkmodesError, match="the structure has no motors"):
        compare(spring, held)
    found = compare(spring, Measurements.from_rows(["A"], [50.0], [0.1]))
    assert [row.drives for row in found.rows] == [None]


def test_rows_from_a_script_are_checked_alike() -> None:
    rows = {"pose": ["A", "A", "B"], "frequency": [50.0, 60.0, 55.0], "sigma": [1.0] * 3}
    points = {"points": [[0.6, 0, -0.245]] * 2 + [[0.5, 0, -0.245]]}
    assert Measurements.from_rows(**rows, **points).drives == ("free", "free")
    assert Measurements.from_rows(**rows, **points, drives="held").drives == ("held", "held")
    mixed = Measurements.from_rows(**rows, **points, drives=["held", "held", "free"])
    assert mixed.drives == ("held", "free")
    for drives, what in (
        ("on", 'expected "free" or "held", found "on"'),
        (["held", "free", "free"], 'pose "A" has two values: drives is held in line 1 and free here'),
        (["held"], "expected one word for all rows, or 3, found 1"),
        ([1, 2, 3], "expected words"),
    ):
        with pytest.raises(MeasurementError, match=what):
            Measurements.from_rows(**rows, **points, drives=drives)  # type: ignore[arg-type]


def test_reading_for_a_robot_takes_the_same_word(tmp_path: Path, robot: Robot) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(f"{HEADER}\n{ROWS}", encoding="utf-8")
    assert updating.read(path, robot=robot, drives="held").drives == ("held", "held")
    with pytest.raises(PkmodesError, match='expected "free" or "held"'):
        updating.read(path, robot=robot, drives="locked")
