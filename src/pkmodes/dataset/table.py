"""A map as a table: one row for each mode at each pose."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.dataset.variables import LIST, MODE

if TYPE_CHECKING:
    import pandas
    import xarray

PER_MODE = ("frequency", "in_plane", "out_of_plane", "rank", "tracking")
PER_POSE = ("condition", "valid", "reason")


def table_of(dataset: xarray.Dataset) -> pandas.DataFrame:
    """Return the modes of a dataset as a table.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `pkmodes.Model.map` or `pkmodes.Modes.to_dataset`.

    Returns
    -------
    pandas.DataFrame
        One row for each mode at each pose, with the coordinates of the map as columns; shapes and positions have one
        column for each component, such as ``platform_shape:x``, ``joint_position:x_1``.
    """
    import xarray

    found: dict[str, xarray.DataArray] = {
        str(name): dataset[name] for name in (*PER_MODE, *PER_POSE) if name in dataset
    }
    for name, along in (
        ("platform_shape", "direction"),
        ("shape", "coordinate"),
        ("joint_position", "coordinate"),
        ("static_torque", "drive"),
    ):
        if name in dataset:
            labels = dataset[along].values.tolist()
            found |= {f"{name}:{label}": dataset[name].sel({along: label}, drop=True) for label in labels}
    wide = xarray.Dataset(found)
    order = [str(dim) for dim in (*dataset["valid"].dims, MODE) if dim in wide.dims]
    if not order:  # one pose, without frequencies and shapes
        wide, order = wide.expand_dims(LIST), [LIST]
    return wide.to_dataframe(dim_order=order).reset_index()


def write_table(table: pandas.DataFrame, path: Path) -> None:
    """Write a table as CSV or, by the name of the file, Parquet; numbers that do not exist are empty."""
    import pyarrow
    from pyarrow import csv, parquet

    content = pyarrow.Table.from_pandas(table, preserve_index=False)
    if path.suffix == ".csv":
        options = csv.WriteOptions(include_header=False, quoting_style="needed")
        with path.open("wb") as file:
            file.write((",".join(content.column_names) + "\n").encode())  # it would quote them
            csv.write_csv(content, file, options)
    else:
        parquet.write_table(content, path)
