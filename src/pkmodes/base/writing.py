"""Write results completely or not at all."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from pkmodes.base.errors import OutputError
from pkmodes.base.places import resolved

#: Failures after which the same place may be used once there is room.
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def write_files(folder: Path, texts: Mapping[str, str | bytes], *, follow: bool = False) -> list[Path]:
    """Write texts, or other contents, into a folder, all or none; existing files of those names are replaced.

    Every text is written to a temporary file next to its target and then moved.  Replaced files are kept until all
    texts are in place.  If anything fails, they are restored and the folders created for the texts are removed.

    Parameters
    ----------
    follow : bool
        Whether a name in the folder may be a symbolic link that leads out of it: only where the user named the file.

    Raises
    ------
    OutputError
        If the folder or a file cannot be written, or a link leads out of the folder.
    """
    staged: list[tuple[Path, Path]] = []
    moved: list[tuple[Path | None, Path]] = []
    writing = folder
    made = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            writing = folder / name
            target = _real(writing)
            if not follow and target != writing and not target.is_relative_to(resolved(folder)):
                what = f"{name} is a symbolic link that leads out of the folder"
                raise OutputError(what, str(folder), "remove the link, or choose another folder")
            staged.append((_stage(target, text), target))
        for temporary, target in staged:
            backup = _set_aside(target)
            moved.append((backup, target))
            temporary.replace(target)
    except BaseException as error:
        for backup, target in reversed(moved):
            if backup is None:
                target.unlink(missing_ok=True)
            else:
                backup.replace(target)
        for temporary, _ in staged:
            temporary.unlink(missing_ok=True)
        for place in made:
            with suppress(OSError):  # it was never created, or is already in use
                place.rmdir()
        if not isinstance(error, OSError):
            raise
        raise refusal(error, writing) from None
    for backup, _ in moved:
        if backup is not None:
            backup.unlink(missing_ok=True)
    return [folder / name for name in texts]


def write_file(path: Path, text: str | bytes) -> None:
    """Write one text, or another content, completely or not at all; a target such as a pipe is written to directly.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    if path.exists() and not path.is_file() and not path.is_dir():
        try:
            path.write_bytes(text.encode("utf-8") if isinstance(text, str) else text)
        except OSError as error:
            raise refusal(error, path) from None
        return
    write_files(path.parent, {path.name: text}, follow=True)


def refusal(error: OSError, place: Path) -> OutputError:
    """Return the error for a file that the system refuses to write.

    Parameters
    ----------
    place : Path
        The file as the user named it; the error itself names a temporary file next to it, or none.
    """
    reason = (error.strerror or "it cannot be written").lower()
    need = "make room" if error.errno in FULL else "make it writable"
    return OutputError(f"cannot write: {reason}", str(place), f"choose another place or {need}")


def _real(path: Path) -> Path:
    """Return the target of a symbolic link, so that the link itself is kept."""
    target = resolved(path) if path.is_symlink() else path
    if target.is_dir():
        raise IsADirectoryError(None, "a folder of that name exists", str(target))
    return target


def _stage(target: Path, text: str | bytes) -> Path:
    handle, name = tempfile.mkstemp(prefix=f".{target.name[:100]}.", dir=target.parent)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(text.encode("utf-8") if isinstance(text, str) else text)
        temporary.chmod(_mode(target))
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return temporary


def _set_aside(target: Path) -> Path | None:
    """Move an existing file out of the way and return its new path; None if there is no file."""
    if not target.exists():
        return None
    handle, name = tempfile.mkstemp(prefix=f".{target.name[:100]}.", dir=target.parent)
    os.close(handle)
    try:
        target.replace(name)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return Path(name)


def _mode(target: Path) -> int:
    """Return the permissions of the existing file, or those of an ordinary new file (temporary files are private)."""
    if target.exists():
        return target.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask
