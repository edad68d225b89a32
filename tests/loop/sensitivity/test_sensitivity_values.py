"""Exact sensitivities along every parameter path, compared with differences and complex steps.

The references are in `sensitivity_references`, the robots and poses in `sensitivity_cases`.
"""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.references.sensitivity_references import (
    AHEAD,
    CENTRAL,
    Rates,
    ahead,
    by_complex_steps,
    by_differences,
    eigenvalues,
    is_locked,
)
from helpers.robots.sensitivity_cases import CASES, Array, Case, assert_small, case, system_of
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives
from pkmodes.loop.sensitivity.paths import ParameterPath, change_quantities, resolve


def assert_matrices(case: Case, i: int, t: slice, expected: Rates, relative: float, rounding: Array) -> None:
    """Scale the coordinates so that all entries of K, and of M times the largest eigenvalue, are of order one."""
    pose, found = case.here[i], case.found
    unit = np.outer(pose.scale, pose.scale)
    locked = np.array([is_locked(case.robot, move) for move in case.moves[t]])
    largest = np.abs(pose.eigenvalues).max()
    for values, reference, factor in (
        (found.mass_matrix[i, t], expected.M, largest),
        (found.stiffness_matrix[i, t], expected.K, 1.0),
    ):
        assert np.isnan(values[locked]).all()
        error = (np.abs(values - reference) * unit * factor)[~locked].max(axis=(1, 2), initial=0.0)
        scale = (np.abs(reference) * unit * factor)[~locked].max(axis=(1, 2), initial=0.0)
        assert_small(error, relative * scale + rounding[~locked], "matrices")


def assert_modes(case: Case, i: int, t: slice, expected: Rates, relative: float, rounding: Array) -> None:
    """Compare errors with each mode's derivative and, below it, with rounding of the largest eigenvalue.

    Rounding of shapes is amplified by their condition number, the largest eigenvalue over the gap.
    """
    pose, found = case.here[i], case.found
    floor = (rounding * expected.largest)[:, None]
    error = np.abs(found.eigenvalues[i, t] - expected.eigenvalues)
    paths = case.names[t]
    assert_small(error, relative * np.abs(expected.eigenvalues) + floor, "eigenvalues", paths)
    error, scale, shape = (
        np.abs(s / pose.scale).max(axis=-1)
        for s in (found.shapes[i, t] - expected.shapes, expected.shapes, pose.shapes)
    )
    assert_small(error, relative * scale + 100 * floor / pose.gaps * shape, "shapes", paths)


@pytest.mark.parametrize("name", CASES)
def test_derivatives_equal_complex_steps(name: str) -> None:
    it = case(name)
    for i, pose in enumerate(it.here):
        expected = by_complex_steps(pose, it.moves, it.sizes)
        assert_matrices(it, i, slice(None), expected, 1e-11, 1e-14 / it.sizes)
        assert_modes(it, i, slice(None), expected, 1e-8, 1e-14 / it.sizes)


@pytest.mark.parametrize("name", CASES)
def test_derivatives_equal_differences_of_the_modes(name: str) -> None:
    """Steps are small compared with the smallest gap, so truncation stays below a millionth."""
    it = case(name)
    gap = min((pose.gaps[3:] / np.abs(pose.eigenvalues[3:])).min() for pose in it.here)
    for t, (move, scale) in enumerate(zip(it.moves, it.sizes, strict=True)):
        at, step, stencil = slice(t, t + 1), min(1e-5, 0.01 * gap) * scale, CENTRAL
        if is_locked(it.robot, move):
            step, stencil = min(ahead(pose, move) for pose in it.here), AHEAD
        elif move.path == "effects.belt_mass.linear_density" and name.endswith("-clamp"):
            # It adds the modes of the clamps: far away, but not so far that their rounding dominates.
            step, stencil = (
                2e-3 * it.robot.parameters.pulley_inertia[0] / it.robot.parameters.pulley_radius[0] ** 2,
                AHEAD,
            )
        for i, expected in enumerate(by_differences(it.here, move, step, stencil)):
            rounding = np.array([1e-14 / step])
            assert_matrices(it, i, at, expected, 1e-6, rounding)
            assert_modes(it, i, at, expected, 1e-6, rounding)


@pytest.mark.parametrize("name", CASES)
def test_frequencies_follow_from_their_definition(name: str) -> None:
    it = case(name)
    for i, pose in enumerate(it.here):
        f = np.sqrt(np.abs(pose.eigenvalues)) / (2 * np.pi)
        still = np.abs(pose.eigenvalues) < 1e-12 * np.abs(pose.eigenvalues).max()
        assert still.sum() == (name in ("published", "published-clamp", "tower", "tower-clamp")), (
            "a mode at 0 Hz"
        )
        expected = it.found.eigenvalues[i] / np.where(still, np.nan, 8 * np.pi**2 * f)
        np.testing.assert_allclose(it.found.frequencies[i], expected, rtol=1e-12)


def test_frequencies_of_unstable_modes_are_negative_and_so_differentiated() -> None:
    it = case("random")
    gravity = [
        (resolve(it.robot, f"gravity.{x}"), -2 * it.robot.parameters.gravity[k]) for k, x in enumerate("xyz")
    ]
    signs = set()
    for robot in (it.robot, change_quantities(it.robot, gravity)):
        model, mass = pkmodes.Model(robot), resolve(robot, "platform.mass")
        f = model.modes(it.poses).frequencies[0]
        difference = sum(
            weight
            / 1e-2
            * pkmodes.Model(change_quantities(robot, [(mass, multiple * 1e-2)]))
            .modes(it.poses)
            .frequencies[0]
            for multiple, weight in CENTRAL.items()
        )
        found = model.sensitivities(it.poses, ["platform.mass"]).frequencies[0, 0]
        np.testing.assert_allclose(found, difference, rtol=1e-6)
        signs |= set(np.sign(f))
    assert signs == {-1.0, 1.0}


@pytest.mark.parametrize("name", CASES)
def test_eigenvalues_alone_are_those_of_the_whole(name: str) -> None:
    it = case(name)
    derivatives = MatrixDerivatives(system_of(it.robot), it.poses, [it.moves])
    values, shapes = (
        np.array([getattr(pose, field) for pose in it.here]) for field in ("eigenvalues", "shapes")
    )
    found = np.swapaxes(derivatives.eigenvalues(values, shapes), 1, 2)
    for i, pose in enumerate(it.here):
        floor = 1e-14 * np.abs(pose.eigenvalues).max() / it.sizes
        for members in pose.members:
            a, b = found[i][:, members], it.found.eigenvalues[i][:, members]
            # In a group they are along its basis: only their sum equals that of the branches.
            error = np.abs(a.sum(axis=1) - b.sum(axis=1))
            assert_small(error, 1e-9 * np.abs(b).max(axis=1) + 2 * floor, "sums")


@pytest.mark.parametrize("name", ["random", "random-active", "published-clamp"])
def test_moving_all_joints_is_moving_the_platform(name: str) -> None:
    it, step = case(name), 1e-5
    for k in range(3):
        shift = ParameterPath("pose", 0.0, "m", {("joint", (j, k)): 1.0 for j in range(3)})
        derivatives = MatrixDerivatives(system_of(it.robot), it.poses[:1], [[shift]])
        pose = it.here[0]
        found = derivatives.eigenvalues(pose.eigenvalues[None], pose.shapes[None])[0, :, 0]
        unit, difference = np.eye(3)[k], np.zeros(len(found))
        for multiple, weight in CENTRAL.items():
            at = it.poses[0] + multiple * step * unit
            difference += weight / step * eigenvalues(pkmodes.Model(it.robot).modes(at).frequencies)
        floor = 1e-14 * np.abs(pose.eigenvalues).max() / step
        assert_small(np.abs(found - difference), 1e-7 * np.abs(difference) + floor, "shift")
