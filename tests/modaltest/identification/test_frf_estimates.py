"""Functions of impacts from signals that a state-space simulation gives exactly."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.identification.frf_estimates import impact_estimate, remove_window_damping
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes_rig.structures.forced import impact, mac, structure

RATE = 2048.0
OUTPUTS = [0, 1, 2]


@pytest.fixture(scope="module")
def blow() -> tuple[object, np.ndarray, np.ndarray]:
    s = structure(np.array([40.0, 90.0, 700.0]), np.array([0.01, 0.006, 0.02]), np.random.default_rng(1))
    return s, *impact(s, OUTPUTS, 0, 2, RATE, 4.0)


@pytest.mark.parametrize("tau", [None, 0.4])
def test_a_window_of_the_responses_is_taken_off_the_damping(blow, tau: float | None) -> None:
    s, force, y = blow
    rng = np.random.default_rng(2)
    y = y + 1e-3 * np.abs(y).max(axis=0) * rng.standard_normal(y.shape)
    if tau:
        y = y * np.exp(-np.arange(len(y)) / RATE / tau)[:, None]
    e = impact_estimate(1.0 / RATE, force, y, window_time_constant=tau)
    assert e.messages == ()
    modes = identify_frf(
        e.frequencies, e.H, band=(10.0, 400.0), derivative_order=2, window_time_constant=tau
    ).modes
    assert [m.frequency for m in modes] == pytest.approx([40.0, 90.0], rel=3e-4)
    assert [m.damping for m in modes] == pytest.approx([0.01, 0.006], rel=0.03)
    assert all(mac(m.shape, s.shapes[OUTPUTS, k]) > 0.999 for k, m in enumerate(modes))


def test_a_pole_without_its_window() -> None:
    assert remove_window_damping(-5.0 + 100.0j, 0.5) == -3.0 + 100.0j
    assert remove_window_damping(-5.0 + 100.0j, None) == -5.0 + 100.0j


def test_a_decay_that_the_record_cuts_off_is_exact(blow) -> None:
    _, force, y = blow
    e = impact_estimate(1.0 / RATE, force[:1500], y[:1500])
    modes = identify_frf(e.frequencies, e.H, band=(10.0, 400.0), derivative_order=2).modes
    assert [m.frequency for m in modes] == pytest.approx([40.0, 90.0], rel=1e-4)
    assert [m.damping for m in modes] == pytest.approx([0.01, 0.006], rel=0.02)


def test_blows_of_a_file_are_averaged_with_coherence(blow) -> None:
    _, force, y = blow
    rng = np.random.default_rng(3)
    all_force, all_y = np.tile(force, 4), np.tile(y, (4, 1))
    all_y = all_y + 0.01 * np.abs(y).max(axis=0) * rng.standard_normal(all_y.shape)
    e = impact_estimate(1.0 / RATE, all_force, all_y, hits=4)
    assert e.averages == 4
    assert e.coherence is not None
    at = int(np.argmin(np.abs(e.frequencies - 40.0)))
    assert e.coherence[at, 0, 0] > 0.95
    with pytest.raises(MeasurementError, match="expected 2 blows, found 1"):
        impact_estimate(1.0 / RATE, force, y, hits=2)


def test_double_hits_are_said(blow) -> None:
    _, force, y = blow
    twice = force + 0.4 * np.roll(force, 60)
    assert any("double hit" in m for m in impact_estimate(1.0 / RATE, twice, y).messages)
