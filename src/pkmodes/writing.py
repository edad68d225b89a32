"""Write results completely or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from pkmodes.errors import OutputError


def write_files(folder: Path, texts: Mapping[str, str | bytes]) -> list[Path]:
    """Write texts, or other contents, into a folder, all or none; existing files of those names are replaced.

    Every text is written to a temporary file next to its target and then moved.  Replaced files are kept until all
    texts are in place.  If anything fails, they are restored and the folders created for the texts are removed.

    Raises
    ------
    OutputError
        If the folder or a file cannot be written.
    """
    staged: list[tuple[Path, Path]] = []
    moved: list[tuple[Path | None, Path]] = []
    made = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            target = _real(folder / name)
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
        reason = (error.strerror or "it cannot be written").lower()
        where = str(error.filename) if isinstance(error.filename, str) else str(folder)
        raise OutputError(
            f"cannot write: {reason}", where, "choose another place or make it writable"
        ) from None
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
            reason = (error.strerror or "it cannot be written").lower()
            raise OutputError(f"cannot write: {reason}", str(path), "choose another place") from None
        return
    write_files(path.parent, {path.name: text})


def _real(path: Path) -> Path:
    """Return the target of a symbolic link, so that the link itself is kept."""
    target = path.resolve() if path.is_symlink() else path
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
