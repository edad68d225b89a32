"""Robot files: their meaning, and errors with file, path, expected and found."""

from __future__ import annotations

import os
import pickle
import shutil
import tomllib
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes.core.base.errors import RobotFileError
from pkmodes.core.robot.reading import read_robot, robot_from_document


def read(tmp_path: Path, text: str) -> object:
    path = tmp_path / "robot.toml"
    path.write_text(text, encoding="utf-8")
    return read_robot(path)


def problems(tmp_path: Path, text: str) -> list[str]:
    with pytest.raises(RobotFileError) as error:
        read(tmp_path, text)
    lines = list(error.value.lines)
    assert str(tmp_path / "robot.toml") in lines[0]
    assert all(len(line) < 600 and "\n" not in line for line in lines)
    return lines


def test_the_published_robot_has_the_values_of_the_paper() -> None:
    robot = read_robot(PUBLISHED)
    p = robot.parameters
    assert robot.name == "linear-delta-2022"
    assert p.platform_mass == 1.5
    assert p.link_length.tolist() == [0.4] * 3
    assert p.link_mass.tolist() == [0.7] * 3
    assert p.carriage_mass.tolist() == [1.0] * 3
    assert p.belt_specific_stiffness.tolist() == [2.42e6] * 3
    assert p.belt_width.tolist() == [0.015] * 3
    assert p.pulley_radius.tolist() == [0.035] * 3
    assert p.pulley_inertia.tolist() == [0.00013] * 3
    assert p.motor_inertia.tolist() == [1.7e-05] * 3
    assert p.gear_ratio.tolist() == [10.0] * 3
    assert p.origin[:, 1].tolist() == [0.0, -0.2, 0.2]
    # Equation 43: the torques are at theta_1_1, theta_2_2 and theta_3_2.
    assert p.drive.tolist() == [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]]
    assert (p.limits[:, 1] - p.limits[:, 0]).tolist() == [1.2] * 3


def test_an_axis_overrides_what_it_shares(tmp_path: Path) -> None:
    text = published() + '\n[axis.belt]\nwidth = "25 mm"\n[axis.link]\nmass = "0.5 kg"\n'
    robot = read(tmp_path, text)
    assert robot.parameters.belt_width.tolist() == [0.015, 0.015, 0.025]
    assert robot.parameters.link_mass.tolist() == [0.7, 0.7, 0.5]
    assert robot.parameters.link_length.tolist() == [0.4] * 3
    assert robot.quantities["axis.3.belt.width"].value == 0.025
    assert "axis.1.belt.width" not in robot.quantities


def test_a_shared_table_may_be_missing_when_every_axis_has_its_own(tmp_path: Path) -> None:
    text = edited('[motor]\ninertia = "0.017e-3 kg*m^2"', "[motor]")
    assert "motor.inertia" in problems(tmp_path, text)[0]
    own = text.replace("branch = 1\n", 'branch = 1\n[axis.motor]\ninertia = "2e-5 kg*m^2"\n')
    own = own.replace("branch = -1\n", 'branch = -1\n[axis.motor]\ninertia = "3e-5 kg*m^2"\n')
    assert read(tmp_path, own).parameters.motor_inertia.tolist() == [2e-5, 3e-5, 3e-5]


def test_sigma_is_absolute_or_relative_or_zero_or_absent(tmp_path: Path) -> None:
    for sigma, expected in (('"0.03 kg"', 0.03), ('"2 %"', 0.03), ("0.03", 0.03), ("0", 0.0)):
        robot = read(tmp_path, edited('mass = "1.5 kg"', f'mass = {{ value = "1.5 kg", sigma = {sigma} }}'))
        assert robot.quantities["platform.mass"].sigma == pytest.approx(expected, abs=0)
    assert read(tmp_path, published()).quantities["platform.mass"].sigma is None
    robot = read(tmp_path, edited('limits = ["0 m",', 'limits = [{ value = "0 m", sigma = "1 mm" },'))
    assert robot.quantities["axis.1.limits.min"].sigma == 0.001


def test_bare_numbers_are_si(tmp_path: Path) -> None:
    assert read(tmp_path, edited('"400 mm"', "0.4")).parameters.link_length.tolist() == [0.4] * 3


@pytest.mark.parametrize(
    ("old", "new"), [('"400 mm"', "4000"), ('"1.2 m"', '"1.2 km"'), ('"35 mm"', "11900.0")]
)
def test_a_length_that_no_robot_has_is_one_in_another_unit(tmp_path: Path, old: str, new: str) -> None:
    found = problems(tmp_path, edited(old, new))
    assert any(f"expected a length of at most 1000 m, found {new}" in line for line in found)
    assert any("a number without a unit is in metres" in line for line in found)


def test_directions_are_normalised(tmp_path: Path) -> None:
    robot = read(tmp_path, edited("direction = [1, 0, 0]", "direction = [0.7071, 0, 0.7071]"))
    np.testing.assert_allclose(robot.parameters.direction[0], [0.5**0.5, 0, 0.5**0.5], rtol=1e-15)


def test_parameters_cannot_be_changed_by_accident() -> None:
    robot = read_robot(PUBLISHED)
    with pytest.raises(ValueError, match="read-only"):
        robot.parameters.link_length[0] = 1.0


MISTAKES = [
    (
        'length = "400 mm"',
        'length = "400 kg"',
        "link.length",
        "expected a length",
        '"400 kg", which is a mass',
    ),
    ('length = "400 mm"', 'length = "400"', "link.length", "expected a length", "no unit"),
    ('length = "400 mm"', 'length = "-4 mm"', "link.length", "greater than 0 m", '"-4 mm"'),
    ('length = "400 mm"', 'length = "0 mm"', "link.length", "greater than 0 m", '"0 mm"'),
    ('length = "400 mm"', "length = nan", "link.length", "finite length", "nan"),
    ('length = "400 mm"', "length = inf", "link.length", "finite length", "inf"),
    ('length = "400 mm"', "length = true", "link.length", "expected a length", "true"),
    ('length = "400 mm"', 'length = ["400 mm"]', "link.length", "expected a length", "a list"),
    (
        'length = "400 mm"',
        "length = {value = 1, sgima = 2}",
        "link.length",
        '"value"',
        '"value", "sgima"',
    ),
    ('length = "400 mm"', "length = {value = 1, sigma = -2}", "link.length", "sigma", "-2"),
    (
        'length = "400 mm"',
        'length = {value = 1, sigma = "2 kg"}',
        "link.length",
        "sigma",
        "which is a mass",
    ),
    ('mass = "1.5 kg"', 'mass = "-1.5 kg"', "platform.mass", "greater than 0 kg", '"-1.5 kg"'),
    ('mass = "0.7 kg"', 'mass = "-0.7 kg"', "link.mass", "at least 0 kg", '"-0.7 kg"'),
    (
        "direction = [1, 0, 0]",
        "direction = [0, 0, 0]",
        "axis.1.direction",
        "unit vector",
        "zero direction",
    ),
    ("direction = [1, 0, 0]", "direction = [2, 0, 0]", "axis.1.direction", "unit vector", "length 2"),
    ("direction = [1, 0, 0]", "direction = [1, 0]", "axis.1.direction", "list of 3", "2 elements"),
    ("direction = [1, 0, 0]", "direction = [nan, 0, 0]", "axis.1.direction.x", "finite", "nan"),
    ('"0 m", "1.2 m"', '"1.2 m", "0 m"', "axis.1.limits", "lower limit first", "1.2 m before 0 m"),
    ('"0 m", "1.2 m"', '"1 m", "1 m"', "axis.1.limits", "lower limit first", "1 m before 1 m"),
    ("driven_pulley = 1", "driven_pulley = 3", "axis.1.driven_pulley", "1 or 2", "3"),
    ("branch = 1\n", "branch = 0\n", "axis.1.branch", "1 or -1", "0"),
    ("format = 1", "format = 2", "format", "1", "2"),
    ('mechanism = "linear_delta"', 'mechanism = "tripod"', "mechanism", "linear_delta", '"tripod"'),
    ('mass = "1.5 kg"', 'mass = "300 gr"', "platform.mass", "the gram or the grain", 'write "300 g"'),
    ('mass = "1.5 kg"', 'mass = "1,5 kg"', "platform.mass", "decimal comma", 'write "1.5 kg"'),
    ('mass = "1.5 kg"', 'mass = { value = 1, sigma = "5 gr" }', "platform.mass", "sigma", 'write "5 g"'),
    ('mass = "1.5 kg"', 'mass = { value = 1, sigma = "2,5 %" }', "platform.mass", "sigma", 'write "2.5 %"'),
    ('name = "linear-delta-2022"', "name = 7", "name", "plain text", "found 7"),
    ("gear_ratio = 10", "gear_ratio = 0", "motor.gear_ratio", "greater than 0", "0"),
    (
        "[platform]\n",
        "[platform]\nmas = 1\n",
        "platform.mas",
        'unknown key "mas"',
        'did you mean "mass"?',
    ),
    ("[belt]\n", "[belts]\n", "belts", 'unknown key "belts"', 'did you mean "belt"?'),
    ("branch = 1\n", "branch = 1\nlimit = 3\n", "axis.1.limit", 'unknown key "limit"', 'mean "limits"?'),
    ("branch = 1\n", "branch = 1\n[axis.bolt]\nwidth = 1\n", "axis.1.bolt", 'key "bolt"', 'mean "belt"?'),
    ("branch = 1\n", "", "axis.1.branch", "axis.1.branch is missing", "add it"),
    ('mass = "1.5 kg"', "", "platform.mass", "platform.mass is missing", "add it"),
    ('length = "0 mm"', 'length = "1.2 m"', "axis.1.limits", "shorter than the travel", "1.2 m"),
    ("format = 1", "format = true", "format", "1", "true"),
    ("format = 1", "format = 1.0", "format", "1", "1.0"),
    ("branch = 1\n", "branch = 1.0\n", "axis.1.branch", "1 or -1", "1.0"),
    ('"linear-delta-2022"', '"   "', "name", "plain text", '"   "'),
    ('"linear-delta-2022"', '"a*/ int x; /*"', "name", "plain text", "int x"),
    ('"linear-delta-2022"', '\'"""; import os\'', "name", "plain text", "import os"),
    ('"linear-delta-2022"', '"a\\nimport os"', "name", "plain text", "a\\nimport os"),
    ('length = "400 mm"', f"length = {10**400}", "link.length", "finite length", "1000"),
    (
        'length = "400 mm"',
        f"length = 0x{'f' * 5000}",
        "link.length",
        "finite length",
        "very large number",
    ),
    ('length = "400 mm"', 'length = """400\n\nkg"""', "link.length", "expected a length", "400\\n\\nkg"),
    ('"0 m", "1.2 m"', '{value = 0, sigma = "1 %"}, 1.2', "axis.1.limits.min", "sigma", "is undefined"),
    (
        "direction = [1, 0, 0]",
        "direction = [{value = 1, sigma = 0.1}, 0, 0]",
        "axis.1.direction",
        "no standard",
        "a table",
    ),
    (
        "gear_ratio = 10",
        'gear_ratio = "10 deg"',
        "motor.gear_ratio",
        "expected a number",
        "does not belong",
    ),
    ("gear_ratio = 10", "gear_ratio = 1e200", "motor.gear_ratio", "magnitude between", "1e+200"),
    ('width = "15 mm"', "", "belt.width", "expected a length", "found nothing"),
]


def test_mistakes_name_path_expected_and_found(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for old, new, path, expected, found in MISTAKES:
        with subtests.test(f"{old} -> {new}"):
            line = problems(tmp_path, edited(old, new))[0]
            assert f"robot.toml: {path})" in line, line
            assert expected in line, line
            assert found in line, line
            assert "; " in line, "what to do is missing"


def test_every_problem_is_reported_at_once(tmp_path: Path) -> None:
    text = edited('length = "400 mm"', 'length = "400 kg"').replace('mass = "1.5 kg"', 'mass = "-1 kg"')
    assert len(problems(tmp_path, text.replace("branch = 1\n", "branch = 5\n"))) == 3


@pytest.mark.parametrize("count", [0, 1, 2, 4])
def test_three_axes_are_needed(tmp_path: Path, count: int) -> None:
    head, *axes = published().split("[[axis]]")
    text = "[[axis]]".join([head, *(axes * 2)[:count]])
    line = problems(tmp_path, text)[0]
    assert "axis" in line
    assert "missing" in line if count == 0 else f"found {count}" in line


def test_a_wrong_type_of_table_is_refused(tmp_path: Path) -> None:
    text = edited('[platform]\nmass = "1.5 kg"', "[frame]").replace(
        "format = 1", 'format = 1\nplatform = "heavy"'
    )
    assert 'expected a table, found "heavy"' in problems(tmp_path, text)[0]


def test_malformed_files_are_refused(tmp_path: Path) -> None:
    assert "not valid TOML" in problems(tmp_path, "format = = 1")[0]
    assert "line 1" in problems(tmp_path, "format = = 1")[0]
    assert problems(tmp_path, "")[0].count("missing") == 1
    (tmp_path / "robot.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(RobotFileError, match="UTF-8"):
        read_robot(tmp_path / "robot.toml")
    with pytest.raises(RobotFileError, match="no such file"):
        read_robot(tmp_path / "absent.toml")
    with pytest.raises(RobotFileError, match="it is a folder"):
        read_robot(tmp_path)
    os.mkfifo(tmp_path / "fifo")
    with pytest.raises(RobotFileError, match="not a regular file"):
        read_robot(tmp_path / "fifo")
    with pytest.raises(RobotFileError, match="null"):
        read_robot("a\0b")
    assert "not valid TOML" in problems(tmp_path, f"format = {'9' * 5000}")[0]
    (tmp_path / "robot.toml").write_text(published(), encoding="utf-8-sig")
    assert read_robot(tmp_path / "robot.toml").name == "linear-delta-2022"
    shutil.rmtree(tmp_path)


def test_errors_survive_pickling(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text("format = 2", encoding="utf-8")
    with pytest.raises(RobotFileError) as error:
        read_robot(tmp_path / "robot.toml")
    assert pickle.loads(pickle.dumps(error.value)).lines == error.value.lines


values = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=20),
    st.lists(st.floats(), max_size=4),
)


@settings(max_examples=200)
@given(
    st.sampled_from(["platform", "link", "axis", "gravity", "name", "format", "motor", "effects", "zzz"]),
    st.one_of(values, st.dictionaries(st.text(max_size=8), values, max_size=3), st.lists(values, max_size=3)),
)
def test_any_value_is_read_or_refused_clearly(key: str, value: object) -> None:
    document = tomllib.loads(published())
    document[key] = value
    try:
        robot_from_document(document, "robot.toml")
    except RobotFileError as error:
        assert all("robot.toml" in line for line in error.lines)


@pytest.mark.parametrize(
    "line",
    [
        "{key} = 1",
        "[{key}]",
        "[[{key}]]",
        "frame = {{ mass = 1, {key} = 1 }}",
        'x = {{ y = """\n"" """, {key} = 1 }}',
    ],
)
@pytest.mark.parametrize("part", ["a", '"a.b"', "'a' "])
def test_a_key_of_very_many_parts_is_refused_before_it_is_read(tmp_path: Path, line: str, part: str) -> None:
    """TOML's reader keeps every beginning of a key: 4,000 parts take 100 MB, 50,000 take gigabytes."""
    text = line.format(key=".".join([part] * 4000)) + "\n" + published()
    tracemalloc.start()
    (found,) = problems(tmp_path, text)
    largest = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert ": line " in found
    assert "expected a key of a few parts, found a line with " in found
    assert largest < 5e6


def test_points_that_are_no_keys_do_not_matter(tmp_path: Path) -> None:
    numbers = ", ".join(["0.5"] * 99)
    read(tmp_path, f"# {'.' * 5000}\n# 1. first {numbers}\n" + published())
