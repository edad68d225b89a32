"""The fields of a map with its axes, from the rows that were computed: in memory, or as Dask arrays if stored."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from math import prod
from typing import Any
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.solve.fields import EVERY, MODE, of_maps
from pkmodes.maps.tracking import Tracked

Array = NDArray[Any]
#: Poses of a stored map that are read and written together.
CHUNK = 16_384


def fields_of(
    arrays: Mapping[str, Any], shape: tuple[int, ...], reasons: Array, tracked: Tracked | None = None
) -> dict[str, Any]:
    """Return the fields of a map.

    Parameters
    ----------
    arrays : mapping of str to ndarray or zarr.Array, shape (rows, ...)
        The fields of `pkmodes.maps.layout.tails`; stored ones become Dask arrays, so that a map can be written
        without having it in memory.
    shape : tuple of int
        Of the map; rows are in C order.
    reasons : ndarray of str
        By code.
    tracked : Tracked, optional
        Modes by shape instead of by rank.
    """
    fields = {name: _spaced(arrays[name], shape) for name in arrays}
    codes = fields.pop("code")
    fields["valid"] = _each(lambda part: part == 0, np.dtype(bool), codes)
    fields["reason"] = _each(reasons.__getitem__, reasons.dtype, codes)
    return fields if tracked is None else fields | _tracked(fields, tracked, shape)


def chunks_of(shape: tuple[int, ...], leading: int) -> tuple[int, ...]:
    """Return the size of the parts of a field: all values at about `CHUNK` poses next to each other."""
    chunks, left = list(shape), CHUNK
    for axis in reversed(range(leading)):
        chunks[axis] = min(shape[axis], max(left, 1))
        left //= shape[axis]
    return tuple(chunks)


def _spaced(values: Any, shape: tuple[int, ...]) -> Any:
    """Return a field with the leading axes of the map."""
    whole = (*shape, *values.shape[1:])
    if isinstance(values, np.ndarray):
        return values.reshape(whole)
    from dask.array import map_blocks
    from dask.array.core import normalize_chunks

    dtype = np.dtype(values.dtype.str)  # Zarr names the byte order, which netCDF4 takes for another one

    def part(block_info: Any) -> Array:
        """Read the rows of a part, which are next to each other."""
        starts, sizes = zip(*[(a, b - a) for a, b in block_info[None]["array-location"]], strict=True)
        first, count = np.ravel_multi_index(starts[: len(shape)], shape), prod(sizes[: len(shape)])
        return np.asarray(values[first : first + count], dtype).reshape(sizes)

    chunks = normalize_chunks(chunks_of(whole, len(shape)), whole)
    meta = np.empty((0,) * len(whole), dtype)
    # A name of its own: by default Dask would make one of the rows themselves.
    return map_blocks(part, name=f"rows-{uuid4()}", chunks=chunks, dtype=dtype, meta=meta)


def _lazy(whole: Array, shape: tuple[int, ...]) -> Any:
    """Return an array in parts, for fields that are stored."""
    from dask.array import from_array

    return from_array(whole, chunks=chunks_of(whole.shape, len(shape)), name=False)


def _each(function: Callable[..., Array], dtype: np.dtype[Any], *fields: Any) -> Any:
    """Apply a function to fields, part by part if they are stored."""
    if isinstance(fields[0], np.ndarray):
        return function(*fields)
    from dask.array import map_blocks

    like = max(fields, key=lambda field: field.ndim)
    return map_blocks(
        function, *fields, dtype=dtype, chunks=like.chunks, meta=np.empty((0,) * like.ndim, dtype)
    )


def _tracked(fields: Mapping[str, Any], tracked: Tracked, shape: tuple[int, ...]) -> dict[str, Any]:
    """Return the fields of modes in the tracked order, and those that only a tracked map has."""
    valid = fields["valid"][..., None]
    order, signs, events = (
        values.reshape(*shape, -1) for values in (tracked.order, tracked.signs, tracked.events)
    )
    if not isinstance(valid, np.ndarray):
        order, signs, events = (_lazy(values, shape) for values in (order, signs, events))
    reordered = {}
    for field in of_maps(EVERY):
        values = fields.get(field.variable)
        if values is None or field.dims[:1] != (MODE,):
            continue
        further = (..., *[None] * (len(field.dims) - 1))
        factors = (signs[further],) if field.signed else ()
        along = partial(_reordered, axis=-len(field.dims))
        reordered[field.variable] = _each(along, values.dtype, values, order[further], *factors)
    reordered["rank"] = _each(
        lambda places, good: np.where(good, places + 1, 0).astype(np.int8), np.dtype(np.int8), order, valid
    )
    reordered["tracking"] = events
    return reordered


def _reordered(values: Array, places: Array, factors: Array | None = None, *, axis: int) -> Array:
    """Return values of modes in another order, multiplied by factors if there are any.

    Parameters
    ----------
    places, factors : ndarray
        Of length 1 along axes after that of the modes.
    axis : int
        That of the modes.
    """
    ordered = np.take_along_axis(values, places, axis=axis)
    return ordered if factors is None else ordered * factors
