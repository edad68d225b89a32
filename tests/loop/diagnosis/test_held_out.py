"""Held-out setups take no part in any choice or fit, and refuse a result that does not predict them.

First frames, then structures whose frequencies' logarithms are linear in the parameters: of these, every prediction
error is known.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from helpers.diagnoses.frame_diagnoses import SIX, TWO, checked, drawn
from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    directions,
    errors,
    frame,
    of_signatures,
    some_rows,
    with_changes,
)
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Diagnosis, MatrixStructure, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.one_state import split_setups
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.held_out import p_held_out


def test_held_out_setups_are_not_used() -> None:
    data = drawn(SIX, 14, {"brace 2": 6.0e4})
    held = np.isin(data.pose, [1, 4])
    f = np.where(held, 1.002 * data.frequency, data.frequency)  # other errors, as large as stated
    other = replace(data, frequency=f)
    holdout = [data.labels[1], data.labels[4]]
    plain, changed = (checked(frame(SIX), d, holdout).as_json() for d in (data, other))
    assert plain["held_out_poses"] == holdout
    assert plain["verdict"] == "effect_found"
    for stage in ("before", "refit", "after"):
        own, others = plain["error"][stage], changed["error"][stage]
        assert own.pop("held_out_rms_relative") != others.pop("held_out_rms_relative")
    assert [row["held_out"] for row in plain["rows"]] == held.tolist()
    for one in (plain, changed):
        one["rows"] = [row for row in one["rows"] if not row["held_out"]]
    assert plain == changed
    # The fit is that of the other setups alone.
    alone = checked(frame(SIX), some_rows(data, ~held)).as_json()
    for key in ("effects", "refitted", "undetectable", "candidates"):
        assert alone[key] == plain[key]


def test_the_held_out_error_shows_that_a_cause_predicts() -> None:
    data = drawn(SIX, 15, {"brace 2": 6.0e4})
    found = checked(frame(SIX), data, None)
    assert len(found.held_out_poses) == 1
    assert found.verdict == "effect_found"
    assert found.after.held_out_rms_relative < 0.5 * found.refit.held_out_rms_relative
    assert found.after.held_out_rms_relative < 3 * SIGMA


def test_shapes_of_held_out_setups_are_not_used() -> None:
    """Nothing but what is told of the held-out rows: with other shapes these have no partners."""
    data = drawn(SIX, 14, {"brace 2": 6.0e4}, shapes=0.02)
    held = data.pose == 2
    rng = np.random.default_rng(0)
    shapes = np.where(held[:, None], rng.standard_normal(data.shapes.shape), data.shapes)
    other = replace(data, shapes=shapes)
    plain, changed = (checked(frame(SIX), d, [data.labels[2]]).as_json() for d in (data, other))
    for one in (plain, changed):
        held_lines = {row["line"] for row in one["rows"] if row["held_out"]}
        one["rows"] = [row for row in one["rows"] if not row["held_out"]]
        one["unpaired"] = [place for place in one["unpaired"] if place["line"] not in held_lines]
        one["notes"] = [note for note in one["notes"] if "held-out" not in note]
        for stage in one["error"].values():
            del stage["held_out_rms_relative"]
    assert plain == changed


def test_holding_out_unknown_or_all_setups_is_refused() -> None:
    data = drawn(TWO, 16)
    with pytest.raises(PkmodesError, match=r'no pose is called "laoded".*loaded'):
        diagnose(frame(TWO), data, holdout=["laoded"])
    with pytest.raises(PkmodesError, match="every pose is held out"):
        diagnose(frame(TWO), data, holdout=["empty", "loaded"])
    assert diagnose(frame(TWO), data, holdout=["loaded", "loaded"]).held_out_poses == ("loaded",)


def test_a_structure_that_is_unstable_as_declared_is_refused() -> None:
    def matrices(values, _):
        return np.eye(2), np.array([[1.0, 2.0], [2.0, 1.0 + values["k"]]])

    leaning = MatrixStructure([Parameter("k", 0.0)], [], matrices, channels=["a", "b"])
    data = Measurements.from_rows(["A"] * 2, [1.0, 2.0], [0.01, 0.01])
    with pytest.raises(PkmodesError, match="cannot be evaluated with its declared values"):
        diagnose(leaning, data)


SETUPS, MODES = 12, 5
HELD = ["P0", "P1"]
DIRECTIONS = directions(SETUPS * MODES, 6)
FITTED = np.repeat(np.arange(SETUPS) >= 2, MODES)


def structure(
    signatures: Mapping[str, np.ndarray], prior: float | None = None, remote: str = ""
) -> LogLinear:
    """One cause for each signature, and an uncertain value with the last direction."""
    uncertain = {} if prior is None else {"k": DIRECTIONS[5]}
    roles, known = {remote: {"remote": True}}, {"k": {"sigma": prior}}
    return of_signatures({**signatures, **uncertain}, SETUPS, MODES, roles=roles, known=known)


def found(model: LogLinear, change: np.ndarray, holdout: list[str] = HELD) -> Diagnosis:
    return diagnose(model, with_changes(model, change + errors(SETUPS * MODES)), holdout=holdout)


def alike() -> tuple[np.ndarray, np.ndarray]:
    """Two signatures that agree in the fitted setups, and in the held-out ones only in size."""
    a = DIRECTIONS[0] * np.where(FITTED, 1.0, 1.5)
    return a, np.where(FITTED, a, -a)


@pytest.mark.parametrize("prior", [None, 4.0])
def test_the_prediction_errors_have_their_predictive_covariance(prior: float | None) -> None:
    """Against the same number from two least-squares fits, by the normal equations and the priors as rows."""
    rng = np.random.default_rng(8)
    model = structure({"a": DIRECTIONS[0], "b": DIRECTIONS[1]}, prior)
    change = 20.0 * DIRECTIONS[0] + 2.0 * rng.standard_normal(SETUPS * MODES)
    data = with_changes(model, change)
    fitted, held = split_setups(data, HELD)
    fitter = Fitter(model.subset(fitted), data.at(fitted))
    search = Search(FitStore(fitter), model.candidates)
    hypothesis = Hypothesis((model.candidates[0],))
    final = search.store.fit(hypothesis)
    assert final is not None
    p_value = p_held_out(AllSetups(model, data, fitter, held), Fitter(model, data), hypothesis, final)

    columns = [DIRECTIONS[0]] if prior is None else [DIRECTIONS[5], DIRECTIONS[0]]
    rows = np.stack(columns, axis=1)
    own = np.zeros((0, 1)) if prior is None else np.array([[1.0 / prior, 0.0]])

    def squares(some: np.ndarray) -> float:
        A, y = np.vstack([rows[some], own]), np.append(change[some], np.zeros(len(own)))
        return float(((y - A @ np.linalg.lstsq(A, y)[0]) ** 2).sum())

    grown = squares(np.ones(SETUPS * MODES, dtype=bool)) - squares(FITTED)
    assert p_value == pytest.approx(stats.chi2.sf(grown, len(HELD) * MODES), rel=1e-4)
    assert p_value < 0.05  # errors twice as large as stated


def test_a_claim_that_does_not_predict_the_held_out_poses_is_refused() -> None:
    a, c = alike()
    plain = found(structure({"a": a, "b": DIRECTIONS[1]}), 40.0 * a)
    assert [effect.name for effect in plain.effects] == ["a"]
    contradicted = found(structure({"a": a, "b": DIRECTIONS[1]}), 40.0 * c)
    assert (contradicted.verdict, contradicted.rule) == ("unexplained", "claims.held_out")
    assert "a would explain the fitted poses, but not the held-out ones (p" in contradicted.reason
    assert contradicted.effects == ()


def test_the_reason_names_a_special_cause_that_explains_all_poses() -> None:
    a, c = alike()
    diagnosis = found(structure({"a": a, "b": DIRECTIONS[1], "c": c}, remote="c"), 40.0 * c)
    assert diagnosis.verdict == "unexplained"
    assert diagnosis.reason.endswith("c would explain all poses: look there")
    # With the same data and other poses held out, it is named as well.
    others = found(structure({"a": a, "b": DIRECTIONS[1], "c": c}, remote="c"), 40.0 * c, ["P7", "P9"])
    assert others.verdict == "unexplained"
    assert "c would" in others.reason


def test_a_gross_error_in_one_held_out_row_is_reported_and_two_are_not_excused() -> None:
    a = DIRECTIONS[0]
    model = structure({"a": a, "b": DIRECTIONS[1]})
    one = 40.0 * a
    one[3] += 25.0
    diagnosis = found(model, one)
    assert [effect.name for effect in diagnosis.effects] == ["a"]
    assert any("line 4 (held-out P0" in note and "check it" in note for note in diagnosis.notes)
    two = one.copy()
    two[7] -= 25.0
    assert found(model, two).verdict == "unexplained"


def test_a_model_that_does_not_predict_the_held_out_poses_is_not_adequate() -> None:
    model = structure({"a": DIRECTIONS[0], "b": DIRECTIONS[1]})
    assert found(model, np.zeros(SETUPS * MODES)).verdict == "adequate"
    moved = found(model, np.where(FITTED, 0.0, 6.0))
    assert moved.verdict == "unexplained"
    assert "the declared model explains the fitted poses, but not the held-out ones" in moved.reason


def test_choices_and_fits_do_not_use_the_held_out_poses() -> None:
    """Values and p-values of a claim are the same whatever the held-out poses are, as long as they agree with it."""
    a = DIRECTIONS[0]
    model = structure({"a": a, "b": DIRECTIONS[1]})
    rng = np.random.default_rng(1)
    first, second = (
        found(model, 40.0 * a + np.where(FITTED, 0.0, 0.5 * rng.standard_normal(SETUPS * MODES)))
        for _ in range(2)
    )
    assert first.effects == second.effects
    assert first.refit is not None
    assert second.refit is not None
    assert first.refit.held_out_rms_relative != second.refit.held_out_rms_relative
