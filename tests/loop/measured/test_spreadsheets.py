"""Measurement files as spreadsheet and analysis programs write them: the same numbers, or an error that names a cell.

The expected numbers are those of one table, written down once; each program's way of writing it is a text made of it.
"""

from __future__ import annotations

import codecs
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.measurement_files import CHANNELS, HEADER, ROW, read, refusal
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements

#: x and z [m], frequency and sigma [Hz], damping [1], and a shape, of two modes; the motors were held.
POINTS = [[0.0625, 0.0, -0.245], [0.5, 0.0, -0.3]]
FREQUENCIES, SIGMAS, DAMPINGS, SHAPES = [41.25, 63.5], [0.0625, 0.125], [0.0125, 0.02], [0.75, -1.5]
COLUMNS = ["Pose", "X (mm)", "y", "Z (mm)", "Frequency (Hz)", "SIGMA [mHz]", "damping (%)", "Shape:p_z"]
CELLS = [
    ["P1", "62.5", "0", "-245", "41.25", "62.5", "1.25", "0.75"],
    ["P2", "500", "0", "-300", "63.5", "125", "2", "-1.5"],
]


def check(found: Measurements, *, drives: str = "held") -> None:
    assert found.labels == ("P1", "P2")
    assert found.points.tolist() == POINTS
    assert found.frequency.tolist() == FREQUENCIES
    assert found.sigma.tolist() == SIGMAS
    assert found.damping.tolist() == DAMPINGS
    assert found.shapes[:, 0].tolist() == SHAPES
    assert found.drives == (drives, drives)


def table(separator: str = ",", decimal: str = ".") -> str:
    rows = [COLUMNS, *([cell.replace(".", decimal) for cell in row] for row in CELLS)]
    return "\n".join(separator.join(row) for row in rows) + "\n"


@pytest.mark.parametrize("word", ["drives", "Motors"])
@pytest.mark.parametrize(("separator", "decimal"), [(",", "."), (";", ","), ("\t", ",")])
@pytest.mark.parametrize(
    "encode",
    [
        str.encode,
        lambda text: codecs.BOM_UTF8 + text.replace("\n", "\r\n").encode(),
        lambda text: codecs.BOM_UTF16_LE + text.replace("\n", "\r\n").encode("utf-16-le"),
        lambda text: codecs.BOM_UTF16_BE + text.encode("utf-16-be"),
    ],
)
def test_a_table_means_the_same_however_a_program_writes_it(
    tmp_path: Path, word: str, separator: str, decimal: str, encode
) -> None:
    path = tmp_path / "modes.txt"  # found by its content, not by its name
    path.write_bytes(encode(f"# {word}: held{3 * separator}\n{table(separator, decimal)}"))
    check(read_measurements(path, CHANNELS))


def test_the_line_that_tells_excel_the_separator_is_read_over(tmp_path: Path) -> None:
    for line in ("sep=;", '"sep=;"', "SEP = ;"):
        check(read(tmp_path, f"{line}\n{table(';', ',')}"), drives="free")


def test_a_header_in_capitals_tells_which_machine_it_is_of(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("Pose,X (mm),Y,Frequency,Sigma\nA,600,0,55,0.1\n")
    planar, spatial = {"x": "m", "y": "m"}, {"x": "m", "y": "m", "z": "m"}
    found = read_measurements(path, CHANNELS, components=[spatial, planar])
    assert found.points.tolist() == [[0.6, 0.0]]


def test_a_column_may_say_what_the_motors_did(tmp_path: Path) -> None:
    found = read(tmp_path, f"{HEADER},Motors\n{ROW},held\nB,0.5,0,-0.3,55,0.1,free\n")
    assert found.drives == ("held", "free")


def test_a_name_in_capitals_is_a_known_one_only_if_a_single_one_is_meant(tmp_path: Path) -> None:
    (tmp_path / "modes.csv").write_text(f"{HEADER},shape:a,shape:A\n{ROW},1,2\n")
    found = read_measurements(tmp_path / "modes.csv", ("a", "A"))
    assert found.channels == ("a", "A")
    np.testing.assert_array_equal(found.shapes, [[1.0, 2.0]])


@pytest.mark.parametrize(
    ("text", "place", "what", "remedy"),
    [
        (HEADER.replace("frequency", "Frequenz (Hz)"), "line 1, column 5)", "Frequenz (Hz)", '"frequency"'),
        (HEADER.replace("frequency", "frequency (mm)"), "line 1, column 5)", 'such as "Hz"', "Hz"),
        (HEADER.replace("sigma", "sigma (%)"), "line 1, column 6)", "sigma", "multiply by the frequency"),
        (
            f"{HEADER},p_x",
            "line 1, column 7)",
            'unknown column "p_x"',
            "write shape:p_x; otherwise remove it",
        ),
        (f"{HEADER},p_x (mm)", "line 1, column 7)", "unknown column", "shape:p_x"),
        (f"# motors held\n{HEADER}", "line 1)", 'expected a colon after "motors"', '"# drives: held"'),
        (f"# motors: on\n{HEADER}", "line 1)", 'expected "free" or "held", found "on"', '"# drives: held"'),
        (
            f"# drives: held\n# motors: free\n{HEADER}",
            "line 2)",
            "this motors differs from that in line 1",
            "one",
        ),
    ],
)
def test_what_cannot_be_understood_is_named(
    tmp_path: Path, text: str, place: str, what: str, remedy: str
) -> None:
    line = refusal(tmp_path, f"{text}\n{ROW},1\n")
    assert place in line, line
    assert what in line, line
    assert remedy in line.partition("; ")[2], line
