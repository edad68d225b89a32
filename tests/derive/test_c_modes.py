"""The C that a controller calls, of robots with and without effects: status, natural frequencies and modes."""

from __future__ import annotations

import ctypes
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from compiled import COMPILER, FLAGS
from pkmodes.generation import generate
from pkmodes.poses import MAX_CONDITION

ROBOTS = Path(__file__).parents[2] / "robots"
#: Robot file, effects, and a box of poses that is larger than the workspace.
CASES = {
    "linear_delta": ("linear-delta-2022.toml", "", ([0.0, -0.3, -0.45], [1.2, 0.3, 0.0])),
    "rotary_delta": ("clavel-delta.toml", "", ([-0.5, -0.5, -0.9], [0.5, 0.5, -0.3])),
    "corexy": ("corexy-printer.toml", "", ([-0.05, -0.05], [0.35, 0.35])),
    "clamps": (
        "linear-delta-2022.toml",
        '\n[effects.clamp_compliance]\ncompliance = "1e-7 m/N"\n'
        '[effects.gearbox_compliance]\ncompliance = "1e-3 rad/(N*m)"\n',
        ([0.0, -0.3, -0.45], [1.2, 0.3, 0.0]),
    ),
    "held": (
        "corexy-printer.toml",
        '\n[effects.servo_stiffness]\nstiffness = "20 N*m/rad"\n'
        '[effects.frame_compliance]\ncompliance = "2e-6 m/N"\n',
        ([-0.05, -0.05], [0.35, 0.35]),
    ),
}


class Compiled:
    """A robot's generated C, compiled with warnings as errors."""

    def __init__(self, folder: Path, case: str) -> None:
        file, effects, self.box = CASES[case]
        robot = folder / file
        robot.write_text((ROBOTS / file).read_text(encoding="utf-8") + effects, encoding="utf-8")
        self.model = pkmodes.load(robot)
        generate(robot, folder / "out")
        (source,) = (folder / "out").glob("*.c")
        self.name, self.header = source.stem, source.with_suffix(".h").read_text(encoding="utf-8")
        library = folder / "robot.so"
        assert COMPILER is not None
        subprocess.run([COMPILER, *FLAGS, str(source), "-o", str(library), "-lm"], check=True)
        self.code = ctypes.CDLL(str(library))
        self.m = self.model.frequencies(self.poses(300)[self.status(self.poses(300)) == 0][:1]).shape[-1]

    def poses(self, count: int) -> np.ndarray:
        return np.random.default_rng(1).uniform(*self.box, (count, len(self.box[0])))

    def status(self, poses: np.ndarray) -> np.ndarray:
        function = getattr(self.code, f"{self.name}_status")
        return np.array([function(np.ascontiguousarray(p).ctypes.data_as(ctypes.c_void_p)) for p in poses])

    def modes(self, p: np.ndarray) -> tuple[int, np.ndarray, np.ndarray, np.ndarray]:
        """Status, frequencies with shapes, shapes, and frequencies alone; poisoned before."""
        f, alone, phi = np.full(self.m, 1e9), np.full(self.m, 1e9), np.full((self.m, self.m), 1e9)
        p, both, one, shapes = (ctypes.c_void_p(a.ctypes.data) for a in (p.copy(), f, alone, phi))
        first = getattr(self.code, f"{self.name}_modes")(p, both, shapes)
        assert getattr(self.code, f"{self.name}_natural_frequencies")(p, one) == first
        return first, f, phi, alone


@pytest.fixture(scope="module", params=CASES)
def robot(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Compiled:
    return Compiled(tmp_path_factory.mktemp(request.param), request.param)


def test_the_status_says_why_as_the_runtime_does(robot: Compiled) -> None:
    poses = robot.poses(2000)
    poses[::100, 0] = np.nan
    poses[50, -1] = np.inf
    expected = robot.model.check(poses).codes
    np.testing.assert_array_equal(robot.status(poses), expected)
    assert 0 in expected
    assert len(set(expected.tolist())) > 2


def test_modes_are_those_of_the_runtime(robot: Compiled) -> None:
    poses = robot.poses(2000)
    valid = poses[robot.status(poses) == 0][:40]
    assert len(valid) == 40
    found = robot.model.modes(valid, backend="numpy")
    rigid = found.rigid_modes
    # A coordinate without inertia is condensed in the generated code.
    inertia = np.diagonal(found.mass_matrix, axis1=1, axis2=2).all(axis=0)
    for p, f, phi, M in zip(
        valid, found.frequencies, found.shapes[..., inertia], found.mass_matrix, strict=True
    ):
        status, both, shapes, alone = robot.modes(p)
        assert status == 0
        np.testing.assert_allclose(both[rigid:], f[rigid:], rtol=1e-9)
        np.testing.assert_array_equal(both, alone)
        M_own = M[np.ix_(inertia, inertia)]
        scale = np.sqrt(np.diagonal(M_own))
        rounding = 20 * robot.m * np.finfo(float).eps * np.linalg.cond(M_own / scale / scale[:, None])
        np.testing.assert_allclose(shapes @ M_own @ shapes.T, np.eye(robot.m), atol=rounding)
        apart = np.abs(np.diff(f, prepend=-1e9, append=1e9)) > 1e-3 * np.abs(f).max()
        alike = apart[:-1] & apart[1:]
        np.testing.assert_allclose(np.abs((shapes @ M_own @ phi.T).diagonal())[alike], 1.0, rtol=1e-9)


def test_a_pose_that_cannot_be_evaluated_has_no_modes(robot: Compiled) -> None:
    poses = robot.poses(200)
    status = robot.status(poses)
    for p, code in zip(poses[status != 0][:20], status[status != 0][:20], strict=True):
        assert robot.modes(p)[0] == code


def test_the_header_has_dimensions_and_statuses(robot: Compiled) -> None:
    upper = robot.name.upper()
    assert f"#define {upper}_COORDINATES {robot.m}\n" in robot.header
    assert f"#define {upper}_POSE {len(robot.box[0])}\n" in robot.header
    if f"{upper}_MAX_CONDITION" in robot.header:
        (limit,) = re.findall(rf"#define {upper}_MAX_CONDITION (\S+)", robot.header)
        assert float(limit) == MAX_CONDITION
    for number, code in enumerate(robot.model.reasons, start=1):
        name = "NOT_FINITE" if code == "finite" else f"BEYOND_{code.upper()}"
        assert f"#define {upper}_{name} {number}\n" in robot.header
