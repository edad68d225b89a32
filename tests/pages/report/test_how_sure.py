"""What is said first of a diagnosis: the place, with its doubt, and nothing surer than the numbers beside it."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from helpers.pages.documentation import ROOT
from helpers.pages.page_reading import NO_BREAK_SPACE, read
from helpers.pages.report_examples import made_up
from pkmodes import read_robot
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, Probabilities
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    Finding,
    Limit,
    Refitted,
    Stability,
    Unseen,
    Value,
)
from pkmodes.pages.plots.places import MARK_COLOURS
from pkmodes.pages.report import report
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.changed import change_headline, change_summary
from pkmodes.pages.report.contrast import contrast_of_parts
from pkmodes.pages.report.diagnosis import verdict_headline
from pkmodes.pages.report.places import marked_elements
from pkmodes.pages.report.report_context import ReportContext

ROBOT = ROOT / "examples" / "tapped_printer" / "robot.toml"
BELTS, WIDTH = "axis_belt_stiffness", "parameter:belt_path.2.belt.width"


def said(result: Diagnosis, setting: ReportContext | None = None) -> dict[str, str]:
    """What is said, by its titles; of several ways, the last."""
    entries = recommended_action(result, setting or ReportContext("", None, None, (), None)).entries
    return {title: " ".join(cell.terminal_text for cell in cells) for title, cells in entries}


def tone(page: str) -> str:
    match = re.search(r'class="summary tone-(\w+)"', page)
    assert match is not None
    return match[1]


def claimed(p: float, **changes: object) -> Diagnosis:
    """A payload that is claimed with a probability."""
    result, _ = made_up(4, 3)
    probabilities = Probabilities(0.0, 1.0 - p, (ClassProbability(("payload",), p),), ())
    return replace(result, probabilities=probabilities, **changes)


@pytest.mark.parametrize(
    ("p", "headline", "colour"),
    [
        (0.25, "Doubtful (25 %): cause found: ", "open"),
        (0.69, "Doubtful (69 %): cause found: ", "open"),
        (0.75, "Cause found: ", "found"),
        (0.99, "Cause found: ", "found"),
    ],
)
def test_the_title_carries_the_doubt(p: float, headline: str, colour: str) -> None:
    result = claimed(p)
    assert verdict_headline(result).startswith(headline)
    page = report(result)
    assert f">{headline}" in page.replace(NO_BREAK_SPACE, " ")
    assert tone(page) == colour


def test_how_sure_says_what_is_more_probable_than_a_doubtful_claim() -> None:
    sentence = "More probable is something that is not among the candidates (75 %)."
    assert sentence in said(claimed(0.25))["how sure"]
    assert "More probable" not in said(claimed(0.75))["how sure"]


def test_the_title_says_that_other_errors_give_another_verdict() -> None:
    """A claim of 99 % that holds only with the errors exactly as stated is in doubt."""
    names = claimed(0.99).effects[0].members
    entries = (Stability("sigma x 0.5", "ambiguous", names), Stability("sigma x 2", "ambiguous", names))
    result = claimed(0.99, stability=entries)
    assert verdict_headline(result).startswith("Cause found: ")
    assert "; with sigma halved or sigma doubled, the verdict changes" in verdict_headline(result)
    assert tone(report(result)) == "open"
    expected = claimed(0.99, stability=(Stability("sigma x 0.5", "unexplained", ()),))
    assert "the verdict changes" not in verdict_headline(expected)
    assert tone(report(expected)) == "found"


CONDITION = "; with sigma halved or sigma doubled, the verdict changes"


@pytest.mark.parametrize(
    ("other_verdict", "condition", "colour"), [("ambiguous", CONDITION, "open"), ("", "", "found")]
)
def test_the_title_of_a_change_says_so_too(other_verdict: str, condition: str, colour: str) -> None:
    names = claimed(0.99).effects[0].members
    changes = ("sigma x 0.5", "sigma x 2") if other_verdict else ()
    entries = tuple(Stability(change, other_verdict, names) for change in changes)
    content = vars(claimed(0.99, stability=entries))
    counterparts = (None,) * len(content["rows"])
    change = Change(**content, states=("before", "after"), changed=True, counterparts=counterparts)
    context = ReportContext("", None, None, (), None)
    assert change_headline(change, context) == f"Changed since before: payload, 0.300 +- 0.010 kg{condition}"
    assert change_summary(change, context).tone == colour


def belts(first: float, second: float, error: float = 0.005) -> Finding:
    """A class of two: the belts are unequal, with these changes and an unknown mean, or one has another width."""
    a = np.array([first, second])
    covariance = 0.1**2 * np.outer(1.0 + a, 1.0 + a) + error**2 * np.eye(2)
    factors = tuple(
        Value(f"effects.{BELTS}.factor_{k}", float(value), float(np.sqrt(covariance[k - 1, k - 1])), "1")
        for k, value in enumerate(a, start=1)
    )
    width = (Value(WIDTH.removeprefix("parameter:"), 8.5e-3, 2e-4, "m"),)
    return Finding(
        BELTS,
        (BELTS, WIDTH),
        factors,
        {BELTS: factors, WIDTH: width},
        1e-9,
        "the belts are not equally stiff",
        covariances={BELTS: tuple(map(tuple, covariance.tolist()))},
    )


def test_of_two_belts_the_softer_one_is_named_in_title_tile_and_picture() -> None:
    """0.70 and 1.00 of the declared stiffness: 30 % less, and 0.70 / 0.85 - 1 = -17.65 % of the mean."""
    robot = read_robot(ROBOT)
    setting = ReportContext("", robot, None, (), None)
    for first, second, soft, other in ((-0.3, 0.0, 1, 2), (0.0, -0.3, 2, 1)):
        result = claimed(0.25, effects=(belts(first, second),), corrected=())
        sentence = f"belt {soft} is 30 % softer than belt {other}"
        assert verdict_headline(result, setting).endswith(f"; {sentence}")
        assert said(result, setting)["inspect"].startswith(
            f"Belt {soft}, which is 30 % softer than belt {other}: "
        )
        page = read(report(result, robot=robot))
        tiles = dict(
            zip((one.text for one in page.all("dt")), (one.text for one in page.all("dd")), strict=False)
        )
        (name,) = (name for name in tiles if "relative to the mean" in name)
        assert f"stiffness of belt {soft} " in name
        assert tiles[name].startswith("\u221217.6")
        assert not [title for title in tiles if "change of the stiffness" in title]
        assert sentence in page.by_id("causes").text
        drawn = {robot.mechanism.drawing.elements[i].name for i in marked_elements(result, robot)}
        assert {f"belt {soft}", "belt 2"} <= drawn
    assert len(MARK_COLOURS) >= 2


def test_belts_that_may_be_equal_are_not_compared() -> None:
    setting = ReportContext("", read_robot(ROBOT), None, (), None)
    assert contrast_of_parts(belts(-0.3, 0.0), setting) is not None
    assert contrast_of_parts(belts(-0.01, 0.0), setting) is None
    assert contrast_of_parts(replace(belts(-0.3, 0.0), covariances={}), setting) is None
    assert contrast_of_parts(belts(-0.3, 0.0), None) is None


def adequate(after: float, headline: str = "") -> Diagnosis:
    result, _ = made_up(4, 3)
    return replace(
        result,
        verdict="adequate",
        effects=(),
        after=None,
        headline=headline,
        undetectable=("frame_compliance",),
        limits={"payload.mass": Limit("payload", 0.1, "kg")},
        refitted=(Refitted("belt.width", 1.0, after, 0.1, 0.1, "m"),),
    )


@pytest.mark.parametrize(
    ("after", "headline", "colour", "title"),
    [
        (1.05, "", "good", "The model is adequate"),
        (0.6, "", "open", "The model is adequate; belt.width was refitted by -40 %"),
        (0.6, "belt.width is 3.4 sigma from its declared value", "open", None),
        (1.05, "belt.width is 3.4 sigma from its declared value", "open", None),
    ],
)
def test_an_adequate_model_with_a_value_far_away_is_amber(
    after: float, headline: str, colour: str, title: str | None
) -> None:
    result = adequate(after, headline)
    assert verdict_headline(result) == (title or f"The model is adequate; {headline}")
    assert tone(report(result)) == colour


def test_nothing_to_inspect_names_what_the_data_cannot_show() -> None:
    assert said(adequate(1.0))["inspect"] == (
        "Nothing: the model explains what was measured. These data cannot show frame_compliance, nor other causes "
        "below their limits."
    )


def sized(chi2: float, *stability: Stability, unseen: Unseen | None = None) -> Diagnosis:
    """A payload of 0.30 +- 0.01 kg by the fit."""
    result = claimed(0.95)
    (value,) = result.effects[0].parameters
    payload = Corrected(value.name, value.value, value.sigma, "kg", 0.0, None, False, unseen)
    assert result.after is not None
    after = type(result.after)(0.002, 0.002, chi2)
    return replace(result, corrected=(payload,), after=after, stability=stability)


def test_a_size_is_no_better_known_than_the_errors_are() -> None:
    same = Stability("sigma x 2", "effect_found", ("payload",))
    none = Stability("sigma x 0.5", "unexplained", ())
    known = "Its size is known to within 3.3 % (one standard deviation"
    assert f"{known})." in said(sized(1.0, same))["how sure"]
    assert (
        f"{known} by the stated errors, which are far larger than the residual)."
        in (said(sized(0.2, same))["how sure"])
    )
    assert "known to" not in said(sized(1.0, same, none))["how sure"]


@pytest.mark.parametrize(
    ("unseen", "what"),
    [
        (Unseen(0.06, "parameter:carriage.length"), "measure carriage.length itself"),
        (Unseen(0.06, "frame_compliance"), "rule out frame_compliance"),
        (Unseen(0.06, "", default="a frame.mass of 50 kg"), "declare frame.mass"),
    ],
)
def test_what_makes_a_size_far_less_sure_is_the_next_measurement(unseen: Unseen, what: str) -> None:
    """0.01 by the fit and 0.06 unseen: 6.1 times as large together."""
    assert said(sized(1.0, unseen=unseen))["measure next"] == (
        f"To know the size better, {what}: these data do not show it, which makes the standard deviation "
        "of payload.mass 6.1 times as large as that of the fit."
    )
    little = replace(unseen, sigma=0.01)
    assert said(sized(1.0, unseen=little))["measure next"].startswith("No next measurement is proposed: ")
