"""Measurements of very many rows: the work grows with their number, and what is compared is the same as for few."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from helpers.robots.robot_text import PUBLISHED
from pkmodes import PkmodesError, load, updating
from pkmodes.loop.diagnosis import Measurements
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.match.pairing import close_rows
from pkmodes.loop.diagnosis.match.shape_errors import shape_errors
from pkmodes.loop.measured.columns import Numbers

#: Far below what any sensor can do, so that `shape_errors` replaces it.
TOO_GOOD = 1e-9


def modes_at(poses: int, *, seed: int = 0) -> Measurements:
    """Return six modes at each of many poses, as the model of the published machine has them, rows in any order."""
    rng = np.random.default_rng(seed)
    model = load(PUBLISHED)
    points = np.array([0.6, 0.0, -0.245]) + rng.uniform(-1.0, 1.0, (poses, 3)) * [0.1, 0.03, 0.02]
    modes = model.modes(points, fields=("frequencies", "platform_shapes"))
    f, shapes = modes.frequencies[:, 3:9].ravel(), modes.platform_shapes[:, 3:9].reshape(-1, 3)
    order = rng.permutation(len(f))
    return Measurements.from_rows(
        [f"P{i // 6}" for i in order],
        f[order] * (1.0 + 0.002 * rng.standard_normal(len(f))),
        0.002 * f[order],
        points=np.repeat(points, 6, axis=0)[order],
        shapes={f"p_{c}": shapes[order, k] for k, c in enumerate("xyz")},
        shape_sigma=np.full(len(f), TOO_GOOD),
    )


class Counted(np.ndarray):
    """An array that counts the elements of what is computed from it, and from that in turn."""

    elements = 0

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        options |= {"out": tuple(map(np.asarray, options["out"]))} if "out" in options else {}
        plain = (np.asarray(value) if isinstance(value, Counted) else value for value in inputs)
        result = getattr(ufunc, method)(*plain, **options)
        Counted.elements += np.size(result)
        return result.view(Counted) if isinstance(result, np.ndarray) else result


def elements(poses: int) -> int:
    """Return how many elements a comparison computes from the setups and the numbers of its rows."""
    robot, data = load(PUBLISHED).robot, modes_at(poses)
    object.__setattr__(data, "pose", data.pose.view(Counted))
    numbers = {name: column.view(Counted) for name, column in data.numbers.items()}
    object.__setattr__(data, "numbers", Numbers(numbers))
    before = Counted.elements
    assert len(updating.compare(robot, data).rows) == 6 * poses
    return Counted.elements - before


def test_the_work_of_a_comparison_is_proportional_to_the_rows() -> None:
    """Sixteen times the rows: 256 times as many elements where every row is compared with all."""
    # A few do not depend on the rows.
    assert elements(800) == pytest.approx(16 * elements(50), rel=0.05)


@pytest.mark.parametrize("seed", range(5))
def test_rows_are_compared_together_where_their_frequencies_are_that_close(seed: int) -> None:
    rng, limits = np.random.default_rng(seed), Criteria().pairing
    count, sigma = 40, float(rng.choice([1e-4, 3e-3, 0.05]))
    f = 50.0 * np.exp(rng.uniform(0.0, 0.4, count))
    labels = rng.choice(["A", "B", "C"], count).tolist()
    data = Measurements.from_rows(labels, f, sigma * f, mode=range(count))
    limit = min(max(limits.mixed_sigmas * math.sqrt(2.0) * sigma, limits.mixed), limits.most_mixed)
    found = close_rows(data, Criteria())
    for i, row in enumerate(found):
        expected = [
            j
            for j in range(count)
            if j != i and labels[j] == labels[i] and abs(math.log(f[j] / f[i])) < limit
        ]
        assert row[row >= 0].tolist() == [i, *expected]


def test_more_modes_than_can_be_diagnosed_are_refused_at_once() -> None:
    robot, data = load(PUBLISHED).robot, modes_at(5000)
    with pytest.raises(
        PkmodesError, match=r"at most 10,000 measured modes to diagnose, found 30,000"
    ) as error:
        updating.diagnose(robot, data)
    assert "keep one pose in 3" in error.value.remedy


def test_shapes_that_are_stated_too_well_are_as_uncertain_as_the_frequencies_make_them() -> None:
    """Two modes of one setup, by the angle of Fox and Kapoor; modes of other setups do not count."""
    f, relative = np.array([50.0, 60.0, 51.0]), np.array([0.01, 0.02, 0.03])
    data = Measurements.from_rows(
        ["A", "A", "B"],
        f,
        relative * f,
        shapes={"a": [1.0, 0.5, 1.0], "b": [0.2, 1.0, 0.3]},
        shape_sigma=[TOO_GOOD, 0.05, TOO_GOOD],
    )
    angle = math.hypot(0.01, 0.02) / math.log(60.0 / 50.0)
    expected = [angle, 0.05, Criteria().shapes.least_sigma]
    np.testing.assert_allclose(shape_errors(data, Criteria()), expected, rtol=1e-12)
