"""A map as a table: one row for each mode at each pose."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.core.solve.fields import ALL_CONDITIONS, MODE, map_fields
from pkmodes.machine.dataset.variables import LIST, OF_POSES, OF_TRACKING, dims_of

if TYPE_CHECKING:
    import pandas
    import xarray
#: Order of the columns, by whether there is one for each mode, and for each component.
ORDER = ((True, False), (False, False), (True, True), (False, True))


def table_of(dataset: xarray.Dataset) -> pandas.DataFrame:
    """Return the modes of a dataset as a table.

    - dataset: from `pkmodes.Model.map` or `pkmodes.Modes.to_dataset`

    Returns one row for each mode at each pose, with the coordinates of the map as columns; shapes and positions have
    one column for each component, such as ``platform_shape:x``, ``joint_position:x_1``.
    """
    import xarray

    # The axes of each variable after those of the poses.
    axes = {field.variable: dims_of(field) for field in map_fields(ALL_CONDITIONS)}
    axes |= {variable.name: variable.dims for variable in (*OF_TRACKING, *OF_POSES)}
    columns: dict[str, xarray.DataArray] = {}
    for name, dims in sorted(
        axes.items(), key=lambda item: ORDER.index((MODE in item[1], bool({*item[1]} - {MODE})))
    ):
        if name not in dataset:
            continue
        if dims in ((), (MODE,)):
            columns[name] = dataset[name]
        else:
            along = dims[-1]
            labels = dataset[along].values.tolist()
            columns |= {f"{name}:{label}": dataset[name].sel({along: label}, drop=True) for label in labels}
    wide = xarray.Dataset(columns)
    order = [str(dim) for dim in (*dataset["valid"].dims, MODE) if dim in wide.dims]
    if not order:  # one pose, without frequencies and shapes
        wide, order = wide.expand_dims(LIST), [LIST]
    return wide.to_dataframe(dim_order=order).reset_index()


def write_table(table: pandas.DataFrame, path: Path) -> None:
    """Write a table as CSV or, by the name of the file, Parquet; numbers that do not exist are empty."""
    if path.suffix == ".csv":
        words = {name: table[name].map({False: "false", True: "true"}) for name in table.select_dtypes(bool)}
        table.assign(**words).to_csv(path, index=False, lineterminator="\n")
    else:
        table.to_parquet(path, index=False)
