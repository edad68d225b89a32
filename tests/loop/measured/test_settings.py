"""Columns that set values: their meaning, and errors with file, line and column."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import numpy as np
import pytest

from pkmodes import Model, Robot, read_robot, updating
from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, Measurements, Parameter, compare

ROBOTS = Path(__file__).parents[3] / "robots"
HEADER = "pose,x,y,frequency,sigma"
TENSION = "set:effects.belt_tension_stiffness.tension"
PAYLOAD = "set:effects.payload.mass"
DELTA = "pose,x,y,z,frequency,sigma"


@pytest.fixture(scope="module")
def robot() -> Robot:
    return read_robot(ROBOTS / "corexy-printer.toml")


def read(folder: Path, text: str, robot: Robot | None) -> Measurements:
    path = folder / "modes.csv"
    path.write_text(text, encoding="utf-8")
    return updating.read(path, robot=robot)


def test_values_are_read_in_their_units_and_by_pose(tmp_path: Path, robot: Robot) -> None:
    text = (
        f"{HEADER},{PAYLOAD} [g],{TENSION},set:belt_path.2.belt.width [mm]\n"
        "A,0.1,0.1,100,0.1,350,,\n"
        "B,0.1,0.1,90,0.1,,42.5,6.35\n"
        "A,0.1,0.1,150,0.1,350.0,,\n"
        "C,0.1,0.2,100,0.1,,,\n"
    )
    for given in (robot, Model(robot), None):  # without a robot, what any mechanism has
        data = read(tmp_path, text, given)
        assert data.settings == (PAYLOAD[4:], TENSION[4:], "belt_path.2.belt.width")
        expected = [[0.35, np.nan, np.nan], [np.nan, 42.5, 0.00635], [np.nan] * 3]
        np.testing.assert_array_equal(data.set_values, expected)
        assert data.load(1) == {TENSION[4:]: 42.5, "belt_path.2.belt.width": 0.00635}
        assert data.load(2) == {}
    part = data.at([2, 1])
    assert part.labels == ("B", "C")
    np.testing.assert_array_equal(part.set_values, data.set_values[1:])
    twin = pickle.loads(pickle.dumps(data))
    np.testing.assert_array_equal(twin.set_values, data.set_values)
    assert not data.set_values.flags.writeable
    plain = read(tmp_path, f"{HEADER}\nA,0.1,0.1,100,0.1\n", robot)
    assert plain.settings == ()
    assert plain.set_values.shape == (1, 0)


@pytest.mark.parametrize(
    ("column", "expected", "remedy"),
    [
        ("set:effects.payload.mas", "is not a value that can be set", 'mean "set:effects.payload.mass"'),
        ("set:", "is not a value that can be set", "docs/reference/parameter-paths.md"),
        ("set:platform.mass", "is not a value that can be set", "correct the name"),
        ("set:belt_path.1.direction", "is not a value that can be set", "correct the name"),
        (
            "set:effects.gearbox_compliance.compliance.psi_1",
            "is not a value",
            "gearbox_compliance.compliance",
        ),
        ("effects.payload.mass", "unknown column", f'mean "{PAYLOAD}"'),
        (f"{PAYLOAD} [gr]", "the gram or the grain", "write [g]"),
        (f"{PAYLOAD} [Kg]", "is unknown", "write [kg]"),
        (f"{PAYLOAD} [N]", "another kind of unit", "write a unit of that kind, or none for kg"),
        (f"{TENSION} [kgs]", "is unknown", "or none for N"),
        (f"{PAYLOAD},{PAYLOAD} [g]", "is repeated, first as column 6", "remove one"),
    ],
)
def test_a_column_that_names_nothing_is_refused_with_the_nearest(
    tmp_path: Path, robot: Robot, column: str, expected: str, remedy: str
) -> None:
    cells = ",1" * (column.count(",") + 1)
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, f"{HEADER},{column}\nA,0.1,0.1,100,0.1{cells}\n", robot)
    line = str(error.value)
    assert f"{tmp_path / 'modes.csv'}: line 1, column {6 + column.count(',')}" in line
    assert expected in line
    assert remedy in line


@pytest.mark.parametrize(
    ("rows", "place", "expected"),
    [
        ("A,0.1,0.1,100,0.1,x\n", "line 2", 'expected a finite number, found "x"'),
        ("A,0.1,0.1,100,0.1,nan\n", "line 2", "expected a finite number"),
        ("A,0.1,0.1,100,0.1,1e99\n", "line 2", "expected a finite value, found 1e+99"),
        (
            "A,0.1,0.1,100,0.1,0.3\nB,0,0,90,0.1,\nA,0.1,0.1,150,0.1,0.35\n",
            "line 4",
            f'pose "A" has two values: {PAYLOAD} is 0.3 in line 2 and 0.35 here',
        ),
        ("A,0.1,0.1,100,0.1,0.3\nA,0.1,0.1,150,0.1,\n", "line 3", "is 0.3 in line 2 and blank here"),
        ("A,0.1,0.1,100,0.1,\nA,0.1,0.1,150,0.1,0\n", "line 3", "is blank in line 2 and 0 here"),
    ],
)
def test_cells_that_are_no_value_or_disagree_are_refused(
    tmp_path: Path, robot: Robot, rows: str, place: str, expected: str
) -> None:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, f"{HEADER},{PAYLOAD}\n{rows}", robot)
    assert f"{tmp_path / 'modes.csv'}: {place}, column {PAYLOAD}" in str(error.value)
    assert expected in str(error.value)


def test_values_that_disagree_are_shown_as_they_were_written(tmp_path: Path, robot: Robot) -> None:
    text = f"{HEADER},{PAYLOAD} [g]\nA,0.1,0.1,100,0.1,300\nA,0.1,0.1,150,0.1,310\n"
    with pytest.raises(MeasurementError, match=r"is 300 g \(0\.3 kg\) in line 2 and 310 g \(0\.31 kg\) here"):
        read(tmp_path, text, robot)


@pytest.mark.parametrize(
    ("column", "value", "expected"),
    [
        (PAYLOAD, "-0.1", "expected a mass greater than 0 kg, or 0 for no effect, found -0.1"),
        ("set:toolhead.mass", "0", "expected a mass greater than 0 kg"),
        ("set:toolhead.mass", "1e-40", "magnitude"),
        ("set:belt_path.1.lengths.2", "0.1", "a run that is 0.2 m too short"),
    ],
)
def test_a_value_that_a_robot_file_could_not_have_is_refused(
    tmp_path: Path, robot: Robot, column: str, value: str, expected: str
) -> None:
    text = f"{HEADER},{column}\nA,0.1,0.1,100,0.1,\nB,0.1,0.1,100,0.1,{value}\n"
    data = read(tmp_path, text, robot)
    for call in (updating.compare, updating.diagnose, updating.update):
        with pytest.raises(MeasurementError) as error:
            call(robot, data)
        assert f"{tmp_path / 'modes.csv'}: line 3, column {column}" in str(error.value)
        assert expected in str(error.value)


def test_a_value_with_which_the_pose_cannot_be_reached_is_refused(tmp_path: Path) -> None:
    robot = read_robot(ROBOTS / "linear-delta-2022.toml")
    row = "0.6,0,-0.245,55,0.1"
    data = read(tmp_path, f"{DELTA},set:link.length [mm]\nA,{row},\nB,{row},200\n", robot)
    with pytest.raises(MeasurementError) as error:
        updating.compare(robot, data)
    assert 'pose "B"' in str(error.value)
    assert "cannot be reached with the set values" in str(error.value)
    assert f"{tmp_path / 'modes.csv'}: line 3, column set:link.length" in str(error.value)
    # A pose that only the robot with the set values reaches.
    far = "0.6,0,-0.45,55,0.1"
    with pytest.raises(MeasurementError, match=r'pose "B" .* cannot be reached'):
        updating.compare(robot, read(tmp_path, f"{DELTA},set:link.length\nA,{row},\nB,{far},\n", robot))
    updating.compare(robot, read(tmp_path, f"{DELTA},set:link.length\nA,{row},\nB,{far},0.6\n", robot))


def test_a_value_is_not_set_twice_under_two_names(tmp_path: Path, robot: Robot) -> None:
    names = "set:frame.mass,set:effects.frame_compliance.mass"
    data = read(tmp_path, f"{HEADER},{names}\nA,0.1,0.1,100,0.1,40,50\n", robot)
    with pytest.raises(MeasurementError) as error:
        updating.compare(robot, data)
    assert "would be changed twice" in str(error.value)
    assert "line 2, column" in str(error.value)


def test_a_path_of_another_robot_is_refused_where_it_is_used(tmp_path: Path, robot: Robot) -> None:
    data = read(tmp_path, f"{HEADER},set:platform.mass\nA,0.1,0.1,100,0.1,1\n", None)
    with pytest.raises(MeasurementError, match=r'"set:platform\.mass" is not a value that can be set in'):
        updating.compare(robot, data)


def test_a_structure_that_knows_nothing_of_it_refuses_what_is_set() -> None:
    data = Measurements.from_rows(["A"], [1.0], [0.1], settings={"load": [2.0]})
    structure = MatrixStructure(
        [Parameter("k", 40.0)], [], lambda values, setup: (np.eye(1), values["k"] * np.eye(1)), channels=["q"]
    )
    with pytest.raises(PkmodesError, match='the measurements set "load", which the structure does not have'):
        compare(structure, data)
    with pytest.raises(MeasurementError, match="expected values by name"):
        Measurements.from_rows(["A"], [1.0], [0.1], settings=[2.0])  # type: ignore[arg-type]
    with pytest.raises(MeasurementError, match=r"expected an array of shape \(1,\)"):
        Measurements.from_rows(["A"], [1.0], [0.1], settings={"load": [2.0, 3.0]})


def test_the_commands_show_what_is_set(
    tmp_path: Path, robot: Robot, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (
        f"{HEADER},{PAYLOAD}\nA,0.1,0.1,120,1,\nA,0.1,0.1,150,1,\nB,0.1,0.1,100,1,0.2\nB,0.1,0.1,120,1,0.2\n"
    )
    read(tmp_path, text, robot)
    files = [str(ROBOTS / "corexy-printer.toml"), str(tmp_path / "modes.csv"), "--drives", "free"]
    assert run(["compare", *files, "--json", "-"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row.get("set") for row in rows] == [None, None, *[{PAYLOAD[4:]: 0.2}] * 2]
    assert run(["compare", *files]) == 0
    out = capsys.readouterr().out
    with_it = [line for line in out.splitlines() if line.endswith("  effects.payload.mass = 0.2 kg")]
    assert [line.split()[0] for line in with_it] == ["B", "B"]
    assert "set by the measurements: effects.payload.mass = 0.2 kg (pose B)\n" in out
    assert run(["diagnose", *files, "--candidates", "belt_mass", "--json", "-"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row.get("set") for row in rows] == [None, None, *[{PAYLOAD[4:]: 0.2}] * 2]
    assert run(["diagnose", *files, "--candidates", "belt_mass"]) == 0
    assert "set by the measurements: effects.payload.mass = 0.2 kg (pose B)" in capsys.readouterr().out
    read(tmp_path, text + "C,0.12,0.1,100,1,0.2\n", robot)
    assert run(["diagnose", *files, "--candidates", "belt_mass", "--holdout", "none"]) == 0
    assert "effects.payload.mass = 0.2 kg (poses B, C)" in capsys.readouterr().out
    read(tmp_path, text, robot)
    # As predicted by the robot with that payload.
    alone = Model(robot.with_values({PAYLOAD[4:]: 0.2})).frequencies([0.1, 0.1], drives="free")[2:]
    found = updating.compare(robot, updating.read(tmp_path / "modes.csv", robot=robot, drives="free"))
    assert [row.predicted for row in found.rows[2:]] == pytest.approx(alone.tolist(), rel=1e-12)
    other = read(tmp_path, text.replace(f",{PAYLOAD}", "").replace(",\n", "\n").replace(",0.2", ""), robot)
    assert all(not row.load for row in updating.compare(robot, other).rows)
