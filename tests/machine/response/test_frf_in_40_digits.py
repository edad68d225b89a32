"""Frequency responses against linear systems of all coordinates in 40 digits."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from helpers.references.response_in_40_digits import assert_exact
from helpers.robots.damped_robots import DAMPED, DAMPING, DRIVES
from helpers.robots.one_of_each import FILES, POSES, model_of


@pytest.mark.parametrize("mechanism", FILES)
def test_every_channel_is_that_of_a_direct_solution(subtests: pytest.Subtests, mechanism: str) -> None:
    for case, drives in product(DAMPED, DRIVES):
        with subtests.test(f"{case}, {drives}"):
            effects, ratio = DAMPED[case]
            assert_exact(model_of(mechanism, effects, ratio=ratio), POSES[mechanism], drives)


@pytest.mark.parametrize("ratio", [1.0 - 1e-3, 1.0, 1.0 + 1e-12, 1.0 + 1e-9, 1.0 + 1e-5])
def test_near_critical_damping_of_coupled_motions(ratio: float) -> None:
    """Where two poles begin to be real they are equal, and their vectors, too: no residues exist."""
    model, p = model_of("corexy", {}), POSES["corexy"]
    M, K = (matrix[:2, :2] for matrix in model.matrices(p))  # motors held: x and y
    none, one = np.zeros((2, 2)), np.eye(2)
    below, above = 600.0, 800.0  # with and without oscillation
    for _ in range(80):
        middle = (below + above) / 2
        poles = np.linalg.eigvals(
            np.block([[none, one], [-np.linalg.solve(M, K), -middle * np.linalg.inv(M)]])
        )
        below, above = (middle, above) if poles.imag.any() else (below, middle)
    assert 650.0 < below < 750.0
    damped = model_of("corexy", {"rail_friction.viscous": below * ratio})
    assert_exact(damped, p, "held", np.array([0.0, 1.0, 40.0, 100.0, 1000.0]))


@pytest.mark.parametrize("joint", ["gearbox", "link", "clamp", "frame"])
def test_stiff_joints_take_no_digits_from_soft_motions(subtests: pytest.Subtests, joint: str) -> None:
    """A direct solution in double precision has errors below 1e-12 with free motors.

    With held ones a wind-up of less than 1e-15 rad/(N m) costs it digits, but not modal coordinates.
    """
    for compliance, drives in product([1e-6, 1e-9, 1e-12, 1e-20, 1e-30], DRIVES):
        with subtests.test(f"{compliance}, {drives}"):
            effects = {**DAMPING, f"{joint}_compliance.compliance": compliance}
            model, p = model_of("linear_delta", effects, ratio=0.01), POSES["linear_delta"]
            first = 1 if drives == "held" else 4
            soft = np.abs(model.frequencies(p, drives=drives)[first - 1 : first + 2])
            assert_exact(model, p, drives, np.array([5.0, *soft, 300.0]))
