"""Identities of every rotary delta: changes of frame and numbering, symmetries, rigid motions, closed forms."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg
from scipy.spatial.transform import Rotation

from helpers.robots.sample_mechanisms import SEEDS, Sample, effects, sample
from helpers.robots.symmetric_rotary_delta import GRAVITY, THIRD, clavel, orthogonal, reordered, turned
from pkmodes_generated.rotary_delta import extended, model

#: The error of each side of an identity is at most 5e-16 per unit of the condition number of D_l, below 12 here
#: (test_oracle); another description of a robot rounds its coordinates once more, to some 1e-16 of a metre
#: for links of half a metre, which is multiplied by the condition number twice.
SAME = 1e-13
CENTRE, ASIDE = (0.0, 0.0, -0.45), (0.06, 0.03, -0.5)


def assert_same(found: np.ndarray, expected: np.ndarray) -> None:
    """Compare to rounding of the largest entry of each block of three coordinates."""
    assert found.shape == expected.shape
    if found.ndim < 2:
        assert np.abs(found - expected).max() < SAME * np.abs(expected).max()
        return
    for i in range(0, found.shape[0], 3):
        for j in range(0, found.shape[1], 3):
            a, b = found[i : i + 3, j : j + 3], expected[i : i + 3, j : j + 3]
            assert np.abs(a - b).max() <= SAME * np.abs(b).max()


def whole(robot: Sample) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return M, K_el and K_g with all effects except the factors, which differ between axes."""
    chosen = effects("rotary_delta", ("",))
    factors = {f: 0.1 for f in chosen._fields if "factor" in f}
    M, K_el, K_g = extended.extended_matrices(robot.pose, robot.parameters, chosen._replace(**factors))
    return M, K_el, K_g


def eigenvalues(robot: Sample) -> np.ndarray:
    M, K = model.modal_matrices(robot.pose, robot.parameters)
    return np.asarray(scipy.linalg.eigh(K, M, eigvals_only=True))


# Changes of frame and numbering


@pytest.mark.parametrize("seed", SEEDS)
def test_turning_and_moving_the_base_frame_turns_the_frame_s_motion_only(seed: int) -> None:
    robot = sample("rotary_delta", seed)
    turn = Rotation.random(rng=np.random.default_rng(seed)).as_matrix()
    there = turned(robot, turn, np.array([0.3, -0.2, 0.4]))
    change = scipy.linalg.block_diag(np.eye(9), turn)
    for found, expected in zip(whole(there), whole(robot), strict=True):
        assert_same(found, change @ expected @ change.T)
    for found, expected in zip(
        model.static_equilibrium(there.pose, there.parameters),
        model.static_equilibrium(robot.pose, robot.parameters),
        strict=True,
    ):
        assert_same(found, expected)
    motion = extended.extended_platform_motion(there.pose, there.parameters)
    assert_same(motion, turn @ extended.extended_platform_motion(robot.pose, robot.parameters) @ change.T)


@pytest.mark.parametrize("seed", SEEDS)
def test_order_of_the_axes_does_not_matter(seed: int) -> None:
    robot, order = sample("rotary_delta", seed), np.array([2, 0, 1])
    all_of_them = np.concatenate([order, order + 3, order + 6, [9, 10, 11]])
    there = Sample(reordered(robot.parameters, order), robot.pose)
    for found, expected in zip(whole(there), whole(robot), strict=True):
        assert_same(found, expected[np.ix_(all_of_them, all_of_them)])


@pytest.mark.parametrize("seed", SEEDS)
def test_an_axis_that_points_the_other_way_turns_its_angles(seed: int) -> None:
    """theta and phi change sign, and so does the branch."""
    robot, sign = sample("rotary_delta", seed), np.array([-1.0, 1.0, -1.0])
    q = robot.parameters
    there = Sample(q._replace(axis=q.axis * sign[:, None], branch=q.branch * sign), robot.pose)
    change = np.diag([*sign, *sign, *np.ones(6)])
    for found, expected in zip(whole(there), whole(robot), strict=True):
        assert_same(found, change @ expected @ change)
    for found, expected in zip(
        model.static_equilibrium(there.pose, there.parameters),
        model.static_equilibrium(robot.pose, q),
        strict=True,
    ):
        assert_same(found, sign * expected)


@pytest.mark.parametrize("seed", SEEDS)
def test_where_an_angle_is_zero_changes_no_matrix(seed: int) -> None:
    robot = sample("rotary_delta", seed)
    q = robot.parameters
    turns = Rotation.from_rotvec(q.axis * np.array([[0.4], [-1.2], [2.5]]))
    there = Sample(q._replace(zero=turns.apply(q.zero)), robot.pose)
    for found, expected in zip(whole(there), whole(robot), strict=True):
        assert_same(found, expected)


# Symmetry


@pytest.mark.parametrize("pose", [CENTRE, ASIDE])
def test_a_third_of_a_turn_renames_the_axes(pose: tuple[float, float, float]) -> None:
    here = clavel(pose)
    there = Sample(here.parameters, THIRD @ here.pose)
    order = np.array([2, 0, 1])
    all_of_them = np.concatenate([order, order + 3, order + 6, [9, 10, 11]])
    change = scipy.linalg.block_diag(np.eye(9), THIRD)
    for found, expected in zip(whole(there), whole(here), strict=True):
        assert_same(found, change @ expected[np.ix_(all_of_them, all_of_them)] @ change.T)


def test_modes_at_the_centre_come_in_pairs() -> None:
    """Three equal coordinates, arms or motors, give one mode that is equal on all axes and a pair.

    Away from the centre the pairs split, so the result is not an accident of equal numbers.
    """
    values = eigenvalues(clavel(CENTRE))
    gaps, size = np.diff(values[3:]), values[-1]
    assert (gaps < SAME * size).sum() == 1
    assert (gaps > 1e-3 * size).sum() == 1
    assert (
        np.diff(values[:3]) < SAME * size
    ).sum() >= 1  # rigid ones: gravity alone, some 1e-5 of the largest
    assert (np.diff(eigenvalues(clavel(ASIDE))[3:]) > 1e-3 * size).all()


def test_platform_above_and_below_differ_by_the_sign_of_gravity() -> None:
    """Mirrored in the plane of the axes, which contains z_j: arm angles, branches and gravity change sign."""
    here = clavel((0.05, -0.08, -0.5))
    q = here.parameters
    there = Sample(q._replace(gravity=-q.gravity, branch=-q.branch), here.pose * [1, 1, -1])
    # the signs of angles cancel in pairs in each matrix, but not with the motion of the frame along z
    change = np.diag([*-np.ones(6), *np.ones(5), -1.0])
    for found, expected in zip(whole(there), whole(here), strict=True):
        assert_same(found, change @ expected @ change)


# Rigid motions and forces


@pytest.mark.parametrize("seed", SEEDS)
def test_reducers_leave_three_rigid_motions(seed: int) -> None:
    """Arm and motor turn together; these modes have zero stiffness without gravity and the same number with it."""
    robot = sample("rotary_delta", seed)
    q = robot.parameters
    K = model.stiffness_matrix(robot.pose, q._replace(gravity=np.zeros(3)))
    np.testing.assert_array_equal(K @ np.vstack([np.eye(3), np.eye(3)]), 0.0)
    scaled = np.linalg.eigvalsh(K / np.sqrt(np.outer(np.diag(K), np.diag(K))))
    np.testing.assert_allclose(scaled, [0, 0, 0, 2, 2, 2], atol=SAME)
    values = eigenvalues(robot)
    assert model.RIGID_MODES == 3
    assert np.abs(values[:3]).max() < 0.05 * values[3]


@pytest.mark.parametrize("seed", SEEDS)
def test_mass_matrix_is_positive_definite(seed: int) -> None:
    M, _, _ = whole(sample("rotary_delta", seed))
    np.testing.assert_array_equal(M, M.T)
    # each elongation moves half of a link and the platform at least: scaled to a unit diagonal, well above zero
    assert np.linalg.eigvalsh(M / np.sqrt(np.outer(np.diag(M), np.diag(M))))[0] > 1e-3


@pytest.mark.parametrize("seed", SEEDS)
def test_motors_hold_the_weight_through_their_reducers(seed: int) -> None:
    robot = sample("rotary_delta", seed)
    q = robot.parameters
    torques, wound = model.static_equilibrium(robot.pose, q)
    assert_same(torques, model.gravity_gradient(robot.pose, q))
    assert_same(wound, torques / q.reducer_stiffness)


def test_torque_on_a_horizontal_arm_lifts_its_load() -> None:
    """The contract's robot with all arms horizontal: theta is positive upwards, and so is the torque that holds it.

    Vertical forces: each arm's end carries a third of platform and links through a link that is tilted by a
    horizontal distance h over a height; the horizontal part has no lever arm, the vertical part has L.  The upper
    halves of the links act on the arms directly.
    """
    radius = 0.11 + 0.24 - 0.04
    robot = clavel((0.0, 0.0, -np.sqrt(0.6**2 - radius**2)))
    q = robot.parameters
    third = q.platform_mass / 3 + 0.16
    expected = GRAVITY * (third * 0.24 + 0.35 * 0.09)
    torques, wound = model.static_equilibrium(robot.pose, q)
    np.testing.assert_allclose(torques, expected, rtol=SAME)
    np.testing.assert_allclose(wound, expected / 4000.0, rtol=SAME)


# Closed forms


@pytest.mark.parametrize("seed", range(3))
def test_decoupled_axes_have_the_frequencies_of_their_own_reducer(seed: int) -> None:
    """Without gravity each axis is an arm and a motor on a torsional spring: lambda = k (1/J + 1/(i^2 I)).

    An arm moves the platform, its own link along its length, and the other two links, which turn about the ends of
    their arms with a third of their mass: J = I_a + L^2 (m_p + m_j + (m_k + m_l) / 3).
    """
    robot = orthogonal(np.zeros(3), np.random.default_rng(seed).uniform(-1.5, 1.5, 3))
    q = robot.parameters
    others = np.sum(q.link_mass) - q.link_mass
    J = q.arm_inertia + q.arm_length**2 * (q.platform_mass + q.link_mass + others / 3)
    motor = q.gear_ratio**2 * q.motor_inertia
    assert_same(model.mass_matrix(robot.pose, q)[:3, :3], np.diag(J))
    expected = np.sort(q.reducer_stiffness * (1 / J + 1 / motor))
    values = eigenvalues(robot)
    np.testing.assert_allclose(values[3:], expected, rtol=SAME)
    assert np.abs(values[:3]).max() < SAME * values[-1]


@pytest.mark.parametrize("seed", range(3))
def test_gravity_hessian_of_orthogonal_links_is_that_of_pendulums(seed: int) -> None:
    """Arm k moves the platform by L_k theta_k perpendicular to the other links, and each link j pulls it back.

    Along base axis j it moves by -(L_k theta_k)^2 / (2 s_j l_j), with s_j = 1 if the platform is ahead of the end of
    arm j, and -1 if it is behind.  The platform and half of each link move with it.  The end of arm k itself moves by
    -L_k theta_k^2 / 2 along the arm, with half of its link, and its centre of mass in proportion; this does not move
    the platform, because the arm is perpendicular to its link.
    """
    rng = np.random.default_rng(seed)
    gravity = rng.normal(size=3)
    robot = orthogonal(gravity, rng.uniform(-1.5, 1.5, 3))
    q = robot.parameters
    moved = q.platform_mass + np.sum(q.link_mass) / 2
    ahead, arm = np.array([1.0, -1.0, 1.0]), np.eye(3)[[1, 2, 0]]
    expected = np.zeros((3, 3))
    for k in range(3):
        back = [-(q.arm_length[k] ** 2) / (ahead[j] * q.link_length[j]) * (j != k) for j in range(3)]
        own = q.link_mass[k] / 2 * q.arm_length[k] + q.arm_mass[k] * q.arm_center[k]
        expected[k, k] = -moved * gravity @ back + own * gravity @ arm[k]
    assert_same(model.gravity_hessian(robot.pose, q), expected)
    assert_same(model.platform_jacobian(robot.pose, q), np.diag(q.arm_length))
