"""Processes that tests start, and what they print."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

ROOT = Path(__file__).parents[3]


def environment(*folders: Path, **variables: str) -> dict[str, str]:
    """Return the environment in which a new Python finds pkmodes, and what is in `folders` before all else."""
    paths = [*folders, *(ROOT / part for part in ("src", "generated", "derive"))]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, paths)), **variables}


def printed_by_a_process(arguments: Sequence[object], variables: Mapping[str, str]) -> tuple[str, str]:
    """Return what a command prints in a process of its own, for what Python reads of the environment as it starts."""
    found = subprocess.run(
        [sys.executable, "-m", "pkmodes", *map(str, arguments)],
        env=environment(**variables),
        capture_output=True,
        check=True,
    )
    encoding = variables.get("PYTHONIOENCODING", "utf-8")
    return found.stdout.decode(encoding), found.stderr.decode()


def interruptible() -> None:
    """Restore what Ctrl-C does, in a new process before its program starts (``preexec_fn``).

    Where a script runs the tests in the background, interrupts are ignored, and its processes inherit that.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def without_progress(printed: str) -> str:
    """Leave out the lines of progress of a diagnosis, which appear where it takes long, on a busy machine."""
    return re.sub(r"(?m)^pkmodes (?:diagnose|changed): .*\n", "", printed)
