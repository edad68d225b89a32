"""Write results completely or not at all."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import tempfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from pkmodes.core.base.errors import OutputError
from pkmodes.core.support.places import resolve_path

#: Failures after which the same place may be used once there is room.
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def write_files(folder: Path, texts: Mapping[str, str | bytes]) -> list[Path]:
    """Write texts, or other contents, into a folder, all or none; existing files of those names are replaced.

    A name may have folders in it, which are created.

    Raises OutputError if the folder or a file cannot be written, or a link leads out of the folder.
    """
    files = {folder / name: text for name, text in texts.items()}
    for name, path in zip(texts, files, strict=True):
        if not resolve_path(path).is_relative_to(resolve_path(folder)):
            link = "is" if path.is_symlink() else "is below"
            problem = f"{name} {link} a symbolic link that leads out of the folder"
            raise OutputError(problem, str(folder), "remove the link, or choose another folder")
    _write(files, folder)
    return list(files)


def write_file(path: Path, text: str | bytes) -> None:
    """Write one text, or another content, completely or not at all; a target such as a pipe is written to directly.

    Raises OutputError if it cannot be written.
    """
    write_all({path: text})


def write_all(contents: Mapping[Path, str | bytes]) -> None:
    """Write files that the user named, in any folders, all or none; existing ones are replaced.

    What is no ordinary file, such as a pipe, is written to directly, when the others are ready.

    Raises OutputError if one of them cannot be written.
    """
    direct = {path for path in contents if path.exists() and not path.is_file() and not path.is_dir()}

    def write_directly() -> None:
        for path in contents:
            if path in direct:
                try:
                    path.write_bytes(_encoded(contents[path]))
                except OSError as error:
                    raise write_error(error, path) from None

    files = {path: content for path, content in contents.items() if path not in direct}
    try:
        _write(files, *(path.parent for path in files), ready=write_directly)
    except OutputError as error:
        if len(contents) == 1:
            raise
        problem = f"{error.what}; none of the {len(contents)} files is written"
        raise OutputError(problem, error.where, error.remedy) from None


def _write(
    contents: Mapping[Path, str | bytes], *folders: Path, ready: Callable[[], object] = lambda: None
) -> None:
    """Write files, all or none.

    Every content is written to a temporary file next to its target, which then replaces it in one step: at any moment
    a reader, also after the process was killed, finds either the old file or the new one, complete.  Where there are
    several, the old ones are kept under other names until all contents are in place.  If anything fails, they are
    restored and the folders created for them are removed.

    - folders: created even if nothing is written there; an error names the first one until a file is being written
    - ready: called when all temporary files are written, and none is in its place yet
    """
    staged: list[tuple[Path, Path]] = []
    backups: dict[Path, Path] = {}
    current = folders[0] if folders else Path()
    parents = (*folders, *(path.parent for path in contents))
    ancestors = {place for folder in parents for place in (folder, *folder.parents)}
    created = sorted(
        (folder for folder in ancestors if not folder.exists()), key=lambda folder: -len(folder.parts)
    )
    try:
        for folder in folders:
            folder.mkdir(parents=True, exist_ok=True)
        for path, content in contents.items():
            current = path
            path.parent.mkdir(parents=True, exist_ok=True)
            target = _link_target(path)
            staged.append((_write_temporary(target, content), target))
        ready()
        if len(staged) > 1:  # a single one is in place, or it is not
            for temporary, target in staged:
                backups[temporary] = target.with_name(_hidden_prefix(target) + secrets.token_hex(8))
                _back_up(target, backups[temporary])
        for temporary, target in staged:
            temporary.replace(target)
    except BaseException as error:
        for temporary, target in reversed(staged):
            _undo(temporary, target, backups.get(temporary))
        for folder in created:
            with suppress(OSError):  # it was never created, or is already in use
                folder.rmdir()
        if not isinstance(error, OSError):
            raise
        raise write_error(error, current) from None
    for backup in backups.values():
        backup.unlink(missing_ok=True)


def write_error(error: OSError, path: Path) -> OutputError:
    """Return the error for a file that the system refuses to write.

    - path: the file as the user named it; the error itself names a temporary file next to it, or none
    """
    reason = (error.strerror or "it cannot be written").lower()
    need = "make room" if error.errno in NO_ROOM else "make it writable"
    return OutputError(f"cannot write: {reason}", str(path), f"choose another place or {need}")


def _link_target(path: Path) -> Path:
    """Return the target of a symbolic link, so that the link itself is kept."""
    target = resolve_path(path) if path.is_symlink() else path
    if target.is_dir():
        raise IsADirectoryError(None, "a folder of that name exists", str(target))
    return target


def _write_temporary(target: Path, text: str | bytes) -> Path:
    descriptor, name = tempfile.mkstemp(prefix=_hidden_prefix(target), dir=target.parent)
    temporary = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(_encoded(text))
        if target.exists():
            permissions = target.stat().st_mode & 0o777
        else:  # those of an ordinary new file: temporary files are private
            mask = os.umask(0)
            os.umask(mask)
            permissions = 0o666 & ~mask
        temporary.chmod(permissions)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return temporary


def _encoded(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


def _back_up(target: Path, backup: Path) -> None:
    """Give an existing file a second name; a copy where the file system, or the owner of the file, forbids that."""
    if not target.exists():
        return
    try:
        backup.hardlink_to(target)
    except OSError:
        shutil.copy2(target, backup)


def _undo(temporary: Path, target: Path, backup: Path | None) -> None:
    """Restore one of several targets, if its text had replaced it; a single one that is in place stays."""
    if temporary.exists():
        temporary.unlink()
    elif backup is not None and backup.exists():
        backup.replace(target)
    elif backup is not None:  # there was no file
        target.unlink(missing_ok=True)
    if backup is not None:
        backup.unlink(missing_ok=True)


def _hidden_prefix(target: Path) -> str:
    """Return how names next to a file begin: short, because a file system limits the bytes of a name."""
    return f".{target.name[:40]}."
