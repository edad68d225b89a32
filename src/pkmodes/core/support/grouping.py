"""Groups of things that are alike."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

T = TypeVar("T")


def grouped(
    elements: Iterable[T], alike: Callable[[T, T], bool], compared_members: int | None = None
) -> list[list[T]]:
    """Return groups in the order of their first members: each element joins the first group with a member like it.

    - alike: whether a member of a group and a further element are alike
    - compared_members: number of members of each group that are compared, the first ones; by default all
    """
    groups: list[list[T]] = []
    for element in elements:
        matching = next(
            (group for group in groups if any(alike(member, element) for member in group[:compared_members])),
            None,
        )
        if matching is None:
            groups.append([element])
        else:
            matching.append(element)
    return groups
