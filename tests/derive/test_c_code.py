"""The generated C compiles without warnings and returns the numbers of the NumPy module."""

from __future__ import annotations

import ctypes
import importlib.util
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from helpers.generated.compiled import build, call
from helpers.generated.emission import Emission
from helpers.robots.sample_robots import random_robot
from pkmodes.codegen.generation import specification
from pkmodes.core.robot.robot import Robot
from pkmodes_derive import mechanisms
from pkmodes_derive.emit import product
from pkmodes_derive.functions import Function
from pkmodes_generated import linear_delta
from pkmodes_generated.linear_delta import Parameters

pytestmark = pytest.mark.compiler

MODEL = mechanisms.base("linear_delta")


def function(name: str) -> Function:
    return next(f for f in MODEL.functions if f.name == name)


def cases(count: int) -> list[tuple[Parameters, dict[str, np.ndarray]]]:
    rng = np.random.default_rng(20220102)
    found = []
    for _ in range(count):
        parameters, pose = random_robot(rng)
        determinant, _ = linear_delta.jacobian_condition(pose, parameters)
        values = {
            "p": pose,
            "x": linear_delta.inverse_kinematics(pose, parameters),
            "assembly": np.sign(determinant),
            "x_dot": rng.normal(size=3),
            "q_dot": rng.normal(size=9),
            "delta_q": 1e-3 * rng.normal(size=9),
        }
        found.append((parameters, values))
    return found


def as_tuple(result: object) -> tuple:
    return result if isinstance(result, tuple) else (result,)


def size(values: np.ndarray) -> np.ndarray:
    """Return the size of each entry's terms: for a symmetric matrix, the geometric mean of its diagonal entries."""
    if values.ndim == 2 and values.shape[0] == values.shape[1] == 9:
        root = np.sqrt(np.abs(np.diagonal(values)))
        return np.outer(root, root)
    return np.full(values.shape, np.abs(values).max(initial=0.0))


def compare(left: Callable[..., tuple], right: Callable[..., object], values: dict[str, np.ndarray]) -> None:
    for function in MODEL.functions:
        inputs = [values[a.name] for a in function.arguments]
        found, expected = left(function.name, inputs), right(function.name, inputs)
        for a, b in zip(found, as_tuple(expected), strict=True):
            # Same operations in the same order; the compiler may fuse a product and a sum.  An entry that
            # cancels keeps the rounding of its terms, which are of the size of its row and column.
            assert (np.abs(a - b) <= 1e-12 * np.maximum(np.abs(b), size(b))).all(), function.name


@pytest.fixture(scope="module")
def parametric_library(tmp_path_factory: pytest.TempPathFactory, emission: Emission) -> ctypes.CDLL:
    return build(tmp_path_factory.mktemp("c"), "linear_delta", emission.parametric("linear_delta"))


@pytest.mark.parametrize("case", range(5))
def test_parametric_c_equals_numpy(parametric_library: ctypes.CDLL, case: int) -> None:
    parameters, values = cases(5)[case]
    compare(
        lambda name, inputs: call(parametric_library, "linear_delta", function(name), inputs, [parameters]),
        lambda name, inputs: getattr(linear_delta, name)(*inputs, parameters),
        values,
    )


def load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("case", range(2))
def test_specialised_numpy_and_c_equal_the_parametric_model(tmp_path: Path, case: int) -> None:
    parameters, values = cases(2)[case]
    robot = Robot(f"sample {case}", "linear_delta", "sample.toml", parameters, {})
    texts = product.specialised(specification(robot, "sample.toml"))
    library = build(tmp_path, f"sample_{case}", texts)
    module = load(tmp_path / f"sample_{case}.py")
    compare(
        lambda name, inputs: call(library, f"sample_{case}", function(name), inputs),
        lambda name, inputs: getattr(linear_delta, name)(*inputs, parameters),
        values,
    )
    compare(
        lambda name, inputs: as_tuple(getattr(module, name)(*inputs)),
        lambda name, inputs: getattr(linear_delta, name)(*inputs, parameters),
        values,
    )


def test_header_can_be_included_from_c_plus_plus(tmp_path: Path, emission: Emission) -> None:
    compiler = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.skip("no C++ compiler")
    (tmp_path / "linear_delta.h").write_text(
        emission.parametric("linear_delta")["linear_delta.h"], encoding="utf-8"
    )
    (tmp_path / "user.cpp").write_text(
        '#include "linear_delta.h"\nint main() { return 0; }\n', encoding="utf-8"
    )
    subprocess.run([compiler, "-Wall", "-Werror", "-fsyntax-only", str(tmp_path / "user.cpp")], check=True)
