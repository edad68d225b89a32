"""Whether data suffice for a claim depends on their information, not on the number of rows or of candidates.

Structures whose frequencies' logarithms are linear in the parameters, with data that are exact.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import numpy as np
import pytest
from scipy import stats

from helpers.robots.small_structures import SIGMA, directions, logs_measured, of_signatures
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict.specificity import DRAWS, PlausibleChanges, p_coincidence

SETUPS, MODES = 10, 5
DIRECTIONS = directions(SETUPS * MODES, 12)


def coincidence(
    signatures: Mapping[str, np.ndarray], change: np.ndarray, *, repeated: int = 1, errors: float = 1.0
) -> float:
    """The probability for the cause "a", with every setup measured several times and all errors scaled."""
    again = {name: np.tile(one, repeated) for name, one in signatures.items()}
    model = of_signatures(again, SETUPS * repeated, MODES)
    logs = model.base + SIGMA * np.tile(change, repeated).reshape(model.base.shape)
    search = Search(FitStore(Fitter(model, logs_measured(logs, errors * SIGMA))), model.candidates)
    final = search.store.fit(Hypothesis((model.candidates[0],)))
    assert final is not None
    return p_coincidence(search, final)


def plain(count: int) -> dict[str, np.ndarray]:
    return {chr(ord("a") + k): DIRECTIONS[k] for k in range(count)}


@pytest.mark.parametrize("strength", [5.0, 6.0, 8.0, 12.0])
def test_orthogonal_candidates_agree_with_the_beta_distribution(strength: float) -> None:
    """The squared cosine between a random vector in k dimensions and an axis is Beta(1/2, (k - 1)/2)."""
    k = 8
    # One unit signature at random has the variance strength^2 / k along each axis.
    resolved = k * (strength**2 / k) / (1.0 + strength**2 / k)
    needed = strength**2 / (strength**2 + 2.0 * np.sqrt(2.0 * (resolved - 1.0)))
    assert needed > 0.5  # two axes are never that close to one vector
    expected = k * stats.beta.sf(needed, 0.5, 0.5 * (k - 1))
    spread = np.sqrt(expected * (1.0 - expected) / DRAWS)
    assert coincidence(plain(k), strength * DIRECTIONS[0]) == pytest.approx(expected, abs=4.0 * spread + 1e-3)


def test_it_is_not_the_number_of_rows_that_counts() -> None:
    """The same measurements four times with errors twice as large hold the same information."""
    once = coincidence(plain(8), 3.0 * DIRECTIONS[0])
    again = coincidence(plain(8), 3.0 * DIRECTIONS[0], repeated=4, errors=2.0)
    assert 0.02 < once < 0.5
    assert again == pytest.approx(once, abs=0.03)
    # Less information never makes a claim easier, and more information never harder.
    assert coincidence(plain(8), 3.0 * DIRECTIONS[0], repeated=2, errors=2.0) > once
    assert coincidence(plain(8), 3.0 * DIRECTIONS[0], repeated=4) < once


def test_it_falls_steadily_with_smaller_errors() -> None:
    sizes = [
        coincidence(plain(8), 3.0 * DIRECTIONS[0], errors=errors) for errors in np.geomspace(0.25, 1.3, 12)
    ]
    assert all(a <= b + 0.01 for a, b in itertools.pairwise(sizes))
    assert max(b - a for a, b in itertools.pairwise(sizes)) < 0.25  # without a step
    assert sizes[0] < 0.001


def test_candidates_that_are_nearly_the_same_count_once() -> None:
    """Many near-copies of one candidate do not make the others look less specific."""
    copies = {}
    for k in range(20):
        near = DIRECTIONS[1] + 0.01 * DIRECTIONS[2 + k % 6]
        copies[f"copy {k}"] = near / np.linalg.norm(near)
    strength = 12.0
    alone = coincidence(plain(8), strength * DIRECTIONS[0])
    beside = coincidence(plain(8) | copies, strength * DIRECTIONS[0])
    assert alone < 0.01
    assert beside < 0.01


def test_directions_that_vanish_in_the_noise_do_not_count() -> None:
    """Weights are v / (1 + v) with v the variance along an eigenvector: known for two signatures at an angle."""
    angle, size = 0.3, 5.0
    a, b = DIRECTIONS[:2]
    both = [(a[:, None], 0), ((np.cos(angle) * a + np.sin(angle) * b)[:, None], 0)]
    v = size**2 / 2.0 * np.array([1.0 + np.cos(angle), 1.0 - np.cos(angle)])
    plausible = PlausibleChanges.of(both, size)
    np.testing.assert_allclose(plausible.weights, v / (1.0 + v), rtol=1e-12)
    assert plausible.resolved_count == pytest.approx((v / (1.0 + v)).sum(), rel=1e-12)
    drawn = plausible.draws(200_000, np.random.default_rng(1))
    np.testing.assert_allclose(drawn.var(axis=1), plausible.weights, rtol=0.02)
    # Along the mean direction the weight is that of the sum, across it that of the difference.
    middle = a + (np.cos(angle) * a + np.sin(angle) * b)
    assert plausible.squares(middle) == pytest.approx(plausible.weights[0] * (middle @ middle), rel=1e-9)
