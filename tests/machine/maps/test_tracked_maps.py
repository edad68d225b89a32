"""Tracked maps of robots."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.machine.dataset.variables import EVENT_FLAGS

ROBOTS = Path(__file__).parents[3] / "robots"
CENTRE = {"x": np.linspace(0.35, 0.77, 169), "y": 0.0, "z": -0.245}


def test_on_the_centre_line_symmetric_and_antisymmetric_modes_cross(model: pkmodes.Model) -> None:
    """There the two outer axes are mirror images: each mode moves them alike or opposite, and stays that way."""
    found = model.map(CENTRE, tracked=True, shapes=True).squeeze()
    outer = found["shape"].sel(coordinate=["x_2", "x_3"]).values
    symmetry = np.sign(outer[..., 0] * outer[..., 1])
    assert (np.abs(np.abs(outer[..., 0]) - np.abs(outer[..., 1])) < 1e-6).all()
    assert (symmetry == symmetry[0]).all(), (
        "each tracked mode is symmetric everywhere, or antisymmetric everywhere"
    )
    by_rank = model.map(CENTRE, shapes=True).squeeze()["shape"].sel(coordinate=["x_2", "x_3"]).values
    ranked = np.sign(by_rank[..., 0] * by_rank[..., 1])
    exchanged = (ranked[1:] != ranked[:-1]).any(axis=1)
    assert exchanged.any(), "by rank they are not"
    crossing = (found["tracking"].values & EVENT_FLAGS["crossing"]).any(axis=1)
    np.testing.assert_array_equal(crossing[1:] & crossing[:-1] & exchanged, exchanged)


@pytest.mark.parametrize("robot", ["linear-delta-2022", "clavel-delta", "corexy-printer"])
def test_a_tracked_map_is_the_map_by_rank_in_another_order(robot: str) -> None:
    model = pkmodes.load(ROBOTS / f"{robot}.toml")
    grid = {
        "linear-delta-2022": {"x": np.linspace(0.2, 0.9, 30), "y": np.linspace(-0.15, 0.15, 21), "z": -0.245},
        "clavel-delta": {"x": np.linspace(-0.3, 0.3, 15), "y": np.linspace(-0.3, 0.3, 15), "z": [-0.7, -0.6]},
        "corexy-printer": {"x": np.linspace(0.02, 0.28, 20), "y": np.linspace(0.02, 0.28, 20)},
    }[robot]
    plain, found = model.map(grid, shapes=True), model.map(grid, tracked=True, shapes=True)
    valid = plain["valid"].values
    order = found["rank"].values[valid] - 1
    assert (np.sort(order, axis=1) == np.arange(order.shape[1])).all()
    assert (found["rank"].values[~valid] == 0).all()
    for name in ("frequency", "in_plane", "out_of_plane"):
        expected = np.take_along_axis(plain[name].values[valid], order, axis=1)
        np.testing.assert_array_equal(found[name].values[valid], expected, err_msg=name)
        assert np.isnan(found[name].values[~valid]).all()
    for name in ("platform_shape", "shape"):
        expected = np.take_along_axis(plain[name].values[valid], order[..., None], axis=1)
        np.testing.assert_array_equal(abs(found[name].values[valid]), abs(expected), err_msg=name)
    ratio = found["shape"].values[valid] * np.take_along_axis(
        plain["shape"].values[valid], order[..., None], axis=1
    )
    assert ((ratio >= 0).all(axis=-1) | (ratio <= 0).all(axis=-1)).all(), (
        "a shape changes its sign as a whole"
    )
    for name in ("condition", "valid", "reason", "joint_position", "static_torque"):
        np.testing.assert_array_equal(found[name].values, plain[name].values)


def test_where_nothing_is_marked_neighbours_have_the_same_shapes(model: pkmodes.Model) -> None:
    grid = {"x": np.linspace(0.35, 0.77, 60), "y": np.linspace(-0.1, 0.1, 41), "z": -0.245}
    found = model.map(grid, tracked=True, shapes=True).squeeze()
    clear = (found["tracking"].values & EVENT_FLAGS["uncertain"]) == 0
    assert clear.mean() > 0.9
    M, _ = model.matrices(np.stack(np.broadcast_arrays(*np.meshgrid(grid["x"], grid["y"]), -0.245), axis=-1))
    phi, psi = found["shape"].values[:, :-1], found["shape"].values[:, 1:]
    product = np.einsum("yxmi,yxij,yxmj->yxm", phi, M[:, :-1], psi)
    both = clear[:, :-1] & clear[:, 1:]
    assert (product[both] ** 2 > 0.45).all()
    assert (product[both] > 0).mean() > 0.99


def test_along_a_line_no_shape_changes_its_sign(model: pkmodes.Model) -> None:
    """By rank, some do; a line goes around no pose at which two frequencies coincide."""
    x = np.linspace(0.25, 0.85, 61)
    M, _ = model.matrices(np.stack([x, np.zeros(61), np.full(61, -0.245)], axis=-1))
    smallest = []
    for tracked in (False, True):
        phi = model.map({"x": x, "y": 0.0, "z": -0.245}, shapes=True, tracked=tracked)[
            "shape"
        ].values.squeeze()
        smallest.append(np.einsum("xmi,xij,xmj->xm", phi[:-1], M[:-1], phi[1:]).min())
    assert smallest[0] < -0.5
    assert smallest[1] > 0.5


def test_along_a_sweep(model: pkmodes.Model) -> None:
    """From a light to a heavy motor, some modes cross; followed, frequencies only fall."""
    masses = np.linspace(0.5, 4.0, 36)
    pose = {"x": 0.6, "y": 0.0, "z": -0.245}
    found = model.map(pose, sweep={"platform.mass": masses}, tracked=True)["frequency"].squeeze()
    assert (np.diff(found.values, axis=0) <= 1e-9).all()
