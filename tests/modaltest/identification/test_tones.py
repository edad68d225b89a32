"""Lines without bandwidth, told apart from lightly damped modes."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from pkmodes.modaltest.identification.tones import find_tones, subtract_tones
from pkmodes_rig.structures.driven import ambient, structure

BAND = (10.0, 200.0)


def tone(frequency: float, seconds: float = 40.0) -> NDArray[np.float64]:
    return np.sin(2 * np.pi * frequency * np.arange(int(seconds * 1000)) / 1000.0 + 0.3)[:, None]


@pytest.mark.parametrize("frequency", [20.0, 49.987, 150.013])
def test_a_tone_in_noise_is_found_to_a_fraction_of_a_line(frequency: float) -> None:
    noise = np.random.default_rng(5).normal(size=(40000, 2))
    (found,) = find_tones(1e-3, [noise + 0.3 * tone(frequency)], BAND)
    assert found.frequency == pytest.approx(frequency, abs=0.003)
    assert "not a mode" in found.message


@pytest.mark.parametrize("seed", range(6))
def test_lightly_damped_modes_are_no_tones(seed: int) -> None:
    rng = np.random.default_rng(seed)
    system = structure(np.array([12.0, 31.0, 120.0]), np.array([0.003, 0.002, 0.001]), rng)
    assert not find_tones(1e-3, [ambient(system, rng)], BAND)


def test_a_weak_tone_beside_a_strong_one_is_found() -> None:
    noise = np.random.default_rng(6).normal(size=(40000, 2))
    found = find_tones(1e-3, [noise + tone(50.0) + 0.8 * tone(50.47)], BAND)
    np.testing.assert_allclose([one.frequency for one in found], [50.0, 50.47], atol=0.005)


def test_given_tones_and_their_multiples_are_taken_where_they_are() -> None:
    noise = np.random.default_rng(7).normal(size=(40000, 2))
    found = find_tones(1e-3, [noise + tone(49.9)], BAND, [50.0])
    assert [round(one.frequency) for one in found] == [50, 100, 150, 200]
    assert found[0].frequency == pytest.approx(49.9, abs=0.03)


def test_subtraction_leaves_the_noise() -> None:
    noise = np.random.default_rng(8).normal(size=(40000, 2))
    pieces = [noise + 5.0 * tone(49.987)]
    (left,) = subtract_tones(1e-3, pieces, find_tones(1e-3, pieces, BAND), BAND)
    assert np.std(left - noise) < 0.03
