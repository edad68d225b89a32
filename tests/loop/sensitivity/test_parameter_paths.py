"""Parameter paths: each name changes the same values as an edited robot file, and unknown names are refused."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.dissipating import dissipating
from helpers.robots.robot_text import edited, published
from helpers.robots.sensitivity_cases import moving
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.paths import change_quantities, paths, resolve
from pkmodes_generated.linear_delta import Parameters

POSE = [0.6, 0.03, -0.245]
OWN_BELT = published() + '\n[axis.belt]\nwidth = "12 mm"\n'  # of the last axis
JOINTS = published()
for _joint in ('["30 mm", "0 mm", "0 mm"]', '["-12 mm", "-16 mm", "0 mm"]', '["0 mm", "20 mm", "-21 mm"]'):
    JOINTS = JOINTS.replace('joint = ["0 mm", "0 mm", "0 mm"]', f"joint = {_joint}", 1)


def robot(text: str) -> Robot:
    return robot_from_document(tomllib.loads(text), "robot.toml")


def by(text: str, amount: float, *names: str) -> Robot:
    start = robot(text)
    return change_quantities(start, [(resolve(start, name), amount) for name in names])


def assert_same(found: Robot, expected: Robot) -> None:
    for name in Parameters._fields:
        a, b = getattr(found.parameters, name), getattr(expected.parameters, name)
        np.testing.assert_allclose(a, b, rtol=1e-14, atol=1e-15, err_msg=name)
    assert found.effects == pytest.approx(expected.effects, rel=1e-14)


@pytest.mark.parametrize(
    ("path", "amount", "old", "new"),
    [
        ("gravity.x", 0.5, 'gravity = ["0 m/s^2"', 'gravity = ["0.5 m/s^2"'),
        ("platform.mass", 0.25, 'mass = "1.5 kg"', 'mass = "1.75 kg"'),
        ("link.length", 0.01, 'length = "400 mm"', 'length = "410 mm"'),
        ("carriage.length", 0.03, 'length = "0 mm"', 'length = "30 mm"'),
        ("belt.width", -0.003, 'width = "15 mm"', 'width = "12 mm"'),
        ("pulley.inertia", 1e-5, 'inertia = "130e-6 kg*m^2"', 'inertia = "140e-6 kg*m^2"'),
        ("motor.inertia", 1e-6, 'inertia = "0.017e-3 kg*m^2"', 'inertia = "0.018e-3 kg*m^2"'),
        ("motor.gear_ratio", -1.0, "gear_ratio = 10", "gear_ratio = 9"),
        ("axis.1.origin.y", 0.02, 'origin = ["0 mm", "0 mm", "0 mm"]', 'origin = ["0 mm", "20 mm", "0 mm"]'),
        ("axis.2.origin.y", 0.02, '"-200 mm"', '"-180 mm"'),
        ("axis.1.limits.max", -0.1, 'limits = ["0 m", "1.2 m"]', 'limits = ["0 m", "1.1 m"]'),
    ],
)
def test_a_path_moves_what_its_name_says_in_the_file(path: str, amount: float, old: str, new: str) -> None:
    changed = published().replace(old, new, 1)
    assert changed != published()
    assert_same(by(published(), amount, path), robot(changed))


def test_span_moves_both_ends_of_each_axis_evenly() -> None:
    changed = edited('limits = ["0 m", "1.2 m"]', 'limits = ["-0.1 m", "1.3 m"]', count=3)
    assert_same(by(published(), 0.2, "axis.span"), robot(changed))
    assert resolve(robot(published()), "axis.span").value == 1.2


def test_a_joints_radius_grows_along_its_own_direction() -> None:
    start, grown = robot(JOINTS), by(JOINTS, 0.01, "axis.joint_radius")
    before, after = start.parameters.joint, grown.parameters.joint
    radius = np.linalg.norm(before, axis=1)
    np.testing.assert_allclose(radius, [0.030, 0.020, 0.029], rtol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(after, axis=1), radius + 0.01, rtol=1e-14)
    np.testing.assert_allclose(after / (radius + 0.01)[:, None], before / radius[:, None], rtol=1e-13)
    assert resolve(start, "axis.joint_radius").value == pytest.approx(0.03, rel=1e-14)


def test_a_shared_path_moves_only_the_axes_without_a_value_of_their_own() -> None:
    assert_same(by(OWN_BELT, 0.001, "belt.width"), robot(OWN_BELT.replace("15 mm", "16 mm")))
    assert_same(by(OWN_BELT, 0.001, "axis.3.belt.width"), robot(OWN_BELT.replace("12 mm", "13 mm")))
    assert resolve(robot(OWN_BELT), "belt.width").value == 0.015
    assert resolve(robot(OWN_BELT), "axis.3.belt.width").value == 0.012


def test_an_axis_has_a_path_whether_or_not_it_has_a_value_of_its_own() -> None:
    start = robot(published())
    for j in (1, 2, 3):
        path = resolve(start, f"axis.{j}.belt.width")
        assert path.weights == {("belt_width", (j - 1,)): 1.0}
        assert (path.value, path.unit) == (0.015, "m")
    together = by(published(), 0.001, "axis.1.belt.width", "axis.2.belt.width", "axis.3.belt.width")
    assert_same(together, by(published(), 0.001, "belt.width"))


def test_values_that_every_axis_overrides_have_no_shared_path() -> None:
    text = published().replace("branch = 1\n", 'branch = 1\n[axis.belt]\nwidth = "11 mm"\n')
    text = text.replace("branch = -1\n", 'branch = -1\n[axis.belt]\nwidth = "12 mm"\n')
    for declared in (
        text,
        text.replace('width = "15 mm"', ""),
    ):  # [belt] width is there, but no axis takes it
        start = robot(declared)
        assert "belt.width" not in paths(start)
        assert "belt.specific_stiffness" in paths(start)
        with pytest.raises(pkmodes.PkmodesError, match=r'did you mean "axis\.\d\.belt\.width"'):
            resolve(start, "belt.width")


def test_every_declared_quantity_has_a_path_with_its_value_and_unit() -> None:
    declared = OWN_BELT + '[frame]\nmass = "60 kg"\n[effects.payload]\nmass = "0.35 kg"\n'
    start = robot(declared + '[effects.frame_compliance]\ncompliance = "1e-8 m/N"\n')
    assert len(start.quantities) > 40
    for name, quantity in start.quantities.items():
        path = resolve(start, name)
        assert (path.path, path.value, path.unit) == (name, quantity.value, quantity.unit)
        assert name in paths(start)


def test_paths_are_listed_once_and_resolve() -> None:
    start = robot(JOINTS)
    listed = paths(start)
    assert len(set(listed)) == len(listed)
    for name in listed:
        assert resolve(start, name).path == name


def test_effects_move_from_null_and_from_their_value() -> None:
    payload = '\n[effects.payload]\nmass = "{} kg"\n'
    frame = '\n[frame]\nmass = "60 kg"\n'
    compliant = '\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\n'
    assert_same(by(published(), 0.35, "effects.payload.mass"), robot(published() + payload.format(0.35)))
    start = published() + payload.format(0.3)
    assert_same(by(start, 0.05, "effects.payload.mass"), robot(published() + payload.format(0.35)))
    path = "effects.frame_compliance.compliance"
    assert_same(by(published(), 1e-8, path), robot(published() + compliant))
    assert_same(by(published() + frame, 1e-8, path), robot(published() + frame + compliant))
    declared = robot(published())
    steps = [(resolve(declared, "frame.mass"), 10.0), (resolve(declared, path), 1e-8)]
    for order in (steps, steps[::-1]):
        assert_same(change_quantities(declared, order), robot(published() + frame + compliant))


def test_moving_leaves_the_robot_as_it_was_and_adds_up() -> None:
    start = robot(published())
    mass, payload = resolve(start, "platform.mass"), resolve(start, "effects.payload.mass")
    changed = change_quantities(start, [(mass, 0.1), (payload, 0.2), (mass, 0.3)])
    assert changed.parameters.platform_mass == pytest.approx(1.9, rel=1e-15)
    assert changed.effects == {"payload.mass": 0.2}
    assert start.parameters.platform_mass == 1.5
    assert start.effects == {}
    assert_same(change_quantities(start, []), start)


def test_the_frames_mass_counts_when_the_frame_moves() -> None:
    compliant = '\n[effects.frame_compliance]\ncompliance = "1e-7 m/N"\n'
    names = ["frame.mass", "effects.frame_compliance.mass"]
    still = pkmodes.Model(robot(published())).sensitivities(POSE, names)
    assert still.values.tolist() == [50.0, 50.0]
    for field in ("mass_matrix", "stiffness_matrix", "eigenvalues", "shapes"):
        assert (getattr(still, field) == 0.0).all()
    moving = pkmodes.Model(robot(published() + '\n[frame]\nmass = "60 kg"\n' + compliant)).sensitivities(
        POSE, names
    )
    assert moving.values.tolist() == [60.0, 60.0]
    expected = np.zeros((12, 12))
    expected[9:, 9:] = np.eye(3)
    np.testing.assert_array_equal(moving.mass_matrix, [expected, expected])
    assert (moving.eigenvalues < 0.0).any()


def test_derivatives_add_up_as_the_moves_do() -> None:
    model = pkmodes.Model(robot(JOINTS))

    def rates(*names: str) -> np.ndarray:
        return model.sensitivities(POSE, names).eigenvalues

    def assert_equal(a: np.ndarray, b: np.ndarray) -> None:
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-9 * np.abs(b).max())

    each = rates(*(f"axis.{j}.link.length" for j in (1, 2, 3)))
    assert_equal(rates("link.length")[0], each.sum(axis=0))
    low, high = (rates(*(f"axis.{j}.limits.{end}" for j in (1, 2, 3))) for end in ("min", "max"))
    assert_equal(rates("axis.span")[0], 0.5 * (high.sum(axis=0) - low.sum(axis=0)))
    joint = model.robot.parameters.joint
    outward = joint / np.linalg.norm(joint, axis=1, keepdims=True)
    names = [f"axis.{j}.{{}}.{x}" for j in (1, 2, 3) for x in "xyz"]
    by_joint, by_origin = (rates(*(name.format(field) for name in names)) for field in ("joint", "origin"))
    assert_equal(rates("axis.joint_radius")[0], outward.ravel() @ by_joint)
    np.testing.assert_array_equal(by_origin, -by_joint)


def test_results_name_their_parameters_values_and_units() -> None:
    wanted = ("axis.span", "effects.link_compliance.compliance", "motor.gear_ratio", "platform.mass")
    found = pkmodes.Model(robot(published())).sensitivities(POSE, wanted)
    assert found.parameters == wanted
    assert found.units == ("m", "m/N", "1", "kg")
    assert found.values.tolist() == [1.2, 0.0, 10.0, 1.5]


@pytest.mark.parametrize(
    ("name", "what", "remedy"),
    [
        ("platform.mas", 'unknown parameter path "platform.mas"', 'did you mean "platform.mass"?'),
        ("axis.4.belt.width", "unknown parameter path", r'did you mean "axis.\d.belt.width"\?'),
        ("axis.1.direction.x", "unknown parameter path", "did you mean"),
        ("effects.paylod.mass", "unknown parameter path", 'did you mean "effects.payload.mass"?'),
        ("xyzzy", "unknown parameter path", "docs/reference/parameter-paths.md"),
        (3, "expected a parameter path, found 3", "give strings"),
        (None, "expected a parameter path", "give strings"),
    ],
)
def test_unknown_paths_are_refused_with_the_nearest(name: object, what: str, remedy: str) -> None:
    with pytest.raises(pkmodes.PkmodesError, match=what) as error:
        pkmodes.Model(robot(published())).sensitivities(POSE, ["link.mass", name])
    assert error.match(remedy)


@pytest.mark.parametrize(
    ("parameters", "found", "remedy"),
    [("link.mass", '"link.mass"', r'write \["link.mass"\]'), (3, "3", r'for example: \["platform.mass"\]')],
)
def test_a_single_path_must_be_in_a_list(parameters: object, found: str, remedy: str) -> None:
    with pytest.raises(
        pkmodes.PkmodesError, match=f"expected a list of parameter paths, found {found}"
    ) as error:
        pkmodes.Model(robot(published())).sensitivities(POSE, parameters)
    assert error.match(remedy)


ONE_CENTRED = JOINTS.replace('["30 mm", "0 mm", "0 mm"]', '["0 mm", "0 mm", "0 mm"]')


@pytest.mark.parametrize("text", [published(), ONE_CENTRED], ids=["all-centred", "one-centred"])
def test_the_radius_of_joints_at_the_centre_cannot_vary(text: str) -> None:
    model = pkmodes.Model(robot(text))
    with pytest.raises(pkmodes.PkmodesError, match=r"axis\.joint_radius cannot vary") as error:
        model.sensitivities(POSE, ["axis.joint_radius"])
    assert error.match(r"axis\.1\.joint\.x")
    everything = model.sensitivities(POSE)  # not requested by name
    assert everything.parameters == tuple(p for p in moving(model.robot) if p != "axis.joint_radius")


def test_by_default_every_path_that_moves_frequencies_is_there() -> None:
    model = pkmodes.Model(robot(JOINTS))
    assert model.sensitivities(POSE).parameters == tuple(moving(model.robot))


def test_frequencies_do_not_depend_on_what_only_dissipates() -> None:
    model = pkmodes.Model(robot(JOINTS))
    names = [path for path in paths(model.robot) if path not in moving(model.robot)]
    assert sorted(name.split(".")[1] for name in names) == sorted(dissipating("linear_delta"))
    found = model.sensitivities(POSE, names)
    assert not found.frequencies[:, model.modes(POSE).rigid_modes :].any()


ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "reference/parameter-paths.md").read_text(encoding="utf-8")


def test_the_page_lists_every_path() -> None:
    for name in paths(robot(JOINTS)):
        if name.startswith("effects."):
            assert "effects.<effect>.<parameter>" in PAGE
            continue
        table, _, key = name.rpartition(".")
        whole = table.removeprefix("axis.1.").removeprefix("axis.2.").removeprefix("axis.3.")
        assert f"`{name}`" in PAGE or f"`{whole}.{key}`" in PAGE or f"`axis.N.{whole}.{key}`" in PAGE, name
