"""Status, natural frequencies and modes in the NumPy module of a robot are those of the runtime."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.generated.generated_robots import Robot


def test_the_status_says_why_as_the_runtime_does(robot: Robot) -> None:
    poses = robot.poses(2000)
    poses[::100, 0] = np.nan
    poses[50, -1] = np.inf
    expected = robot.model.check(poses).codes
    np.testing.assert_array_equal(robot.module.status(poses), expected)
    assert robot.module.status(poses[0]) == expected[0] == robot.module.NOT_FINITE
    assert len(robot.module.STATUSES) == len(robot.model.reasons) + 1
    assert len(robot.module.POSE) == len(robot.box[0])


def test_modes_are_those_of_the_runtime(robot: Robot) -> None:
    valid = robot.valid(40)
    found = robot.model.modes(valid, backend="numpy")
    f, phi = robot.module.modes(valid)
    rigid = robot.module.RIGID_MODES
    np.testing.assert_allclose(f[:, rigid:], found.frequencies[:, rigid:], rtol=1e-9)
    np.testing.assert_array_equal(robot.module.natural_frequencies(valid), f)
    assert (np.diff(f, axis=-1) >= 0.0).all()
    M, K = robot.module.modal_matrices(valid)
    n = f.shape[-1]
    np.testing.assert_allclose(
        phi @ M @ np.swapaxes(phi, 1, 2), np.broadcast_to(np.eye(n), M.shape), atol=1e-10
    )
    eigenvalues = np.sign(f) * (2.0 * np.pi * f) ** 2
    left = phi @ K @ np.swapaxes(phi, 1, 2)
    right = eigenvalues[:, :, None] * np.eye(n)
    assert (np.abs(left - right) < 1e-10 * eigenvalues[:, -1, None, None]).all()


@pytest.mark.compiler
def test_signs_are_those_of_the_c_code(robot: Robot) -> None:
    """Also at symmetric poses, where components are equal and rounding must not decide."""
    poses = robot.valid(200)
    symmetric = poses * [1.0, 0.0, 1.0][: poses.shape[-1]]
    symmetric = symmetric[robot.module.status(symmetric) == 0]
    for p in (*poses[:20], *symmetric):
        f, phi = robot.module.modes(p)
        _, _, shapes, _ = robot.double.modes(p)
        apart = np.abs(np.diff(f, prepend=-1e9, append=1e9)) > 1e-2 * f[-1]
        alike = apart[:-1] & apart[1:]
        np.testing.assert_allclose(shapes[alike], phi[alike], rtol=0, atol=1e-8 * np.abs(phi).max())


def test_invalid_poses_have_nan_and_leave_the_others_alone(robot: Robot) -> None:
    poses = robot.poses(60).reshape(3, 20, -1)
    poses[1, 5] = np.nan
    status = robot.module.status(poses)
    f, phi = robot.module.modes(poses)
    assert status.shape == (3, 20)
    assert phi.shape == (*f.shape, f.shape[-1])
    np.testing.assert_array_equal(np.isnan(f).all(axis=-1), status != 0)
    np.testing.assert_array_equal(np.isnan(phi).any(axis=(-1, -2)), status != 0)
    at = tuple(np.argwhere(status == 0)[0])
    np.testing.assert_allclose(robot.module.modes(poses[at])[0], f[at], rtol=0, atol=1e-9 * f[at][-1])


def test_no_poses_give_no_modes(robot: Robot) -> None:
    d, n = len(robot.box[0]), len(robot.module.COORDINATES)
    f, phi = robot.module.modes(np.empty((0, d)))
    assert (f.shape, phi.shape) == ((0, n), (0, n, n))
    with pytest.raises(ValueError, match="expected an array of shape"):
        robot.module.status(np.zeros(d + 1))
