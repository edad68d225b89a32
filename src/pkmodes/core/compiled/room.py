"""Room for one pose and its results in memory, so that a call needs no new arrays and looks up no addresses."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.loader import Library, Request

Array = NDArray[np.float64]
#: Lanes for one pose: every processor has so many, more take longer, and the results are the same.
NARROWEST = 2


class Room:
    """A request for one pose with arrays that stay where they are; for one thread at a time.

    Parameters
    ----------
    library : Library
    robot : Request
        With one robot; what its addresses point to must outlive the room.
    size : int
        Components of a pose.
    tails : mapping of str to tuple of int
        Shape at one pose of each field of `pkmodes.core.compiled.lanes.FIELDS` that is wanted.

    Attributes
    ----------
    arrays : dict of str to ndarray, shape (1, *tail)
        What `run` has filled, by field.
    """

    def __init__(
        self, library: Library, robot: Request, size: int, tails: Mapping[str, tuple[int, ...]]
    ) -> None:
        self._pose, self._codes = np.empty((1, size)), np.empty(1, dtype=np.int8)
        self.arrays = {name: np.empty((1, *tail)) for name, tail in tails.items()}
        self._request = Request.from_buffer_copy(robot)
        self._request.count = 1
        self._request.poses, self._request.codes = self._pose.ctypes.data, self._codes.ctypes.data
        for name, array in self.arrays.items():
            setattr(self._request, name, array.ctypes.data)
        self._run, self._address = library.run, ctypes.addressof(self._request)

    def run(self, point: Array) -> int:
        """Evaluate a pose, (1, d), and return its code, as `pkmodes.core.compiled.evaluator.Evaluator.run` does."""
        self._pose[...] = point
        self._run(self._address, NARROWEST)
        return int(self._codes[0])
