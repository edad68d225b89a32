"""Which parameter each frequency depends on: relative sensitivities in a plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.labels import typeset
from pkmodes.plots.maps import mode_panels, panels_of
from pkmodes.plots.plane import Plane
from pkmodes.plots.style import BLACK, UNCHANGED, WHITE, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Parameters listed at most.
ROWS = 14
#: Luminance at which black and white text have the same contrast: 1.05 / (L + 0.05) = (L + 0.05) / 0.05.
MIDDLE = 0.179


def table(paths: Sequence[str], relative: Array) -> Figure:
    """Draw the median influence of each parameter on each frequency: at the edge of a plane some grow without bound.

    Parameters
    ----------
    paths : sequence of str
        Parameters; those that act as one have one name, separated by commas.
    relative : ndarray, shape (along, across, parameters, modes)
        d ln f / d ln p.
    """
    reached = relative[np.isfinite(relative).all(axis=(2, 3))]
    middle = np.median(reached, axis=0) if len(reached) else np.zeros(relative.shape[2:])
    order = np.argsort(-np.abs(middle).max(axis=1))[:ROWS]
    drawn = figure(0.24 * len(order) + 0.9)
    axes = drawn.add_subplot()
    high = max(float(np.abs(middle).max()), 1e-12)
    mesh = axes.imshow(middle[order], cmap="PuOr", vmin=-high, vmax=high, aspect="auto")
    axes.set_xticks(range(middle.shape[1]), [f"mode {i + 1}" for i in range(middle.shape[1])])
    axes.set_yticks(range(len(order)), [broken(paths[i]) for i in order])
    axes.grid(visible=False)
    axes.tick_params(length=0)
    for row, path in enumerate(order):
        for mode in range(middle.shape[1]):
            value = middle[path, mode]
            ink = BLACK if luminance(mesh.to_rgba(value)) > MIDDLE else WHITE
            axes.text(mode, row, typeset(f"{value:+.2f}"), ha="center", va="center", fontsize=7.5, color=ink)
    bar = drawn.colorbar(mesh, ax=axes, aspect=25)
    bar.set_label("d ln f / d ln p, median over the plane [1]")
    return drawn


def broken(name: str) -> str:
    """Return a name of several parameters with each on a line of its own."""
    return name.replace(", ", ",\n")


def luminance(colour: Sequence[float] | Array) -> float:
    """Return the relative luminance of a colour, 0 for black to 1 for white.

    References
    ----------
    Web Content Accessibility Guidelines 2.1, relative luminance.
    """
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour[:3]]
    return float(np.dot([0.2126, 0.7152, 0.0722], linear))


def dominant(plane: Plane, paths: Sequence[str], relative: Array) -> Figure:
    """Draw, for each mode, the parameter with the largest influence at each pose.

    Parameters
    ----------
    paths : sequence of str
        Parameters; those that act as one have one name, separated by commas.
    relative : ndarray, shape (along, across, parameters, modes)
        d ln f / d ln p.
    """
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    size = np.abs(relative)
    reached = np.isfinite(size).all(axis=2)
    first = np.where(reached, np.nan_to_num(size).argmax(axis=2), -1)
    counts = np.bincount(first[first >= 0], minlength=len(paths))
    shown = [int(i) for i in np.argsort(-counts, kind="stable")[: len(UNCHANGED) - 1] if counts[i]]
    place = np.full(len(paths) + 1, float(len(shown)))
    place[shown] = range(len(shown))
    place[-1] = np.nan
    *palette, grey = UNCHANGED
    colours = ListedColormap([*palette[: len(shown)], grey])
    modes = relative.shape[-1]
    drawn, panels = panels_of(plane, modes, colour_bars=False)
    for mode, axes in mode_panels(plane, panels, modes):
        plane.draw(axes, place[first[..., mode]], cmap=colours, vmin=-0.5, vmax=len(shown) + 0.5)
    legend = [Patch(color=palette[i], label=broken(paths[path])) for i, path in enumerate(shown)]
    if counts.sum() > counts[shown].sum():
        legend.append(Patch(color=grey, label="another"))
    drawn.legend(
        handles=legend,
        loc="outside lower center",
        ncols=3,
        title=f"largest |d ln f / d ln p| of {len(paths)} parameters",
    )
    return drawn
