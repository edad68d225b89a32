"""The file of a map: NetCDF-4, Zarr, or a table in CSV or Parquet; written completely or not at all."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pkmodes.core.base.arguments import FILE_NAME, alternatives, check_argument
from pkmodes.core.base.errors import OutputError, shown
from pkmodes.core.support.extras import require
from pkmodes.core.support.places import resolve_path
from pkmodes.core.support.replacing import check_replaced
from pkmodes.machine.dataset.attributes import import_xarray
from pkmodes.machine.dataset.table import table_of, write_table

if TYPE_CHECKING:
    import xarray

NETCDF, ZARR, CSV, PARQUET = ".nc", ".zarr", ".csv", ".parquet"
#: For each format, the extra and the libraries that write it; then those that every map in progress needs.
LIBRARIES = {
    NETCDF: ("map", "netCDF4"),
    ZARR: ("map",),
    CSV: ("map", "pandas"),
    PARQUET: ("parquet", "pyarrow"),
}
PROGRESS_LIBRARIES = ("map", "zarr", "dask")
FORMATS = tuple(LIBRARIES)
#: Metadata files of a Zarr store: each group has one of the first tuple, and each array one of the second.
GROUP_FILES, ARRAY_FILES = (".zgroup", "zarr.json"), (".zarray", "zarr.json")
METADATA_FILES = {*GROUP_FILES, *ARRAY_FILES, ".zattrs", ".zmetadata"}
#: Names of its chunks, or of folders of chunks.
CHUNK_NAME = re.compile(r"c|(c\.)?\d+(\.\d+)*")
#: Names, in the folder of the map in progress, of the new map and of the one that it replaces.
TEMPORARY_NAMES = ("new", "replaced")


@dataclass(frozen=True)
class MapFile:
    """The file of a map."""

    path: Path

    @classmethod
    def checked(cls, out: str | os.PathLike[str], overwrite: bool) -> MapFile:
        """Check, before anything is computed, that a map can be written there.

        Raises OutputError if the format is unknown, the folder does not exist or cannot be written, or the file
        exists.
        Raises MissingExtraError if a library that writes it is not installed.
        """
        check_argument(out, FILE_NAME, "out", "for example: map.nc", OutputError)
        path, where = Path(out), shown(str(out))
        if "\0" in str(out) or path.suffix.lower() not in FORMATS:
            problem = f"expected a name that ends in {alternatives(FORMATS)}, found {where}"
            raise OutputError(problem, "out", "for example: map.nc")
        if path.is_symlink():
            path = resolve_path(path, "out")
            if path.suffix.lower() not in FORMATS:
                problem = f"expected a link to a name that ends in {alternatives(FORMATS)}, found {shown(str(path))}"
                raise OutputError(problem, where, "name that file as a map, or choose another name")
        if not path.parent.is_dir():
            raise OutputError(
                f"the folder {path.parent} does not exist", where, "create it, or choose another place"
            )
        is_store = path.suffix.lower() == ZARR
        remedy = "choose another name, or replace it with overwrite=True (--overwrite)"
        check_replaced([path], "out", overwrite, what="the output exists", remedy=remedy)
        if path.exists() and path.is_dir() != is_store:
            existing = "a folder" if path.is_dir() else "a file"
            raise OutputError(
                f"expected {'a folder' if is_store else 'a file'}, found {existing}",
                where,
                "choose another name",
            )
        if is_store and path.exists() and not any((path / name).exists() for name in GROUP_FILES):
            raise OutputError(
                "the folder to replace does not hold a Zarr store", where, "choose another name"
            )
        if is_store and path.exists() and (foreign := next(_foreign_entries(path), None)) is not None:
            part = shown(str(foreign.relative_to(path)))
            problem = f"the folder to replace holds {part}, which is no part of the map"
            raise OutputError(problem, where, "move that away, or choose another name")
        if not os.access(path.parent, os.W_OK):
            raise OutputError(
                "cannot write: permission denied", where, "choose another place or make it writable"
            )
        for extra, *libraries in (LIBRARIES[path.suffix.lower()], PROGRESS_LIBRARIES):
            require(f"{path.suffix.lower()} files", extra, *libraries)
        return cls(path)

    def write(self, dataset: xarray.Dataset, folder: Path) -> None:
        """Write the dataset into a folder next to the file, then move it to its place.

        Raises OutputError if it cannot be written.
        """
        suffix = self.path.suffix.lower()
        new_file, replaced_file = (folder / f"{name}{suffix}" for name in TEMPORARY_NAMES)

        def restore_replaced() -> None:
            """Undo the first of the two renames that replace a folder, if the second was not made."""
            if replaced_file.exists() and not self.path.exists():
                replaced_file.rename(self.path)

        try:
            restore_replaced()  # the previous run was killed between the two renames
            for leftover in (new_file, replaced_file):  # by an interrupted run
                _remove(leftover)
            if suffix == NETCDF:
                import dask

                encoded, encoding = encode_reasons(dataset)
                with dask.config.set(scheduler=_sequential_scheduler):
                    encoded.to_netcdf(new_file, format="NETCDF4", engine="netcdf4", encoding=encoding)
            elif suffix == ZARR:
                # Version 2 of the format: version 3 has no standard for text yet.
                dataset.drop_encoding().to_zarr(new_file, mode="w", zarr_format=2, consolidated=True)
            else:
                write_table(table_of(dataset), new_file)
            try:
                if self.path.is_dir():
                    self.path.rename(replaced_file)
                new_file.replace(self.path)
            finally:
                restore_replaced()
            _remove(replaced_file)
        except (OSError, RuntimeError) as error:  # the NetCDF library raises RuntimeError
            reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
            remedy = "make room or choose another place; the same command continues"
            raise OutputError(f"cannot write: {reason.lower()}", str(self.path), remedy) from None

    @property
    def is_table(self) -> bool:
        """Whether the file is a table, which holds less than the dataset."""
        return self.path.suffix.lower() in (CSV, PARQUET)

    def open_dataset(self) -> xarray.Dataset:
        """Open a map that was written, without loading its values."""
        engine = "netcdf4" if self.path.suffix.lower() == NETCDF else "zarr"
        dataset: xarray.Dataset = import_xarray().open_dataset(self.path, engine=engine)
        return dataset


def encode_reasons(dataset: xarray.Dataset) -> tuple[xarray.Dataset, dict[str, dict[str, Any]]]:
    """Return the dataset with its reasons as bytes, and the encoding with which NetCDF stores characters.

    Characters compress well, because nearly all are alike, and xarray encodes text only as a whole.
    """
    reason = dataset["reason"]
    attributes = {**reason.attrs, "_Encoding": "utf-8"}
    size = np.dtype(f"S{reason.dtype.itemsize // np.dtype('U1').itemsize}")
    reason = reason.astype(size).assign_attrs(attributes)
    # Coordinates are complete, and CF forbids a fill value.
    encoding: dict[str, dict[str, Any]] = {str(name): {"_FillValue": None} for name in dataset.coords}
    encoding["reason"] = {"dtype": "S1", "zlib": True, "complevel": 1}
    return dataset.assign(reason=reason), encoding


def _sequential_scheduler(graph: Any, keys: Any, **options: Any) -> Any:
    """Evaluate a Dask graph, as one of its schedulers, and write the parts of each field one after the other.

    With threads, or in the order that Dask derives from random names, the same map has another layout at every run.
    """
    from dask.local import get_sync
    from dask.optimization import cull

    tasks = dict(graph.__dask_graph__() if hasattr(graph, "__dask_graph__") else graph)

    def evaluate(request: Any) -> Any:
        if isinstance(request, list):
            return [evaluate(part) for part in request]
        return get_sync(cull(tasks, [request])[0], request)

    return evaluate(keys)


def _foreign_entries(folder: Path, *, in_array: bool = False) -> Iterator[Path]:
    """Yield the files and folders in a folder of a Zarr store that are not part of the store.

    - in_array: whether the folder is that of an array, which holds its values
    """
    in_array = in_array or any((folder / name).is_file() for name in ARRAY_FILES)
    for entry in sorted(folder.iterdir()):
        is_chunk = in_array and CHUNK_NAME.fullmatch(entry.name) is not None
        if entry.is_symlink() or not entry.is_dir():
            if entry.is_symlink() or not (is_chunk or entry.name in METADATA_FILES):
                yield entry
        elif is_chunk or any((entry / name).is_file() for name in (*GROUP_FILES, *ARRAY_FILES)):
            yield from _foreign_entries(entry, in_array=is_chunk)
        else:
            yield entry


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)
