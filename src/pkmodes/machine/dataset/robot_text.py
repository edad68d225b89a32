"""The text of a robot file that declares a robot."""

from __future__ import annotations

from pathlib import Path

import tomlkit

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.variants import document_of, raw_values


def robot_file_text(robot: Robot) -> str:
    """Return the text of a robot file that declares this robot.

    Returns the robot's file itself if it still declares this robot, with its comments; otherwise a text in SI units.
    """
    path = Path(robot.source)
    try:
        if path.is_file() and read_robot(path) == robot:
            return path.read_text(encoding="utf-8-sig")
    except (PkmodesError, OSError, ValueError):  # the file changed since
        pass
    document = document_of(
        robot.mechanism,
        robot.name,
        raw_values(robot),
        robot.usable,
        robot.report,
        robot.covariance,
        robot.drives,
    )
    return tomlkit.dumps(document)
