"""The robot that a manifest records: what a copied model was generated with, where its robot file is not at hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from pkmodes.errors import PkmodesError
from pkmodes.robot.reading import COMPONENTS, FRAME_MASS, robot_from_document
from pkmodes.robot.robot import Robot

#: Elements of a vector, which the manifest has one by one and a robot file as a list.
VECTORS = {"gravity": COMPONENTS, "origin": COMPONENTS, "joint": COMPONENTS, "limits": ("min", "max")}


def recorded_robot(recorded: Mapping[str, Any], place: str) -> Robot:
    """Read a robot from the values in a manifest; they are in SI units and complete.

    Parameters
    ----------
    recorded : mapping
        The manifest.
    place : str
        The manifest's file, for messages.

    Raises
    ------
    PkmodesError
        If what it records is not a robot.
    """
    try:
        values = recorded["robot"]["values"]
        document = {
            "format": 1,
            "name": recorded["robot"]["name"],
            "mechanism": recorded["mechanism"],
            **_document(values),
        }
        robot = robot_from_document(document, place)
        # As recorded: normalised again, a direction could differ in its last digit.
        direction = np.array([values[f"axis.{j}.direction"] for j in (1, 2, 3)])
        robot = replace(robot, parameters=robot.parameters._replace(direction=direction))
        same = robot.declared == values
    except (PkmodesError, LookupError, TypeError, ValueError, AttributeError):
        same = False
    if not same:
        raise PkmodesError(
            "the manifest does not record the robot that the model was generated with",
            place,
            "put its robot file back, or generate the model again with: pkmodes generate ROBOT.toml --out DIR",
        )
    return robot


def _document(values: Mapping[str, Any]) -> dict[str, Any]:
    """A robot file with these values, by dotted path."""
    found: dict[str, Any] = {}
    for path, value in values.items():
        if path == f"effects.{FRAME_MASS}" and "frame.mass" in values:
            continue  # declared with the frame: the effect only repeats it
        *tables, key = path.split(".")
        table = found
        for name in tables:
            table = table.setdefault(name, {})
        table[key] = value
    found["axis"] = [found["axis"][number] for number in ("1", "2", "3")]
    for table in (found, *found["axis"]):
        for name in VECTORS.keys() & table.keys():
            table[name] = [table[name][element] for element in VECTORS[name]]
    return found
