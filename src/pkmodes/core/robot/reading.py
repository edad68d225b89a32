"""Read and validate a robot file in TOML, reporting every problem in it."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NoReturn

from pkmodes.core.base.errors import PkmodesError, RobotFileError, shown
from pkmodes.core.base.toml import MAX_KEY_PARTS, line_of_long_key
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.validation import declaration

MAX_FILE_SIZE = 1_000_000


def read_robot(path: str | PathLike[str]) -> Robot:
    """Read and validate a robot file.

    Parameters
    ----------
    path : path-like
        A TOML file, format 1.

    Returns
    -------
    Robot
        All values in SI units.

    Raises
    ------
    RobotFileError
        If the file cannot be read or is invalid: one problem for each thing to fix, with the dotted path, what was
        expected and what was found.
    """
    name = fspath(path) if isinstance(path, str | PathLike) else None
    if not isinstance(name, str):
        _refuse(
            f"expected the path of a robot file, found {shown(path)}", "robot file", "give its path as text"
        )
    file = Path(name)
    try:
        if file.exists() and not file.is_file():
            kind = "a folder" if file.is_dir() else "not a regular file"
            _refuse(f"cannot read the robot file: it is {kind}", name, "give a robot file in TOML")
        if file.stat().st_size > MAX_FILE_SIZE:
            _refuse("cannot read the robot file: it is larger than 1 MB", name, "give a robot file in TOML")
        text = file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        problem = f"expected UTF-8 text, found an invalid byte at offset {error.start}"
        _refuse(problem, name, "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or str(error)
        _refuse(f"cannot read the robot file: {reason.lower()}", name, "check the path")
    if (line := line_of_long_key(text)) is not None:
        problem = f"expected a key of a few parts, found a line with one of more than {MAX_KEY_PARTS}"
        _refuse(problem, f"{name}: line {line}", "shorten the key")
    try:
        document = tomllib.loads(text)
    except (
        ValueError,
        RecursionError,
    ) as error:  # also integers with too many digits, tables nested too deeply
        _refuse(f"not valid TOML: {error}", name, "fix the syntax at that place")
    return robot_from_document(document, name)


def robot_from_document(document: Mapping[str, Any], source: str) -> Robot:
    """Validate a parsed robot file; `source` names it in messages."""
    return Robot.of(declaration(document, source))


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise RobotFileError([PkmodesError(what, where, remedy)]) from None
