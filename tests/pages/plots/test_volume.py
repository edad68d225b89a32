"""The reachable volume as coloured cells."""

from __future__ import annotations

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest
import xarray
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from pkmodes.pages.plots.volume import _draw_outer_faces, volume


def ball(radius: float) -> xarray.Dataset:
    """A map whose poses within a sphere can be reached, with frequencies that grow with z."""
    x, y, z = np.linspace(-1.0, 1.0, 11), np.linspace(-1.0, 1.0, 9), np.linspace(-2.0, 0.0, 7)
    X, Y, Z = np.meshgrid(x, y, z, indexing="ij")
    valid = radius**2 >= X**2 + Y**2 + (Z + 1.0) ** 2
    frequency = np.where(valid, 50.0 + 10.0 * Z, np.nan)[..., None]
    dims = ("x", "y", "z")
    return xarray.Dataset(
        {
            "valid": (dims, valid),
            "frequency": ((*dims, "mode"), frequency),
            "unstable_modes": (dims, np.zeros(valid.shape, int)),
        },
        {name: (name, places, {"units": "m"}) for name, places in zip(dims, (x, y, z), strict=True)},
    )


def test_the_sides_of_the_cells_enclose_the_poses_that_can_be_reached() -> None:
    """As many as a count over all neighbours gives, and a half of the volume where it is cut."""
    dataset = ball(0.9)
    whole, cut = (
        next(one for one in axes.collections) for axes in volume(dataset, ("x", "y", "z")).figure.axes[:2]
    )

    def sides(valid: np.ndarray) -> int:
        padded = np.pad(valid, 1).astype(int)
        return int(sum(np.abs(np.diff(padded, axis=axis)).sum() for axis in range(3)))

    valid = dataset["valid"].values
    assert len(whole.get_facecolor()) == sides(valid)
    reached = np.flatnonzero(valid.any((0, 2)))
    first, last = max(reached[0] - 1, 0), min(reached[-1] + 1, 8)
    behind = valid.copy()
    behind[:, : first + (last - first + 1) // 2] = False
    assert len(cut.get_facecolor()) == sides(behind)


def test_each_side_has_the_place_and_the_colour_of_its_cell(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cell by cell: a side where no cell with a value is beside it."""
    taken: list[tuple[np.ndarray, np.ndarray]] = []

    def collection(sides: np.ndarray, *, facecolors: np.ndarray, **_: object) -> None:
        taken.append((sides, facecolors))

    monkeypatch.setattr("mpl_toolkits.mplot3d.art3d.Poly3DCollection", collection)
    values = np.arange(24.0).reshape(2, 3, 4)
    values[0, 1] = values[1, 2, 3] = np.nan
    edges = [np.array([0.0, 1.0, 3.0]), np.arange(4.0), np.array([-4.0, -2.0, -1.0, 0.0, 5.0])]
    colours = ScalarMappable(Normalize(0.0, 23.0))
    _draw_outer_faces(SimpleNamespace(add_collection3d=lambda _: None), edges, values, colours)
    ((sides, faces),) = taken
    expected = {}
    for cell in np.ndindex(values.shape):
        if np.isnan(values[cell]):
            continue
        for axis, end in product(range(3), (0, 1)):
            beside = list(cell)
            beside[axis] += 2 * end - 1
            if 0 <= beside[axis] < values.shape[axis] and np.isfinite(values[tuple(beside)]):
                continue
            middle = [0.5 * (edges[k][cell[k]] + edges[k][cell[k] + 1]) for k in range(3)]
            middle[axis] = edges[axis][cell[axis] + end]
            red, green, blue, _ = colours.to_rgba(values[cell])
            light = (0.82, 0.92, 1.0)[axis]
            expected[tuple(middle)] = (light * red, light * green, light * blue, 1.0)
    found = {tuple(side.mean(axis=0)): tuple(face) for side, face in zip(sides, faces, strict=True)}
    assert len(found) == len(sides)
    assert found == {place: pytest.approx(colour) for place, colour in expected.items()}
