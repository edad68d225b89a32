"""The table ``[usable]`` of a robot file: what it may say, what is refused, and what it does not touch."""

from __future__ import annotations

import math
import pickle
import tomllib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pkmodes
from helpers.robots.corrected_files import changed_lines, correct
from helpers.robots.robot_text import published
from pkmodes.codegen.generation import specification
from pkmodes.core.base.errors import PkmodesError, RobotFileError
from pkmodes.core.robot.reading import read_robot, robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import Radius, limits_in_words
from pkmodes.core.robot.usable_poses import bounding_box
from pkmodes.loop.robot_files.differences import differences
from pkmodes.loop.robot_files.saving import Correction
from pkmodes.loop.sensitivity.paths import paths
from pkmodes.loop.updating.load_cases import settable_paths
from pkmodes.machine.dataset.robot_text import robot_file_text

ROBOTS = Path(__file__).parents[3] / "robots"
USED = '\n[usable]\nz = ["-300 mm", "-200 mm"]  # the table is there\nx = [0.1, "110 cm"]\n'


def read(folder: Path, table: str, robot: str = "linear-delta-2022") -> Robot:
    path = folder / "robot.toml"
    path.write_text((ROBOTS / f"{robot}.toml").read_text(encoding="utf-8") + table, encoding="utf-8")
    return read_robot(path)


def test_limits_are_in_si_units_and_in_the_order_of_the_pose(tmp_path: Path) -> None:
    assert list(read(tmp_path, USED).usable.items()) == [("x", (0.1, 1.1)), ("z", (-0.3, -0.2))]
    assert read(tmp_path, "").usable == {}
    assert read(tmp_path, "\n[usable]\n").usable == {}
    assert read(tmp_path, '\n[usable]\ny = ["0 mm", "20 cm"]\n', "corexy-printer").usable == {"y": (0.0, 0.2)}


REFUSED = [
    (
        "w = [0, 1]",
        "usable.w",
        [
            'expected a component of the pose, radius or singular_angle, found "w"',
            "known: x, y, z, radius, singular_angle",
        ],
    ),
    ("Z = [0, 1]", "usable.Z", ['did you mean "z"?']),
    ('z = ["1 kg", 2]', "usable.z.min", ['expected a length such as "400 mm", found "1 kg"']),
    ('z = [0, "2"]', "usable.z.max", ['found "2", which has no unit']),
    ("z = [0, true]", "usable.z.max", ["found true"]),
    ("z = [0, inf]", "usable.z.max", ["expected a finite length"]),
    ('z = ["-200 mm", "-300 mm"]', "usable.z", ["found -0.2 m before -0.3 m", "exchange them"]),
    ("z = [1, 1]", "usable.z", ["found 1 m twice", "write two limits"]),
    ("z = -0.3", "usable.z", ["expected the lower and the upper limit, found -0.3", "write two limits"]),
    ("z = [-0.3]", "usable.z", ["expected the lower and the upper limit, found a list of 1"]),
    ("z = { min = 1 }", "usable.z", ["expected the lower and the upper limit, found a table"]),
    (
        'z = [{ value = 0, sigma = "1 mm" }, 1]',
        "usable.z.min",
        ["found a table: a limit has no standard deviation"],
    ),
    ("radius = 0", "usable.radius", ["expected a length greater than 0 m, found 0"]),
    ('radius = "12 deg"', "usable.radius", ['expected a length such as "400 mm", found "12 deg"']),
    ("radius = [0, 1]", "usable.radius", ["found a list"]),
    (
        'radius = { about = ["0 mm", "0 mm"] }',
        "usable.radius",
        ['found "about" (', 'write radius = "120 mm"'],
    ),
    (
        'radius = { value = 0.1, sigma = "1 mm" }',
        "usable.radius",
        ['found "value", "sigma": a limit has no standard deviation'],
    ),
    ("radius = { value = 0.1, about = [0] }", "usable.radius.about", ["found a list of 1"]),
    ('radius = { value = 0.1, about = [0, "1 s"] }', "usable.radius.about.y", ['found "1 s"']),
    ("singular_angle = 0", "usable.singular_angle", ["expected an angle greater than 0 rad, found 0"]),
    ("singular_angle = 15", "usable.singular_angle", ["below 90 deg, found 15, which is 859.4 deg"]),
    (
        'singular_angle = { value = "15 deg", sigma = "1 deg" }',
        "usable.singular_angle",
        ["found a table: a limit has no standard deviation", 'write singular_angle = "15 deg"'],
    ),
    ('"z\\u001b[2J" = [0, 1]', 'usable."z\\x1b[2J"', ["expected a component of the pose"]),
]


def test_what_is_refused(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for table, place, parts in REFUSED:
        with subtests.test(table=table):
            with pytest.raises(RobotFileError) as error:
                read(tmp_path, f"\n[usable]\n{table}\n")
            (line,) = error.value.lines
            assert f"({tmp_path / 'robot.toml'}: {place}); " in line
            for part in parts:
                assert part in line


def test_all_problems_are_told_together_and_the_table_must_be_one(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError) as error:
        read(tmp_path, "\n[usable]\nz = 1\nx = [1, 0]\nq = [0, 1]\n")
    assert len(error.value.lines) == 3
    with pytest.raises(RobotFileError, match=r"expected a table, found a list \(.*: usable\); write z = "):
        read(tmp_path, "\n[[usable]]\nz = [0, 1]\n")
    with pytest.raises(RobotFileError, match=r"known: x, y, radius$"):
        read(tmp_path, "\n[usable]\nz = [0, 1]\n", "corexy-printer")


ROUND = '\n[usable]\nradius = "120 mm"\nsingular_angle = "15 deg"\n'
ASIDE = '\n[usable]\nradius = { value = "120 mm", about = ["600 mm", 0] }\nx = [0, 1]\n'


def test_a_radius_and_an_angle_are_read_in_si_units_and_told_in_words(tmp_path: Path) -> None:
    robot = read(tmp_path, ROUND)
    assert list(robot.usable) == ["radius", "singular_angle"]
    assert robot.usable["radius"] == Radius(0.12, (0.0, 0.0))
    assert robot.usable["singular_angle"] == pytest.approx((math.radians(15.0),), rel=1e-15)
    assert limits_in_words(robot.mechanism, robot.usable) == (
        "at most 0.12 m from x = 0 m, y = 0 m, every rod at least 15 deg from its singular direction"
    )
    aside = read(tmp_path, ASIDE)
    assert aside.usable == {"x": (0.0, 1.0), "radius": Radius(0.12, (0.6, 0.0))}
    low, high = bounding_box(aside.mechanism, aside.usable)
    assert (low.tolist(), high.tolist()) == ([0.48, -0.12, -math.inf], [0.72, 0.12, math.inf])
    assert read(tmp_path, '\n[usable]\nradius = "9 cm"\n', "corexy-printer").usable == {
        "radius": Radius(0.09, (0.0, 0.0))
    }


def test_a_mechanism_without_rods_has_no_singular_angle(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError) as error:
        read(tmp_path, '\n[usable]\nsingular_angle = "15 deg"\n', "corexy-printer")
    (line,) = error.value.lines
    assert "corexy has no singular angle: it has no rods" in line
    assert line.endswith("leave singular_angle out")


@pytest.mark.parametrize("table", [ROUND, ASIDE])
def test_every_form_stays_with_the_robot(tmp_path: Path, table: str) -> None:
    robot = read(tmp_path, table)
    assert pickle.loads(pickle.dumps(robot)) == robot
    heavier = robot.with_values({"platform.mass": "2 kg"})
    other = tmp_path / "other.toml"
    for one in (heavier, robot):
        other.write_text(robot_file_text(one), encoding="utf-8")
        assert read_robot(other) == one
        assert read_robot(other).usable == robot.usable
    assert correct(tmp_path, published() + table, platform__mass=Correction(1.4, 0.01, "new")).endswith(table)


def test_two_robots_differ_in_every_form(tmp_path: Path) -> None:
    plain, robot = read(tmp_path, ""), read(tmp_path, ROUND)
    values = {one.path: (one.unit, one.first, one.second) for one in differences(plain, robot).values}
    fifteen = pytest.approx(math.radians(15.0), rel=1e-15)
    assert values == {"usable.radius": ("m", None, 0.12), "usable.singular_angle": ("rad", None, fifteen)}
    aside = {one.path: (one.first, one.second) for one in differences(robot, read(tmp_path, ASIDE)).values}
    assert aside["usable.radius.about.x"] == (None, 0.6)
    assert "usable.radius" not in aside
    assert aside["usable.singular_angle"] == (fifteen, None)


def test_limits_belong_to_the_robot_and_stay_with_it(tmp_path: Path) -> None:
    robot, plain = read(tmp_path, USED), read_robot(ROBOTS / "linear-delta-2022.toml")
    assert robot != plain
    again = pickle.loads(pickle.dumps(robot))
    assert (again, hash(again), again.usable) == (robot, hash(robot), robot.usable)
    heavier = robot.with_values({"platform.mass": "2 kg"})
    assert heavier.usable == robot.usable
    other = tmp_path / "other.toml"
    for one in (heavier, robot):
        other.write_text(robot_file_text(one), encoding="utf-8")
        assert read_robot(other) == one


def test_limits_are_no_parameters(tmp_path: Path) -> None:
    robot, plain = read(tmp_path, USED), read_robot(ROBOTS / "linear-delta-2022.toml")
    assert paths(robot) == paths(plain)
    assert settable_paths(robot.mechanism, robot) == settable_paths(plain.mechanism, plain)
    assert (robot.quantities, robot.declared) == (plain.quantities, plain.declared)
    for path in ("usable.z", "usable.z.min"):
        with pytest.raises(PkmodesError, match=f'unknown parameter path "{path}"'):
            robot.with_values({path: 0.0})


def test_measurements_cannot_set_a_limit(tmp_path: Path) -> None:
    modes = tmp_path / "modes.csv"
    modes.write_text("pose,x,y,z,frequency,sigma,set:usable.z.min\nA,0.6,0,-0.245,55,0.1,-0.3\n")
    robot = read(tmp_path, USED)
    with pytest.raises(PkmodesError, match=r'"set:usable\.z\.min" is not a value that can be set'):
        pkmodes.loop.updating.compare(robot, pkmodes.loop.updating.read(modes))


def test_generated_code_does_not_depend_on_limits(tmp_path: Path) -> None:
    """Name, version, digest and every line of the code follow from this specification alone."""
    used = specification(read(tmp_path, USED), "robot.toml")
    assert used == specification(read(tmp_path, ""), "robot.toml")


def test_a_corrected_file_keeps_the_table(tmp_path: Path) -> None:
    text = published() + USED
    after = correct(tmp_path, text, platform__mass=Correction(1.4, 0.01, "new"))
    assert after.endswith(USED)
    assert len(changed_lines(text, after)[1]) == 1
    after = correct(tmp_path, text, effects__payload__mass=Correction(0.3, 0.01, "found"))
    assert after.startswith(text)
    path = tmp_path / "corrected.toml"
    path.write_text(after, encoding="utf-8")
    assert read_robot(path).usable == {"x": (0.1, 1.1), "z": (-0.3, -0.2)}


ENDS = st.floats(-1e3, 1e3).filter(lambda value: value == 0.0 or abs(value) > 1e-29)


@settings(max_examples=25, deadline=None)
@given(limits=st.dictionaries(st.sampled_from("xyz"), st.tuples(ENDS, ENDS)))
def test_any_limits_are_read_as_written_or_refused(limits: dict[str, tuple[float, float]]) -> None:
    document = {**tomllib.loads(published()), "usable": {name: list(ends) for name, ends in limits.items()}}
    if all(low < high for low, high in limits.values()):
        robot = robot_from_document(document, "robot.toml")
        assert robot.usable == limits
        assert robot_from_document(tomllib.loads(robot_file_text(robot)), "again.toml") == robot
    else:
        wrong = {f"robot.toml: usable.{name}" for name, (low, high) in limits.items() if low >= high}
        with pytest.raises(RobotFileError) as error:
            robot_from_document(document, "robot.toml")
        assert {line.partition("(")[2].partition(")")[0] for line in error.value.lines} == wrong
