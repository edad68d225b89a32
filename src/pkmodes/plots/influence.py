"""Which parameter each frequency depends on: relative sensitivities in a plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.labels import broken, typeset
from pkmodes.plots.style import figure, ink_on

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Parameters listed at most.
ROWS = 14


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
            ink = ink_on(mesh.to_rgba(value))
            axes.text(mode, row, typeset(f"{value:+.2f}"), ha="center", va="center", fontsize=7.5, color=ink)
    bar = drawn.colorbar(mesh, ax=axes, aspect=25)
    bar.set_label("d ln f / d ln p, median over the plane [1]")
    return drawn
