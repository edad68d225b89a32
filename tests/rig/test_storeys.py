"""Storey frames on the rig agree with textbook solutions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from pkmodes_rig.laboratory import Laboratory
from pkmodes_rig.measurements import identified
from pkmodes_rig.storeys import channels, storey_modes


@pytest.mark.parametrize("n", [3, 4, 5])
def test_a_uniform_frame_has_the_modes_of_a_fixed_free_chain(n: int) -> None:
    m, k = 20.0, 4.0e5
    true = storey_modes([m] * n, [k] * n)
    r, floor = np.arange(1, n + 1), np.arange(1, n + 1)
    half = (2 * r - 1) * np.pi / (2 * (2 * n + 1))
    assert true.frequencies == pytest.approx(2 * np.sqrt(k / m) * np.sin(half) / (2 * np.pi), rel=1e-10)
    shapes = np.array([true.shapes[name] for name in channels(n)])
    expected = np.sin(2 * np.outer(floor, half))
    expected /= np.sqrt(m * np.sum(expected**2, axis=0))
    np.testing.assert_allclose(np.abs(shapes), np.abs(expected), atol=1e-10)
    assert true.rigid == 0


def test_braces_and_absorbers_are_springs_between_the_masses_they_join() -> None:
    true = storey_modes(
        [3.0, 2.0, 1.0], [50.0, 40.0, 30.0], braces={(0, 2): 7.0, (1, 3): 5.0}, absorbers={2: (0.5, 4.0)}
    )

    def spring(k: float, *ends: int) -> np.ndarray:
        stretch = np.zeros(4)
        stretch[list(ends)] = (1.0, -1.0)[: len(ends)]
        return k * np.outer(stretch, stretch)

    K = spring(50, 0) + spring(40, 1, 0) + spring(30, 2, 1) + spring(7, 1) + spring(5, 2, 0) + spring(4, 3, 1)
    eigenvalues = eigh(K, np.diag([3.0, 2.0, 1.0, 0.5]), eigvals_only=True)
    np.testing.assert_allclose(true.frequencies, np.sqrt(eigenvalues) / (2 * np.pi), rtol=1e-10)


def test_all_modes_of_a_frame_can_be_measured() -> None:
    true = storey_modes([20.0] * 4, [4e5] * 4)
    lab = Laboratory(modes=(4, 4), shapes=channels(4), sigma=1e-6)
    options = {k: v for k, v in lab.options().items() if k != "band_stated"}
    rows = identified([true], rng=np.random.default_rng(0), **options)
    assert sorted(row.frequency for row in rows) == pytest.approx(true.frequencies, rel=1e-4)
