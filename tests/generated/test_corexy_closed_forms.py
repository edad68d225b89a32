"""The CoreXY against closed forms, and identities that hold for any parameter values."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg

from helpers.robots.sample_mechanisms import SEEDS, Sample, effects, sample
from pkmodes_generated.corexy import extended, model

#: Sums of some ten terms, none of which cancel: measured at most 4e-16 of the entry's own size.
SAME = 3e-15
COORDINATES = extended.COORDINATES


def symmetric(pose: tuple[float, float], level: bool = True) -> Sample:
    """Return a machine with mirror symmetry: on the centre line both belts have the same runs."""
    q = sample("corexy", 0).parameters
    same = {
        field: np.full(2, getattr(q, field)[0])
        for field in (
            *("belt_specific_stiffness", "belt_width", "pulley_radius"),
            *("pulley_inertia", "motor_inertia", "gear_ratio"),
        )
    }
    q = q._replace(
        **same,
        gravity=np.array([0.0, 0.0, -9.81]) if level else np.array([0.0, -3.0, -9.0]),
        belt_path_direction=np.array([[1.0, -1.0], [-1.0, -1.0]]),
        belt_path_lengths=np.array([[0.45, 0.75], [0.75, 0.45]]),
        workspace=np.array([[0.0, 0.3], [0.0, 0.3]]),
    )
    return Sample(q, np.array(pose))


def eigenvalues(robot: Sample) -> np.ndarray:
    M, K = model.modal_matrices(robot.pose, robot.parameters)
    return np.asarray(scipy.linalg.eigh(K, M, eigvals_only=True))


#: Free lengths of the runs on the centre line: 0.45 + 0.15 - 0.2, 0.75 - 0.15 + 0.2.
CENTRE, RUNS = (0.15, 0.2), (0.4, 0.8)


def test_two_vibrations_of_a_symmetric_machine_on_its_centre_line() -> None:
    """Equal belts of stiffness k = w k_sp (1/l_1 + 1/l_2), with g = (1, -1) and (-1, -1).

    2 V = k (x - y + R theta_1)^2 + k (-x - y + R theta_2)^2
        = k/2 (2 x + R (theta_1 - theta_2))^2 + k/2 (-2 y + R (theta_1 + theta_2))^2

    Along x, with z = 2 x and w = R (theta_1 - theta_2): 2 T = m/4 z_dot^2 + J/(2 R^2) w_dot^2, two masses on a
    spring of k/2, so lambda = k/2 (4/m + 2 R^2/J) = k (2/m + R^2/J).  The same holds along y with
    theta_1 + theta_2.  The beam moves only along y: m is the tool head along x, tool head and gantry along y.
    J = I_p + gear_ratio^2 I_m.  The two rigid modes are the free motions of the tool head and both motors.
    """
    robot = symmetric(CENTRE)
    q = robot.parameters
    k = q.belt_width[0] * q.belt_specific_stiffness[0] * sum(1 / length for length in RUNS)
    rotor = q.pulley_inertia[0] + q.gear_ratio[0] ** 2 * q.motor_inertia[0]
    drive = q.pulley_radius[0] ** 2 / rotor
    along_x = k * (2 / q.toolhead_mass + drive)
    along_y = k * (2 / (q.toolhead_mass + q.gantry_mass) + drive)
    found = eigenvalues(robot)
    # an eigenvalue has the absolute error of the largest one
    np.testing.assert_allclose(found[2:], [along_y, along_x], rtol=1e-12)
    assert np.abs(found[:2]).max() < 1e-12 * along_x


def test_ends_tension_and_factors_change_the_same_springs() -> None:
    """As above with 1/k = l / (w k_sp (1 + a) (1 + b F)) + c for each run; both runs of a belt act in parallel."""
    robot = symmetric(CENTRE)
    q = robot.parameters
    chosen = effects("corexy", ("belt_end", "belt_tension"))
    chosen = chosen._replace(axis_belt_stiffness_factor_1=0.2, axis_belt_stiffness_factor_2=0.2)
    unit = q.belt_width[0] * q.belt_specific_stiffness[0] * 1.2
    unit *= 1 + chosen.belt_tension_stiffness_coefficient * chosen.belt_tension_stiffness_tension
    k = sum(1 / (length / unit + chosen.belt_end_compliance_compliance) for length in RUNS)
    M, K_el, K_g = (a[:4, :4] for a in extended.extended_matrices(robot.pose, q, chosen))
    rotor = q.pulley_inertia[0] + q.gear_ratio[0] ** 2 * q.motor_inertia[0]
    drive = q.pulley_radius[0] ** 2 / rotor
    expected = [k * (2 / mass + drive) for mass in (q.toolhead_mass + q.gantry_mass, q.toolhead_mass)]
    found = scipy.linalg.eigh(K_el + K_g, M, eigvals_only=True)
    np.testing.assert_allclose(found[2:], expected, rtol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_running_free_strains_no_belt(seed: int) -> None:
    """For any parameter values there are exactly two motions in which the tool head moves and the pulleys roll."""
    robot = sample("corexy", seed)
    q = robot.parameters
    K = model.stiffness_matrix(robot.pose, q)
    free = np.vstack([np.eye(2), -q.belt_path_direction / q.pulley_radius[:, None]])
    size = np.sqrt(np.diag(K))
    scaled = K / np.outer(size, size)
    assert np.abs(scaled @ (free * size[:, None])).max() < SAME * np.abs(free * size[:, None]).max()
    values = np.linalg.eigvalsh(scaled)
    assert np.abs(values[:2]).max() < SAME * 4
    assert (values[2:] > 0.1).all()
    assert model.RIGID_MODES == 2


def _mirrored() -> np.ndarray:
    """Return the coordinates of the mirrored machine: x changes sign, belts 1 and 2 are exchanged."""
    swap = {"_1": "_2", "_2": "_1"}
    there = [c[:-2] + swap[c[-2:]] if c[-2:] in swap else c for c in COORDINATES]
    turn = np.zeros((len(COORDINATES),) * 2)
    for i, c in enumerate(there):
        turn[i, COORDINATES.index(c)] = -1.0 if c in ("x", "u_x", "psi_b") else 1.0
    return turn


@pytest.mark.parametrize("pose", [(0.15, 0.2), (0.04, 0.11), (0.29, 0.3)])
def test_mirror_image_exchanges_the_belts(pose: tuple[float, float]) -> None:
    """The workspace ends at 0.3 m: position x becomes 0.3 m - x in the mirrored machine."""
    chosen = effects("corexy", ("",))._replace(
        axis_belt_stiffness_factor_1=0.1, axis_belt_stiffness_factor_2=0.1, gantry_racking_center=0.15
    )
    here, there = symmetric(pose, False), symmetric((0.3 - pose[0], pose[1]), False)
    turn = _mirrored()
    for found, expected in zip(
        extended.extended_matrices(there.pose, there.parameters, chosen),
        extended.extended_matrices(here.pose, here.parameters, chosen),
        strict=True,
    ):
        # 0.3 - x adds one rounding to the lengths of runs
        np.testing.assert_allclose(found, turn @ expected @ turn.T, rtol=2e-14, atol=1e-13)
    for one, other in zip(
        extended.extended_static_equilibrium(there.pose, there.parameters, chosen),
        extended.extended_static_equilibrium(here.pose, here.parameters, chosen),
        strict=True,
    ):
        np.testing.assert_allclose(one, other[::-1], rtol=2e-14)
        assert np.abs(one).max() > 0


@pytest.mark.parametrize("seed", SEEDS)
def test_naming_the_runs_the_other_way_round_turns_the_angles(seed: int) -> None:
    """Exchange runs 1 and 2 of the second belt: its direction, clamp, pulley and motor change sign."""
    robot = sample("corexy", seed)
    q = robot.parameters
    sign = np.array([[1.0], [-1.0]])
    renamed = q._replace(
        belt_path_direction=q.belt_path_direction * sign,
        belt_path_lengths=np.array([q.belt_path_lengths[0], q.belt_path_lengths[1, ::-1]]),
    )
    chosen = effects("corexy", ("",))
    turn = np.diag([-1.0 if c in ("theta_2", "psi_2", "eps_2") else 1.0 for c in COORDINATES])
    for found, expected in zip(
        extended.extended_matrices(robot.pose, renamed, chosen),
        extended.extended_matrices(robot.pose, q, chosen),
        strict=True,
    ):
        np.testing.assert_allclose(found, turn @ expected @ turn, rtol=SAME, atol=0)


@pytest.mark.parametrize("seed", SEEDS)
def test_torques_are_the_pull_of_the_weight_along_the_belts(seed: int) -> None:
    """Virtual work with rolling pulleys: tau . dtheta = -weight . (dx, dy), R dtheta_i = -g_i . (dx, dy).

    That is g^T (tau / R) = weight: of the tool head along x, of gantry and tool head along y; a level plane needs
    no torque.
    """
    robot = sample("corexy", seed)
    q = robot.parameters
    weight = q.gravity[:2] * [q.toolhead_mass, q.toolhead_mass + q.gantry_mass]
    torques, theta = model.static_equilibrium(robot.pose, q)
    expected = q.pulley_radius * np.linalg.solve(q.belt_path_direction.T, weight)
    np.testing.assert_allclose(torques, expected, rtol=1e-13)
    k = np.sum(model.belt_stiffness(robot.pose, q), axis=1)
    np.testing.assert_allclose(theta, expected / (k * q.pulley_radius**2), rtol=1e-13)
    level = q._replace(gravity=np.array([0.0, 0.0, -9.81]))
    for found in model.static_equilibrium(robot.pose, level):
        np.testing.assert_array_equal(np.abs(found), 0.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_runs_lengthen_and_shorten_with_the_tool_head(seed: int) -> None:
    robot = sample("corexy", seed)
    q = robot.parameters
    (l_1, l_2), (l_3, l_4) = q.belt_path_lengths
    g_1, g_2 = q.belt_path_direction @ robot.pose
    expected = np.array([[l_1 + g_1, l_2 - g_1], [l_3 + g_2, l_4 - g_2]])
    np.testing.assert_allclose(model.belt_spans(robot.pose, q), expected, rtol=1e-15)
    stiffness = (q.belt_width * q.belt_specific_stiffness)[:, None] / expected
    np.testing.assert_allclose(model.belt_stiffness(robot.pose, q), stiffness, rtol=1e-15)
    corners = [np.array([x, y]) for x in q.workspace[0] for y in q.workspace[1]]
    least = np.min([model.belt_spans(corner, q) for corner in corners], axis=0)
    np.testing.assert_allclose(model.run_margin(q), least, rtol=1e-14)
    low, high = q.workspace.T
    np.testing.assert_allclose(
        model.travel_margin(robot.pose, q), np.stack([robot.pose - low, high - robot.pose], axis=-1)
    )


def test_a_belt_that_pulls_as_the_other_does_is_seen() -> None:
    q = sample("corexy", 0).parameters
    for first in ([1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]):
        for other in ([1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]):
            margin = model.crossing_margin(q._replace(belt_path_direction=np.array([first, other])))
            assert (margin > 0).all() == (first[0] * other[1] != first[1] * other[0])
