"""What the data can show: one value in the JSON, the table and the list; why the best explanation is not claimed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy import stats

from helpers.diagnoses.examples import example
from helpers.diagnoses.verdict_examples import VERDICTS
from helpers.pages.page_reading import read
from helpers.pages.report_examples import diagnosed
from helpers.pages.without_drawing import without_drawing
from helpers.robots.small_structures import log_linear, logs_measured
from helpers.runs.shared import Shared
from pkmodes.loop.diagnosis import Candidate, Diagnosis, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.search.score import Score, Scores
from pkmodes.loop.diagnosis.verdict.detectable import examine_candidates
from pkmodes.loop.diagnosis.verdict.findings import Examined
from pkmodes.pages.report import report

#: p-value of a score that no chance explains.
SIGNIFICANT = 1e-3


@pytest.fixture(scope="module")
def voron(shared: Shared) -> Diagnosis:
    return example(shared, "voron")


@pytest.fixture(scope="module", params=VERDICTS)
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Diagnosis, str]:
    result, robot, data = diagnosed(request.param, tmp_path_factory.mktemp("made"))
    with without_drawing():
        return result, report(result, robot=robot, data=data)


def by_name(result: Diagnosis) -> Mapping[str, Examined]:
    return {one.name: one for one in result.candidates}


def expect_no_contradiction(result: Diagnosis) -> None:
    """What is called not detectable has no limit, and is part of no explanation that some text names."""
    limited = {limit.candidate for limit in result.limits.values() if limit.value is not None}
    assert not limited & set(result.undetectable)
    assert not {name for entry in result.stability for name in entry.effects} & set(result.undetectable)
    for one in result.candidates:
        assert one.detectable or not one.visible_from, one.name


def expect_one_value(result: Diagnosis) -> None:
    expect_no_contradiction(result)
    shown = {name for effect in result.effects for name in effect.members}
    shown |= {name for group in result.survivors for each in group for name in each.split(" + ")}
    tested = by_name(result)
    assert set(result.undetectable) >= {name for name, one in tested.items() if not one.detectable}
    assert not set(result.undetectable) & {name for name, one in tested.items() if one.detectable}
    for name, one in tested.items():
        assert one.detectable or (one.p_value > SIGNIFICANT and name not in shown), name


def test_every_verdict_calls_the_same_candidates_detectable(made: tuple[Diagnosis, str]) -> None:
    result, html = made
    expect_one_value(result)
    assert {limit.candidate for limit in result.limits.values() if limit.value is None} >= set(
        result.undetectable
    )
    content: Any = result.as_json()
    assert {one["name"]: one["detectable"] for one in content["candidates"]} == {
        name: one.detectable for name, one in by_name(result).items()
    }
    if result.candidates:
        said = [item.text for item in read(html).by_id("candidates").all("li")]
        assert said == content["undetectable"]


def test_a_candidate_to_which_the_residual_points_is_detectable_although_it_would_have_to_be_large(
    voron: Diagnosis,
) -> None:
    expect_one_value(voron)
    tension = by_name(voron)["belt_tension_stiffness"]
    assert tension.p_value < 1e-100
    assert tension.detectable
    assert "belt_tension_stiffness" not in voron.undetectable


def test_the_best_explanation_that_is_not_claimed_is_named_with_the_reason_why(voron: Diagnosis) -> None:
    assert voron.verdict == "unexplained"
    assert "points to no candidate" not in voron.reason
    left = voron.reason.partition("; the best explanation, ")[2]
    assert left.startswith(
        "that the stiffness of the belts increases with their tension (belt_tension_stiffness) and the frame moves: "
    )
    assert "is not claimed: it leaves a residual 2.1 times as large as the stated errors" in left


@pytest.mark.parametrize(
    ("file", "beside"), [("measured", "frame_compliance.compliance_x"), ("preloads", "frame_compliance")]
)
def test_what_the_reason_points_to_is_never_called_undetectable(
    file: str, beside: str, shared: Shared
) -> None:
    """The reason names two causes, of which the second shows only beside the first."""
    found = example(shared, "voron", file)
    named = {name for name in by_name(found) if re.search(rf"{re.escape(name)}(?!\.?\w)", found.reason)}
    assert named == {"belt_tension_stiffness", beside}
    assert not named & set(found.undetectable)


def test_gravity_does_not_seem_significant_at_a_size_that_no_machine_has(shared: Shared) -> None:
    """Its signature is nearly that of a mass: the unbounded score has p = 5e-16, at ten times g."""
    found = example(shared, "closed_loop")
    expect_one_value(found)
    gravity = by_name(found)["parameter:gravity.z"]
    assert (gravity.detectable, gravity.visible_from) == (False, ())
    assert gravity.p_value > 0.01


#: A parameter whose score asks for 8 standard deviations.
Z = 8.0


def one_examined(
    most: float,
    *,
    z: float = Z,
    shown: bool = False,
    lower: float = -np.inf,
    limited: bool = True,
) -> Examined:
    """One candidate of unit standard deviation, plausible up to some size."""
    candidate = Candidate("a", ("a",))
    model = log_linear(np.random.default_rng(1), 4, 3, [Parameter("a", 0.0, lower=lower)], [candidate])
    fitter = Fitter(model, logs_measured(model.base, 0.002))
    p = float(stats.norm.sf(z) if np.isfinite(lower) else stats.chi2.sf(z**2, 1))
    one = Score(candidate, p, z**2, np.array([z]), np.ones(1), np.array([1e-3]), is_visible=True)
    scores = Scores((one,), ())
    known = {True: {"a"}, False: set[str]()}
    (found,) = examine_candidates(
        fitter,
        scores,
        scores,
        {0: most},
        named=known[shown],
        limited=known[limited],
        unbounded=known[not limited],
    )
    return found


def test_the_score_is_that_of_the_best_plausible_change() -> None:
    """The sum of squares at the size t is (z - t)^2 above its least."""
    assert one_examined(9.0).p_value == pytest.approx(stats.chi2.sf(Z**2, 1))
    for t in (0.5, 1.0, 3.0):
        gain = Z**2 - (Z - t) ** 2
        assert one_examined(t).p_value == pytest.approx(stats.chi2.sf(gain, 1), rel=1e-12)
        assert one_examined(t, lower=0.0).p_value == pytest.approx(stats.norm.sf(np.sqrt(gain)), rel=1e-12)


@pytest.mark.parametrize(
    ("most", "z", "limited", "detectable", "visible"),
    [
        (100.0, 0.1, True, True, True),  # it is not seen, and bounded
        (100.0, 8.0, True, True, True),  # it is seen
        (4.0, 0.1, True, True, False),  # bounded, but five standard deviations would not be plausible
        (4.0, 0.1, False, False, False),  # nothing is known of it
        (100.0, 8.0, False, True, False),  # it is seen, however large it is
        (0.5, 8.0, False, False, False),  # what is seen is not plausible
    ],
)
def test_only_a_plausible_change_counts(
    most: float, z: float, limited: bool, detectable: bool, visible: bool
) -> None:
    found = one_examined(most, z=z, limited=limited)
    assert (found.detectable, bool(found.visible_from)) == (detectable, visible)


def test_a_member_of_a_claimed_class_is_detectable_but_visible_from_no_implausible_size() -> None:
    found = one_examined(4.0, z=0.1, shown=True, limited=False)
    assert (found.detectable, found.visible_from) == (True, ())


def test_a_candidate_that_the_data_do_not_bound_is_visible_from_no_size() -> None:
    found = one_examined(100.0, z=0.1, limited=False)
    assert (found.detectable, found.visible_from) == (False, ())
