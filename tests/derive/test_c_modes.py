"""The C that a controller calls, of robots with and without effects: status, natural frequencies and modes."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.compiled import COMPILER
from helpers.generated.generated_robots import Robot
from pkmodes.core.mechanism.poses import MAX_CONDITION

pytestmark = pytest.mark.compiler


def test_the_status_says_why_as_the_runtime_does(robot: Robot) -> None:
    poses = robot.poses(2000)
    poses[::100, 0] = np.nan
    poses[50, -1] = np.inf
    expected = robot.model.check(poses).codes
    np.testing.assert_array_equal(robot.double.status(poses), expected)
    assert 0 in expected
    assert len(set(expected.tolist())) > 2


def test_modes_are_those_of_the_runtime(robot: Robot) -> None:
    valid = robot.valid(40)
    assert len(valid) == 40
    found = robot.model.modes(valid, backend="numpy")
    rigid, m = found.rigid_modes, robot.double.m
    # A coordinate without inertia is condensed in the generated code.
    inertia = np.diagonal(found.mass_matrix, axis1=1, axis2=2).all(axis=0)
    for p, f, phi, M in zip(
        valid, found.frequencies, found.shapes[..., inertia], found.mass_matrix, strict=True
    ):
        status, both, shapes, alone = robot.double.modes(p)
        assert status == 0
        np.testing.assert_allclose(both[rigid:], f[rigid:], rtol=1e-9)
        np.testing.assert_array_equal(both, alone)
        M_own = M[np.ix_(inertia, inertia)]
        scale = np.sqrt(np.diagonal(M_own))
        rounding = 20 * m * np.finfo(float).eps * np.linalg.cond(M_own / scale / scale[:, None])
        np.testing.assert_allclose(shapes @ M_own @ shapes.T, np.eye(m), atol=rounding)
        apart = np.abs(np.diff(f, prepend=-1e9, append=1e9)) > 1e-3 * np.abs(f).max()
        alike = apart[:-1] & apart[1:]
        np.testing.assert_allclose(np.abs((shapes @ M_own @ phi.T).diagonal())[alike], 1.0, rtol=1e-9)


def test_a_pose_that_cannot_be_evaluated_has_no_modes(robot: Robot) -> None:
    poses = robot.poses(200)
    status = robot.double.status(poses)
    for p, code in zip(poses[status != 0][:20], status[status != 0][:20], strict=True):
        assert robot.double.modes(p)[0] == code


def test_the_header_has_dimensions_and_statuses(robot: Robot) -> None:
    upper = robot.name.upper()
    assert f"#define {upper}_COORDINATES {len(robot.module.COORDINATES)}\n" in robot.header
    assert f"#define {upper}_POSE {len(robot.box[0])}\n" in robot.header
    if f"{upper}_MAX_CONDITION" in robot.header:
        single, limit = re.findall(rf"#define {upper}_MAX_CONDITION (\S+)", robot.header)
        assert float(limit) == MAX_CONDITION
        assert single == "1000.0f"
    for number, code in enumerate(robot.model.reasons, start=1):
        name = "NOT_FINITE" if code == "finite" else f"BEYOND_{code.upper()}"
        assert f"#define {upper}_{name} {number}\n" in robot.header


def test_every_function_that_does_not_check_the_pose_says_so(robot: Robot) -> None:
    """Except the status, what it calls, and the kinematics, which say themselves what they return."""
    remark = f"Call `{robot.name}_status` first: where it is not 0, the results are NaN or have no meaning."
    comments = re.findall(
        r"/\*((?:(?!\*/).)*)\*/\nvoid \w+?\(const pkmodes_real p\[", robot.header, flags=re.DOTALL
    )
    told = [remark in " ".join(comment.replace(" *", " ").split()) for comment in comments]
    calls = {margin.function for margin in robot.model.robot.mechanism.margins} | {"inverse_kinematics"}
    assert told.count(False) == len(calls)
    assert told.count(True) > 8
    assert robot.header.index(f"{robot.name}_status(p) == 0") < robot.header.index("#ifndef")


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize(
    "language", [["-x", "c", "-std=c89"], ["-x", "c", "-std=c99"], ["-x", "c++", "-std=c++98"]]
)
def test_the_headers_suit_c89_and_cpp(
    robot: Robot, tmp_path: Path, language: list[str], single: bool
) -> None:
    """Both headers of a robot with effects in one file, too."""
    source = tmp_path / "main.c"
    headers = [name for name in robot.written if name.endswith(".h")]
    source.write_text("".join(f'#include "{name}"\n' for name in headers), encoding="utf-8")
    subprocess.run(
        [str(COMPILER), *language, "-Wall", "-Wextra", "-pedantic", "-Werror", "-fsyntax-only"]
        + ["-DPKMODES_FLOAT"] * single
        + [f"-I{robot.out}", str(source)],
        check=True,
    )
