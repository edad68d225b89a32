"""The compiled evaluator under the address and undefined-behaviour sanitizers, for every mechanism."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pkmodes.core.compiled import build

pytestmark = pytest.mark.compiler

CODE = """
import numpy as np
from pkmodes.core.compiled import build, loader
build.FLAGS = tuple("-O0" if f == "-O3" else f for f in build.FLAGS) + (
    "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
build.WIDTHS = {build.machine(): {2: ()}}
link = build._run
build._run = lambda command, folder: link(
    [*command, "-fsanitize=address,undefined"] if "-shared" in command else command, folder)
loader.INSTALLED_LIBRARIES = loader.INSTALLED_LIBRARIES / "none"
from helpers.robots.lane_samples import NAMES, SIX_LEGGED, case, results
for name in (*NAMES, *SIX_LEGGED):
    for effects in ("none", "clamps with belt mass", "everything"):
        for count in (1, 3, 6, 13):
            given = case(name, 2, effects, count=count)
            given.poses[0] = np.nan
            codes, found = results(given, given.poses)
            assert codes[0] == 1 and np.isfinite(found["shapes"][1:][codes[1:] == 0]).all()
print("clean")
"""


@pytest.mark.slow
def test_the_sanitizers_find_nothing(tmp_path: Path) -> None:
    cc = build.compiler()
    assert cc is not None
    found = subprocess.run([*cc, "-print-file-name=libasan.so"], capture_output=True, text=True, check=True)
    runtime = found.stdout.strip()
    if not Path(runtime).is_absolute():
        pytest.skip("the compiler has no address sanitizer to be loaded before Python")
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(sys.path),
        "LD_PRELOAD": runtime,
        "ASAN_OPTIONS": "detect_leaks=0",
        "PKMODES_CACHE": str(tmp_path / "cache"),
        "OPENBLAS_NUM_THREADS": "1",
    }
    done = subprocess.run(
        [sys.executable, "-c", CODE], env=environment, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, "clean\n"), done.stderr[-3000:]
