"""The evaluator: array shapes, units, signs and bad poses."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes
from pkmodes.core.base.errors import PoseError
from pkmodes_generated import linear_delta

pytestmark = pytest.mark.usefixtures("backend")

POSE = np.array([0.6, 0.03, -0.245])


def test_modes_solve_the_eigenproblem_of_the_generated_matrices(model: pkmodes.Model) -> None:
    result = model.modes(POSE)
    M, K = linear_delta.modal_matrices(POSE, model.robot.parameters)
    eigenvalues = eigh(K, M, eigvals_only=True)
    expected = np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2 * np.pi)
    np.testing.assert_allclose(result.frequencies[3:], expected[3:], rtol=1e-12)
    np.testing.assert_array_equal(result.mass_matrix, M)
    np.testing.assert_array_equal(result.stiffness_matrix, K)


def test_shapes_are_mass_normalised_and_projected_with_the_platform_jacobian(model: pkmodes.Model) -> None:
    result = model.modes(POSE)
    identity = result.shapes @ result.mass_matrix @ result.shapes.T
    np.testing.assert_allclose(identity, np.eye(9), rtol=0, atol=1e-12)
    D_p = linear_delta.platform_jacobian(POSE, model.robot.parameters)
    for i in range(9):
        np.testing.assert_allclose(result.platform_shapes[i], D_p @ result.shapes[i, :3], rtol=0, atol=1e-14)


def test_three_rigid_modes_come_first(model: pkmodes.Model) -> None:
    result = model.modes(POSE)
    assert result.rigid_modes == 3
    assert np.all(np.diff(result.frequencies) >= 0)
    # Only gravity acts on the rigid-body modes: a pendulum of some decimetres is below 2 Hz.
    assert np.all(np.abs(result.frequencies[:3]) < 2.0)
    assert result.frequencies[3] > 20.0


def test_a_batch_equals_its_poses_one_by_one(model: pkmodes.Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pkmodes.core.solve.batch.CHUNK", 7)  # several chunks, the last one not full
    rng = np.random.default_rng(3)
    poses = POSE + rng.uniform(-0.02, 0.02, size=(4, 5, 3))
    batch = model.modes(poses)
    assert batch.frequencies.shape == (4, 5, 9)
    assert batch.shapes.shape == (4, 5, 9, 9)
    assert batch.platform_shapes.shape == (4, 5, 9, 3)
    assert batch.carriage_positions.shape == (4, 5, 3)
    assert batch.valid.shape == (4, 5)
    for index in np.ndindex(4, 5):
        one = model.modes(poses[index])
        np.testing.assert_allclose(batch.frequencies[index][3:], one.frequencies[3:], rtol=1e-12)
        np.testing.assert_allclose(batch.shapes[index], one.shapes, rtol=0, atol=1e-9)
        np.testing.assert_allclose(batch.carriage_positions[index], one.carriage_positions, rtol=1e-14)
    M, K = model.matrices(poses)
    np.testing.assert_array_equal(M, batch.mass_matrix)
    np.testing.assert_array_equal(K, batch.stiffness_matrix)


def test_kinematics_go_both_ways(model: pkmodes.Model) -> None:
    x = model.inverse_kinematics(POSE)
    assembly = int(model.assembly(POSE))
    np.testing.assert_allclose(model.direct_kinematics(x, assembly), POSE, rtol=0, atol=1e-14)
    mirrored = model.direct_kinematics(x, -assembly)
    assert mirrored[2] == pytest.approx(0.245)  # rails in the plane z = 0: the other assembly is above it


def test_torques_balance_the_weight_by_virtual_work(model: pkmodes.Model) -> None:
    """Raising the platform by dz, with the carriages following, does the same work as the torques."""
    statics = model.statics(POSE)
    dz = 1e-6
    up, down = (model.inverse_kinematics(POSE + [0, 0, s * dz]) for s in (1, -1))
    dx = (up - down) / 2
    radius = model.robot.parameters.pulley_radius
    work = statics.torques @ (dx / radius)
    # Platform and half of each linkage rise by dz; the carriages and the other halves stay on level rails.
    weight = 9.81 * (1.5 + 3 * 0.7 / 2)
    assert work == pytest.approx(weight * dz, rel=1e-9)


BAD_POSES = [
    ([0.6, 0.0, 0.9], "out of reach: link"),
    ([0.6, 0.0, 0.0], "singular: the condition number of D_l is inf"),
    ([0.6, 0.0, -1e-9], "singular: the condition number of D_l is"),
    (
        [0.1, 0.0, -0.245],
        "carriage 2 is beyond its limits: the belt span between its carriage and pulley 2",
    ),
    (
        [1.1, 0.0, -0.245],
        "carriage 1 is beyond its limits: the belt span between its carriage and pulley 1",
    ),
    ([np.nan, 0.0, -0.245], "finite"),
    ([np.inf, 0.0, -0.245], "finite"),
    ([], "shape"),
    (np.empty((0, 3)), "at least one pose"),
    ([0.6, 0.0], "shape"),
    (0.6, "shape"),
    ([[0.6, 0.0], [1.0]], "array of numbers"),
    (["a", "b", "c"], "array of numbers"),
    ([1j, 0, 0], "array of numbers"),
    (None, "array of numbers"),
]


def test_bad_poses_are_refused(subtests: pytest.Subtests, model: pkmodes.Model) -> None:
    for poses, what in BAD_POSES:
        with subtests.test(poses=poses):
            for method in (
                model.modes,
                model.matrices,
                model.statics,
                model.platform_jacobian,
                model.inverse_kinematics,
            ):
                with pytest.raises(PoseError, match=what):
                    method(poses)


def test_the_message_names_the_first_bad_pose_and_counts_them(model: pkmodes.Model) -> None:
    with pytest.raises(
        PoseError, match=r"pose 1 at \[9, 9, 9\] m, the first of 2 bad poses.*on_error"
    ) as error:
        model.modes([POSE, [9, 9, 9], POSE, [0.6, 0, 0]])
    assert error.value.index == 1


def test_bad_poses_come_back_as_nan_when_asked(model: pkmodes.Model) -> None:
    poses = [POSE, [9, 9, 9], [np.nan, 0, 0], [0.6, 0, 0], [0.1, 0, -0.245]]
    result = model.modes(poses, on_error="nan")
    assert result.valid.tolist() == [True, False, False, False, False]
    np.testing.assert_array_equal(result.frequencies[0], model.modes(POSE).frequencies)
    assert np.isnan(result.frequencies[1:]).all()
    assert np.isnan(result.shapes[1:]).all()
    assert result.rigid_modes == 3
    assert model.statics(poses, on_error="nan").valid.sum() == 1
    assert not model.modes([9, 9, 9], on_error="nan").valid
    with pytest.raises(PoseError, match="on_error"):
        model.modes(POSE, on_error="ignore")


def test_a_pose_at_the_limit_has_a_zero_span_and_is_refused(model: pkmodes.Model) -> None:
    """Carriage 1 is 0.316... m ahead of the platform on the centre line."""
    ahead = np.sqrt(0.4**2 - 0.245**2)
    at_limit = [1.2 - ahead, 0.0, -0.245]
    with pytest.raises(PoseError, match="carriage 1 is beyond its limits"):
        model.modes(np.array(at_limit) + [1e-12, 0, 0])
    assert model.modes(np.array(at_limit) - [1e-6, 0, 0]).valid


def test_carriages_that_do_not_assemble_are_refused(model: pkmodes.Model) -> None:
    with pytest.raises(PoseError, match="do not meet"):
        model.direct_kinematics([0.0, 1.2, 0.0], 1)
    with pytest.raises(PoseError, match="assembly"):
        model.direct_kinematics([0.5, 0.5, 0.5], 0)
    with pytest.raises(PoseError, match="shape"):
        model.direct_kinematics([0.5, 0.5], 1)


def test_a_massless_structure_is_an_error_of_the_robot(model: pkmodes.Model) -> None:
    parameters = model.robot.parameters._replace(
        platform_mass=0.0, link_mass=np.zeros(3), carriage_mass=np.zeros(3)
    )
    with pytest.raises(PoseError, match="not positive definite"):
        pkmodes.Model(replace(model.robot, parameters=parameters)).modes(POSE)
