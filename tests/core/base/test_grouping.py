"""Groups of things that are alike."""

from __future__ import annotations

from pkmodes.core.support.grouping import grouped


def near(member: int, other: int) -> bool:
    return abs(member - other) < 2


def test_each_joins_the_first_group_with_one_that_is_like_it() -> None:
    assert grouped([1, 5, 2, 3, 4], near) == [[1, 2, 3, 4], [5]]
    assert grouped([], near) == []


def test_only_the_first_members_are_compared() -> None:
    assert grouped([1, 2, 3, 4], near, compared_members=1) == [[1, 2], [3, 4]]
