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
from pkmodes.machine.dataset.attributes import imported
from pkmodes.machine.dataset.table import table_of, write_table

if TYPE_CHECKING:
    import xarray

NETCDF, ZARR, CSV, PARQUET = ".nc", ".zarr", ".csv", ".parquet"
#: Libraries that write each format, besides those that every map in progress needs, and their extra.
LIBRARIES = {
    NETCDF: ("map", "netCDF4"),
    ZARR: ("map",),
    CSV: ("map", "pandas"),
    PARQUET: ("parquet", "pyarrow"),
}
IN_PROGRESS = ("map", "zarr", "dask")
FORMATS = tuple(LIBRARIES)
#: Metadata files of a Zarr store: each group has one of the first, and each array one of the second.
GROUP, ARRAY = (".zgroup", "zarr.json"), (".zarray", "zarr.json")
DESCRIBING = {*GROUP, *ARRAY, ".zattrs", ".zmetadata"}
#: Names of its data: chunks of an array, or folders of chunks.
PIECE = re.compile(r"c|(c\.)?\d+(\.\d+)*")
#: Names, in the folder of the map in progress, of the map being written and of the one that it replaces.
UNDER_WAY = ("new", "replaced")


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
        folder = path.suffix.lower() == ZARR
        remedy = "choose another name, or replace it with overwrite=True (--overwrite)"
        check_replaced([path], "out", overwrite, what="the output exists", remedy=remedy)
        if path.exists() and path.is_dir() != folder:
            existing = "a folder" if path.is_dir() else "a file"
            raise OutputError(
                f"expected {'a folder' if folder else 'a file'}, found {existing}",
                where,
                "choose another name",
            )
        if folder and path.exists() and not any((path / name).exists() for name in GROUP):
            raise OutputError(
                "the folder to replace does not hold a Zarr store", where, "choose another name"
            )
        if folder and path.exists() and (foreign := next(_foreign(path), None)) is not None:
            part = shown(str(foreign.relative_to(path)))
            problem = f"the folder to replace holds {part}, which is no part of the map"
            raise OutputError(problem, where, "move that away, or choose another name")
        if not os.access(path.parent, os.W_OK):
            raise OutputError(
                "cannot write: permission denied", where, "choose another place or make it writable"
            )
        for extra, *libraries in (LIBRARIES[path.suffix.lower()], IN_PROGRESS):
            require(f"{path.suffix.lower()} files", extra, *libraries)
        return cls(path)

    def write(self, dataset: xarray.Dataset, folder: Path) -> None:
        """Write the dataset into a folder next to the file, then move it to its place.

        Raises OutputError if it cannot be written.
        """
        suffix = self.path.suffix.lower()
        new, replaced = (folder / f"{name}{suffix}" for name in UNDER_WAY)

        def put_back() -> None:
            """Undo the first of the two renames that replace a folder, if the second was not made."""
            if replaced.exists() and not self.path.exists():
                replaced.rename(self.path)

        try:
            put_back()  # the previous run was killed between the two
            for leftover in (new, replaced):  # by an interrupted run
                _remove(leftover)
            if suffix == NETCDF:
                import dask

                written, encoding = as_characters(dataset)
                with dask.config.set(scheduler=_in_order):
                    written.to_netcdf(new, format="NETCDF4", engine="netcdf4", encoding=encoding)
            elif suffix == ZARR:
                # Version 2 of the format: version 3 has no standard for text yet.
                dataset.drop_encoding().to_zarr(new, mode="w", zarr_format=2, consolidated=True)
            else:
                write_table(table_of(dataset), new)
            try:
                if self.path.is_dir():
                    self.path.rename(replaced)
                new.replace(self.path)
            finally:
                put_back()
            _remove(replaced)
        except (OSError, RuntimeError) as error:  # the NetCDF library raises RuntimeError
            reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
            remedy = "make room or choose another place; the same command continues"
            raise OutputError(f"cannot write: {reason.lower()}", str(self.path), remedy) from None

    @property
    def is_table(self) -> bool:
        """Whether the file is a table, which holds less than the dataset."""
        return self.path.suffix.lower() in (CSV, PARQUET)

    def opened(self) -> xarray.Dataset:
        """Open a map that was written, without loading its values."""
        engine = "netcdf4" if self.path.suffix.lower() == NETCDF else "zarr"
        dataset: xarray.Dataset = imported().open_dataset(self.path, engine=engine)
        return dataset


def as_characters(dataset: xarray.Dataset) -> tuple[xarray.Dataset, dict[str, dict[str, Any]]]:
    """Return the dataset with its reasons as bytes, and the encoding with which NetCDF holds characters.

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


def _in_order(graph: Any, keys: Any, **_: Any) -> Any:
    """Evaluate a Dask graph, as one of its schedulers, and write the parts of each field one after the other.

    Threads lay the same map out differently every time, and so does the order that Dask chooses by random names.
    """
    from dask.local import get_sync
    from dask.optimization import cull

    tasks = dict(graph.__dask_graph__() if hasattr(graph, "__dask_graph__") else graph)

    def evaluated(request: Any) -> Any:
        if isinstance(request, list):
            return [evaluated(part) for part in request]
        return get_sync(cull(tasks, [request])[0], request)

    return evaluated(keys)


def _foreign(folder: Path, *, pieces: bool = False) -> Iterator[Path]:
    """Yield what a folder of a Zarr store holds that is not part of it.

    - pieces: whether the folder is that of an array, which holds its values
    """
    pieces = pieces or any((folder / name).is_file() for name in ARRAY)
    for entry in sorted(folder.iterdir()):
        piece = pieces and PIECE.fullmatch(entry.name) is not None
        if entry.is_symlink() or not entry.is_dir():
            if entry.is_symlink() or not (piece or entry.name in DESCRIBING):
                yield entry
        elif piece or any((entry / name).is_file() for name in (*GROUP, *ARRAY)):
            yield from _foreign(entry, pieces=piece)
        else:
            yield entry


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)
