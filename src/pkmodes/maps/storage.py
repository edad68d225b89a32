"""The arrays of a map: in memory, or in a folder from which an interrupted run can be continued.

The folder holds one array per field, a record of the finished tasks, and the plan: what is computed.  A task is
recorded after its rows are stored, with their checksum, so a killed process loses only tasks in progress, and rows
that were damaged since are computed again.  Rows are written to and read
from the files directly: a memory-mapped file would end the process with a signal when the disk is full, and its pages
would count as memory of the process.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from contextlib import suppress
from io import BytesIO
from math import prod
from pathlib import Path
from threading import Lock
from typing import Any, BinaryIO
from zlib import crc32

import numpy as np
from numpy.lib.format import dtype_to_descr, write_array_header_1_0
from numpy.typing import NDArray

from pkmodes.core.base.errors import OutputError
from pkmodes.core.solve.fields import EVERY, of_maps
from pkmodes.support.writing import refusal

Array = NDArray[Any]
#: Shape at one pose, and type, of each field.
Tails = Mapping[str, tuple[tuple[int, ...], str]]
#: Type, and shape of the whole array, of each file.
Kinds = dict[str, tuple[np.dtype[Any], tuple[int, ...]]]
PLAN, DONE, CHECKS = "plan.json", "done", "checks"
SUFFIX = ".partial"


class Stored:
    """An array in a file, of which parts are read on demand."""

    def __init__(self, file: Path, start: int, dtype: np.dtype[Any], shape: tuple[int, ...]) -> None:
        self.file, self.start, self.dtype = file, start, dtype
        self.shape, self.ndim = shape, len(shape)

    def __getitem__(self, key: Any) -> Array:
        return np.array(np.memmap(self.file, self.dtype, "r", self.start, self.shape)[key])

    def __len__(self) -> int:
        return self.shape[0]

    def reshape(self, *shape: int) -> Stored:
        """Return the same array with another shape."""
        return Stored(self.file, self.start, self.dtype, shape)


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

    def put(self, number: int, rows: slice, values: Mapping[str, Array]) -> None:
        """Store the values of a task, which has these rows; several threads may store different tasks."""
        for name, array in self.arrays.items():
            array[rows] = values[name]

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
    rows_of : callable
        Returns the rows of a task, given its number.

    Attributes
    ----------
    arrays : dict of str to Stored, shape (rows, ...)
    done : ndarray of bool, shape (tasks,)
        When it was opened, and since; not those whose rows were damaged.

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
        tails: Tails,
        rows_of: Callable[[int], slice],
    ) -> None:
        self.folder, self._rows_of = folder, rows_of
        kinds = {name: (np.dtype(dtype), (rows, *tail)) for name, (tail, dtype) in tails.items()}
        self._kinds: Kinds = {**kinds, DONE: (np.dtype("?"), (tasks,)), CHECKS: (np.dtype("<u4"), (tasks,))}
        self._starts = {name: len(_header(*kind)) for name, kind in self._kinds.items()}
        self._handles: dict[str, BinaryIO] = {}
        self._checks: dict[int, int] = {}
        self._writing = Lock()
        try:
            if (folder / PLAN).exists():
                self._compare(plan)
            else:
                self._begin(plan)
            for name in self._kinds:
                self._open(name)
            self.arrays = {name: self._stored(name) for name in tails}
            self.done: Array = self._whole()
        except OSError as error:
            self.close()
            raise refusal(error, folder) from None
        except BaseException:
            self.close()
            raise

    def put(self, number: int, rows: slice, values: Mapping[str, Array]) -> None:
        """Store the values of a task, which has these rows; several threads may store different tasks.

        Raises
        ------
        OutputError
            If they cannot be written.
        """
        check = 0
        for name in self.arrays:
            data = np.ascontiguousarray(values[name]).reshape(-1).view(np.uint8)
            check = crc32(data.data, check)
            self._write(name, rows.start * self._size(name), data)
        self._checks[number] = check

    def finish(self, number: int) -> None:
        """Record that the rows of a task are stored."""
        check = np.array([self._checks.pop(number)], dtype="<u4").view(np.uint8)
        self._write(CHECKS, number * self._size(CHECKS), check)
        self._write(DONE, number, np.ones(1, dtype=np.uint8))
        self.done[number] = True

    def close(self) -> None:
        """Close the files; what is stored can still be read."""
        for handle in self._handles.values():
            with suppress(OSError):  # every write was flushed
                handle.close()
        self._handles = {}

    def remove(self) -> None:
        """Remove the files of the map, which is complete, or has nothing to continue; and the folder, once empty."""
        self.close()
        fields = {field.variable for field in of_maps(EVERY)} | {"code", DONE, CHECKS}
        for name in [PLAN, f"{PLAN}.new", *(f"{field}.npy" for field in fields)]:
            (self.folder / name).unlink(missing_ok=True)

    def _begin(self, plan: dict[str, Any]) -> None:
        """Make the arrays, then the plan: a folder without a plan is begun anew."""
        try:
            for name, kind in self._kinds.items():
                with self._file(name).open("wb") as file:
                    file.write(_header(*kind))
                    file.truncate(self._length(name))
                    file.flush()
                    if hasattr(os, "posix_fallocate"):  # not on every system
                        # A full disk shows before anything is computed.
                        os.posix_fallocate(file.fileno(), 0, self._length(name))
        except BaseException:  # a full disk should not stay full
            for name in self._kinds:
                self._file(name).unlink(missing_ok=True)
            raise
        temporary = self.folder / f"{PLAN}.new"
        temporary.write_text(json.dumps(plan, indent=1), encoding="utf-8")
        temporary.replace(self.folder / PLAN)

    def _whole(self) -> Array:
        """Return which tasks are done, with the rows that were stored."""
        done = self._stored(DONE)[:].view(np.uint8) == 1  # another byte than 0 and 1 is damage
        checks = self._stored(CHECKS)[:]
        for number in np.flatnonzero(done).tolist():
            rows, check = self._rows_of(number), 0
            for array in self.arrays.values():
                check = crc32(np.ascontiguousarray(array[rows]).data, check)
            done[number] = check == checks[number]
        return np.asarray(done)

    def _stored(self, name: str) -> Stored:
        dtype, shape = self._kinds[name]
        return Stored(self._file(name), self._starts[name], dtype, shape)

    def _size(self, name: str) -> int:
        """Bytes of a row."""
        dtype, shape = self._kinds[name]
        return dtype.itemsize * prod(shape[1:])

    def _length(self, name: str) -> int:
        """Bytes of a file."""
        return self._starts[name] + self._size(name) * self._kinds[name][1][0]

    def _file(self, name: str) -> Path:
        return self.folder / f"{name}.npy"

    def _compare(self, plan: dict[str, Any]) -> None:
        try:
            interrupted = json.loads((self.folder / PLAN).read_text(encoding="utf-8"))
        except (ValueError, RecursionError):
            interrupted = None
        if not isinstance(interrupted, dict):
            self._refuse("the plan of the interrupted map is damaged")
        other = [key for key in {**plan, **interrupted} if plan.get(key) != interrupted.get(key)]
        if other:
            self._refuse(f"this folder holds an interrupted map that differs in: {', '.join(other)}")

    def _open(self, name: str) -> None:
        file = self._file(name)
        if not file.is_file() or file.stat().st_size != self._length(name):
            self._refuse(f"the file {file.name} of the interrupted map is truncated or missing")
        handle = self._handles[name] = file.open("r+b")
        if handle.read(self._starts[name]) != _header(*self._kinds[name]):
            self._refuse(f"the file {file.name} of the interrupted map is damaged")

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


def _header(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    """Return how a file begins; a header that differs is not interpreted."""
    file = BytesIO()
    about = {"descr": dtype_to_descr(dtype), "fortran_order": False, "shape": shape}
    write_array_header_1_0(file, about)
    return file.getvalue()
