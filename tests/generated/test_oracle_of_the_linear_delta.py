"""Every generated function against the independent model in 60 digits of `oracle`, value by value.

Derivatives, energies and balances are exact there to some 30 digits, so that what is left is the rounding of
the generated code alone, and any wrong term, sign, factor or exchange of two axes stands out by ten orders.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from helpers.generated.generated_functions import FUNCTIONS, arguments, outputs, scale
from helpers.references.oracle import Oracle
from helpers.robots.sample_robots import RANDOM, SAMPLES, sample
from pkmodes_generated.linear_delta import model

# Relative rounding error for each unit of the Frobenius condition number of D_l (between 3 and 12 here): 45
# units in the last place.  Rounding puts a few of these into the linkage vectors, from coordinates up to three
# linkage lengths long; solving with D_l multiplies them by at most its condition number, and the sums that
# follow have some tens of terms.  Measured over 40 random robots: at most 5 units for each unit of condition
# (belt_stiffness, of a span that is a short difference of long coordinates), 1 in the median.
ROUNDING = 1e-14


@cache
def oracle_at(name: str) -> Oracle:
    robot = sample(name)
    return Oracle(robot.parameters, robot.pose)


def tolerance(name: str) -> float:
    return ROUNDING * float(oracle_at(name).jacobian_condition()[1])


def test_oracle_has_every_public_function() -> None:
    assert FUNCTIONS, "no functions found: the inspection itself is wrong"
    missing = [name for name in FUNCTIONS if not callable(getattr(Oracle, name, None))]
    assert not missing, f"add to the oracle: {missing}"


def test_random_robots_show_every_choice() -> None:
    """Otherwise a wrong formula for one branch, one driven pulley or one assembly could go unnoticed."""
    robots = [sample(name) for name in RANDOM]
    for j in range(3):
        assert {robot.parameters.branch[j] for robot in robots} == {-1.0, 1.0}
        assert {int(robot.parameters.drive[j, 0]) for robot in robots} == {0, 1}
    assert {np.sign(model.jacobian_condition(r.pose, r.parameters)[0]) for r in robots} == {-1.0, 1.0}
    for robot in robots:
        assert np.all(model.belt_spans(robot.pose, robot.parameters) > 0), "carriage outside its limits"


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_agrees_with_oracle(name: str) -> None:
    wrong = []
    for robot_name in SAMPLES:
        robot = sample(robot_name)
        given = arguments(name, robot)
        extra = {key: value for key, value in given.items() if key not in ("p", "parameters")}
        expected = getattr(oracle_at(robot_name), name)(**extra)
        expected = expected if isinstance(expected, tuple) else (expected,)
        found = outputs(name, **given)
        assert len(found) == len(expected), robot_name
        for one, other in zip(found, expected, strict=True):
            reference = np.asarray(other, dtype=float)
            assert np.shape(one) == reference.shape, robot_name
            size = scale(reference)
            if name == "gravity_potential":
                # its zero is arbitrary: an energy is measured by the weight lifted through a metre
                size = size + _weight(robot_name)
            if not np.max(np.abs(one - reference) / size) < tolerance(robot_name):
                wrong.append(f"{robot_name}: {one} instead of {reference}")
    assert not wrong, "\n".join(wrong)


def test_other_assembly_agrees_with_oracle() -> None:
    wrong = []
    for robot_name in SAMPLES:
        robot = sample(robot_name)
        given = arguments("direct_kinematics", robot)
        given["assembly"] = -given["assembly"]
        expected = oracle_at(robot_name).direct_kinematics(given["x"], given["assembly"]).astype(float)
        found = model.direct_kinematics(**given)
        assert np.linalg.norm(expected - robot.pose) > 0.05, f"{robot_name}: not another solution"
        # the same bound: this solution is the mirror image in the plane of the sphere centres
        if not np.max(np.abs(found - expected)) < tolerance(robot_name) * scale(expected):
            wrong.append(f"{robot_name}: {found} instead of {expected}")
    assert not wrong, "\n".join(wrong)


def _weight(robot_name: str) -> float:
    q = sample(robot_name).parameters
    return float((q.platform_mass + np.sum(q.link_mass + q.carriage_mass)) * np.linalg.norm(q.gravity))
