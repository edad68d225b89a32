"""A folder with a user's mechanism, in which commands run."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from pkmodes.core.mechanism import registry as known
from pkmodes_derive import mechanisms


@contextmanager
def inside(folder: Path) -> Iterator[None]:
    """Run commands in a folder, and forget the mechanisms and effects that they add."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(known, "_package_by_name", {})
        patch.setenv("COLUMNS", "110")
        patch.chdir(folder)
        try:
            yield
        finally:
            for name in [*mechanisms._own_effects]:
                mechanisms.add_effects(name, [])
