"""The reachable volume as coloured cells."""

from __future__ import annotations

import numpy as np
import xarray

from pkmodes.plots.volume import volume


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
