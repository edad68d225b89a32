"""Between which explanations a further measurement could decide, and how probable each is."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from pkmodes.loop.diagnosis import Candidate
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, PairProbability, Probabilities
from pkmodes.loop.diagnosis.verdict.explanations import explanations


def fit(*causes: str, criterion: float = 0.0, at_bound: tuple[str, ...] = ()) -> Any:
    return SimpleNamespace(
        causes=tuple(Candidate(name, (name,)) for name in causes), criterion=criterion, at_bound=at_bound
    )


def found(
    said: Probabilities | None, left: list[list[Any]], tried: list[Any] | None = None
) -> dict[str, float]:
    """The probabilities by name, the most probable first, where these fits were tried."""
    some = [fit(), *map(fit, "abcdrs"), fit("b", "a"), fit("a", "c")] if tried is None else tried
    store: Any = SimpleNamespace(all_fits=lambda: some, criterion=lambda one: one.criterion)
    named = [[("+".join(cause.name for cause in one.causes), one) for one in group] for group in left]
    return {one.name: one.probability for one in explanations(store, said, named)}


def said(
    nothing: float = 0.0,
    outside: float = 0.0,
    classes: tuple[tuple[str, float], ...] = (),
    pairs: tuple[tuple[str, float], ...] = (),
) -> Probabilities:
    """Probabilities of classes of causes with one letter: ("ab", 0.5); and of pairs: ("ab ac", 0.5)."""
    return Probabilities(
        nothing,
        outside,
        tuple(ClassProbability(tuple(members), p) for members, p in classes),
        tuple(PairProbability(tuple((one[0], one[1]) for one in members.split()), p) for members, p in pairs),
    )


def test_members_of_a_class_share_its_probability_and_outside_takes_no_part() -> None:
    every = said(0.1, 0.3, (("ab", 0.4), ("c", 0.05)), (("ab ac", 0.15),))
    assert found(every, []) == pytest.approx(
        {"a": 0.2, "b": 0.2, "nothing_missing": 0.1, "a + b": 0.075, "a + c": 0.075, "c": 0.05}
    )


def test_members_that_were_not_fitted_predict_nothing() -> None:
    some = [fit(), fit("a"), fit("c", at_bound=("c",))]
    assert found(said(0.2, 0.2, (("abc", 0.6),)), [], some) == pytest.approx(
        {"a": 0.6, "nothing_missing": 0.2}
    )


def test_the_best_fit_of_an_explanation_predicts() -> None:
    some = [fit(), fit("a", criterion=5.0), best := fit("a", criterion=3.0), fit("a", criterion=4.0)]
    store: Any = SimpleNamespace(all_fits=lambda: some, criterion=lambda one: one.criterion)
    (one,) = explanations(store, said(0.0, 0.1, (("a", 0.9),)), [])
    assert one.fit is best


def test_of_a_class_those_count_that_the_verdict_leaves() -> None:
    every = said(0.0, 0.0, (("abc", 0.9), ("d", 0.1)))
    assert found(every, [[fit("c"), fit("a")]]) == pytest.approx({"a": 0.45, "c": 0.45, "d": 0.1})


def test_what_the_verdict_leaves_in_no_class_has_the_probability_of_something_outside() -> None:
    every = said(0.0, 0.3, (("a", 0.7),))
    assert found(every, [[fit("a")], [fit("r")], [fit("s")]]) == pytest.approx(
        {"a": 0.7, "r": 0.15, "s": 0.15}
    )
    # A class of the verdict has one probability for all of its members.
    assert found(every, [[fit("a"), fit("r")]]) == pytest.approx({"a": 0.5, "r": 0.5})


def test_what_is_improbable_counts_only_where_the_verdict_leaves_it() -> None:
    every = said(0.04, 0.0, (("a", 0.9), ("b", 0.02), ("c", 0.04)))
    assert found(every, []) == pytest.approx({"a": 0.9})
    assert found(every, [[fit("a")], [fit("b")]]) == pytest.approx({"a": 0.9, "b": 0.045})
    # A class of many members is as probable as these together.
    assert len(found(said(0.8, 0.1, (("abcd", 0.1),)), [])) == 5


def test_without_probabilities_what_the_verdict_leaves_is_equally_probable() -> None:
    assert found(None, [[fit("a"), fit("b")], [fit("c", "a")]]) == pytest.approx(
        {"a": 1 / 3, "b": 1 / 3, "c+a": 1 / 3}
    )
    assert found(None, []) == {}


def test_at_most_eight_count() -> None:
    letters = "abcdefghij"
    some = [fit(), *map(fit, letters)]
    assert list(found(said(0.0, 0.0, ((letters, 1.0),)), [], some)) == list(letters[:8])
