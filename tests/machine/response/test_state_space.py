"""State space models against frequency responses, static solutions, and integrations by SciPy."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from scipy.signal import dlsim, lsim

import pkmodes
from helpers.robots.one_of_each import ROBOTS
from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.response.state_space import StateSpace

ROOT = Path(__file__).parents[3]

MECHANISMS = {
    "linear_delta": ("linear-delta-2022.toml", [0.6, 0.05, -0.245]),
    "rotary_delta": ("clavel-delta.toml", [0.03, 0.02, -0.45]),
    "corexy": ("corexy-printer.toml", [0.02, 0.05]),
}
CASES = {
    "plain": {},
    "friction": {"drive_friction.viscous": 2e-3},
    "gearbox": {"gearbox_compliance.compliance": 2e-3, "drive_friction.viscous": 2e-3},
    "frame": {"frame_compliance.compliance": 1e-7, "frame_compliance.mass": 40.0},
    "clamp": {"clamp_compliance.compliance": 1e-7},
}
FREQUENCIES = np.geomspace(1.0, 600.0, 160)


def model_of(mechanism: str, case: str, **values: float) -> tuple[pkmodes.Model, list[float]]:
    file, pose = MECHANISMS[mechanism]
    model = pkmodes.load(ROBOTS / file)
    known = model.mechanism.effects
    effects = {f"effects.{k}": v for k, v in CASES[case].items() if k.split(".")[0] in known}
    return model.with_values({"damping.ratio": 0.02, **effects, **values}), pose


def ports(model: pkmodes.Model, drives: str) -> tuple[list[str], list[str]]:
    mechanism = model.mechanism
    drive = "motor_" if drives == "held" else "torque_"
    inputs = [f"{drive}{mechanism.drives[0].name}", f"force_{mechanism.directions[-1]}"]
    return inputs, [*(f"p_{name}" for name in mechanism.directions), model.coordinates[0]]


def at_frequencies(system: StateSpace, frequencies: np.ndarray) -> np.ndarray:
    """Return C (s - A)^-1 B + D for every frequency."""
    identity = np.eye(len(system.A))
    return np.array(
        [
            system.C @ np.linalg.solve(2j * np.pi * f * identity - system.A, system.B) + system.D
            for f in frequencies
        ]
    )


def assert_channels(found: np.ndarray, expected: np.ndarray, tolerance: float) -> None:
    """Compare channels to a part of the peak of each, or of a thousandth of the largest."""
    peak = np.abs(expected).max(axis=0)
    scale = np.maximum(peak, 1e-3 * peak.max(axis=0))
    assert (np.abs(found - expected).max(axis=0) <= tolerance * scale).all()


@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_all_modes_give_the_frequency_responses(subtests: pytest.Subtests, mechanism: str) -> None:
    for case, drives in product(CASES, ["free", "held"]):
        with subtests.test(f"{case}, {drives}"):
            model, pose = model_of(mechanism, case)
            inputs, outputs = ports(model, drives)
            system = model.state_space(pose, inputs, outputs, drives=drives)
            expected = model.frf(pose, FREQUENCIES, inputs, outputs, drives=drives).values
            assert_channels(at_frequencies(system, FREQUENCIES), expected, 1e-10)


@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_residual_flexibility_thirds_the_error_of_omitted_modes(mechanism: str) -> None:
    """Below half the frequency of the first omitted mode.

    What a prescribed motion does to omitted modes through inertia is no static contribution; it is below 1e-5 here.
    """
    model, pose = model_of(mechanism, "gearbox")
    inputs, outputs = ports(model, "held")
    every = model.frequencies(pose, drives="held")
    kept = 2
    frequencies = np.linspace(1.0, every[kept] / 2, 200)
    exact = model.frf(pose, frequencies, inputs, outputs, drives="held").values
    errors = [
        np.abs(at_frequencies(system, frequencies) - exact).max(axis=0)
        for system in (
            model.state_space(pose, inputs, outputs, drives="held", modes=kept, residual=residual)
            for residual in (True, False)
        )
    ]
    assert (errors[0] <= errors[1] / 3 + np.array([1e-5, 1e-12]) * np.abs(exact).max(axis=0)).all()
    system = model.state_space(pose, inputs, outputs, drives="held", modes=kept)
    np.testing.assert_allclose(system.frequencies, every[:kept], rtol=1e-12)
    static = system.D - system.C @ np.linalg.solve(system.A, system.B)
    exact = model.frf(pose, [0.0], inputs, outputs, drives="held").values[0].real
    assert np.abs(static - exact).max() < 1e-10 * np.abs(exact).max()


def test_velocities_and_accelerations_are_derivatives() -> None:
    model, pose = model_of("linear_delta", "gearbox")
    inputs, outputs = ["torque_1", "force_x"], ["p_x", "psi_1"]
    for quantity in ("velocity", "acceleration"):
        system = model.state_space(pose, inputs, outputs, quantity=quantity)
        expected = model.frf(pose, FREQUENCIES, inputs, outputs, quantity=quantity).values
        assert_channels(at_frequencies(system, FREQUENCIES), expected, 1e-9)
    assert system.units[0] == ("m/s^2/(N m)", "m/s^2/N")


def test_what_needs_a_derivative_of_the_input_is_refused() -> None:
    model, pose = model_of("linear_delta", "gearbox")
    with pytest.raises(PkmodesError, match="motor_1 follows motor_1 at once") as error:
        model.state_space(pose, ["motor_1"], ["motor_1"], drives="held", quantity="velocity")
    assert "displacement" in str(error.value)


def test_poses_are_the_leading_axes() -> None:
    model, pose = model_of("corexy", "gearbox")
    poses = np.array([[[0.02, 0.05], [0.0, 0.0], [9.0, 0.0]]])
    many = model.state_space(poses, ["motor_1"], ["p_x"], drives="held", modes=2, on_error="nan")
    one = model.state_space(pose, ["motor_1"], ["p_x"], drives="held", modes=2)
    assert many.A.shape == (1, 3, 4, 4)
    np.testing.assert_array_equal(many.A[0, 0], one.A)
    assert np.isnan(many.A[0, 2]).all()
    assert many.valid.tolist() == [[True, True, False]]
    assert np.isnan(many.discretized(1e-3).A[0, 2]).all()


def test_discretized_models_are_exact_between_ticks() -> None:
    """Held inputs give the same samples as the continuous model, integrated with steps a hundred times as fine."""
    model, pose = model_of("linear_delta", "plain")
    system = model.state_space(pose, ["motor_1", "motor_2"], ["p_x", "p_z"], drives="held", modes=3)
    discrete = system.discretized(1e-3)
    commands = np.random.default_rng(5).normal(size=(80, 2))
    _, samples, _ = dlsim(discrete.at(), commands)
    time = np.arange(80 * 100) * 1e-5
    _, fine, _ = lsim(system.at(), np.repeat(commands, 100, axis=0), time, interp=False)
    np.testing.assert_allclose(samples, fine[::100], rtol=0, atol=1e-8 * np.abs(fine).max())


def test_modes_above_half_the_sampling_rate_are_refused() -> None:
    model, pose = model_of("linear_delta", "plain")
    system = model.state_space(pose, ["motor_1"], ["p_x"], drives="held")
    with pytest.raises(PkmodesError, match="above half the sampling rate, 125 Hz"):
        system.discretized(4e-3)
    with pytest.raises(PkmodesError, match="discrete already"):
        system.discretized(1e-3).discretized(1e-3)
    for tick in (0.0, -1.0, np.nan, "1 ms", None):
        with pytest.raises(PkmodesError, match="period"):
            system.discretized(tick)  # type: ignore[arg-type]


@pytest.mark.parametrize("modes", [0, 7, 2.5, True, "3"])
def test_impossible_numbers_of_modes_are_refused(modes: object) -> None:
    model, pose = model_of("linear_delta", "plain")
    with pytest.raises(PkmodesError, match="from 1 to 6"):
        model.state_space(pose, ["motor_1"], ["p_x"], drives="held", modes=modes)  # type: ignore[arg-type]


@pytest.mark.parametrize("index", [(), 2, (0, 0), "first", 1.5])
def test_an_index_selects_one_pose(index: object, tmp_path: Path) -> None:
    model, pose = model_of("linear_delta", "plain")
    poses = np.array([pose, pose])
    system = model.state_space(poses, ["motor_1"], ["p_x"], drives="held")
    response = model.frf(poses, [10.0], ["motor_1"], ["p_x"], drives="held")
    for take in (
        system.at,
        lambda i: system.to_mat(tmp_path / "a.mat", i),
        lambda i: response.to_csv(tmp_path / "a.csv", i),
    ):
        with pytest.raises(PkmodesError, match="index of one of the poses"):
            take(index)  # type: ignore[arg-type]
    assert not [*tmp_path.iterdir()]


def test_a_pose_that_cannot_be_evaluated_has_no_system() -> None:
    model, pose = model_of("linear_delta", "plain")
    system = model.state_space([pose, [9.0, 9.0, 9.0]], ["motor_1"], ["p_x"], drives="held", on_error="nan")
    assert system.at(0).A.shape == (12, 12)
    with pytest.raises(PkmodesError, match="could not be evaluated"):
        system.at(1)


def test_rigid_modes_are_kept() -> None:
    model, pose = model_of("linear_delta", "plain")
    with pytest.raises(PkmodesError, match=r"from 3 to 9.*rigid"):
        model.state_space(pose, ["torque_1"], ["p_x"], modes=2)


def test_other_programs_get_the_same_model(tmp_path: Path) -> None:
    control = pytest.importorskip("control")
    model, pose = model_of("linear_delta", "plain")
    system = model.state_space(pose, ["motor_1"], ["p_x", "p_z"], drives="held", modes=3)
    of_control = system.to_control()
    assert isinstance(of_control, control.StateSpace)
    assert of_control.input_labels == ["motor_1"]
    assert of_control.output_labels == ["p_x", "p_z"]
    response = model.frf(pose, FREQUENCIES, ["motor_1"], ["p_x", "p_z"], drives="held")
    there = response.to_control()
    np.testing.assert_array_equal(there.frdata[:, 0, :], response.values[:, :, 0].T)
    np.testing.assert_allclose(there.omega, 2 * np.pi * FREQUENCIES)
    assert system.discretized(1e-3).to_control().dt == 1e-3
    system.to_mat(tmp_path / "delta.mat")
    read = loadmat(tmp_path / "delta.mat")
    for name in "ABCD":
        np.testing.assert_array_equal(read[name], getattr(system, name))
    assert [str(cell[0]) for cell in read["outputs"].ravel()] == ["p_x", "p_z"]
    np.testing.assert_array_equal(read["pose"].ravel(), pose)
    assert str(read["units"][0, 0][0]) == "m/rad"


@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_compliance_is_the_response_at_0_hz(mechanism: str) -> None:
    model, pose = model_of(mechanism, "gearbox")
    names = model.mechanism.directions
    forces, outputs = [f"force_{n}" for n in names], [f"p_{n}" for n in names]
    expected = model.frf(pose, [0.0], forces, outputs, drives="held").values[0]
    found = model.compliance([pose, pose])
    assert found.shape == (2, len(names), len(names))
    assert np.abs(found - expected).max() < 1e-10 * np.abs(expected).max()
    np.testing.assert_array_equal(found, np.swapaxes(found, -1, -2))
    assert (np.linalg.eigvalsh(found[0]) > 0.0).all()


def test_compliance_of_a_corexy_is_that_of_its_belts() -> None:
    """By hand: each belt has two runs of stiffness w k_sp / length that a motion along its direction strains."""
    model = pkmodes.load(ROBOTS / "corexy-printer.toml")
    p, robot = np.array([0.02, 0.05]), model.robot.parameters
    K = np.zeros((2, 2))
    for j in range(2):
        g = np.asarray(robot.belt_path_direction[j])
        lengths = np.asarray(robot.belt_path_lengths[j]) + np.array([1.0, -1.0]) * (g @ p)
        stiffness = (robot.belt_width[j] * robot.belt_specific_stiffness[j] / lengths).sum()
        K += stiffness * np.outer(g, g)
    np.testing.assert_allclose(model.compliance(p), np.linalg.inv(K), rtol=1e-12)


def test_the_largest_velocity_gain_of_the_page_is_where_the_loop_becomes_unstable() -> None:
    """The Nyquist curve of the frequency response, with the delay as it is, passes through -1."""
    control = pytest.importorskip("control")
    model = pkmodes.load(ROOT / "robots/linear-delta-2022-identified.toml").with_values(
        {"damping.ratio": 0.01}
    )
    for pose, gain in (([1.2, 0.1, -0.24], 0.793), ([0.32, 0.0, -0.24], 2.829)):
        f = np.arange(100.0, 1500.0, 0.01)
        mobility = model.frf(pose, f, ["torque_1"], ["motor_1"], quantity="velocity").values[:, 0, 0]
        loop = mobility * np.exp(-2j * np.pi * f * 1e-3)
        at = np.flatnonzero((np.diff(np.sign(loop.imag)) != 0.0) & (loop.real[1:] < 0.0))
        assert -1.0 / loop.real[at].min() == pytest.approx(gain, rel=2e-3)
        # Just below and above it: poles of the closed loop, with a delay that is exact far beyond these frequencies.
        system = model.state_space(pose, ["torque_1"], ["motor_1"], quantity="velocity").to_control()
        delay = control.tf(*control.pade(1e-3, 8))
        rigid = 10.0  # 1/s: far below the vibrations
        for factor, stable in ((0.98, True), (1.02, False)):
            poles = control.feedback(delay * system, factor * gain).poles()
            assert (poles.real[np.abs(poles) > rigid].max() < 0.0) == stable
