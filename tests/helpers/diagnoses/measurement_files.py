"""Files of measurements as text: the columns of a robot with three axes, and what reading them gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements

CHANNELS = ("x_1", "x_2", "x_3", "theta_1_1", "theta_2_1", "p_x", "p_y", "p_z")
HEADER = "pose,x,y,z,frequency,sigma"
FULL = f"{HEADER},sigma_x,sigma_y,sigma_z,damping,mode,shape:x_1,shape:p_z"
ROW = "A,0.6,0,-0.245,55.5,0.05"


def read(tmp_path: Path, text: str) -> Measurements:
    path = tmp_path / "modes.csv"
    path.write_bytes(text.encode("utf-8"))
    return read_measurements(path, CHANNELS)


def refusal(tmp_path: Path, text: str) -> str:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, text)
    (line,) = error.value.lines
    assert str(tmp_path / "modes.csv") in line
    assert "\n" not in line
    assert "; " in line, "what to do is missing"
    return line
