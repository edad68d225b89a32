"""A user-defined mechanism: a Python file outside this package with ``TITLE``, ``DIRECTIONS`` and ``declare(m)``.

Where the platform turns it has ``ROTATIONS`` as well.

Every mistake in it is reported as what, where (file and line) and what to do, never as a traceback: its author does
not know the code of the derivation.
"""

from __future__ import annotations

import keyword
import linecache
import re
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

from pkmodes_derive.reserved_words import C_KEYWORDS
from pkmodes_derive.vocabulary import AXES

#: Name of the copy of the file that is kept with the generated code.
FILE_NAME = "definition.py"


class DefinitionError(Exception):
    """A mistake in the definition of a mechanism: what is wrong, where, and what to do about it."""

    def __init__(self, what: str, where: str, remedy: str) -> None:
        super().__init__(what, where, remedy)
        self.what, self.where, self.remedy = what, where, remedy

    def __str__(self) -> str:
        return f"{self.what} ({self.where}); {self.remedy}"


def check_name(name: str, place: str) -> None:
    """Refuse a name that is not valid for a mechanism, a Python package and C functions."""
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name) or name in C_KEYWORDS:
        raise DefinitionError(
            f'"{name}" is not a valid name for a mechanism',
            place,
            "name the file with lower-case letters, digits and underscores, for example five_bar.py",
        )


def read(name: str, text: str, place: str) -> ModuleType:
    """Run the text of a definition and return its module.

    Parameters
    ----------
    name : str
        Name of the mechanism.
    place : str
        The file, for messages.

    Raises
    ------
    DefinitionError
        If it is not valid Python, raises an exception or lacks one of the three names.
    """
    module = run(name, text, place)
    title, directions = (getattr(module, attribute, None) for attribute in ("TITLE", "DIRECTIONS"))
    if not isinstance(title, str) or not title.strip():
        raise DefinitionError(
            "TITLE is missing or not a string", place, 'add a line such as TITLE = "two arms"'
        )
    if not isinstance(directions, list | tuple) or not directions or not _in_order(directions):
        raise DefinitionError(
            "DIRECTIONS is missing or does not list the directions in which the platform moves",
            place,
            'add a line such as DIRECTIONS = ("x", "y")',
        )
    _check_rotations(getattr(module, "ROTATIONS", ()), tuple(directions), place)
    if not callable(getattr(module, "declare", None)):
        raise DefinitionError("there is no function declare(m)", place, "add it: it declares the mechanism")
    return module


def run(name: str, text: str, place: str) -> ModuleType:
    """Run the text of a file and return its module; every exception becomes a `DefinitionError`."""
    module = ModuleType(name)
    module.__file__ = place
    # Messages and tracebacks show the text that was run, even if the file has changed since.
    linecache.cache[place] = (len(text), None, text.splitlines(keepends=True), place)
    with as_definition_errors(place, "fix that line"):
        exec(compile(text, place, "exec"), module.__dict__)
    return module


def _check_rotations(rotations: object, directions: tuple[object, ...], place: str) -> None:
    """Refuse axes of rotation that a platform with these directions cannot have."""
    if not isinstance(rotations, list | tuple) or not _in_order(rotations):
        raise DefinitionError(
            f"ROTATIONS does not list axes about which the platform turns, found {rotations!r}",
            place,
            'write ROTATIONS = ("z",) for a machine in a plane, or ("x", "y", "z")',
        )
    if len(rotations) == 2:
        raise DefinitionError(
            f"ROTATIONS has two axes, {' and '.join(rotations)}: together they also turn about the third",
            place,
            'write one axis, or all three: ROTATIONS = ("x", "y", "z")',
        )
    missing = [axis for axis in AXES if rotations and axis not in directions and tuple(rotations) != (axis,)]
    if missing:
        raise DefinitionError(
            f"the platform turns about {', '.join(rotations)}, but DIRECTIONS lacks {', '.join(missing)}",
            place,
            "list every direction in which a point of the platform moves when it turns",
        )


def _in_order(directions: list[object] | tuple[object, ...]) -> bool:
    return list(directions) == [axis for axis in AXES if axis in directions]


@contextmanager
def as_definition_errors(place: str, remedy: str, during: str = "") -> Iterator[None]:
    """Turn every exception into a `DefinitionError` that names the last line of the file involved."""
    try:
        yield
    except DefinitionError as error:
        where = f"{place}: {error.where}" if error.where else place
        raise DefinitionError(error.what, where, error.remedy) from None
    except SyntaxError as error:
        line = f":{error.lineno}" if error.lineno else ""
        raise DefinitionError(f"not valid Python: {error.msg}", f"{place}{line}", remedy) from None
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # the author's code may raise anything
        frames = traceback.extract_tb(error.__traceback__)
        lines = [f.lineno for f in frames if f.filename == place]
        text = " ".join(str(error).split())
        what = (
            text if isinstance(error, ValueError) and text else f"{type(error).__name__}: {text}".rstrip(": ")
        )
        if isinstance(error, RecursionError) and frames[-1].filename != place:
            what = "named values are defined in terms of each other"
        where = f"{place}:{lines[-1]}" if lines else place
        raise DefinitionError(what, f"{where}{during}", getattr(error, "remedy", remedy)) from None
