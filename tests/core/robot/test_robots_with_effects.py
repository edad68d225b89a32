"""Robots with ``[effects.*]`` tables: results of the evaluator, and refusals.

Effects that only dissipate change neither M nor K: see test_dissipation_matrices.py.
"""

from __future__ import annotations

import json
import runpy
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.dissipating import dissipating
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.core.base.errors import RobotFileError
from pkmodes.core.mechanism.registry import mechanism

CATALOGUE = mechanism("linear_delta").effects

POSE = [0.6, 0.03, -0.245]
VALUES = {
    "payload": {"mass": "0.35 kg"},
    "belt_mass": {"linear_density": "0.06 kg/m"},
    "gearbox_inertia": {"inertia": "2e-4 kg*m^2"},
    "servo_stiffness": {"stiffness": "500 N*m/rad"},
    "belt_end_compliance": {"compliance": "1e-7 m/N"},
    "axis_belt_stiffness": {"factor_1": "5 %", "factor_2": "-0.1", "factor_3": "0.02"},
    "belt_tension_stiffness": {"coefficient": "0.01 1/N", "tension": "20 N"},
    "cable_stiffness": {"stiffness": "1 N/mm"},
    "gearbox_compliance": {"compliance": "1e-3 rad/(N*m)"},
    "link_compliance": {"compliance": "1e-7 m/N"},
    "clamp_compliance": {"compliance": "1e-7 m/N"},
    "frame_compliance": {"compliance": "1e-8 m/N"},
}


def table(name: str, values: dict[str, str]) -> str:
    return f"\n[effects.{name}]\n" + "".join(f'{key} = "{value}"\n' for key, value in values.items())


def load(tmp_path: Path, *tables: str) -> pkmodes.Model:
    path = tmp_path / "robot.toml"
    path.write_text(published() + "".join(tables), encoding="utf-8")
    return pkmodes.load(path)


def problem(tmp_path: Path, *tables: str) -> str:
    with pytest.raises(RobotFileError) as error:
        load(tmp_path, *tables)
    return error.value.lines[0]


def test_every_effect_of_the_catalogue_has_a_case_here() -> None:
    assert VALUES.keys() == CATALOGUE.keys() - set(dissipating("linear_delta"))


@pytest.mark.parametrize("name", list(VALUES))
def test_null_values_are_the_base_model(tmp_path: Path, name: str) -> None:
    given = [one for one in CATALOGUE[name].parameters if one.fitted and not one.in_place_of]
    nulls = {parameter.name: "0" for parameter in given}
    rows = "".join(f"{key} = {value}\n" for key, value in nulls.items())
    found = load(tmp_path, f"\n[effects.{name}]\n{rows}").modes(POSE)
    expected = pkmodes.load(PUBLISHED).modes(POSE)
    assert found.coordinates == expected.coordinates
    np.testing.assert_array_equal(found.frequencies, expected.frequencies)


@pytest.mark.parametrize("name", list(VALUES))
def test_each_effect_changes_the_frequencies_and_lists_its_coordinates(tmp_path: Path, name: str) -> None:
    found, base = load(tmp_path, table(name, VALUES[name])).modes(POSE), pkmodes.load(PUBLISHED).modes(POSE)
    assert found.coordinates == (*base.coordinates, *(q.name for q in CATALOGUE[name].coordinates))
    assert found.rigid_modes == (0 if CATALOGUE[name].grounds else 3)
    added = 0 if name == "clamp_compliance" else len(CATALOGUE[name].coordinates)
    assert found.frequencies.shape == (9 + added,)
    assert found.shapes.shape == (9 + added, len(found.coordinates))
    assert np.abs(found.frequencies[3:9] - base.frequencies[3:9]).max() > 1e-3
    M = found.mass_matrix
    np.testing.assert_allclose(
        found.shapes @ M @ found.shapes.T, np.eye(len(found.shapes)), rtol=0, atol=1e-11
    )


def assert_pair(tmp_path: Path, pair: tuple[str, str]) -> None:
    found = load(tmp_path, *(table(name, VALUES[name]) for name in pair)).modes(POSE)
    order = [q.name for name in CATALOGUE if name in pair for q in CATALOGUE[name].coordinates]
    assert list(found.coordinates[9:]) == order
    M, K, shapes = found.mass_matrix, found.stiffness_matrix, found.shapes
    eigenvalues = np.sign(found.frequencies) * (2 * np.pi * found.frequencies) ** 2
    residual = shapes @ K - eigenvalues[:, None] * (shapes @ M)
    inertia = np.diagonal(M)
    # A backward stable solver leaves rounding of the largest eigenvalue in coordinates scaled by inertia; a
    # coordinate without inertia is in equilibrium, to the rounding of the forces that act on it.
    bound = 1e-12 * eigenvalues[-1] * np.sqrt(inertia) + 1e-12 * (inertia == 0.0) * np.abs(K).max(axis=0)
    assert (np.abs(residual) <= bound * np.maximum(np.abs(shapes).max(), 1.0)).all()


def test_any_two_effects_solve_their_eigenproblem(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for pair in combinations(VALUES, 2):
        with subtests.test(" and ".join(pair)):
            assert_pair(tmp_path, pair)


def test_the_rigid_modes_are_those_that_strain_nothing(tmp_path: Path) -> None:
    """Without gravity they are zero eigenvalues, and there are none if the platform is tied to ground."""
    for name in VALUES:
        text = published().replace("-9.81 m/s^2", "0 m/s^2") + table(name, VALUES[name])
        (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
        found = pkmodes.load(tmp_path / "robot.toml").modes(POSE)
        assert (np.abs(found.frequencies) < 1e-3).sum() == found.rigid_modes, name


def test_a_clamp_without_mass_is_the_limit_of_a_small_mass(tmp_path: Path) -> None:
    """Condensation is exact: with decreasing belt mass the result converges to it from below, at a linear rate."""
    clamp = table("clamp_compliance", VALUES["clamp_compliance"])
    exact = load(tmp_path, clamp).modes(POSE).frequencies
    errors = []
    for density in (1e-3, 1e-4):
        light = load(tmp_path, clamp, table("belt_mass", {"linear_density": f"{density} kg/m"})).modes(POSE)
        assert len(light.frequencies) == 12
        errors.append(exact[3:] - light.frequencies[3:9])
    assert (errors[0] > 0).all()
    np.testing.assert_allclose(errors[1], 0.1 * errors[0], rtol=1e-2)


def test_the_platform_moves_with_the_frame(tmp_path: Path) -> None:
    found = load(tmp_path, table("frame_compliance", VALUES["frame_compliance"])).modes(POSE)
    D_p = pkmodes.load(PUBLISHED).platform_jacobian(POSE)
    expected = found.shapes[:, :3] @ D_p.T + found.shapes[:, 9:]
    np.testing.assert_allclose(found.platform_shapes, expected, rtol=0, atol=1e-12)


def test_static_torques_hold_the_payload_too(tmp_path: Path) -> None:
    loaded = load(tmp_path, table("payload", VALUES["payload"])).statics(POSE).torques
    text = published().replace('mass = "1.5 kg"', 'mass = "1.85 kg"')
    (tmp_path / "heavier.toml").write_text(text, encoding="utf-8")
    np.testing.assert_allclose(
        loaded, pkmodes.load(tmp_path / "heavier.toml").statics(POSE).torques, rtol=1e-12
    )
    servo = load(tmp_path, table("servo_stiffness", VALUES["servo_stiffness"])).statics(POSE).torques
    np.testing.assert_allclose(servo, pkmodes.load(PUBLISHED).statics(POSE).torques, rtol=1e-12)


def test_batches_and_bad_poses_work_with_effects(tmp_path: Path) -> None:
    model = load(tmp_path, *(table(name, values) for name, values in VALUES.items()))
    result = model.modes([POSE, [9, 9, 9], POSE], on_error="nan")
    assert result.valid.tolist() == [True, False, True]
    assert result.frequencies.shape == (3, 21)
    np.testing.assert_array_equal(result.frequencies[0], result.frequencies[2])
    np.testing.assert_allclose(result.frequencies[0], model.modes(POSE).frequencies, rtol=1e-12)


def test_the_frames_mass_is_that_of_the_frame_table(tmp_path: Path) -> None:
    compliant = table("frame_compliance", VALUES["frame_compliance"])
    default = load(tmp_path, compliant).modes(POSE).frequencies
    same = load(tmp_path, '\n[frame]\nmass = "50 kg"\n', compliant).modes(POSE).frequencies
    heavier = load(tmp_path, '\n[frame]\nmass = "80 kg"\n', compliant).modes(POSE).frequencies
    within = load(tmp_path, table("frame_compliance", {"compliance": "1e-8 m/N", "mass": "80 kg"})).modes(
        POSE
    )
    np.testing.assert_array_equal(default, same)
    assert np.abs(default - heavier).max() > 0.1
    np.testing.assert_array_equal(heavier, within.frequencies)


def test_the_command_line_evaluates_effects(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load(tmp_path, *(table(name, values) for name, values in VALUES.items()))
    assert run(["modes", str(tmp_path / "robot.toml"), "--pose", "0.6,0.03,-0.245", "--json", "-"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["coordinates"][9:] == [q.name for effect in CATALOGUE.values() for q in effect.coordinates]
    assert content["rigid_modes"] == 0
    assert run(["modes", str(tmp_path / "robot.toml"), "--pose", "0.6,0.03,-0.245"]) == 0
    out = capsys.readouterr().out
    assert "…" not in out
    assert "eps_3" in out


@pytest.mark.parametrize(
    ("text", "what", "where", "remedy"),
    [
        (
            '[effects.paylod]\nmass = "1 kg"',
            'unknown effect "paylod"',
            'effects."paylod"',
            'did you mean "payload"?',
        ),
        (  # as a diagnosis writes it for what it found beyond the catalogue
            '[effects.mount_carriage_2_y]\ncompliance = "8e-7 m/N"',
            'unknown effect "mount_carriage_2_y"',
            'effects."mount_carriage_2_y"',
            "for an effect of your own, give the mechanism generated with it: --mechanism DIR/<mechanism>",
        ),
        (
            '[effects.payload]\nmas = "1 kg"',
            'unknown parameter "mas"',
            "effects.payload)",
            'did you mean "mass"?',
        ),
        ("[effects.payload]", "mass is missing", "effects.payload.mass", "add it"),
        (
            '[effects.payload]\nmass = "-1 kg"',
            "greater than 0 kg, or 0 for no effect",
            "effects.payload.mass",
            "sign",
        ),
        ('[effects.payload]\nmass = "1 m"', "which is a length", "effects.payload.mass", "unit"),
        ('[effects.link_compliance]\ncompliance = "-1e-7 m/N"', "greater than 0 m/N", "compliance)", "sign"),
        (
            '[effects.belt_tension_stiffness]\ncoefficient = "-0.05 1/N"\ntension = "30 N"',
            "1 + coefficient * tension above 0, found -0.5",
            "effects.belt_tension_stiffness.coefficient)",
            "check coefficient and tension",
        ),
        ('[effects.axis_belt_stiffness]\nfactor_1 = "-1"', "greater than -1", "factor_1)", "sign"),
        ('[effects.frame_compliance]\nmass = "8 kg"', "compliance is missing", "compliance)", "add it"),
        (
            '[frame]\nmass = "8 kg"\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\nmass = "9 kg"',
            "declared twice",
            "frame_compliance.mass",
            "keep it in [frame]",
        ),
        ("[effects]\npayload = 3", "expected a table, found 3", "effects.payload", "[effects.payload]"),
        ('[effects.payload]\nmass = "1 kg"\n[effects.payload]\nmass = "2 kg"', "not valid TOML", "", "fix"),
    ],
)
def test_mistakes_in_effects_are_refused(
    tmp_path: Path, text: str, what: str, where: str, remedy: str
) -> None:
    line = problem(tmp_path, "\n", text, "\n")
    assert what in line, line
    assert where in line, line
    assert remedy in line, line


@pytest.mark.parametrize(
    "names", [("payload",), ("clamp_compliance", "belt_mass"), tuple(VALUES)], ids="+".join
)
def test_a_generated_model_has_what_the_robot_needs_and_nothing_else(
    tmp_path: Path, names: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    model = load(tmp_path, *(table(name, VALUES[name]) for name in names))
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    module = runpy.run_path(str(tmp_path / "model" / "linear_delta_2022.py"))
    assert module["COORDINATES"] == model.coordinates
    M, K = module["modal_matrices"](POSE)
    expected = model.modes(POSE)
    np.testing.assert_allclose(M, expected.mass_matrix, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(K, expected.stiffness_matrix, rtol=1e-12, atol=1e-9)
    np.testing.assert_allclose(module["static_equilibrium"](POSE)[0], model.statics(POSE).torques, rtol=1e-12)
    motion = module["platform_motion"](POSE)
    np.testing.assert_allclose(expected.shapes @ motion.T, expected.platform_shapes, rtol=0, atol=1e-12)
    assert run(["check", str(tmp_path / "model")]) == 0
    assert "current" in capsys.readouterr().out


def test_a_changed_effect_makes_the_model_stale(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load(tmp_path, table("payload", {"mass": "0.35 kg"}))
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    load(tmp_path, table("payload", {"mass": "0.4 kg"}))
    assert run(["check", str(tmp_path / "model")]) == 1
    assert "the robot file changed: effects.payload.mass is 0.4" in capsys.readouterr().out
    load(tmp_path)
    assert run(["check", str(tmp_path / "model")]) == 1
    assert "effects.payload.mass is absent" in capsys.readouterr().out


def test_another_machine_does_not_need_the_null_effects(tmp_path: Path) -> None:
    """An effect at its null value generates the base model, byte for byte except for the robot file's text."""
    load(tmp_path, "\n[effects.payload]\nmass = 0\n")
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "null")]) == 0
    load(tmp_path)
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "base")]) == 0
    name = "linear_delta_2022.py"
    assert (tmp_path / "null" / name).read_bytes() == (tmp_path / "base" / name).read_bytes()


# A frame by direction -------------------------------------------------------------------------------------------


def test_a_frame_with_equal_directions_is_the_isotropic_one(tmp_path: Path) -> None:
    found = load(tmp_path, table("frame_compliance", {f"compliance_{i}": "4e-8 m/N" for i in "xyz"})).modes(
        POSE
    )
    expected = load(tmp_path, table("frame_compliance", {"compliance": "4e-8 m/N"})).modes(POSE)
    np.testing.assert_array_equal(found.frequencies, expected.frequencies)
    np.testing.assert_array_equal(found.shapes, expected.shapes)


@pytest.mark.parametrize("drives", ["free", "held"])
def test_a_direction_that_is_not_given_stays_locked(tmp_path: Path, drives: str) -> None:
    """A direction with a compliance that hardly yields moves no more than one that is locked."""
    one = load(tmp_path, table("frame_compliance", {"compliance_y": "4e-8 m/N"}))
    stiff = {f"compliance_{i}": "4e-8 m/N" if i == "y" else "1e-20 m/N" for i in "xyz"}
    all_three = load(tmp_path, table("frame_compliance", stiff))
    assert one.coordinates[-2:] == ("theta_3_2", "u_y")
    found, expected = (model.modes(POSE, drives=drives).frequencies for model in (one, all_three))
    assert len(found) == len(expected) - 2
    vibrations = found > 1.0
    np.testing.assert_allclose(found[vibrations], expected[: len(found)][vibrations], rtol=1e-8)


def test_a_frame_is_isotropic_or_given_by_direction(tmp_path: Path) -> None:
    both = problem(
        tmp_path, table("frame_compliance", {"compliance": "4e-8 m/N", "compliance_y": "4e-8 m/N"})
    )
    assert "expected compliance or compliance_y, found both" in both
    assert "effects.frame_compliance.compliance)" in both
    assert "keep compliance, or compliance_y in its place" in both
    assert "the parameter compliance is missing" in problem(tmp_path, "\n[effects.frame_compliance]\n")
    declared = load(tmp_path, table("frame_compliance", {"compliance_y": "4e-8 m/N"})).robot
    assert "effects.frame_compliance.compliance" not in declared.quantities
    softer = declared.with_values({"effects.frame_compliance.compliance_z": 1e-8})
    assert softer.effects["frame_compliance.compliance_z"] == 1e-8
    with pytest.raises(RobotFileError, match="found both"):
        declared.with_values({"effects.frame_compliance.compliance": 1e-8})
