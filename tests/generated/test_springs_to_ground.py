"""Robots that springs hold to ground, from 1e-8 N/m to 1e6: nine digits with both back ends, or an error.

In K the springs stand beside belts of 1e5 N/m, and without care a symmetric solver loses them in the rounding of its
largest eigenvalue.  The references are modes of the oracles' matrices in 60 digits, found once for both back ends.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import load_free
from helpers.references.high_precision import Exact, solved
from helpers.references.high_precision_mechanisms import mp
from helpers.references.oracle import Oracle
from helpers.references.oracle_modes import exact, model_of
from helpers.robots.sample_mechanisms import NAMES, effects, sample
from helpers.robots.sample_robots import Sample, published, random_robot
from pkmodes.core.base.errors import PoseError
from pkmodes.core.linalg.eigen import generalised_eigh

pytestmark = pytest.mark.usefixtures("backend")
ROBOT = Path(__file__).parents[2] / "robots" / "linear-delta-2022.toml"
PRINTER = ROBOT.with_name("corexy-printer.toml")
STIFFNESSES = (1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6)
#: Effects beside the springs, by the beginnings of their names.
BESIDE = {
    "nothing": (),
    "frame": ("frame_compliance",),
    "massless clamps": ("clamp_compliance",),
    "stiff joints": ("gearbox_compliance", "link_compliance"),
    "everything": ("clamp", "belt", "gearbox", "frame", "payload", "link"),
}


def assert_nine_digits(found: np.ndarray, modes: Exact) -> None:
    for f, value in zip(found, modes.eigenvalues, strict=True):
        expected = mp.sign(value) * mp.sqrt(abs(value)) / (2 * mp.pi)
        assert abs(mp.mpf(float(f)) / expected - 1) < 1e-9, (f, float(expected))


def scaled(name: str, seed: int, *, gravity: float, mass: float) -> Sample:
    """A sample with some of its gravity and a heavy or light platform."""
    robot = sample(name, seed)
    heavy = {"rotary_delta": "platform_mass", "corexy": "toolhead_mass"}[name]
    parameters = robot.parameters._replace(
        gravity=np.asarray(robot.parameters.gravity) * gravity,
        **{heavy: np.asarray(getattr(robot.parameters, heavy)) * mass},
    )
    return robot._replace(parameters=parameters)


@cache
def held(
    name: str, spring: str, beside: str, stiffness: float, gravity: float, mass: float, seed: int
) -> tuple[Sample, Any, Exact]:
    """A robot with a spring to ground and what is beside it, its effects, and its modes."""
    robot = scaled(name, seed, gravity=gravity, mass=mass)
    chosen = effects(name, BESIDE[beside])._replace(**{spring: stiffness})
    return robot, chosen, exact(name, robot, chosen)[1]


@pytest.mark.parametrize("beside", list(BESIDE))
@pytest.mark.parametrize("spring", ["cable_stiffness_stiffness", "servo_stiffness_stiffness"])
@pytest.mark.parametrize("name", NAMES)
def test_modes_of_held_robots_have_nine_digits(name: str, spring: str, beside: str) -> None:
    rng = np.random.default_rng([len(name), len(spring), len(beside)])
    for stiffness in rng.choice(STIFFNESSES[:-1], 4, replace=False):
        gravity, mass, seed = rng.choice([0.0, 1.0]), rng.choice([0.01, 1.0, 100.0]), int(rng.integers(3))
        robot, chosen, modes = held(name, spring, beside, stiffness, gravity, mass, seed)
        found = model_of(name, robot, chosen).modes(robot.pose)
        assert_nine_digits(found.frequencies, modes)
        M, rows = found.mass_matrix, modes.rows()
        assert np.abs(found.shapes @ M @ found.shapes.T - np.eye(len(rows))).max() < 1e-12
        # Of separate modes the shapes, too.
        values = modes.values()
        apart = np.abs(np.diff(values, prepend=-np.inf, append=np.inf)) > 1e-2 * np.abs(values).max()
        for k in np.flatnonzero(apart[:-1] & apart[1:]):
            assert abs(found.shapes[k] @ M @ rows[k]) == pytest.approx(1.0, abs=1e-9)


@cache
def unheld(name: str, gravity: float) -> tuple[Sample, np.ndarray, np.ndarray, np.ndarray]:
    """A linear delta with M, K and the platform's motion in 60 digits."""
    robot = published((0.6, 0.03, -0.245)) if name == "published" else random_robot(np.random.default_rng(1))
    pull = np.asarray(robot.parameters.gravity) * gravity
    robot = robot._replace(parameters=robot.parameters._replace(gravity=pull))
    oracle = Oracle(*robot)
    M, K = (np.array(matrix, dtype=object) for matrix in oracle.modal_matrices())
    return robot, M, K, np.array(oracle.platform_jacobian(), dtype=object)


def linear_delta(robot: Sample, cable: float, servo: float) -> pkmodes.Model:
    springs = {"cable_stiffness.stiffness": cable, "servo_stiffness.stiffness": servo}
    return pkmodes.Model(replace(pkmodes.read_robot(ROBOT), parameters=robot.parameters, effects=springs))


@cache
def modes_of(name: str, gravity: float, cable: float, servo: float) -> Exact:
    robot, M, K, J = unheld(name, gravity)
    K = K.copy()
    K[:3, :3] += mp.mpf(cable) * (J.T @ J)
    for j, pulley in np.argwhere(robot.parameters.drive):
        K[3 + 3 * pulley + j, 3 + 3 * pulley + j] += mp.mpf(servo)
    return solved(mp.matrix(M.tolist()), mp.matrix(K.tolist()))


@pytest.mark.parametrize("name", ["published", "random"])
def test_modes_of_a_held_linear_delta_have_nine_digits_or_it_is_refused(name: str) -> None:
    """The rails of the published one are level, so gravity leaves motion along them to the springs alone."""
    refused = []
    for gravity in (0.0, 1.0):
        robot, *_ = unheld(name, gravity)
        for cable, servo in [*((k, 0.0) for k in STIFFNESSES), (0.0, 1e-6), (0.0, 1e4), (1e-3, 1e2)]:
            try:
                found = linear_delta(robot, cable, servo).modes(robot.pose).frequencies
            except PoseError as error:
                assert "so soft that their vibration" in str(error)
                refused.append((gravity, cable))
            else:
                assert_nine_digits(found, modes_of(name, gravity, cable, servo))
    assert refused == ([(1.0, 1e-8), (1.0, 1e-6), (1.0, 1e-4)] if name == "published" else [])


def test_the_error_names_the_smallest_spring_that_is_resolved() -> None:
    robot, *_ = unheld("published", 1.0)
    model = linear_delta(robot, 1e-6, 0.0)
    with pytest.raises(PoseError) as caught:
        model.modes(robot.pose)
    assert "give effects.cable_stiffness.stiffness at least 0.0013 N/m, or leave it out" in str(caught.value)
    out = {"frequencies": np.full((2, 9), 7.0)}
    with pytest.raises(PoseError, match="cable_stiffness"):
        model.modes([robot.pose, robot.pose], out=out)
    assert (out["frequencies"] == 7.0).all()
    found = linear_delta(robot, 0.0013, 0.0).modes(robot.pose).frequencies
    assert_nine_digits(found, modes_of("published", 1.0, 0.0013, 0.0))


def test_a_motion_near_balance_between_spring_and_gravity_is_not_refused() -> None:
    """Upside down, gravity drives the platform away from the pose; bisection finds the cable that just holds it."""
    robot, *_ = unheld("published", 1.0)
    robot = robot._replace(parameters=robot.parameters._replace(gravity=np.array([0.0, 0.0, 9.81])))
    low, high = 1.0, 1e4
    for _ in range(50):
        middle = 0.5 * (low + high)
        f = linear_delta(robot, middle, 0.0).modes(robot.pose).frequencies
        low, high = (middle, high) if f[0] < 0 else (low, middle)
    assert abs(f[0]) < 1e-4
    assert f[3] > 50.0


@cache
def frequencies(cable: float | mp.mpf, head: float | mp.mpf) -> list[mp.mpf]:
    """All digits of a printer's frequencies with a cable and a tool head."""
    robot = sample("corexy", 1)
    moved = robot._replace(parameters=robot.parameters._replace(toolhead_mass=head))
    chosen = effects("corexy")._replace(cable_stiffness_stiffness=cable)
    values = exact("corexy", moved, chosen)[1].eigenvalues
    return [mp.sqrt(value) / (2 * mp.pi) for value in values]


@pytest.mark.parametrize("stiffness", [1e-8, 1e-2, 1e2])
def test_sensitivities_of_held_motions_have_nine_digits(stiffness: float) -> None:
    """Against differences in 60 digits; the first two modes are the held motions."""
    name, robot = "corexy", sample("corexy", 1)
    chosen = effects(name)._replace(cable_stiffness_stiffness=stiffness)
    model, step = model_of(name, robot, chosen), 1e-12

    head = float(robot.parameters.toolhead_mass)
    found = model.sensitivities(
        robot.pose, ["effects.cable_stiffness.stiffness", "toolhead.mass"], fields=["frequencies"]
    ).frequencies
    for k in range(4):
        for t, (at, moved) in enumerate(
            (
                (stiffness, lambda x, k=k: frequencies(x, head)[k]),
                (head, lambda x, k=k: frequencies(stiffness, x)[k]),
            )
        ):
            ahead, behind = mp.mpf(at) * (1 + mp.mpf(step)), mp.mpf(at) * (1 - mp.mpf(step))
            rate = (moved(ahead) - moved(behind)) / (ahead - behind)
            assert found[t, k] == pytest.approx(float(rate), rel=1e-9, abs=1e-9 * 1e-6 / at)


def test_without_keeping_the_parts_apart_the_digits_would_be_lost() -> None:
    """Otherwise the tests above would prove nothing."""
    robot, chosen = sample("corexy", 0), effects("corexy")._replace(cable_stiffness_stiffness=1e-6)
    _, modes, _ = exact("corexy", robot, chosen)
    M, K = model_of("corexy", robot, chosen).matrices(robot.pose)
    values, _ = generalised_eigh(M[None], K[None])
    assert np.abs(values[0] / modes.values() - 1.0).max() > 1e-6


@pytest.mark.parametrize(
    ("values", "blamed"),
    [
        ({"servo_stiffness.stiffness": 1e12}, "springs to ground softer: effects.servo_stiffness.stiffness"),
        ({"cable_stiffness.stiffness": 1e-3, "gearbox_compliance.compliance": 1e12}, "a joint is so soft"),
        ({"gearbox_compliance.compliance": 1e12}, "a joint is so soft"),
        ({"cable_stiffness.stiffness": 5e-324}, "leave them out: effects.cable_stiffness.stiffness"),
    ],
)
def test_what_cannot_be_resolved_is_refused(values: dict[str, float], blamed: str) -> None:
    model = pkmodes.Model(replace(load_free(PRINTER).robot, effects=values))
    for evaluate in (model.modes, lambda p: model.sensitivities(p, ["toolhead.mass"])):
        with pytest.raises(PoseError) as caught:
            evaluate([0.1, 0.1])
        assert blamed in str(caught.value)


def test_magnitudes_out_of_all_proportion_are_refused() -> None:
    """One belt far thinner than the others; gravity would mix its vibrations with the rigid-body modes."""
    robot, *_ = unheld("published", 0.0)
    refused = []
    for thin in (1.0, 1e-3, 1e-8, 1e-12):
        width = np.asarray(robot.parameters.belt_width) * [1.0, 1.0, thin]
        uneven = robot._replace(parameters=robot.parameters._replace(belt_width=width))
        model = linear_delta(uneven, 0.0, 0.0)
        for fields in (None, ("shapes",), ("frequencies",)):
            try:
                found = model.modes(robot.pose, fields=fields)
            except PoseError as error:
                assert "is lost in rounding against" in str(error)
                assert "check the robot's masses, inertias, lengths and stiffnesses" in str(error)
                refused.append(thin)
            else:
                if fields is None:
                    M, K = (np.array(a, dtype=object).tolist() for a in Oracle(*uneven).modal_matrices())
                    values = solved(mp.matrix(M), mp.matrix(K)).values()[3:]
                    expected = np.sqrt(values) / (2 * np.pi)
                    np.testing.assert_allclose(found.frequencies[3:], expected, rtol=1e-9)
    assert refused == [1e-8] * 3 + [1e-12] * 3
