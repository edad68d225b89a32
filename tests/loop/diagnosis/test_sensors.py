"""Structures whose channels are not their coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import sparse

from helpers.robots.small_structures import in_a_row
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import MatrixStructure, Parameter

FOUR = ["a", "b", "c", "d"]


def springs(values, setup=None) -> tuple[np.ndarray, np.ndarray]:
    """Four masses of 1, 2, 3 and 4 kg in a row on the ground, with a soft second spring."""
    k = np.array([4e3, 1e3 * (1.0 + values["stiffer"]), 3e3, 2e3])
    M = np.diag([1.0, 2.0, 3.0, 4.0 + values["tip"]])
    return M, in_a_row(k)


CHANGES = [Parameter("stiffer", 0.0, lower=-0.9), Parameter("tip", 0.0, lower=-1.0)]
VALUES = np.array([0.2, 0.5])


def four(**options: Any) -> MatrixStructure:
    return MatrixStructure(CHANGES, [], springs, **{"channels": FOUR, **options})


def test_channels_are_some_of_the_coordinates_in_any_order() -> None:
    whole, part = four(), four(channels=["d", "b"], coordinates=FOUR)
    every, some = (one.predict(VALUES, (0, 1), shape_rates=True) for one in (whole, part))
    assert (some.shapes == every.shapes[..., [3, 1]]).all()
    assert (np.asarray(some.shape_rates) == np.asarray(every.shape_rates)[:, :, [3, 1]]).all()
    assert (some.eigenvalues == every.eigenvalues).all()
    assert part.subset([0]).channels == ("d", "b")


@pytest.mark.parametrize("form", [np.asarray, sparse.csr_array, sparse.csc_matrix, np.ndarray.tolist])
def test_sensors_measure_any_combination_of_coordinates(form: Any) -> None:
    # Midway between two masses, and the stretch of the last spring.
    sensors = np.array([[0.5, 0.5, 0, 0], [0, 0, -1, 1]])
    found = four(channels=["mid", "stretch"], sensors=form(sensors)).predict(VALUES, (0, 1), shape_rates=True)
    every = four().predict(VALUES, (0, 1), shape_rates=True)
    assert found.shapes == pytest.approx(every.shapes @ sensors.T)
    expected = np.einsum("cn,smnt->smct", sensors, np.asarray(every.shape_rates))
    assert np.asarray(found.shape_rates) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"channels": ["a", "e"], "coordinates": FOUR},
            r'channel "e" is not one of the 4 coordinates.*a, b, c, d',
        ),
        ({"channels": ["a"], "coordinates": ["a", "b"]}, r"shape \(2, 2\) for 2 coordinates, found \(4, 4\)"),
        ({"channels": ["a"], "coordinates": ["a", "b", "b", "c"]}, 'two coordinates are called "b"'),
        ({"channels": ["a"], "sensors": np.eye(4)}, r"expected one row for each channel \(1\)"),
        (
            {"channels": ["a"], "sensors": [[1, 0, 0]]},
            r"shape \(3, 3\) for 3 columns of sensors, found \(4, 4\)",
        ),
        ({"channels": ["a"], "sensors": [1, 0, 0, 0]}, "expected one row for each channel"),
        ({"channels": ["a"], "sensors": [[1, 0, np.nan, 0]]}, "expected finite real numbers"),
        ({"channels": ["a"], "sensors": [[1, 0, 1j, 0]]}, "expected finite real numbers"),
        ({"channels": ["a"], "sensors": [["x", "y", "z", "q"]]}, "sensors"),
        ({"channels": ["a"], "sensors": [[1, 0], [0]]}, "expected a matrix"),
        ({"channels": ["a", "b"], "sensors": [[1, 0, 0, 0], [0] * 4]}, 'channel "b" measures nothing'),
        ({"channels": FOUR, "sensors": np.eye(4), "coordinates": FOUR}, "found both"),
        ({"channels": ["a", "b"]}, "give one channel for each coordinate, or coordinates= or sensors="),
        ({"modes": 0}, "more than the 0 rigid ones, found 0"),
        ({"modes": 2, "rigid": 2}, "more than the 2 rigid ones, found 2"),
        ({"modes": 2.5}, "expected a whole number of modes, .*found 2.5"),
    ],
)
def test_sensors_that_do_not_fit_are_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(PkmodesError, match=message):
        four(**options)
