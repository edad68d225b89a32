"""Poses of measurements: units of length that were mistaken, poses out of reach, and a part of the poses."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.measurement_files import HEADER, ROW, read
from helpers.robots.robot_text import PUBLISHED
from pkmodes import updating
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating import measured_robot
from pkmodes.loop.updating.measured_robot import MeasuredRobot


def test_positions_in_millimetres_are_recognised(tmp_path: Path) -> None:
    model = pkmodes.load(PUBLISHED)
    for header, place, remedy in (
        (HEADER, "600,0,-245", "look like millimetres: write x [mm],y [mm],z [mm] in the header"),
        (HEADER.replace("x,y,z", "x [mm],y [mm],z [mm]"), "0.6,0,-0.245", "look like metres"),
    ):
        with pytest.raises(MeasurementError) as error:
            MeasuredRobot.of(model, read(tmp_path, f"{header}\nA,{place},55.5,0.1\nA,{place},60,0.1\n"))
        assert remedy in error.value.remedy
    mixed = read(tmp_path, f"{HEADER}\nA,600,0,-245,55.5,0.1\nB,0.6,0,-0.245,60,0.1\n")
    with pytest.raises(MeasurementError, match="out of reach"):
        MeasuredRobot.of(model, mixed)


@pytest.mark.parametrize(("x", "recognised"), [(250.0, True), (0.31, False)])
def test_small_numbers_are_not_taken_for_millimetres(tmp_path: Path, x: float, recognised: bool) -> None:
    """The workspace of a CoreXY has the origin in it: a thousandth of any pose can be reached."""
    model = pkmodes.load(PUBLISHED.parent / "corexy-printer.toml")
    text = f"pose,x,y,frequency,sigma\nA,{x},{min(x, 0.2)},111,1\n"
    (tmp_path / "modes.csv").write_text(text)
    data = updating.read(tmp_path / "modes.csv", robot=model)
    with pytest.raises(MeasurementError) as error:
        MeasuredRobot.of(model, data)
    assert ("millimetres" in error.value.remedy) == recognised


def test_a_pose_that_the_robot_cannot_take_is_refused(tmp_path: Path) -> None:
    model = pkmodes.load(PUBLISHED)
    MeasuredRobot.of(model, read(tmp_path, f"{HEADER}\n{ROW}\n"))
    for place, reason in (("0.6,0,-0.5", "out of reach: link"), ("0.1,0,-0.245", "beyond its limits")):
        found = read(tmp_path, f"{HEADER}\n{ROW}\n# far\nC 3,{place},50,0.1\nC 3,{place},60,0.1\n")
        with pytest.raises(MeasurementError) as error:
            MeasuredRobot.of(model, found)
        line = str(error.value)
        assert f"{tmp_path / 'modes.csv'}: line 4, columns x, y and z)" in line
        assert f'"C 3" at [{place.replace(",", ", ")}] m' in line
        assert reason in line
        assert str(PUBLISHED) in error.value.remedy
    found = read(tmp_path, f"{HEADER}\nC,9,9,9,1,0.1\n{ROW}\nD,0.6,0,9,2,0.1\n")
    with pytest.raises(MeasurementError, match="line 2, columns x, y and z, the first of 2 bad poses"):
        MeasuredRobot.of(model, found)
    MeasuredRobot.of(model, found.at([1]))
    with pytest.raises(PkmodesError, match="expected measurements, found no rows"):
        MeasuredRobot.of(model, found.at([]))


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


def test_a_robot_and_its_measurements_are_checked_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot, data = pkmodes.read_robot(PUBLISHED), read(tmp_path, f"{HEADER}\n{ROW}\n")
    visits: list[str] = []
    for name in ("load_cases_of", "check_reachable", "check_measurements"):
        check = getattr(measured_robot, name)

        def counted(*given: object, check=check, name=name) -> object:
            visits.append(name)
            return check(*given)

        monkeypatch.setattr(measured_robot, name, counted)
    updating.compare(robot, data)
    assert visits == ["check_measurements", "load_cases_of", "check_reachable"]
    measured = MeasuredRobot.of(robot, data)
    assert (measured.robot, measured.data) == (robot, data)
    structures = [measured.structure(), measured.structure(candidates=())]
    assert visits == 2 * ["check_measurements", "load_cases_of", "check_reachable"]
    assert all(one.points is not None and len(one.points) == len(data.points) for one in structures)


def test_the_first_of_several_mistakes_is_told_before_poses_are_checked(tmp_path: Path) -> None:
    """In this order: robot, measurements, components, coordinates, set values, poses, candidates, priors."""
    robot = pkmodes.read_robot(PUBLISHED)
    far = {"points": [[9.0, 9.0, 9.0]], "settings": {"platform.mass": [-1.0]}}
    given: dict[str, object] = {"frequency": [1.0], "sigma": [0.1]}
    messages = []
    for changes in (
        {**far, "components": {"x": "m", "z": "m", "y": "m"}, "shapes": {"no": [1.0]}},
        {**far, "shapes": {"no": [1.0]}},
        far,
        {"points": far["points"]},
        {"points": [[0.6, 0.0, -0.245]]},
    ):
        data = Measurements.from_rows(["A"], **given, **changes)
        with pytest.raises(PkmodesError) as error:
            updating.diagnose(robot, data, candidates=["no such"], priors={"none": 1.0})
        messages.append(error.value.what)
    expected = ["expected poses with x, y and z", '"no" is not a coordinate', "mass", "pose ", "unknown cand"]
    assert all(part in what for part, what in zip(expected, messages, strict=True)), messages
    for wrong in ((PUBLISHED, None), (robot, None)):
        with pytest.raises(
            PkmodesError, match="expected a robot" if wrong[0] is PUBLISHED else "expected meas"
        ):
            updating.compare(*wrong)


@pytest.mark.parametrize(
    ("columns", "robot", "first", "whose"),
    [
        ("shape:x_1,shape:theta_1_1", "clavel-delta", "shape:x_1", "hexaglide or linear_delta"),
        ("shape:theta_1,shape:phi_1", "linear-delta-2022", "shape:theta_1", "rotary_delta"),
    ],
)
def test_the_columns_of_another_mechanism_are_told_as_such(
    tmp_path: Path, columns: str, robot: str, first: str, whose: str
) -> None:
    path = tmp_path / "modes.csv"
    path.write_text(f"pose,x,y,z,frequency,sigma,{columns}\nP1,0.6,0,-0.245,50,0.1,1,2\n")
    machine = pkmodes.read_robot(PUBLISHED.parent / f"{robot}.toml")
    for asked in (
        lambda: updating.read(path, robot=machine),
        lambda: updating.compare(machine, updating.read(path)),
    ):
        with pytest.raises(MeasurementError) as error:
            asked()
        said = f'"{first}" is a column of another machine: the columns of the file are those of {whose} ('
        assert said in str(error.value)
        assert "give the robot file of that machine" in error.value.remedy
        assert "did you mean" not in str(error.value)


def test_a_wrong_name_among_those_of_another_mechanism_is_still_a_wrong_name(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("pose,x,y,z,frequency,sigma,shape:x1,shape:phi_1\nP1,0.6,0,-0.245,50,0.1,1,2\n")
    machine = pkmodes.read_robot(PUBLISHED)
    with pytest.raises(
        MeasurementError,
        match=r'unknown columns "shape:x1", "shape:phi_1" .* "shape:x1" -> "shape:x_1"',
    ):
        updating.read(path, robot=machine)
