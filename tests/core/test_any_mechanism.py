"""A hand-written mechanism with two coordinates works with the whole runtime."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import pytest

import pkmodes
import planar_pair
from pkmodes import diagnosis, updating
from pkmodes.cli.modes import as_json
from pkmodes.cli.poses import parse_pose
from pkmodes.codegen.checking.consistency import check_consistency
from pkmodes.core.base.errors import MeasurementError, PkmodesError, PoseError
from pkmodes.core.mechanism import registry as known
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import sample_parameters
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives
from pkmodes.loop.sensitivity.paths import ParameterPath
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.channels import channels
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.loop.updating.robot_structure import RobotStructure

KIND = known._load("planar_pair")
SAMPLE = sample_parameters(KIND)
POSES = np.array([[0.1, 0.05], [0.25, -0.02], [0.0, 0.2]])
CLAMPS = {"clamp_compliance.compliance": 2e-5}


def robot(effects: Mapping[str, float] | None = None) -> Robot:
    return Robot("pair", KIND.name, "pair.toml", SAMPLE, {}, dict(effects or {}))


@pytest.fixture(scope="module", autouse=True)
def _known_here_only() -> Iterator[None]:
    """Other tests in the same process find only the generated mechanisms."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(known, "_package_by_name", {})
        assert known.add("planar_pair") is KIND
        yield


@pytest.fixture(scope="module")
def model() -> pkmodes.Model:
    return pkmodes.Model(robot())


def expected(p: np.ndarray, compliance: float = 0.0, mass: float = SAMPLE.mass) -> np.ndarray:
    """Return the frequencies in closed form: per axis a mass and an inertia on one spring, clamp in series [Hz]."""
    k = 1.0 / ((SAMPLE.length + p) / SAMPLE.stiffness + compliance)
    found = np.sqrt(k * (1.0 / mass + SAMPLE.radius**2 / SAMPLE.inertia)) / (2.0 * np.pi)
    return np.sort(found, axis=-1)


def test_modes_are_those_of_two_springs(model: pkmodes.Model) -> None:
    found = model.modes(POSES)
    assert found.rigid_modes == 2
    np.testing.assert_allclose(found.frequencies[:, 2:], expected(POSES), rtol=1e-12)
    np.testing.assert_allclose(found.joint_positions, POSES)
    np.testing.assert_allclose(found.platform_shapes, found.shapes[..., :2])
    assert found.poses.shape == (3, 2)
    assert "carriage_positions" not in pkmodes.Modes.fields_of(KIND)
    with pytest.raises(PkmodesError, match='unknown field "carriage_positions"'):
        model.modes(POSES, fields=["carriage_positions"])
    assert model.modes(POSES[0]).frequencies.shape == (4,)
    one = np.empty((3, 2))
    assert model.modes(POSES, out={"joint_positions": one}).joint_positions is one
    np.testing.assert_array_equal(one, POSES)


def test_effects_release_coordinates_and_ground_the_tool() -> None:
    clamped = pkmodes.Model(robot(CLAMPS))
    assert clamped.coordinates == ("x", "y", "theta_1", "theta_2", "eps_1", "eps_2")
    np.testing.assert_allclose(clamped.frequencies(POSES)[:, 2:], expected(POSES, 2e-5), rtol=1e-12)
    # Without inertia they add no mode, even if there is no pose to evaluate M at.
    assert clamped.frequencies([[9.0, 9.0]], "nan").shape == (1, 4)
    assert ExtendedSystem.of(clamped.robot).massless.tolist() == [False] * 4 + [True] * 2
    loaded = pkmodes.Model(robot({"payload.mass": 0.4}))
    np.testing.assert_allclose(loaded.frequencies(POSES)[:, 2:], expected(POSES, mass=1.1), rtol=1e-12)
    assert pkmodes.Model(robot({"cable_stiffness.stiffness": 10.0})).modes(POSES).rigid_modes == 0


def test_torques_hold_the_weight(model: pkmodes.Model) -> None:
    found = model.statics(POSES)
    assert found.rotations.shape == (3, 2)
    weight = SAMPLE.mass * SAMPLE.gravity[:2]
    np.testing.assert_allclose(found.torques, np.tile(-SAMPLE.radius * weight, (3, 1)))


def test_poses_are_refused_in_the_words_of_the_mechanism(model: pkmodes.Model) -> None:
    found = model.check([[0.1, 0.05], [0.1, 0.25], [np.nan, 0.0]])
    assert found.reason.tolist() == ["", "limits", "finite"]
    sentence = "y is 0.05 m beyond its upper limit; choose a pose within the travel"
    assert found.sentences.tolist()[1] == sentence
    assert repr(found) == "PoseCheck(1 of 3 valid, 1 finite, 1 limits)"
    assert list(model.reasons) == ["finite", "limits"]
    with pytest.raises(PoseError, match=r"pose 0 at \[0.1, 0.25\] m"):
        model.modes([0.1, 0.25])
    with pytest.raises(PoseError, match=r"shape \(2,\) or \(N, 2\), found \(3,\)") as error:
        model.modes([0.1, 0.05, 0.0])
    assert error.match(r"give poses \[x, y\] in metres: tool in the plane")


def test_what_a_mechanism_has_not_says_so(model: pkmodes.Model) -> None:
    np.testing.assert_array_equal(model.inverse_kinematics(POSES), POSES)
    assert model.platform_jacobian(POSES).shape == (3, 2, 2)
    for call in (lambda: model.direct_kinematics([0.1, 0.1], 1), lambda: model.assembly(POSES)):
        with pytest.raises(PkmodesError, match="planar_pair has no direct kinematics"):
            call()


@pytest.mark.parametrize("effects", [{}, CLAMPS])
def test_models_travel_to_other_processes(effects: Mapping[str, float]) -> None:
    """Also for a derived mechanism with effects, whose evaluation holds generated modules."""
    planar = pkmodes.Model(robot(effects))
    twin = pickle.loads(pickle.dumps(planar))
    np.testing.assert_array_equal(twin.frequencies(POSES), planar.frequencies(POSES))
    pickle.loads(pickle.dumps(ExtendedSystem.of(planar.robot)))
    pickle.loads(pickle.dumps(planar.modes(POSES)))


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_a_model_with_effects_works_in_a_pool(method: str) -> None:
    declared = pkmodes.load(Path(__file__).parents[2] / "robots/linear-delta-2022.toml")
    extended = declared.with_values({"effects.gearbox_compliance.compliance": 1e-4})
    poses = np.array([[0.6, 0.0, -0.245], [0.6, 0.03, -0.245]])
    with multiprocessing.get_context(method).Pool(2) as pool:
        found = pool.map(extended.frequencies, poses)
    np.testing.assert_array_equal(found, [extended.frequencies(p) for p in poses])


def test_generated_functions_agree_with_differences() -> None:
    checks = check_consistency(Generated(planar_pair, SAMPLE), KIND, SAMPLE)
    assert len(checks) > 20
    assert [one for one in checks if not one.holds] == []


@pytest.mark.parametrize("name", ["elastic_hessian", "gravity_gradient", "static_equilibrium", "mass_matrix"])
def test_a_wrong_function_is_found(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = getattr(planar_pair, name)

    def wrong(*arguments: object) -> object:
        found = right(*arguments)
        return tuple(1.0001 * part for part in found) if isinstance(found, tuple) else 1.0001 * found

    monkeypatch.setattr(planar_pair, name, wrong)
    assert not all(one.holds for one in check_consistency(Generated(planar_pair, SAMPLE), KIND, SAMPLE))


def test_sensitivities_are_those_of_differences() -> None:
    paths = [
        ParameterPath("tool.mass", 0.7, "kg", {("mass", ()): 1.0}),
        ParameterPath("axis.2.stiffness", 3e4, "N", {("stiffness", (1,)): 1.0}),
        ParameterPath(
            "effects.clamp_compliance.compliance", 0.0, "m/N", {("clamp_compliance.compliance", ()): 1.0}
        ),
        ParameterPath("pose.y", 0.0, "m", {("pose", (1,)): 1.0}),
    ]
    model, system = pkmodes.Model(robot()), ExtendedSystem.of(robot())
    shapes = model.modes(POSES).shapes
    squares = (2.0 * np.pi * model.frequencies(POSES)) ** 2
    found = MatrixDerivatives(system, POSES, [paths]).eigenvalues(squares, shapes)[:, 2:]
    k = SAMPLE.stiffness / (SAMPLE.length + POSES)
    for i, p in enumerate(POSES):
        axis = np.argsort(k[i] * (1.0 / SAMPLE.mass + SAMPLE.radius**2 / SAMPLE.inertia))
        inertia = 1.0 / SAMPLE.mass + (SAMPLE.radius**2 / SAMPLE.inertia)[axis]
        of_second = axis == 1
        np.testing.assert_allclose(found[i, :, 0], -k[i, axis] / SAMPLE.mass**2, rtol=1e-9)
        by_stiffness = of_second * inertia / (SAMPLE.length[1] + p[1])
        np.testing.assert_allclose(found[i, :, 1], by_stiffness, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(found[i, :, 2], -(k[i, axis] ** 2) * inertia, rtol=1e-9)
        by_pose = -1.0 * of_second * inertia * k[i, 1] / (SAMPLE.length[1] + p[1])
        np.testing.assert_allclose(found[i, :, 3], by_pose, rtol=1e-9, atol=1e-3)


def test_measurements_have_the_components_of_the_pose(tmp_path: Path, model: pkmodes.Model) -> None:
    path = tmp_path / "modes.csv"
    f = expected(POSES)
    rows = [
        f"P{i},{1e3 * x},{1e3 * y},{f[i, k] * (1.0 + 0.001 * k)},0.1"
        for i, (x, y) in enumerate(POSES)
        for k in (0, 1)
    ]
    header = "pose,x [mm],y [mm],frequency,sigma"
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    for given in (model, None):  # without a robot, the header determines the components
        data = updating.read(path, robot=given)
        assert data.components == ("x", "y")
        np.testing.assert_allclose(data.points, POSES)
    MeasuredRobot.of(model, data)
    structure = RobotStructure(model.robot, data.points, [], [], {})
    found = diagnosis.compare(structure, data)
    np.testing.assert_allclose([row.predicted for row in found.rows], f.ravel(), rtol=1e-9)
    rates = structure.position_rates(np.empty(0)).rates
    assert rates.shape == (3, 4, 2)
    path.write_text("pose,x,y,z,frequency,sigma\nA,0.1,0.05,0,30,0.1\n", encoding="utf-8")
    with pytest.raises(
        MeasurementError, match=r'"z" is a column of another machine: .* linear_delta or rotary_delta'
    ):
        updating.read(path, robot=model)
    with pytest.raises(MeasurementError, match="expected poses with x and y, found x, y and z"):
        MeasuredRobot.of(model, updating.read(path))
    path.write_text("pose,x,frequency,sigma,shape:x\nA,0.1,30,0.1,1\n", encoding="utf-8")
    with pytest.raises(MeasurementError, match='the column "y" is missing'):
        updating.read(path, robot=model)
    path.write_text("pose,x,y,frequency,sigma\nA,100,50,30,0.1\n", encoding="utf-8")
    with pytest.raises(MeasurementError, match=r"write x \[mm\],y \[mm\] in the header"):
        MeasuredRobot.of(model, updating.read(path, robot=model))


def test_channels_are_the_coordinates_and_the_tool() -> None:
    assert channels(KIND) == {
        **dict.fromkeys(("x", "y"), "m"),
        **dict.fromkeys(("theta_1", "theta_2"), "rad"),
        **dict.fromkeys(("eps_1", "eps_2", "p_x", "p_y"), "m"),
    }


def test_the_measurement_frame_of_a_plane_is_shifted_and_turned_in_it() -> None:
    assert list(frame.parameters(KIND)) == [
        "measurement.offset.x",
        "measurement.offset.y",
        "measurement.yaw",
    ]
    parameters, candidates = frame.suspects(KIND)
    assert [c.name for c in candidates] == [
        p.name.replace("measurement.", "measurement:", 1) for p in parameters
    ]
    values = {"measurement.yaw": np.pi / 2, "measurement.offset.y": 0.1}
    np.testing.assert_allclose(
        frame.true_points(KIND, np.array([[1.0, 0.0]]), values), [[0.0, 1.1]], atol=1e-15
    )
    np.testing.assert_allclose(
        frame.pose_rates(KIND, "measurement.yaw", np.array([[1.0, 0.0]]), values), [[-1.0, 0.0]], atol=1e-15
    )


def test_the_command_line_reads_and_reports_its_poses(model: pkmodes.Model) -> None:
    assert parse_pose("100 mm, 0.05", KIND) == [0.1, 0.05]
    with pytest.raises(PoseError, match="expected 2 components X,Y, found 3") as error:
        parse_pose("0,0,0", KIND)
    assert error.match("write --pose X,Y, decimals with a point: tool in the plane")
    content = as_json(model, model.modes(POSES[0]), model.statics(POSES[0]))
    assert content["pose"] == [0.1, 0.05]
    assert content["joint_positions"] == {"x": 0.1, "y": 0.05}
    assert np.shape(content["platform_shapes"]) == (4, 2)
    assert "carriage_positions" not in content
