"""Every public function of the base models of the rotary delta and the CoreXY against the oracle in 60 digits.

`test_oracle` covers the matrices and torques; these tests cover kinematics, energies, their derivatives, and velocity
forces.  Functions are found by inspection: one added to a model is either compared or named by a failing test.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest

from helpers.references.high_precision_mechanisms import (
    STEP,
    HighPrecision,
    combine,
    cross,
    dot,
    exact,
    minus,
    mp,
    plus,
)
from helpers.references.oracle_rotary_delta import RotaryDelta
from helpers.robots.sample_mechanisms import NAMES, SEEDS, Sample, effects, model, oracle, sample

#: Per unit of the condition number of D_l, as in `test_oracle`; measured: at most 4e-16.
ROUNDING = 3e-15
#: Compared in `test_oracle`, or in the tests of kinematics and closed forms, which are stricter than an oracle.
ELSEWHERE = {
    *("mass_matrix", "stiffness_matrix", "elastic_hessian", "modal_matrices", "static_equilibrium"),
    *("inverse_kinematics", "direct_kinematics", "reach_margin", "limit_margin", "inertia_margin"),
    *(
        "perpendicular_margin",
        "belt_spans",
        "belt_stiffness",
        "run_margin",
        "travel_margin",
        "crossing_margin",
    ),
}
Expected = Callable[[HighPrecision, dict[str, Any]], tuple[Any, ...]]


def functions(name: str) -> dict[str, Callable[..., Any]]:
    module = model(name)
    members = inspect.getmembers(module, inspect.isfunction)
    return {key: f for key, f in members if f.__module__ == module.__name__ and not key.startswith("_")}


def given(name: str, robot: Sample) -> dict[str, Any]:
    """Return the arguments of any function by name, with random velocities and displacements."""
    rng = np.random.default_rng(3)
    n = len(model(name).COORDINATES)
    velocity = rng.normal(size=n)
    independent = velocity[: n // 2]
    return {
        "p": robot.pose,
        "parameters": robot.parameters,
        "q_dot": velocity,
        "theta_dot": independent,
        "xy_dot": independent,
        "delta_q": 1e-2 * rng.normal(size=n),
    }


def padded(it: HighPrecision, values: Any) -> list[Any]:
    """Return the exact displacements of all coordinates from those of the first ones."""
    first = list(exact(values))
    return first + [mp.mpf(0)] * (it.size - len(first))


def velocity(g: dict[str, Any]) -> Any:
    return g["theta_dot"]


def platform_second_derivatives(it: HighPrecision, _: dict[str, Any]) -> tuple[Any, ...]:
    n = it.independent
    components = range(len(it.platform(it.at())))
    by_component = [it.hessian(lambda q, i=i: it.platform(q)[i])[:n, :n] for i in components]
    return (np.array(by_component),)


def platform_jacobian_rate(it: HighPrecision, g: dict[str, Any]) -> tuple[Any, ...]:
    (P,) = platform_second_derivatives(it, g)
    return (P @ np.array(exact(velocity(g)), dtype=object),)


def kinetic_energy(it: HighPrecision, g: dict[str, Any]) -> tuple[Any, ...]:
    """Return the kinetic energies of structure and transmissions, which share no coordinate."""
    M = it.mass_matrix()
    n, q_dot = it.independent, np.array(padded(it, g["q_dot"]), dtype=object)
    parts = q_dot.copy(), q_dot.copy()
    parts[0][n:], parts[1][:n] = mp.mpf(0), mp.mpf(0)
    return tuple(part @ M @ part / 2 for part in parts)


def velocity_forces(it: HighPrecision, g: dict[str, Any]) -> tuple[Any, ...]:
    """Return, by d'Alembert, the forces that accelerate every particle along the path of constant rates."""
    along = padded(it, velocity(g))
    ahead, here, behind = (it.particles([step * rate for rate in along]) for step in (STEP, mp.mpf(0), -STEP))
    columns = it.columns(lambda q: [particle.position for particle in it.particles(q)])
    forces = [mp.mpf(0)] * it.independent
    for i, (a, b, c) in enumerate(zip(ahead, here, behind, strict=True)):
        sums = plus(combine(a.position, -2, b.position), c.position)
        for k in range(it.independent):
            forces[k] += b.mass * dot(columns[k][i], sums) / STEP**2
    return (np.array(forces, dtype=object),)


def elastic_gradient(it: HighPrecision, g: dict[str, Any]) -> tuple[Any, ...]:
    strained = padded(it, g["delta_q"])
    gradient = it.gradient(lambda q: it.transmission(plus(strained, q)))
    return (np.array(gradient[: it.base], dtype=object),)


def constraint_jacobians(it: RotaryDelta, _: dict[str, Any]) -> tuple[Any, ...]:
    """Difference half the squared link lengths by the platform, and by the arms with opposite sign."""
    loops, zero = it.loops, [mp.mpf(0)] * 3

    def half_squares(moved: list[Any], turned: list[Any]) -> np.ndarray:
        found = []
        for j in range(3):
            joint = plus(plus(it.pose, moved), loops.joint[j])
            link = minus(joint, loops.arm(j, loops.theta[j] + turned[j], loops.arm_length[j]))
            found.append(dot(link, link) / 2)
        return np.array(found, dtype=object)

    steps = [[STEP * (i == k) for i in range(3)] for k in range(3)]
    back = [[-step for step in row] for row in steps]
    D_l = [
        (half_squares(a, zero) - half_squares(b, zero)) / (2 * STEP) for a, b in zip(steps, back, strict=True)
    ]
    D_r = [
        (half_squares(zero, b) - half_squares(zero, a)) / (2 * STEP) for a, b in zip(steps, back, strict=True)
    ]
    return np.array(D_l).T, np.array(D_r).T


def jacobian_condition(it: RotaryDelta, g: dict[str, Any]) -> tuple[Any, ...]:
    D_l = mp.matrix(constraint_jacobians(it, g)[0].tolist())
    return mp.det(D_l), mp.mnorm(D_l, "f") * mp.mnorm(mp.inverse(D_l), "f")


def link_jacobians(it: RotaryDelta, _: dict[str, Any]) -> tuple[Any, ...]:
    """Return the velocity of each rod's midpoint, and s x s_dot / l^2 of the rod vector s, for unit arm rates."""
    D_d, D_omega = np.empty((2, 3, 3, 3), dtype=object)
    for j in range(3):
        first, last = it._ends_of_link(j, it.at())
        s = minus(last, first)
        columns = it.columns(lambda q, j=j: list(it._ends_of_link(j, q)))
        for k in range(3):
            start, end = columns[k]
            D_d[j, :, k] = [(a + b) / 2 for a, b in zip(start, end, strict=True)]
            D_omega[j, :, k] = [c / dot(s, s) for c in cross(s, minus(end, start))]
    return D_d, D_omega


EXPECTED: dict[str, Expected] = {
    "platform_jacobian": lambda it, _: (it.platform_motion()[:, : it.independent],),
    "gravity_potential": lambda it, _: (it.weight(it.at()),),
    "gravity_gradient": lambda it, _: (np.array(it.gradient(it.weight)[: it.independent], dtype=object),),
    "gravity_hessian": lambda it, _: (it.gravity_hessian()[: it.independent, : it.independent],),
    "elastic_potential": lambda it, g: (it.transmission(padded(it, g["delta_q"])),),
} | {
    function.__name__: function
    for function in (
        platform_second_derivatives,
        platform_jacobian_rate,
        kinetic_energy,
        velocity_forces,
        elastic_gradient,
        constraint_jacobians,
        jacobian_condition,
        link_jacobians,
    )
}
CHOICES = [(name, function) for name in NAMES for function in EXPECTED if function in functions(name)]


@cache
def condition(name: str, seed: int) -> float:
    it = oracle(name, sample(name, seed), effects(name))
    return float(jacobian_condition(it, {})[1]) if isinstance(it, RotaryDelta) else 1.0


@pytest.mark.parametrize("name", NAMES)
def test_every_public_function_is_compared(name: str) -> None:
    assert set(functions(name)) - ELSEWHERE <= set(EXPECTED)
    assert len(functions(name)) > 15, "the inspection itself is wrong"


def assert_function(name: str, function: str, seed: int) -> None:
    robot = sample(name, seed)
    known = given(name, robot)
    call = functions(name)[function]
    found = call(**{key: known[key] for key in inspect.signature(call).parameters})
    found = found if isinstance(found, tuple) else (found,)
    expected = EXPECTED[function](oracle(name, robot, effects(name)), known)
    for one, other in zip(found, expected, strict=True):
        reference = np.asarray(other, dtype=float)
        assert np.shape(one) == reference.shape
        size = np.abs(reference).max()
        if function == "gravity_potential":
            size += 10.0  # its zero is arbitrary: scaled by a kilogram lifted through a metre
        if size < 1e-15:  # zero in a plane
            assert not np.any(one)
        else:
            assert np.abs(one - reference).max() < ROUNDING * condition(name, seed) * size


def test_agrees_with_the_oracle(subtests: pytest.Subtests) -> None:
    for (name, function), seed in product(CHOICES, SEEDS):
        with subtests.test(f"{name}, {function}, {seed}"):
            assert_function(name, function, seed)


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_of_robots_and_poses_is_each_of_them(name: str) -> None:
    """Every function takes two batch axes, robots along one and displacements along the other."""
    robots = [sample(name, seed) for seed in SEEDS]
    stacked = type(robots[0].parameters)(*map(np.array, zip(*(r.parameters for r in robots), strict=True)))
    poses = np.array([robot.pose for robot in robots])
    for call in functions(name).values():
        names = inspect.signature(call).parameters
        if "assembly" in names:
            continue
        known = {**given(name, robots[0]), "p": poses, "parameters": stacked}
        together = call(**{key: known[key] for key in names})
        for i, robot in enumerate(robots):
            one = call(
                **{key: {**known, "p": robot.pose, "parameters": robot.parameters}[key] for key in names}
            )
            pairs = zip(together, one, strict=True) if isinstance(one, tuple) else [(together, one)]
            for many, single in pairs:
                np.testing.assert_allclose(
                    many[i] if np.ndim(many) > np.ndim(single) else many, single, rtol=1e-13, atol=1e-15
                )


@pytest.mark.parametrize("name", NAMES)
def test_complex_steps_of_the_pose_are_its_differences(name: str) -> None:
    """Complex arguments are used as they are, not reduced to their real part."""
    robot = sample(name, 1)
    known, along = given(name, robot), np.linspace(0.6, -0.8, len(robot.pose))
    moving = 0
    for key, call in functions(name).items():
        names = inspect.signature(call).parameters
        if "p" not in names:
            continue

        def outputs(p: np.ndarray, call: Any = call, names: Any = names) -> list[np.ndarray]:
            found = call(**{key: p if key == "p" else known[key] for key in names})
            return [np.asarray(output) for output in (found if isinstance(found, tuple) else (found,))]

        exactly = [np.imag(output) / 1e-30 for output in outputs(robot.pose + 1e-30j * along)]
        h = 1e-4
        sides = zip(outputs(robot.pose + h * along), outputs(robot.pose - h * along), strict=True)
        for one, (ahead, behind) in zip(exactly, sides, strict=True):
            difference = (ahead - behind) / (2 * h)
            # truncation h^2 over lengths of a tenth of a metre, and rounding over the step
            bound = 1e-5 * np.abs(difference).max() + 1e-11 * np.abs(ahead).max()
            assert np.abs(one - difference).max() <= bound, key
            moving += bool(np.abs(one).max() > 0)
    assert moving >= (12 if name == "rotary_delta" else 6)
