"""The library of the wheel for another processor, under emulation: the same bits."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from helpers.robots.lane_samples import case, evaluator
from helpers.runs.programs import needed
from pkmodes.core.compiled import build

pytestmark = pytest.mark.compiler
DRIVER = Path(__file__).with_name("one_library.c")
ROOT = Path(__file__).parents[3]
#: Where the C library of the other processor lies, as Debian installs it.
SYSTEM = "/usr/aarch64-linux-gnu"


def emulated(name: str, folder: Path, cc: list[str]) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies and shapes of a robot from a library that is built for AArch64, and from that of this processor."""
    given = case(name, 7)
    run, lanes = evaluator(given), given.evaluation.lanes()
    n, poses = run.coordinates, np.ascontiguousarray(given.poses)
    here = {"frequencies": np.empty((len(poses), n)), "shapes": np.empty((len(poses), n, n))}
    run.run(poses, here)
    sizes = np.array([*poses.shape, lanes.parameters.size, lanes.effects.size, n], dtype=np.int64)
    doubles = np.concatenate([poses.ravel(), lanes.parameters, lanes.effects])
    (folder / "input").write_bytes(sizes.tobytes() + doubles.tobytes())
    header = (ROOT / "generated/pkmodes_generated" / name / build.HEADER).read_text(encoding="utf-8")
    library = build.build(header, folder, name, cc)
    driver = [*cc, "-O1", "-I", str(build.FOLDER), str(DRIVER), "-o", str(folder / "driver")]
    subprocess.run(driver, check=True)
    command = ["qemu-aarch64", "-L", SYSTEM, "driver", library.name, "input", "output"]
    subprocess.run(command, cwd=folder, check=True, env={"LD_LIBRARY_PATH": ".", "PATH": "/usr/bin:/bin"})
    return np.fromfile(folder / "output"), np.concatenate([array.ravel() for array in here.values()])


def test_a_library_for_aarch64_gives_the_same_bits(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Built as a wheel for AArch64 is, and loaded by a program of its own; corexy has no trigonometric functions."""
    needed("aarch64-linux-gnu-gcc", "qemu-aarch64")
    monkeypatch.setenv("_PYTHON_HOST_PLATFORM", "linux-aarch64")
    found, expected = emulated("corexy", tmp_path, [shutil.which("aarch64-linux-gnu-gcc") or ""])
    assert np.isfinite(expected).all()
    np.testing.assert_array_equal(found, expected)
