"""Corrections of a robot, taken apart into the values of its file that they change."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

from pkmodes.errors import OutputError, PkmodesError, shown
from pkmodes.robot.effects import CATALOGUE
from pkmodes.robot.reading import SHARED
from pkmodes.robot.robot import Robot
from pkmodes.robot.units import DIMENSIONS
from pkmodes.robot.wholes import joints_of_radius, limits_of_span

DIGITS = 10
#: Elements of a whole have more digits, because their rounding adds up in it.
DIGITS_OF_ELEMENTS = 12
EFFECTS = "effects"
FRAME_MASS = "frame.mass"


@dataclass(frozen=True)
class Correction:
    """A value to be written.

    Attributes
    ----------
    value : float
        In SI units.
    sigma : float or None
        One standard deviation in SI units; None keeps the one that the file declares, if any.
    note : str
        The comment to put behind the value, such as "was 1.5 kg: refitted".
    """

    value: float
    sigma: float | None = None
    note: str = ""


@dataclass(frozen=True)
class Edit:
    """A change of one value of the file."""

    value: float
    sigma: float | None
    note: str
    digits: int = DIGITS


def edits_of(changes: Mapping[str, Correction], robot: Robot) -> dict[str, Edit]:
    """The values of the file that corrections change, by dotted path.

    Parameters
    ----------
    changes : mapping of str to Correction
        By path of a value or of a whole.
    robot : Robot
        As its file declares it.

    Raises
    ------
    OutputError
        If a path is not one that can be changed, two corrections change one value, a number is not finite, or
        a joint has no direction in which its radius could change.
    """
    edits: dict[str, Edit] = {}
    for path, correction in changes.items():
        _check_numbers(path, correction, robot)
        for element, edit in _elements(path, correction, robot).items():
            if element in edits:
                refuse("the value would be changed twice", f"{robot.source}: {element}", "change it once")
            edits[element] = edit
    return edits


def refuse(what: str, where: str, remedy: str) -> NoReturn:
    """Raise the error of a robot that cannot be saved."""
    raise OutputError(what, where, remedy) from None


def _check_numbers(path: str, correction: Correction, robot: Robot) -> None:
    sigma = correction.sigma
    if not math.isfinite(correction.value) or not (sigma is None or (math.isfinite(sigma) and sigma >= 0.0)):
        refuse(
            f"expected a finite value and a standard deviation of at least 0, found {correction.value:g} and {sigma}",
            f"{robot.source}: {path}",
            "correct it by finite numbers",
        )


def _elements(path: str, correction: Correction, robot: Robot) -> dict[str, Edit]:
    """The values of the file that a correction changes."""
    if path == "axis.span":
        return _span(correction, robot)
    if path == "axis.joint_radius":
        return _joint_radius(correction, robot)
    if path not in (known := changeable(robot)):
        nearest = difflib.get_close_matches(path, known, n=1, cutoff=0.6)
        remedy = f'did you mean "{nearest[0]}"?' if nearest else "name a value of docs/robot-file.md"
        refuse(f"there is no value {shown(path)} to change", robot.source, remedy)
    return {path: Edit(float(correction.value), correction.sigma, correction.note)}


def changeable(robot: Robot) -> dict[str, str]:
    """Paths that can be changed or added, and their SI units."""
    overrides = {
        f"axis.{j}.{table}.{key}": DIMENSIONS[dimension][0]
        for j in (1, 2, 3)
        for table, keys in SHARED.items()
        for key, dimension in keys.items()
    }
    effects = {
        f"{EFFECTS}.{effect.name}.{parameter.name}": parameter.unit
        for effect in CATALOGUE.values()
        for parameter in effect.parameters
    }
    declared = {path: quantity.unit for path, quantity in robot.quantities.items()}
    return {**declared, FRAME_MASS: "kg", **overrides, **effects, "axis.span": "m", "axis.joint_radius": "m"}


def _span(correction: Correction, robot: Robot) -> dict[str, Edit]:
    note = _note_of_whole("axis.span", correction)
    elements = limits_of_span(robot.parameters.limits, correction.value)
    return {path: Edit(value, None, note, DIGITS_OF_ELEMENTS) for path, value in elements.items()}


def _joint_radius(correction: Correction, robot: Robot) -> dict[str, Edit]:
    note = _note_of_whole("axis.joint_radius", correction)
    try:
        elements = joints_of_radius(robot.parameters.joint, correction.value, robot.source)
    except PkmodesError as error:
        refuse(error.what, error.where, error.remedy)
    return {path: Edit(value, None, note, DIGITS_OF_ELEMENTS) for path, value in elements.items()}


def _note_of_whole(path: str, correction: Correction) -> str:
    sigma = "" if correction.sigma is None else f"sigma of {path} {correction.sigma:.3g} m"
    return "; ".join(part for part in (correction.note, sigma) if part)
