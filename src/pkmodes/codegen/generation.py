"""Generate code from a robot file, and optionally from the definition of a user-defined mechanism."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pkmodes.codegen.derivation import (
    Definition,
    add_effects,
    as_pkmodes_errors,
    definition_of,
    derive_mechanism,
    effects_of,
    import_derivation,
    read_definition,
    read_effect,
    register_definition,
    staged_mechanism,
    with_stored_effects,
)
from pkmodes.codegen.product_folder import (
    MANIFEST,
    check_mechanism,
    check_no_link,
    check_owner,
    check_place,
    folder_lock,
    stale_outputs,
)
from pkmodes.core.base.errors import OutputError, PkmodesError, shown
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.packages import folder_of
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.writing import write_files
from pkmodes.core.system.motors import springs_on_motors
from pkmodes.core.system.released import active_effects


def specification(robot: Robot, robot_file: str, definition: str = "") -> Any:
    """Return the derivation's input for a robot; a user-defined mechanism is registered with the derivation.

    - robot_file, definition: references to the robot file and to the mechanism's definition, as the generated files
      state them
    """
    stored_definition = definition_of(robot.mechanism)
    if stored_definition is not None:
        register_definition(stored_definition)
    add_effects(robot.mechanism_name, effects_of(robot.mechanism))
    parameters = {
        name: value.tolist() if hasattr(value, "tolist") else value
        for name, value in robot.parameters._asdict().items()
    }
    # All parameters of the declared effects, also those that the file does not give.
    effects = {
        f"{name}_{parameter.name}": robot.effects.get(f"{name}.{parameter.name}", 0.0)
        for name in dict.fromkeys(path.partition(".")[0] for path in robot.effects)
        for parameter in robot.mechanism.effects[name].parameters
    }
    return import_derivation("emit.specification").Specification(
        name=robot.name,
        mechanism=robot.mechanism_name,
        robot_file=robot_file,
        fields={**parameters, **effects},
        values=robot.declared,
        effects=active_effects(robot.mechanism, robot.effects),
        damping_ratio=robot.damping_ratio,
        definition=definition,
        springs=next(iter(springs_on_motors(robot.mechanism, robot.effects)), ""),
    )


def derive_robot_model(specification: Any) -> dict[str, str]:
    """Derive the model of one robot and return its texts by file name."""
    with as_pkmodes_errors():
        texts: dict[str, str] = import_derivation("emit.product").specialised(specification)
    return texts


@dataclass(frozen=True)
class _Folder:
    """A folder of generated code, its manifest before anything is derived, and other paths that may be in it."""

    path: Path
    manifest: dict[str, Any] | None
    allowed: tuple[Path, ...]

    @classmethod
    def checked(cls, path: Path, *allowed: Path) -> _Folder:
        """Check that generated files may be written there."""
        folder = cls(path, _read_manifest(path), allowed)
        check_place(path, allowed, folder.manifest)
        return folder

    def check_again(self, texts: Mapping[str, str]) -> None:
        """Refuse a folder that another process has changed meanwhile, unless it wrote the same."""
        manifest = _read_manifest(self.path)
        if manifest not in (self.manifest, json.loads(texts[MANIFEST])):
            problem = "another process has generated into the folder meanwhile"
            raise OutputError(problem, str(self.path), "choose another folder, or run the command again")
        check_place(self.path, self.allowed, manifest)
        for name in texts:
            check_no_link(self.path / name)

    def write(self, texts: Mapping[str, str]) -> list[Path]:
        """Write the generated files and remove those that a previous generation wrote under other names."""
        generated = import_derivation("emit.currency").carries_header
        stale = [] if self.manifest is None else stale_outputs(self.path, self.manifest, texts, generated)
        written = write_files(self.path, texts)
        for path in stale:
            path.unlink(missing_ok=True)
        return written


def generate(
    robot_file: Path, out: Path, mechanism: Path | None = None, effects: Sequence[Path] = ()
) -> list[Path]:
    """Generate the model of one robot and, given the definition of a mechanism or effects, the mechanism's code.

    - out: output folder; created if it does not exist
    - mechanism: a user-defined mechanism: either the Python file that defines it, whose code is written into the
      folder of its name in `out`, or a folder that was generated from such a file
    - effects: Python files of effects that the mechanism is to have beside the catalogue, and beside those that it
      has in the folder that is given: its code with them is written into the folder of its name in `out`

    Returns the files written: a NumPy module, a C source, its header, for a robot with effects the same without them,
    and a manifest.
    Raises RobotFileError if the robot file is invalid.
    Raises OutputError if the folder cannot be written, is not suitable for generated files, or holds the model of
    another robot.
    Raises MissingExtraError if SymPy or Jinja2 is not installed.
    Raises PkmodesError if the definition or an effect is invalid.
    """
    new_effects = [read_effect(file) for file in effects]
    if mechanism is not None and not mechanism.is_dir():
        definition = read_definition(mechanism)
        return _generate_both(robot_file, out, definition.name, definition, new_effects)
    given_mechanism = None if mechanism is None else registry.add_folder(mechanism)
    if new_effects:
        base_mechanism = given_mechanism or registry.mechanism(_mechanism_name(robot_file))
        all_effects = with_stored_effects(base_mechanism, new_effects)
        return _generate_both(
            robot_file, out, base_mechanism.name, definition_of(base_mechanism), all_effects
        )
    robot = read_robot(robot_file)
    folder = _Folder.checked(out, robot_file)
    mechanism_folder = folder_of(robot.mechanism.package)
    reference = relative_path(Path(mechanism_folder), out) if mechanism_folder else ""
    texts = _derive_texts(robot, robot_file, folder, reference)
    with folder_lock(out):
        folder.check_again(texts)
        return folder.write(texts)


def _mechanism_name(robot_file: Path) -> str:
    """Return the mechanism of a robot file, which may have effects that the mechanism does not have yet."""
    try:
        name = tomllib.loads(robot_file.read_text(encoding="utf-8-sig"))["mechanism"]
    except (OSError, ValueError, KeyError):
        name = None
    return (
        name if isinstance(name, str) and name in registry.names() else read_robot(robot_file).mechanism_name
    )


def _generate_both(
    robot_file: Path, out: Path, name: str, definition: Definition | None, effects: Sequence[Definition]
) -> list[Path]:
    """Generate the code of a mechanism and the model of a robot; write nothing unless both succeed."""
    package = out / name
    source_files = [source.file for source in (definition, *effects) if source is not None]
    robot_folder = _Folder.checked(out, robot_file, *source_files, package)
    check_no_link(package)
    mechanism_folder = _Folder.checked(package)
    check_mechanism(package, mechanism_folder.manifest, name)
    references = {relative_path(effect.file, package): effect for effect in effects}
    definition_reference = "" if definition is None else relative_path(definition.file, package)
    mechanism_texts = derive_mechanism(name, definition, definition_reference, references)
    with staged_mechanism(name, mechanism_texts):
        robot = read_robot(robot_file)
        if robot.mechanism_name != name:
            problem = f"the robot is a {robot.mechanism_name}, not a {name}"
            remedy = f'write mechanism = "{name}", or leave --mechanism out'
            raise PkmodesError(problem, f"{robot_file}: mechanism", remedy)
        # The mechanism's folder has its definition and its effects; a definition without effects is named directly.
        source = package if definition is None or effects else definition.file
        robot_texts = _derive_texts(robot, robot_file, robot_folder, relative_path(source, out))
    with folder_lock(out):
        check_no_link(package)
        mechanism_folder.check_again(mechanism_texts)
        robot_folder.check_again(robot_texts)
        written = [*mechanism_folder.write(mechanism_texts), *robot_folder.write(robot_texts)]
    registry.add_folder(package)
    return written


def _derive_texts(robot: Robot, robot_file: Path, folder: _Folder, definition: str) -> dict[str, str]:
    """Derive the model of a robot, for a folder that is free or already holds this robot's model."""
    reference = relative_path(robot_file, folder.path)
    if folder.manifest is not None:
        check_owner(folder.path, folder.manifest, reference, robot.name)
    return derive_robot_model(specification(robot, reference, definition))


def relative_path(source: Path, out: Path) -> str:
    """Return a path relative to the output folder, with forward slashes."""
    return Path(os.path.relpath(source.resolve(), out.resolve())).as_posix()


def _read_manifest(folder: Path) -> dict[str, Any] | None:
    """Return the manifest in a folder, None if there is none."""
    manifest_file = folder / MANIFEST
    try:
        manifest_file.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError) as error:  # not a valid folder name
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise OutputError(f"cannot write: {reason}", shown(str(folder)), "choose another place") from None
    try:
        content: dict[str, Any] = import_derivation("emit.currency").read_manifest(folder)
    except (ValueError, OSError) as error:
        raise OutputError(
            f"the folder holds a manifest that cannot be read: {error}",
            str(manifest_file),
            "choose another folder, or remove that file",
        ) from None
    return content
