"""Constraints on arguments: what counts as a number or a name, and the sentence for everything else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.arguments import (
    FILE_NAME,
    NATURAL_NUMBER,
    POSITIVE_INTEGER,
    POSITIVE_NUMBER,
    alternatives,
    check_argument,
    one_of,
)
from pkmodes.core.base.errors import OutputError, PkmodesError

SVG_OR_PNG = one_of(["svg", "png"])


CONSTRAINTS = [
    *[(POSITIVE_INTEGER, value, True) for value in (1, 10**30, np.int8(3), np.uint64(7))],
    *[(POSITIVE_INTEGER, value, False) for value in (0, -1, True, np.True_, 1.0, "1", None, np.array([1]))],
    *[(NATURAL_NUMBER, value, True) for value in (0, np.int64(0))],
    *[(NATURAL_NUMBER, value, False) for value in (-1, False, 0.0, [])],
    *[(POSITIVE_NUMBER, value, True) for value in (1, 1e-300, np.float32(0.5), np.int16(2), float("inf"))],
    *[(POSITIVE_NUMBER, value, False) for value in (0, -1.5, True, 1j, "1", float("nan"), None)],
    *[(FILE_NAME, value, True) for value in ("map.nc", Path("map.nc"))],
    *[(FILE_NAME, value, False) for value in (b"map.nc", 5, None, ["map.nc"])],
    *[(SVG_OR_PNG, value, True) for value in ("svg", "png")],
    *[(SVG_OR_PNG, value, False) for value in ("SVG", "", None, ["svg"], {})],
]


def test_a_constraint_holds_for_what_its_words_say(subtests: pytest.Subtests) -> None:
    for constraint, value, holds in CONSTRAINTS:
        with subtests.test(f"{constraint}, {value}, {holds}"):
            assert bool(constraint.holds(value)) is holds


def test_the_sentence_says_what_was_expected_what_was_given_and_what_to_do() -> None:
    with pytest.raises(PkmodesError) as error:
        check_argument(True, POSITIVE_INTEGER, "threads", "leave it out for all cores")
    assert str(error.value) == "expected a positive integer, found true (threads); leave it out for all cores"
    with pytest.raises(OutputError, match='expected svg or png, found "gif"'):
        check_argument("gif", SVG_OR_PNG, "formats", "choose one of the two", OutputError)


def test_words_are_enumerated() -> None:
    assert [alternatives(words) for words in (["a"], ["a", "b"], ["a", "b", "c"])] == [
        "a",
        "a or b",
        "a, b or c",
    ]
