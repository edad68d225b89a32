"""The stability of a verdict: errors halved and doubled, whatever was measured and however large they are."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from helpers.robots.small_structures import LOADS, STIFFNESS, frame, frame_measured
from pkmodes.loop.diagnosis import Measurements, diagnose
from pkmodes.loop.diagnosis.verdict import stability


@pytest.fixture(scope="module")
def data() -> Measurements:
    """Of a frame with a brace."""
    return frame_measured(LOADS, {"brace 2": 0.8 * STIFFNESS}, np.random.default_rng(5), shapes=0.01)


@pytest.mark.parametrize("stated", [{"shape_sigma": 0.6}, {"relative": 0.6}, {"damping_sigma": 0.6}])
def test_errors_that_cannot_be_doubled_are_no_mistake_in_the_file(
    data: Measurements, stated: dict[str, float]
) -> None:
    rows = len(data.lines)
    columns = {name: np.full(rows, value) for name, value in stated.items()}
    if "relative" in columns:
        columns = {"sigma": columns["relative"] * data.frequency}
    given = replace(data, damping=np.full(rows, 0.5), **{"damping_sigma": np.full(rows, 0.1), **columns})
    diagnosis = diagnose(frame(LOADS), given, holdout=())
    changes = [entry.change for entry in diagnosis.stability]
    assert changes == ["sigma x 0.5", "sigma x 2", "priors x 2"]


def test_the_errors_of_every_quantity_are_scaled(data: Measurements, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also of one that no prediction is compared with yet."""
    rows = len(data.lines)
    given = replace(data, damping=np.full(rows, 0.02), damping_sigma=np.full(rows, 0.004))
    tried: list[Measurements] = []
    fitter = stability.Fitter

    def recorded(structure: Any, data: Measurements, *arguments: Any, **options: Any) -> Any:
        tried.append(data)
        return fitter(structure, data, *arguments, **options)

    monkeypatch.setattr(stability, "Fitter", recorded)
    diagnose(frame(LOADS), given, holdout=())
    factors = [0.5, 2.0, 1.0]
    assert [one.sigma[0] / given.sigma[0] for one in tried] == factors
    assert [one.damping_sigma[0] / given.damping_sigma[0] for one in tried] == factors
