"""The committed C of the rotary delta and the CoreXY returns the numbers of their NumPy modules.

Arguments are passed by their names in the prototypes of the header, so an argument order that differs from the
header is detected too.
"""

from __future__ import annotations

import ctypes
import re
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from helpers.generated.compiled import build, packed
from helpers.robots.sample_mechanisms import NAMES, SEEDS, effects, extended, model, sample

pytestmark = pytest.mark.compiler

PROTOTYPE = re.compile(r"^void (\w+)\(([^)]*)\);", re.MULTILINE)
ARGUMENT = re.compile(r"(const )?(\w+) (\*?)(\w+)((?:\[\d+\])*)$")


def prototypes(header: str) -> dict[str, list[tuple[str, bool, str, tuple[int, ...]]]]:
    """Return the arguments of each function: type, whether it is an input, name and shape."""
    found = {}
    for name, arguments in PROTOTYPE.findall(header):
        matches = [ARGUMENT.match(" ".join(argument.split())) for argument in arguments.split(",")]
        found[name] = [
            (m[2], bool(m[1]) or not (m[3] or m[5]), m[4], tuple(map(int, re.findall(r"\d+", m[5]))))
            for m in matches
            if m
        ]
        assert len(found[name]) == len(matches), arguments
    return found


def given(name: str, seed: int) -> dict[str, Any]:
    robot, rng = sample(name, seed), np.random.default_rng(seed)
    n = len(model(name).COORDINATES)
    known = {
        "p": robot.pose,
        "parameters": robot.parameters,
        "effects": effects(name, ("",)),
        "theta_dot": rng.normal(size=3),
        "xy_dot": rng.normal(size=2),
        "q_dot": rng.normal(size=n),
        "delta_q": 1e-2 * rng.normal(size=n),
        "assembly": 1.0,
    }
    if name == "rotary_delta":
        known["theta"] = model(name).inverse_kinematics(robot.pose, robot.parameters)
        known["assembly"] = np.sign(model(name).jacobian_condition(robot.pose, robot.parameters)[0])
    return known


def called(function: Any, signature: list, known: dict[str, Any]) -> tuple[list[str], list[np.ndarray]]:
    """Return the names of a C function's inputs and the arrays of its results."""
    arguments, taken, outputs = [], [], []
    for kind, is_input, key, shape in signature:
        if not is_input:
            outputs.append(np.full(shape, np.nan))  # poisoned, so that an unwritten entry is detected
            arguments.append(outputs[-1].ctypes.data_as(ctypes.c_void_p))
            continue
        taken.append(key)
        if kind == "pkmodes_real" and not shape:
            arguments.append(ctypes.c_double(known[key]))
        else:
            values = np.asarray(known[key], dtype=float) if kind == "pkmodes_real" else packed(known[key])
            arguments.append(np.ascontiguousarray(values).ctypes.data_as(ctypes.c_void_p))
    function(*arguments)
    return taken, outputs


@pytest.mark.parametrize("part", ["", "_extended"])
@pytest.mark.parametrize("name", NAMES)
def test_c_equals_numpy(name: str, part: str, tmp_path: Path) -> None:
    folder = files("pkmodes_generated") / name
    texts = {
        f"{name}{which}.{ending}": (folder / f"{name}{which}.{ending}").read_text(encoding="utf-8")
        for which in ("", "_extended")
        for ending in ("c", "h")
    }
    library = build(tmp_path, f"{name}{part}", texts)
    module: ModuleType = extended(name) if part else model(name)
    signatures = prototypes(texts[f"{name}{part}.h"])
    assert len(signatures) >= (4 if part else 19)
    for seed in SEEDS:
        known = given(name, seed)
        for c_name, signature in signatures.items():
            taken, found = called(getattr(library, c_name), signature, known)
            key = c_name.removeprefix(f"{name}{part}_")
            expected = getattr(module, key)(**{argument: known[argument] for argument in taken})
            expected = expected if isinstance(expected, tuple) else (expected,)
            for one, other in zip(found, expected, strict=True):
                # the same operations in the same order; the compiler may fuse a product and a sum
                bound = 1e-13 * np.abs(other).max(initial=0.0)
                np.testing.assert_allclose(one, other, rtol=1e-12, atol=bound, err_msg=key)
