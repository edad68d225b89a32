"""A cache of libraries in which nothing is kept yet."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from pkmodes.core.compiled import build, loader


@pytest.fixture
def fresh(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Path]:
    """No library that was loaded, shipped or kept; the folder of the cache.  What is built here is built quickly."""
    monkeypatch.setattr(build, "FLAGS", ("-std=gnu11", "-O0", "-fPIC"))
    monkeypatch.setattr(build, "WIDTHS", {build.machine(): {2: ()}})
    cache = tmp_path / "cache"
    monkeypatch.setenv(loader.CACHE_VARIABLE, str(cache))
    monkeypatch.setattr(loader, "INSTALLED_LIBRARIES", tmp_path / "nothing")
    loader.load.cache_clear()
    yield cache
    loader.load.cache_clear()
