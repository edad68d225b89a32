"""The bridge between runtime and derivation, and the definitions of a user's own mechanisms that it takes.

This is the only module that imports the derivation, and it does so when it is called: ``import pkmodes`` must
work, and fast, without SymPy.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

from pkmodes.errors import MissingExtraError, PkmodesError
from pkmodes.mechanism import Mechanism, meanwhile, supplied
from pkmodes.mechanism_packages import DEFINITION, GIVE
from pkmodes.writing import write_files

#: The extra `derive` of pyproject.toml: named here so that it can be installed without an index that has pkmodes.
REQUIREMENTS = ("jinja2>=3.1", "sympy==1.14.0")
LARGEST_FILE = 1_000_000


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


@dataclass(frozen=True)
class Definition:
    """The Python source of a user's own mechanism: its name, text and file."""

    name: str
    text: str
    file: Path


def read_definition(file: Path, name: str | None = None) -> Definition:
    """Read the definition of a mechanism; without a name that of the file counts.

    Raises
    ------
    PkmodesError
        If the file cannot be read.
    """
    remedy = "give a Python file with TITLE, DIRECTIONS and declare(m)"
    if file.exists() and not file.is_file():
        raise PkmodesError("cannot read the definition: it is no file", str(file), remedy)
    if name is None and file.suffix != ".py":
        raise PkmodesError("expected a Python file, or the folder of a mechanism", str(file), remedy)
    try:
        if file.stat().st_size > LARGEST_FILE:
            raise PkmodesError("cannot read the definition: it has more than 1 MB", str(file), remedy)
        text = file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        what = f"expected UTF-8 text, found byte {error.start} that is not"
        raise PkmodesError(what, str(file), "save the file as UTF-8") from None
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise PkmodesError(f"cannot read the definition: {reason}", str(file), remedy) from None
    return Definition(file.stem if name is None else name, text, file)


def define(definition: Definition) -> None:
    """Make a definition known to the derivation.

    Raises
    ------
    PkmodesError
        If anything in it is wrong, with its line.
    """
    with told():
        derivation("mechanisms").add(definition.name, definition.text, str(definition.file))


def definition_of(kind: Mechanism) -> Definition | None:
    """The definition that lies with the code of a mechanism, None for one that comes with pkmodes."""
    if kind.name in supplied():
        return None
    file = Path(str(files(kind.package))) / DEFINITION
    if not file.is_file():
        what = f"there is no {DEFINITION}, from which code of the mechanism {kind.name} is derived"
        raise PkmodesError(what, str(file.parent), GIVE)
    return read_definition(file, kind.name)


@contextmanager
def told() -> Iterator[None]:
    """Tell a mistake in a definition as any other."""
    mistake = derivation("definition").DefinitionError
    try:
        yield
    except mistake as error:
        raise PkmodesError(error.what, error.where, error.remedy) from None


def parametric(definition: Definition, reference: str) -> dict[str, str]:
    """Derive a user's own mechanism: the texts of its package.

    Parameters
    ----------
    definition : Definition
    reference : str
        Its file, relative to the folder of the package.

    Raises
    ------
    PkmodesError
        If anything in the definition is wrong.
    """
    define(definition)
    with told():
        texts: dict[str, str] = derivation("emit.product").parametric(definition.name, reference)
    return texts


@contextmanager
def staged(name: str, texts: dict[str, str]) -> Iterator[Mechanism]:
    """Know a mechanism by code that is not written to its place yet."""
    with TemporaryDirectory(prefix="pkmodes-") as place:
        write_files(Path(place) / name, texts)
        with meanwhile(Path(place) / name) as kind:
            yield kind
