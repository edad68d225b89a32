"""The measurements of the virtual test rig are as requested: noise, gaps, order, shapes and poses."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from helpers.diagnoses.diagnose_command import SHAPES, rows_of
from pkmodes_generated.linear_delta import belt_spans, jacobian_condition
from pkmodes_rig.engine import TrueModes, true_modes
from pkmodes_rig.measurements import Identified, measure, measure_modes, written
from pkmodes_rig.robots import POSES, ROBOTS, read

POSE = POSES["published"]["grid"][4]


@cache
def modes() -> TrueModes:
    return true_modes(read("published").parameters, POSE)


def many(count: int, seed: int = 1, **options: object) -> list[dict[str, str]]:
    """The same modes measured at one pose under many labels."""
    rng = np.random.default_rng(seed)
    return rows_of(measure_modes([modes()] * count, [POSE] * count, rng=rng, **options))


def errors(found: list[dict[str, str]]) -> np.ndarray:
    """Logarithms of measured over true frequencies, one row for each pose."""
    true = modes().frequencies[3:]
    by_pose: dict[str, np.ndarray] = {}
    for row in found:
        f = float(row["frequency"])
        i = int(np.argmin(np.abs(f / true - 1)))
        by_pose.setdefault(row["pose"], np.full(len(true), np.nan))[i] = np.log(f / true[i])
    return np.array(list(by_pose.values()))


def test_noise_is_of_the_size_that_was_asked_for() -> None:
    found = errors(many(400, sigma=1e-3))
    assert np.nanstd(found) == pytest.approx(1e-3, rel=0.1)
    assert np.nanmean(found) == pytest.approx(0.0, abs=1e-4)
    assert np.nanstd(np.nanmean(found, axis=1)) == pytest.approx(1e-3 / np.sqrt(6), rel=0.2)
    shared = errors(many(400, sigma=1e-4, common=1e-3))
    assert np.nanstd(np.nanmean(shared, axis=1)) == pytest.approx(1e-3, rel=0.15)
    assert np.nanmean(np.nanstd(shared, axis=1)) == pytest.approx(1e-4, rel=0.2)


def test_stated_uncertainty_may_be_wrong_by_a_factor() -> None:
    for row in many(3, sigma=2e-3, sigma_scale=0.5):
        assert float(row["sigma"]) == pytest.approx(1e-3 * float(row["frequency"]), rel=1e-8)


def test_modes_are_missed_and_rows_are_in_disorder() -> None:
    found = many(200, missing=0.25)
    assert len(found) == pytest.approx(0.75 * 6 * 200, rel=0.08)
    assert [row["pose"] for row in found] != sorted((row["pose"] for row in found), key=lambda s: int(s[1:]))
    numbers = {
        row["mode"] for row in found if abs(float(row["frequency"]) / modes().frequencies[3] - 1) < 0.01
    }
    assert len(numbers) > 6  # says nothing about which mode it is


def test_seeds_reproduce_and_differ() -> None:
    assert many(5, 7, shapes=SHAPES, missing=0.2) == many(5, 7, shapes=SHAPES, missing=0.2)
    assert many(5, 7) != many(5, 8)


def test_poses_keep_their_labels() -> None:
    parameters, poses = read("tower").parameters, POSES["tower"]["line"][:3]
    text = measure(parameters, poses, rng=np.random.default_rng(0), labels=["a", "b", "c"], modes=4)
    found = rows_of(text)
    assert Counter(row["pose"] for row in found) == {"a": 4, "b": 4, "c": 4}
    for row in found:
        p = poses["abc".index(row["pose"])]
        assert [float(row[axis]) for axis in "xyz"] == pytest.approx(list(p), rel=1e-8)


def test_shapes_are_scaled_arbitrarily_and_noisy() -> None:
    found = many(60, shapes=SHAPES, shape_noise=0.02)
    true = np.array([modes().shapes[name] for name in SHAPES]).T[3:]
    true /= np.abs(true).max(axis=1, keepdims=True)
    left, scales = [], []
    for row in found:
        measured = np.array([float(row[f"shape:{name}"]) for name in SHAPES])
        i = int(np.argmin(np.abs(float(row["frequency"]) / modes().frequencies[3:] - 1)))
        scale = measured @ true[i] / (true[i] @ true[i])
        left.append(measured / scale - true[i])
        scales.append(scale)
    # One of six components is taken up by the scale.
    assert np.std(left) == pytest.approx(0.02 * np.sqrt(5 / 6), rel=0.1)
    assert min(scales) < -3
    assert max(scales) > 3
    assert 0.3 < np.mean(np.sign(scales) > 0) < 0.7


def test_sensors_at_nodes_of_a_mode_tell_no_shape() -> None:
    row = Identified(0, 3, 50.0, 0.1, 0.1, 1, np.array([1.0, -0.5]), 0.02)
    rows = [replace(row, shape=shape) for shape in (row.shape, np.zeros(2), np.full(2, np.nan))]
    cells = rows_of(written(rows, [POSE], ["x", "y"], sigma_shape=True))
    assert [cell["shape:x"] for cell in cells] == ["1", "", ""]
    assert [cell["sigma_shape"] for cell in cells] == ["0.02", "", ""]


def test_modes_that_were_rigid_are_found_when_something_ties_the_robot_to_ground() -> None:
    parameters, rng = read("published").parameters, np.random.default_rng(0)
    effects = {"cable_stiffness.stiffness": 2e4}
    found = rows_of(measure(parameters, [POSE], effects=effects, rng=rng, sigma=1e-6))
    true = true_modes(parameters, POSE, effects)
    assert true.rigid == 0
    expected = true.frequencies[true.frequencies > 2.0]
    np.testing.assert_allclose(sorted(float(row["frequency"]) for row in found), expected, rtol=1e-5)
    assert len(found) == 9
    hose = rows_of(measure(parameters, [POSE], outside={"hose": 2e4}, rng=rng))
    assert len(hose) == 7  # one of the three only


def test_a_robot_that_warms_up_drifts_in_the_order_of_measuring() -> None:
    parameters, rng = read("published").parameters, np.random.default_rng(0)
    text = measure(
        parameters, [POSE] * 3, outside={"thermal_drift": -0.01}, rng=rng, sigma=1e-9, shapes=("x_1",)
    )
    for row in rows_of(text):
        ratio = float(row["frequency"]) / modes().frequencies[3:]
        assert np.abs(ratio - (1 - 0.01 * (int(row["pose"][1:]) - 1))).min() < 1e-7


@pytest.mark.parametrize("name", ROBOTS)
def test_robots_stand_well_at_their_poses(name: str) -> None:
    robot = read(name)
    uncertain = {path for path, quantity in robot.quantities.items() if quantity.sigma is not None}
    assert uncertain == {"platform.mass", "belt.specific_stiffness", "motor.inertia"}
    assert len(POSES[name]) >= 3
    for poses in POSES[name].values():
        assert np.shape(poses) == (12, 3)
        assert belt_spans(np.array(poses), robot.parameters).min() >= 0.1
        assert jacobian_condition(np.array(poses), robot.parameters)[1].max() < 5
