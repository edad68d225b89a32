"""Frequencies that change while a vibration decays, against the backbone curve of Duffing's equation."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from pkmodes.modaltest.identification.frf_estimates import impact_estimate
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes.modaltest.identification.level import levels
from pkmodes.modaltest.identification.ssi_identification import identify_responses
from pkmodes_rig.structures.driven import ambient, decay, random_structure
from pkmodes_rig.structures.forced import impact
from pkmodes_rig.structures.forced import random_structure as random_frf_structure

Array = NDArray[np.float64]
RATE, F0, RATIO = 1000.0, 40.0, 0.004


def ring_down(hardening: float, rng: np.random.Generator, noise: float = 0.002) -> Array:
    """Two accelerations of an oscillator with a cubic spring after a blow, and of a linear mode at 97 Hz.

    The backbone is f0 (1 + hardening A^2), with A = 1 at the beginning (Nayfeh and Mook, Nonlinear Oscillations,
    1979, section 2.1: 3/8 of the cubic stiffness over the linear one).
    """
    omega, t = 2.0 * np.pi * F0, np.arange(6000) / RATE
    cubic = 8.0 / 3.0 * hardening * omega**2

    def rates(_: float, y: Array) -> list[float]:
        return [y[1], -(omega**2) * y[0] - 2.0 * RATIO * omega * y[1] - cubic * y[0] ** 3]

    x = solve_ivp(rates, (0.0, t[-1]), [0.0, omega], t_eval=t, rtol=1e-9, atol=1e-12).y
    own = np.array([rates(0.0, y)[1] for y in x.T])
    other = 0.3 * omega**2 * np.exp(-0.01 * 2.0 * np.pi * 97.0 * t) * np.sin(2.0 * np.pi * 97.0 * t)
    signals = np.vstack([np.zeros((100, 2)), np.stack([own + other, 0.6 * own - other], axis=1)])
    return signals + noise * signals.std(axis=0) * rng.normal(size=signals.shape)


def poles_and_shapes(signals: Array, rate: float, band: tuple[float, float]) -> tuple[Array, Array]:
    modes = identify_responses(1.0 / rate, signals, band=band)[0].modes
    return np.array([mode.pole for mode in modes]), np.array([mode.shape for mode in modes])


@pytest.mark.parametrize("hardening", [0.004, -0.004, 0.001])
def test_a_cubic_spring_moves_the_frequency_along_its_backbone(hardening: float) -> None:
    signals = ring_down(hardening, np.random.default_rng(1))
    nonlinear, linear = levels(1.0 / RATE, [signals], *poles_and_shapes(signals, RATE, (10.0, 150.0)))
    assert linear.shift is None
    shift = nonlinear.shift
    assert shift is not None
    lost = np.exp(-RATIO * 2.0 * np.pi * F0 * 0.1)  # in the first 0.1 s the filter settles: four of its 20 ms
    assert shift.high / F0 - 1.0 == pytest.approx(hardening * lost**2, rel=0.15)
    assert shift.low / F0 - 1.0 == pytest.approx(
        hardening * (lost / shift.fall) ** 2, abs=0.03 * abs(hardening)
    )
    assert 7.0 < shift.fall < 11.0


def test_the_window_of_an_analyser_does_not_hide_it() -> None:
    signals = ring_down(0.004, np.random.default_rng(2))
    tau = 1.5
    windowed = signals * np.exp(-np.arange(len(signals)) / RATE / tau)[:, None]
    poles, shapes = poles_and_shapes(signals, RATE, (10.0, 150.0))
    plain, under = (
        levels(1.0 / RATE, [some], poles, shapes, window)[0].shift
        for some, window in ((signals, None), (windowed, tau))
    )
    assert plain is not None
    assert under is not None
    assert under.high == pytest.approx(plain.high, abs=0.005)


def test_linear_modes_do_not_change() -> None:
    for seed in range(3100, 3106):
        rng = np.random.default_rng(seed)
        signals = decay(random_structure(rng), rng)
        poles, shapes = poles_and_shapes(signals, 1000.0, (10.0, 200.0))
        assert all(one.shift is None for one in levels(1e-3, [signals], poles, shapes))
    rng = np.random.default_rng(3110)
    signals = ambient(random_structure(rng), rng)
    poles, shapes = poles_and_shapes(signals, 1000.0, (10.0, 200.0))
    assert all(one.shift is None for one in levels(1e-3, [signals], poles, shapes))


@pytest.mark.slow
def test_false_alarms_are_rare() -> None:
    """None among some 400 linear modes whose decay is long enough to tell."""
    alarms = 0
    for seed in range(3200, 3300):
        rng = np.random.default_rng(seed)
        s = random_frf_structure(rng, int(rng.integers(3, 8)))
        outputs = list(range(min(6, len(s.M))))
        force, y = impact(s, outputs, 0, 2, 2048.0, float(rng.uniform(2.0, 6.0)))
        y = y + 10 ** rng.uniform(-3.3, -1.3) * y.std(axis=0) * rng.normal(size=y.shape)
        e = impact_estimate(1.0 / 2048.0, force, y)
        modes = identify_frf(e.frequencies, e.H, band=(10.0, 400.0), derivative_order=2).modes
        poles, shapes = np.array([mode.pole for mode in modes]), np.array([mode.shape for mode in modes])
        alarms += sum(one.shift is not None for one in levels(1.0 / 2048.0, [y], poles, shapes))
    assert alarms == 0


def test_the_amplitude_grows_with_the_signals() -> None:
    signals = ring_down(0.0, np.random.default_rng(3))
    poles, shapes = poles_and_shapes(signals, RATE, (10.0, 150.0))
    one, three = (levels(1.0 / RATE, [k * signals], poles, shapes)[0].amplitude for k in (1.0, 3.0))
    assert three == pytest.approx(3.0 * one, rel=1e-9)
    assert one == pytest.approx(np.hypot(1.0, 0.6) * (2.0 * np.pi * F0) ** 2 / np.sqrt(2.0), rel=0.1)
