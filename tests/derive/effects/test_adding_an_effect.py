"""Follow docs/how-to/adding-an-effect.md: one new file adds an effect, which is derived, emitted and evaluated."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from helpers.robots.robot_text import published

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "how-to/adding-an-effect.md").read_text(encoding="utf-8")
SOURCE = PAGE.split("```python\n")[1].split("```")[0]
EVALUATE = """
import json, pkmodes
model = pkmodes.load("robot.toml")
_, K = model.matrices([0.6, 0.03, -0.245])
print(json.dumps([K.tolist(), model.platform_jacobian([0.6, 0.03, -0.245]).tolist()]))
"""


def test_the_page_is_short() -> None:
    assert len(SOURCE.splitlines()) < 60


@pytest.mark.slow
def test_a_new_file_is_a_new_effect(tmp_path: Path) -> None:
    for part in ("src", "generated", "derive"):
        shutil.copytree(ROOT / part, tmp_path / part, ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "derive/pkmodes_derive/effects/tube_stiffness.py").write_text(SOURCE, encoding="utf-8")
    path = os.pathsep.join(str(tmp_path / part) for part in ("src", "generated", "derive"))
    environment = {**os.environ, "PYTHONPATH": path}

    def python(*arguments: str) -> str:
        run = subprocess.run(
            [sys.executable, *arguments],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        return run.stdout

    out = str(tmp_path / "generated" / "pkmodes_generated")
    python("-m", "pkmodes_derive", "generate", "--mechanism", "linear_delta", "--out", out)
    results = []
    for tables in ("", '\n[effects.tube_stiffness]\nstiffness = "200 N/m"\n'):
        (tmp_path / "robot.toml").write_text(published() + tables, encoding="utf-8")
        results.append([np.array(m) for m in json.loads(python("-c", EVALUATE))])
    (K, D_p), (K_tube, _) = results
    expected = K.copy()
    expected[:3, :3] += 200.0 * D_p[:2].T @ D_p[:2]
    np.testing.assert_allclose(K_tube, expected, rtol=1e-12, atol=1e-9)
