"""Invariants of every robot, whatever its numbers: closed kinematics, symmetries, rigid-body modes.

No formula of the model is repeated here but for two robots with a solution in closed form.  The tests turn, move,
mirror or relabel a robot, and ask that its matrices follow.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import scipy.linalg
from scipy.spatial.transform import Rotation

from helpers.robots.sample_robots import RANDOM, SAMPLES, Sample, published, sample, tower_printer
from pkmodes_generated.linear_delta import Parameters, model

# Each side of an identity errs by at most 1e-14 for each unit of the condition number of D_l, below 12 here
# (test_generated_oracle); moving a robot rounds its coordinates once more.
SAME = 5e-13
IDS: dict[str, Any] = {"ids": str}


def assert_same(found: Any, expected: Any) -> None:
    """Check equality to rounding, each entry of a 9 by 9 matrix relative to its diagonal entries."""
    found, expected = np.asarray(found), np.asarray(expected)
    size: Any = np.max(np.abs(expected))
    if expected.shape == (9, 9):
        diagonal = np.sqrt(np.diag(expected))
        size = np.outer(diagonal, diagonal)
    assert found.shape == expected.shape
    assert np.max(np.abs(found - expected) / size) < SAME


def frequencies(robot: Sample) -> np.ndarray:
    """Squared angular frequencies, ascending."""
    M, K = model.modal_matrices(robot.pose, robot.parameters)
    return scipy.linalg.eigh(K, M, eigvals_only=True)


def linkages(p: np.ndarray, x: np.ndarray, q: Parameters) -> np.ndarray:
    return p + q.joint - (q.origin + x[:, None] * q.direction)


def assembled(name: str) -> tuple[np.ndarray, Parameters, np.ndarray, np.float64]:
    """Return pose, parameters and carriages of a sample robot, and the sign of the volume that its linkages span."""
    p, q = sample(name).pose, sample(name).parameters
    x = model.inverse_kinematics(p, q)
    return p, q, x, np.sign(np.linalg.det(linkages(p, x, q)))


# Kinematics


def test_direct_kinematics_undoes_inverse_in_the_same_assembly(subtests: pytest.Subtests) -> None:
    for name in SAMPLES:
        with subtests.test(name=name):
            p, q, x, assembly = assembled(name)
            # 1e-12 m: a picometre, for poses within a metre of the origin
            np.testing.assert_allclose(model.direct_kinematics(x, assembly, q), p, rtol=0, atol=1e-12)


def test_other_assembly_closes_too_and_has_the_other_sign(subtests: pytest.Subtests) -> None:
    for name in SAMPLES:
        with subtests.test(name=name):
            _, q, x, assembly = assembled(name)
            other = model.direct_kinematics(x, -assembly, q)
            s = linkages(other, x, q)
            np.testing.assert_allclose(np.linalg.norm(s, axis=-1), q.link_length, rtol=1e-12)
            assert np.sign(np.linalg.det(s)) == -assembly
            # and back, on the branches that this assembly has
            branch = -np.sign(np.sum(s * q.direction, axis=-1))
            back = model.inverse_kinematics(other, q._replace(branch=branch))
            np.testing.assert_allclose(
                back, x, rtol=0, atol=1e-11
            )  # x(p) is steep where a linkage is square to its rail


def test_each_branch_puts_the_carriage_on_its_side(subtests: pytest.Subtests) -> None:
    for name in SAMPLES:
        with subtests.test(name=name):
            p, q = sample(name).pose, sample(name).parameters
            for branch in (q.branch, -q.branch):
                x = model.inverse_kinematics(p, q._replace(branch=branch))
                s = linkages(p, x, q)
                np.testing.assert_allclose(np.linalg.norm(s, axis=-1), q.link_length, rtol=1e-12)
                np.testing.assert_array_equal(np.sign(-np.sum(s * q.direction, axis=-1)), branch)


# Changes of frame and of names


def test_turning_and_moving_the_base_frame_changes_no_matrix(subtests: pytest.Subtests) -> None:
    for name in SAMPLES:
        with subtests.test(name=name):
            robot = sample(name)
            q = robot.parameters
            turn = Rotation.random(rng=np.random.default_rng(2)).as_matrix()
            shift = np.array([0.3, -0.2, 0.4])
            moved = q._replace(
                gravity=turn @ q.gravity,
                origin=q.origin @ turn.T + shift,
                direction=q.direction @ turn.T,
                joint=q.joint @ turn.T,
            )
            p = turn @ robot.pose + shift
            for found, expected in zip(
                model.modal_matrices(p, moved), model.modal_matrices(robot.pose, q), strict=True
            ):
                assert_same(found, expected)
            assert_same(model.platform_jacobian(p, moved), turn @ model.platform_jacobian(robot.pose, q))
            x_dot = np.array([0.7, -0.4, 0.9])
            assert_same(model.velocity_forces(p, x_dot, moved), model.velocity_forces(robot.pose, x_dot, q))
            for found, expected in zip(
                model.static_equilibrium(p, moved), model.static_equilibrium(robot.pose, q), strict=True
            ):
                assert_same(found, expected)


def test_counting_a_rail_from_its_other_end_only_renames(subtests: pytest.Subtests) -> None:
    """Direction, coordinate, branch and limits change sign, and with them the pulleys exchange names."""
    for name in SAMPLES:
        with subtests.test(name=name):
            robot = sample(name)
            q = robot.parameters
            turned = q._replace(
                direction=-q.direction,
                branch=-q.branch,
                limits=-q.limits[:, ::-1],
                drive=q.drive[:, ::-1],
            )
            order = [0, 1, 2, 6, 7, 8, 3, 4, 5]
            for found, expected in zip(
                model.modal_matrices(robot.pose, turned), model.modal_matrices(robot.pose, q), strict=True
            ):
                # every coordinate changes sign, which cancels in a quadratic form
                assert_same(found, expected[np.ix_(order, order)])
            torques, theta = model.static_equilibrium(robot.pose, q)
            torques_turned, theta_turned = model.static_equilibrium(robot.pose, turned)
            assert_same(torques_turned, -torques)
            assert_same(theta_turned, -theta[[3, 4, 5, 0, 1, 2]])


def test_order_of_the_axes_does_not_matter(subtests: pytest.Subtests) -> None:
    for name in RANDOM:
        with subtests.test(name=name):
            robot = sample(name)
            order = np.array([2, 0, 1])
            per_axis = {
                field: value[order]
                for field, value in robot.parameters._asdict().items()
                if field not in ("platform_mass", "gravity")
            }
            renamed = robot.parameters._replace(**per_axis)
            nine = np.concatenate([order, order + 3, order + 6])
            for found, expected in zip(
                model.modal_matrices(robot.pose, renamed),
                model.modal_matrices(robot.pose, robot.parameters),
                strict=True,
            ):
                assert_same(found, expected[np.ix_(nine, nine)])


# Symmetries


@pytest.mark.parametrize("robot", [sample(name) for name in SAMPLES if not name.startswith("random")])
@pytest.mark.parametrize("distance", [-0.07, 0.03, 10.0])
def test_sliding_along_parallel_rails_with_the_limits_changes_nothing(robot: Sample, distance: float) -> None:
    q = robot.parameters
    rail = q.direction[0]
    np.testing.assert_array_equal(q.direction, np.tile(rail, (3, 1)))
    slid = q._replace(limits=q.limits + distance)
    for found, expected in zip(
        model.modal_matrices(robot.pose + distance * rail, slid),
        model.modal_matrices(robot.pose, q),
        strict=True,
    ):
        # ten metres away, coordinates round to 2e-15 m, an order more than at home
        assert_same(found, expected)


@pytest.mark.parametrize("y", [0.0, 0.04, -0.09])
def test_mirror_image_of_the_published_robot_exchanges_axes_2_and_3(y: float) -> None:
    here, there = published((0.5, y, -0.23)), published((0.5, -y, -0.23))
    order = np.array([0, 2, 1])
    nine = np.concatenate([order, order + 3, order + 6])
    for found, expected in zip(
        model.modal_matrices(there.pose, there.parameters),
        model.modal_matrices(here.pose, here.parameters),
        strict=True,
    ):
        assert_same(found, expected[np.ix_(nine, nine)])
    _assert_same_frequencies(frequencies(there), frequencies(here))


@pytest.mark.parametrize("pose", [(0.0, 0.0, 0.1), (0.04, 0.02, 0.05)], **IDS)
def test_a_third_of_a_turn_renames_the_axes_of_the_tower(pose: tuple[float, float, float]) -> None:
    here = tower_printer(pose)
    turn = Rotation.from_euler("z", 120, degrees=True).as_matrix()
    there = tower_printer(tuple(turn @ here.pose))
    order = np.array([2, 0, 1])
    nine = np.concatenate([order, order + 3, order + 6])
    for found, expected in zip(
        model.modal_matrices(there.pose, there.parameters),
        model.modal_matrices(here.pose, here.parameters),
        strict=True,
    ):
        assert_same(found, expected[np.ix_(nine, nine)])
    _assert_same_frequencies(frequencies(there), frequencies(here))


def _assert_same_frequencies(found: np.ndarray, expected: np.ndarray) -> None:
    # a symmetric eigenproblem is as exact as the largest eigenvalue
    assert np.max(np.abs(found - expected)) < SAME * expected[-1]


def test_symmetric_poses_have_symmetric_matrices() -> None:
    """Half of the entries are equal in pairs or vanish, so a wrong term could go unnoticed at these poses."""
    robot = sample("published-symmetric")
    D_p = model.platform_jacobian(robot.pose, robot.parameters)
    assert_same(D_p[:, [0, 2, 1]], np.diag([1.0, -1.0, 1.0]) @ D_p)
    assert abs(D_p[1, 0]) < SAME
    tower = sample("tower-symmetric")
    M, K = (matrix[:3, :3] for matrix in model.modal_matrices(tower.pose, tower.parameters))
    for matrix in (M, K):
        off = matrix[~np.eye(3, dtype=bool)]
        assert np.ptp(np.diag(matrix)) < SAME * matrix[0, 0]
        assert np.ptp(off) < SAME * matrix[0, 0]


# Matrices


def test_belts_leave_three_rigid_body_motions(subtests: pytest.Subtests) -> None:
    """Without gravity: each axis can run freely, its pulleys rolling on the belt."""
    for name in SAMPLES:
        with subtests.test(name=name):
            robot = sample(name)
            q = robot.parameters._replace(gravity=np.zeros(3))
            K = model.stiffness_matrix(robot.pose, q)
            # a carriage by R_p, its pulleys by one radian
            free = np.concatenate([np.diag(q.pulley_radius), np.eye(3), np.eye(3)])
            size = np.sqrt(np.outer(np.diag(K), np.diag(K)))
            scaled = K / size
            weighted = free * np.sqrt(np.diag(K))[:, None]
            assert np.max(np.abs(scaled @ weighted)) < SAME * np.max(np.abs(weighted))
            eigenvalues = np.linalg.eigvalsh(scaled)
            assert np.all(np.abs(eigenvalues[:3]) < SAME)
            # the other six strain a belt; scaled to a unit diagonal: at least the ratio of two spans
            assert np.all(eigenvalues[3:] > 0.01)


def test_mass_matrix_is_positive_definite(subtests: pytest.Subtests) -> None:
    for name in SAMPLES:
        with subtests.test(name=name):
            robot = sample(name)
            M = model.mass_matrix(robot.pose, robot.parameters)
            np.testing.assert_array_equal(M, M.T)
            diagonal = np.sqrt(np.diag(M))
            # scaled to a unit diagonal; a carriage keeps its own mass whatever the others do
            assert np.linalg.eigvalsh(M / np.outer(diagonal, diagonal))[0] > 0.01
            assert np.all(np.linalg.eigvalsh(M[:3, :3]) > np.min(robot.parameters.carriage_mass))


def test_static_equilibrium_balances_every_coordinate(subtests: pytest.Subtests) -> None:
    """With the stiffness matrix itself: K_el delta_q + grad V_g = Q."""
    for name in SAMPLES:
        with subtests.test(name=name):
            robot = sample(name)
            q = robot.parameters
            torques, theta = model.static_equilibrium(robot.pose, q)
            weights = np.concatenate([model.gravity_gradient(robot.pose, q), np.zeros(6)])
            restoring = model.elastic_hessian(robot.pose, q) @ np.concatenate([np.zeros(3), theta])
            motors = np.concatenate([np.zeros(3), (torques[:, None] * q.drive).T.ravel()])
            size = np.max(np.abs(weights)) * np.repeat([1.0, np.max(q.pulley_radius)], [3, 6])
            assert np.max(np.abs(restoring + weights - motors) / size) < SAME
            # the free pulley of a closed belt carries no torque: the weight goes through the driven one
            assert_same(torques, weights[:3] * q.pulley_radius)


# Closed forms


def orthogonal_robot(gravity: np.ndarray) -> Sample:
    """Three rails along x, y and z with each linkage along its rail, so that D_p is the unit matrix."""
    base = sample("random-0").parameters
    length = np.array([0.3, 0.4, 0.5])
    x = np.array([0.7, 0.5, 0.6])
    branch = np.array([1.0, -1.0, 1.0])
    # carriage at p + branch l n
    origin = np.diag(branch * length - x)
    return Sample(
        base._replace(
            gravity=gravity,
            origin=origin,
            direction=np.eye(3),
            joint=np.zeros((3, 3)),
            link_length=length,
            limits=np.stack([x - [0.3, 0.5, 0.2], x + [0.6, 0.25, 0.35]], axis=-1),
            branch=branch,
        ),
        np.zeros(3),
    )


def test_decoupled_axes_have_the_frequencies_of_their_own_chain() -> None:
    """Without gravity each axis is a carriage and two pulleys in a triangle of springs.

    Moving along its rail, a carriage takes with it the platform, its own linkage along its length, and the
    other two linkages, which turn about their carriages: a third of their mass.  With pulleys as masses
    I / R^2 at the belt, the characteristic polynomial of the triangle is
    lambda (lambda^2 - b lambda + c), with b the sum of k (1/m + 1/m') over the springs and
    c = (k1 k2 + k2 k3 + k3 k1) (m1 + m2 + m3) / (m1 m2 m3).
    """
    robot = orthogonal_robot(np.zeros(3))
    q = robot.parameters
    expected = [0.0] * 3
    for j in range(3):
        others = np.sum(q.link_mass) - q.link_mass[j]
        carriage = q.carriage_mass[j] + q.platform_mass + q.link_mass[j] + others / 3
        motor = q.motor_inertia[j] * q.gear_ratio[j] ** 2
        pulley_1, pulley_2 = (q.pulley_inertia[j] + motor * q.drive[j]) / q.pulley_radius[j] ** 2
        x = (0.7, 0.5, 0.6)[j]
        low, high = q.limits[j]
        half = q.carriage_length[j] / 2
        k_1, k_2, k_3 = (
            q.belt_width[j]
            * q.belt_specific_stiffness[j]
            / np.array([high - low, x - low - half, high - x - half])
        )
        b = (
            k_1 * (1 / pulley_1 + 1 / pulley_2)
            + k_2 * (1 / carriage + 1 / pulley_2)
            + k_3 * (1 / carriage + 1 / pulley_1)
        )
        total, product = carriage + pulley_1 + pulley_2, carriage * pulley_1 * pulley_2
        c = (k_1 * k_2 + k_2 * k_3 + k_3 * k_1) * total / product
        root = np.sqrt(b * b - 4 * c)
        expected += [(b - root) / 2, (b + root) / 2]
    _assert_same_frequencies(frequencies(robot), np.sort(expected))
    # to the digits of its own value each, where the largest does not set the rounding
    np.testing.assert_allclose(frequencies(robot)[3:], np.sort(expected)[3:], rtol=1e-11)


@pytest.mark.parametrize("along", [0, 1, 2])
def test_gravity_hessian_of_orthogonal_linkages_is_that_of_pendulums(along: int) -> None:
    """Gravity along one rail: sideways motion u swings that linkage, and moves p along the rail by u^2 / (2 l).

    That is towards the carriage, which holds p back: forward for branch +1, backward for branch -1.  The whole
    platform and half of each linkage go with it.
    """
    gravity = np.zeros(3)
    gravity[along] = -9.81
    robot = orthogonal_robot(gravity)
    q = robot.parameters
    moved = q.platform_mass + np.sum(q.link_mass) / 2
    stiffness = moved * 9.81 * q.branch[along] / q.link_length[along]
    expected = stiffness * np.diag([float(k != along) for k in range(3)])
    assert_same(model.gravity_hessian(robot.pose, q), expected)


def test_platform_jacobian_of_orthogonal_linkages_is_the_unit_matrix() -> None:
    robot = orthogonal_robot(np.zeros(3))
    found: Callable[..., np.ndarray] = model.platform_jacobian
    assert_same(found(robot.pose, robot.parameters), np.eye(3))
    determinant, condition = model.jacobian_condition(robot.pose, robot.parameters)
    l_1, l_2, l_3 = robot.parameters.link_length
    np.testing.assert_allclose(determinant, l_1 * l_2 * l_3, rtol=1e-14)  # two of three linkages point back
    exact = np.hypot(np.hypot(l_1, l_2), l_3) * np.sqrt(l_1**-2 + l_2**-2 + l_3**-2)
    np.testing.assert_allclose(condition, exact, rtol=1e-14)
