"""From a robot file to a generated model: the bridge between runtime and derivation.

This is the only module that imports the derivation, and it does so when it is called: ``import pkmodes`` must
work, and fast, without SymPy.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from pkmodes.errors import MissingExtraError, OutputError
from pkmodes.evaluation import active_effects
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot
from pkmodes.writing import write_files

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
            "install it with: pip install 'pkmodes[derive]'",
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
        effects=active_effects(robot.effects),
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
        If the folder cannot be written or holds the model of another robot file.
    MissingExtraError
        If SymPy or Jinja2 is not installed.
    """
    robot = read_robot(robot_file)
    reference = relative(robot_file, out)
    texts = derivation("emit.product").specialised(specification(robot, reference))
    stale = _stale_outputs(out, reference, texts)
    written = write_files(out, texts)
    for path in stale:
        path.unlink(missing_ok=True)
    return written


def relative(robot_file: Path, out: Path) -> str:
    """The robot file as seen from the product's folder, with forward slashes."""
    return Path(os.path.relpath(robot_file.resolve(), out.resolve())).as_posix()


def _stale_outputs(out: Path, reference: str, texts: Iterable[str]) -> list[Path]:
    """Outputs of an earlier generation from the same robot file, under a name that it had then."""
    if not (out / "manifest.json").is_file():
        there = [name for name in texts if (out / name).exists()]
        if there:
            raise OutputError(
                f"{there[0]} is there and there is no manifest that says it was generated",
                str(out),
                "choose another folder, or remove that file",
            )
        return []
    try:
        recorded = derivation("emit.currency").read_manifest(out)
    except (ValueError, OSError) as error:
        raise OutputError(
            f"the folder holds a manifest that cannot be read: {error}",
            str(out / "manifest.json"),
            "remove it",
        ) from None
    owner = recorded.get("robot", {}).get("file") if isinstance(recorded.get("robot"), dict) else None
    if owner != reference:
        found = f"the robot file {owner}" if owner else f"the mechanism {recorded.get('mechanism')}"
        raise OutputError(
            f"the folder already holds the model generated from {found}",
            str(out),
            "choose another folder, or remove that one",
        )
    # Only files in this very folder: a manifest cannot make us remove anything elsewhere.
    beside = {path.name for path in out.iterdir() if path.is_file()}
    return [out / name for name in recorded["outputs"] if name in beside - set(texts)]
