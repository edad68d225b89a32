"""The generated C in single precision: no double arithmetic, and the modes of double precision to its accuracy.

`conftest` compiles it with errors for every conversion between the two.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.compiled import COMPILER, FLAGS
from helpers.generated.generated_robots import STRICT, Robot

pytestmark = pytest.mark.compiler

#: Relative error of a frequency where it is the highest one and the pose is regular: some eighty roundings, mostly
#: those of the kinematics.
ERROR = 1e-5
#: Condition number up to which the rounding of the kinematics does not dominate.
REGULAR = 100.0
FUNCTIONS = ("sqrt", "fabs", "fmax", "fmin", "copysign", "sin", "cos", "sincos", "acos", "atan2", "exp")


def regular(robot: Robot, count: int) -> np.ndarray:
    poses = robot.valid(2000)
    if hasattr(robot.module, "jacobian_condition"):
        poses = poses[robot.module.jacobian_condition(poses)[1] < REGULAR]
    return poses[:count]


def test_frequencies_are_those_of_double_precision(robot: Robot) -> None:
    poses, rigid = regular(robot, 300), robot.module.RIGID_MODES
    assert len(poses) > 100
    largest = []
    for p in poses:
        # The pose that both get is one of single precision.
        status, f, _, alone = robot.single.modes(p.astype(np.float32))
        _, expected, _, _ = robot.double.modes(p.astype(np.float32))
        assert status == 0
        np.testing.assert_array_equal(f, alone)
        error = np.abs(f[rigid:] / expected[rigid:] - 1.0)
        assert (error < ERROR * (expected[-1] / expected[rigid:]) ** 2).all()
        assert (np.abs(f - expected)[:rigid] < np.sqrt(ERROR) * expected[-1]).all(), "rounding of lambda"
        largest.append(error.max())
    assert np.median(largest) < (3e-5 if robot.effects else 1e-6)
    assert np.quantile(largest, 0.95) < 1e-4


def test_shapes_are_mass_normalised_and_those_of_double_precision(robot: Robot) -> None:
    for p in regular(robot, 30):
        M, _ = robot.module.modal_matrices(p)
        _, f, shapes, _ = robot.single.modes(p)
        _, _, expected, _ = robot.double.modes(p)
        np.testing.assert_allclose(shapes @ M @ shapes.T, np.eye(len(f)), atol=1e-3)
        apart = np.abs(np.diff(f, prepend=-1e9, append=1e9)) > 0.03 * f[-1]
        alike = apart[:-1] & apart[1:]
        np.testing.assert_allclose(
            np.abs((shapes @ M @ expected.T).diagonal())[alike], 1.0, rtol=0, atol=1e-3
        )


def test_statuses_agree_away_from_the_margins(robot: Robot) -> None:
    poses = robot.poses(2000)
    poses[::100, 0] = np.nan
    found, expected = robot.single.status(poses), robot.double.status(poses)
    conditions = [m.code for m in robot.model.robot.mechanism.margins]
    for p in poses[found != expected]:
        around = p + 1e-5 * np.vstack([np.eye(len(p)), -np.eye(len(p))])
        near_a_margin = len(set(robot.double.status(around).tolist())) > 1
        singular = conditions.index("singular") + 2 if "singular" in conditions else None
        assert near_a_margin or robot.single.status(p[None]) == singular
    assert np.count_nonzero(found != expected) < 0.01 * len(poses)


def test_the_object_has_no_double_arithmetic(robot: Robot, tmp_path: Path) -> None:
    """The functions of the C library that it calls have the suffix f."""
    target = tmp_path / "single.o"
    flags = [flag for flag in FLAGS if flag != "-shared"]
    source = robot.out / f"{robot.name}.c"
    subprocess.run(
        [str(COMPILER), *flags, "-DPKMODES_FLOAT", "-c", str(source), "-o", str(target)], check=True
    )
    listed = subprocess.run(["nm", "-u", str(target)], check=True, capture_output=True, text=True).stdout
    called = {name for name in re.findall(r"U (\w+)", listed) if not name.startswith("_")}
    assert called - {"memset", "memcpy"} <= {f"{name}f" for name in FUNCTIONS}


def test_comparing_with_a_limit_takes_no_double(robot: Robot, tmp_path: Path) -> None:
    limits = re.findall(rf"^#define ({robot.name.upper()}_\w+_M(?:IN|AX)) ", robot.header, flags=re.MULTILINE)
    assert len(limits) in (4, 6)
    source = tmp_path / "main.c"
    checks = " + ".join(f"(x > {limit})" for limit in [*limits, f"-{limits[0]}"])
    source.write_text(
        f'#include "{robot.name}.h"\nint beyond(pkmodes_real x);\n'
        f"int beyond(pkmodes_real x) {{ return {checks}; }}\n",
        encoding="utf-8",
    )
    for define in ([], ["-DPKMODES_FLOAT"]):
        command = [str(COMPILER), "-std=c99", "-Wall", "-Wextra", *STRICT, "-Werror", *define]
        subprocess.run([*command, f"-I{robot.out}", "-fsyntax-only", str(source)], check=True)


def test_both_precisions_link_into_one_program(robot: Robot, tmp_path: Path) -> None:
    """And a caller of the other precision is an error of the linker, not a wrong number."""
    name, d = robot.name, len(robot.box[0])
    caller = tmp_path / "caller.c"
    caller.write_text(
        f'#include "{name}.h"\nint THIS(void);\n'
        f"int THIS(void) {{ const pkmodes_real p[{d}] = {{0}}; return {name}_status(p); }}\n",
        encoding="utf-8",
    )
    main = tmp_path / "main.c"
    main.write_text("int a(void); int b(void); int main(void) { return a() < 0 || b() < 0; }\n", "utf-8")
    objects = {}
    for key, flags, file in (
        ("double", [], robot.out / f"{name}.c"),
        ("single", ["-DPKMODES_FLOAT"], robot.out / f"{name}.c"),
        ("a", ["-DTHIS=a"], caller),
        ("b", ["-DTHIS=b", "-DPKMODES_FLOAT"], caller),
        ("main", [], main),
    ):
        objects[key] = str(tmp_path / f"{key}.o")
        command = [str(COMPILER), "-std=c99", *flags, f"-I{robot.out}", "-c", str(file), "-o", objects[key]]
        subprocess.run(command, check=True)
    program = str(tmp_path / "program")
    subprocess.run([str(COMPILER), *objects.values(), "-o", program, "-lm"], check=True)
    subprocess.run([program], check=True)
    without = [value for key, value in objects.items() if key != "single"]
    failed = subprocess.run([str(COMPILER), *without, "-o", program, "-lm"], capture_output=True, text=True)
    assert failed.returncode != 0
    assert f"{name}_status_f" in failed.stderr
