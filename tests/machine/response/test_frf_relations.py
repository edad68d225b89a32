"""What frequency responses have to do with each other: other motors, poses, back ends, quantities and directions."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

import numpy as np
import pytest

from helpers.references.response_in_40_digits import frequencies_of, ports, size_of
from helpers.robots.damped_robots import DAMPED, DAMPING, DRIVES
from helpers.robots.one_of_each import FILES, POSES, model_of


@pytest.mark.parametrize("mechanism", FILES)
def test_forces_and_displacements_may_be_exchanged(subtests: pytest.Subtests, mechanism: str) -> None:
    """Motion a per force b is motion b per force a, of platform and free motors, to 1e-12 of the largest."""
    for case, drives in product(DAMPED, DRIVES):
        with subtests.test(f"{case}, {drives}"):
            effects, ratio = DAMPED[case]
            model, p = model_of(mechanism, effects, ratio=ratio), POSES[mechanism]
            directions = model.mechanism.directions
            inputs, outputs = [f"force_{d}" for d in directions], [f"p_{d}" for d in directions]
            if drives == "free":
                for drive in model.mechanism.drives:
                    inputs.append(f"torque_{drive.name}")
                    outputs.append(f"motor_{drive.name}")
            H = model.frf(p, frequencies_of(model, p, drives), inputs, outputs, drives=drives).values
            own = np.sqrt(np.abs(np.einsum("fii->fi", H)))
            size = (own[:, :, None] * own[:, None, :]).max(axis=0)
            assert (np.abs(H - np.swapaxes(H, 1, 2)).max(axis=0) / size).max() < 1e-12


@pytest.mark.parametrize(
    "values",
    [
        {"motor.inertia": 3.0, "motor.gear_ratio": 7.0},
        {"effects.servo_stiffness.stiffness": 1e10},
        {"effects.drive_friction.viscous": 1e2},
    ],
)
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_what_acts_on_a_held_motor_has_no_influence(mechanism: str, values: Mapping[str, float]) -> None:
    """With a gearbox that winds up, too: inertia, servo and friction of the motor are behind it."""
    effects = {**DAMPING, "gearbox_compliance.compliance": 2e-3}
    model, p = model_of(mechanism, effects, ratio=0.01), POSES[mechanism]
    inputs, outputs, *_ = ports(model, "held", p)
    at = frequencies_of(model, p, "held")
    plain = model.frf(p, at, inputs, outputs, drives="held")
    other = model.with_values(values).frf(p, at, inputs, outputs, drives="held")
    sizes = size_of(plain.values, plain.units)
    error = np.abs(other.values - plain.values) / np.where(sizes == 0.0, 1.0, sizes)
    assert error.max() < 1e-10


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("mechanism", FILES)
def test_a_batch_has_the_responses_of_its_poses_with_both_back_ends(mechanism: str, drives: str) -> None:
    effects, ratio = DAMPED["many"]
    model, p = model_of(mechanism, effects, ratio=ratio), POSES[mechanism]
    poses = np.stack([[p, p + 0.01], [p - 0.02, p + 9.0]])
    inputs, outputs, *_ = ports(model, drives, p)
    at = frequencies_of(model, p, drives)
    found = [
        model.frf(poses, at, inputs, outputs, drives=drives, on_error="nan", backend=backend).values
        for backend in ("numpy", "auto")
    ]
    alone = model.frf(poses[0, 1], at, inputs, outputs, drives=drives)
    sizes = size_of(alone.values, alone.units)
    scale = np.where(sizes == 0.0, 1.0, sizes)
    for values in found:
        assert values.shape == (2, 2, len(at), len(outputs), len(inputs))
        assert values.dtype == np.complex128
        assert np.abs((values[0, 1] - alone.values) / scale).max() < 1e-10
        assert np.isfinite(values[1, 0]).all()
    assert np.abs((found[0] - found[1])[0] / scale).max() < 1e-10


def test_a_pose_that_cannot_be_evaluated_is_nan_in_both_parts() -> None:
    """Its imaginary part is no response of 0 either."""
    found = model_of("corexy", {}, ratio=0.02).frf(
        [[0.1, 0.05], [9, 9]], [10.0], ["force_x"], ["p_x"], on_error="nan"
    )
    assert found.valid.tolist() == [True, False]
    assert np.isnan(found.values[1].real).all()
    assert np.isnan(found.values[1].imag).all()


@pytest.mark.parametrize("drives", DRIVES)
def test_velocities_and_accelerations_are_derivatives_of_displacements(drives: str) -> None:
    effects, ratio = DAMPED["gearbox"]
    model, p = model_of("linear_delta", effects, ratio=ratio), POSES["linear_delta"]
    f = np.array([3.0, 27.0, 200.0])
    inputs, outputs, *_ = ports(model, drives, p)
    x, v, a = (
        model.frf(p, f, inputs, outputs, drives=drives, quantity=quantity)
        for quantity in ("displacement", "velocity", "acceleration")
    )
    s = 2j * np.pi * f[:, None, None]
    np.testing.assert_allclose(v.values, s * x.values, rtol=1e-14)
    np.testing.assert_allclose(a.values, s**2 * x.values, rtol=1e-14)
    assert (x.units[0][0], v.units[0][0], a.units[0][0]) == ("m/N", "m/s/N", "m/s^2/N")
    assert a.quantity == "acceleration"
    assert a.drives == drives


def test_a_direction_is_the_projection_of_the_platform() -> None:
    """Normalised, and absolute: with the frame that moves, which the coordinates are relative to."""
    model, p = model_of("corexy", {"frame_compliance.compliance": 1e-5}, ratio=0.02), POSES["corexy"]
    outputs = ["p_x", "p_y", {"oblique": [3.0, 4.0]}, "x", "y", "u_x", "u_y"]
    values = model.frf(p, [5.0, 20.0, 90.0], ["force_x", "force_y"], outputs, drives="held").values
    p_x, p_y, oblique, x, y, u_x, u_y = np.moveaxis(values, 1, 0)
    np.testing.assert_allclose(oblique, 0.6 * p_x + 0.8 * p_y, rtol=1e-12, atol=1e-20)
    np.testing.assert_allclose(p_x, x + u_x, rtol=1e-10, atol=1e-12 * np.abs(p_x).max())
    np.testing.assert_allclose(p_y, y + u_y, rtol=1e-10, atol=1e-12 * np.abs(p_y).max())
