"""A tone among the measured modes: it is no mode, and no cause explains it."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes import read_robot, updating
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes_rig import POSES, read, true_modes

POINTS, MODES = POSES["published"]["scattered"][:7], 5
CAUSE = {"gearbox_compliance.compliance": 4e-4}


def diagnosed(tones: list[tuple[int, float]], effects: dict[str, float]) -> Diagnosis:
    """Five modes at seven poses with errors of 0.2 %, motors held, and lines at poses."""
    rng, q = np.random.default_rng(5), read("published").parameters
    rows = []
    for k, p in enumerate(POINTS):
        modes = true_modes(q, p, effects, held=True)
        rows += [(k, f * (1.0 + 0.002 * rng.normal())) for f in modes.frequencies[:MODES]]
    rows += tones
    pose, frequency = (np.array(column) for column in zip(*rows, strict=True))
    data = Measurements.from_rows(
        pose, frequency, 0.002 * frequency, points=[POINTS[k] for k in pose], drives="held"
    )
    return updating.diagnose(read_robot("robots/linear-delta-2022.toml"), data, terms=False)


@pytest.fixture(autouse=True)
def in_the_repository(monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> None:
    monkeypatch.chdir(request.config.rootpath)


def test_a_tone_beside_a_cause_is_set_aside_and_the_cause_named() -> None:
    found = diagnosed([(1, 84.0)], CAUSE)
    assert found.verdict == "effect_found", found.reason
    assert [effect.name for effect in found.effects] == ["gearbox_compliance"]
    assert [row.measured for row in found.outliers] == [84.0]
    assert "set aside" in found.reason


def test_more_rows_than_one_in_thirty_are_not_set_aside() -> None:
    found = diagnosed([(0, 84.0), (2, 76.0), (4, 90.0)], CAUSE)
    assert not found.effects


def test_without_a_tone_nothing_is_set_aside() -> None:
    found = diagnosed([], CAUSE)
    assert [effect.name for effect in found.effects] == ["gearbox_compliance"]
    assert not found.outliers
