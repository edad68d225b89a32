"""Tables of modes whose rows end with a separator, as some programs write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.reading import read_modes

HEADER, ROWS = "pose,frequency,sigma,damping", ("A,55.5,0.11,0.01", "A,60.25,0.12,")


def written(folder: Path, header: str, *rows: str) -> Path:
    path = folder / "modes.csv"
    path.write_text("\n".join([header, *rows, ""]), encoding="utf-8")
    return path


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("of_header", ["", ","])
def test_a_separator_after_the_last_cell_of_each_row_is_none(
    tmp_path: Path, separator: str, of_header: str
) -> None:
    lines = (f"{HEADER}{of_header}", *(f"{row}," for row in ROWS))
    data = read_modes(written(tmp_path, *(line.replace(",", separator) for line in lines)), ())
    assert data.frequency.tolist() == [55.5, 60.25]
    assert data.damping[0] == 0.01
    assert data.damping[1] != data.damping[1]  # blank


def test_blank_last_cells_stay_blank(tmp_path: Path) -> None:
    data = read_modes(written(tmp_path, HEADER, "A,55.5,0.11,", "A,60.25,0.12,"), ())
    assert data.frequency.tolist() == [55.5, 60.25]


def test_rows_of_different_lengths_are_refused(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="expected 4 cells, found 5"):
        read_modes(written(tmp_path, HEADER, ROWS[0], f"{ROWS[1]},"), ())
