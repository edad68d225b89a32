"""The published tables as a file of modal measurements at the identified poses."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import pkmodes
from pkmodes.loop.updating import read
from printed import HALF_HERTZ, Array, read_rows

if TYPE_CHECKING:
    from identification import Identified

FILE = Path(__file__).with_name("published-modes.csv")
#: The rounding error is uniformly distributed over half a unit of the last digit either way.
SIGMA = HALF_HERTZ / np.sqrt(3.0)
HEAD = """\
# Tables 1 and 2 of the paper as modal measurements; written by identify.py, which identified the poses.
# Labels: point of the 37.5 mm grid on the centre line.  Positions refer to linear-delta-2022-identified.toml.
# sigma: a frequency rounded to 0.001 Hz has a standard deviation of 0.0005 Hz / sqrt(3).
# Shapes: x in metres in every row (the tables mix metres and x/R_p), each component at the midpoint of the range of
# its printed digits; blank where the printed shape belongs to a different pose than the frequency.
"""


def text(found: Identified) -> str:
    """Return the contents of the file, with rows in the order of the tables."""
    file = io.StringIO()
    file.write(HEAD)
    writer = csv.writer(file, lineterminator="\n")
    names = pkmodes.Model(found.declared).coordinates
    writer.writerow(
        ["pose", "x", "y", "z", "frequency", "sigma", "mode", *[f"shape:{name}" for name in names]]
    )
    radius = float(found.declared.parameters.pulley_radius[0])
    first = found.in_robot_file[2]
    for row, k in zip(found.rows, found.tables.index, strict=True):
        shape = row.middle(found.cut)
        if found.tables.readings[row.name] == "x/R_p":
            shape[:3] *= radius
        components = ["" if row.name in found.strays else f"{value:.5g}" for value in shape]
        place = [f"{first + k * found.geometry.step:.4f}", "0", f"{found.geometry.z:.8f}"]
        writer.writerow([f"G{k:02d}", *place, f"{row.frequency:.3f}", f"{SIGMA:.5f}", row.mode, *components])
    return file.getvalue()


def frequencies(robot: pkmodes.Robot) -> dict[tuple[str, int], float]:
    """Compute the frequencies of a robot at the poses of the file, by point and mode [Hz]."""
    data = read(FILE)
    modes = pkmodes.Model(robot).modes(data.points)
    number = np.array([int(mode) for mode in data.mode])
    found: Array = modes.frequencies[data.pose, modes.rigid_modes + number - 1]
    keys = [
        (row.point, row.mode) for row in read_rows()
    ]  # the file has the rows of the tables in their order
    return dict(zip(keys, found.tolist(), strict=True))
