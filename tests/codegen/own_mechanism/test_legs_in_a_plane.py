"""A planar 3-RPR, whose legs change their length: against its positions, written by hand.

Nothing of the reference is shared with the derivation: what moves is a function of the pose and of the displacement
of the frame, and everything else follows by differences.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import scipy.linalg

import pkmodes
from helpers.commands.answers import printed, refused
from helpers.commands.own_folder import inside
from helpers.references.five_bar_by_hand import differentiated
from helpers.robots import three_rpr
from pkmodes.core.mechanism import registry as known

ROBOT = """format = 1
name = "rpr"
mechanism = "three_rpr"
gravity = ["0.4 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
platform = { mass = "1.6 kg", center = ["4 mm", "-17 mm"], inertia = "4.2e-3 kg*m^2" }
motor = { inertia = "1e-5 kg*m^2", travel = "0.8 mm" }

[actuator]
stiffness = "4e5 N/m"
housing_mass = "0.7 kg"
housing_center = "80 mm"
housing_inertia = "2e-3 kg*m^2"
rod_mass = "0.2 kg"
rod_center = "60 mm"
rod_inertia = "6e-4 kg*m^2"

[[axis]]
base = ["-300 mm", "-173 mm"]
joint = ["-82 mm", "-50 mm"]
limits = ["100 mm", "500 mm"]
[[axis]]
base = ["300 mm", "-163 mm"]
joint = ["72 mm", "-60 mm"]
limits = ["100 mm", "500 mm"]
actuator = { stiffness = "5e5 N/m" }
[[axis]]
base = ["20 mm", "346 mm"]
joint = ["50 mm", "70 mm"]
limits = ["100 mm", "500 mm"]

[effects.payload]
mass = "0.3 kg"
offset_x = "20 mm"
[effects.frame_compliance]
compliance = "2e-7 m/N"
"""
GRAVITY = np.array([0.4, -9.81])
BASES = np.array([[-0.3, -0.173], [0.3, -0.163], [0.02, 0.346]])
JOINTS = np.array([[-0.082, -0.05], [0.072, -0.06], [0.05, 0.07]])
STIFFNESSES = np.array([4e5, 5e5, 4e5])
#: Mass, place of the centre along the leg from the pivot or before the joint, and inertia about the centre.
HOUSING, ROD = (0.7, 0.08, 2e-3), (0.2, 0.06, 6e-4)
MOTOR, FRAME_MASS, FRAME_COMPLIANCE = 1e-5 / 0.8e-3**2, 50.0, 2e-7
POSES = np.array([[0.01, -0.02, 0.1], [-0.03, 0.02, -0.2], [0.0, 0.0, 0.3]])


def turned(v: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Places on the platform, before the frame moves."""
    c, s = np.cos(v[2]), np.sin(v[2])
    return np.asarray(v[:2] + vectors @ np.array([[c, s], [-s, c]]))


def coordinates(v: np.ndarray) -> np.ndarray:
    """Lengths of the legs and displacement of the frame, from the pose and that displacement."""
    return np.concatenate([np.linalg.norm(turned(v, JOINTS) - BASES, axis=1), v[3:]])


def masses(v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Everything that moves as points: a body is two halves, a radius of gyration on either side of its centre."""
    found = [(0.3, turned(v, np.array([0.02, 0.0])))]
    for side in (1.0, -1.0):
        radius = np.sqrt(4.2e-3 / 1.6) * np.array([0.6, 0.8])
        found.append((0.8, turned(v, np.array([4e-3, -17e-3]) + side * radius)))
        for base, joint in zip(BASES, turned(v, JOINTS), strict=True):
            along = (joint - base) / np.linalg.norm(joint - base)
            for (mass, place, inertia), start, forward in ((HOUSING, base, 1.0), (ROD, joint, -1.0)):
                centre = start + forward * place * along
                found.append((mass / 2, centre + side * np.sqrt(inertia / mass) * along))
    return np.array([mass for mass, _ in found]), np.stack([place + v[3:] for _, place in found])


def forces(v: np.ndarray) -> np.ndarray:
    """What holds the pose against gravity, conjugate to `coordinates`: first the forces of the drives."""
    weight = differentiated(lambda w: -np.sum(masses(w)[0][:, None] * masses(w)[1] @ GRAVITY[:, None]), v)
    return np.linalg.solve(differentiated(coordinates, v).T, weight)


def matrices(pose: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """M and K for l_1..3, s_1..3, u_x, u_y."""
    at = np.concatenate([pose, np.zeros(2)])
    back = np.linalg.inv(differentiated(coordinates, at))
    velocities = differentiated(lambda v: masses(v)[1], at) @ back
    M, K = np.zeros((8, 8)), np.zeros((8, 8))
    others = np.ix_([0, 1, 2, 6, 7], [0, 1, 2, 6, 7])
    M[others] = np.einsum("n,nik,nil->kl", masses(at)[0], velocities, velocities)
    K[others] = differentiated(forces, at) @ back
    M[3:6, 3:6] += MOTOR * np.eye(3)
    M[6:, 6:] += FRAME_MASS * np.eye(2)
    K[:6, :6] += np.kron([[1, -1], [-1, 1]], np.diag(STIFFNESSES))
    K[6:, 6:] += np.eye(2) / FRAME_COMPLIANCE
    return M, K


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("legs")
    (folder / "three_rpr.py").write_text(
        Path(three_rpr.__file__).read_text(encoding="utf-8"), encoding="utf-8"
    )
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with inside(folder):
        printed("generate", "robot.toml", "--mechanism", "three_rpr.py", "--out", "build")
        yield folder


@pytest.fixture
def model(place: Path, monkeypatch: pytest.MonkeyPatch) -> pkmodes.Model:
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    known.add_folder(place / "build" / "three_rpr")
    return pkmodes.load(place / "robot.toml")


def test_matrices_and_forces_agree_with_positions_by_hand(model: pkmodes.Model) -> None:
    for pose in POSES:
        for found, expected in zip(model.matrices(pose), matrices(pose), strict=True):
            scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
            np.testing.assert_allclose(found / scale, expected / scale, rtol=0.0, atol=1e-8)
        at = np.concatenate([pose, np.zeros(2)])
        np.testing.assert_allclose(model.statics(pose).torques, forces(at)[:3], atol=1e-7)
        np.testing.assert_allclose(model.modes(pose).joint_positions, coordinates(at)[:3], rtol=1e-12)


def test_frequencies_with_free_and_held_motors(model: pkmodes.Model) -> None:
    for pose in POSES:
        M, K = matrices(pose)
        free = np.sqrt(scipy.linalg.eigvalsh(K, M)[3:]) / (2 * np.pi)
        found = model.modes(pose)
        assert found.rigid_modes == 3
        np.testing.assert_allclose(found.frequencies[3:], free, rtol=1e-6)
        rest = np.ix_([0, 1, 2, 6, 7], [0, 1, 2, 6, 7])
        held = np.sqrt(scipy.linalg.eigvalsh(K[rest], M[rest])) / (2 * np.pi)
        np.testing.assert_allclose(model.frequencies(pose, drives="held"), held, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.compiler
def test_the_compiled_code_gives_the_same(model: pkmodes.Model) -> None:
    for drives in ("free", "held"):
        found = model.modes(POSES, drives=drives, backend="compiled").frequencies
        np.testing.assert_allclose(
            found[:, 3:], model.modes(POSES, drives=drives).frequencies[:, 3:], rtol=1e-9
        )


def test_a_cable_leaves_the_turn_of_the_platform_free(model: pkmodes.Model) -> None:
    """In a plane it holds two of three motions."""
    cable = model.with_values({"effects.cable_stiffness.stiffness": 300.0, "gravity": [0.0, 0.0, 0.0]})
    for pose in POSES:
        found = cable.modes(pose)
        assert found.rigid_modes == 1
        assert abs(found.frequencies[0]) < 1e-6 * found.frequencies[1]
        assert cable.modes(pose, drives="held").rigid_modes == 0


def test_the_derivation_agrees_with_finite_differences(place: Path) -> None:
    assert "build/three_rpr: current" in printed("check", "build/three_rpr")


def test_a_leg_whose_link_is_rigid_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = Path(three_rpr.__file__).read_text(encoding="utf-8")
    right = "m.link(d[j], l[j], l[j], lever[j])"
    assert right in text
    rigid = text.replace(right, "m.link(d[j], high[j], l[j], lever[j])")
    (tmp_path / "three_rpr.py").write_text(rigid, encoding="utf-8")
    (tmp_path / "robot.toml").write_text(ROBOT, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    error = refused("generate", "robot.toml", "--mechanism", "three_rpr.py", "--out", "build")
    assert "the link of the leg along d_1_x, ... is rigid (three_rpr.py: m.leg)" in error
