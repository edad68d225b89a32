"""The map from a model's coordinates to the channels where shapes are measured."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.diagnosis.problem import Array

REMEDY = "give each channel a row and each coordinate of the model a column"


def sensor_map(channels: Sequence[str], coordinates: Sequence[str] | None, sensors: Any) -> Array | None:
    """Return the matrix that maps the coordinates of a model to the channels.

    Parameters
    ----------
    coordinates : sequence of str, optional
        Names of the n coordinates, if the channels are some of them.
    sensors : array_like or sparse matrix, shape (C, n), optional
        Motion of each channel for unit motions of the coordinates.

    Returns
    -------
    ndarray, shape (C, n), or None
        None if the channels are all coordinates in order.

    Raises
    ------
    PkmodesError
        If both are given, a channel is not a coordinate, or the map is not a matrix of numbers.
    """
    if sensors is None:
        if coordinates is None or tuple(coordinates) == tuple(channels):
            return None
        for name in channels:
            if name not in coordinates:
                known = ", ".join(coordinates[:20]) + (", ..." if len(coordinates) > 20 else "")
                what = f"the channel {shown(name)} is not one of the {len(coordinates)} coordinates"
                raise PkmodesError(
                    what, "channels", f"coordinates are: {known}; for other places, use sensors="
                )
        place = {name: i for i, name in enumerate(coordinates)}
        columns = [place[name] for name in channels]
        return np.eye(len(coordinates))[columns]
    if coordinates is not None:
        what = "expected sensors or coordinates, found both"
        raise PkmodesError(what, "sensors", "leave out one of them")
    try:
        matrix = sensors.toarray() if hasattr(sensors, "toarray") else np.asarray(sensors)
    except (TypeError, ValueError) as error:
        raise PkmodesError(f"expected a matrix, found {shown(str(error))}", "sensors", REMEDY) from error
    if matrix.ndim != 2 or matrix.shape[0] != len(channels):
        what = f"expected one row for each channel ({len(channels)}), found the shape {matrix.shape}"
        raise PkmodesError(what, "sensors", REMEDY)
    if matrix.dtype.kind not in "biuf" or not np.isfinite(matrix).all():
        raise PkmodesError("expected finite real numbers", "sensors", REMEDY)
    found: Array = matrix.astype(float)
    empty = np.flatnonzero(~found.any(axis=1))
    if empty.size:
        what = f"the channel {shown(channels[empty[0]])} measures nothing: its row is zero"
        raise PkmodesError(what, "sensors", "remove it or correct its row")
    return found
