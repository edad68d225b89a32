"""Poses in a table of another library: columns are taken by name, whatever their order.

A table is anything with named columns: of pandas, polars or pyarrow, a structured array of NumPy, or an object with
a label for each number of a pose, such as a row of pandas or an array of xarray.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import MeasurementError, PoseError, shown
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.columns import parse_heading

Array = NDArray[Any]
#: Column names of a table, and a function that returns the values of a column by its index.
NamedColumns = tuple[Sequence[Any], Callable[[int], Any]]


def poses_by_name(poses: ArrayLike, mechanism: Mechanism) -> ArrayLike:
    """Return poses as an array with the components in their order; what has no names is returned unchanged.

    - poses: a table has a column for each component of the pose, in SI units or with a unit in its name (``x [mm]``);
      other columns are ignored

    Raises PoseError if a column is missing or repeated, does not hold numbers, or has another kind of unit.
    """
    if _is_array(poses):
        return poses  # without delay: a single pose takes microseconds
    return ordered_by_name(poses, {component.name: component.unit for component in mechanism.pose}, "poses")


def ordered_by_name(numbers: ArrayLike, units: Mapping[str, str], where: str) -> ArrayLike:
    """Return numbers by their names, (..., k), as `poses_by_name` does.

    - units: names and SI units, in the order of the result
    - where: name of the argument, for messages
    """
    columns = None if _is_array(numbers) else _named_columns(numbers)
    if columns is None:
        return numbers
    names, column_at = columns
    example = f"name them {', '.join(units)}, in any order, or give an array"
    try:
        headings = [
            parse_heading(str(name).strip(), f"{where}: column {shown(str(name))}", units) for name in names
        ]
    except MeasurementError as error:
        raise PoseError(error.what, error.where, error.remedy) from None
    stacked = []
    for name in units:
        matches = [i for i, (column_name, _) in enumerate(headings) if column_name == name]
        if len(matches) != 1:
            given_names = shown(", ".join(str(heading) for heading in names))
            problem = f"expected one column {shown(name)}, found {len(matches) or 'none'} among {given_names}"
            raise PoseError(problem, where, example)
        column, factor = np.asarray(column_at(matches[0])), headings[matches[0]][1]
        if column.dtype.kind not in "iuf":
            problem = f"expected numbers in the column {shown(name)}, found values of type {column.dtype}"
            raise PoseError(problem, where, "give a number for each pose")
        if factor is not None:  # in SI units, to the same digits as from a file
            plain_numbers = column.astype(float).ravel().tolist()
            column = np.array([float(Decimal(repr(x)) * factor) for x in plain_numbers]).reshape(column.shape)
        stacked.append(column)
    return np.stack(stacked, axis=-1)


def _is_array(values: Any) -> bool:
    return isinstance(values, list | tuple) or (isinstance(values, np.ndarray) and values.dtype.names is None)


def _named_columns(values: Any) -> NamedColumns | None:
    """Return the columns of a table, None for anything else."""
    if isinstance(values, np.ndarray):
        names = values.dtype.names or ()
        return names, lambda i: values[names[i]]
    if hasattr(values, "iloc"):  # pandas, and what has its interface
        if hasattr(values, "columns"):
            return list(values.columns), lambda i: values.iloc[:, i]
        return list(values.index), lambda i: values.iloc[i]
    columns = getattr(values, "column_names", getattr(values, "columns", None))  # pyarrow, polars
    if isinstance(columns, list | tuple) and hasattr(values, "__getitem__"):
        return columns, lambda i: values[columns[i]]
    dims, coords = getattr(values, "dims", None), getattr(values, "coords", None)
    if isinstance(dims, tuple) and dims and isinstance(coords, Mapping) and dims[-1] in coords:
        labels, array = np.asarray(coords[dims[-1]]), np.asarray(values)  # xarray
        if labels.dtype.kind in "UO":
            return labels.tolist(), lambda i: array[..., i]
    return None
