"""The expected information of a measurement, against closed forms, quadrature and random draws."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import integrate, stats

from pkmodes.loop.diagnosis.verdict.information import information, separations

#: Normal distributions of one number: probabilities, means, standard deviations.
MIXTURES = {
    "two, two sigmas apart": ([0.5, 0.5], [0.0, 2.0], [1.0, 1.0]),
    "two of unequal width": ([0.3, 0.7], [0.0, 1.0], [0.5, 3.0]),
    "one of three far away": ([0.2, 0.5, 0.3], [0.0, 1.5, 30.0], [1.0, 1.0, 2.0]),
    "four, two of them equal": ([0.25] * 4, [0.0, 0.0, 4.0, -5.0], [1.0, 1.0, 1.0, 0.7]),
}


def told(p: list[float], means: np.ndarray, covariances: np.ndarray) -> float:
    """The information at one place, from means (n, m) and covariances (n, m, m)."""
    return float(information(np.array(p), separations(means[:, None], covariances[:, None])[2]).item())


def exact(p: list[float], means: list[float], sigmas: list[float]) -> float:
    """The mutual information of one number, by quadrature."""
    parts = [stats.norm(mean, sigma) for mean, sigma in zip(means, sigmas, strict=True)]

    def integrand(y: float) -> float:
        densities = np.array([part.pdf(y) for part in parts])
        mixed = float(np.dot(p, densities))
        return sum(q * d * np.log(d / mixed) for q, d in zip(p, densities, strict=True) if d > 0.0)

    ends = [(part.ppf(1e-15), part.ppf(1 - 1e-15)) for part in parts]
    low, high = min(end[0] for end in ends), max(end[1] for end in ends)
    return float(integrate.quad(integrand, low, high, points=means, limit=500)[0])


@pytest.mark.parametrize("name", MIXTURES)
def test_it_is_a_tight_lower_bound_of_the_mutual_information(name: str) -> None:
    p, means, sigmas = MIXTURES[name]
    found = told(p, np.array(means)[:, None], np.array(sigmas)[:, None, None] ** 2)
    true = exact(p, means, sigmas)
    assert 0.6 * true < found < true


@pytest.mark.parametrize("count", [2, 3, 5])
def test_equal_predictions_tell_nothing_and_far_ones_everything(count: int) -> None:
    p, eye = [1.0 / count] * count, np.broadcast_to(np.eye(3), (count, 3, 3))
    assert told(p, np.ones((count, 3)), eye) == pytest.approx(0.0, abs=1e-12)
    assert told(p, 100.0 * np.arange(count)[:, None] * np.ones(3), eye) == pytest.approx(np.log(count))


def test_distances_and_overlaps_are_those_of_normal_distributions() -> None:
    rng = np.random.default_rng(5)
    A, B = rng.standard_normal((2, 3, 3))
    V, W, m = A @ A.T + np.eye(3), B @ B.T + np.eye(3), np.array([1.0, -0.5, 2.0])
    distances, certain, overlaps = separations(np.array([[0.0 * m], [m]]), np.array([[V], [W]]))
    assert distances.item() == pytest.approx(np.linalg.norm(m))
    white = np.linalg.solve(np.linalg.cholesky((V + W) / 2.0), m)
    assert certain.item() == pytest.approx(np.linalg.norm(white))
    # The overlap is the mean of the root of the ratio of both densities under one of them.
    one, other = stats.multivariate_normal(0.0 * m, V), stats.multivariate_normal(m, W)
    drawn = one.rvs(400_000, random_state=rng)
    ratio = np.exp(0.5 * (other.logpdf(drawn) - one.logpdf(drawn)))
    assert abs(overlaps.item() - ratio.mean()) < 4.0 * ratio.std() / np.sqrt(len(drawn))


def test_what_predicts_nothing_is_told_from_nothing() -> None:
    means = np.array([[[0.0], [0.0]], [[9.0], [np.nan]], [[0.0], [9.0]]])
    distances, certain, overlaps = separations(means, np.ones((3, 2, 1, 1)))
    assert distances.tolist() == certain.tolist() == [[9.0, 0.0], [0.0, 9.0], [9.0, 0.0]]
    assert overlaps[:, 1] == pytest.approx([1.0, np.exp(-81.0 / 8.0), 1.0])
    assert overlaps[1, 0] == 1.0
