"""Run the cases of suites in several processes, and write their pages: what all suites share."""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import traceback
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Generic, TypeVar

from pkmodes.diagnosis.posterior.document import Probabilities

C = TypeVar("C")
R = TypeVar("R")

#: Processes by default.
JOBS = min(2, os.cpu_count() or 1)


@dataclass(frozen=True)
class Outcome(Generic[C]):
    """Outcome of a case; what is not described here is copied from the diagnosis.

    Attributes
    ----------
    state : str
        ``adequate``; ``abstained`` (ambiguous, unexplained, insufficient_data); for a claim: ``named`` (each
        cause in a separate class), ``partly`` (nothing wrong, but not every cause), ``wrong`` (a class without any
        of the causes); ``failed`` if an exception was raised.
    classes : tuple of tuple of str
        Classes of the causes found, or the survivors.
    values : tuple of (name, estimate, sigma, true)
        Parameters of the causes that were named.
    signal : float
        Predicted signal for the modes that were found, see `strengths`; infinite if an exception was raised.
    seconds : float
        Time of the diagnosis.
    reason : str
        Of the diagnosis, or the traceback of the exception.
    rule : str
        The rule that gave the verdict, with its table: "claims.found".
    probabilities : Probabilities or None
    candidates : tuple of str
        Names of the candidates that were tested.
    """

    case: C
    state: str
    verdict: str = ""
    classes: tuple[tuple[str, ...], ...] = ()
    values: tuple[tuple[str, float, float, float], ...] = ()
    signal: float = 0.0
    seconds: float = 0.0
    reason: str = ""
    rule: str = ""
    probabilities: Probabilities | None = None
    candidates: tuple[str, ...] = ()


def command_line(description: str, seed: int = 1) -> argparse.ArgumentParser:
    """Return the options that all suites have."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--out", type=Path, help="file for the page; by default it is printed")
    parser.add_argument(
        "--seed", type=int, default=seed, help="seed of the random draws (noise, true values)"
    )
    parser.add_argument("--jobs", type=int, default=JOBS, help="processes; default 2")
    return parser


def run_all(
    run: Callable[[C], R],
    cases: Sequence[C],
    jobs: int,
    said: Callable[[R], str],
    failed: Callable[..., R] | None = None,
) -> list[R]:
    """Run cases, and say on the terminal what came out.

    Parameters
    ----------
    run, said, failed : callable
        `said` describes an outcome in a line.  `failed` makes the outcome of a case in which an exception was raised:
        its state is ``failed`` and its signal infinite, so that a cause counts as a clear one that was not named.
        Without it the exception is not caught.
    cases : sequence
    jobs : int
        Processes.
    """
    outcomes: list[R] = []
    with _processes(jobs) as pool:
        for outcome in pool.map(partial(_attempt, run, failed), cases):
            outcomes.append(outcome)
            print(f"{len(outcomes)}/{len(cases)} {said(outcome)}", file=sys.stderr, flush=True)
    return outcomes


def _attempt(run: Callable[[Any], R], failed: Callable[..., R] | None, case: Any) -> R:
    try:
        return run(case)
    except Exception:
        if failed is None:
            raise
        return failed(case, "failed", signal=float("inf"), reason=traceback.format_exc(limit=-8))


def _processes(jobs: int) -> ProcessPoolExecutor:
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
