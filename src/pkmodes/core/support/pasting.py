"""Paths in printed commands, written so that the command can be pasted into a shell."""

from __future__ import annotations

import os
import shlex
from pathlib import Path


def shell_path(path: Path) -> str:
    """Return a path as one quoted word of a shell command, relative if it is below the working directory."""
    working_folder = Path.cwd()
    try:
        resolved = path.resolve()
    except RuntimeError:  # symbolic links that form a loop
        resolved = Path(os.path.abspath(path))  # noqa: PTH100 - Path.absolute keeps the dots
    is_inside = (
        resolved != working_folder
        and resolved.is_relative_to(working_folder)
        and working_folder != Path(working_folder.anchor)
    )
    text = str(resolved.relative_to(working_folder) if is_inside else resolved)
    return shlex.quote(f"./{text}" if text.startswith("-") else text)
