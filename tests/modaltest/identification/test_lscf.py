"""Poles of the matrix fraction, and residues, of responses without noise."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.modaltest.identification.clusters import pole_clusters
from pkmodes.modaltest.identification.lscf import lscf
from pkmodes_rig.structures.forced import mac, noise, random_structure

LINES = np.arange(10.0, 400.0, 0.5)


@pytest.mark.parametrize("references", [[0], [0, 1], [0, 1, 2]])
def test_poles_shapes_and_participations(references: list[int]) -> None:
    s = random_structure(np.random.default_rng(7))
    H = s.response(LINES, [0, 1, 2, 3], references, 2)
    (order,) = lscf(LINES, H, np.ones((len(LINES), 4)), [36 // len(references)])
    for m in range(6):
        pole = 2.0 * np.pi * s.frequencies[m] * (-s.damping[m] + 1j * np.sqrt(1.0 - s.damping[m] ** 2))
        nearest = int(np.argmin(np.abs(order.poles - pole)))
        assert abs(order.poles[nearest] - pole) < 1e-5 * abs(pole)
        assert mac(order.shapes[nearest], s.shapes[:4, m]) > 0.9999
        assert mac(order.participation[nearest], s.shapes[references, m]) > 0.9999


def test_clusters_are_the_modes() -> None:
    rng = np.random.default_rng(8)
    s = random_structure(rng)
    H = s.response(LINES, [0, 1, 2, 3], [0, 1], 2)
    H = H + noise(rng, H, 0.003 * np.sqrt((np.abs(H) ** 2).mean()))
    found = pole_clusters(lscf(LINES, H, np.ones((len(LINES), 4)), range(4, 31, 2)), 10.0, 400.0)
    frequencies = np.array([abs(one.pole) for one in found]) / (2.0 * np.pi)
    for f in s.frequencies[:6]:
        assert (np.abs(frequencies / f - 1.0) < 2e-3).sum() == 1
