"""What to do about a diagnosis: where to look, what it does to the frequencies, how sure, and what to measure."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.examples import EXAMPLES, example
from helpers.diagnoses.verdict_examples import VERDICTS
from helpers.pages.report_examples import diagnosed, made_up
from helpers.runs.shared import Shared
from pkmodes import read_robot, updating
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, PairProbability, Probabilities
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report.action import ADVICE_BY_CAUSE, _match_modes, recommended_action
from pkmodes.pages.report.certainty import PROBABILITY_PHRASES
from pkmodes.pages.report.formatting import to_sentence
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.report_context import ReportContext
from studies import tables

ROOT = Path(__file__).parents[3]
#: Words that are surer than a verdict without a claim.
SURE = re.compile(r"likely|certain|found|is the cause|are the causes")


def said(result: Diagnosis, robot: pkmodes.Robot | None = None) -> dict[str, str]:
    """What is said, by its titles; of several ways, the last."""
    entries = recommended_action(result, ReportContext("", robot, None, (), None)).entries
    return {title: " ".join(cell.terminal_text for cell in cells) for title, cells in entries}


def claiming(*classes: tuple[str, ...], probabilities: Probabilities | None) -> dict[str, str]:
    """What is said of causes that were found."""
    result, _ = made_up(4, 3)
    effects = tuple(Finding(names[0], names, (), dict.fromkeys(names, ()), 1e-9, "") for names in classes)
    return said(replace(result, verdict="effect_found", effects=effects, probabilities=probabilities))


def probable(p: float, *members: str) -> Probabilities:
    return Probabilities(0.0, 1.0 - p, (ClassProbability(members, p),), ())


def test_the_effect_is_the_difference_of_two_robots_and_begins_as_declared(shared: Shared) -> None:
    """The machine as diagnosed, the same with stiff gearboxes, and the robot file as it is."""
    result = example(shared, "closed_loop")
    robot = read_robot(EXAMPLES / "closed_loop" / "robot.toml")
    data = updating.read(EXAMPLES / "closed_loop" / "measured.csv", robot=robot)
    values = {value.name: value.value for value in result.corrected}
    declared = pkmodes.load(robot.source)
    compliant = declared.with_values(values)
    stiff = declared.with_values(
        {name: value for name, value in values.items() if not name.startswith("effects.")}
    )
    models = (declared, stiff, compliant)
    before, without, after = (model.modes(data.points).frequencies[:, 3:9] for model in models)
    partner = np.abs(np.log(after[data.pose] / data.frequency[:, None])).argmin(axis=1)
    changes = (after - without)[data.pose, partner]
    row = int(np.abs(changes).argmax())
    at, mode = data.pose[row], partner[row]
    assert (changes < 0.0).all()
    assert said(result, robot)["effect"] == (
        f"In the model it lowers the frequencies of the {len(data.frequency)} measured modes by up to "
        f"{-changes.min():.1f} Hz. With this and the other refitted values together, mode {mode + 1} at "
        f"{data.labels[at]} goes from "
        f"{before[at, mode]:.3f} Hz as declared to {after[at, mode]:.3f} Hz."
    )


def test_the_numbers_of_the_effect_stand_in_the_table_of_measured_modes(tmp_path: Path) -> None:
    """As cells with the place of the exact number in the JSON."""
    result, robot, data = diagnosed("effect_found", tmp_path)
    setting = ReportContext("", robot, data, (), None)
    shown = dict(recommended_action(result, setting).entries)["effect"]
    numbers = {cell.json_pointer: cell.text for cell in shown if cell.json_pointer}
    rows = mode_table(result, PlottedEvidence.of(result, data), setting).rows
    in_table = {cell.json_pointer: cell.text for cells in rows for cell in cells}
    assert [at.rpartition("/")[2] for at in numbers] == ["before_hz", "after_hz"]
    assert numbers == {at: in_table[at] for at in numbers}


def test_modes_that_a_cause_brings_are_no_change_of_others() -> None:
    """As those of a frame that moves: the sixth mode is not lowered from 156 to 102 Hz."""
    without = np.array([28.1, 35.8, 50.9, 125.5, 140.6, 155.6])
    moved = without * (1.0 + np.array([-3.0, 2.0, -9.0, 1.0, 0.5, -2.0]) * 1e-3)
    after = np.sort([*moved, 95.0, 96.4, 101.7])
    assert _match_modes(after, without) == [(0, 0), (1, 1), (2, 2), (6, 3), (7, 4), (8, 5)]
    lowered = np.array([20.0, 40.0, 60.0, np.nan])
    assert _match_modes(lowered, 2.5 * lowered) == [
        (0, 0),
        (1, 1),
        (2, 2),
    ]  # as many: in their order, however far


def test_a_name_that_begins_a_sentence_keeps_its_small_letter() -> None:
    assert to_sentence("effects.payload.mass may be it") == "effects.payload.mass may be it."
    assert to_sentence("nothing, for once.") == "Nothing, for once."


@pytest.mark.parametrize("verdict", VERDICTS)
def test_nothing_is_surer_than_the_verdict(verdict: str, tmp_path: Path) -> None:
    result, robot, _ = diagnosed(verdict, tmp_path)
    found = said(result, robot)
    assert list(found)[-2:] == ["how sure", "measure next"]
    assert ("effect" in found) == bool(result.effects)
    assert bool(SURE.search(found["how sure"])) == result.settled
    # Each sentence is one: nothing refers to a title, and nothing is empty.
    for text in found.values():
        assert re.fullmatch(r"[A-Z].+\.", text), text


def test_every_remaining_explanation_has_a_place(tmp_path: Path) -> None:
    result, robot, _ = diagnosed("ambiguous", tmp_path)
    titles = [
        title for title, _ in recommended_action(result, ReportContext("", robot, None, (), None)).entries
    ]
    assert titles == ["inspect", "or", "or", "difference", "how sure", "measure next"]


def test_a_probability_has_the_word_that_was_measured_for_it() -> None:
    words = {0.97: "very likely that", 0.8: "likely that", 0.6: "doubtful whether"}
    for p, word in words.items():
        found = claiming(("payload",), probabilities=probable(p, "payload"))["how sure"]
        assert found.startswith(f"It is {word} this is the cause (probability {100 * p:.0f} %).")
    assert "over 99 %" in claiming(("a",), probabilities=probable(0.9999, "a"))["how sure"]
    assert claiming(("a",), probabilities=None)["how sure"].startswith(
        "The tests allow that this is the cause."
    )


def test_a_probability_that_others_share_says_so() -> None:
    shared = claiming(("a",), probabilities=probable(0.95, "a", "b"))["how sure"]
    assert shared.startswith(
        "It is very likely that the cause is this or one other explanation that acts alike (probability 95 % for all "
        "of them together). Of these, the tests of the verdict leave only this."
    )
    of_four = claiming(("a",), probabilities=probable(0.95, "a", "b", "c", "d"))["how sure"]
    assert "this or one of 3 other explanations that act alike (probability 95 % for all of them" in of_four
    whole = claiming(("a", "b"), probabilities=probable(0.95, "b", "a"))["how sure"]
    assert "one of these is the cause (probability 95 %). These data cannot tell which" in whole
    # What the tests claim and the second opinion does not know of.
    assert (
        "doubtful whether this is the cause (probability 0 %)"
        in (claiming(("a",), probabilities=probable(0.95, "b"))["how sure"])
    )


def test_two_causes_are_sure_together() -> None:
    pairs = (PairProbability((("b", "a"),), 0.75), PairProbability((("a", "c"),), 0.2))
    found = claiming(("a",), ("b",), probabilities=Probabilities(0.0, 0.05, (), pairs))
    assert found["how sure"].startswith("It is likely that these are the causes (probability 75 %).")
    assert found["inspect"] == "A."
    assert found["and"] == "B."


def test_a_declared_value_is_to_be_measured_again() -> None:
    robot = read_robot(EXAMPLES / "closed_loop" / "robot.toml")
    result, _ = made_up(4, 3)
    name = "parameter:belt.width"
    effect = Finding(name, (name,), (), {name: ()}, 1e-9, "")
    found = said(replace(result, verdict="effect_found", effects=(effect,)), robot)
    assert found["inspect"] == "The width of each belt: measure or look it up again."


@pytest.mark.parametrize(("count", "rest"), [(6, None), (8, "2 further places: see the explanations below.")])
def test_six_places_are_listed_and_the_rest_is_counted(count: int, rest: str | None) -> None:
    result, _ = made_up(4, 3)
    names = tuple(f"parameter:axis.{k}.leg.stiffness" for k in range(1, count + 1))
    effect = Finding(names[0], names, (), dict.fromkeys(names, ()), 1e-9, "")
    claimed = replace(result, verdict="effect_found", effects=(effect,))
    entries = recommended_action(claimed, ReportContext("", None, None, (), None)).entries
    places = [
        " ".join(cell.terminal_text for cell in cells)
        for title, cells in entries
        if title in ("inspect", "or")
    ]
    assert len(places) == 6 + (rest is not None)
    for k, place in enumerate(places[:6], start=1):
        assert f"axis.{k}.leg.stiffness" in place
    assert places[6:] == ([] if rest is None else [rest])


def test_the_documentation_says_how_often_each_word_is_right() -> None:
    """From the table that the suites wrote: the explanations with a probability from each limit to the next."""
    rows = [
        row
        for row in tables.read(ROOT / "docs/results/probabilities")["probabilities"].records()
        if row["by"] == "largest probability" and row["group"] != "all"
    ]
    rates, above = [], 1.01
    for least, _ in PROBABILITY_PHRASES:
        some = [
            (int(row["cases"]), int(row["right"]))
            for row in rows
            if least <= float(row["group"].partition(" to ")[0]) < above
        ]
        rates.append(round(100 * sum(right for _, right in some) / sum(count for count, _ in some)))
        above = least
    said = f"{rates[0]}, {rates[1]} and {rates[2]} % [were right](../reference/results.md#probabilities)"
    assert said in (ROOT / "docs" / "explanation/diagnosis.md").read_text(encoding="utf-8").replace(
        "\n  ", " "
    )


def test_every_effect_has_advice() -> None:
    """Effects that only dissipate are causes of the damping, which has no action."""
    mechanisms = [read_robot(path).mechanism for path in sorted((ROOT / "robots").glob("*.toml"))]
    names = {
        name
        for mechanism in mechanisms
        for name, effect in mechanism.effects.items()
        if not effect.dissipates
    }
    assert len(names) > 10
    assert names == ADVICE_BY_CAUSE.keys()
