"""Comparing matrices of a mechanism block by block, where a block belongs to coordinates of one kind each."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

#: Differences of 60 digits leave some 1e-20 of what is zero; no entry of a robot is as small as this.
NOTHING = 1e-16


def kinds(coordinates: Sequence[str]) -> list[np.ndarray]:
    """Indices of coordinates of one kind: those whose names differ in the number or direction only."""
    found: dict[str, list[int]] = {}
    for i, coordinate in enumerate(coordinates):
        stem, separator, _ = coordinate.rpartition("_")
        found.setdefault(stem if separator else "", []).append(i)
    return [np.array(indices) for indices in found.values()]


def worst(found: np.ndarray, expected: np.ndarray, blocks: list[np.ndarray]) -> float:
    """Largest error of any block, relative to the largest entry of the block; a block of zeros is exactly so.

    Block by block, because units differ, and a small effect must not hide behind a large one.
    """
    assert found.shape == expected.shape
    errors = [0.0]
    for rows in blocks:
        for columns in blocks:
            a, b = found[np.ix_(rows, columns)], expected[np.ix_(rows, columns)]
            size = np.abs(b).max()
            if size < NOTHING:
                assert not a.any()
            else:
                errors.append(float(np.abs(a - b).max() / size))
    return max(errors)
