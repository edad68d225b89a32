"""Held-out setups take no part in any choice or fit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.diagnoses.frame_diagnoses import SIX, TWO, checked, drawn
from helpers.robots.small_structures import SIGMA, frame, some_rows
from pkmodes.core.base.errors import PkmodesError
from pkmodes.diagnosis import MatrixStructure, Measurements, Parameter, diagnose


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
    data = drawn(SIX, 14, {"brace 2": 6.0e4}, shapes=0.02)
    held = data.pose == 2
    rng = np.random.default_rng(0)
    shapes = np.where(held[:, None], rng.standard_normal(data.shapes.shape), data.shapes)
    other = replace(data, shapes=shapes)
    plain, changed = (checked(frame(SIX), d, [data.labels[2]]).as_json() for d in (data, other))
    for one in (plain, changed):
        one["rows"] = [row for row in one["rows"] if not row["held_out"]]
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
