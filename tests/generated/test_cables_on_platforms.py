"""A cable at the origin of a platform that turns: it holds three motions, and the other three stay at 0 Hz.

The references are the matrices of the oracle of machines with six legs: their rank, and their modes in 60 digits.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.references.high_precision import solved
from helpers.references.high_precision_mechanisms import mp
from helpers.references.oracle_six_legged import oracle
from helpers.references.six_legs_compared import load
from helpers.robots.six_legged import MACHINES, Case
from pkmodes.cli import run
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import regular_poses

pytestmark = pytest.mark.usefixtures("backend")
NAMES = ("hexapod", "hexaglide")
ROBOTS = Path(__file__).parents[2] / "robots"
CABLE, SERVO = "cable_stiffness", "servo_stiffness"
#: Robots by springs to ground: how many motions no spring holds, with motors free.
COUNTS = [((), 6), ((CABLE,), 3), ((SERVO,), 0), ((CABLE, SERVO), 0)]


def machine(name: str, seed: int, springs: dict[str, float], gravity: bool) -> Case:
    """A random machine, with springs to ground."""
    case = MACHINES[name](seed)
    changed = {"effects": {effect: {"stiffness": value} for effect, value in springs.items()}}
    if not gravity:
        changed["gravity"] = [0.0, 0.0, 0.0]
    return Case({**case.machine, **changed}, case.pose)


@cache
def without_gravity(name: str) -> tuple[pkmodes.Model, np.ndarray]:
    """The supplied robot with a cable where nothing falls, and poses all over its workspace."""
    robot = pkmodes.read_robot(ROBOTS / f"{name}.toml")
    parameters = robot.parameters._replace(gravity=np.zeros(3))
    effects = {"cable_stiffness.stiffness": 2e4}
    model = pkmodes.Model(replace(robot, parameters=parameters, effects=effects))
    mechanism = robot.mechanism
    return model, regular_poses(Generated(mechanism.model, parameters), mechanism, parameters, 300)


@pytest.mark.parametrize("name", NAMES)
def test_no_pose_is_refused_by_chance(name: str) -> None:
    model, poses = without_gravity(name)
    assert len(poses) == 300
    batch = model.modes(poses)
    assert batch.rigid_modes == 3
    size = np.abs(batch.frequencies)
    assert (size[:, :3] < 1e-5 * size[:, 3:4]).all()
    assert (size[:, 3] > 0.1).all()
    for pose, f in zip(poses[:40], batch.frequencies, strict=False):
        single = model.modes(pose)
        assert single.rigid_modes == 3
        np.testing.assert_allclose(single.frequencies[3:], f[3:], rtol=1e-9)


def exact_matrices(case: Case, gravity: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """M and K in many digits, without the joints of effects, which are locked; K with gravity or without."""
    exact = oracle(case.machine, case.pose)
    kept = [exact.coordinates.index(name) for name in (*exact.independent, *exact.transmissions)]
    place = np.ix_(kept, kept)
    K = exact.elastic_hessian() + (exact.gravity_hessian() if gravity else 0)
    return exact.mass_matrix()[place], K[place]


@pytest.mark.parametrize("stiffness", [1e-6, 1.0, 2e4])
@pytest.mark.parametrize("name", NAMES)
def test_what_the_cable_holds_has_nine_digits(name: str, stiffness: float, tmp_path: Path) -> None:
    case = machine(name, 3, {CABLE: stiffness}, gravity=False)
    values = solved(*(mp.matrix(matrix.tolist()) for matrix in exact_matrices(case))).values()
    expected = np.sqrt(np.abs(values)) / (2 * np.pi)
    found = load(case.machine, tmp_path).modes(case.pose)
    assert found.rigid_modes == 3
    assert np.abs(found.frequencies[:3]).max() < 1e-6 * expected[3]
    np.testing.assert_allclose(found.frequencies[3:], expected[3:], rtol=1e-9)


@pytest.mark.parametrize(("springs", "count"), COUNTS)
@pytest.mark.parametrize("name", NAMES)
def test_the_count_is_what_the_rank_of_the_springs_leaves(
    name: str, springs: tuple[str, ...], count: int, tmp_path: Path
) -> None:
    for seed in range(3):
        case = machine(name, seed, dict.fromkeys(springs, 300.0), gravity=True)
        _, K_el = exact_matrices(case)
        size = np.sqrt(np.diag(K_el).astype(float))
        values = np.linalg.eigvalsh((K_el / np.outer(size, size)).astype(float))
        assert np.count_nonzero(values < 1e-13 * values[-1]) == count
        model = load(case.machine, tmp_path)
        assert model.modes(case.pose).rigid_modes == model.solved("free").rigid_modes == count
        assert model.modes(case.pose, drives="held").rigid_modes == 0


@pytest.mark.parametrize("stiffness", [1.0, 2e4])
@pytest.mark.parametrize("name", NAMES)
def test_beside_gravity_all_six_motions_have_their_eigenvalues(
    name: str, stiffness: float, tmp_path: Path
) -> None:
    case = machine(name, 4, {CABLE: stiffness}, gravity=True)
    M, K = exact_matrices(case, gravity=True)
    expected = solved(mp.matrix(M.tolist()), mp.matrix(K.tolist())).values()
    found = load(case.machine, tmp_path).modes(case.pose)
    assert found.rigid_modes == 3  # a count: gravity mixes them with those that the cable holds
    values = np.sign(found.frequencies) * (2 * np.pi * found.frequencies) ** 2
    np.testing.assert_allclose(values[:6], expected[:6], rtol=0, atol=2e-9 * np.abs(expected[:6]).max())
    np.testing.assert_allclose(values[6:], expected[6:], rtol=2e-9)


def test_the_table_calls_them_rigid_and_says_what_acts_on_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (ROBOTS / "hexapod.toml").read_text(encoding="utf-8")
    held = f'{text}\n[effects.cable_stiffness]\nstiffness = "20 kN/m"\n'
    falls = '"0 m/s^2", "0 m/s^2", "-9.81 m/s^2"'
    assert falls in text
    for robot, said in ((held, True), (held.replace(falls, "0, 0, 0"), False)):
        (tmp_path / "robot.toml").write_text(robot, encoding="utf-8")
        assert run(["modes", str(tmp_path / "robot.toml"), "--pose=0.01,0,0.24,0.05,-0.01,0.05"]) == 0
        out = " ".join(capsys.readouterr().out.split())
        assert "mode rigid rigid rigid 1 2 3" in out
        assert ("rigid: the 3 lowest modes, as many as there are motions that no spring holds" in out) is said
        assert "only gravity acts" not in out
        assert ("f [Hz] 0 0 0 0." in out) is not said
