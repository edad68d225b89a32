"""A map as a table: one row for each mode at each pose."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.core.solve.fields import ALL_CONDITIONS, MODE, map_fields
from pkmodes.machine.dataset.variables import POSE_AXIS, POSE_VARIABLES, TRACKING_VARIABLES, dims_of

if TYPE_CHECKING:
    import pandas
    import xarray

#: Order of the columns: by whether there is one for each mode, and one for each component.
COLUMN_ORDER = ((True, False), (False, False), (True, True), (False, True))


def table_of(dataset: xarray.Dataset) -> pandas.DataFrame:
    """Return the modes of a dataset as a table.

    - dataset: from `pkmodes.Model.map` or `pkmodes.Modes.to_dataset`

    Returns one row for each mode at each pose, with the coordinates of the map as columns; shapes and positions have
    one column for each component, such as ``platform_shape:x``, ``joint_position:x_1``.
    """
    import xarray

    # The axes of each variable after those of the poses.
    axes = {field.variable: dims_of(field) for field in map_fields(ALL_CONDITIONS)}
    axes |= {variable.name: variable.dims for variable in (*TRACKING_VARIABLES, *POSE_VARIABLES)}
    columns: dict[str, xarray.DataArray] = {}
    for name, dims in sorted(
        axes.items(), key=lambda item: COLUMN_ORDER.index((MODE in item[1], bool({*item[1]} - {MODE})))
    ):
        if name not in dataset:
            continue
        if dims in ((), (MODE,)):
            columns[name] = dataset[name]
        else:
            component_axis = dims[-1]
            labels = dataset[component_axis].values.tolist()
            columns |= {
                f"{name}:{label}": dataset[name].sel({component_axis: label}, drop=True) for label in labels
            }
    column_dataset = xarray.Dataset(columns)
    row_dims = [str(dim) for dim in (*dataset["valid"].dims, MODE) if dim in column_dataset.dims]
    if not row_dims:  # one pose, without frequencies and shapes
        column_dataset, row_dims = column_dataset.expand_dims(POSE_AXIS), [POSE_AXIS]
    return column_dataset.to_dataframe(dim_order=row_dims).reset_index()


def write_table(table: pandas.DataFrame, path: Path) -> None:
    """Write a table as CSV or, by the name of the file, Parquet; missing numbers are empty."""
    if path.suffix == ".csv":
        flags_as_text = {
            name: table[name].map({False: "false", True: "true"}) for name in table.select_dtypes(bool)
        }
        table.assign(**flags_as_text).to_csv(path, index=False, lineterminator="\n")
    else:
        table.to_parquet(path, index=False)
