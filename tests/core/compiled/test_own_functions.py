"""A user's mechanism with a function whose derivative is another one: Abs, whose derivative is sign."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from helpers.commands.adding_a_mechanism import DEFINITION, ROBOT

pytestmark = pytest.mark.compiler

PLAIN, WITH_ABS = "sqrt(rho2[j] - along[j] ** 2)", "sqrt(Abs(rho2[j] - along[j] ** 2))"
CODE = """
from pathlib import Path
import numpy as np, pkmodes
from pkmodes.core.compiled import build
from pkmodes.codegen.generation import generate
from pkmodes.core.mechanism.registry import add_folder
build.FLAGS = tuple("-O0" if flag == "-O3" else flag for flag in build.FLAGS)
build.WIDTHS = {build.machine(): {2: ()}}
generate(Path("five-bar.toml"), Path("out"), Path("five_bar.py"))
add_folder("out/five_bar")
model = pkmodes.load("five-bar.toml")
poses = [[0.03, -0.42], [-0.05, -0.4]]
numpy, compiled = (model.modes(poses, backend=b).frequencies[:, 2:] for b in ("numpy", "compiled"))
np.testing.assert_allclose(compiled, numpy, rtol=1e-10)
numpy, compiled = (
    model.sensitivities(poses, fields=["frequencies"], backend=b).frequencies[..., 2:] for b in ("numpy", "compiled")
)
np.testing.assert_allclose(compiled, numpy, rtol=1e-8, atol=1e-10 * np.abs(numpy).max())
print("agree")
"""


def test_a_derivative_of_another_kind_compiles_and_agrees(tmp_path: Path) -> None:
    assert PLAIN in DEFINITION
    definition = DEFINITION.replace(PLAIN, WITH_ABS).replace("from sympy import ", "from sympy import Abs, ")
    (tmp_path / "five_bar.py").write_text(definition, encoding="utf-8")
    (tmp_path / "five-bar.toml").write_text(ROBOT, encoding="utf-8")
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(sys.path),
        "PKMODES_CACHE": str(tmp_path / "cache"),
    }
    done = subprocess.run(
        [sys.executable, "-c", CODE],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout.splitlines()[-1:]) == (0, ["agree"]), done.stderr[-3000:]
