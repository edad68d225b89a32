"""Values relative to their mean, where the data leave that mean uncertain: the factors of several belts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pkmodes.loop.diagnosis.verdict.findings import Finding, Value
from pkmodes.loop.diagnosis.verdict.relative import relative_to_mean

SHARED = 0.06


def of_factors(factors: np.ndarray, own: np.ndarray, shared: float = SHARED) -> np.ndarray:
    """Covariance of factors a of stiffnesses k (1 + a), if k is uncertain by `shared`: all move with 1 + a."""
    together = np.outer(1.0 + factors, 1.0 + factors)
    return shared**2 * together + np.diag(own**2)


@settings(max_examples=100, deadline=None)
@given(
    factors=st.lists(st.floats(-0.5, 1.0), min_size=2, max_size=6),
    shared=st.floats(0.01, 0.3),
    seed=st.integers(0, 99),
)
def test_factors_are_ratios_to_their_mean(factors: list[float], shared: float, seed: int) -> None:
    """Whatever the common stiffness is, (1 + a) / mean(1 + a) stays, and with it what is printed."""
    a, rng = np.array(factors), np.random.default_rng(seed)
    own = 1e-3 * shared * rng.uniform(0.5, 1.0, len(a))
    found = relative_to_mean(a, of_factors(a, own, shared))
    assert found is not None
    np.testing.assert_allclose(found[0], (1.0 + a) / (1.0 + a).mean() - 1.0, atol=1e-5)
    assert abs(found[0].sum()) < 1e-12


def test_their_sigma_is_the_scatter_of_the_ratios() -> None:
    """By drawing factors from the covariance, and taking the ratios of each draw."""
    a, own = np.array([-0.10, 0.05, 0.03]), np.array([0.001, 0.002, 0.0015])
    C = of_factors(a, own)
    found = relative_to_mean(a, C)
    assert found is not None
    drawn = np.random.default_rng(1).multivariate_normal(a, C, 200_000)
    ratios = (1.0 + drawn) / (1.0 + drawn).mean(axis=1, keepdims=True) - 1.0
    np.testing.assert_allclose(found[1], ratios.std(axis=0), rtol=0.02)
    np.testing.assert_allclose(found[0], ratios.mean(axis=0), atol=2e-5)


def test_equal_shares_are_differences_from_the_mean() -> None:
    a, own = np.array([3.0, 5.0, 10.0]), 0.1
    C = 4.0 * np.ones((3, 3)) + own**2 * np.eye(3)
    found = relative_to_mean(a, C)
    assert found is not None
    np.testing.assert_allclose(found[0], [-3.0, -1.0, 4.0], atol=1e-12)
    np.testing.assert_allclose(found[1], own * np.sqrt(2.0 / 3.0), rtol=1e-9)


@pytest.mark.parametrize(
    "covariance",
    [
        np.diag([1.0, 2.0, 3.0]),  # independent of each other
        np.diag([100.0, 1.0, 1.0]),  # one is uncertain, not all together
        np.ones((3, 3)) + 0.5 * np.eye(3),  # hardly sharper
        np.array([[1.0, -0.99, 0.0], [-0.99, 1.0, 0.0], [0.0, 0.0, 1e-6]]),  # against each other
        np.full((3, 3), np.nan),
        np.zeros((3, 3)),
        np.ones((2, 2)),
    ],
)
def test_where_the_values_say_enough_nothing_is_relative(covariance: np.ndarray) -> None:
    assert relative_to_mean([1.0, 2.0, 3.0], covariance) is None
    assert relative_to_mean([1.0], [[1.0]]) is None
    assert relative_to_mean([], []) is None


def finding(*units: str) -> Finding:
    values = tuple(Value(f"effects.group.part_{i}", 0.1 * i, 1.0, unit) for i, unit in enumerate(units))
    C = np.ones((len(units),) * 2) + 1e-4 * np.eye(len(units))
    return Finding(
        "group", ("group",), values, {"group": values}, 1e-9, "", {"group": tuple(map(tuple, C.tolist()))}
    )


def test_a_finding_tells_its_values_relative_to_their_mean() -> None:
    relative = finding("1", "1", "1").relative()
    assert [value.name for value in relative] == [f"effects.group.part_{i}" for i in range(3)]
    np.testing.assert_allclose([value.value for value in relative], [-0.1, 0.0, 0.1], atol=1e-12)
    assert finding("kg", "kg").covariance == ((1.0001, 1.0), (1.0, 1.0001))
    assert finding("1").relative() == ()
    assert finding("kg", "m").relative() == ()
    assert finding("1", "1").relative("another") == ()
    assert Finding("payload", ("payload",), (), {}, 0.0, "").relative() == ()
