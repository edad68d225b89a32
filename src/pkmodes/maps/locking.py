"""The folder of a map in progress: made, and kept from a second process."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pkmodes.errors import OutputError

LOCK = "lock"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Make a folder and keep a second process from writing into it, where the system has file locks.

    A folder in which nothing was begun is removed again.

    Raises
    ------
    OutputError
        If it cannot be made, or another process holds it.
    """
    try:
        folder.mkdir(exist_ok=True)
        handle = (folder / LOCK).open("w")
    except OSError as error:
        raise cannot_write(error, folder) from None
    with handle:
        try:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except ModuleNotFoundError:  # not on this system
            pass
        except OSError:
            what, remedy = "another process is writing this map", "wait for it, or choose another output"
            raise OutputError(what, str(folder), remedy) from None
        try:
            yield
        finally:
            if folder.is_dir() and [path.name for path in folder.iterdir()] == [LOCK]:
                with suppress(OSError):
                    (folder / LOCK).unlink()
                    folder.rmdir()


def cannot_write(error: OSError, place: Path) -> OutputError:
    """Return the error of a file that cannot be written."""
    what = f"cannot write: {(error.strerror or str(error)).lower()}"
    where = error.filename if isinstance(error.filename, str) else str(place)
    return OutputError(what, where, "make room or make it writable, or choose another place")
