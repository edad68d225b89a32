"""Processor time of every test, and the order in which files of tests run.

Wall time of a test says little where workers share cores.  ``--processor-time FILE`` writes, for every test, the
processor time of its set-up, call and tear-down, of the processes that it started and waited for, too.

Workers take whole files, the longest first, so that what a file sets up is set up once and all workers end together:
tests/processor_time.tsv has the seconds of each file, and ``python tests/helpers/runs/processor_time.py FILE``
writes it anew from a table of all tests.
"""

from __future__ import annotations

import csv
import math
import os
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

#: Seconds of each file, the longest first.
FILES = Path(__file__).parents[2] / "processor_time.tsv"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--processor-time",
        metavar="FILE",
        type=Path,
        help="write the processor time of every test [s] as a table",
    )


def _used() -> float:
    """Return the processor time of this process and of those that it has waited for [s]."""
    return sum(os.times()[:4])


class Meter:
    """Measures in the process that runs tests; what it measures travels with the reports."""

    def __init__(self) -> None:
        self._before = _used()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self) -> Iterator[None]:
        report = yield
        after = _used()
        report.processor_time = after - self._before
        self._before = after
        return report


class Table:
    """Collects the reports of all workers."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self._times: defaultdict[str, Counter[str]] = defaultdict(Counter)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        # The cases of a test, its subtests, are reported as calls of their own.
        self._times[report.nodeid][report.when] += report.processor_time

    def pytest_sessionfinish(self) -> None:
        rows = sorted(self._times.items(), key=lambda row: -row[1].total())
        self._file.parent.mkdir(parents=True, exist_ok=True)
        self._file.write_text(
            "total\tsetup\tcall\tteardown\ttest\n"
            + "".join(
                "\t".join(f"{seconds:.2f}" for seconds in (times.total(), *(times[w] for w in _PHASES)))
                + f"\t{test}\n"
                for test, times in rows
            ),
            encoding="utf-8",
        )


_PHASES = ("setup", "call", "teardown")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(Meter())
    file = config.getoption("--processor-time")
    if file and not hasattr(config, "workerinput"):
        config.pluginmanager.register(Table(file))


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest file first; a new one before all others, because nothing is known of it."""
    with FILES.open(encoding="utf-8", newline="") as file:
        seconds = {row["file"]: float(row["seconds"]) for row in csv.DictReader(file, delimiter="\t")}
    items.sort(key=lambda item: -seconds.get(item.nodeid.split("::")[0], math.inf))


def by_file(table: Path) -> str:
    """Return the seconds of every file from a table of all tests."""
    seconds: defaultdict[str, float] = defaultdict(float)
    with table.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE):
            seconds[row["test"].split("::")[0]] += float(row["total"])
    rows = sorted(seconds.items(), key=lambda row: (-row[1], row[0]))
    return "seconds\tfile\n" + "".join(f"{total:.0f}\t{name}\n" for name, total in rows)


if __name__ == "__main__":
    FILES.write_text(by_file(Path(sys.argv[1])), encoding="utf-8")
