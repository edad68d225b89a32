"""Fields of a result: which are requested, and arrays that are filled part by part.

Poses are evaluated in parts that fit the cache, and each part is stored at once, so the memory needed is that of
the result and one part.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import is_all
from pkmodes.core.base.errors import PkmodesError, checked_list, nearest_name, shown
from pkmodes.core.mechanism.poses import PoseIndices
from pkmodes.core.solve.fields import missing_value

Array = NDArray[Any]
#: Names of fields, or the word "all".
FieldNames = Iterable[str] | None
OutArrays = Mapping[str, Array] | None


def chosen_fields(fields: FieldNames, out: OutArrays, available: tuple[str, ...]) -> tuple[str, ...]:
    """Check which fields are requested.

    - fields: by default the fields in `out`, or all without `out`; the word "all" for all
    - out: arrays to fill, by field
    - available: all fields

    Returns them in the order of `available`.
    Raises PkmodesError if a field is unknown, no field is requested, or `out` is not a mapping of fields to different
    arrays.
    """
    if out is not None and not isinstance(out, Mapping):
        raise PkmodesError(
            f"expected arrays by field, found {shown(out)}",
            "out",
            f'for example: {{"{available[0]}": array}}',
        )
    if is_all(fields):
        fields = available
    elif fields is None:
        fields = available if out is None else tuple(out)
    elif isinstance(fields, str) and fields not in available:
        raise PkmodesError(f"unknown field {shown(fields)}", "fields", nearest_name(fields, available))
    requested = checked_list(fields, "fields", "fields", f'"{available[0]}"')
    for where, names in (("fields", requested), ("out", list(out or ()))):
        for name in names:
            if not (isinstance(name, str) and name in available):
                raise PkmodesError(f"unknown field {shown(name)}", where, nearest_name(name, available))
    if not requested:
        raise PkmodesError(
            "expected at least one field, found none", "fields", f"known: {', '.join(available)}"
        )
    for name, array in (out or {}).items():
        where = f"out: {name}"
        if name not in requested:
            raise PkmodesError("the field is not requested", where, "add it to fields, or remove it from out")
        if not isinstance(array, np.ndarray):
            raise PkmodesError(
                f"expected an ndarray, found {shown(type(array).__name__)}", where, "use numpy.empty"
            )
        if not array.flags.writeable:
            raise PkmodesError("the array is read-only", where, "give a writable array")
    for (a, first), (b, second) in itertools.combinations((out or {}).items(), 2):
        if np.may_share_memory(first, second) and np.shares_memory(first, second):
            raise PkmodesError(f"{a} and {b} share memory", "out", "give a separate array for each field")
    return tuple(name for name in available if name in requested)


class FieldArrays:
    """Arrays with the leading axes of the caller's poses, filled part by part.

    - batch: shape of the poses
    - out: arrays of the caller's to fill; arrays of other fields are allocated
    - deferred: whether the caller's arrays are left unchanged until `finish`
    - filled_with_nan: whether arrays begin with NaN, or -1 in arrays of integers, instead of anything
    - pose_shapes: shape at one pose, and type, of fields to create at once

    Its attributes:
    - arrays: by field, each (..., *tail)
    - rows: what to fill, contiguous, each (N, *tail): a view of the array, or a stand-in until `finish`
    """

    def __init__(
        self,
        batch: tuple[int, ...],
        out: OutArrays = None,
        *,
        deferred: bool = False,
        filled_with_nan: bool = False,
        pose_shapes: Mapping[str, tuple[tuple[int, ...], Any]] | None = None,
    ) -> None:
        self._batch, self._out, self._deferred, self._filled_with_nan = (
            batch,
            out or {},
            deferred,
            filled_with_nan,
        )
        self.arrays: dict[str, Array] = {}
        self.rows: dict[str, Array] = {}
        self._stand_ins: list[str] = []
        for name, (shape, dtype) in (pose_shapes or {}).items():
            self.add(name, shape, dtype)

    def add(self, name: str, pose_shape: tuple[int, ...], dtype: Any = float) -> None:
        """Add a field with its shape at one pose."""
        shape = (*self._batch, *pose_shape)
        array = self._out.get(name)
        if array is None:
            array = filled = np.empty(shape, dtype)
        else:
            if array.dtype != np.dtype(dtype) or array.shape != shape:
                raise PkmodesError(
                    f"expected an array of shape {shape} and type {np.dtype(dtype)}, "
                    f"found shape {array.shape} and type {array.dtype}",
                    f"out: {name}",
                    f"use numpy.empty({shape}, {np.dtype(dtype)})",
                )
            filled = array
            if self._deferred or not array.flags.c_contiguous:
                filled = np.empty(shape, dtype)
                self._stand_ins.append(name)
        self.arrays[name], self.rows[name] = array, filled.reshape(prod(self._batch), *pose_shape)
        if self._filled_with_nan:
            filled[...] = missing_value(filled.dtype)

    def put(self, indices: PoseIndices, values: Mapping[str, Array]) -> None:
        """Store the values of some poses, (n, *tail) each; fields are added when they first occur."""
        for name, rows in values.items():
            if name not in self.rows:
                self.add(name, rows.shape[1:], rows.dtype)
            self.rows[name][indices] = rows

    def finish(self) -> dict[str, Array]:
        """Copy stand-ins to where they belong, and return the arrays."""
        for name in self._stand_ins:
            self.arrays[name][...] = self.rows[name].reshape(self.arrays[name].shape)
        return self.arrays
