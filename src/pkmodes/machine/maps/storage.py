"""The fields of a map: in memory, or in a folder from which an interrupted run can be continued.

The folder holds a Zarr group.  Its attributes are the plan: what is computed.  It has an array for each field, and in
each array a chunk for each task.  Zarr writes a chunk, with its checksum, under a temporary name and then renames it.
So a task is done if all of its chunks are there with the right checksum: a killed process loses only tasks in
progress, and rows that were damaged or removed since are computed again.

A lock file, created first and uniquely named, keeps other processes out.  A folder that contains files but no lock
belongs to the user: nothing in it is written or removed.
"""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from math import prod
from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import OutputError, shown
from pkmodes.core.solve.fields import missing_value
from pkmodes.core.support.writing import write_error

Array = NDArray[Any]
#: Shape at one pose and type of each field.
FieldLayouts = Mapping[str, tuple[tuple[int, ...], str]]
#: Of the folder of a map in progress, after the name of its file.
PARTIAL_SUFFIX = ".partial"
#: Name of the group in the folder.
GROUP_NAME = "fields.zarr"
LOCK_NAME = "pkmodes-map.lock"
START_AGAIN_REMEDY = "delete this folder to start again, or choose another output"


@dataclass(frozen=True, eq=False)
class Store:
    """The fields of a map.

    - arrays: each (rows, ...)
    - done: tasks that an earlier run completed, (tasks,)
    - folder: where the arrays are, if not in memory
    """

    arrays: dict[str, Any]
    done: NDArray[np.bool_]
    folder: Path | None = None

    def write_rows(self, rows: slice, values: Mapping[str, Array]) -> None:
        """Write the values of a task, which has these rows; several threads may write different tasks.

        Raises OutputError if they cannot be written.
        """
        try:
            for name, array in self.arrays.items():
                array[rows] = values[name]
        except OSError as error:
            assert self.folder is not None, "memory raises no such error"
            raise write_error(error, self.folder) from None

    def codes(self) -> Array:
        """Return the code of each row, after all of them were stored.

        Raises OutputError if someone removed files during the run: Zarr would return fill values, as if no pose there
        could be evaluated.
        """
        codes = np.asarray(self.arrays["code"][:])
        if self.folder is not None and (codes < 0).any():
            problem = "expected the rows of the map in progress, found that some were removed meanwhile"
            raise OutputError(problem, str(self.folder), "the same command computes them again")
        return codes

    def remove_files(self) -> None:
        """Remove the files of the map, once it is finished or has nothing worth continuing."""
        if self.folder is not None:
            shutil.rmtree(self.folder / GROUP_NAME)


@contextmanager
def checksum_errors_explained(folder: Path) -> Iterator[None]:
    """Explain what to do if rows were damaged after they had been stored.

    Raises OutputError if a checksum is not that of the rows.
    """
    try:
        yield
    except ValueError as error:
        if "checksum" not in str(error):  # of Zarr's codec
            raise
        problem = "rows of the map in progress were damaged meanwhile"
        raise OutputError(problem, str(folder), "the same command computes them again") from None


def memory_store(rows: int, tasks: int, layouts: FieldLayouts) -> Store:
    """Return empty fields in memory, with no task done."""
    arrays = {name: np.empty((rows, *pose_shape), dtype) for name, (pose_shape, dtype) in layouts.items()}
    return Store(arrays, np.zeros(tasks, dtype=bool))


def disk_store(
    folder: Path, plan: dict[str, Any], rows: int, rows_of_a_task: int, layouts: FieldLayouts
) -> Store:
    """Return fields in a folder, with the tasks that are done there.

    The metadata of each array is deleted and created anew over its chunks, which the new array adopts.

    - folder: exists; continued if it holds the same plan
    - plan: what is computed, as JSON data

    Raises OutputError if the folder cannot be written, has no room, or holds another map.
    """
    import zarr
    from zarr.codecs import Crc32cCodec

    group, tasks = folder / GROUP_NAME, range(-(-rows // rows_of_a_task))
    bytes_needed = rows * sum(
        prod(pose_shape) * np.dtype(dtype).itemsize for pose_shape, dtype in layouts.values()
    )
    arrays: dict[str, Any] = {}
    try:
        if not _can_continue(group, plan):
            if shutil.disk_usage(folder).free < bytes_needed:  # reported before anything is computed
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            zarr.create_group(group, overwrite=True, zarr_format=3, attributes=plan)
        for name, (pose_shape, dtype) in layouts.items():
            # Recreate the metadata: the plan determines it, whatever is on disk.
            (group / name / "zarr.json").unlink(missing_ok=True)
            arrays[name] = zarr.create_array(
                group / name,
                shape=(rows, *pose_shape),
                chunks=(min(rows_of_a_task, rows), *(max(length, 1) for length in pose_shape)),
                dtype=dtype,
                fill_value=missing_value(dtype),
                compressors=[Crc32cCodec()],
                zarr_format=3,
                config={"write_empty_chunks": True},  # otherwise a task without a valid pose is never done
            )
        done = [
            all(_task_intact(group / name, array, task) for name, array in arrays.items()) for task in tasks
        ]
    except OSError as error:
        raise write_error(error, folder) from None
    return Store(arrays, np.array(done), folder)


def _can_continue(group: Path, plan: dict[str, Any]) -> bool:
    """Return whether there is an interrupted map with this plan; refuse another one."""
    import zarr

    try:
        interrupted = zarr.open_group(group, mode="r", zarr_format=3).attrs.asdict()
    except FileNotFoundError:
        return False
    except OSError:
        raise
    except Exception:  # depends on what Zarr finds wrong with the file
        problem = "the plan of the interrupted map is damaged"
        raise OutputError(problem, str(group.parent), START_AGAIN_REMEDY) from None
    differing = [key for key in {**plan, **interrupted} if plan.get(key) != interrupted.get(key)]
    if differing:
        problem = f"this folder holds an interrupted map that differs in: {', '.join(differing)}"
        raise OutputError(problem, str(group.parent), START_AGAIN_REMEDY)
    return True


def _task_intact(array_folder: Path, array: Any, task: int) -> bool:
    """Return whether the rows of a task are there as they were stored."""
    if not array.size:  # a robot without modes
        return True
    if not (array_folder / array.metadata.encode_chunk_key((task,) + (0,) * (array.ndim - 1))).is_file():
        return False
    try:
        array.blocks[task]
    except ValueError:  # checksum mismatch
        return False
    return True


@contextmanager
def folder_lock(folder: Path) -> Iterator[None]:
    """Make a folder and keep a second process from writing into it.

    The system releases the lock of a process that was killed.  A folder in which nothing was begun is removed again.

    Raises OutputError if the folder cannot be made, is not that of a map in progress, or is locked by another
    process.
    """
    from filelock import FileLock, Timeout

    lock = FileLock(folder / LOCK_NAME, blocking=False)
    try:
        if not folder.is_symlink():
            with suppress(FileExistsError):
                folder.mkdir()
        _refuse_foreign_folder(folder)
        lock.acquire()
    except Timeout:
        problem, remedy = "another process is writing this map", "wait for it, or choose another output"
        raise OutputError(problem, str(folder), remedy) from None
    except OSError as error:
        raise write_error(error, folder) from None
    try:
        yield
    finally:
        with suppress(OSError):
            if [path.name for path in folder.iterdir()] == [LOCK_NAME]:
                (folder / LOCK_NAME).unlink()
                folder.rmdir()
        lock.release()


def _refuse_foreign_folder(folder: Path) -> None:
    """Refuse what is not a folder of a map in progress; an empty folder may become one."""
    entries = sorted(path.name for path in folder.iterdir()) if folder.is_dir() else []
    obstacle, remedy = "", "move or rename it, or choose another output"
    if folder.is_symlink():
        obstacle, remedy = "a symbolic link", "remove it, or choose another output"
    elif not folder.is_dir():
        obstacle = "a file"
    elif entries and LOCK_NAME not in entries:
        obstacle = f"one with other files ({shown(entries[0])})"
    if obstacle:
        problem = f"expected a folder for the map in progress, found {obstacle}"
        raise OutputError(problem, str(folder), remedy)
    for parent, folders, files in os.walk(folder):
        for name in (*folders, *files):
            # Another process may be deleting its files; acquiring the lock will detect it.
            with suppress(FileNotFoundError):
                kind = (Path(parent) / name).lstat().st_mode
                if not (S_ISREG(kind) or S_ISDIR(kind)):
                    problem = f"expected files for the map in progress, found a link or device, {shown(name)}"
                    raise OutputError(problem, str(folder), START_AGAIN_REMEDY)
