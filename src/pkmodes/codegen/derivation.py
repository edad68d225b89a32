"""Interface from the runtime to the derivation, including definitions of user-defined mechanisms.

This is the only module that imports the derivation, and it does so on demand: ``import pkmodes`` must be fast and
must work without SymPy.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

from pkmodes.core.base.errors import MissingExtraError, PkmodesError
from pkmodes.core.mechanism.packages import DEFINITION_FILE, FOLDER_REMEDY, effect_files
from pkmodes.core.mechanism.registry import Mechanism, supplied_names, temporarily_registered
from pkmodes.core.support.writing import write_files

#: The extra `derive` of pyproject.toml, repeated here so that it can be installed without a pkmodes index entry.
REQUIREMENTS = ("jinja2>=3.1", "sympy==1.14.0")
#: Maximum size of a definition or effect [bytes].
MAX_FILE_SIZE = 1_000_000


def import_derivation(name: str) -> ModuleType:
    """Import a module of the derivation.

    Raises MissingExtraError if SymPy or Jinja2 is not installed.
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


@dataclass(frozen=True)
class Definition:
    """The Python source of a user-defined mechanism or effect: its name, text and file."""

    name: str
    text: str
    file: Path


def read_definition(file: Path, name: str | None = None) -> Definition:
    """Read the definition of a mechanism; the name defaults to that of the file.

    Raises PkmodesError if the file cannot be read.
    """
    remedy = "give a Python file with TITLE, DIRECTIONS and declare(m)"
    if name is None and file.suffix != ".py" and (file.is_file() or not file.exists()):
        raise PkmodesError("expected a Python file, or the folder of a mechanism", str(file), remedy)
    text = python_text(file, "definition", remedy)
    return Definition(file.stem if name is None else name, text, file)


def read_effect(file: Path) -> Definition:
    """Read the file of an effect.

    Raises PkmodesError if it cannot be read.
    """
    remedy = "give a Python file with EFFECT, as pkmodes diagnose --save-effect writes it"
    return Definition(file.stem, python_text(file, "effect", remedy), file)


def python_text(file: Path, noun: str, remedy: str) -> str:
    """Read the text of a definition or effect, which the messages call by that noun.

    Raises PkmodesError if the file cannot be read.
    """
    if file.exists() and not file.is_file():
        raise PkmodesError(f"cannot read the {noun}: it is not a file", str(file), remedy)
    try:
        if file.stat().st_size > MAX_FILE_SIZE:
            raise PkmodesError(f"cannot read the {noun}: it is larger than 1 MB", str(file), remedy)
        return file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        problem = f"expected UTF-8 text, found an invalid byte at offset {error.start}"
        raise PkmodesError(problem, str(file), "save the file as UTF-8") from None
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise PkmodesError(f"cannot read the {noun}: {reason}", str(file), remedy) from None


def register_definition(definition: Definition) -> None:
    """Register a definition with the derivation.

    Raises PkmodesError if the definition is invalid; the message gives the line.
    """
    with as_pkmodes_errors():
        import_derivation("mechanisms").add(definition.name, definition.text, str(definition.file))


def definition_of(mechanism: Mechanism) -> Definition | None:
    """Return the definition stored with a mechanism's code, None for a mechanism that comes with pkmodes."""
    if mechanism.name in supplied_names():
        return None
    file = Path(str(files(mechanism.package))) / DEFINITION_FILE
    if not file.is_file():
        problem = (
            f"expected {DEFINITION_FILE}, from which the mechanism {mechanism.name} is derived, "
            "found no such file"
        )
        raise PkmodesError(problem, str(file.parent), FOLDER_REMEDY)
    return read_definition(file, mechanism.name)


@contextmanager
def as_pkmodes_errors() -> Iterator[None]:
    """Convert errors of a definition to `PkmodesError`."""
    definition_error = import_derivation("definition").DefinitionError
    try:
        yield
    except definition_error as error:
        raise PkmodesError(error.what, error.where, error.remedy) from None


def add_effects(name: str, files: Sequence[Definition]) -> None:
    """Set the user's effects of a mechanism in the derivation: these and no others.

    Raises PkmodesError if one is invalid; the message gives the line.
    """
    with as_pkmodes_errors():
        import_derivation("mechanisms").add_effects(
            name, [(effect.text, str(effect.file)) for effect in files]
        )


def effects_of(mechanism: Mechanism) -> list[Definition]:
    """Return the user's effects that are stored with a mechanism's code."""
    return [read_effect(file) for file in effect_files(mechanism.package, mechanism.effects)]


def with_stored_effects(mechanism: Mechanism, effects: Sequence[Definition]) -> list[Definition]:
    """Return the user's effects after those stored with a mechanism's code, without stored ones of the same name."""
    effect_file = import_derivation("effect_file")
    with as_pkmodes_errors():
        replaced = {
            effect_file.file_name(effect_file.read(effect.text, str(effect.file))) for effect in effects
        }
    return [*(stored for stored in effects_of(mechanism) if stored.file.name not in replaced), *effects]


def derive_mechanism(
    name: str,
    definition: Definition | None,
    reference: str = "",
    effects: Mapping[str, Definition] | None = None,
) -> dict[str, str]:
    """Derive a mechanism with a user's definition or effects: texts of its package by file name.

    - definition: None for a mechanism of pkmodes
    - reference: path of its file relative to the package folder
    - effects: files of effects by their paths relative to the package folder

    Raises PkmodesError if the definition, or an effect, is invalid.
    """
    files = dict(sorted((effects or {}).items()))
    if definition is not None:
        register_definition(definition)
    add_effects(name, list(files.values()))
    with as_pkmodes_errors():
        texts: dict[str, str] = import_derivation("emit.product").parametric(name, reference, tuple(files))
    return texts


@contextmanager
def staged_mechanism(name: str, texts: dict[str, str]) -> Iterator[Mechanism]:
    """Register a mechanism from code that has not been written to its folder yet."""
    with TemporaryDirectory(prefix="pkmodes-") as folder:
        write_files(Path(folder) / name, texts)
        with temporarily_registered(Path(folder) / name) as mechanism:
            yield mechanism
