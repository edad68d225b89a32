"""One thing at one place that no candidate has: found where it is true, and nothing claimed where it is not.

The truth is a chain of masses and springs that the tests assemble with NumPy.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh

from helpers.diagnoses.chains import Frame, at, joined
from helpers.diagnoses.resonators import Resonant, hanging
from helpers.pages.page_reading import read
from pkmodes.loop.diagnosis import Diagnosis, MatrixStructure, Measurements, diagnose
from pkmodes.loop.diagnosis.beyond import term_fits
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.search.score import MAX_DIRECTIONS_CORRELATED, Score, p_of_smallest
from pkmodes.pages.report import report
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.diagnosis import verdict_headline
from pkmodes.pages.report.report_context import ReportContext

FRAME = Frame()
NOTHING = np.zeros((6, 6))
Change = Callable[[int], tuple[np.ndarray, np.ndarray]]


def of(frame: Frame, change: Change, **options: float) -> Diagnosis:
    return diagnose(frame.structure(), frame.measured(change, **options), terms=True)  # type: ignore[arg-type]


def without_errors_of_poses(data: Measurements, factor: np.ndarray) -> Measurements:
    labels = [data.labels[i] for i in data.pose]
    return Measurements.from_rows(labels, data.frequency * factor, data.sigma)


def test_what_is_found_is_the_last_stage_of_its_page() -> None:
    data = FRAME.measured(lambda _: (NOTHING, 2.0e4 * joined(6, 2, 5)))
    result = diagnose(FRAME.structure(), data, terms=True)
    content = result.as_json()
    # Six frequencies at each setup, of masses and springs that the test knows: the noise is 0.15 %.
    predicted = np.array([row["beyond_hz"] for row in content["rows"]])  # type: ignore[attr-defined]
    np.testing.assert_allclose(predicted, data.frequency, rtol=5.0 * 0.0015)
    as_declared = np.array([row["before_hz"] for row in content["rows"]])  # type: ignore[attr-defined]
    assert np.abs(as_declared / data.frequency - 1.0).max() > 10.0 * 0.0015
    page = read(report(result, data=data, title="frame"))
    member = content["beyond"]["classes"][0]["members"][0]  # type: ignore[index]
    *_, last_row = page.by_id("errors").all("tr")
    assert "after: with what was found beyond the catalogue" in last_row.text
    assert float(last_row.all("data")[-1].attributes["value"]) == member["error"]["chi2_per_dof"]
    assert "model with what was found" in page.by_id("rows").text
    assert "In the model it raises the frequencies of" in page.by_id("summary").text
    assert "; without it, the residual is" in result.reason
    row, stage = result.rows[0], result.stages
    assert row.after is None  # the catalogue adds nothing
    assert stage is not None
    assert stage.after is None


@pytest.mark.parametrize(
    ("term", "size", "unit", "change"),
    [
        ("spring:floor 2/floor 5", 2.0e4, "N/m", lambda _: (NOTHING, 2.0e4 * joined(6, 2, 5))),
        ("spring:floor 5", 2.0e4, "N/m", lambda _: (NOTHING, 2.0e4 * joined(6, 5))),
        ("mass:floor 4", 1.5, "kg", lambda _: (1.5 * at(6, 4), NOTHING)),
    ],
)
def test_the_true_term_is_found_with_its_value(term: str, size: float, unit: str, change: Change) -> None:
    found = of(FRAME, change)
    assert found.verdict == "unexplained"
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule, found.beyond.tried) == ("found", "beyond.found", 27)
    beyond = found.as_json()["beyond"]
    assert isinstance(beyond, dict)
    (group,) = beyond["classes"]
    (member,) = group["members"]
    assert member["term"] == term
    assert member["plausible"]
    quantity = "mass" if unit == "kg" else "stiffness"
    assert {*member["parameters"]} == {quantity}
    value = member["parameters"][quantity]
    assert value["unit"] == unit
    assert value["value"] == pytest.approx(size, abs=3.0 * value["sigma"])
    assert value["sigma"] < 0.2 * size
    assert group["p_value"] < 1e-6
    assert group["probability"] == 1.0
    # The errors are the noise: 0.15 %.
    assert member["error"]["rms_relative"] == pytest.approx(0.0015, rel=0.35)
    assert member["error"]["held_out_rms_relative"] == pytest.approx(0.0015, rel=0.8)
    assert member["error"]["chi2_per_dof"] == pytest.approx(1.0, abs=0.5)
    words = f"Not in the catalogue: {member['sentence']}, "
    assert found.reason.startswith(words)
    setting = ReportContext("frame", None, None, (), None)
    assert verdict_headline(found).startswith(words)
    assert recommended_action(found, setting).entries[0][1][0].text == f"Look for {member['sentence']}."


def test_a_term_is_found_in_which_the_linear_model_sees_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """None is among the most promising by its score: the largest of several sizes tells."""
    monkeypatch.setattr(term_fits, "MAX_TERMS_BY_SCORE", 0)
    found = of(FRAME, lambda _: (1.5 * at(6, 4), NOTHING))
    assert found.beyond is not None
    assert found.beyond.found is not None
    assert found.beyond.found.finding.name == "mass:floor 4"


def test_a_fit_that_goes_astray_is_begun_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """The linear estimate of every term is a thousand times too large."""
    monkeypatch.setattr(term_fits, "MAX_TERMS_BY_SIZE", 0)
    monkeypatch.setattr(term_fits, "SMALL_CHANGE", np.inf)
    linear = term_fits._Explorer._values_with_step

    def far(self: term_fits._Explorer, plain: Fit, one: Score) -> np.ndarray:
        return linear(self, plain, replace(one, step=1e3 * one.step))

    monkeypatch.setattr(term_fits._Explorer, "_values_with_step", far)
    found = of(FRAME, lambda _: (NOTHING, 2.0e4 * joined(6, 2, 5)))
    assert found.beyond is not None
    assert found.beyond.found is not None
    assert found.beyond.found.finding.name == "spring:floor 2/floor 5"


def test_terms_are_tried_only_where_asked_for() -> None:
    data = FRAME.measured(lambda _: (1.5 * at(6, 4), NOTHING))
    assert diagnose(FRAME.structure(), data).beyond is None


def test_nothing_is_tried_where_nothing_is_missing_or_the_data_are_mistaken_or_too_few() -> None:
    complete = FRAME.measured(lambda _: (NOTHING, NOTHING))
    found = diagnose(FRAME.structure(), complete, terms=True)
    assert (found.verdict, found.beyond) == ("adequate", None)
    assert found.as_json()["beyond"] is None
    in_radians = without_errors_of_poses(complete, np.full(len(complete.frequency), 2.0 * np.pi))
    found = diagnose(FRAME.structure(), in_radians, terms=True)
    assert (found.verdict, found.beyond) == ("unexplained", None)
    few = Measurements.from_rows(["S1"] * 2, complete.frequency[:2] * (1.0, 1.1), complete.sigma[:2])
    found = diagnose(FRAME.structure(), few, terms=True)
    assert (found.verdict, found.beyond) == ("insufficient_data", None)


def law(data: Measurements, size: float, function: np.ndarray) -> Measurements:
    return without_errors_of_poses(data, 1.0 + size * (function - function.mean()) / np.std(function))


def test_nothing_is_claimed_for_what_no_term_has() -> None:
    """Laws of the frequency, of time, of a storey over time, of each mode, two places at once, and no law at all."""
    plain = FRAME.measured(lambda _: (NOTHING, NOTHING))
    rng, count = np.random.default_rng(1), len(plain.frequency)
    cases = {
        "frequency": law(plain, 0.01, np.log(plain.frequency)),
        "time": law(plain, 0.01, plain.pose.astype(float)),
        "each mode": law(plain, 0.01, np.tile(rng.standard_normal(6), count // 6)),
        "anything": law(plain, 0.01, rng.standard_normal(count)),
        "one storey over time": FRAME.measured(lambda k: (NOTHING, 2e4 * (k - 3) * joined(6, 2, 3))),
        "two places": FRAME.measured(lambda _: (1.5 * at(6, 3), 2e4 * joined(6, 2, 5))),
    }
    for name, data in cases.items():
        found = diagnose(FRAME.structure(), data, terms=True)
        assert found.verdict == "unexplained", name
        assert found.beyond is not None, name
        assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.nothing"), name
        assert found.beyond.classes == (), name
        assert not found.reason.startswith("Not in the catalogue"), name


def test_where_only_the_shapes_are_unexplained_the_reason_says_so() -> None:
    """A mass, and shapes whose errors are twice as large as stated."""
    rng, setups, logs, shapes = np.random.default_rng(3), list[str](), list[float](), list[np.ndarray]()
    for setup in FRAME.setups:
        M, K = FRAME.matrices({"mass": 1.002, "storey": 1.02}, setup)
        squares, modes = eigh(K, M + 1.5 * at(6, 4))
        modes /= np.abs(modes).max(axis=0)
        setups += [setup] * 6
        logs += (0.5 * np.log(squares) + 0.0015 * rng.standard_normal(6)).tolist()
        shapes += list((modes + 0.04 * rng.standard_normal(modes.shape)).T)
    frequency = np.exp(logs) / (2.0 * np.pi)
    components = dict(zip(FRAME.names, np.transpose(shapes), strict=True))
    data = Measurements.from_rows(setups, frequency, 0.0015 * frequency, shapes=components, shape_sigma=0.02)
    found = diagnose(FRAME.structure(), data, terms=True)
    assert found.beyond is not None
    assert found.beyond.rule == "beyond.nothing"
    assert "(mass:floor 4), leaves frequencies as measured, but not shapes (p < 1e-6)" in found.beyond.reason


def test_of_two_places_at_once_what_is_left_points_to_the_other() -> None:
    """The second one is small: the first leaves noise, but noise that has its direction."""
    found = of(FRAME, lambda _: (1.5 * at(6, 3), 2.8e3 * joined(6, 2, 5)))
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.leaves_more")


def test_an_error_that_the_modes_of_a_setup_share_refuses_a_term() -> None:
    plain = FRAME.measured(lambda _: (NOTHING, NOTHING), seed=2)
    found = diagnose(FRAME.structure(), law(plain, 0.004, plain.pose.astype(float)), terms=True)
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.errors")


class Clamped(Frame):
    """A frame that is the same from both ends: the last floor is held by a storey too."""

    def matrices(self, values: object, setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = super().matrices(values, setup)  # type: ignore[arg-type]
        return M, K + 4e5 * values["storey"] * joined(self.floors, self.floors)  # type: ignore[index]


def test_places_that_have_the_same_frequencies_are_one_class() -> None:
    frame = Clamped(5, ((3, 0.0), (3, 4.0), (3, 8.0), (3, 12.0), (3, 16.0), (3, 20.0), (3, 24.0)))
    found = of(frame, lambda _: (1.5 * at(5, 2), np.zeros((5, 5))))
    assert found.beyond is not None
    assert found.beyond.status == "found"
    (group,) = found.beyond.document().classes
    assert {member.term for member in group.members} == {"mass:floor 2", "mass:floor 4"}
    for member in group.members:
        value = member.parameters["mass"]
        assert value.value == pytest.approx(1.5, abs=3.0 * value.sigma)
    assert "narrowed to two: a mass at floor 2, or a mass at floor 4" in verdict_headline(found)


def test_of_terms_that_explain_equally_little_all_are_named() -> None:
    frame = Clamped(5, tuple((3, 4.0 * k) for k in range(7)))
    plain = frame.measured(lambda _: (1.5 * at(5, 2), np.zeros((5, 5))))
    found = diagnose(frame.structure(), law(plain, 0.004, np.arange(35.0) % 5 == 2), terms=True)
    assert found.beyond is not None
    assert found.beyond.rule == "beyond.nothing"
    assert "the best, a mass at floor 2 (mass:floor 2) or a mass at floor 4 (mass:floor 4), leaves" in (
        found.beyond.reason
    )


def lowest(data: Measurements, modes: int, count: int) -> Measurements:
    """Return the lowest of `count` modes of each setup."""
    rows = np.flatnonzero(np.arange(len(data.frequency)) % count < modes)
    labels = [data.labels[i] for i in data.pose[rows]]
    return Measurements.from_rows(labels, data.frequency[rows], data.sigma[rows])


def test_too_many_places_are_not_found() -> None:
    """Two modes of a long chain do not tell where a mass is."""
    frame = Clamped(9, tuple((5, 4.0 * k) for k in range(8)))
    whole = frame.measured(lambda _: (3.0 * at(9, 2), np.zeros((9, 9))))
    found = diagnose(frame.structure(), lowest(whole, 2, 9), terms=True)
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("several", "beyond.several")
    (group,) = found.beyond.document().classes
    assert len(group.members) > 5
    assert {"mass:floor 2", "mass:floor 8"} <= {member.term for member in group.members}


def test_few_modes_tell_no_term_from_what_no_term_has() -> None:
    """A change of three modes is matched by some of ninety terms, whatever caused it."""
    frame = Clamped(12, tuple((7, 4.0 * k) for k in range(8)))
    whole = frame.measured(lambda _: (4.0 * at(12, 2), np.zeros((12, 12))))
    found = diagnose(frame.structure(), lowest(whole, 3, 12), terms=True)
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.not_specific")


class Usual(MatrixStructure):
    """A structure on whose floors nothing heavier than half a kilogram is usual."""

    def with_terms(self) -> MatrixStructure:
        extended = super().with_terms()
        extended.parameters = tuple(
            replace(p, usual=(0.0, 0.5)) if p.name.endswith(".mass") else p for p in extended.parameters
        )
        return extended


def test_a_class_of_nothing_but_implausible_values_is_not_found() -> None:
    data = FRAME.measured(lambda _: (1.5 * at(6, 4), NOTHING))
    found = diagnose(FRAME.structure(Usual), data, terms=True)
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.implausible")
    assert "0 to 0.5 kg is plausible" in found.beyond.reason


def test_one_row_carries_no_claim() -> None:
    frame = Frame(6, ((1, 0.0), (2, 4.0), (3, 8.0), (5, 4.0)))
    whole = frame.measured(lambda _: (NOTHING, NOTHING))
    rows = np.array([row for row in range(len(whole.frequency)) if row % 6 < 2 or row == 5])
    factor = np.where(rows == 5, 1.02, 1.0)
    data = Measurements.from_rows(
        [whole.labels[i] for i in whole.pose[rows]], whole.frequency[rows] * factor, whole.sigma[rows]
    )
    found = diagnose(frame.structure(), data, terms=True, holdout=[])
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.one_row")


@pytest.mark.parametrize("count", [5, MAX_DIRECTIONS_CORRELATED + 50])
@pytest.mark.parametrize("p", [0.01, 1e-4])
def test_the_p_value_counts_all_that_was_tried(count: int, p: float) -> None:
    """Of n independent directions, the smallest p-value is at most p with the probability 1 - (1 - p)^n."""
    directions = [(column[:, None], 0) for column in np.eye(count)]
    expected = 1.0 - (1.0 - p) ** count
    assert p_of_smallest(directions, p) == pytest.approx(
        expected, abs=4.0 * np.sqrt(expected / 20_000) + 1e-9
    )


def test_a_law_that_explains_as_much_refuses_a_term() -> None:
    """Of two modes, all frequencies alike that vary with frequency are what a mass on one floor does."""
    frame = Frame(2, tuple((1, 0.0) for _ in range(7)))
    found = of(frame, lambda _: (0.6 * at(2, 1), np.zeros((2, 2))))
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.law")
    assert "all frequencies alike, if it varied with frequency" in found.beyond.reason


def test_a_term_that_does_not_predict_the_held_out_setup_is_refused() -> None:
    found = of(FRAME, lambda k: (0.0 * NOTHING if k == 3 else 1.5 * at(6, 4), NOTHING))
    assert found.held_out_poses == ("S4",)
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.rule) == ("none", "beyond.held_out")


@pytest.mark.parametrize("frequency", [12.0, 33.0])
def test_a_resonator_is_found_by_the_mode_that_it_adds(frequency: float) -> None:
    """It starts from many frequencies: its mode, which the model lacks, is unmatched or takes the place of others."""
    data = FRAME.measured(lambda _: hanging(FRAME, 5, 0.8, frequency))
    found = diagnose(Resonant(FRAME), data, terms=True)
    assert found.verdict == "unexplained"
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.tried) == ("found", 6)
    (member,) = found.beyond.document().classes[0].members
    assert member.term == "resonator:floor 5"
    for name, truth in (("mass", 0.8), ("frequency", frequency)):
        value = member.parameters[name]
        assert value.value == pytest.approx(truth, abs=3.0 * value.sigma)
        assert value.sigma < 0.1 * truth
