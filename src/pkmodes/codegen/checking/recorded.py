"""The robot recorded in a manifest, used if a copied model is without its robot file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import registry
from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.variants import document_of


def recorded_robot(recorded: Mapping[str, Any], place: str) -> Robot:
    """Read a robot from the values in a manifest, which are in SI units and complete.

    Parameters
    ----------
    recorded : mapping
        The manifest.
    place : str
        The manifest's file, for messages.

    Raises
    ------
    PkmodesError
        If the manifest does not record a valid robot.
    """
    try:
        values = recorded["robot"]["values"]
        mechanism = registry.mechanism(recorded["mechanism"])
        robot = robot_from_document(document_of(mechanism, recorded["robot"]["name"], values), place)
        same = robot.declared == values
    except (PkmodesError, LookupError, TypeError, ValueError, AttributeError):
        same = False
    if not same:
        raise PkmodesError(
            "the manifest does not record the robot that the model was generated with",
            place,
            "restore its robot file, or generate the model again with: pkmodes generate ROBOT.toml --out DIR",
        )
    return robot
