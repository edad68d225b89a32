"""One process at a time writes into the folder of a product."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pkmodes.core.base.errors import OutputError
from pkmodes.support.writing import refusal

#: Hidden, and removed at the end.
LOCK = ".pkmodes-generate.lock"
#: Seconds for which another process may write.
PATIENCE = 60


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Make a folder, and keep other processes from generating into it; what stays empty is removed again.

    Raises
    ------
    OutputError
        If the folder cannot be made or written, or another process does not finish.
    """
    from filelock import FileLock, Timeout

    made = [place for place in (folder, *folder.parents) if not place.exists()]
    lock = FileLock(folder / LOCK, timeout=PATIENCE)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except Timeout:
        what = f"another process has been generating into the folder for {PATIENCE} s"
        raise OutputError(what, str(folder), "end it, or choose another folder") from None
    except OSError as error:
        raise refusal(error, folder) from None
    except NotImplementedError:  # a file system without locks
        pass
    try:
        yield
    finally:
        with suppress(OSError):
            (folder / LOCK).unlink()
        lock.release()
        for place in made:
            with suppress(OSError):  # it is in use
                place.rmdir()
