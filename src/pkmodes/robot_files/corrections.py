"""Corrections of a robot, split into edits of single values of its file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

from pkmodes.core.base.errors import OutputError, PkmodesError, nearest, shown
from pkmodes.core.robot.declaration import Declaration, changeable
from pkmodes.core.robot.parameter_groups import elements_of, groups_by_path
from pkmodes_description import ParameterGroup

DIGITS = 10
#: Elements of a group are written with more digits, because their rounding errors add up.
DIGITS_OF_ELEMENTS = 12


@dataclass(frozen=True)
class Correction:
    """A value to write.

    Attributes
    ----------
    value : float
        In SI units.
    sigma : float or None
        One standard deviation in SI units; None keeps the one declared in the file, if any.
    note : str
        The comment to write after the value, such as "was 1.5 kg: refitted".
    """

    value: float
    sigma: float | None = None
    note: str = ""


@dataclass(frozen=True)
class Edit:
    """A change of one value in the file."""

    value: float
    sigma: float | None
    note: str
    digits: int = DIGITS


def edits_of(changes: Mapping[str, Correction], robot: Declaration) -> dict[str, Edit]:
    """Return the edits of the file that corrections require, by dotted path.

    Parameters
    ----------
    changes : mapping of str to Correction
        By path of a value or of a parameter group.
    robot : Declaration
        The robot as declared in its file.

    Raises
    ------
    OutputError
        If a path cannot be changed, two corrections change one value, a number is not finite, or a vector has no
        direction along which its radius could change.
    """
    edits: dict[str, Edit] = {}
    for path, correction in changes.items():
        _check_numbers(path, correction, robot)
        for element, edit in _elements(path, correction, robot).items():
            if element in edits:
                refuse(
                    "the value would be changed twice", f"{robot.source}: {element}", "change it only once"
                )
            edits[element] = edit
    return edits


def refuse(what: str, where: str, remedy: str) -> NoReturn:
    """Raise the error of a robot that cannot be saved."""
    raise OutputError(what, where, remedy) from None


def _check_numbers(path: str, correction: Correction, robot: Declaration) -> None:
    sigma = correction.sigma
    if not math.isfinite(correction.value) or not (sigma is None or (math.isfinite(sigma) and sigma >= 0.0)):
        refuse(
            f"expected a finite value and a standard deviation of at least 0, found {correction.value:g} and {sigma}",
            f"{robot.source}: {path}",
            "use finite numbers",
        )


def _elements(path: str, correction: Correction, robot: Declaration) -> dict[str, Edit]:
    """Return the values of the file that a correction changes."""
    if path in (known := groups_by_path(robot.mechanism)):
        return _of_group(known[path], correction, robot)
    if path not in changeable(robot):
        remedy = nearest(path, changeable(robot), "see docs/robot-file.md for the values")
        refuse(f"there is no value {shown(path)} to change", robot.source, remedy)
    return {path: Edit(float(correction.value), correction.sigma, correction.note)}


def _of_group(group: ParameterGroup, correction: Correction, robot: Declaration) -> dict[str, Edit]:
    """Return the edits of a group's elements; the group's standard deviation goes into the comment."""
    sigma = correction.sigma
    deviation = "" if sigma is None else f"sigma of {group.path} {sigma:.3g} {group.unit}"
    note = "; ".join(part for part in (correction.note, deviation) if part)
    try:
        elements = elements_of(robot, group, correction.value)
    except PkmodesError as error:
        refuse(error.what, error.where, error.remedy)
    return {path: Edit(value, None, note, DIGITS_OF_ELEMENTS) for path, value in elements.items()}
