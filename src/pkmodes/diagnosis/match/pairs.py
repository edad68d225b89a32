"""Pairs of measured rows of one setup, without looking at those of others."""

from __future__ import annotations

from collections.abc import Iterator

from pkmodes.diagnosis.problem import Index


def pairs_of_setups(pose: Index, order: Index) -> Iterator[tuple[Index, Index]]:
    """Yield all pairs of rows of the same setup: those next to each other in an order first.

    The time grows with the number of rows times the largest number of them in one setup.

    Parameters
    ----------
    pose : ndarray of int, shape (R,)
        Setup of each row.
    order : ndarray of int, shape (R,)
        The rows, those of each setup together.

    Yields
    ------
    a, b : ndarray of int
        The first and the second row of each pair; a row is in each of them once at most.
    """
    for step in range(1, len(order)):
        a, b = order[:-step], order[step:]
        same = pose[a] == pose[b]
        if not same.any():
            return
        yield a[same], b[same]
