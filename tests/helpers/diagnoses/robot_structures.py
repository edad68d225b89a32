"""Structures of robots as a diagnosis makes them of measurements, and values of their parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis import Measurements
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.loop.updating.robot_structure import RobotStructure


def structure_at(
    robot: Robot, points: np.ndarray, candidates: Sequence[str] | None = None, **columns: Any
) -> RobotStructure:
    """The structure of a robot that was measured at these poses: one row each; `columns` as for `from_rows`."""
    count = len(points)
    data = Measurements.from_rows(
        [f"P{i}" for i in range(count)],
        np.full(count, 50.0),
        np.full(count, 0.1),
        points=points,
        components={component.name: component.unit for component in robot.mechanism.pose},
        **columns,
    )
    return MeasuredRobot.of(robot, data).structure(candidates)


def suspected(robot: Robot, points: np.ndarray, candidates: Sequence[str] | None = None) -> RobotStructure:
    """The structure of a robot at poses that need no measurements, with its candidates."""
    return RobotStructure(robot, points, *suspects(robot, candidates))


def index(structure: Structure, name: str) -> int:
    """The place of a parameter."""
    return [p.name for p in structure.parameters].index(name)


def declared(structure: Structure, changes: Mapping[str, float] = {}) -> np.ndarray:
    """Declared values of the parameters, some of them changed by so much."""
    return np.array([p.value + changes.get(p.name, 0.0) for p in structure.parameters])
