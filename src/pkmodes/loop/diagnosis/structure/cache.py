"""A cache of limited memory for recent results."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Generic, TypeVar

from cachetools import LRUCache

#: Largest memory of all values together [bytes]; a single larger value is still kept.
MAX_MEMORY = 64 * 2**20

T = TypeVar("T")


class ResultCache(Generic[T]):
    """A least-recently-used cache of values, each stored with its size."""

    def __init__(self, max_memory: int = MAX_MEMORY) -> None:
        self._values: LRUCache[Hashable, tuple[T, int]] = LRUCache(
            max_memory, getsizeof=lambda entry: entry[1]
        )

    def __contains__(self, key: Hashable) -> bool:
        return key in self._values

    def __getitem__(self, key: Hashable) -> T:
        return self._values[key][0]

    def keep(self, key: Hashable, value: T, size: int) -> T:
        """Keep a value of a size in bytes, and return it."""
        self._values[key] = value, min(size, int(self._values.maxsize))
        return value
