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

from pkmodes.base.errors import PkmodesError, listed, nearest, shown
from pkmodes.mechanism.poses import CheckedPoses, Where

Array = NDArray[Any]
Fields = Iterable[str] | None
Out = Mapping[str, Array] | None


def chosen_fields(fields: Fields, out: Out, known: tuple[str, ...]) -> tuple[str, ...]:
    """Check which fields are requested.

    Parameters
    ----------
    fields : iterable of str, optional
        By default the fields in `out`, or all without `out`.
    out : mapping of str to ndarray, optional
        Arrays to fill, by field.
    known : tuple of str
        All fields.

    Returns
    -------
    tuple of str
        In the order of `known`.

    Raises
    ------
    PkmodesError
        If a field is unknown, no field is requested, or `out` is not a mapping of fields to different arrays.
    """
    if out is not None and not isinstance(out, Mapping):
        raise PkmodesError(
            f"expected arrays by field, found {shown(out)}", "out", f'for example: {{"{known[0]}": array}}'
        )
    if fields is None:
        fields = known if out is None else tuple(out)
    asked = listed(fields, "fields", "fields", f'"{known[0]}"')
    for where, names in (("fields", asked), ("out", list(out or ()))):
        for name in names:
            if not (isinstance(name, str) and name in known):
                raise PkmodesError(f"unknown field {shown(name)}", where, nearest(name, known))
    if not asked:
        raise PkmodesError("expected at least one field, found none", "fields", f"known: {', '.join(known)}")
    for name, array in (out or {}).items():
        _check_out(name, array, asked)
    for (a, first), (b, second) in itertools.combinations((out or {}).items(), 2):
        if np.may_share_memory(first, second) and np.shares_memory(first, second):
            raise PkmodesError(f"{a} and {b} share memory", "out", "give a separate array for each field")
    return tuple(name for name in known if name in asked)


def _check_out(name: str, array: object, asked: list[str]) -> None:
    where = f"out: {name}"
    if name not in asked:
        raise PkmodesError("the field is not requested", where, "add it to fields, or remove it from out")
    if not isinstance(array, np.ndarray):
        raise PkmodesError(
            f"expected an ndarray, found {shown(type(array).__name__)}", where, "use numpy.empty"
        )
    if not array.flags.writeable:
        raise PkmodesError("the array is read-only", where, "give a writable array")


def _check_fits(name: str, array: Array, shape: tuple[int, ...], dtype: np.dtype[Any]) -> None:
    if array.dtype != dtype or array.shape != shape:
        raise PkmodesError(
            f"expected an array of shape {shape} and type {dtype}, "
            f"found shape {array.shape} and type {array.dtype}",
            f"out: {name}",
            f"use numpy.empty({shape}, {dtype})",
        )


def allotted(
    tails: Mapping[str, tuple[int, ...]], batch: tuple[int, ...], out: Out
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Allot arrays of doubles that are filled as a whole.

    Parameters
    ----------
    tails : mapping of str to tuple of int
        Shape of each field at one pose.
    batch : tuple of int
        Shape of the poses.
    out : mapping of str to ndarray, optional
        Arrays of the caller's.

    Returns
    -------
    arrays : dict of str to ndarray, shape (..., *tail)
        The caller's array, or a new one.
    rows : dict of str to ndarray, shape (N, *tail)
        Contiguous: a view of the array, or a stand-in where that is not possible.
    """
    arrays, rows = {}, {}
    for name, tail in tails.items():
        array = None if out is None else out.get(name)
        shape = (*batch, *tail)
        if array is None:
            array = np.empty(shape)
        else:
            _check_fits(name, array, shape, np.dtype(float))
        arrays[name] = array
        whole = array if array.flags.c_contiguous else np.empty(shape)
        rows[name] = whole.reshape(prod(batch), *tail)
    return arrays, rows


class Gathered:
    """Arrays with the leading axes of the caller's poses, filled part by part.

    Parameters
    ----------
    poses : CheckedPoses
    out : mapping of str to ndarray, optional
        Arrays to fill; arrays of other fields are allocated.

    Attributes
    ----------
    arrays : dict of str to ndarray
        By field, (..., *tail); NaN, or -1 in arrays of integers, where a pose is not valid.
    """

    def __init__(self, poses: CheckedPoses, out: Out = None) -> None:
        self._poses, self._out = poses, out or {}
        self.arrays: dict[str, Array] = {}
        self._flat: dict[str, Array | None] = {}

    def put(self, where: Where, values: Mapping[str, Array]) -> None:
        """Store the values of some poses, (n, *tail) each."""
        for name, part in values.items():
            if name not in self.arrays:
                self._begin(name, part)
            flat = self._flat[name]
            if flat is not None:
                flat[where] = part
            elif len(part):  # a non-contiguous array has no flat view of all poses
                places = np.arange(len(self._poses.points))[where]
                self.arrays[name][np.unravel_index(places, self._poses.batch)] = part

    def _begin(self, name: str, part: Array) -> None:
        shape = (*self._poses.batch, *part.shape[1:])
        array = self._out.get(name)
        if array is None:
            array = np.empty(shape, part.dtype)
        else:
            _check_fits(name, array, shape, part.dtype)
        if self._poses.codes.any():
            array[...] = -1 if part.dtype.kind == "i" else np.nan
        flat = array.reshape(len(self._poses.points), *array.shape[len(self._poses.batch) :])
        self.arrays[name] = array
        self._flat[name] = flat if not array.size or np.may_share_memory(flat, array) else None
