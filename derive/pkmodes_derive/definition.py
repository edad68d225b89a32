"""A user's own mechanism: a Python file with ``TITLE``, ``DIRECTIONS`` and ``declare(m)``, outside this package.

Whatever is wrong with it is told as what, where (file and line) and what to do, never as a traceback: who writes a
mechanism has not written the derivation.
"""

from __future__ import annotations

import keyword
import linecache
import re
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

from pkmodes_derive.emit.specification import C_KEYWORDS
from pkmodes_derive.vocabulary import AXES

#: The copy of the file that lies with the code that was derived from it.
FILE_NAME = "definition.py"


class DefinitionError(Exception):
    """A mistake in the definition of a mechanism: what is wrong, where, and what to do about it."""

    def __init__(self, what: str, where: str, remedy: str) -> None:
        super().__init__(what, where, remedy)
        self.what, self.where, self.remedy = what, where, remedy

    def __str__(self) -> str:
        return f"{self.what} ({self.where}); {self.remedy}"


def check_name(name: str, place: str) -> None:
    """Refuse a name that cannot be that of a mechanism, a Python package and C functions."""
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name) or name in C_KEYWORDS:
        raise DefinitionError(
            f'"{name}" cannot be the name of a mechanism',
            place,
            "name the file with small letters, digits and underscores, such as five_bar.py",
        )


def read(name: str, text: str, place: str) -> ModuleType:
    """Run the text of a definition and return its module.

    Parameters
    ----------
    name : str
        Of the mechanism.
    text : str
    place : str
        The file, for messages.

    Raises
    ------
    DefinitionError
        If it is not Python, raises, or lacks one of the three names.
    """
    module = ModuleType(name)
    module.__file__ = place
    # Messages and tracebacks show lines of the text that was run, whatever the file says by then.
    linecache.cache[place] = (len(text), None, text.splitlines(keepends=True), place)
    with told(place, "mend that line"):
        exec(compile(text, place, "exec"), module.__dict__)
    title, directions = (getattr(module, attribute, None) for attribute in ("TITLE", "DIRECTIONS"))
    if not isinstance(title, str) or not title.strip():
        raise DefinitionError("TITLE is missing, or no text", place, 'add a line such as TITLE = "two arms"')
    if not isinstance(directions, list | tuple) or not directions or not _in_order(directions):
        raise DefinitionError(
            "DIRECTIONS is missing, or does not say in which directions the platform moves",
            place,
            'add a line such as DIRECTIONS = ("x", "y")',
        )
    if not callable(getattr(module, "declare", None)):
        raise DefinitionError("there is no function declare(m)", place, "add it: it declares the mechanism")
    return module


def _in_order(directions: list[object] | tuple[object, ...]) -> bool:
    return list(directions) == [axis for axis in AXES if axis in directions]


@contextmanager
def told(place: str, remedy: str, during: str = "") -> Iterator[None]:
    """Tell whatever is raised with the last line of the file that led to it."""
    try:
        yield
    except DefinitionError as error:
        where = f"{place}: {error.where}" if error.where else place
        raise DefinitionError(error.what, where, error.remedy) from None
    except SyntaxError as error:
        raise DefinitionError(f"not valid Python: {error.msg}", f"{place}:{error.lineno}", remedy) from None
    except (Exception, SystemExit) as error:
        lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if f.filename == place]
        what = str(error) if isinstance(error, ValueError) else f"{type(error).__name__}: {error}"
        if isinstance(error, RecursionError):
            what = "named values are defined by one another"
        where = f"{place}:{lines[-1]}" if lines else place
        raise DefinitionError(what, f"{where}{during}", getattr(error, "remedy", remedy)) from None
