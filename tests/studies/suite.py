"""What suites share: cases drawn from a seed, run in a pool, counted in tables that one command writes."""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Generic

from studies.running import C, Pool, R, parallel_command_line, run_all
from studies.tables import Table, Tables, publish


class Suite(Generic[C, R]):
    """A family of cases, and what is measured of them.

    A family has its own class of cases, its judge (`run`) and its columns (`tables`).

    Attributes
    ----------
    description : str
        Of the command.
    seed : int
        Of the draws, by default.
    run : callable
        Measures, diagnoses and judges a case.
    failed : callable or None
        Makes the outcome of a case in which an exception was raised; without it the exception is not caught.
    """

    description: str
    seed = 1
    run: Callable[[C], R]
    failed: Callable[..., R] | None = None

    def cases(self, arguments: argparse.Namespace) -> Iterable[C]:
        """Return all cases of the seed of the command line."""
        raise NotImplementedError

    def label(self, case: C) -> str:
        """Return the name of a case, of which ``--only`` gives a part."""
        return str(getattr(case, "label"))  # noqa: B009 - the classes of cases have no base

    def line(self, outcome: R) -> str:
        """Return an outcome in a line, for the terminal."""
        raise NotImplementedError

    def tables(self, outcomes: Sequence[R]) -> Tables:
        """Return the tables of the outcomes, without the summary."""
        raise NotImplementedError

    def facts(self, outcomes: Sequence[R]) -> dict[str, object]:
        """Return what the summary says besides the seed, the number of cases, and times."""
        return {}

    def options(self, parser: argparse.ArgumentParser) -> None:
        """Add options of this family."""

    def chosen(self, arguments: argparse.Namespace) -> list[C]:
        """Return the cases that the command line asks for."""
        some = [case for case in self.cases(arguments) if arguments.only in self.label(case)]
        return some[:: arguments.every]

    def instead(self, arguments: argparse.Namespace) -> bool:
        """Do what an option asks for in place of running the cases; return whether there was any."""
        return False

    def after(self, outcomes: Sequence[R], arguments: argparse.Namespace, pool: Pool) -> None:
        """Do what follows the cases, before the tables are made."""

    def summary(self, outcomes: Sequence[R], seed: int, seconds: float, pool: Pool) -> Table:
        """Return the table of what was run."""
        facts: dict[str, Any] = {"seed": seed, "cases": len(outcomes), **self.facts(outcomes)}
        if times := [getattr(o, "seconds", 0.0) for o in outcomes]:
            facts |= {
                "median [s]": f"{statistics.median(times):.1f}",
                "longest [s]": f"{max(times):.1f}",
            }
        return Table.of(
            ("quantity", "value"), [*facts.items(), ("minutes", f"{seconds / 60:.0f}"), ("run by", pool)]
        )

    def main(self) -> None:
        """Run the chosen cases, and write their tables.

        Raises
        ------
        SystemExit
            If the options choose no case.
        """
        parser = parallel_command_line(self.description, self.seed)
        parser.add_argument("--only", default="", help="part of the label of the cases to run")
        parser.add_argument("--every", type=int, default=1, help="run one case in this many")
        self.options(parser)
        arguments = parser.parse_args()
        if self.instead(arguments):
            return
        if not (chosen := self.chosen(arguments)):
            raise SystemExit(f'error: no case has "{arguments.only}" in its label')
        pool, start = Pool.of(arguments), time.perf_counter()
        outcomes = run_all(self.run, chosen, pool, self.line, self.failed)
        self.after(outcomes, arguments, pool)
        summary = self.summary(outcomes, arguments.seed, time.perf_counter() - start, pool)
        publish({"summary": summary, **self.tables(outcomes)}, arguments.out)
