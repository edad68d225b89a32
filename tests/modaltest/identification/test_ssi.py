"""Subspace identification of known correlations, and its derivatives against finite differences."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from pkmodes.modaltest.identification.ssi import modes_of_order, subspace
from pkmodes.modaltest.identification.ssi_bands import BandPart, SpectralLines, correlations, split_band
from pkmodes.modaltest.identification.ssi_uncertainty import _line_contributions

PART = BandPart(20.0, 28.0, 17.6, 30.4)


def test_correlations_of_three_modes_give_their_poles_and_shapes() -> None:
    rng = np.random.default_rng(1)
    f, zeta = np.array([21.0, 24.0, 24.3]), np.array([0.01, 0.02, 0.005])
    poles = 2 * np.pi * f * (-zeta + 1j * np.sqrt(1 - zeta**2))
    psi, g = (rng.normal(size=(4, 3)) + 1j * rng.normal(size=(4, 3)) for _ in range(2))
    step = np.exp((poles - 2j * np.pi * PART.start) / PART.rate)
    R = np.einsum("si,ki,ri->ksr", psi, step ** np.arange(1, 41)[:, None], g)
    found = modes_of_order(subspace(R, 20, 3), 3)
    order_of = np.argsort(np.abs(PART.pole(found.values)))
    np.testing.assert_allclose(PART.pole(found.values)[order_of], poles, rtol=1e-8)
    shapes = found.shapes[:, order_of]
    np.testing.assert_allclose(shapes / shapes[0], psi / psi[0], rtol=1e-6)


def test_changes_of_the_lines_change_poles_and_shapes_as_their_derivatives_say() -> None:
    rng = np.random.default_rng(2)
    f = np.arange(0.0, 100.0, 0.025)
    psi = rng.normal(size=(3, 2))
    peaks = 1.0 / (1j * 2 * np.pi * (f[:, None] - [22.0, 25.0]) + [2.0, 3.0])
    lines = SpectralLines(f, peaks @ psi.T)
    references, lags = np.eye(3), np.arange(1, 41)
    k = int(np.searchsorted(f, 22.1))

    def at(change: float) -> tuple[complex, np.ndarray]:
        values = lines.values.copy()
        values[k] *= np.sqrt(1.0 + change)
        of = modes_of_order(
            subspace(correlations([SpectralLines(f, values)], PART, references, lags), 20, 2), 2
        )
        i = int(np.argmin(np.abs(PART.pole(of.values).imag / (2 * np.pi) - 22.0)))
        return complex(of.values[i]), of.shapes[1:, i] / of.shapes[0, i]

    of = modes_of_order(subspace(correlations([lines], PART, references, lags), 20, 2), 2)
    i = int(np.argmin(np.abs(PART.pole(of.values).imag / (2 * np.pi) - 22.0)))
    inside = lines.select(PART)
    dvalue, dshape = _line_contributions(inside, PART, references, 1, of, i)
    row = int(np.argmin(np.abs(inside.frequencies - f[k])))
    h = 1e-3
    (low, shape_low), (high, shape_high) = at(-h), at(h)
    assert abs((high - low) / (2 * h) - dvalue[row]) < 0.02 * abs(dvalue[row])
    shape = of.shapes[:, i]
    expected = (dshape[row, 1:] - shape[1:] / shape[0] * dshape[row, 0]) / shape[0]
    np.testing.assert_allclose(
        (shape_high - shape_low) / (2 * h), expected, atol=0.1 * np.abs(expected).max()
    )


def test_the_parts_of_a_band_cover_it_once() -> None:
    found = split_band(10.0, 200.0, 500.0, 40.0)
    assert found[0].low == 10.0
    assert found[-1].high == 200.0
    assert all(one.high == other.low for one, other in pairwise(found))
    assert all(one.start < one.low and one.high < one.stop for one in found)
