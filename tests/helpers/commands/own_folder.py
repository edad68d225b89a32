"""A folder with a user's mechanism, in which commands run."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from pkmodes.core.mechanism import registry as known


@contextmanager
def inside(folder: Path) -> Iterator[None]:
    """Run commands in a folder, and forget the mechanisms that they add."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(known, "_added", {})
        patch.setenv("COLUMNS", "110")
        patch.chdir(folder)
        yield
