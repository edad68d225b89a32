"""What calls of a pose and of a batch take, as ratios that can be compared between machines and commits."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

import backends_report
from published import published, valid_poses
from timing import interleaved

WRITER = "benchmarks/one_core.py"
ROOT = Path(__file__).parents[1]
#: Calls of one pose that are timed together: one alone takes not much longer than reading the clock.
CALLS = 20
BATCH = 10_000
REPETITIONS = 9
FREE, HELD = "free", "held"


@dataclass(frozen=True)
class Ratio:
    """A time as a multiple of another one in the same run.

    Attributes
    ----------
    name, of : str
        Of the times.
    head : str
        Column in the table.
    most : float, optional
        What is asked.
    """

    name: str
    of: str
    head: str
    most: float | None = None


RATIOS = (
    Ratio("frequencies of a pose", "eigh", "frequencies", 1.5),
    Ratio("modes of a pose", "eigh", "modes", 3.0),
    Ratio("frequencies of a pose, held", "eigh", "held: frequencies", 1.5),
    Ratio("modes of a pose, held", "eigh", "held: modes", 3.0),
    Ratio("modes of a pose, every field read", "eigh", "all read"),
    Ratio("modes of a pose, held, every field read", "eigh", "held: all read"),
    Ratio("shaper of a pose", "eigh", "shaper"),
    Ratio("modes of a batch", "frequencies of a batch", "batch: modes", 2.0),
    Ratio("modes of a batch, held", "frequencies of a batch, held", "batch, held: modes", 2.0),
)


def times(repetitions: int = REPETITIONS) -> dict[str, float]:
    """Measure [s]: `eigh` is one `numpy.linalg.eigh` of the standard problem at a pose, n by n."""
    model, (pose, *_), poses = published(), valid_poses(1), valid_poses(BATCH)
    M, K = model.matrices(pose)
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    standard = inverse @ K @ inverse.T
    fields = type(model.modes(pose)).fields_of(model.mechanism)

    def read(drives: str) -> None:
        modes = model.modes(pose, drives=drives)
        for name in fields:
            getattr(modes, name)

    short: dict[str, Callable[[], object]] = {"eigh": partial(np.linalg.eigh, 0.5 * (standard + standard.T))}
    long: dict[str, Callable[[], object]] = {}
    for drives, word in ((FREE, ""), (HELD, ", held")):
        short[f"frequencies of a pose{word}"] = partial(model.frequencies, pose, drives=drives)
        short[f"modes of a pose{word}"] = partial(model.modes, pose, drives=drives)
        short[f"modes of a pose{word}, every field read"] = partial(read, drives)
        long[f"frequencies of a batch{word}"] = partial(model.frequencies, poses, drives=drives, threads=1)
        long[f"modes of a batch{word}"] = partial(model.modes, poses, drives=drives, threads=1)
    short["shaper of a pose"] = partial(model.shaper, "zv", pose)

    def many(call: Callable[[], object]) -> None:
        for _ in range(CALLS):
            call()

    calls = {name: partial(many, call) for name, call in short.items()} | long
    for call in calls.values():
        call()
    found = interleaved(calls, repetitions)
    return {name: time / (CALLS if name in short else 1) for name, time in found.items()}


def ratios(found: dict[str, float]) -> dict[str, float]:
    """Return the ratios by the heads of the table."""
    return {one.head: found[one.name] / found[one.of] for one in RATIOS}


def lines(found: dict[str, float]) -> list[str]:
    """Write times and ratios for a terminal."""
    written = [f"one numpy.linalg.eigh: {1e6 * found['eigh']:.1f} us"]
    for one, ratio in zip(RATIOS, ratios(found).values(), strict=True):
        asked = (
            "" if one.most is None else f", at most {one.most:g}: {'met' if ratio <= one.most else 'NOT MET'}"
        )
        what = "one eigh" if one.of == "eigh" else one.of
        written.append(f"{one.name}: {ratio:.2f} times {what}{asked}")
    return written


def keep(found: dict[str, float], document: Path) -> None:
    """Add a row for the present commit to the table in a document, or replace the row."""
    head = ["commit", "eigh [us]", *(one.head for one in RATIOS)]
    asked = ["asked, at most", "", *("" if one.most is None else f"{one.most:g}" for one in RATIOS)]
    row = [commit(), f"{1e6 * found['eigh']:.1f}", *map(backends_report.digits, ratios(found).values())]
    begin = backends_report.BEGIN.replace(backends_report.WRITER, WRITER)
    text = document.read_text(encoding="utf-8").partition(begin)[2].partition(backends_report.END)[0]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.split("\n") if line]
    kept = [old for old in cells[3:] if old[0] != row[0]]
    backends_report.put(document, backends_report.table(head, [asked, *kept, row]) + "\n", WRITER)


def commit() -> str:
    """Return the present commit, with a plus if files were changed since."""
    said = ["git", "-C", str(ROOT), "describe", "--always", "--abbrev=8", "--dirty=+", "--exclude=*"]
    return subprocess.run(said, check=True, text=True, stdout=subprocess.PIPE).stdout.strip()
