"""From a robot file to a generated model: the bridge between runtime and derivation.

This is the only module that imports the derivation, and it does so when it is called: ``import pkmodes`` must
work, and fast, without SymPy.
"""

from __future__ import annotations

import os
import shlex
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from pkmodes.errors import MissingExtraError, OutputError, shown
from pkmodes.evaluation import active_effects
from pkmodes.product_folder import MANIFEST, check_owner, check_place, stale_outputs
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot
from pkmodes.writing import write_files

#: The extra `derive` of pyproject.toml: named here so that it can be installed without an index that has pkmodes.
REQUIREMENTS = ("jinja2>=3.1", "sympy==1.14.0")

if TYPE_CHECKING:
    from pkmodes_derive.emit.specification import Specification


def derivation(name: str) -> ModuleType:
    """Import a module of the derivation.

    Raises
    ------
    MissingExtraError
        If SymPy or Jinja2 is not installed.
    """
    from importlib import import_module

    try:
        return import_module(f"pkmodes_derive.{name}")
    except ModuleNotFoundError as error:
        raise MissingExtraError(
            f"{error.name} is not installed; generating and checking code needs it",
            "optional dependency",
            f"install it with: pip install {' '.join(map(shlex.quote, REQUIREMENTS))}, "
            "or in a checkout of pkmodes with: pip install '.[derive]'",
        ) from None


def specification(robot: Robot, robot_file: str) -> Specification:
    """What the derivation needs to know of a robot; `robot_file` is how its product refers to the file."""
    found: Specification = derivation("emit.specification").Specification(
        name=robot.name,
        mechanism=robot.mechanism,
        robot_file=robot_file,
        fields={name: _plain(value) for name, value in robot.parameters._asdict().items()}
        | {path.replace(".", "_"): value for path, value in robot.effects.items()},
        values=robot.declared,
        effects=active_effects(robot.kind, robot.effects),
    )
    return found


def _plain(value: Any) -> Any:
    return value.tolist() if hasattr(value, "tolist") else value


def generate(robot_file: Path, out: Path) -> list[Path]:
    """Generate the model of one robot.

    Parameters
    ----------
    robot_file : Path
        The robot file.
    out : Path
        Folder of the product; made if it is not there.

    Returns
    -------
    list of Path
        The files written: a NumPy module, a C source, its header, a manifest.

    Raises
    ------
    RobotFileError
        If the robot file is wrong.
    OutputError
        If the folder cannot be written, is no place for generated files, or holds the model of another robot.
    MissingExtraError
        If SymPy or Jinja2 is not installed.
    """
    robot = read_robot(robot_file)
    recorded = _recorded(out)
    reference = relative(robot_file, out)
    check_place(out, robot_file, recorded)
    if recorded is not None:
        check_owner(out, recorded, reference, robot.name)
    texts = derivation("emit.product").specialised(specification(robot, reference))
    generated = derivation("emit.currency").carries_header
    stale = [] if recorded is None else stale_outputs(out, recorded, texts, generated)
    written = write_files(out, texts)
    for path in stale:
        path.unlink(missing_ok=True)
    return written


def relative(robot_file: Path, out: Path) -> str:
    """The robot file as seen from the product's folder, with forward slashes."""
    return Path(os.path.relpath(robot_file.resolve(), out.resolve())).as_posix()


def _recorded(folder: Path) -> dict[str, Any] | None:
    """The manifest of the model that a folder holds, None where there is none."""
    place = folder / MANIFEST
    try:
        place.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError) as error:  # a name that cannot be one of a folder
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise OutputError(f"cannot write: {reason}", shown(str(folder)), "choose another place") from None
    try:
        content: dict[str, Any] = derivation("emit.currency").read_manifest(folder)
    except (ValueError, OSError) as error:
        raise OutputError(
            f"the folder holds a manifest that cannot be read: {error}",
            str(place),
            "choose another folder, or remove that file",
        ) from None
    return content
