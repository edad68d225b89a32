"""Robot files of mechanisms unknown to the package, which only needs their description."""

from __future__ import annotations

import ast
import copy
import math
import pickle
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.made_up_mechanisms import ARMS_FILE, GANTRY_FILE, write_package
from helpers.robots.robot_text import edited
from pkmodes.core.base.errors import PkmodesError, RobotFileError
from pkmodes.core.mechanism import registry as mechanisms
from pkmodes.core.robot.layout import items
from pkmodes.core.robot.reading import read_robot, robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.variants import document_of
from pkmodes.loop.robot_files.saving import Correction, corrected_text
from pkmodes.loop.sensitivity.paths import change_quantities, paths, resolve
from pkmodes.loop.updating.candidates import suspects


@pytest.fixture(autouse=True, scope="module")
def made_up(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    folder = tmp_path_factory.mktemp("packages")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mechanisms, "_package_by_name", {})
        patch.syspath_prepend(folder)
        for package in write_package(folder):
            mechanisms.add(package)
        yield


def read(folder: Path, text: str) -> Robot:
    path = folder / "robot.toml"
    path.write_text(text, encoding="utf-8")
    return read_robot(path)


@pytest.fixture
def gantry(tmp_path: Path) -> Robot:
    return read(tmp_path, GANTRY_FILE)


@pytest.fixture
def arms(tmp_path: Path) -> Robot:
    return read(tmp_path, ARMS_FILE)


def test_mechanisms_are_known_by_name() -> None:
    assert {"made_up_gantry", "made_up_arms", "linear_delta"} <= set(mechanisms.names())
    found = mechanisms.mechanism("made_up_gantry")
    assert pickle.loads(pickle.dumps(found)) is found
    with pytest.raises(PkmodesError, match='unknown mechanism "linear_dleta"') as error:
        mechanisms.mechanism("linear_dleta")
    assert error.match('did you mean "linear_delta"')


def test_every_number_goes_to_its_place(gantry: Robot) -> None:
    p = gantry.parameters
    assert p.toolhead_mass == 0.5
    assert p.belt_width.tolist() == [0.006, 0.009]
    assert p.belt_specific_stiffness.tolist() == [2.6e6] * 2
    assert p.workspace.tolist() == [[0.0, 0.3], [-0.01, 0.25]]
    assert p.signs.tolist() == [[1.0, -1.0], [-1.0, -1.0]]
    assert p.lengths.tolist() == [[0.45, 0.75], [0.75, 0.76]]
    assert gantry.quantities["toolhead.mass"].sigma == 0.01
    assert gantry.declared["belt_path.2.direction"] == [-1, -1]
    assert gantry.declared["belt_path.2.lengths.2"] == 0.76
    assert gantry.constants == {"frame_compliance.mass": 50.0}


def test_angles_are_read_in_degrees(arms: Robot) -> None:
    assert arms.parameters.limits.tolist() == [[math.radians(-95), math.radians(40)]] * 3
    assert arms.quantities["axis.2.limits.max"].unit == "rad"
    np.testing.assert_allclose(np.linalg.norm(arms.parameters.axis, axis=1), 1.0, rtol=1e-15)


@pytest.mark.parametrize(
    ("old", "new", "path", "expected", "found"),
    [
        ("direction = [1, -1]", "direction = [1, 2]", "belt_path.1.direction", "each 1 or -1", "2"),
        ("direction = [1, -1]", "direction = [1]", "belt_path.1.direction", "list of 2 numbers", "found 1"),
        ("direction = [1, -1]", "direction = [true, 1]", "belt_path.1.direction", "each 1 or -1", "true"),
        ('["450 mm", "750 mm"]', '["450 mm", "0 mm"]', "belt_path.1.lengths.2", "greater than 0 m", "0 mm"),
        ('["450 mm", "750 mm"]', '["450 mm"]', "belt_path.1.lengths", "list of 2 length", "1 elements"),
        ('["0 mm", "300 mm"]', '["300 mm", "0 mm"]', "workspace.x", "lower limit first", "0.3 m before 0 m"),
        ('x = ["0 mm", "300 mm"]', "", "workspace.x", "workspace.x is missing", "add it"),
        ('["0 mm", "300 mm"]', '["0 mm", "900 mm"]', "belt_path.1.lengths", "positive", "-0.16 m (0.45 m at"),
        ("[toolhead]", "[tolhead]", "toolhead", "toolhead is missing", "add it"),
        ("[gantry]\n", "[gantry]\nlength = 1\n", "gantry.length", 'unknown key "length"', "known: mass"),
        ("[gantry]\n", "[platform]\nmass = 1\n[gantry]\n", "platform", 'unknown key "platform"', "known"),
        ("[belt_path.belt]", "[belt_path.bolt]", "belt_path.2.bolt", 'key "bolt"', 'did you mean "belt"'),
        ('width = "6 mm"', "", "belt.width", "expected a length", "found nothing"),
        (
            "[gantry]\n",
            "[effects.link_compliance]\n[gantry]\n",
            'effects."link_compliance"',
            "does not apply",
            "",
        ),
        ("[gantry]\n", "[effects.belt_mas]\n[gantry]\n", 'effects."belt_mas"', "unknown", '"belt_mass"'),
        ("made_up_gantry", "made_up_gantri", "mechanism", "unknown mechanism", '"made_up_gantry"'),
        ('"made_up_gantry"', "3", "mechanism", "name of a mechanism", "found 3"),
    ],
)
def test_mistakes_name_path_expected_and_found(
    tmp_path: Path, old: str, new: str, path: str, expected: str, found: str
) -> None:
    assert old in GANTRY_FILE
    with pytest.raises(RobotFileError) as error:
        read(tmp_path, GANTRY_FILE.replace(old, new, 1))
    line = error.value.lines[0]
    assert f"robot.toml: {path})" in line, line
    assert expected in line, line
    assert found in line, line


def test_an_effect_that_does_not_apply_is_refused_with_those_that_do(tmp_path: Path) -> None:
    with pytest.raises(
        RobotFileError, match="link_compliance does not apply to the mechanism made_up_gantry"
    ) as e:
        read(tmp_path, GANTRY_FILE + '[effects.link_compliance]\ncompliance = "1e-7 m/N"\n')
    assert e.match("effects that apply: belt_mass, belt_tension_stiffness, frame_compliance")


def test_an_angle_out_of_bounds_is_refused(tmp_path: Path) -> None:
    for limits, found in (('["-181 deg", "40 deg"]', "of at least"), ('["0 deg", "181 deg"]', "of at most")):
        with pytest.raises(RobotFileError, match=f"expected an angle {found}"):
            read(tmp_path, ARMS_FILE.replace('["-95 deg", "40 deg"]', limits, 1))
    assert read(tmp_path, ARMS_FILE.replace('["-95 deg", "40 deg"]', '["-180 deg", "180 deg"]'))


def test_the_count_of_a_repeated_table_is_its_own(tmp_path: Path) -> None:
    with pytest.raises(
        RobotFileError, match=r"expected exactly two \[\[belt_path\]\] tables, found 1"
    ) as error:
        read(tmp_path, GANTRY_FILE[: GANTRY_FILE.rindex("[[belt_path]]")])
    assert error.match("a belt with its two runs")


def test_parameters_of_an_effect_that_are_not_given_are_null(tmp_path: Path) -> None:
    robot = read(tmp_path, GANTRY_FILE + '[effects.belt_tension_stiffness]\ntension = "50 N"\n')
    assert robot.effects == {
        "belt_tension_stiffness.tension": 50.0,
        "belt_tension_stiffness.coefficient": 0.0,
    }
    robot = robot.with_values({"effects.belt_tension_stiffness.coefficient": "2e-3 1/N"})
    assert robot.effects["belt_tension_stiffness.coefficient"] == 0.002


def test_it_is_changed_as_an_edited_file(tmp_path: Path, gantry: Robot) -> None:
    values = {
        "belt.width": "7 mm",
        "belt_path.1.pulley.radius": "6.5 mm",
        "belt_path.2.lengths": ["760 mm", 0.77],
        "workspace.x.max": 0.31,
        "frame.mass": "20 kg",
    }
    changed = gantry.with_values(values)
    text = GANTRY_FILE.replace('"6 mm"', '"7 mm"').replace('["750 mm", "760 mm"]', '["760 mm", "770 mm"]')
    text = text.replace('"300 mm"', '"310 mm"').replace("[workspace]", '[frame]\nmass = "20 kg"\n[workspace]')
    text = text.replace('"750 mm"]\n[[', '"750 mm"]\npulley.radius = "6.5 mm"\n[[')
    assert changed == read(tmp_path, text)
    assert changed.parameters.pulley_radius.tolist() == [0.0065, 0.00637]
    for wrong, what in (
        ({"belt_path.1.direction": [1, 1]}, "belt_path.1.direction is not a quantity"),
        ({"belt_path.3.belt.width": 1}, "unknown parameter path"),
        ({"workspace.x.max": 0.9}, "positive in the whole workspace"),
        ({"axis.span": 1}, "unknown parameter path"),
    ):
        with pytest.raises(PkmodesError, match=what):
            gantry.with_values(wrong)


def test_a_shared_value_that_no_entry_takes_cannot_be_changed(gantry: Robot) -> None:
    own = gantry.with_values({"belt_path.1.belt.width": 0.006})
    with pytest.raises(PkmodesError, match=r"no belt_path takes the shared value belt\.width") as error:
        own.with_values({"belt.width": 0.007})
    assert error.match(r"change belt_path\.1\.belt\.width and belt_path\.2\.belt\.width")


def test_it_is_saved_with_its_layout(tmp_path: Path, gantry: Robot) -> None:
    text = corrected_text(
        tmp_path / "robot.toml",
        {
            "belt_path.1.lengths.2": Correction(0.7512, 0.001, "refitted"),
            "belt_path.1.belt.width": Correction(0.0061),
            "belt.width": Correction(0.0062),
            "effects.belt_tension_stiffness.coefficient": Correction(2e-3),
            "frame.mass": Correction(20.0),
        },
    )
    expected = GANTRY_FILE.replace(
        '"750 mm"]',
        '{ value = "751.2 mm", sigma = "1 mm" }]  # refitted\n\n[belt_path.belt]\nwidth = "6.1 mm"',
        1,
    )
    expected = expected.replace('"6 mm"', '"6.2 mm"')
    expected += '\n[effects.belt_tension_stiffness]\ncoefficient = "0.002 1/N"\n\n[frame]\nmass = "20 kg"\n'
    assert text == expected
    assert read(tmp_path, text).parameters.lengths[0].tolist() == [0.45, 0.7512]


def test_a_corrected_angle_keeps_its_degrees(tmp_path: Path, arms: Robot) -> None:
    text = corrected_text(tmp_path / "robot.toml", {"axis.range": Correction(math.radians(137.0))})
    assert text == ARMS_FILE.replace('["-95 deg", "40 deg"]', '["-96 deg", "41 deg"]')


def test_paths_are_those_of_the_tables(gantry: Robot, arms: Robot) -> None:
    known = paths(gantry)
    assert known[:5] == ("gravity.x", "gravity.y", "gravity.z", "toolhead.mass", "gantry.mass")
    assert {"belt_path.1.belt.width", "belt_path.2.lengths.1", "workspace.y.max", "frame.mass"} <= set(known)
    for robot in (gantry, arms):
        for name in paths(robot):
            path = resolve(robot, name)
            changed = change_quantities(robot, [(path, 0.01)])
            assert resolve(changed, name).value == pytest.approx(path.value + 0.01, rel=1e-12)
        assert set(robot.quantities) <= set(paths(robot))
    assert resolve(gantry, "belt.width").weights == {("belt_width", (0,)): 1.0}  # belt 2 has its own
    assert resolve(gantry, "workspace.y.max").weights == {("workspace", (1, 1)): 1.0}
    assert resolve(gantry, "frame.mass").weights == {("frame_compliance.mass", ()): 1.0}
    assert resolve(arms, "axis.joint_radius").value == 0.04
    assert resolve(arms, "axis.range").unit == "rad"
    with pytest.raises(PkmodesError, match=r'did you mean "belt_path\.1\.belt\.width"'):
        resolve(gantry, "belt_path.1.belt.widht")


def test_what_is_suspected_follows_from_the_tables(gantry: Robot, arms: Robot) -> None:
    parameters, candidates, moves = suspects(gantry)
    names = {candidate.name for candidate in candidates}
    assert {"parameter:gantry.mass", "parameter:belt_path.1.lengths.2", "parameter:belt.width"} <= names
    assert {"belt_mass", "frame_compliance with another frame.mass"} <= names
    assert "belt_tension_stiffness" not in names  # without a tension its coefficient has no effect
    assert {"parameter:belt_path.2.pulley.radius", "frame_compliance of u_y alone"} <= names
    # Known exactly, not suspected, not measurable, or overridden for the other belt.
    for name in ("toolhead.mass", "frame.mass", "workspace.x.max", "gravity.x", "belt_path.1.belt.width"):
        assert f"parameter:{name}" not in names
    assert parameters[0].name == "toolhead.mass"
    assert moves["gantry.mass"].value == 0.7
    tensioned = gantry.with_values({"effects.belt_tension_stiffness.tension": "40 N"})
    found = suspects(tensioned)[1]
    tension = next(candidate for candidate in found if candidate.name == "belt_tension_stiffness")
    assert tension.parameters == ("effects.belt_tension_stiffness.coefficient",)
    names = {candidate.name for candidate in suspects(arms)[1]}
    assert {"parameter:axis.range", "parameter:axis.joint_radius"} <= names
    assert not any(".limits." in name or ".joint." in name for name in names)


def test_robots_travel_and_compare(gantry: Robot) -> None:
    for twin in (copy.deepcopy(gantry), pickle.loads(pickle.dumps(gantry))):
        assert twin == gantry
        assert hash(twin) == hash(gantry)
        assert not twin.parameters.lengths.flags.writeable
        assert twin.mechanism is gantry.mechanism


def test_what_is_declared_is_read_back(gantry: Robot, arms: Robot) -> None:
    for robot in (
        gantry,
        arms,
        pkmodes.read_robot(Path(__file__).parents[2] / "robots/linear-delta-2022.toml"),
    ):
        document = document_of(robot.mechanism, robot.name, robot.declared)
        found = robot_from_document(document, "declared")
        assert found.declared == robot.declared
        assert all(np.array_equal(a, b) for a, b in zip(found.parameters, robot.parameters, strict=True))


def test_the_tables_fill_every_field_of_every_mechanism() -> None:
    for name in mechanisms.names():
        kind = mechanisms.mechanism(name)
        filled = {item.key.field for item in items(kind)} - {""}
        assert filled == set(kind.model.Parameters._fields), name


def test_a_mechanism_that_is_misspelled_is_refused_with_the_nearest(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match='unknown mechanism "linear_dleta"') as error:
        read(tmp_path, edited('"linear_delta"', '"linear_dleta"'))
    assert error.match(r'robot\.toml: mechanism\); did you mean "linear_delta"\?')


def test_what_reads_robot_files_names_nothing_of_a_mechanism() -> None:
    """In the code only: docstrings may give examples, and sentences contain words such as joint."""
    kind = mechanisms.mechanism("linear_delta")
    named = {kind.name, *kind.effects, *kind.independent}
    named |= {table.name for table in kind.tables} | {group.path for group in kind.parameter_groups}
    every = [item.key for item in items(kind)]
    named |= {key.field for key in every} - {"gravity", ""} - {key.kind for key in every}
    source = Path(__file__).parents[2] / "src/pkmodes"
    files = [
        *sorted((source / "core" / "robot").glob("*.py")),
        source / "loop" / "updating" / "candidates.py",
    ]
    assert len(files) > 10
    for file in files:
        tree = ast.parse(file.read_text(encoding="utf-8"))
        explained = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(tree):
            words: set[str] = set()
            if isinstance(node, ast.Attribute):
                words = {node.attr}
            elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in explained:
                words = set(re.findall(r"\w+", node.value)) if " " not in node.value else set()
            assert not words & named, (file.name, getattr(node, "lineno", 0), words & named)
