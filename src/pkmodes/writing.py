"""Write results whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from pkmodes.errors import OutputError


def write_files(folder: Path, texts: Mapping[str, str]) -> list[Path]:
    """Write texts into a folder, all or none; existing files of those names are replaced.

    Every text is first written beside its place and then moved there, so that a full disk or a missing
    permission leaves what was there before.

    Raises
    ------
    OutputError
        If the folder or a file cannot be written.
    """
    staged: list[tuple[str, Path]] = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            target = folder / name
            if target.is_dir():
                raise IsADirectoryError(None, "a folder of that name is there", str(target))
            handle, temporary = tempfile.mkstemp(prefix=f".{name}.", dir=folder)
            staged.append((temporary, target))
            with os.fdopen(handle, "wb") as file:
                file.write(text.encode("utf-8"))
            _usual_permissions(temporary)
        for temporary, target in staged:
            Path(temporary).replace(target)
    except OSError as error:
        for temporary, _ in staged:
            Path(temporary).unlink(missing_ok=True)
        reason = (error.strerror or "it cannot be written").lower()
        where = str(error.filename) if error.filename and not staged else str(folder)
        raise OutputError(f"cannot write: {reason}", where, "choose another place or free it") from None
    return [target for _, target in staged]


def write_file(path: Path, text: str) -> None:
    """Write one text, whole or not at all.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    write_files(path.parent, {path.name: text})


def _usual_permissions(path: str) -> None:
    """Temporary files are private; results get the permissions of an ordinary new file."""
    mask = os.umask(0)
    os.umask(mask)
    Path(path).chmod(0o666 & ~mask)
