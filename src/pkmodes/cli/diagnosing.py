"""Functions shared by diagnose and changed: lists of names, the verdicts of --fail-on, and progress."""

from __future__ import annotations

import csv
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import click

from pkmodes.cli.progress import on_terminal
from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.support.progress import report_progress

#: The word that stands for all verdicts except adequate.
ANY_VERDICT = "any"
#: Seconds between progress lines if stderr is not a terminal.
PROGRESS_INTERVAL = 5.0


def split_names(text: str, option: str) -> list[str]:
    """Split names at commas; as in the measurements, a name with a comma is written in double quotes."""
    try:
        (cells,) = csv.reader([text], strict=True, skipinitialspace=True)
    except (csv.Error, ValueError):
        cells = []
    names = [cell.strip() for cell in cells if cell.strip()]
    if not names:
        problem = f"expected names separated by commas, found {shown(text)}"
        raise PkmodesError(problem, option, "give at least one name, or omit the option")
    return names


@contextmanager
def progress_lines(command: str) -> Iterator[Callable[[str], None]]:
    """Show progress of a command on stderr: in place on a terminal, otherwise as occasional lines."""
    if on_terminal():
        yield report_progress
        return
    last_time = time.monotonic()

    def print_line(text: str) -> None:
        nonlocal last_time
        if time.monotonic() - last_time >= PROGRESS_INTERVAL:
            last_time = time.monotonic()
            click.echo(f"pkmodes {command}: {text}", err=True)

    yield print_line


def parse_verdicts(names: Sequence[str]) -> frozenset[str]:
    """Return the verdicts that the names stand for.

    - names: verdicts, or the word any

    Raises PkmodesError if there is no such verdict.
    """
    from pkmodes.loop.diagnosis.verdict.verdicts import VERDICTS  # loads SciPy

    choices, verdicts = (*VERDICTS, ANY_VERDICT), set[str]()
    for name in names:
        if name not in choices:
            remedy = nearest_name(name, choices, f"choose from {', '.join(choices)}")
            raise PkmodesError(f"unknown verdict {shown(name)}", "--fail-on", remedy)
        verdicts |= (
            {word for word, verdict in VERDICTS.items() if verdict.fails} if name == ANY_VERDICT else {name}
        )
    return frozenset(verdicts)
