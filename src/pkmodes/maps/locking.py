"""The folder of a map in progress: made, told from one of the user, and kept from a second process.

The lock is the first file in it, under a name that nothing else has.  A folder that has other files and no lock is
the user's: nothing is written into it, nothing removed.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from stat import S_ISDIR, S_ISREG

from pkmodes.core.base.errors import OutputError, shown
from pkmodes.support.writing import refusal

LOCK = "pkmodes-map.lock"
START_AGAIN = "delete this folder to start again, or choose another output"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Make a folder and keep a second process from writing into it.

    The system releases the lock of a process that was killed.  A folder in which nothing was begun is removed again.

    Raises
    ------
    OutputError
        If it cannot be made, is not that of a map in progress, or another process holds it.
    """
    from filelock import FileLock, Timeout

    lock = FileLock(folder / LOCK, blocking=False)
    try:
        if not folder.is_symlink():
            with suppress(FileExistsError):
                folder.mkdir()
        _check_own(folder)
        lock.acquire()
    except Timeout:
        what, remedy = "another process is writing this map", "wait for it, or choose another output"
        raise OutputError(what, str(folder), remedy) from None
    except OSError as error:
        raise refusal(error, folder) from None
    try:
        yield
    finally:
        with suppress(OSError):
            if [path.name for path in folder.iterdir()] == [LOCK]:
                (folder / LOCK).unlink()
                folder.rmdir()
        lock.release()


def _check_own(folder: Path) -> None:
    """Refuse what is not a folder of a map in progress; one that is empty may become one."""
    entries = sorted(path.name for path in folder.iterdir()) if folder.is_dir() else []
    found, remedy = "", "move or rename it, or choose another output"
    if folder.is_symlink():
        found, remedy = "a symbolic link", "remove it, or choose another output"
    elif not folder.is_dir():
        found = "a file"
    elif entries and LOCK not in entries:
        found = f"one with other files ({shown(entries[0])})"
    if found:
        what = f"expected a folder for the map in progress, found {found}"
        raise OutputError(what, str(folder), remedy)
    for place, folders, files in os.walk(folder):
        for name in (*folders, *files):
            with suppress(FileNotFoundError):  # another process, which the lock will tell, removes its own
                kind = (Path(place) / name).lstat().st_mode
                if not (S_ISREG(kind) or S_ISDIR(kind)):
                    what = f"expected files for the map in progress, found a link or device, {shown(name)}"
                    raise OutputError(what, str(folder), START_AGAIN)
