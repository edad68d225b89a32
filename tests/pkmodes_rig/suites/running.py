"""Run suites in several processes, and write their pages."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

#: Processes by default.
JOBS = min(2, os.cpu_count() or 1)


def processes(jobs: int) -> ProcessPoolExecutor:
    """Return a pool of processes with one thread each: one process per core is faster than threads."""
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    return ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("spawn"))


def publish(lines: Sequence[str], out: Path | None) -> None:
    """Write a page to a file, or print it."""
    text = "\n".join(lines) + "\n"
    if out is None:
        print(text, end="")
    else:
        out.write_text(text, encoding="utf-8")
