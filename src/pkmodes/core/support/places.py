"""Where a path leads, through symbolic links that may form a loop."""

from __future__ import annotations

import errno
from pathlib import Path

from pkmodes.core.base.errors import OutputError, shown


def resolve_path(path: Path, option: str = "") -> Path:
    """Return the absolute path without symbolic links; it need not exist.

    - option: the option that names it, for messages

    Raises OutputError if its symbolic links form a loop.
    """
    try:
        path.stat()
    except OSError as error:
        if error.errno == errno.ELOOP:
            where = f"{option} {shown(str(path))}".lstrip()
            problem = "expected a file or folder, found symbolic links that lead back to themselves"
            raise OutputError(problem, where, "remove the link, or choose another place") from None
    return path.resolve()
