"""Coordinates and attributes of a dataset of a robot, after the CF conventions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.version import VERSION
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import reasons_of
from pkmodes.core.solve.fields import COORDINATE, DIRECTION, DRIVE, MODE
from pkmodes.core.support.extras import require
from pkmodes.machine.dataset.robot_text import text_of
from pkmodes.machine.dataset.variables import EVENTS, FIRST

CONVENTIONS = "CF-1.11"


def imported() -> Any:
    """Import xarray.

    Raises MissingExtraError.
    """
    require("maps", "map", "xarray", "pandas")
    import xarray

    return xarray


def meanings_of(robot: Robot, name: str) -> dict[str, Any]:
    """Return further attributes of a variable: what its codes mean."""
    if name == "reason":
        return reasons_of(robot.mechanism, robot.usable)
    if name == "tracking":
        masks = np.array(list(EVENTS.values()), dtype=np.int8)
        return {"flag_masks": masks, "flag_meanings": " ".join(EVENTS)}
    return {}


def labels_of(mechanism: Mechanism, modes: int, coordinates: tuple[str, ...]) -> dict[str, Any]:
    """Return the coordinates along the axes after the poses."""
    numbers = np.arange(FIRST, FIRST + modes)
    part = "component" if mechanism.rotations else "direction"
    return {
        MODE: (MODE, numbers, {"units": "1", "long_name": "vibration mode, rigid-body modes left out"}),
        DIRECTION: (
            DIRECTION,
            np.array(mechanism.components),
            _named(f"{part} of motion of the {mechanism.moving_body()}"),
        ),
        COORDINATE: (COORDINATE, np.array(coordinates), _named("generalised coordinate")),
        DRIVE: (DRIVE, np.array([d.name for d in mechanism.drives]), _named("drive")),
    }


def _named(long_name: str) -> dict[str, str]:
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
        "robot_file": text_of(robot),
        "robot_file_name": Path(robot.source).name,
        "version": VERSION,
        "rigid_modes": rigid_modes,
        "drives": drives,
    }
