"""A cache of limited size for recent results."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable
from typing import Generic, TypeVar

#: Largest memory of all values together [bytes]; a single larger value is kept.
MEMORY = 64 * 2**20

T = TypeVar("T")


class Kept(Generic[T]):
    """A least-recently-used cache.

    Parameters
    ----------
    memory : int, optional
        Largest memory of all values together [bytes].
    """

    def __init__(self, memory: int = MEMORY) -> None:
        self._memory, self._taken = memory, 0
        self._values: OrderedDict[Hashable, tuple[T, int]] = OrderedDict()

    def __contains__(self, key: Hashable) -> bool:
        return key in self._values

    def __getitem__(self, key: Hashable) -> T:
        self._values.move_to_end(key)
        return self._values[key][0]

    def keep(self, key: Hashable, value: T, size: int) -> T:
        """Keep a value of a size in bytes, and return it."""
        self._taken += size - (self._values.pop(key)[1] if key in self._values else 0)
        self._values[key] = value, size
        while self._taken > self._memory and len(self._values) > 1:
            self._taken -= self._values.popitem(last=False)[1][1]
        return value
