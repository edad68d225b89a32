"""A robot with other values equals the robot of an edited file; robots compare, hash, pickle and copy."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import tomlkit
from hypothesis import given, settings
from hypothesis import strategies as st

import pkmodes
from helpers.robots.robot_text import PUBLISHED, edited, published
from helpers.robots.same_robots import same_to_the_last_digit
from pkmodes.core.base.errors import PoseError, RobotFileError
from pkmodes.core.robot.units import Quantity
from pkmodes.loop.sensitivity.paths import change_quantities, paths, resolve

POSE = [0.6, 0.03, -0.245]
#: Joints off the centre, overrides, standard deviations, effects, a direction that changes when normalised twice.
RICH = (
    published()
    .replace('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "2 %" }')
    .replace('width = "15 mm"', 'width = { value = "15 mm", sigma = "0.1 mm" }')
    .replace('joint = ["0 mm", "0 mm", "0 mm"]', 'joint = ["30 mm", "5 mm", "-1 mm"]', 1)
    .replace('joint = ["0 mm", "0 mm", "0 mm"]', 'joint = ["-12 mm", "16 mm", "0 mm"]', 1)
    .replace('joint = ["0 mm", "0 mm", "0 mm"]', 'joint = ["0 mm", "-21 mm", "20 mm"]', 1)
    .replace("direction = [1, 0, 0]", "direction = [0.99, 0.001, 0.045]", 1)
    + '\n[axis.belt]\nwidth = "12 mm"\n[axis.link]\nmass = { value = "0.6 kg", sigma = 0 }\n'
    + '\n[effects.payload]\nmass = "0.2 kg"\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\n'
)


def read(folder: Path, text: str) -> pkmodes.Robot:
    path = folder / "robot.toml"
    path.write_text(text, encoding="utf-8")
    return pkmodes.read_robot(path)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("robots")


@pytest.fixture(scope="module")
def rich(folder: Path) -> pkmodes.Robot:
    return read(folder, RICH)


@pytest.fixture(scope="module")
def by_direction(folder: Path) -> pkmodes.Robot:
    """The same with compliances of the frame in place of the isotropic one."""
    directions = 'compliance_x = "1e-8 m/N"\ncompliance_y = "2e-8 m/N"\ncompliance_z = "3e-9 m/N"'
    return read(folder, RICH.replace('compliance = "1e-8 m/N"', directions))


@pytest.fixture(scope="module")
def robot() -> pkmodes.Robot:
    return pkmodes.read_robot(PUBLISHED)


def written(text: str, path: str, raw: object) -> str:
    """A robot file with another value, edited with a library that the package does not use."""
    document = tomlkit.parse(text)
    *tables, key = path.split(".")
    table = document
    for name in tables:
        if name in "123":
            table = table[int(name) - 1]
        else:
            if name not in table:
                table[name] = tomlkit.table()
            table = table[name]
    elements = {"x": 0, "y": 1, "z": 2, "min": 0, "max": 1}
    table[elements.get(key, key)] = raw
    return tomlkit.dumps(document)


#: Paths of one number, what a file may say there, and the relative standard deviation that is kept.
LENGTH = ["{} mm", "{} um", "{:.3f} inch"]
VALUES = {
    "platform.mass": ["{} g", "{:.4f} kg"],
    "link.length": ["40{} mm", "0.4{} m", "16 in"],
    "link.mass": ["{} g"],
    "carriage.mass": ["{} g", "{:.3f} lb"],
    "carriage.length": ["{} um"],
    "belt.specific_stiffness": ["{} kN/m"],
    "belt.width": LENGTH,
    "pulley.radius": LENGTH,
    "pulley.inertia": ["{} kg*mm^2"],
    "motor.inertia": ["{} g*cm**2"],
    "motor.gear_ratio": ["{}"],
    "gravity.z": ["-{} m/s^2"],
    "gravity.x": ["{} mm/s^2"],
    "frame.mass": ["{} kg"],
    "axis.1.origin.y": ["-{} um"],
    "axis.2.joint.z": ["{} um"],
    "axis.3.limits.max": ["1{} mm"],
    "axis.1.belt.width": LENGTH,
    "axis.3.belt.width": LENGTH,
    "axis.2.motor.gear_ratio": ["{}"],
    "effects.payload.mass": ["{} g"],
    "effects.belt_mass.linear_density": ["{} g/m"],
    "effects.gearbox_compliance.compliance": ["{}e-6 rad/(N*m)"],
    "effects.axis_belt_stiffness.factor_2": ["-0.{:d}"],
    "effects.frame_compliance.compliance": ["{} um/kN"],
}


@pytest.mark.usefixtures("backend")
@settings(max_examples=120)
@given(
    base=st.sampled_from([published(), RICH]),
    path=st.sampled_from(sorted(VALUES)),
    number=st.integers(1, 999),
    which=st.integers(0, 2),
    sigma=st.sampled_from(["keep", "3 %", 0, None]),
)
def test_it_is_the_robot_of_an_edited_file(
    folder: Path, base: str, path: str, number: int, which: int, sigma: object
) -> None:
    start = read(folder, base)
    raw = VALUES[path][which % len(VALUES[path])].format(number)
    before = start.quantities[path].sigma if path in start.quantities else None
    if path == "frame.mass" and "effects.frame_compliance.mass" in start.quantities:
        before = start.quantities["effects.frame_compliance.mass"].sigma
    value: object = raw if sigma == "keep" else {"value": raw, "sigma": sigma}
    stated = before if sigma == "keep" else sigma
    try:
        expected = read(
            folder, written(base, path, raw if stated is None else {"value": raw, "sigma": stated})
        )
    except RobotFileError as error:
        with pytest.raises(RobotFileError) as found:
            start.with_values({path: value})
        assert [p.what for p in found.value.problems] == [p.what for p in error.problems]
        assert [p.where.split(": ")[-1] for p in found.value.problems] == [
            p.where.split(": ")[-1] for p in error.problems
        ]
        return
    changed = start.with_values({path: value})
    same_to_the_last_digit(changed, expected)
    poses = [POSE, [0.55, -0.02, -0.26]]
    models = pkmodes.Model(changed), pkmodes.Model(expected)
    try:
        b = models[1].modes(poses, on_error="nan")
    except PoseError as error:  # such as a joint that hardly holds
        with pytest.raises(PoseError) as refused:
            models[0].modes(poses, on_error="nan")
        assert refused.value.what == error.what
        return
    a = models[0].modes(poses, on_error="nan")
    for name in pkmodes.Modes.FIELDS:
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), strict=True)


def test_several_values_at_once_and_one_after_the_other(folder: Path, rich: pkmodes.Robot) -> None:
    values = {"platform.mass": 0.3, "effects.payload.mass": "350 g", "link.length": "16 in"}
    text = RICH
    for path, raw in {**values, "platform.mass": {"value": 0.3, "sigma": 0.03}}.items():
        text = written(text, path, raw)
    expected = read(folder, text)
    same_to_the_last_digit(rich.with_values(values), expected)
    one_by_one = rich
    for path, raw in reversed(values.items()):
        one_by_one = one_by_one.with_values({path: raw})
    same_to_the_last_digit(one_by_one, expected)
    assert one_by_one.source == f"{folder / 'robot.toml'} with other values"
    assert rich.quantities["platform.mass"].value == 1.5  # the one that was begun with is as it was
    same_to_the_last_digit(rich.with_values({}), rich)


def test_a_standard_deviation_stays_unless_another_is_given(rich: pkmodes.Robot) -> None:
    def sigma(path: str, raw: object) -> float | None:
        return rich.with_values({path: raw}).quantities[path].sigma

    assert sigma("platform.mass", "3 kg") == 0.03  # 2 % of 1.5 kg: as it was, not of the new value
    assert sigma("platform.mass", {"value": "3 kg"}) == 0.03
    assert sigma("platform.mass", {"value": "3 kg", "sigma": "2 %"}) == pytest.approx(0.06)
    assert sigma("platform.mass", {"value": "3 kg", "sigma": None}) is None
    assert sigma("platform.mass", {"sigma": "10 g"}) == 0.01
    assert rich.with_values({"platform.mass": {"sigma": 0}}).quantities["platform.mass"] == Quantity(
        1.5, "kg", 0
    )
    assert sigma("axis.3.link.mass", "0.5 kg") == 0  # known exactly, and still
    assert sigma("axis.1.belt.width", "14 mm") is None  # a value of its own, as a file would declare it
    assert sigma("link.mass", Quantity(0.8, "kg", 0.01)) == 0.01


def test_wholes_move_their_elements(rich: pkmodes.Robot) -> None:
    wide = rich.with_values({"axis.span": "1400 mm"})
    np.testing.assert_allclose(wide.parameters.limits, [[-0.1, 1.3]] * 3, rtol=1e-15, atol=1e-16)
    grown = rich.with_values({"axis.joint_radius": np.linalg.norm([0.03, 0.005, 0.001]) + 0.01})
    before, after = rich.parameters.joint, grown.parameters.joint
    radius = np.linalg.norm(before, axis=1)
    np.testing.assert_allclose(after, before * ((radius + 0.01) / radius)[:, None], rtol=1e-14)
    assert grown.quantities["axis.2.joint.x"].value == after[1, 0]


def test_a_vector_may_be_given_whole(rich: pkmodes.Robot) -> None:
    for moon in (["0 m/s^2", 0, -1.62], (0, 0, "-1.62 m/s^2"), np.array([0.0, 0.0, -1.62])):
        assert rich.with_values({"gravity": moon}).parameters.gravity.tolist() == [0.0, 0.0, -1.62]
    short = rich.with_values({"axis.1.limits": ["5 cm", {"value": "1 m", "sigma": "1 mm"}]})
    assert short.parameters.limits[0].tolist() == [0.05, 1.0]
    assert short.quantities["axis.1.limits.max"].sigma == 0.001


def test_the_mass_of_the_frame_is_one(folder: Path, robot: pkmodes.Robot, rich: pkmodes.Robot) -> None:
    twice = edited('mass = "1.5 kg"', 'mass = "1.5 kg"\n[frame]\nmass = { value = "40 kg", sigma = "1 kg" }')
    framed = read(folder, twice + '\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\n')
    own = read(
        folder, published() + '\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\nmass = "40 kg"\n'
    )
    for start in (robot, rich, framed, own):
        for path in ("frame.mass", "effects.frame_compliance.mass"):
            changed = start.with_values({path: "60 kg"})
            assert changed.constants == {"frame_compliance.mass": 60.0}
            assert changed.effects.get("frame_compliance.mass", 60.0) == 60.0
            masses = [
                q.value for p, q in changed.quantities.items() if p.startswith(("frame", "effects.frame"))
            ]
            assert set(masses) <= {60.0, 1e-8}
    assert framed.with_values({"frame.mass": "60 kg"}).quantities["frame.mass"].sigma == 1.0
    for start in (robot, rich, framed, own):
        with pytest.raises(pkmodes.PkmodesError, match="would be changed twice"):
            start.with_values({"frame.mass": 50, "effects.frame_compliance.mass": 50})
    both = {"effects.frame_compliance.compliance": 1e-8, "effects.frame_compliance.mass": 40}
    same_to_the_last_digit(robot.with_values(both), own)


REFUSED = [
    ({"platform.mas": 1}, 'unknown parameter path "platform.mas"', 'did you mean "platform.mass"'),
    ({"axis.1.belt.with": 1}, "unknown parameter path", 'did you mean "axis.1.belt.width"'),
    ({"effects.paylod.mass": 1}, "unknown parameter path", 'did you mean "effects.payload.mass"'),
    ({"gravitty": 1}, "unknown parameter path", 'did you mean "gravity"'),
    ({"xyzzy": 1}, "unknown parameter path", "see docs"),
    ({3: 1}, "expected a parameter path, found 3", "for example: "),
    ({"axis.1.direction": [1, 0, 0]}, "axis.1.direction is not a quantity", "change the robot file"),
    ({"axis.1.branch": -1}, "axis.1.branch is not a quantity", "change the robot file"),
    ({"platform.mass": -1}, "expected a mass greater than 0 kg, found -1", "check the sign"),
    ({"platform.mass": "1 m"}, 'found "1 m", which is a length', "with its unit"),
    ({"platform.mass": "1.5"}, "which has no unit", "with its unit"),
    ({"platform.mass": None}, "expected a value, found None", "0 means no effect"),
    ({"frame.mass": {"value": None}}, "expected a value, found None", "give a number"),
    ({"platform.mass": True}, "expected a mass such as", "with its unit"),
    ({"platform.mass": 1j}, "expected a mass such as", "with its unit"),
    ({"platform.mass": np.array([1.0, 2.0])}, "found a list", "with its unit"),
    ({"platform.mass": {"value": 1, "sgima": 1}}, '"sgima"', "write { value"),
    (
        {"platform.mass": Quantity(1.0, "m")},
        "expected a quantity in kg, found one in m",
        "with that unit",
    ),
    ({"effects.payload.mass": -0.1}, "or 0 for no effect", "check the sign"),
    (
        {"effects.axis_belt_stiffness.factor_1": -1},
        "greater than -1, or 0 for no effect",
        "check the sign",
    ),
    ({"axis.1.limits": ["2 m", "1 m"]}, "expected the lower limit first", "write limits"),
    ({"axis.1.limits.min": "2 m"}, "expected the lower limit first", "write limits"),
    ({"axis.1.origin": [1, 2]}, "expected a list of 3 values, found 2", "give x, y, z"),
    ({"gravity": "9.81 m/s^2"}, "expected a list of 3 values", "give x, y, z"),
    ({"carriage.length": "1.3 m"}, "expected a carriage shorter than the travel", "check the limits"),
    ({"axis.span": 0}, "expected a length greater than 0 m", "check the sign"),
    ({"axis.span": "1 kg"}, "which is a mass", "with its unit"),
    ({"axis.span": {"value": 1, "sigma": 0.1}}, "axis.span has no standard deviation", "elements"),
    ({"axis.span": 1, "axis.2.limits.min": 0}, "would be changed twice", "change it only once"),
    ({"axis.joint_radius": 0.1}, "cannot be changed along its direction: it is 0", "the elements"),
    ("platform.mass", 'expected values by path, found "platform.mass"', "for example: "),
    ([("platform.mass", 1)], "expected values by path, found a list", "for example: "),
    (None, "expected values by path, found None", "for example: "),
]


def test_what_a_file_would_be_refused_for_is_refused(subtests: pytest.Subtests, robot: pkmodes.Robot) -> None:
    for values, what, remedy in REFUSED:
        with subtests.test(values=values):
            for call in (robot.with_values, pkmodes.Model(robot).with_values):
                with pytest.raises(pkmodes.PkmodesError, match=what.replace("(", r"\(")) as error:
                    call(values)
                assert error.match(remedy.replace("{", r"\{"))


def test_a_shared_value_that_no_axis_takes_cannot_be_changed(rich: pkmodes.Robot) -> None:
    own = rich.with_values({f"axis.{j}.belt.width": 0.012 for j in (1, 2, 3)})
    with pytest.raises(pkmodes.PkmodesError, match=r"no axis takes the shared value belt\.width") as error:
        own.with_values({"belt.width": 0.013})
    assert error.match(r"change axis\.1\.belt\.width, axis\.2")


def test_a_robot_whose_parameters_were_replaced_is_not_begun_with(robot: pkmodes.Robot) -> None:
    heavier = replace(robot, parameters=robot.parameters._replace(platform_mass=3.0))
    with pytest.raises(pkmodes.PkmodesError, match="differ from those that it declares"):
        heavier.with_values({"link.mass": 1})


def test_robots_are_equal_when_they_declare_the_same(folder: Path, robot: pkmodes.Robot) -> None:
    same = read(folder, published().replace('"400 mm"', '"0.4 m"') + "\n# a comment\n")
    assert same == robot
    assert hash(same) == hash(robot)
    assert len({same, robot}) == 1
    for other in (
        robot.with_values({"link.length": np.nextafter(0.4, 1)}),
        robot.with_values({"link.length": {"sigma": 0}}),
        robot.with_values({"effects.payload.mass": 0}),  # declared, if as none
        robot.with_values({"axis.1.link.length": 0.4}),
        robot.with_values({"frame.mass": 60}),
        read(folder, edited("driven_pulley = 1", "driven_pulley = 2")),
        read(folder, edited('name = "linear-delta-2022"', 'name = "another"')),
    ):
        assert other != robot
        assert len({other, robot}) == 2
    assert robot != "linear-delta-2022"
    assert (robot == 3) is False


def test_quantities_compare_and_hash() -> None:
    assert Quantity(1.5, "kg") == Quantity(1.5, "kg")
    assert len({Quantity(1.5, "kg"), Quantity(1.5, "kg", 0.0), Quantity(1.5, "m"), Quantity(1.5, "kg")}) == 3


@pytest.mark.usefixtures("backend")
def test_models_with_effects_are_pickled_and_copied(rich: pkmodes.Robot) -> None:
    model = pkmodes.Model(rich.with_values({"effects.gearbox_compliance.compliance": 1e-4}), 1e5)
    expected = model.modes(POSE)
    for twin in (copy.copy(model), copy.deepcopy(model), pickle.loads(pickle.dumps(model))):
        assert (twin.robot, twin.max_condition, twin.coordinates) == (model.robot, 1e5, model.coordinates)
        assert not twin.robot.parameters.link_length.flags.writeable
        np.testing.assert_array_equal(twin.modes(POSE).shapes, expected.shapes)


@pytest.mark.usefixtures("backend")
def test_models_travel_to_other_processes(robot: pkmodes.Robot) -> None:
    model = pkmodes.Model(robot.with_values({"effects.payload.mass": "350 g"}))
    poses = [np.array(POSE), np.array(POSE) + 0.01]
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        found = pool.map(model.frequencies, poses)
    np.testing.assert_array_equal(found, [model.frequencies(p) for p in poses])


def assert_changed(rich: pkmodes.Robot, path: str) -> None:
    """And to a value that the derivatives' paths also find: both use the same names."""
    before = resolve(rich, path)
    value = before.value * 1.01 or 1e-9
    changed = rich.with_values({path: value})
    after = resolve(changed, path)
    whole = path in ("axis.span", "axis.joint_radius")
    assert after.value == (pytest.approx(value, rel=1e-14) if whole else value)
    assert after.weights.keys() == before.weights.keys()
    # To first order the wholes change by their weights: joints along their directions, limits symmetrically.
    step = change_quantities(rich, [(before, value - before.value)])
    for a, b in zip(changed.parameters, step.parameters, strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-14, atol=1e-15)


def test_every_path_that_has_derivatives_can_be_changed(
    subtests: pytest.Subtests, rich: pkmodes.Robot, by_direction: pkmodes.Robot
) -> None:
    for path in paths(pkmodes.read_robot(PUBLISHED)):
        with subtests.test(path=path):
            assert_changed(by_direction if path in by_direction.quantities else rich, path)
