"""Draw the maps of six-legged machines in docs/tutorial/gallery.md: the first frequency over position and tilt.

    python docs/figures/six_legs.py [FOLDER]

writes them next to this file, or into another folder.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import pkmodes

HERE = Path(__file__).parent
ROBOTS = HERE.parents[1] / "robots"
#: Height of the platform [m], and half the width of each plane [m, deg].
MACHINES = {"hexapod": (0.232, 0.06, 20.0), "hexaglide": (0.2, 0.15, 25.0)}
COUNT = 25
STYLE = {"font.size": 10, "font.family": "sans-serif"}


def first(model: pkmodes.Model, height: float, axes: tuple[int, int], values: np.ndarray) -> np.ndarray:
    """Return the first frequency with held motors over two components of the pose, NaN where it is not reached."""
    poses = np.zeros((len(values), len(values), 6))
    poses[..., 2] = height
    poses[..., axes[0]], poses[..., axes[1]] = values[None, :], values[:, None]
    return np.asarray(model.frequencies(poses, drives="held", on_error="nan")[..., 0])


def plane(axes: Axes, values: np.ndarray, frequencies: np.ndarray, limits: tuple[float, float]) -> Any:
    """Draw a map over two components that have the same values."""
    drawn = axes.pcolormesh(
        values, values, frequencies, cmap="cividis", shading="nearest", vmin=limits[0], vmax=limits[1]
    )
    axes.contour(values, values, frequencies, colors="white", linewidths=0.6)
    axes.set_aspect("equal")
    return drawn


def maps(name: str) -> Figure:
    """Draw both planes of a machine with one scale of colours."""
    height, metres, degrees = MACHINES[name]
    model = pkmodes.load(ROBOTS / f"{name}.toml")
    along, turned = (np.linspace(-1.0, 1.0, COUNT) * half for half in (metres, np.radians(degrees)))
    position, tilt = first(model, height, (0, 1), along), first(model, height, (3, 4), turned)
    limits = (np.nanmin([position, tilt]), np.nanmax([position, tilt]))
    figure = Figure(figsize=(7.2, 3.3), layout="constrained")
    left, right = figure.subplots(1, 2)
    plane(left, along * 1e3, position, limits)
    drawn = plane(right, np.degrees(turned), tilt, limits)
    left.set(xlabel="x [mm]", ylabel="y [mm]", title="level")
    right.set(xlabel="rx [deg]", ylabel="ry [deg]", title="x = y = 0")
    figure.suptitle(f"{name}, z = {height * 1e3:.0f} mm, motors held")
    figure.colorbar(drawn, ax=[left, right], label="first frequency [Hz]")
    return figure


PICTURES = {f"six-legs-{name}": name for name in MACHINES}


def main(arguments: Sequence[str]) -> None:
    """Draw all of them."""
    folder = Path(arguments[0]) if arguments else HERE
    with mpl.rc_context(STYLE):
        for picture, name in PICTURES.items():
            maps(name).savefig(folder / f"{picture}.png", dpi=120, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1:])
