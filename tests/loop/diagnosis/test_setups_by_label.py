"""Setups of structures given by callables: matched by label, and structures that name none."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.robots.small_structures import (
    LOADS,
    altered,
    frame,
    frame_derivatives,
    frame_matrices,
    frame_measured,
    some_rows,
)
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, compare, diagnose, update


def test_the_order_of_setups_is_that_of_the_labels_not_of_the_rows() -> None:
    data = frame_measured(LOADS, {}, np.random.default_rng(0))
    reverse = some_rows(data, np.arange(8)[::-1])
    plain, turned = compare(frame(LOADS), data), compare(frame(LOADS), reverse)
    assert [row.predicted for row in turned.rows] == [row.predicted for row in plain.rows[::-1]]
    assert turned.chi2_per_dof == pytest.approx(plain.chi2_per_dof)
    assert plain.p_value > 1e-3
    # Setups that were not measured are ignored; missing ones are refused.
    assert compare(frame({"spare": 9.0, **LOADS}), data).rms_relative == plain.rms_relative
    with pytest.raises(PkmodesError, match=r'no setup "loaded", which was measured.*setups are: "empty"'):
        compare(frame({"empty": 0.0}), data)


def nameless() -> MatrixStructure:
    plain = frame(LOADS, only=["brace 2", "brace 3"])
    matrices = frame_matrices(4, LOADS)
    return altered(
        plain, lambda values, _: matrices(values, "empty"), derivatives=frame_derivatives(4), setups=("",)
    )


@pytest.mark.parametrize("label", ["today", "P1"])
def test_a_structure_without_labels_is_measured_under_any(label: str) -> None:
    data = frame_measured({label: 0.0}, {}, np.random.default_rng(0))
    assert compare(nameless(), data).p_value > 1e-3
    assert update(nameless(), data).p_value > 1e-3
    braced = frame_measured({label: 0.0}, {"brace 2": 1.5e5}, np.random.default_rng(0), shapes=0.01)
    result = diagnose(nameless(), braced)
    assert [found.name for found in result.effects] == ["brace 2"]
    assert {row.pose for row in result.rows} == {label}


def test_a_structure_without_labels_is_not_measured_under_several() -> None:
    data = frame_measured(LOADS, {}, np.random.default_rng(0))
    with pytest.raises(PkmodesError, match="2 setups were measured, but the structure names none") as error:
        compare(nameless(), data)
    assert error.value.remedy == 'pass setups=["empty", "loaded"] to MatrixStructure'
