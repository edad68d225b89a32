"""Orders of a motor whose speed wanders, and lightly damped modes, which a fit to a spectrum does not tell apart."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import lfilter

from pkmodes.modaltest.identification.ssi_bands import SpectralLines
from pkmodes.modaltest.identification.ssi_identification import identify_responses
from pkmodes.modaltest.identification.ssi_lines import amplitude_statistics, quantile
from pkmodes.modaltest.identification.ssi_selection import RefinedMode
from pkmodes_rig.structures.driven import accelerations, structure

Array = NDArray[np.float64]
RATE, BAND = 1000.0, (10.0, 200.0)
ORDERS = (1.0, 1.5, 3.0, 4.5, 5.0)


def motor(seed: int, wander: float, seconds: float = 40.0, level: float = 0.3) -> tuple[Array, Array, float]:
    """Accelerations under white noise and the orders of a motor; frequencies of the modes, the last of 0.15 %.

    The speed wanders with a standard deviation relative to its mean, over some 5 s.
    """
    rng = np.random.default_rng(seed)
    f = np.array([17.0, 52.0, 75.0, 118.0, 143.0])
    system = structure(f, np.array([0.01, 0.012, 0.008, 0.006, 0.0015]), rng)
    samples, before = int((seconds + 5.0) * RATE), int(5.0 * RATE)
    kept = math.exp(-1.0 / (5.0 * RATE))
    slow = lfilter([math.sqrt(1.0 - kept**2)], [1.0, -kept], rng.normal(size=samples + 30000))[30000:]
    speed = rng.uniform(36.0, 37.5)
    turn = 2.0 * np.pi * np.cumsum(speed * (1.0 + wander * slow)) / RATE
    force = rng.normal(size=(samples, len(f)))
    for order in ORDERS:
        force += level * np.sin(order * turn + rng.uniform(0.0, 6.0))[:, None] * rng.normal(size=len(f))
    clean = accelerations(system, force, RATE)[before:]
    noisy = clean + 0.05 * clean.std(axis=0) * rng.normal(size=clean.shape)
    return noisy * 10.0 ** rng.uniform(-1.0, 1.0, len(f)), f, speed


@pytest.mark.parametrize("wander", [2e-4, 2e-3])
def test_orders_of_a_motor_that_wanders_are_lines_and_the_modes_stay(wander: float) -> None:
    named = 0
    for seed in (8101, 8102, 8103):
        signals, f, speed = motor(seed, wander)
        estimate, said = identify_responses(1.0 / RATE, signals, band=BAND)
        found = np.array([mode.frequency for mode in estimate.modes])
        assert len(found) == len(f)
        np.testing.assert_allclose(found, f, rtol=0.01)
        lines = np.array(estimate.tones)
        named += sum(np.abs(lines / (order * speed) - 1.0).min() < 0.003 for order in ORDERS)
        assert all(any(f"{line:.4g} Hz" in sentence for sentence in said) for line in lines)
    assert named >= 6


def responses(decays: float, count: int, rng: np.random.Generator) -> Array:
    """Analytic signals of a mode under white noise in records of 1 s, (count, N), with this rate of decay [1/s]."""
    samples = 1024
    kept = math.exp(-decays / samples)
    noise = rng.normal(size=(count, samples)) + 1j * rng.normal(size=(count, samples))
    noise[:, 0] /= math.sqrt(1.0 - kept**2)
    return np.asarray(lfilter([1.0], [1.0, -kept], noise, axis=1))


def statistic(signal: NDArray[np.complex128], decays: float) -> float:
    """Return that of a signal of 1 s around 200 Hz."""
    lines = SpectralLines(np.arange(-312.0, 712.0) + 0.0, np.fft.fftshift(np.fft.fft(signal))[:, None])
    return amplitude_statistics(
        [lines], RefinedMode(200.0, decays, np.zeros((2, 2)), np.ones(1, complex), 0.0)
    ).statistic


@pytest.mark.parametrize("decays", [3.0, 12.0, 100.0])
def test_the_quantiles_are_those_of_simulated_responses(decays: float) -> None:
    values = [statistic(one, decays) for one in responses(decays, 1200, np.random.default_rng(8200))]
    for share, few, most in (
        (0.01, 0.003, 0.025),
        (0.2, 0.16, 0.25),
        (0.5, 0.45, 0.56),
        (0.99, 0.975, 0.997),
    ):
        assert few < np.mean(np.array(values) < quantile(share, decays)) < most


def test_a_constant_amplitude_is_far_below_all_responses() -> None:
    turn = 0.7 * np.cumsum(np.random.default_rng(8300).normal(size=1024)) / 8.0
    for decays in (3.0, 12.0, 100.0):
        assert statistic(np.exp(0.2j * turn), decays) < quantile(0.01, decays)


def test_a_doubtful_mode_is_said() -> None:
    """A mode of 0.3 % at 11 Hz decays seven times in 40 s."""
    rng = np.random.default_rng(8402)
    system = structure(np.array([11.0, 60.0]), np.array([0.002, 0.01]), rng)
    force = rng.normal(size=(50000, 2))
    signals = accelerations(system, force, RATE)[20000:]
    estimate, said = identify_responses(1.0 / RATE, signals, band=(8.0, 100.0))
    sure = [mode for mode in estimate.modes if mode.damping > 2.0 * mode.sigma_damping]
    assert len(sure) == 1
    doubtful = [one for one in said if "doubtful" in one or "does not tell" in one]
    assert len(doubtful) == 1
    (said_of,) = re.findall(r"([0-9.]+) Hz", doubtful[0])
    assert float(said_of) == pytest.approx(11.0, rel=0.01)
