"""Thresholds halved and doubled: shadows notice what makes a difference, and the table has every threshold."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Criteria
from pkmodes.loop.diagnosis.criteria import ShapeCriteria
from studies.shadows import Shadowed
from studies.tables import read
from studies.thresholds import defaults, differs, limited, numbers, scaled

RESULTS = Path(__file__).parents[3] / "docs/results/thresholds"
rows = np.array([0.5, 3.0, np.nan])
#: Calculations with a threshold of 2, what they give, and whether they notice 1 and 4.
CALCULATIONS: list[tuple[Callable[[Any], Any], Any, str]] = [
    (lambda t: t > 0.5, True, ""),
    (lambda t: t >= 1.5, True, "half"),
    (lambda t: np.float64(3.0) < t, False, "double"),
    (lambda t: (rows > t).tolist(), [False, True, False], "double"),
    (lambda t: (rows > 10.0 * t).tolist(), [False, False, False], ""),
    (lambda t: 10.0 + t**2 > 13.5, True, "half"),
    (lambda t: np.clip(0.5, t, 8.0) >= 2.0, True, "half"),
    (lambda t: max(5.0, t) - 1.0, 4.0, ""),
    (lambda t: int(0.2 * t), 0, ""),
    (lambda t: 7 // t == 3, True, "half double"),
    (lambda t: [10, 20, 30][: int(t)], [10, 20], "half double"),
    (lambda t: len(range(int(t))), 2, "half double"),
    (lambda t: np.where([True, False], t, 0.0).tolist(), [2.0, 0.0], "half double"),
    (lambda t: float(np.array([1.0, 2.0]) @ (t * np.ones(2))), 6.0, "half double"),
    (lambda t: f"{t:g}", "2", ""),
]


@pytest.mark.parametrize("place", range(len(CALCULATIONS)))
def test_a_shadow_is_noticed_where_another_value_makes_a_difference(place: int) -> None:
    calculate, expected, words = CALCULATIONS[place]
    noticed: set[str] = set()
    assert calculate(2.0) == expected
    assert calculate(Shadowed(2.0, {"half": 1.0, "double": 4.0}, noticed)) == expected
    assert noticed == set(words.split())
    for word, value in {"half": 1.0, "double": 4.0}.items():
        assert word in noticed or calculate(value) == expected or isinstance(expected, str)


def test_another_threshold_applies_for_a_while_where_none_is_given() -> None:
    with defaults({"gate.level": 0.02, "readings.dead[1]": 0.5}):
        assert (Criteria().gate.level, Criteria().readings.dead) == (0.02, (0.3, 0.5))
        assert Criteria().gate.surely == numbers()["gate.surely"]
    assert Criteria().gate.level == 0.01


@pytest.mark.parametrize("sharper", [1.0, 1.6, np.nan])
def test_a_factor_with_which_a_search_would_not_end_is_refused(sharper: float) -> None:
    assert ShapeCriteria(sharper=0.99).sharper == 0.99
    with pytest.raises(PkmodesError, match=rf"a factor below 1, found {sharper:g}: .*ShapeCriteria\.sharper"):
        ShapeCriteria(sharper=sharper)


def test_whole_numbers_remain_whole_and_at_least_one() -> None:
    assert [scaled(3, 0.5), scaled(1, 0.5), scaled(3, 2.0), scaled(0.3, 0.5)] == [2, 1, 6, 0.15]


def test_outcomes_differ_in_words_and_in_values_beyond_a_part_of_their_deviation() -> None:
    said = {
        "verdict": "effect_found",
        "damping": "",
        "classes": [["a"]],
        "rule": "r",
        "values": {"a": [5.0, 1.0]},
    }
    assert differs(said, said | {"values": {"a": [5.04, 0.96]}}) == ""
    assert differs(said, said | {"values": {"a": [5.06, 1.0]}}) == "values"
    assert differs(said, said | {"rule": "other"}) == "rule"
    assert differs(said, said | {"verdict": "adequate", "rule": "other"}) == "verdict"


def test_a_diagnosis_that_does_not_end_is_stopped() -> None:
    with pytest.raises(TimeoutError), limited(0.05):
        all(True for _ in itertools.count())


def test_the_table_has_every_threshold_and_why_it_stays_if_no_case_notices_it() -> None:
    tables = read(RESULTS)
    rows = tables["thresholds"].records()
    assert [(row["threshold"], row["value"]) for row in rows] == [
        (name, f"{value:g}") for name, value in numbers().items()
    ]
    letters = {row["letter"] for row in tables["reasons"].records()}
    for row in rows:
        unchanged = row["half: changed"] == row["double: changed"] == "0"
        letter, _, noticing = row["why it stays"].partition(", ")
        assert bool(letter) is unchanged, row
        assert not unchanged or letter in letters
        assert Path(__file__).with_name(noticing or Path(__file__).name).is_file(), row
