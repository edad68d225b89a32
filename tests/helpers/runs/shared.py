"""What the workers of a run share: each thing is computed once, by the worker that needs it first."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from filelock import FileLock

T = TypeVar("T")


class Shared:
    """A folder of the run.

    The others wait while one computes; what fails is computed again by the next.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        folder.mkdir(exist_ok=True)

    def value(self, name: str, compute: Callable[[], T]) -> T:
        """Return what `compute` returns, which can be pickled."""

        def write(folder: Path) -> None:
            (folder / "value.pickle").write_bytes(pickle.dumps(compute()))

        result: T = pickle.loads((self.folder(name, write) / "value.pickle").read_bytes())
        return result

    def folder(self, name: str, fill: Callable[[Path], None]) -> Path:
        """Return a folder that `fill` has filled; tests only read it."""
        folder, done = self._folder / name, self._folder / f"{name}.done"
        with FileLock(self._folder / f"{name}.lock"):
            if not done.exists():
                folder.mkdir(exist_ok=True)
                fill(folder)
                done.touch()
        return folder
