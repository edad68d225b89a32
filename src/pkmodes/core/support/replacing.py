"""The rule for files that exist where a result is written (docs/reference/command-line.md, "What is replaced").

A file that the caller names is replaced.  Where the program chooses the name, or what is there may have taken hours
or an editor, only a file known to be replaceable is replaced; anything else is refused, unless the caller asks to
overwrite it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from pkmodes.core.base.errors import OutputError

OVERWRITE_REMEDY = "choose another place, or replace what is there with --overwrite"


def check_replaced(
    files: Iterable[Path],
    where: str,
    overwrite: bool,
    replaceable: Callable[[Path], bool] = lambda _: False,
    *,
    what: str = "the file exists",
    remedy: str = OVERWRITE_REMEDY,
) -> None:
    """Refuse to replace files.

    - files: what will be written
    - where: the option or argument that names the place
    - overwrite: whether the caller asked for it
    - replaceable: returns whether a file that exists may be replaced without that
    - what, remedy: what is wrong with the others, and what to do

    Raises OutputError if one of them exists and may not be replaced.
    """
    if overwrite:
        return
    blocked = [path for path in files if path.exists() and not (path.is_file() and replaceable(path))]
    if blocked:
        suffix = f" and {len(blocked) - 1} more" if blocked[1:] else ""
        raise OutputError(f"{blocked[0]}{suffix}: {what}", where, remedy)


def contains_mark(mark: bytes) -> Callable[[Path], bool]:
    """Return a test whether a file holds a mark, by which a command recognises its own files."""

    def contains(path: Path) -> bool:
        try:
            return mark in path.read_bytes()
        except OSError:
            return False

    return contains
