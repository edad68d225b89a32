"""Shapes and residual terms of known poles."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.modaltest.identification.residues import lsfd
from pkmodes_rig.structures.forced import structure

LINES = np.arange(10.0, 400.0, 0.5)


@pytest.mark.parametrize("power", [0, 1, 2])
def test_residues_of_known_poles_in_the_band_of_a_structure_with_a_stiff_mode(power: int) -> None:
    f, z = np.array([80.0, 200.0, 40_000.0]), np.array([0.01, 0.02, 0.01])
    s = structure(f, z, np.random.default_rng(9))
    H = s.response(LINES, [0, 1, 2], [0, 1], power)
    w = 2.0 * np.pi * f[:2]
    poles = w * (-z[:2] + 1j * np.sqrt(1.0 - z[:2] ** 2))
    parts = s.shapes[:2, :2].T.astype(complex)
    fit = lsfd(LINES, H, np.ones((len(LINES), 3)), poles, parts, power)
    expected = s.shapes[:, :2].T / (2j * poles.imag[:, None])
    assert fit.shapes == pytest.approx(expected, rel=1e-3, abs=1e-6 * np.abs(expected).max())
    static = np.outer(s.shapes[:, 2], s.shapes[:2, 2]) / (2.0 * np.pi * f[2]) ** 2
    assert fit.upper.real == pytest.approx(static, rel=0.02, abs=0.02 * np.abs(static).max())
    assert np.abs(fit.response(LINES) - H).max() < 1e-4 * np.abs(H).max()
