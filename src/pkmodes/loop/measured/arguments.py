"""Columns of measurements given in Python: names of arguments, shapes and types of arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from pkmodes.core.base.errors import MeasurementError, checked_list, nearest_name, shown
from pkmodes.loop.measured.columns import Array
from pkmodes.loop.measured.quantities import QUANTITIES, NumberColumn, number_columns


def renamed_columns() -> dict[str, str]:
    """Return the arguments by column name, where the two names differ."""
    return {spec.column: spec.argument for spec in number_columns() if spec.column != spec.argument}


def unknown_argument_remedy(name: str) -> str:
    """Return the remedy for an unknown argument of `Measurements.from_rows`."""
    optional = [q for q in QUANTITIES.values() if not q.value.required]
    values, sigmas = ([getattr(q, attribute).argument for q in optional] for attribute in ("value", "sigma"))
    shapes = ["mode", "shapes", "shape_sigma"]
    names = ["points", "point_sigma", *values, *shapes, *sigmas, "band", "components", "settings", "level"]
    name_by_alias = {**renamed_columns(), "x": "points", "shape": "shapes"}
    return nearest_name(name_by_alias.get(name, name), names)


def quantity_columns(arrays: Mapping[str, ArrayLike | None], rows: int, source: str) -> dict[str, Array]:
    """Return the columns of all quantities, with the usual standard deviations where none are given."""

    def column(spec: NumberColumn, values: ArrayLike | None) -> Array:
        present = spec.required or values is not None
        return checked_array(values, spec.argument, (rows,), source) if present else np.full(rows, np.nan)

    columns: dict[str, Array] = {}
    # Optional columns are checked first, so that their mistakes are reported first.
    for quantity in reversed(QUANTITIES.values()):
        value, sigma = quantity.value, quantity.sigma
        values, stated_sigma = column(value, arrays.get(value.argument)), arrays.get(sigma.argument)
        sigmas = column(sigma, stated_sigma if sigma.required else repeat_for_rows(stated_sigma, rows))
        if quantity.usual_sigma is not None:
            sigmas = np.where(np.isnan(sigmas), quantity.usual_sigma(values), sigmas)
        columns |= {value.argument: values, sigma.argument: sigmas}
    return columns


def make_read_only(array: Array) -> Array:
    """Make an array read-only, in place, and return it."""
    array.flags.writeable = False
    return array


def repeat_for_rows(values: ArrayLike | None, rows: int) -> ArrayLike | None:
    """Repeat a single number for all rows; return anything else unchanged."""
    return np.full(rows, values) if isinstance(values, int | float | np.integer | np.floating) else values


def checked_columns(
    columns: Mapping[str, ArrayLike] | None, argument: str, example: str, source: str
) -> Mapping[str, ArrayLike]:
    """Check a mapping of names to columns; empty if none is given."""
    if columns is None:
        return {}
    if not isinstance(columns, Mapping) or not all(isinstance(name, str) for name in columns):
        expected = "components by coordinate" if argument == "shapes" else "values by name"
        raise MeasurementError(
            f"expected {expected}, found {shown(columns)}",
            f"{source}: {argument}",
            f'for example: {{"{example}": [0.5, -0.2]}}',
        )
    return columns


def drives_of_rows(drives: str | Sequence[str], rows: int, source: str) -> list[str]:
    """Return whether the motors were held or free in each row, from one word for all rows or one for each."""
    if isinstance(drives, str):
        return [drives] * rows
    words = checked_list(drives, "words", f"{source}: drives", '"held"', str, MeasurementError)
    if len(words) != rows:
        problem = f"expected one word for all rows, or {rows}, found {len(words)}"
        raise MeasurementError(problem, f"{source}: drives", 'give "free" or "held" for each row')
    return list(words)


def checked_mode_numbers(mode: Sequence[object], source: str) -> list[object]:
    """Check the experimenter's mode numbers, which may be text."""
    return checked_list(mode, "mode numbers", f"{source}: mode", "1", error=MeasurementError)


def checked_array(
    values: ArrayLike | None, name: str, shape: tuple[int, ...], source: str, integers_only: bool = False
) -> Array:
    """Copy an array, checking its shape and that it holds integers or numbers."""
    try:
        array = np.array(values)
        if array.dtype.kind not in ("iu" if integers_only else "iuf") and array.size:
            raise TypeError(f"found values of type {array.dtype}")
    except Exception as error:  # conversion of an arbitrary object may raise anything
        kind = "whole numbers" if integers_only else "numbers"
        raise MeasurementError(
            f"expected an array of {kind}: {error}", f"{source}: {name}", f"give an array of {kind}"
        ) from None
    if array.shape != shape:
        raise MeasurementError(
            f"expected an array of shape {shape}, found {array.shape}",
            f"{source}: {name}",
            "give one entry for each row, and one column for each component",
        )
    return array.astype(int if integers_only else float)
