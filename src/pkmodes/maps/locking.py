"""The folder of a map in progress: made, and kept from a second process."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pkmodes.base.errors import OutputError
from pkmodes.base.writing import refusal

LOCK = "lock"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Make a folder and keep a second process from writing into it.

    The system releases the lock of a process that was killed.  A folder in which nothing was begun is removed again.

    Raises
    ------
    OutputError
        If it cannot be made, or another process holds it.
    """
    from filelock import FileLock, Timeout

    lock = FileLock(folder / LOCK, blocking=False)
    try:
        folder.mkdir(exist_ok=True)
        lock.acquire()
    except FileExistsError:
        what = "expected a folder for the map in progress, found a file"
        raise OutputError(what, str(folder), "delete it, or choose another output") from None
    except Timeout:
        what, remedy = "another process is writing this map", "wait for it, or choose another output"
        raise OutputError(what, str(folder), remedy) from None
    except OSError as error:
        raise refusal(error, folder) from None
    try:
        yield
    finally:
        if folder.is_dir() and [path.name for path in folder.iterdir()] == [LOCK]:
            with suppress(OSError):
                (folder / LOCK).unlink()
                folder.rmdir()
        lock.release()
