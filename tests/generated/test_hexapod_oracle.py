"""Hexapod and hexaglide as a user has them, from a robot file to modes, against 60 digits from their contract.

The oracle (`oracle_six_legged`) shares no code with the derivation; `test_six_legged_oracle` holds it against two
engines and closed forms.  Machines are random, each with other effects; two hundred of each are tried by
`benchmarks/six_legs.py`.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.references.oracle_six_legged import result
from helpers.references.six_legs_by_hand import orthogonal, pairs, together, vertical
from helpers.references.six_legs_compared import (
    by_diagonal,
    disagreements,
    errors,
    load,
    matrix_errors,
    mode_errors,
    relative,
)
from helpers.robots.six_legged import MACHINES, Case, drawn, effects, rotation, with_effects

NAMES = tuple(MACHINES)
TABLE = Path(__file__).with_name("exudyn_six_legs.json")


@pytest.mark.parametrize("seed", range(7))
@pytest.mark.parametrize("name", NAMES)
def test_random_machines(name: str, seed: int, tmp_path: Path) -> None:
    """The first without effects, the second with all."""
    case = drawn(name, seed)
    model, expected = load(case.machine, tmp_path), result(*case)
    assert not disagreements(matrix_errors(model, case, expected))
    assert not disagreements(mode_errors(model, case, expected))


def test_each_effect_by_itself(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for name in NAMES:
        case = MACHINES[name](8)
        for effect in effects(case):
            with subtests.test(f"{name}, {effect}"):
                one = with_effects(case, [effect])
                expected, model = result(*one), load(one.machine, tmp_path)
                assert model.coordinates == expected.coordinates
                M, K = model.matrices(one.pose)
                assert by_diagonal(M, expected.M) < 1e-12
                assert by_diagonal(K, expected.K) < 1e-12


def test_a_frame_that_yields_by_direction(tmp_path: Path) -> None:
    case = MACHINES["hexapod"](2)
    yields = {f"compliance_{axis}": c for axis, c in zip("xyz", (1e-7, 3e-7, 2e-8), strict=True)}
    one = Case({**case.machine, "effects": {"frame_compliance": yields}}, case.pose)
    assert not disagreements(errors(one, tmp_path))


@pytest.mark.parametrize("weight", [False, True])
def test_two_legs_along_each_axis(weight: bool, tmp_path: Path) -> None:
    case, by_hand = orthogonal(weight=weight)
    model = load(case.machine, tmp_path)
    M, K = model.matrices(case.pose)
    tolerance = 1e-11 if weight else 1e-13
    assert relative(M, by_hand.M) < tolerance
    assert relative(K, by_hand.K) < 1e-13
    assert relative(model.statics(case.pose).torques, by_hand.statics) < tolerance
    held = model.modes(case.pose, drives="held").frequencies
    np.testing.assert_allclose(held, by_hand.held, rtol=tolerance)
    if not weight:
        free = model.modes(case.pose)
        assert free.rigid_modes == 6
        np.testing.assert_allclose(free.frequencies[6:], by_hand.free, rtol=1e-13)


def test_six_vertical_legs_are_singular(tmp_path: Path) -> None:
    case, _ = vertical()
    model = load(case.machine, tmp_path)
    assert model.check(case.pose).reason == "singular"
    with pytest.raises(pkmodes.PoseError, match="singular"):
        model.modes(case.pose)


@pytest.mark.parametrize("with_all", [False, True])
def test_pairs_of_parallel_rods_are_a_linear_delta(with_all: bool, tmp_path: Path) -> None:
    it = pairs(0, effects=with_all)
    delta, six = load(it.delta, tmp_path), load(it.six.machine, tmp_path)
    S = together(six.coordinates, delta.coordinates)
    for found, expected in zip(six.matrices(it.six.pose), delta.matrices(it.position), strict=True):
        assert by_diagonal(S.T @ found @ S, expected) < 1e-12
    torques = six.statics(it.six.pose).torques.reshape(3, 2).sum(axis=1)
    assert relative(torques, delta.statics(it.position).torques) < 1e-12


@pytest.mark.parametrize(
    "entry", json.loads(TABLE.read_text(encoding="utf-8")), ids=lambda e: e["machine"]["name"]
)
def test_frequencies_by_exudyn(entry: dict[str, Any], tmp_path: Path) -> None:
    model = load(entry["machine"], tmp_path)
    for drives in ("free", "held"):
        found = model.modes(entry["pose"], drives=drives)
        np.testing.assert_allclose(found.frequencies[found.rigid_modes :], entry[drives], rtol=1e-10)


@pytest.mark.parametrize("name", NAMES)
def test_gravity_is_what_changes_the_forces_of_the_drives(name: str, tmp_path: Path) -> None:
    """Of neighbouring poses: K_g by the drives' coordinates is the slope of the forces there, without any oracle."""
    case = MACHINES[name](3)
    model = load(case.machine, tmp_path)
    weightless = load({**case.machine, "name": "weightless", "gravity": [0.0, 0.0, 0.0]}, tmp_path)
    arm = [1.0] * 6
    if name == "hexaglide":  # torques on pulleys are forces on belts
        arm = [
            axis.get("pulley", {}).get("radius", case.machine["pulley"]["radius"])
            for axis in case.machine["axis"]
        ]
    by_pose = []
    size = float(np.abs([axis["joint"] for axis in case.machine["axis"]]).max())
    for unit in np.eye(6):
        # fourth order; steps of a thousandth of the platform
        step = 1e-3 * (size if unit[:3].any() else 1.0)
        at = [
            (_moved(case, k * step * unit), w)
            for k, w in ((1, 2 / 3), (-1, -2 / 3), (2, -1 / 12), (-2, 1 / 12))
        ]
        by_pose.append(
            (
                sum(w * model.statics(pose).torques / arm for pose, w in at) / step,
                sum(w * model.inverse_kinematics(pose) for pose, w in at) / step,
            )
        )
    forces, positions = (np.array(rows).T for rows in zip(*by_pose, strict=True))
    K_g = (model.matrices(case.pose)[1] - weightless.matrices(case.pose)[1])[:6, :6]
    # truncation of some 1e-9, rounding of the springs, amplified by the condition of the poses
    assert relative(forces @ np.linalg.inv(positions), K_g) < 1e-6


def _moved(case: Case, by: np.ndarray) -> np.ndarray:
    """A pose a translation and a small rotation about base axes further."""
    R = rotation(by[3:]) @ rotation(case.pose[3:])
    # of less than half a turn
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    sine = np.linalg.norm(axis)
    turn = axis / sine * np.arctan2(sine, (np.trace(R) - 1) / 2)
    return np.concatenate([np.array(case.pose[:3]) + by[:3], turn])
