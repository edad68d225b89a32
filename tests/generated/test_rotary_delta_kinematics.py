"""Arm angles and poses of the rotary delta: the contract's formula, its range, and both assemblies."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.robots.sample_mechanisms import SEEDS, Sample, sample
from helpers.robots.symmetric_rotary_delta import clavel
from pkmodes_generated.rotary_delta import Parameters, model

MANY = 2000


def many(seed: int) -> tuple[Parameters, np.ndarray]:
    """Return robots with zero directions of the arms in any direction, and poses that they reach with some margin."""
    rng = np.random.default_rng(seed)
    q = sample("rotary_delta", 0).parameters
    axis = unit(rng.normal(size=(MANY, 3, 3)))
    zero = np.cross(axis, rng.normal(size=(MANY, 3, 3)))
    robots = q._replace(axis=axis, zero=unit(zero), branch=rng.choice([-1.0, 1.0], (MANY, 3)))
    poses = rng.uniform(-0.6, 0.6, (MANY, 3))
    reached = (model.reach_margin(poses, robots) > 0.004).all(axis=(-1, -2))
    # for a joint near the arm's axis, any angle is nearly correct
    reached &= (by_formula(poses, robots)[1] > 0.05).all(axis=-1)
    batched = {field: getattr(robots, field)[reached] for field in ("axis", "zero", "branch")}
    return robots._replace(**batched), poses[reached]


def unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def by_formula(p: np.ndarray, q: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return theta = atan2(B, A) + branch acos(C / rho) of the contract, not yet brought into a range, and rho."""
    r = p[..., None, :] + q.joint - q.origin
    A = np.sum(r * q.zero, axis=-1)
    B = np.sum(r * np.cross(q.axis, q.zero), axis=-1)
    rho = np.hypot(A, B)
    C = (np.sum(r * r, axis=-1) + q.arm_length**2 - q.link_length**2) / (2 * q.arm_length)
    with np.errstate(invalid="ignore"):
        return np.arctan2(B, A) + q.branch * np.arccos(C / rho), rho


def ends(theta: np.ndarray, q: Any) -> np.ndarray:
    """Return the ends of the arms, origin + L (cos theta z + sin theta a x z)."""
    c, s = np.cos(theta)[..., None], np.sin(theta)[..., None]
    return np.asarray(q.origin + q.arm_length[..., None] * (c * q.zero + s * np.cross(q.axis, q.zero)))


@pytest.mark.parametrize("seed", range(2))
def test_arm_angles_follow_the_contract_s_formula(seed: int) -> None:
    robots, poses = many(seed)
    raw, _ = by_formula(poses, robots)
    expected = np.where(raw > np.pi, raw - 2 * np.pi, np.where(raw <= -np.pi, raw + 2 * np.pi, raw))
    found = model.inverse_kinematics(poses, robots)
    # the test is meaningful only if both ends of the range are crossed
    assert (raw > np.pi).sum() > 20
    assert (raw <= -np.pi).sum() > 20
    assert (raw == expected).sum() > 200
    assert (found > -np.pi).all()
    assert (found <= np.pi).all()
    # acos is steep near full stretch, a centimetre away here: some roundings; measured: 3.6e-15
    assert np.abs(found - expected).max() < 3e-14


@pytest.mark.parametrize("seed", range(2))
def test_links_close_at_the_arm_angles(seed: int) -> None:
    robots, poses = many(seed)
    theta = model.inverse_kinematics(poses, robots)
    links = poses[:, None, :] + robots.joint - ends(theta, robots)
    lengths = np.linalg.norm(links, axis=-1)
    # a few roundings in coordinates of half a metre; measured: 2.3e-16
    assert np.abs(lengths - robots.link_length).max() < 3e-15


@pytest.mark.parametrize("link", [(-0.375, 0.5), (0.375, 0.5), (0.0, 0.625)])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_an_arm_that_points_straight_back_is_at_pi_and_not_at_minus_pi(
    side: float, link: tuple[float, float]
) -> None:
    """Exact in short binary fractions: an arm along -x, and a link that is the hypotenuse of a 3-4-5 triangle.

    The formula itself ends at -pi below the arm and at pi above it.
    """
    q = sample("rotary_delta", 0).parameters._replace(
        origin=np.zeros((3, 3)),
        axis=np.tile([0.0, -1.0, 0.0], (3, 1)),
        zero=np.tile([1.0, 0.0, 0.0], (3, 1)),
        joint=np.zeros((3, 3)),
        arm_length=np.full(3, 0.25),
        link_length=np.full(3, 0.625),
        branch=np.full(3, side),
    )
    pose = np.array([-0.25 + link[0], 0.0, side * link[1]])
    np.testing.assert_array_equal(by_formula(pose, q)[0], side * np.pi)
    np.testing.assert_array_equal(model.inverse_kinematics(pose, q), np.pi)


@pytest.mark.parametrize("seed", SEEDS)
def test_direct_kinematics_undoes_inverse_in_the_same_assembly(seed: int) -> None:
    p, q = sample("rotary_delta", seed).pose, sample("rotary_delta", seed).parameters
    theta = model.inverse_kinematics(p, q)
    links = p + q.joint - ends(theta, q)
    assembly = np.sign(np.linalg.det(links))
    np.testing.assert_allclose(model.direct_kinematics(theta, assembly, q), p, rtol=0, atol=1e-14)
    other = model.direct_kinematics(theta, -assembly, q)
    links = other + q.joint - ends(theta, q)
    np.testing.assert_allclose(np.linalg.norm(links, axis=-1), q.link_length, rtol=1e-12)
    assert np.sign(np.linalg.det(links)) == -assembly


@pytest.mark.parametrize("seed", SEEDS)
def test_each_branch_is_another_angle_that_closes(seed: int) -> None:
    p, q = sample("rotary_delta", seed).pose, sample("rotary_delta", seed).parameters
    both = [model.inverse_kinematics(p, q._replace(branch=sign * q.branch)) for sign in (1, -1)]
    assert (np.abs(both[0] - both[1]) > 0.1).all()
    for theta in both:
        links = p + q.joint - ends(theta, q)
        np.testing.assert_allclose(np.linalg.norm(links, axis=-1), q.link_length, rtol=1e-14)


# Margins


@pytest.mark.parametrize("seed", SEEDS)
def test_reach_ends_where_the_link_is_straight_or_folded(seed: int) -> None:
    """The closure has a solution exactly where the margin is not negative, for a joint too far or too near."""
    robot, rng = sample("rotary_delta", seed), np.random.default_rng(seed)
    q = robot.parameters
    poses = rng.uniform(-1.2, 1.2, (1000, 3)) * rng.uniform(0.0, 1.0, (1000, 1))
    raw, rho = by_formula(poses, q)
    missed = np.isnan(raw)
    assert (missed & (rho < 0.2)).sum() > 5
    assert (missed & (rho > 0.7)).sum() > 100
    np.testing.assert_array_equal((model.reach_margin(poses, q) >= 0).all(axis=-1), ~missed)


def test_a_joint_out_of_reach_is_missed_by_the_length_that_the_linkage_lacks() -> None:
    """Radially outwards, arm and link end at L_a + l; towards the axis of the arm, the link is too long."""
    q = clavel((0.0, 0.0, -0.6)).parameters
    for beyond in (0.001, 0.01, 0.1):
        out = q.origin[0] + (q.arm_length[0] + q.link_length[0] + beyond) * q.zero[0] - q.joint[0]
        assert model.reach_margin(out, q)[0, 0] == pytest.approx(-beyond, rel=1e-12)
        near = q.origin[0] + (q.link_length[0] - q.arm_length[0] - beyond) * q.zero[0] - q.joint[0]
        assert model.reach_margin(near, q)[0, 1] == pytest.approx(-beyond, rel=1e-12)


def test_limits_are_those_of_the_arm_angles() -> None:
    robot: Sample = clavel((0.05, -0.08, -0.5))
    q = robot.parameters
    theta = model.inverse_kinematics(robot.pose, q)
    expected = np.stack([theta - q.limits[:, 0], q.limits[:, 1] - theta], axis=-1)
    np.testing.assert_allclose(model.limit_margin(robot.pose, q), expected, rtol=0, atol=1e-15)


def test_requirements_of_arms() -> None:
    q = sample("rotary_delta", 1).parameters
    np.testing.assert_allclose(model.inertia_margin(q), q.arm_inertia - q.arm_mass * q.arm_center**2)
    assert (model.perpendicular_margin(q) > 0.99e-12).all()
    for cosine, holds in ((0.9e-6, True), (1.1e-6, False), (-0.9e-6, True), (-1.1e-6, False)):
        leaning = q.zero + cosine * q.axis
        margin = model.perpendicular_margin(q._replace(zero=leaning))
        assert ((margin >= 0) == holds).all()
