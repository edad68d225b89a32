"""Between the poses of a grid: modes are paired by their shapes, and frequencies are as far off as the scene says."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.view import poses_around
from pkmodes.view.interpolation import deviations, mean_frequency
from pkmodes.view.pairing import paired_modes

ROBOTS = Path(__file__).parents[2] / "robots"


def test_springs_in_series_are_interpolated_exactly() -> None:
    """A mass on a bar of length x has f^-2 = (2 pi)^2 m x / EA, which is linear in x."""
    x = np.array([0.2, 0.5, 1.1])
    frequency = lambda at: 40.0 / np.sqrt(at)  # noqa: E731 - the closed form
    found = deviations(
        frequency(x)[:, None], np.zeros((3, 1), dtype=int), np.arange(3), (x,), lambda at: frequency(at)
    )
    np.testing.assert_allclose(found, 0.0, atol=1e-14)
    off = deviations(
        frequency(x)[:, None], np.zeros((3, 1), dtype=int), np.arange(3), (x,), lambda at: 1.1 * frequency(at)
    )
    np.testing.assert_allclose(off, 1.0 / 1.1 - 1.0)


def test_a_cell_without_one_of_its_corners_has_no_deviation() -> None:
    places = np.array([[0, 1, 2], [3, -1, 4]])
    found = deviations(
        np.full((5, 1), 10.0),
        np.zeros((5, 1), dtype=int),
        places,
        (np.arange(2.0), np.arange(3.0)),
        lambda at: np.full((len(at), 1), 10.0),
    )
    assert np.isnan(found).all()


def test_the_mean_of_a_frequency_below_zero_is_that_of_the_frequencies() -> None:
    np.testing.assert_allclose(mean_frequency(np.array([[-1.0, 3.0], [2.0, 3.0]])), [0.5, 3.0])


def test_modes_that_cross_are_paired_by_shape() -> None:
    """Two masses of 2 and 3 kg on springs of their own: shapes stay, ranks are exchanged where they cross."""
    M = np.diag([2.0, 3.0])
    unit = np.eye(2) / np.sqrt(np.diag(M))
    shapes = np.stack([unit, -unit, unit[::-1]])  # the third state is beyond the crossing
    order = paired_modes(shapes, np.tile(M, (3, 1, 1)), np.arange(3), 0)
    np.testing.assert_array_equal(order, [[0, 1], [0, 1], [1, 0]])
    rigid = paired_modes(shapes, np.tile(M, (3, 1, 1)), np.arange(3), 2)
    np.testing.assert_array_equal(rigid, [[0, 1]] * 3)


@pytest.mark.parametrize("name", ["corexy-printer", "clavel-delta"])
def test_a_scene_tells_how_far_its_interpolation_is_off(name: str) -> None:
    """Recomputed for one cell from the model alone, by rank: these modes do not cross there."""
    model = pkmodes.load(ROBOTS / f"{name}.toml")
    shown = poses_around(model, {"corexy-printer": [0.1, 0.2], "clavel-delta": [0.0, 0.0, -0.55]}[name])
    assert shown.levels is not None
    assert shown.places is not None
    assert shown.deviations is not None
    sizes = [len(values) - 1 for values in shown.levels]
    cells = shown.deviations.reshape(*sizes, -1)
    cell = tuple(np.argwhere(np.isfinite(cells[..., 0]))[-1])
    corners = np.stack(
        np.meshgrid(
            *([values[i], values[i + 1]] for values, i in zip(shown.levels, cell, strict=True)), indexing="ij"
        ),
        axis=-1,
    ).reshape(-1, len(sizes))
    rigid = shown.rigid_modes
    between = mean_frequency(model.frequencies(corners)[:, rigid:])
    exact = model.frequencies(corners.mean(axis=0))[rigid:]
    np.testing.assert_allclose(cells[cell], between / exact - 1.0, atol=2e-3)
    assert np.nanmedian(np.abs(shown.deviations)) < 0.02
