"""Pairs of measured rows of the same setup, without visiting pairs across setups."""

from __future__ import annotations

from collections.abc import Iterator

from pkmodes.loop.diagnosis.problem import Index


def pairs_of_setups(pose: Index, order: Index) -> Iterator[tuple[Index, Index]]:
    """Yield all pairs of rows of the same setup: those next to each other in an order first.

    The time grows as the number of rows times the largest number of rows in a setup.

    - pose: setup of each row, (R,)
    - order: the rows, those of each setup together, (R,)

    Yields a and b: the first and the second rows of the pairs; a row occurs at most once in each array.
    """
    for step in range(1, len(order)):
        a, b = order[:-step], order[step:]
        is_same_setup = pose[a] == pose[b]
        if not is_same_setup.any():
            return
        yield a[is_same_setup], b[is_same_setup]
