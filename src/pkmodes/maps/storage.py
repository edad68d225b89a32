"""The arrays of a map: in memory, or in a folder from which an interrupted run can be continued.

The folder holds one array per field, a record of the finished tasks, and the plan: what is computed.  A task is
recorded after its rows are stored, so a killed process loses only tasks in progress.  Rows are written to and read
from the files directly: a memory-mapped file would end the process with a signal when the disk is full, and its pages
would count as memory of the process.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Mapping
from contextlib import suppress
from math import prod
from pathlib import Path
from threading import Lock
from typing import Any, BinaryIO

import numpy as np
from numpy.lib.format import open_memmap
from numpy.typing import NDArray

from pkmodes.base.errors import OutputError
from pkmodes.base.writing import refusal

Array = NDArray[Any]
#: Shape at one pose, and type, of each field.
Tails = Mapping[str, tuple[tuple[int, ...], str]]
PLAN, DONE = "plan.json", "done"
SUFFIX = ".partial"


class Stored:
    """An array in a file, of which parts are read on demand."""

    def __init__(self, file: Path, shape: tuple[int, ...]) -> None:
        self.file, self.shape, self.ndim = file, shape, len(shape)
        self.dtype = np.load(file, mmap_mode="r").dtype

    def __getitem__(self, key: Any) -> Array:
        return np.array(np.load(self.file, mmap_mode="r").reshape(self.shape)[key])

    def __len__(self) -> int:
        return self.shape[0]

    def reshape(self, *shape: int) -> Stored:
        """Return the same array with another shape."""
        return Stored(self.file, shape)


class InMemory:
    """Arrays in memory.

    Attributes
    ----------
    arrays : dict of str to ndarray, shape (rows, ...)
    done : ndarray of bool, shape (tasks,)
    """

    def __init__(self, rows: int, tasks: int, tails: Tails) -> None:
        self.arrays: dict[str, Array] = {
            name: np.empty((rows, *tail), dtype) for name, (tail, dtype) in tails.items()
        }
        self.done: Array = np.zeros(tasks, dtype=bool)

    def put(self, first: int, values: Mapping[str, Array]) -> None:
        """Store values of consecutive rows, from the first one on; several threads may store different rows."""
        for name, array in self.arrays.items():
            array[first : first + len(values[name])] = values[name]

    def finish(self, number: int) -> None:
        """Record that the rows of a task are stored."""
        self.done[number] = True

    def remove(self) -> None:
        """Forget the arrays."""
        self.arrays = {}


class OnDisk:
    """Arrays in a folder.

    Parameters
    ----------
    folder : Path
        Exists; continued if it holds the same plan.
    plan : dict
        What is computed, as JSON can hold it.

    Attributes
    ----------
    arrays : dict of str to Stored, shape (rows, ...)
    done : ndarray of bool, shape (tasks,)
        When it was opened, and since.

    Raises
    ------
    OutputError
        If the folder cannot be written, holds another map, or is damaged.
    """

    def __init__(self, folder: Path, plan: dict[str, Any], rows: int, tasks: int, tails: Tails) -> None:
        self.folder = folder
        shapes = {name: ((rows, *tail), dtype) for name, (tail, dtype) in tails.items()}
        shapes[DONE] = ((tasks,), "?")
        self._handles: dict[str, BinaryIO] = {}
        self._starts: dict[str, int] = {}
        self._writing = Lock()
        try:
            if (folder / PLAN).exists():
                self._compare(plan)
            else:
                self._begin(plan, shapes)
            for name, (shape, dtype) in shapes.items():
                self._open(name, shape, dtype)
            self.done: Array = np.load(self._file(DONE))
            self.arrays = {name: Stored(self._file(name), shapes[name][0]) for name in tails}
        except OSError as error:
            self.close()
            raise refusal(error, folder) from None
        except BaseException:
            self.close()
            raise

    def put(self, first: int, values: Mapping[str, Array]) -> None:
        """Store values of consecutive rows, from the first one on; several threads may store different rows.

        Raises
        ------
        OutputError
            If they cannot be written.
        """
        for name in self.arrays:
            array = np.ascontiguousarray(values[name])
            size = array.itemsize * prod(array.shape[1:])
            self._write(name, first * size, array.reshape(-1).view(np.uint8))

    def finish(self, number: int) -> None:
        """Record that the rows of a task are stored."""
        self._write(DONE, number, np.ones(1, dtype=np.uint8))
        self.done[number] = True

    def close(self) -> None:
        """Close the files; what is stored can still be read."""
        for handle in self._handles.values():
            with suppress(OSError):  # every write was flushed
                handle.close()
        self._handles = {}

    def remove(self) -> None:
        """Remove the folder: the map is complete, or there is nothing to continue."""
        self.close()
        shutil.rmtree(self.folder)

    def _begin(self, plan: dict[str, Any], shapes: Tails) -> None:
        """Make the arrays, then the plan: a folder without a plan is begun anew."""
        try:
            for name, (shape, dtype) in shapes.items():
                open_memmap(self._file(name), "w+", dtype, shape).flush()
                _reserve(self._file(name))
        except BaseException:  # a full disk should not stay full
            for name in shapes:
                self._file(name).unlink(missing_ok=True)
            raise
        temporary = self.folder / f"{PLAN}.new"
        temporary.write_text(json.dumps(plan, indent=1), encoding="utf-8")
        temporary.replace(self.folder / PLAN)

    def _file(self, name: str) -> Path:
        return self.folder / f"{name}.npy"

    def _compare(self, plan: dict[str, Any]) -> None:
        try:
            interrupted = json.loads((self.folder / PLAN).read_text(encoding="utf-8"))
        except ValueError:
            interrupted = None
        if not isinstance(interrupted, dict):
            self._refuse("the plan of the interrupted map is damaged")
        other = [key for key in {**plan, **interrupted} if plan.get(key) != interrupted.get(key)]
        if other:
            self._refuse(f"this folder holds an interrupted map that differs in: {', '.join(other)}")

    def _open(self, name: str, shape: tuple[int, ...], dtype: str) -> None:
        file = self._file(name)
        try:
            array = np.load(file, mmap_mode="r")
        except (ValueError, EOFError, FileNotFoundError):
            self._refuse(f"the file {file.name} of the interrupted map is truncated or missing")
        if array.shape != shape or array.dtype != np.dtype(dtype):
            self._refuse(f"the file {file.name} of the interrupted map is damaged")
        self._starts[name] = file.stat().st_size - array.nbytes
        self._handles[name] = file.open("r+b")

    def _write(self, name: str, offset: int, data: Array) -> None:
        handle = self._handles[name]
        try:
            with self._writing:
                handle.seek(self._starts[name] + offset)
                handle.write(data.data)
                handle.flush()
        except OSError as error:
            raise refusal(error, self.folder) from None

    def _refuse(self, what: str) -> Any:
        raise OutputError(
            what, str(self.folder), "delete this folder to start again, or choose another output"
        )


def _reserve(file: Path) -> None:
    """Take the room of a file now, so that a full disk shows before anything is computed."""
    if hasattr(os, "posix_fallocate"):  # not on every system
        with file.open("r+b") as handle:
            os.posix_fallocate(handle.fileno(), 0, file.stat().st_size)
