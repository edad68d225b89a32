"""The arrays of a map: in memory, or in a folder from which an interrupted run can be continued.

The folder holds one memory-mapped array per field, a record of the finished tasks, and the plan: what is computed.  A
task is recorded after its rows are stored, so a killed process loses only tasks under way.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib.format import open_memmap
from numpy.typing import NDArray

from pkmodes.errors import OutputError

Array = NDArray[Any]
PLAN, DONE, LOCK = "plan.json", "done", "lock"
SUFFIX = ".partial"


class InMemory:
    """Arrays in memory.

    Attributes
    ----------
    arrays : dict of str to ndarray, shape (rows, ...)
    done : ndarray of bool, shape (tasks,)
    """

    def __init__(self, rows: int, tasks: int, tails: Mapping[str, tuple[tuple[int, ...], str]]) -> None:
        self.arrays: dict[str, Array] = {
            name: np.empty((rows, *tail), dtype) for name, (tail, dtype) in tails.items()
        }
        self.done: Array = np.zeros(tasks, dtype=bool)


class OnDisk:
    """Arrays in a folder.

    Parameters
    ----------
    folder : Path
        Created, or continued if it holds the same plan.
    plan : dict
        What is computed, as JSON can hold it.
    rows, tasks : int
    tails : mapping of str to (tuple of int, str)
        Shape at one pose and type of each field.

    Attributes
    ----------
    arrays : dict of str to ndarray, shape (rows, ...)
    done : ndarray of bool, shape (tasks,)

    Raises
    ------
    OutputError
        If the folder cannot be written, holds another map, or is damaged.
    """

    def __init__(
        self,
        folder: Path,
        plan: dict[str, Any],
        rows: int,
        tasks: int,
        tails: Mapping[str, tuple[tuple[int, ...], str]],
    ) -> None:
        self.folder = folder
        shapes = {name: ((rows, *tail), dtype) for name, (tail, dtype) in tails.items()}
        shapes[DONE] = ((tasks,), "?")
        try:
            if (folder / PLAN).exists():
                self._compare(plan)
            else:
                folder.mkdir(exist_ok=True)
                for name, (shape, dtype) in shapes.items():
                    open_memmap(self._file(name), "w+", dtype, shape).flush()
                (folder / PLAN).write_text(json.dumps(plan, indent=1), encoding="utf-8")
            opened = {name: self._open(name, *shapes[name]) for name in shapes}
        except OSError as error:
            what = f"cannot write: {(error.strerror or str(error)).lower()}"
            raise OutputError(
                what, str(error.filename or folder), "choose another place or make room"
            ) from None
        self.done = opened.pop(DONE)
        self.arrays = opened

    def remove(self) -> None:
        """Remove the folder: the map is complete."""
        self.arrays, self.done = {}, np.zeros(0, dtype=bool)
        shutil.rmtree(self.folder)

    def _file(self, name: str) -> Path:
        return self.folder / f"{name}.npy"

    def _compare(self, plan: dict[str, Any]) -> None:
        try:
            found = json.loads((self.folder / PLAN).read_text(encoding="utf-8"))
        except ValueError:
            self._refuse("the plan of the interrupted map is damaged")
        other = [key for key in {**plan, **found} if plan.get(key) != found.get(key)]
        if other:
            self._refuse(f"this folder holds an interrupted map that differs in: {', '.join(other)}")

    def _open(self, name: str, shape: tuple[int, ...], dtype: str) -> Array:
        try:
            found = open_memmap(self._file(name), "r+")
        except (ValueError, EOFError, FileNotFoundError):
            self._refuse(f"the file {name}.npy of the interrupted map is truncated or missing")
        if found.shape != shape or found.dtype != np.dtype(dtype):
            self._refuse(f"the file {name}.npy of the interrupted map is damaged")
        return found

    def _refuse(self, what: str) -> Any:
        raise OutputError(
            what, str(self.folder), "delete this folder to start again, or choose another output"
        )


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Keep a second process from writing into the same folder, where the system has file locks.

    Raises
    ------
    OutputError
        If another process holds it.
    """
    try:
        import fcntl
    except ModuleNotFoundError:  # not on this system
        yield
        return
    try:
        folder.mkdir(exist_ok=True)
        handle = (folder / LOCK).open("w")
    except OSError as error:
        what = f"cannot write: {(error.strerror or str(error)).lower()}"
        raise OutputError(what, str(folder), "choose another place or make it writable") from None
    with handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            what, remedy = "another process is writing this map", "wait for it, or choose another output"
            raise OutputError(what, str(folder), remedy) from None
        yield
