"""Diagnoses of the identified robot at the identified poses, and of the declared robot at its own extremes."""

from __future__ import annotations

import pkmodes
from extremes import Extremes
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating import diagnose, read
from printed import read_rows
from published_modes import FILE, SIGMA


def diagnose_published(robot: pkmodes.Robot) -> Diagnosis:
    """Diagnose a robot with the published tables at the identified poses."""
    return diagnose(robot, read(FILE))


def assumed_poses(found: Extremes) -> Measurements:
    """Return the published frequencies at a robot's minima and maxima along its centre line.

    The paper says no more about the poses.  Rows at the same pose share its label.  Shapes are left out: read as
    headed, most of them have the wrong unit.
    """
    rows = read_rows()
    index = [found.index[row.point, row.mode] for row in rows]
    return Measurements.from_rows(
        [f"x = {found.poses[i, 0]:.4f} m" for i in index],
        [row.frequency for row in rows],
        [SIGMA] * len(rows),
        points=found.poses[index],
        mode=[row.mode for row in rows],
        source="published tables at the declared robot's own extremes",
    )
