"""Processor time of every test, and the order in which files of tests run.

Wall time of a test says little where workers share cores.  ``--processor-time FILE`` writes, for every test, the
processor time of its set-up, call and tear-down, of the processes that it started and waited for, too.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest


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
        self._times: defaultdict[str, dict[str, float]] = defaultdict(dict)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._times[report.nodeid][report.when] = report.processor_time

    def pytest_sessionfinish(self) -> None:
        rows = sorted(self._times.items(), key=lambda row: -sum(row[1].values()))
        self._file.parent.mkdir(parents=True, exist_ok=True)
        self._file.write_text(
            "total\tsetup\tcall\tteardown\ttest\n"
            + "".join(
                "\t".join(
                    f"{seconds:.2f}" for seconds in (sum(times.values()), *(times.get(w, 0) for w in _PHASES))
                )
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
