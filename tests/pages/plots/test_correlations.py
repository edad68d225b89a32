"""Correlations of fitted values, and the ellipses of pairs that hardly part."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.loop.diagnosis.verdict.findings import Corrected
from pkmodes.pages.plots import correlations
from pkmodes.pages.plots.drawing import Drawing

RATES = np.array([[1.0, 0.9, 0.1], [0.9, 1.0, -0.75], [0.1, -0.75, 1.0]])


def values(*sizes: float) -> list[Corrected]:
    return [
        Corrected("abc"[k], size, 0.02 * abs(size), "1", 1.01 * size, 0.1, False)
        for k, size in enumerate(sizes)
    ]


def table(drawing: Drawing | None) -> dict[str, list[str]]:
    assert drawing is not None
    return {column[0]: column[1:] for column in drawing.table}


@pytest.mark.parametrize("probability", [0.68, 0.95])
def test_an_ellipse_has_the_pairs_that_it_should(probability: float) -> None:
    """Of 200 000 normal pairs: by the signed area of each pair and the edges of the polygon."""
    sigma, rate = (3.0, 0.2), -0.8
    covariance = np.outer(sigma, sigma) * [[1.0, rate], [rate, 1.0]]
    pairs = np.random.default_rng(5).multivariate_normal([0.0, 0.0], covariance, 200_000)
    edge = correlations.ellipse_points(sigma, rate, probability)
    (x, y), step = edge[:, :-1], np.diff(edge)
    inside = np.ones(len(pairs), dtype=bool)
    for k in range(len(x)):
        inside &= step[0, k] * (pairs[:, 1] - y[k]) - step[1, k] * (pairs[:, 0] - x[k]) > 0.0
    assert inside.mean() == pytest.approx(probability, abs=0.004)


def test_strong_pairs_alone_have_ellipses_the_strongest_first() -> None:
    some = values(2.0, -5.0, 40.0)
    assert correlations.notable_pairs(some, RATES) == [(0, 1), (1, 2)]
    drawn = table(correlations.error_ellipses(some, RATES))
    assert list(dict.fromkeys(drawn["panel"])) == ["correlation +0.90", "correlation \u22120.75"]
    # Declared values are 1 % beyond the fitted ones.
    at = drawn["series"].index("declared")
    assert [float(drawn[f"{name} [%]"][at]) for name in "ab"] == pytest.approx([1.0, -1.0])
    assert correlations.error_ellipses(some, np.eye(3)) is None


def test_an_ellipse_of_a_value_near_0_is_in_its_unit() -> None:
    """Of 0.1 mm with a sigma of 0.5 mm: the ellipse of 95 % reaches 2.448 sigma, in mm, and not 1224 %."""
    some = [
        Corrected("offset", 1e-4, 5e-4, "m", 0.0, 1e-3, False),
        Corrected("stiffness", 2000.0, 20.0, "N/m", 2000.0, 500.0, False),
    ]
    drawn = table(correlations.error_ellipses(some, np.array([[1.0, 0.9], [0.9, 1.0]])))
    reach = {name: max(abs(float(x)) for x in drawn[name]) for name in ("offset [mm]", "stiffness [%]")}
    assert reach == pytest.approx({"offset [mm]": 2.4477 * 0.5, "stiffness [%]": 2.4477}, rel=1e-3)
    at = drawn["series"].index("declared")
    assert float(drawn["offset [mm]"][at]) == pytest.approx(-0.1)
    zero = [Corrected("offset", 0.0, 5e-4, "m", 0.0, 1e-3, False), some[1]]
    assert "offset [mm]" in table(correlations.error_ellipses(zero, np.array([[1.0, 0.9], [0.9, 1.0]])))


def test_pairs_of_one_quantity_at_two_places_have_no_ellipse() -> None:
    some = [Corrected(name, 2.0, 0.04, "1", 2.0, 0.1, False) for name in ("leg_1.k", "leg_2.k", "mass.3")]
    strong = np.full((3, 3), 0.95) + 0.05 * np.eye(3)
    assert correlations.notable_pairs(some, strong) == [(0, 1), (0, 2), (1, 2)]
    assert correlations.drawn_pairs(some, strong) == [(0, 2), (1, 2)]
    assert correlations.error_ellipses(some[:2], strong[:2, :2]) is None


def test_the_matrix_names_its_values() -> None:
    drawn = table(correlations.correlation_matrix(values(1.0, 2.0, 3.0), RATES))
    assert [float(one) for one in drawn["correlation [1]"]] == RATES.ravel().tolist()
    assert drawn["y (name)"][:3] == ["a"] * 3
    assert correlations.correlation_matrix(values(1.0), np.eye(1)) is None
