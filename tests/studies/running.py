"""Run cases in several processes, here or on a cluster, and keep what was found of them."""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Generic, TypeVar

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.machine.maps.running import connect

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


@dataclass(frozen=True)
class Pool:
    """Where cases run: in processes of this machine, or on the workers of a Dask scheduler.

    Attributes
    ----------
    jobs : int
        Processes of this machine.
    scheduler : str, optional
        Address of the scheduler, whose workers run the cases instead.
    """

    jobs: int = JOBS
    scheduler: str | None = None

    @classmethod
    def of(cls, arguments: argparse.Namespace) -> Pool:
        """Return what the command line says."""
        return cls(arguments.jobs, arguments.scheduler)

    def __str__(self) -> str:
        """Return what ran the cases."""
        if self.scheduler is not None:
            return "the workers of a Dask scheduler"
        return f"{self.jobs} process{'es' if self.jobs > 1 else ''}"

    @contextmanager
    def executor(self) -> Iterator[Executor]:
        """Give what runs cases in processes with one thread each: one for each core is faster than threads.

        Raises
        ------
        SystemExit
            If there is no such scheduler, or a worker would run several cases in one process.
        """
        if self.scheduler is None:
            for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
                os.environ.setdefault(name, "1")
            with ProcessPoolExecutor(self.jobs, mp_context=multiprocessing.get_context("spawn")) as pool:
                yield pool
            return
        with ExitStack() as stack:
            try:
                client = stack.enter_context(connect(self.scheduler))
                if (threads := max(client.nthreads().values())) > 1:
                    what = f"expected workers with one thread each, found one with {threads}"
                    remedy = f"start them with: dask worker {self.scheduler} --nworkers N --nthreads 1"
                    raise PkmodesError(what, f"scheduler {shown(self.scheduler)}", remedy)
            except PkmodesError as error:
                raise SystemExit(f"error: {error}") from None
            yield client.get_executor(pure=False)


def command_line(description: str, seed: int = 1) -> argparse.ArgumentParser:
    """Return the options that all suites have."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--out", type=Path, help="folder for the tables, CSV; by default they are printed")
    parser.add_argument(
        "--seed", type=int, default=seed, help="seed of the random draws (noise, true values)"
    )
    return parser


def parallel_command_line(description: str, seed: int = 1) -> argparse.ArgumentParser:
    """Return the options of suites whose cases run in a `Pool`."""
    parser = command_line(description, seed)
    parser.add_argument("--jobs", type=int, default=JOBS, help="processes; default 2")
    parser.add_argument(
        "--scheduler", metavar="ADDRESS", help="run the cases on the workers of this Dask scheduler instead"
    )
    return parser


def run_all(
    run: Callable[[C], R],
    cases: Sequence[C],
    pool: Pool,
    line: Callable[[R], str],
    failed: Callable[..., R] | None = None,
) -> list[R]:
    """Run cases, and say on the terminal what came out.

    Parameters
    ----------
    run, line, failed : callable
        `line` describes an outcome in a line.  `failed` makes the outcome of a case in which an exception was raised:
        its state is ``failed`` and its signal infinite, so that a cause counts as a clear one that was not named.
        Without it the exception is not caught.
    cases : sequence
    pool : Pool
        Where they run.
    """
    outcomes: list[R] = []
    with pool.executor() as executor:
        for outcome in executor.map(partial(_attempt, run, failed), cases):
            outcomes.append(outcome)
            print(f"{len(outcomes)}/{len(cases)} {line(outcome)}", file=sys.stderr, flush=True)
    return outcomes


def _attempt(run: Callable[[Any], R], failed: Callable[..., R] | None, case: Any) -> R:
    try:
        return run(case)
    except Exception:
        if failed is None:
            raise
        return failed(case, "failed", signal=float("inf"), reason=traceback.format_exc(limit=-8))


class Kept:
    """Lines of JSON in a file, one a case: a run that was stopped goes on where it was.

    Parameters
    ----------
    path : Path
        Its folder is made.
    """

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text(encoding="utf-8") if path.exists() else ""
        self._path, self.lines = path, [json.loads(line) for line in text.splitlines()]

    def add(self, line: Any) -> None:
        """Append the line of a case."""
        self.lines.append(json.loads(json.dumps(line)))
        with self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(line) + "\n")
