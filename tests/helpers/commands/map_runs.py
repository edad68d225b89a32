"""Maps that run in another process, slowly enough to be interrupted."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.runs.processes import ROOT, environment, interruptible
from pkmodes.machine.maps import mapping, running
from pkmodes.machine.maps.evaluating import Task
from pkmodes.machine.maps.storage import GROUP_NAME, PARTIAL_SUFFIX

ROBOT = ROOT / "robots" / "linear-delta-2022.toml"
#: 330 poses in tasks of 20 rows.
GRID = {"x": np.linspace(0.3, 0.8, 33), "y": np.linspace(-0.1, 0.1, 10), "z": -0.245}
GRID_TEXT = "x=0.3:0.8:33,y=-0.1:0.1:10,z=-0.245"
ROWS, TASKS = 20, 17
#: Runs the command line with short tasks.  Each takes a while; with HOLD_AFTER, that many are computed at once, then
#: it waits until its standard input is closed, and a moment longer: a signal that was sent before arrives first.
PROGRAM = f"""
import os, sys, time
from pkmodes.machine.maps import mapping, running
mapping.TASK_ROWS = {ROWS}
evaluate = running.evaluate
hold, begun = int(os.environ.get("HOLD_AFTER", 0)), 0
def slowly(task):
    global begun
    begun += 1
    if not hold:
        time.sleep(0.15)
    elif begun == hold + 1:
        sys.stdin.read()
        time.sleep(0.5)
    return evaluate(task)
running.evaluate = slowly
from pkmodes.cli import main
main()
"""
#: The same with a scheduler: it waits once that many tasks are stored, with others on their way to the workers.
CLIENT = f"""
import os, sys
from pkmodes.machine.maps import mapping, running
mapping.TASK_ROWS = {ROWS}
collect, hold, stored = running._collect, int(os.environ["HOLD_AFTER"]), 0
def collected(pending, put, finish):
    def finished(number):
        global stored
        finish(number)
        stored += 1
        if stored == hold:
            sys.stdin.read()
    collect(pending, put, finished)
running._collect = collected
from pkmodes.cli import main
main()
"""


def started(out: Path, after: int, *options: str, program: str = PROGRAM) -> subprocess.Popen[str]:
    """Start ``pkmodes map`` with one thread, and wait until some tasks are done and the next one waits."""
    process = subprocess.Popen(
        [*[sys.executable, "-c", program, "map", str(ROBOT), "--grid", GRID_TEXT], "--out", str(out)]
        + ["--threads", "1", *options],
        env=environment(HOLD_AFTER=str(after)),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=interruptible,
    )
    while done_in(out) < after:
        assert process.poll() is None, process.communicate()
        time.sleep(0.01)
    return process


def folder_of(out: Path) -> Path:
    return out.with_name(out.name + PARTIAL_SUFFIX)


def group_of(out: Path) -> Path:
    return folder_of(out) / GROUP_NAME


def done_in(out: Path) -> int:
    """Number of tasks of which every field is stored."""
    fields = [place.parent for place in group_of(out).glob("*/zarr.json")]
    return min((len(chunks_in(field)) for field in fields), default=0)


def chunks_in(field: Path) -> list[Path]:
    """Files with the rows of a field, one for each task; not those under way."""
    return sorted(file for file in (field / "c").rglob("*") if file.is_file() and file.suffix != ".partial")


def count_tasks(monkeypatch: pytest.MonkeyPatch) -> list[Task]:
    """Use the same short tasks here; return the list of those evaluated from now on."""
    monkeypatch.setattr(mapping, "TASK_ROWS", ROWS)
    evaluate, seen = running.evaluate, []

    def counted(task: Task) -> dict[str, np.ndarray]:
        seen.append(task)
        return evaluate(task)

    monkeypatch.setattr(running, "evaluate", counted)
    return seen


def model() -> pkmodes.Model:
    return pkmodes.load(ROBOT)
