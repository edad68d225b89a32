"""Impulses as firmware makes them: by the conditions that define them, values of the sources, and their rounding."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import fsolve
from scipy.signal import argrelmax, argrelmin

from pkmodes.machine.shaping import KINDS, residual, shaper
from pkmodes.machine.shaping.firmware import VERSIONS
from pkmodes.machine.shaping.firmware_impulses import (
    centre_of_equal_impulses,
    firmware_shaper,
    has_own_formulas,
)

Array = NDArray[np.float64]
F = 40.0
HUMPS = {"ei": 1, "2hump_ei": 2, "3hump_ei": 3}
#: Largest damping ratio for which the humps are looked at: those of Klipper's polynomials beyond are less even.
RATIOS = [("ei", 0.0), ("ei", 0.1), ("ei", 0.2), ("2hump_ei", 0.05), ("2hump_ei", 0.1), ("3hump_ei", 0.05)]

#: Versions, kind, amplitudes and times [ms] of Klipper for 40 Hz and a ratio of 0.1, at commits 84104bbbd, 768b19e8b
#: and d5a7a7f00.
NUMBERS = [
    (("klipper", "klipper-2025-09"), "ei", [0.3548814, 0.4529981, 0.1921205], [0.0, 12.681, 25.12595]),
    (
        ("klipper", "klipper-2025-09"),
        "2hump_ei",
        [0.2585355, 0.3599357, 0.2727638, 0.108765],
        [0.0, 12.89764, 25.20516, 37.22316],
    ),
    (
        ("klipper",),
        "3hump_ei",
        [0.2208544, 0.2772115, 0.2596997, 0.1670552, 0.0751793],
        [0.0, 13.51255, 25.70128, 37.64748, 49.57318],
    ),
    (
        ("klipper-2025-09",),
        "3hump_ei",
        [0.2109051, 0.276349, 0.2633645, 0.1716194, 0.077762],
        [0.0, 13.20075, 25.1163, 37.22168, 49.43807],
    ),
    (("klipper-2025-08",), "ei", [0.3507058, 0.4627882, 0.1865061], [0.0, 12.56297, 25.12595]),
    (
        ("klipper-2025-08",),
        "2hump_ei",
        [0.2455466, 0.3812217, 0.278005, 0.0952267],
        [0.0, 12.56297, 25.12595, 37.68892],
    ),
    (
        ("klipper-2025-08",),
        "3hump_ei",
        [0.1974575, 0.3043159, 0.2805471, 0.1618358, 0.0558436],
        [0.0, 12.56297, 25.12595, 37.68892, 50.25189],
    ),
]
#: How far the polynomials of Klipper are from the solutions to which they were fitted: of what is left, and of
#: amplitudes and times.
FITTED, SOLVED = 0.004, 0.002


@pytest.mark.parametrize(("kind", "zeta"), RATIOS)
def test_klipper_keeps_the_humps_at_the_tolerance_with_damping_too(kind: str, zeta: float) -> None:
    """So the shapers are defined: between frequencies of which nothing is left, humps of 5 % (Singhose et al. 1997).

    The impulses of the design, which decay like the mode, do not.
    """
    f = np.linspace(15.0, 75.0, 60001)

    def extremes(left: Array) -> tuple[Array, Array]:
        minima = argrelmin(left)[0]
        inside = left[minima[0] : minima[-1] + 1]
        return left[minima], inside[argrelmax(inside)[0]]

    lowest, humps = extremes(residual(firmware_shaper("klipper", kind, F, zeta), f, zeta))
    assert (len(lowest), len(humps)) == (HUMPS[kind] + 1, HUMPS[kind])
    np.testing.assert_allclose(lowest, 0.0, atol=FITTED)
    np.testing.assert_allclose(humps, 0.05, atol=FITTED)
    if zeta > 0.05:
        _, humps = extremes(residual(firmware_shaper("klipper-2025-08", kind, F, zeta), f, zeta))
        assert abs(humps - 0.05).max() > 0.006


@pytest.mark.parametrize("zeta", [0.02, 0.1, 0.2])
def test_ei_of_klipper_solves_the_conditions_of_the_damped_mode(zeta: float) -> None:
    """Nothing left at a frequency below and at one above, 5 % at the design, in one period of the damped mode."""
    V, root = 0.05, np.sqrt(1.0 - zeta**2)

    def left(x: Array, f: float) -> complex:
        amplitudes, times = np.array([x[0], x[1], 1.0 - x[0] - x[1]]), np.array([0.0, x[2], 1.0 / root])
        s = 2.0 * np.pi * f * (zeta + 1j * root)
        return complex(np.exp(-2.0 * np.pi * f * zeta / root) * (amplitudes * np.exp(s * times)).sum())

    def conditions(x: Array) -> list[float]:
        low, high = left(x, x[3]), left(x, x[4])
        return [low.real, low.imag, high.real, high.imag, abs(left(x, 1.0)) - V]

    # From frequencies at which the undamped shaper leaves nothing: cos(pi f) = -(1 - V) / (1 + V).
    apart = np.arccos((1.0 - V) / (1.0 + V)) / np.pi
    start = [0.26, 0.47, 0.5 / root, 1.0 - apart, 1.0 + apart]
    found, _, flag, message = fsolve(conditions, start, full_output=True, xtol=1e-12)
    assert flag == 1, message
    made = firmware_shaper("klipper", "ei", 1.0, zeta)
    np.testing.assert_allclose(made.amplitudes[:2], found[:2], atol=SOLVED)
    np.testing.assert_allclose(made.delays[1:], [found[2], 1.0 / root], atol=SOLVED)
    assert np.abs(shaper("ei", 1.0, zeta).amplitudes[:2] - found[:2]).max() > 0.04 * zeta


def test_numbers_of_klipper() -> None:
    """What klippy/extras/shaper_defs.py of each version gives, its amplitudes over their sum."""
    for versions, kind, amplitudes, milliseconds in NUMBERS:
        for version in versions:  # to the digits of these numbers
            made = firmware_shaper(version, kind, F, 0.1)
            np.testing.assert_allclose(made.amplitudes, amplitudes, rtol=0, atol=2e-6)
            np.testing.assert_allclose(1e3 * made.delays, milliseconds, rtol=0, atol=2e-5)


def test_only_ei_of_klipper_has_changed() -> None:
    for kind in KINDS:
        for version in ("klipper", "klipper-2025-09", "klipper-2025-08"):
            changed = kind in HUMPS and version != "klipper-2025-08"
            assert has_own_formulas(version, kind, 0.05) == changed
            one, design = firmware_shaper(version, kind, F, 0.05), shaper(kind, F, 0.05)
            assert np.allclose(one.amplitudes, design.amplitudes, rtol=0, atol=1e-12) != changed
    # Beyond its limits there is no such shaper, and nothing to be made.
    assert not has_own_formulas("klipper", "3hump_ei", 0.21)


@pytest.mark.parametrize("version", list(VERSIONS))
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("zeta", [0.0, 0.02, 0.15])
def test_every_version_makes_a_shaper(version: str, kind: str, zeta: float) -> None:
    made = firmware_shaper(version, kind, F, zeta)
    assert made.amplitudes.sum() == pytest.approx(1.0, abs=1e-12)
    assert (made.amplitudes > 0.0).all()
    assert made.delays[0] == 0.0
    assert (np.diff(made.delays) > 0.0).all()


def test_marlin_has_impulses_a_whole_number_of_milliseconds_apart() -> None:
    """Ni[1] = LROUND(base / f / df * FTM_FS), 0.5 or 0.375 periods of the damped mode; a ratio of 0.01 at least."""
    np.testing.assert_allclose(
        firmware_shaper("marlin", "ei", 45.9, 0.0).delays, [0.0, 0.011, 0.022], atol=1e-12
    )
    np.testing.assert_allclose(
        firmware_shaper("marlin", "mzv", 44.69, 0.1).delays, [0.0, 0.008, 0.016], atol=1e-12
    )
    np.testing.assert_allclose(
        firmware_shaper("marlin", "mzv", 44.0, 0.1).delays, [0.0, 0.009, 0.018], atol=1e-12
    )
    K = np.exp(-0.1 * np.pi / np.sqrt(1.0 - 0.01))
    weights = np.array([1.0, np.sqrt(2.0) * K, K**2])
    made = firmware_shaper("marlin", "mzv", 44.69, 0.1)
    np.testing.assert_allclose(made.amplitudes, weights / weights.sum(), atol=1e-12)
    undamped = firmware_shaper("marlin", "zvd", 44.69, 0.0)
    np.testing.assert_allclose(undamped.amplitudes, shaper("zvd", 44.69, 0.01).amplitudes, atol=1e-12)
    assert firmware_shaper("marlin", "zv", 44.69, 0.1).delays[1] == shaper("zv", 44.69, 0.1).delays[1]  # M593


def test_marlin_gets_the_frequency_in_the_middle_of_those_with_the_same_impulses() -> None:
    for f in (43.8, 44.69, 46.5):
        middle = centre_of_equal_impulses("marlin", "mzv", f, 0.1)
        assert (
            firmware_shaper("marlin", "mzv", middle, 0.1).delays[1]
            == firmware_shaper("marlin", "mzv", f, 0.1).delays[1]
        )
        assert shaper("mzv", middle, 0.1).delays[1] % 1e-3 == pytest.approx(0.0, abs=1e-9) or shaper(
            "mzv", middle, 0.1
        ).delays[1] % 1e-3 == pytest.approx(1e-3, abs=1e-9)
    assert centre_of_equal_impulses("klipper", "mzv", 44.69, 0.1) == 44.69


def test_reprapfirmware_has_the_humps_in_periods_of_the_damped_mode() -> None:
    damped = np.sqrt(1.0 - 0.03**2)
    for kind in ("2hump_ei", "3hump_ei"):
        mine, others = (
            firmware_shaper("reprapfirmware", kind, F, 0.03),
            firmware_shaper("klipper", kind, F, 0.03),
        )
        np.testing.assert_allclose(mine.delays * damped, others.delays, rtol=1e-12)
        np.testing.assert_allclose(mine.amplitudes, others.amplitudes, rtol=1e-12)
    assert not has_own_formulas("reprapfirmware", "2hump_ei", 0.04)  # the impulses of the design are sent
