"""Points of a drawing and their motion, for robots without symmetry and with every effect, against kinematics."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.sample_mechanisms import TYPICAL, sampled
from helpers.robots.sample_mechanisms import sample as other_sample
from helpers.robots.sample_robots import sample as linear_sample
from pkmodes.core.mechanism import registry
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.pages.view.evaluating import scene
from pkmodes.pages.view.robot_drawing import RobotDrawing

MECHANISMS = ("linear_delta", *sampled())
CASES = [(name, seed) for name in MECHANISMS for seed in range(4)]
#: Central differences with this step have some 1e-9 of error relative to the size of the motion.
STEP, CLOSE = 1e-6, 1e-7
#: Rigid links keep their length to first order: only rounding is left.
ROUNDING = 1e-12


def robot_of(name: str, seed: int, effects: bool = False) -> tuple[Robot, np.ndarray]:
    """Return a random robot and a pose; with all effects that the mechanism has, or without any."""
    found = linear_sample(f"random-{seed}") if name == "linear_delta" else other_sample(name, seed)
    mechanism = registry.mechanism(name)
    values: dict[str, float] = {}
    for effect in mechanism.effects.values() if effects else ():
        for p in effect.parameters:
            values[f"{effect.name}.{p.name}"] = TYPICAL.get(f"{effect.name}_{p.name}", 0.07)
    parameters = found.parameters
    if name == "rotary_delta":  # the sample's pose may lie beyond the limits of the arms
        parameters = parameters._replace(limits=np.tile([-np.pi, np.pi], (3, 1)))
    return Robot(f"{name}-{seed}", name, f"{name}.toml", parameters, {}, values), found.pose


def motion(drawn: RobotDrawing, p: np.ndarray) -> np.ndarray:
    """Return the Jacobian of every point, (P, 3, n)."""
    return drawn.motions(p[None])[0][list(drawn.drawing.motions)]


def carried(robot: Robot, p: np.ndarray) -> Any:
    """Return the pose as a function of the independent coordinates near a pose."""
    model = import_module(f"pkmodes_generated.{robot.mechanism_name}.model")
    if hasattr(model, "direct_kinematics"):
        assembly = np.sign(model.jacobian_condition(p, robot.parameters)[0])
        return lambda q: model.direct_kinematics(q, assembly, robot.parameters)
    return lambda q: q  # the pose itself


def inverse(robot: Robot, p: np.ndarray) -> np.ndarray:
    model = import_module(f"pkmodes_generated.{robot.mechanism_name}.model")
    return np.asarray(model.inverse_kinematics(p, robot.parameters))


@pytest.mark.parametrize(("name", "seed"), CASES)
def test_points_move_as_differences_of_their_positions_say(name: str, seed: int) -> None:
    robot, p = robot_of(name, seed)
    drawn, pose_of, q = RobotDrawing(robot), carried(robot, p), inverse(robot, p)
    found = motion(drawn, p)
    places = [drawn.coordinates.index(one) for one in robot.mechanism.independent]
    size = np.abs(found[..., places]).max()
    for k, place in enumerate(places):
        step = STEP * np.eye(len(q))[k]
        ahead, behind = (drawn.points(pose_of(q + s * step)[None])[0] for s in (1, -1))
        np.testing.assert_allclose(
            found[..., place], (ahead - behind) / (2 * STEP), rtol=0, atol=CLOSE * size
        )
    others = [k for k in range(len(drawn.coordinates)) if k not in places]
    assert not found[..., others].any(), "transmissions move no point"


@pytest.mark.parametrize(("name", "seed"), CASES)
@pytest.mark.parametrize("effects", [False, True])
def test_the_first_point_moves_as_the_platform_does(name: str, seed: int, effects: bool) -> None:
    robot, p = robot_of(name, seed, effects)
    drawn, model = RobotDrawing(robot), pkmodes.Model(robot)
    rows = ["xyz".index(one) for one in robot.mechanism.directions]
    assert drawn.coordinates == model.coordinates
    np.testing.assert_array_equal(drawn.points(p[None])[0, 0, rows], p)
    modes, shown = model.modes(p), scene(model, p)
    for m, shape in enumerate(modes.platform_shapes):
        np.testing.assert_allclose(shown.displacements(0, m)[0, rows], shape, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(("name", "seed"), [case for case in CASES if case[0].endswith("delta")])
def test_rods_keep_their_length_unless_their_elongation_is_released(name: str, seed: int) -> None:
    robot, p = robot_of(name, seed, effects=True)
    drawn = RobotDrawing(robot)
    points, J = drawn.points(p[None])[0], motion(drawn, p)
    rods = [e for e in drawn.drawing.elements if e.kind == "link"]
    assert len(rods) == 6
    for number, rod in enumerate(rods):
        first, last = rod.points
        along = points[last] - points[first]
        length = np.linalg.norm(along)
        stretch = along @ (J[last] - J[first]) / length
        expected = np.zeros(len(drawn.coordinates))
        expected[drawn.coordinates.index(f"delta_{number // 2 + 1}")] = 1.0
        np.testing.assert_allclose(stretch, expected, atol=1e3 * ROUNDING)
        assert length == pytest.approx(float(robot.parameters.link_length[number // 2]), rel=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_arms_turn_about_their_axes(seed: int) -> None:
    robot, p = robot_of("rotary_delta", seed)
    drawn = RobotDrawing(robot)
    points, J = drawn.points(p[None])[0], motion(drawn, p)
    for j, arm in enumerate(e for e in drawn.drawing.elements if e.kind == "arm"):
        first, last = arm.points
        np.testing.assert_array_equal(J[first], 0.0)
        turned = np.cross(robot.parameters.axis[j], points[last] - points[first])
        np.testing.assert_allclose(J[last][:, j], turned, atol=ROUNDING)


@pytest.mark.parametrize(("name", "seed"), CASES)
def test_the_frame_carries_every_point(name: str, seed: int) -> None:
    robot, p = robot_of(name, seed, effects=True)
    drawn = RobotDrawing(robot)
    J = motion(drawn, p)
    for axis in robot.mechanism.directions:
        column = J[..., drawn.coordinates.index(f"u_{axis}")]
        np.testing.assert_array_equal(column, np.tile(np.eye(3)["xyz".index(axis)], (len(J), 1)))


def test_drawn_belt_spans_have_the_free_lengths_and_strains_of_the_model() -> None:
    """The ends of a span approach as its coordinates strain it, and a clamp that yields strains it alike."""
    for seed in range(4):
        robot, p = robot_of("linear_delta", seed, effects=True)
        robot = replace(robot, parameters=robot.parameters._replace(carriage_length=np.zeros(3)))
        drawn = RobotDrawing(robot)
        points, J = drawn.points(p[None])[0], motion(drawn, p)
        free = import_module("pkmodes_generated.linear_delta.model").belt_spans(p, robot.parameters).ravel()
        strain = drawn.springs(p[None]).strain[0]
        belts = [e for e in drawn.drawing.elements if e.kind == "belt"]
        for belt, expected in zip(belts, free, strict=True):
            first, last = belt.points
            along = points[last] - points[first]
            length = np.linalg.norm(along)
            assert length == pytest.approx(expected, rel=1e-12)
            stretch = along @ (J[last] - J[first]) / length
            theta = [k for k, q in enumerate(drawn.coordinates) if q.startswith("theta")]
            others = [k for k in range(len(drawn.coordinates)) if k not in theta]
            np.testing.assert_allclose(stretch[others], strain[belt.spring][others], atol=1e3 * ROUNDING)
            assert not stretch[theta].any(), "pulleys turn, their centres stay"


@pytest.mark.parametrize(("name", "seed"), CASES)
def test_the_energies_of_all_springs_and_of_gravity_add_up_to_the_stiffness(name: str, seed: int) -> None:
    robot, p = robot_of(name, seed, effects=True)
    system, drawn = ExtendedSystem.of(robot), RobotDrawing(robot)
    extended = import_module(f"pkmodes_generated.{name}.extended")
    _, _, K_g = extended.extended_matrices(p, robot.parameters, system.effects)
    _, K = system.all_coordinates(p[None])
    _, stiffness, strain = drawn.springs(p[None])
    B = strain[0]
    total = B.T @ (stiffness[0][:, None] * B) + K_g[np.ix_(system.free, system.free)]
    wanted = system.free_part(K)[0]
    scale = np.sqrt(np.outer(np.diag(np.abs(wanted)), np.diag(np.abs(wanted))))
    assert np.abs((total - wanted) / scale.max(initial=1e-300, where=scale > 0)).max() < ROUNDING


@pytest.mark.parametrize(("name", "seed"), CASES)
def test_the_strain_energy_of_a_mode_is_that_of_its_springs(name: str, seed: int) -> None:
    robot, p = robot_of(name, seed)
    model = pkmodes.Model(robot)
    modes, shown = model.modes(p), scene(model, p)
    M = import_module(f"pkmodes_generated.{name}.model")
    H = M.elastic_hessian(p, robot.parameters)
    for m in range(shown.rigid_modes, len(modes.frequencies)):
        expected = 0.5 * modes.shapes[m] @ H @ modes.shapes[m]
        assert shown.energies[0, m].sum() == pytest.approx(expected, rel=1e-9)
        assert shown.shares[0, m].sum() == pytest.approx(1.0, rel=1e-12)
    assert np.isnan(shown.shares[0, : shown.rigid_modes]).all()
