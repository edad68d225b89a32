"""Whether a robot can take the measured poses, with the values set there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, PoseError, shown
from pkmodes.core.mechanism.poses import LARGE, check_poses, placed
from pkmodes.core.robot.robot import Robot
from pkmodes.measured.header import in_words
from pkmodes.measured.measurements import Measurements
from pkmodes.updating.load_cases import LoadCases, of_columns

#: Factors for lengths in another unit than stated, and the remedy.
OTHER_LENGTHS = {
    1e-3: "the numbers look like millimetres: write {0} in the header",
    1e3: "the numbers look like metres, but the header says otherwise: write {1} there",
}


def check_reachable(robot: Robot, data: Measurements, loads: LoadCases) -> None:
    """Refuse the first pose that cannot be evaluated, with the line of its first row.

    Raises
    ------
    MeasurementError
    """
    valid = np.ones(len(data.points), dtype=bool)
    for c, case in enumerate(loads.cases):
        rows = np.flatnonzero(loads.of == c)
        valid[rows] = _reached(case.robot, data.points[rows])
    if valid.all():
        return
    mechanism, columns = robot.mechanism, f"columns {in_words(data.components)}"
    first = int(np.argmin(valid))
    line = data.lines[int(np.argmax(data.pose == first))]
    where = f"{data.source}: line {line}, {columns}"
    if (bad := int((~valid).sum())) > 1:
        where += f", the first of {bad} bad poses"
    if not valid.any():
        _refuse_another_unit(robot, data, where)
    load, remedy = data.load(first), f"check the row and {robot.source}"
    if _reached(robot, data.points[first]).all():  # as declared, the robot reaches it
        where, remedy = where.replace(columns, of_columns(load)), "check the set values"
    loaded = loads.cases[loads.of[first]].robot
    try:
        check_poses(data.points[first], mechanism, loaded.parameters, "raise")
    except PoseError as error:
        label, place = shown(data.labels[first]), placed(mechanism, data.points[first])
        set_values = " with the set values" if load else ""
        what = f"pose {label} at {place} cannot be reached{set_values}: {error.what}"
        raise MeasurementError(what, where, f"{error.remedy}; {remedy}") from None


def _refuse_another_unit(robot: Robot, data: Measurements, where: str) -> None:
    """Refuse poses that can all be reached with lengths in another unit than stated."""
    lengths = [component.unit == "m" for component in robot.mechanism.pose]
    large = np.abs(data.points[:, lengths]).max(initial=0.0) >= LARGE
    for factor, remedy in OTHER_LENGTHS.items():
        scaled = data.points * np.where(lengths, factor, 1.0)
        if (factor > 1.0 or large) and _reached(robot, scaled).all():
            columns = ",".join(
                f"{name} [mm]" if length else name
                for name, length in zip(data.components, lengths, strict=True)
            )
            what = f"no pose can be reached, but all can if multiplied by {factor:g}"
            raise MeasurementError(what, where, remedy.format(columns, ",".join(data.components)))


def _reached(robot: Robot, points: NDArray[np.float64]) -> NDArray[np.bool_]:
    return check_poses(points, robot.mechanism, robot.parameters, "nan").valid
