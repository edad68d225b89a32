"""Labels stand in the order in which people count."""

from __future__ import annotations

import pytest

from pkmodes.core.support.ordering import joined, listed, natural_order, sorted_labels


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (["P10", "P2", "P1"], ["P1", "P2", "P10"]),
        (["+0.5 mm", "-0.5 mm", "+1.0 mm", "+0.0 mm"], ["-0.5 mm", "+0.0 mm", "+0.5 mm", "+1.0 mm"]),
        (["18.4 N", "4.6 N", "8.2 N"], ["4.6 N", "8.2 N", "18.4 N"]),
        (["row 2 left", "row 10 left", "row 2 right"], ["row 2 left", "row 2 right", "row 10 left"]),
        (["front", "centre", "P1"], ["front", "centre", "P1"]),  # no number: the order of the file
        (["9 mm", "10 m"], ["9 mm", "10 m"]),
        ([], []),
    ],
)
def test_the_order(given: list[str], expected: list[str]) -> None:
    assert sorted_labels(given) == expected
    assert sorted(natural_order(given)) == list(range(len(given)))


def test_equal_labels_keep_their_order() -> None:
    assert natural_order(["1.0 mm", "1 mm", "0 mm"]) == [2, 0, 1]


def test_a_list_in_a_sentence_says_how_many_it_leaves_out() -> None:
    assert [listed(["a", "b", "c"], most) for most in (1, 2, 3)] == [
        "a and 2 more",
        "a, b and 1 more",
        "a, b, c",
    ]
    assert listed(["a", "b", "c"], 2, "; ", "; and ") == "a; b; and 1 more"
    assert listed([], 2) == ""


def test_all_names_in_a_sentence() -> None:
    assert [joined(["a", "b", "c"][:count]) for count in range(4)] == ["", "a", "a and b", "a, b and c"]
    assert joined(["a", "b", "c"], "or") == "a, b or c"
