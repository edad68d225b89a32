"""Which back end runs: by argument, by environment, and where there is no library; what the command line says."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.generated.libraries import POSE, ROBOT, ROOT, frequencies, libraries
from pkmodes import PkmodesError
from pkmodes.core.compiled import build

pytestmark = pytest.mark.compiler


def test_the_compiled_library_is_the_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PKMODES_BACKEND", raising=False)
    assert frequencies().backend == "compiled"
    assert frequencies("numpy").backend == "numpy"
    np.testing.assert_allclose(
        frequencies("numpy").frequencies, frequencies().frequencies, rtol=1e-12, atol=1e-4
    )


def test_the_environment_decides_where_nothing_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    assert frequencies().backend == "numpy"
    assert frequencies("compiled").backend == "compiled"
    monkeypatch.setenv("PKMODES_BACKEND", "fortran")
    with pytest.raises(PkmodesError, match=r'"numpy" or "compiled", found "fortran" .*PKMODES_BACKEND'):
        frequencies()


@pytest.mark.parametrize("backend", ["C", None, 3, ["numpy"]])
def test_an_unknown_back_end_is_refused(backend: str) -> None:
    with pytest.raises(PkmodesError, match=r'expected "auto", "numpy" or "compiled", found .* \(backend\)'):
        frequencies(backend)


@pytest.mark.parametrize("threads", [0, -1, 1.5, True, "2"])
def test_threads_are_a_positive_integer(threads: object) -> None:
    with pytest.raises(PkmodesError, match=r"expected a positive integer, found .* \(threads\)"):
        pkmodes.load(ROBOT).frequencies(POSE, threads=threads)


def test_without_compiler_and_library_numpy_does_the_work(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build.shutil, "which", lambda name: None)
    assert frequencies().backend == "numpy"
    with pytest.raises(PkmodesError, match=r"no C compiler to build it with .*; install a C compiler"):
        frequencies("compiled")
    assert not libraries(fresh)


def test_without_a_library_numpy_compares_whatever_the_environment_asks_for(
    fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A comparison chooses no back end: what cannot be had must not refuse the user's measurements."""
    robot, measured = (ROOT / "examples/closed_loop" / name for name in ("robot.toml", "measured.csv"))
    declared = pkmodes.read_robot(robot)
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    expected = pkmodes.loop.updating.compare(declared, pkmodes.loop.updating.read(measured, robot=declared))
    monkeypatch.setattr(build.shutil, "which", lambda name: None)
    monkeypatch.setenv("PKMODES_BACKEND", "compiled")
    comparison = pkmodes.loop.updating.compare(declared, pkmodes.loop.updating.read(measured, robot=declared))
    assert comparison.chi2_per_dof == expected.chi2_per_dof


def test_the_command_line_says_which_back_end_ran(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    for backend in ("numpy", "compiled"):
        command = [sys.executable, "-m", "pkmodes", "modes", str(ROBOT), "--pose", "0.15,0.2", "--json", "-"]
        found = subprocess.run(
            command,
            env={**environment, "PKMODES_BACKEND": backend},
            capture_output=True,
            text=True,
            check=True,
        )
        assert json.loads(found.stdout)["backend"] == backend


def test_messages_are_those_of_numpy() -> None:
    model = pkmodes.load(ROBOT)
    for poses in ([9.0, 0.0], [[0.1, 0.1], [np.nan, 0.0]], [[0.1, 0.1], [0.1, -1.0], [7.0, 0.0]]):
        texts = []
        for backend in ("numpy", "compiled"):
            with pytest.raises(pkmodes.PoseError) as error:
                model.modes(poses, backend=backend)
            texts.append(str(error.value))
        assert texts[0] == texts[1]
