"""Between the poses of a grid: modes are paired by their shapes, and frequencies are as far off as the scene says."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import POSES
from pkmodes.pages.view import poses_around
from pkmodes.pages.view.interpolation import (
    SLIDER_STEPS,
    interpolation_errors,
    largest_around,
    mean_frequency,
)
from pkmodes.pages.view.pairing import paired_modes

ROBOTS = Path(__file__).parents[3] / "robots"


def test_springs_in_series_are_interpolated_exactly() -> None:
    """A mass on a bar of length x has f^-2 = (2 pi)^2 m x / EA, which is linear in x."""
    x = np.array([0.2, 0.5, 1.1])
    frequency = lambda at: 40.0 / np.sqrt(at)  # noqa: E731 - the closed form
    found = interpolation_errors(
        frequency(x)[:, None], np.zeros((3, 1), dtype=int), np.arange(3), (x,), lambda at: frequency(at)
    )
    assert found.shape == (5, 1)
    np.testing.assert_allclose(found[1::2], 0.0, atol=1e-14)
    assert np.isnan(found[::2]).all(), "at the states themselves nothing is interpolated"
    off = interpolation_errors(
        frequency(x)[:, None], np.zeros((3, 1), dtype=int), np.arange(3), (x,), lambda at: 1.1 * frequency(at)
    )
    np.testing.assert_allclose(off[1::2], 1.0 / 1.1 - 1.0)


def test_a_cell_without_one_of_its_corners_has_no_deviation_but_its_other_edges_have() -> None:
    places = np.array([[0, 1, 2], [3, -1, 4]])
    found = interpolation_errors(
        np.full((5, 1), 10.0),
        np.zeros((5, 1), dtype=int),
        places,
        (np.arange(2.0), np.arange(3.0)),
        lambda at: np.full((len(at), 1), 10.0),
    )
    edges = np.array([[0, 1, 0, 1, 0], [1, 0, 0, 0, 1], [0, 0, 0, 0, 0]], dtype=bool)
    np.testing.assert_array_equal(np.isfinite(found[..., 0]), edges)


def test_the_error_inside_a_cell_is_the_largest_of_its_middle_and_its_sides() -> None:
    """With f^-2 = 1 + x y + x^2 / 10 on the unit square, linear along y: off half-way along x only."""
    corner = lambda at: (1.0 + at[..., 0] * at[..., 1] + 0.1 * at[..., 0] ** 2) ** -0.5  # noqa: E731 - as above
    places, x = np.array([[0, 1], [2, 3]]), np.array([0.0, 1.0])
    at = np.stack(np.meshgrid(x, x, indexing="ij"), axis=-1).reshape(-1, 2)
    order = np.zeros((4, 1), dtype=int)
    found = interpolation_errors(corner(at)[:, None], order, places, (x, x), lambda at: corner(at)[:, None])
    off = {y: ((1.0 + 0.5 * y + 0.05) / (1.0 + 0.5 * y + 0.025)) ** -0.5 - 1.0 for y in (0.0, 0.5, 1.0)}
    np.testing.assert_allclose(found[1, :, 0], [off[0.0], off[0.5], off[1.0]], rtol=1e-12)
    np.testing.assert_allclose(found[[0, 2], 1, 0], 0.0, atol=1e-15)
    around = largest_around(found)
    np.testing.assert_allclose(around[1], [-off[0.0], -off[0.0], -off[1.0]], rtol=1e-12)
    assert np.isnan(around[::2, ::2]).all()


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


def test_points_beside_the_middle_are_checked_too() -> None:
    """With f^-2 = 1 + x^6 between 0 and 1, interpolated as 1 + x: off by more at 3/4 than in the middle."""
    x, order = np.array([0.0, 1.0]), np.zeros((2, 1), dtype=int)
    frequency = lambda at: (1.0 + at**6) ** -0.5  # noqa: E731 - as above
    checked = (0.25, 0.5, 0.75)
    found = interpolation_errors(frequency(x)[:, None], order, np.arange(2), (x,), frequency, checked)
    off = [((1.0 + t) / (1.0 + t**6)) ** -0.5 - 1.0 for t in checked]
    np.testing.assert_allclose(found[1], min(off), rtol=1e-12)
    assert min(off) == off[2] < off[1] < 0.0
    only = interpolation_errors(frequency(x)[:, None], order, np.arange(2), (x,), frequency, (0.25,))
    np.testing.assert_allclose(only[1], off[0], rtol=1e-12)


@pytest.mark.parametrize(
    ("name", "pose", "stops", "where", "typical"),
    [
        ("corexy-printer", [0.1, 0.2], np.arange(1, SLIDER_STEPS), "", 0.02),
        ("clavel-delta", [0.0, 0.0, -0.55], np.arange(1, SLIDER_STEPS), "", 0.02),
        # Three levels of each of six components are few.
        ("hexapod", POSES["hexapod"], np.array([2, 5, 8]), "at three stops in nine of each slider", 0.05),
    ],
)
def test_a_scene_tells_how_far_its_interpolation_is_off(
    name: str, pose: Any, stops: Any, where: str, typical: float
) -> None:
    """Recomputed at the widest place between poses, from the model alone, by rank: modes do not cross there."""
    model = pkmodes.load(ROBOTS / f"{name}.toml")
    shown = poses_around(model, pose)
    assert shown.checked == where
    assert shown.levels is not None
    assert shown.places is not None
    assert shown.deviations is not None
    rigid, known = shown.rigid_modes, np.argwhere(np.isfinite(shown.deviations[..., 0]))
    between = known % 2  # of the components between whose levels a place is
    widest = between.sum(axis=1) == between.sum(axis=1).max()
    place, spans = known[widest][-1], between[widest][-1]
    ends = [
        values[[i // 2, i // 2 + 1]] if i % 2 else values[[i // 2]]
        for values, i in zip(shown.levels, place, strict=True)
    ]
    corners = np.array(list(product(*ends)))
    at_corners, off = model.frequencies(corners)[:, rigid:], []
    for parts in product(*(stops / SLIDER_STEPS if spanned else [0.0] for spanned in spans)):
        shares = [(1.0 - t, t) if spanned else (1.0,) for t, spanned in zip(parts, spans, strict=True)]
        weights = np.array([np.prod(one) for one in product(*shares)])
        exact = model.frequencies(weights @ corners)[rigid:]
        off.append(mean_frequency(at_corners, weights) / exact - 1.0)
    largest = np.take_along_axis(np.array(off), np.abs(off).argmax(axis=0)[None], axis=0)[0]
    np.testing.assert_allclose(shown.deviations[tuple(place)], largest, atol=1e-9)
    assert np.median(np.abs(shown.deviations[tuple(known[widest].T)])) < typical


def test_the_stated_error_holds_all_along_the_sliders() -> None:
    """At all stops of the sliders along x and y, from the model alone."""
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    shown = poses_around(model, [0.6, 0.0, -0.245])
    assert shown.levels is not None
    assert shown.places is not None
    assert shown.deviations is not None
    assert shown.order is not None
    numbered = np.take_along_axis(shown.frequencies, shown.order, axis=1)[:, shown.rigid_modes :]
    stated, parts, ratios = largest_around(shown.deviations), np.arange(1, 10)[:, None] / 10, []
    grid = np.stack(np.meshgrid(*shown.levels, indexing="ij"), axis=-1)
    for step in np.eye(3, dtype=int)[:2]:
        for at in np.argwhere(shown.places >= 0):
            if (at + step >= shown.places.shape).any() or shown.places[tuple(at + step)] < 0:
                continue
            low, high = (numbered[shown.places[tuple(one)]] ** -2 for one in (at, at + step))
            found = np.sort(((1 - parts) * low + parts * high) ** -0.5, axis=1)
            exact = model.frequencies((1 - parts) * grid[tuple(at)] + parts * grid[tuple(at + step)])
            off = np.abs(found / exact[:, shown.rigid_modes :] - 1.0).max(initial=1e-5)
            ratios.append(off / max(stated[tuple(2 * at + step)], 1e-5))
    assert len(ratios) > 200
    assert max(ratios) < 1.0 + 1e-9
