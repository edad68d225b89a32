"""The oracle of machines with six legs, before anything is compared with it: charts, closed forms, and two engines.

It must agree with MuJoCo, which knows bodies and joints, with a table that Exudyn computed, which knows constraints,
with what a pencil finds for special machines, and, where its rods are pairs, with the linear delta of pkmodes.
"""

from __future__ import annotations

import json
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.references.oracle_six_legged import CHARTS, SixLegged, modes, oracle, result
from helpers.references.six_legs_by_hand import orthogonal, pairs, together, vertical
from helpers.references.six_legs_compared import ENGINE_TOLERANCES, by_diagonal, engine_errors, load, relative
from helpers.robots.six_legged import (
    LARGEST_CONDITION,
    MACHINES,
    Case,
    drawn,
    toml_text,
)

NAMES = tuple(MACHINES)
SEEDS = range(2)
TABLE = Path(__file__).with_name("exudyn_six_legs.json")


def jacobian(it: SixLegged) -> np.ndarray:
    """Derivatives of legs or carriages by the motion of the platform, which is not inverted here."""
    return np.array(it.slopes(lambda y: it.drives(it.place(y))).tolist(), dtype=float)[:, :6]


@pytest.mark.parametrize(("name", "seed"), list(product(NAMES, SEEDS)))
def test_bodies_and_joints_in_mujoco(name: str, seed: int) -> None:
    found = engine_errors(MACHINES[name](seed))
    assert found.keys() == ENGINE_TOLERANCES.keys()
    for quantity, error in found.items():
        assert error < ENGINE_TOLERANCES[quantity], quantity


@pytest.mark.parametrize("name", NAMES)
def test_stiffness_does_not_depend_on_the_chart_of_rotations(name: str) -> None:
    case = drawn(name, 1)
    first, *others = (oracle(*case, chart).gravity_hessian().astype(float) for chart in CHARTS)
    for other in others:
        assert relative(other, first) < 1e-15


def test_charts_are_different() -> None:
    """Otherwise their agreement would say nothing: second derivatives of the pose differ."""
    case = MACHINES["hexapod"](0)
    second = [oracle(*case, chart).curvatures(_drives(case, chart))[3, 4] for chart in CHARTS]
    for one, other in ((0, 2), (1, 2)):
        assert np.abs((second[one] - second[other]).astype(float)).max() > 1e-3


def _drives(case: Case, chart: str) -> Any:
    it = oracle(*case, chart)
    return lambda y: it.drives(it.place(y))


@pytest.mark.parametrize(
    "entry", json.loads(TABLE.read_text(encoding="utf-8")), ids=lambda e: e["machine"]["name"]
)
def test_frequencies_by_exudyn(entry: dict[str, Any]) -> None:
    found = result(entry["machine"], entry["pose"])
    np.testing.assert_allclose(modes(found.M, found.K).frequencies[6:], entry["free"], rtol=1e-11)
    held = modes(found.M, found.K, found.motors).frequencies
    np.testing.assert_allclose(held, entry["held"], rtol=1e-11)


@pytest.mark.parametrize("weight", [False, True])
def test_two_legs_along_each_axis(weight: bool) -> None:
    case, by_hand = orthogonal(weight=weight)
    found = result(*case)
    # legs of 1e-12 of their mass; else rounding
    tolerance = 1e-11 if weight else 1e-14
    assert relative(found.M, by_hand.M) < tolerance
    assert relative(found.K_g[:6, :6], (by_hand.K - _springs(by_hand.K))[:6, :6]) < 1e-9
    assert relative(found.K, by_hand.K) < 1e-14
    assert relative(found.statics, by_hand.statics) < tolerance
    np.testing.assert_allclose(
        modes(found.M, found.K, found.motors).frequencies, by_hand.held, rtol=tolerance
    )
    if not weight:
        np.testing.assert_allclose(modes(found.M, found.K).frequencies[6:], by_hand.free, rtol=1e-13)


def _springs(K: np.ndarray) -> np.ndarray:
    """Stiffness of the springs alone: gravity has no part in that of the motors."""
    k = np.diag(np.diag(K)[6:])
    return np.block([[k, -k], [-k, k]])


def test_six_vertical_legs_know_nothing_of_x_y_and_a_rotation_about_z() -> None:
    case, rows = vertical()
    J = jacobian(oracle(*case))
    assert np.abs(J - rows).max() < 1e-15
    assert np.linalg.matrix_rank(J) == 3


@pytest.mark.parametrize("with_all", [False, True])
def test_pairs_of_parallel_rods_are_a_linear_delta(with_all: bool, tmp_path: Path) -> None:
    it = pairs(0, effects=with_all)
    delta, found = load(it.delta, tmp_path), result(*it.six)
    S = together(found.coordinates, delta.coordinates)
    M, K = delta.matrices(it.position)
    # measured over 6 machines: 1e-14 of the largest entry
    assert by_diagonal(S.T @ found.M @ S, M) < 1e-13
    assert by_diagonal(S.T @ found.K @ S, K) < 1e-13
    torques = delta.statics(it.position).torques
    assert relative(found.statics.reshape(3, 2).sum(axis=1), torques) < 1e-13


@pytest.mark.parametrize("name", NAMES)
def test_machines_are_plausible(name: str) -> None:
    for seed in range(20):
        case = MACHINES[name](seed)
        it = oracle(*case)
        J = jacobian(it)
        size = np.linalg.norm([axis["joint"] for axis in case.machine["axis"]], axis=1).max()
        assert np.linalg.cond(J / [1, 1, 1, size, size, size]) < 2 * LARGEST_CONDITION
        for axis, where in zip(case.machine["axis"], it.drives(it.place(it.at())), strict=True):
            low, high = axis["limits"]
            assert low < where < high
        assert np.linalg.norm(case.pose[3:]) < np.pi / 2
        xx, yy, zz = case.machine["platform"]["inertia"]
        xy, xz, yz = case.machine["platform"]["products"]
        one, two, three = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        assert 0 < three < one + two


def test_the_same_seed_gives_the_same_file() -> None:
    for name, seed in product(NAMES, SEEDS):
        assert toml_text(MACHINES[name](seed).machine) == toml_text(MACHINES[name](seed).machine)
