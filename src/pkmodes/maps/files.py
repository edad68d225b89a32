"""The file of a map: NetCDF-4, Zarr, or a table in CSV or Parquet; written completely or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pkmodes.errors import OutputError, shown
from pkmodes.maps.dataset import imported
from pkmodes.maps.table import table_of

if TYPE_CHECKING:
    import xarray

NETCDF, ZARR, CSV, PARQUET = ".nc", ".zarr", ".csv", ".parquet"
FORMATS = (NETCDF, ZARR, CSV, PARQUET)


@dataclass(frozen=True)
class Target:
    """The file of a map.

    Attributes
    ----------
    path : Path
    """

    path: Path

    @classmethod
    def checked(cls, out: str | os.PathLike[str], overwrite: bool) -> Target:
        """Check, before anything is computed, that a map can be written there.

        Raises
        ------
        OutputError
            If the format is unknown, the folder does not exist or cannot be written, or the file exists.
        """
        path, where = Path(out), shown(str(out))
        if "\\0" in str(out) or path.suffix.lower() not in FORMATS:
            what = f"expected a name that ends in {', '.join(FORMATS[:-1])} or {FORMATS[-1]}, found {where}"
            raise OutputError(what, "out", "for example: map.nc")
        if not path.parent.is_dir():
            raise OutputError(
                f"the folder {path.parent} does not exist", where, "create it, or choose another place"
            )
        folder = path.suffix.lower() == ZARR
        if path.exists() and not overwrite:
            remedy = "choose another name, or allow it to be replaced with overwrite (--overwrite)"
            raise OutputError("the output exists", where, remedy)
        if path.exists() and path.is_dir() != folder:
            found = "a folder" if path.is_dir() else "a file"
            raise OutputError(
                f"expected {'a folder' if folder else 'a file'}, found {found}", where, "choose another name"
            )
        if folder and path.exists() and not any((path / name).exists() for name in (".zgroup", "zarr.json")):
            raise OutputError(
                "the folder to replace does not hold a Zarr store", where, "choose another name"
            )
        if not os.access(path.parent, os.W_OK):
            raise OutputError(
                "cannot write: permission denied", where, "choose another place or make it writable"
            )
        return cls(path)

    def write(self, dataset: xarray.Dataset) -> None:
        """Write the dataset under a temporary name, then rename it.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        suffix = self.path.suffix.lower()
        temporary = Path(tempfile.mkdtemp(prefix=f".{self.path.name[:100]}.", dir=self.path.parent))
        try:
            new = temporary / self.path.name
            if suffix == NETCDF:
                dataset.to_netcdf(new, format="NETCDF4", engine="netcdf4", encoding=encoding_of(dataset))
            elif suffix == ZARR:
                # Version 2 of the format: version 3 has no standard for text yet.
                dataset.drop_encoding().to_zarr(new, mode="w", zarr_format=2, consolidated=True)
            elif suffix == CSV:
                table_of(dataset).to_csv(new, index=False)
            else:
                table_of(dataset).to_parquet(new, index=False)
            if self.path.is_dir():
                self.path.rename(temporary / "replaced")
            new.replace(self.path)
        except OSError as error:
            what = f"cannot write: {(error.strerror or str(error)).lower()}"
            raise OutputError(
                what, str(self.path), "choose another place or make room, then run it again"
            ) from None
        finally:
            with suppress(OSError):
                shutil.rmtree(temporary)

    @property
    def is_table(self) -> bool:
        """Whether the file is a table, which holds less than the dataset."""
        return self.path.suffix.lower() in (CSV, PARQUET)

    def opened(self) -> xarray.Dataset:
        """Open a map that was written, without loading its values."""
        engine = "netcdf4" if self.path.suffix.lower() == NETCDF else "zarr"
        found: xarray.Dataset = imported().open_dataset(self.path, engine=engine)
        return found


def encoding_of(dataset: xarray.Dataset) -> dict[str, dict[str, Any]]:
    """Return the NetCDF encoding: text as characters, which compress well, because nearly all are alike."""
    return {"reason": {"dtype": "S1", "zlib": True, "complevel": 1}} if "reason" in dataset else {}
