"""Input shapers: published insensitivities, the conditions that define them, and a simulated oscillator."""

from __future__ import annotations

import itertools
import warnings
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.signal.windows import chebwin

from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.shaping import KINDS, Shaper, residual, shaper

TOLERANCE = 0.05
HUMPS = {"ei": 1, "2hump_ei": 2, "3hump_ei": 3}
#: Multiplicity of the zero at the mode itself.
ZEROS = {"zv": 1, "zvd": 2, "zvdd": 3, "mzv": 1, "2hump_ei": 1}


def insensitivity(kind: str, zeta: float = 0.0) -> float:
    """Return the width of the band of f/f_model around 1 in which at most 5 % is left."""
    of_one = shaper(kind, 1.0, zeta)

    def over(r: float) -> float:
        # Humps as high as the tolerance touch it; only where the band ends they go through it.
        return float(residual(of_one, r, zeta)) - TOLERANCE * (1.0 + 1e-9)

    edges = []
    for sign in (-1.0, 1.0):
        outside = next(r for r in 1.0 + sign * np.arange(0.0, 1.0, 1e-3) if over(r) > 0.0)
        edges.append(brentq(over, outside - sign * 1e-3, outside, xtol=1e-13))
    return edges[1] - edges[0]


@pytest.mark.parametrize(
    ("kind", "width"), [("zv", 0.064), ("zvd", 0.287), ("ei", 0.399), ("2hump_ei", 0.725)]
)
def test_the_insensitivity_is_the_published_one(kind: str, width: float) -> None:
    assert insensitivity(kind) == pytest.approx(width, rel=0.01)


@pytest.mark.parametrize("kind", HUMPS)
def test_humps_are_those_of_a_chebyshev_polynomial(kind: str) -> None:
    """The polynomial with equal ripples of 5 %: its coefficients are a Dolph-Chebyshev window."""
    order = HUMPS[kind] + 1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # for spectra, ripples of -26 dB are too high
        window = chebwin(order + 1, at=-20.0 * np.log10(TOLERANCE))
    assert shaper(kind, 1.0, 0.0).amplitudes == pytest.approx(window / window.sum(), abs=1e-12)
    largest = np.cosh(np.arccosh(1.0 / TOLERANCE) / order)
    # For three humps this is 0.964.
    assert insensitivity(kind) == pytest.approx(2.0 - 4.0 / np.pi * np.arccos(1.0 / largest), rel=1e-6)


@pytest.mark.parametrize("kind", HUMPS)
def test_damping_does_not_narrow_the_band_of_the_humps(kind: str) -> None:
    widths = [insensitivity(kind, zeta) for zeta in (0.0, 0.01, 0.05, 0.1, 0.2)]
    assert (np.diff(widths) > 0.0).all()


def vibration(impulses: Shaper, f: float, zeta: float) -> float:
    """Simulate an oscillator at rest that impulses drive; return the amplitude of its vibration at the last one."""
    omega = 2.0 * np.pi * f

    def rate(_: float, y: Any) -> list[float]:
        return [y[1], -2.0 * zeta * omega * y[1] - omega**2 * y[0]]

    x, v, now = 0.0, 0.0, float(impulses.delays[0])
    for amplitude, delay in zip(impulses.amplitudes, impulses.delays, strict=True):
        if delay > now:
            run = solve_ivp(rate, (now, delay), [x, v], method="DOP853", rtol=1e-11, atol=1e-12)
            (x, v), now = run.y[:, -1], delay
        v += amplitude * omega**2
    # x = A exp(-zeta omega t) cos(omega_d t + phase), t from now on.
    return float(np.hypot(x, (v + zeta * omega * x) / (omega * np.sqrt(1.0 - zeta**2))))


ONE_IMPULSE = Shaper(np.ones(1), np.zeros(1))


@pytest.mark.parametrize("kind", KINDS)
def test_the_residual_is_that_of_a_simulated_oscillator(subtests: pytest.Subtests, kind: str) -> None:
    for f, zeta in [(32.3, 0.02), (25.0, 0.0), (41.0, 0.15), (90.0, 0.4)]:
        with subtests.test(f"{f}, {zeta}"):
            designed = shaper(kind, 31.0, 0.05)
            simulated = vibration(designed, f, zeta) / vibration(ONE_IMPULSE, f, zeta)
            assert simulated > 1e-4
            assert residual(designed, f, zeta) == pytest.approx(simulated, abs=1e-8)


def test_a_product_cancels_the_vibration_of_several_simulated_oscillators() -> None:
    frequencies, ratios = [32.3, 36.2, 39.7], [0.02, 0.05, 0.1]
    designed = shaper("zv*mzv*zvd", frequencies, ratios)
    for f, zeta in zip(frequencies, ratios, strict=True):
        assert vibration(designed, f, zeta) < 1e-8 * vibration(ONE_IMPULSE, f, zeta)


def test_nothing_is_left_of_the_mode_itself(subtests: pytest.Subtests) -> None:
    for zeta, kind in product([0.0, 0.01, 0.1, 0.5, 0.9], ZEROS):
        with subtests.test(f"{zeta}, {kind}"):
            assert residual(shaper(kind, 31.2, zeta), 31.2, zeta) < 1e-12


DIRECTIONS = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-1.0, 1.0)]


@pytest.mark.parametrize("kind", ZEROS)
def test_the_derivatives_vanish_up_to_the_order_of_the_kind(subtests: pytest.Subtests, kind: str) -> None:
    """Twice as far from the mode, in frequency or damping, 2^p is left: p - 1 derivatives vanish, and no more."""
    for df, dzeta in DIRECTIONS:
        with subtests.test(f"{df}, {dzeta}"):
            h = np.array([1e-4, 2e-4])
            left = residual(shaper(kind, 31.2, 0.1), 31.2 * (1.0 + df * h), 0.1 + dzeta * h)
            assert np.log2(left[1] / left[0]) == pytest.approx(ZEROS[kind], abs=0.01)


def test_amplitudes_with_damping_are_the_published_ones() -> None:
    zeta = 0.1
    K = np.exp(-zeta * np.pi / np.sqrt(1.0 - zeta**2))
    T = 1.0 / (20.0 * np.sqrt(1.0 - zeta**2))
    for kind, raw in [("zv", [1, K]), ("zvd", [1, 2 * K, K**2]), ("zvdd", [1, 3 * K, 3 * K**2, K**3])]:
        amplitudes, delays = shaper(kind, 20.0, zeta)
        assert amplitudes == pytest.approx(np.array(raw) / (1 + K) ** (len(raw) - 1), rel=1e-14)
        assert delays == pytest.approx(np.arange(len(raw)) * T / 2, rel=1e-14)


@pytest.mark.parametrize("zeta", [0.0, 0.1])
def test_mzv_solves_its_conditions(zeta: float) -> None:
    """Three impulses 3T/8 apart: no vibration, and the sum 1."""
    omega_d = 2.0 * np.pi * 20.0 * np.sqrt(1.0 - zeta**2)
    delays = np.arange(3) * 3.0 / 8.0 * 2.0 * np.pi / omega_d
    growth = np.exp(2.0 * np.pi * 20.0 * zeta * delays)
    conditions = [growth * np.cos(omega_d * delays), growth * np.sin(omega_d * delays), np.ones(3)]
    assert shaper("mzv", 20.0, zeta).delays == pytest.approx(delays, rel=1e-14)
    expected = np.linalg.solve(conditions, [0.0, 0.0, 1.0])
    assert shaper("mzv", 20.0, zeta).amplitudes == pytest.approx(expected, rel=1e-12)


def test_a_product_is_the_convolution() -> None:
    """On a grid of milliseconds: half periods of 10, 4 and 7 ms."""
    kinds, frequencies = ["zvd", "3hump_ei", "zv"], np.array([50.0, 125.0, 500.0 / 7.0])

    def sampled(one: Shaper) -> Any:
        samples = np.zeros(80)
        np.add.at(samples, np.rint(one.delays * 1e3).astype(int), one.amplitudes)
        return samples

    expected = np.ones(1)
    for kind, f in zip(kinds, frequencies, strict=True):
        expected = np.convolve(expected, sampled(shaper(kind, f, 0.0)))[:80]
    product = shaper("*".join(kinds), frequencies, 0.0)
    assert product.amplitudes.shape == (3 * 5 * 2,)
    assert sampled(product) == pytest.approx(expected, abs=1e-15)
    assert (np.diff(product.delays) >= 0.0).all()


def test_a_factor_is_for_the_frequency_at_its_index() -> None:
    product = shaper("zv * 2hump_ei", [30.0, 70.0], [0.02, 0.2])
    of_factors = [shaper("zv", 30.0, 0.02), shaper("2hump_ei", 70.0, 0.2)]
    f, zeta = np.array([20.0, 33.0, 80.0]), np.array([0.0, 0.1, 0.3])
    expected = residual(of_factors[0], f, zeta) * residual(of_factors[1], f, zeta)
    assert residual(product, f, zeta) == pytest.approx(expected, rel=1e-12)
    assert product.durations == pytest.approx(sum(one.durations for one in of_factors), rel=1e-14)


@pytest.mark.parametrize("kind", [*KINDS, "zv*mzv", "ei*zvdd"])
def test_a_batch_holds_what_single_designs_give(kind: str) -> None:
    rng = np.random.default_rng(1)
    last = (2,) if "*" in kind else ()
    f, zeta = rng.uniform(20.0, 60.0, (3, 4, *last)), rng.uniform(0.0, 0.3, (3, 4, *last))
    batch = shaper(kind, f, zeta)
    actual, damping = rng.uniform(20.0, 60.0, (3, 4, 5)), rng.uniform(0.0, 0.3, (3, 4, 5))
    left = residual(batch, actual, damping)
    assert left.shape == (3, 4, 5)
    assert batch.durations.shape == (3, 4)
    for i, j in itertools.product(range(3), range(4)):
        one = shaper(kind, f[i, j], zeta[i, j])
        assert batch.amplitudes[i, j] == pytest.approx(one.amplitudes, rel=1e-13)
        assert batch.delays[i, j] == pytest.approx(one.delays, rel=1e-13)
        assert left[i, j] == pytest.approx(residual(one, actual[i, j], damping[i, j]), abs=1e-13)
        assert batch.durations[i, j] == pytest.approx(one.delays[-1], rel=1e-13)


def test_axes_of_frequencies_go_with_those_of_the_shaper_from_the_first_on() -> None:
    f = np.array([20.0, 30.0, 40.0])
    three, one = shaper("zv", f, 0.1), shaper("zv", 30.0, 0.1)
    # Square, so that the other order would give a result too.
    modes = f[:, None] * np.array([1.0, 1.5, 2.0])
    left = residual(three, modes, 0.1)
    assert left[:, 0] == pytest.approx(0.0, abs=1e-12)
    assert left[:, 1] == pytest.approx(left[0, 1], rel=1e-12)
    assert left[0, 1] > 0.1
    assert residual(three, f, 0.1) == pytest.approx(0.0, abs=1e-12)
    assert residual(three, 30.0, [0.1, 0.2, 0.3]).shape == (3,)
    assert residual(one, modes, 0.1).shape == (3, 3)
    assert residual(one, 30.0, 0.1).shape == ()
    six = shaper("zv", np.broadcast_to(f, (2, 3)), 0.1)
    assert residual(six, [30.0, 20.0], 0.1)[:, 1] == pytest.approx([0.0, residual(three, 20.0, 0.1)[1]])


def test_ratios_are_broadcast_with_frequencies() -> None:
    assert shaper("zvd", [20.0, 30.0], 0.1).delays.shape == (2, 3)
    assert shaper("zvd", 20.0, [0.1, 0.2]).delays.shape == (2, 3)
    assert shaper("zv*zv", [[20.0, 30.0]] * 5, [0.1, 0.2]).delays.shape == (5, 4)


def test_a_long_shaper_of_a_fast_mode_does_not_overflow() -> None:
    """The factors of the formula alone would: exp(1 000) and exp(-1 000)."""
    assert 0.0 < residual(shaper("zv", 1.0, 0.0), 1000.0, 0.5) <= 0.5


products = st.lists(st.sampled_from(KINDS), min_size=1, max_size=3).map("*".join)


@given(st.data(), products)
def test_amplitudes_are_positive_with_the_sum_1_and_delays_ascend_from_0(
    data: st.DataObject, kind: str
) -> None:
    count = kind.count("*") + 1
    f = data.draw(st.lists(st.floats(1e-3, 1e5), min_size=count, max_size=count))
    zeta = data.draw(st.lists(st.floats(0.0, 0.9), min_size=count, max_size=count))
    amplitudes, delays = shaper(kind, f, zeta) if count > 1 else shaper(kind, f[0], zeta[0])
    assert amplitudes.shape == delays.shape
    assert (amplitudes > 0.0).all()
    assert amplitudes.sum() == pytest.approx(1.0, abs=1e-14)
    assert delays[0] == 0.0
    assert (np.diff(delays) >= 0.0).all()
    actual, damping = data.draw(st.floats(1e-3, 1e5)), data.draw(st.floats(0.0, 0.9))
    assert 0.0 <= residual(Shaper(amplitudes, delays), actual, damping) <= 1.0 + 1e-12


@pytest.mark.parametrize(
    ("arguments", "parts"),
    [
        (("zvdx", 30.0, 0.1), ("expected zv, zvd,", 'found "zvdx"', '"zvd"?')),
        (("2hump-ei", 30.0, 0.1), ('found "2hump-ei"', '"2hump_ei"?')),
        (("zv*ie*zv", [30.0] * 3, 0.1), ('found "ie" in "zv*ie*zv"', '"ei"?')),
        (("zv*", [30.0] * 2, 0.1), ('found "" in "zv*"', "known: zv, ")),
        ((3, 30.0, 0.1), ("found 3", "known: zv, ")),
        (("zv", 0.0, 0.1), ("expected positive frequencies in Hz, found 0 (frequencies)",)),
        (("zv", [[30.0, np.nan]], 0.1), ("found nan (frequencies[0, 1])",)),
        (("zv", [np.inf], 0.1), ("found inf (frequencies[0])",)),
        (("zv", "30 Hz", 0.1), ('expected frequencies in Hz, found "30 Hz"',)),
        (("zv", True, 0.1), ("expected frequencies in Hz, found true",)),
        (("zv", [[1.0], [1.0, 2.0]], 0.1), ("expected frequencies in Hz, found a list",)),
        (("zv", 30.0, 1.0), ("expected damping ratios from 0 to below 1, found 1 (damping_ratios)",)),
        (("zv", 30.0, [0.1, -1e-3]), ("found -0.001 (damping_ratios[1])",)),
        (("zv", 30.0, np.nan), ("found nan (damping_ratios)",)),
        (("zv", 30.0, None), ("expected damping ratios, found None",)),
        (("zv", [30.0, 40.0], [0.1] * 3), ("for each of the frequencies (2,), found (3,)",)),
        (("zv*zv", [30.0] * 3, 0.1), ("a last axis of 2 frequencies", "factor of zv*zv, found (3,)")),
        (("zv*zv", [30.0], [0.1, 0.2]), ("a last axis of 2 frequencies", "found (1,)")),
        (("zv*zv", 30.0, 0.1), ("a last axis of 2 frequencies", "found ()")),
    ],
)
def test_a_mistake_is_named(arguments: Any, parts: tuple[str, ...]) -> None:
    with pytest.raises(PkmodesError) as caught:
        shaper(*arguments)
    assert all(part in str(caught.value) for part in parts), str(caught.value)


def test_a_mistake_in_actual_modes_is_named() -> None:
    three = shaper("zv", [20.0, 30.0, 40.0], 0.1)
    with pytest.raises(PkmodesError, match=r"shapers \(3,\).*found \(2, 3\)"):
        residual(three, np.full((2, 3), 30.0), 0.1)
    with pytest.raises(PkmodesError, match=r"found -30 \(frequencies\)"):
        residual(three, -30.0, 0.1)
