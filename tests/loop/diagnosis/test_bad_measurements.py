"""Outliers and modes that the model lacks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.diagnoses.frame_diagnoses import SIX, causes, checked, drawn, spoiled
from helpers.robots.small_structures import SIGMA, frame
from pkmodes.loop.diagnosis import Measurements
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis


@pytest.mark.parametrize("truth", [{}, {"brace 2": 6.0e4}])
def test_an_outlier_is_set_aside_and_named_by_its_line(truth: dict[str, float]) -> None:
    found = checked(frame(SIX), spoiled(drawn(SIX, 9, truth), 14, 1.08))
    assert found.verdict == ("effect_found" if truth else "adequate")
    assert causes(found) == list(truth)
    assert [row.line for row in found.outliers] == [17]
    assert "line 17 set aside" in found.reason
    assert found.as_json()["outliers"] == [{"pose": "6 kg", "line": 17}]
    if not truth:
        # Its partner is 8 % away; the error is that of the others.
        assert found.refit.rms_relative < 2 * SIGMA


@pytest.mark.parametrize(
    ("common", "excluded", "truth"),
    [(0.0, [14], {"brace 2": 6.0e4}), (0.01, [], {}), (0.01, [], {"brace 2": 1.0e5})],
)
def test_each_cause_each_row_set_aside_and_a_shared_error_take_a_degree_of_freedom(
    common: float, excluded: list[int], truth: dict[str, float]
) -> None:
    data = drawn(SIX, 9, truth)
    shift = np.exp(common * np.random.default_rng(1).standard_normal(6))[data.pose]
    shift[excluded] *= 1.08
    data = replace(data, frequency=data.frequency * shift)
    structure = frame(SIX)
    found = checked(structure, data)
    assert causes(found) == list(truth)
    shared = bool(common and truth)
    assert bool(found.scatter) == shared
    assert ("the modes of a pose share" in found.reason) == bool(common)
    added = tuple(c for c in structure.candidates if c.name in truth)
    fit = Fitter(structure, data).fit(Hypothesis(added, frozenset(excluded), shared))
    assert fit is not None
    degrees = 24 - len(excluded) - len(added) - shared
    assert (found.after or found.refit).chi2_per_dof == pytest.approx(fit.chi2 / degrees, rel=1e-4)


def with_another(data: Measurements, setup: str, frequency: float) -> Measurements:
    f = np.append(data.frequency, frequency)
    return Measurements.from_rows([*(data.labels[i] for i in data.pose), setup], f, SIGMA * f)


def test_a_measured_mode_that_the_model_lacks_is_not_taken_for_a_cause() -> None:
    data = drawn(SIX, 10)
    found = checked(frame(SIX), with_another(data, "4 kg", 0.3 * data.frequency[0]))
    assert not found.effects
    assert found.rows[-1].before is None
    if found.verdict == "adequate":
        assert [row.line for row in found.outliers] == [25]
    else:
        assert [row.line for row in found.unpaired] == [25]


def test_a_row_is_not_set_aside_where_the_model_has_no_mode_left_for_it() -> None:
    """All modes of the pose were measured: a further one is no error of a row, and the model is not adequate."""
    data = drawn(SIX, 10)
    between = np.sqrt(data.frequency[0] * data.frequency[1])
    found = checked(frame(SIX), with_another(data, data.labels[0], between))
    assert found.rule == "adequacy.extra_modes"
    assert not found.effects
    # In place of a mode, the same row may be a gross error of that mode.
    replaced = data.frequency.copy()
    replaced[1] = between
    other = checked(frame(SIX), replace(data, frequency=replaced, sigma=SIGMA * replaced))
    assert other.verdict == "adequate"
    assert [row.line for row in other.outliers] == [2]
