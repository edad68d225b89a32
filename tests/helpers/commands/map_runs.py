"""Maps that run in another process, slowly enough to be interrupted."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.maps import mapping, running
from pkmodes.maps.evaluating import Task
from pkmodes.maps.storage import SUFFIX

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots" / "linear-delta-2022.toml"
#: 330 poses in tasks of 20 rows.
GRID = {"x": np.linspace(0.3, 0.8, 33), "y": np.linspace(-0.1, 0.1, 10), "z": -0.245}
GRID_TEXT = "x=0.3:0.8:33,y=-0.1:0.1:10,z=-0.245"
ROWS, TASKS = 20, 17
#: Runs the command line with short tasks that take a while each.
PROGRAM = f"""
import sys, time
from pkmodes.maps import mapping, running
mapping.ROWS = {ROWS}
evaluate = running.evaluate
def slowly(task):
    time.sleep(0.15)
    return evaluate(task)
running.evaluate = slowly
from pkmodes.cli import main
main()
"""


def started(out: Path, *options: str) -> subprocess.Popen[str]:
    """Start ``pkmodes map`` with one thread."""
    paths = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    return subprocess.Popen(
        [*[sys.executable, "-c", PROGRAM, "map", str(ROBOT), "--grid", GRID_TEXT], "--out", str(out)]
        + ["--threads", "1", *options],
        env={**os.environ, "PYTHONPATH": paths},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def folder_of(out: Path) -> Path:
    return out.with_name(out.name + SUFFIX)


def done_in(out: Path) -> int:
    """Number of tasks recorded as done."""
    try:
        return int(np.load(folder_of(out) / "done.npy").sum())
    except (OSError, ValueError, EOFError):  # it is being made
        return 0


def wait_until_done(out: Path, tasks: int, process: subprocess.Popen[str]) -> None:
    deadline = time.monotonic() + 60
    while done_in(out) < tasks:
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.01)


def count_tasks(monkeypatch: pytest.MonkeyPatch) -> list[Task]:
    """Use the same short tasks here; return the list of those evaluated from now on."""
    monkeypatch.setattr(mapping, "ROWS", ROWS)
    evaluate, seen = running.evaluate, []

    def counted(task: Task) -> dict[str, np.ndarray]:
        seen.append(task)
        return evaluate(task)

    monkeypatch.setattr(running, "evaluate", counted)
    return seen


def model() -> pkmodes.Model:
    return pkmodes.load(ROBOT)
