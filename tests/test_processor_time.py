"""Files of tests run by their processor time, and the table of files is the sum of that of tests."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from helpers.runs import processor_time


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """The tests of three files, as ``--processor-time`` writes them."""
    rows = [
        ("60.00", "tests/long.py::test_one[a::b]"),
        ("30.00", "tests/middle.py::test_all"),
        ("20.25", 'tests/long.py::test_other["]'),
        ("0.10", "tests/short.py::test_this"),
    ]
    lines = [f"{seconds}\t0.00\t{seconds}\t0.00\t{test}\n" for seconds, test in rows]
    (tmp_path / "tests.tsv").write_text(
        "total\tsetup\tcall\tteardown\ttest\n" + "".join(lines), encoding="utf-8"
    )
    return tmp_path / "tests.tsv"


def test_the_time_of_a_file_is_that_of_its_tests(table: Path) -> None:
    assert (
        processor_time.by_file(table)
        == "seconds\tfile\n80\ttests/long.py\n30\ttests/middle.py\n0\ttests/short.py\n"
    )


def test_a_new_file_runs_first_then_the_longest_each_in_its_own_order(
    table: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "files.tsv").write_text(processor_time.by_file(table), encoding="utf-8")
    monkeypatch.setattr(processor_time, "FILES", tmp_path / "files.tsv")
    names = ["short.py::b", "long.py::b", "short.py::a", "new.py::a", "middle.py::a", "long.py::a[x::y]"]
    items: Any = [SimpleNamespace(nodeid=f"tests/{name}") for name in names]
    processor_time.pytest_collection_modifyitems(items)
    assert [item.nodeid.removeprefix("tests/") for item in items] == [
        *("new.py::a", "long.py::b", "long.py::a[x::y]", "middle.py::a", "short.py::b", "short.py::a")
    ]
