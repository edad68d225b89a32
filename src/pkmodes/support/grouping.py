"""Groups of things that are alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

T = TypeVar("T")


def grouped(some: Iterable[T], alike: Callable[[T, T], bool], compared: int | None = None) -> list[list[T]]:
    """Return groups in the order of their first members: each thing joins the first group with one that is like it.

    Parameters
    ----------
    alike : callable
        Whether a member of a group and a further thing are alike.
    compared : int, optional
        Number of members of each group that are compared, the first ones; by default all.
    """
    groups: list[list[T]] = []
    for one in some:
        home = next((group for group in groups if any(alike(each, one) for each in group[:compared])), None)
        if home is None:
            groups.append([one])
        else:
            home.append(one)
    return groups
