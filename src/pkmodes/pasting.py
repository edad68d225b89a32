"""Commands that are printed so that a person can paste them where they are printed."""

from __future__ import annotations

import shlex
from pathlib import Path


def pasted(path: Path) -> str:
    """A path as one word of a shell command: relative where it is below the working directory, and quoted."""
    resolved, here = path.resolve(), Path.cwd()
    below = resolved != here and resolved.is_relative_to(here) and here != Path(here.anchor)
    text = str(resolved.relative_to(here) if below else resolved)
    return shlex.quote(f"./{text}" if text.startswith("-") else text)
