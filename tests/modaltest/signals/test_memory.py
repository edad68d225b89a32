"""Reading fills no more memory than a few times the file, whatever the cells look like."""

from __future__ import annotations

import struct
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.reading import read_signals

ROWS = 200_000
HEADER = {"logger": "time,a,b,c", "quoted": '"time","a","b","c"', "reprap": "Sample,X,Y,Z"}


@pytest.mark.parametrize(("name", "digits"), [("logger", 9), ("logger", 0), ("quoted", 3), ("reprap", 3)])
def test_a_table_takes_four_times_its_size(tmp_path: Path, name: str, digits: int) -> None:
    """And 4 MB; numbers of one digit are four times as long in memory."""
    a = np.random.default_rng(1).normal(size=(ROWS, 3))
    step = 1 if name == "reprap" else 0.001
    rows = (f"{step * i:g},{x:.{digits}f},{y:.{digits}f},{z:.{digits}f}\n" for i, (x, y, z) in enumerate(a))
    path = tmp_path / "table.csv"
    end = "Rate 1344, overflows 0\n" if name == "reprap" else ""
    path.write_text(f"{HEADER[name]}\n{''.join(rows)}{end}")
    tracemalloc.start()
    try:
        read = read_signals(path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert len(read.functions) >= 3
    assert peak < 4 * path.stat().st_size + 4_000_000


def test_a_damaged_file_takes_no_room_for_what_it_states(tmp_path: Path) -> None:
    """Of version 4 of MATLAB: a name of 1.7 GB, and a matrix of a gigabyte, in files of some bytes."""
    for head in (
        struct.pack("<5i", 0, 1, 1, 0, 1_700_000_000),
        struct.pack(">5i", 1000, 11_585, 11_585, 0, 2),
    ):
        path = tmp_path / "signals.mat"
        path.write_bytes(head + b"a\0" + bytes(64))
        tracemalloc.start()
        try:
            with pytest.raises(MeasurementError, match="found the end of the file"):
                read_signals(path)
            peak = tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()
        assert peak < 4_000_000
