"""Rotations of poses in a table of modes: degrees that no unit calls so are not taken for radians."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements

COMPONENTS = {"x": "m", "ry": "rad"}
SMALL, LARGE = "A,5,0.25,55.5,0.1\n", "B,0,12,60.5,0.1\n"


def read(folder: Path, text: str) -> Measurements:
    path = folder / "modes.csv"
    path.write_text(text, encoding="utf-8")
    return read_measurements(path, (), components=(COMPONENTS,))


def test_rotations_above_pi_without_a_unit_look_like_degrees(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="found 12: these look like degrees") as error:
        read(tmp_path, f"pose,x,ry,frequency,sigma\n{SMALL}{LARGE}")
    assert error.value.where.endswith("line 3, column ry")
    assert error.value.remedy == "write the unit into the header: ry [deg], or ry [rad] if it is that"


@pytest.mark.parametrize(("unit", "factor"), [("[deg]", math.pi / 180.0), ("(rad)", 1.0)])
def test_a_unit_is_believed(tmp_path: Path, unit: str, factor: float) -> None:
    data = read(tmp_path, f"pose,x,ry {unit},frequency,sigma\n{SMALL}{LARGE}")
    assert data.points[:, 1].tolist() == pytest.approx([0.25 * factor, 12.0 * factor])


def test_small_rotations_are_in_radians(tmp_path: Path) -> None:
    assert read(tmp_path, f"pose,x,ry,frequency,sigma\n{SMALL}").points.tolist() == [[5.0, 0.25]]
