"""Coordinates and attributes of a dataset of a robot, after the CF conventions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.version import VERSION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import meanings_of_reason_codes
from pkmodes.core.solve.fields import COORDINATE, DIRECTION, DRIVE, MODE
from pkmodes.core.support.extras import require
from pkmodes.machine.dataset.robot_text import robot_file_text
from pkmodes.machine.dataset.variables import EVENT_FLAGS, FIRST_MODE

CONVENTIONS = "CF-1.11"


def import_xarray() -> Any:
    """Import xarray.

    Raises MissingExtraError.
    """
    require("maps", "map", "xarray", "pandas")
    import xarray

    return xarray


def code_attributes(robot: Robot, name: str) -> dict[str, Any]:
    """Return the attributes of a variable that explain its codes; none for a variable without codes."""
    if name == "reason":
        return meanings_of_reason_codes(robot.mechanism, robot.usable)
    if name == "tracking":
        masks = np.array(list(EVENT_FLAGS.values()), dtype=np.int8)
        return {"flag_masks": masks, "flag_meanings": " ".join(EVENT_FLAGS)}
    return {}


def axis_coordinates(
    mechanism: Mechanism, mode_count: int, generalised_coordinates: tuple[str, ...]
) -> dict[str, Any]:
    """Return the coordinates of the axes that follow the pose axes."""
    mode_numbers = np.arange(FIRST_MODE, FIRST_MODE + mode_count)
    kind_of_motion = "component" if mechanism.rotations else "direction"
    return {
        MODE: (MODE, mode_numbers, {"units": "1", "long_name": "vibration mode, rigid-body modes left out"}),
        DIRECTION: (
            DIRECTION,
            np.array(mechanism.components),
            _label_attributes(f"{kind_of_motion} of motion of the {mechanism.moving_body()}"),
        ),
        COORDINATE: (
            COORDINATE,
            np.array(generalised_coordinates),
            _label_attributes("generalised coordinate"),
        ),
        DRIVE: (DRIVE, np.array([d.name for d in mechanism.drives]), _label_attributes("drive")),
    }


def _label_attributes(long_name: str) -> dict[str, str]:
    return {"units": "1", "long_name": long_name}


def attributes_of(robot: Robot, rigid_modes: int, drives: str = FREE) -> dict[str, Any]:
    """Return the attributes of a dataset of a robot."""
    return {
        "Conventions": CONVENTIONS,
        "title": f"natural frequencies and mode shapes of {robot.name}",
        "source": f"pkmodes {VERSION}",
        "history": f"computed by pkmodes {VERSION}",
        "robot": robot.name,
        "mechanism": robot.mechanism_name,
        "robot_file": robot_file_text(robot),
        "robot_file_name": Path(robot.source).name,
        "version": VERSION,
        "rigid_modes": rigid_modes,
        "drives": drives,
    }
