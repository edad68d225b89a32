"""Paths in printed commands, written so that the command can be pasted into a shell."""

from __future__ import annotations

import os
import shlex
from pathlib import Path


def pasted(path: Path) -> str:
    """Return a path as one quoted word of a shell command, relative if it is below the working directory."""
    here = Path.cwd()
    try:
        resolved = path.resolve()
    except RuntimeError:  # symbolic links that form a loop
        resolved = Path(os.path.abspath(path))  # noqa: PTH100 - Path.absolute keeps the dots
    below = resolved != here and resolved.is_relative_to(here) and here != Path(here.anchor)
    text = str(resolved.relative_to(here) if below else resolved)
    return shlex.quote(f"./{text}" if text.startswith("-") else text)
