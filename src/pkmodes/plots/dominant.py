"""Which parameter a frequency depends on most, at each pose of a plane."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.labels import broken
from pkmodes.plots.panels import mode_panels, panels_of
from pkmodes.plots.plane import Plane
from pkmodes.plots.style import ink_on

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Colours of the parameters, those of the largest areas first, and that of all others.  No two of them have the same
#: grey, and none is one that a page redefines: an image keeps its colours on a dark page.
COLOURS = ("#0072b3", "#e69f01", "#00264d", "#bfe3f8", "#009e74", "#7a2f00", "#f2f2f2")
FRAME = "#80868c"
#: Poses around a number in its region: where there are fewer, the region has none.
ROOM = 2


def dominant(plane: Plane, paths: Sequence[str], relative: Array) -> Figure | str:
    """Draw, for each mode, the parameter with the largest influence at each pose.

    Parameters
    ----------
    paths : sequence of str
        Parameters.
    relative : ndarray, shape (along, across, parameters, modes)
        d ln f / d ln p.

    Returns
    -------
    Figure or str
        A sentence if each mode has one parameter.
    """
    from matplotlib.colors import ListedColormap, to_rgb
    from matplotlib.patches import Patch

    size = np.abs(relative)
    reached = np.isfinite(size).all(axis=2)
    first = np.where(reached, np.nan_to_num(size).argmax(axis=2), -1)
    modes = relative.shape[-1]
    if sentence := _one_each(paths, first):
        return sentence
    counts = np.bincount(first[first >= 0], minlength=len(paths))
    shown = [int(i) for i in np.argsort(-counts, kind="stable")[: len(COLOURS) - 1] if counts[i]]
    place = np.full(len(paths) + 1, float(len(shown)))
    place[shown] = range(len(shown))
    place[-1] = np.nan
    *palette, other = COLOURS
    used = [*palette[: len(shown)], other]
    drawn, panels = panels_of(plane, modes, colour_bars=False, below=0.9)
    x, y = plane.drawn(plane.across), plane.drawn(plane.along)
    for mode, axes in mode_panels(plane, panels, modes):
        values = place[first[..., mode]]
        plane.draw(axes, values, cmap=ListedColormap(used), vmin=-0.5, vmax=len(shown) + 0.5)
        for i in range(len(shown)):
            for row, column in middles(values == i):
                ink = ink_on(to_rgb(used[i]))
                axes.text(x[column], y[row], str(i + 1), color=ink, ha="center", va="center", weight="bold")
    legend = [
        Patch(facecolor=used[i], edgecolor=FRAME, label=f"{i + 1}  {broken(paths[path])}")
        for i, path in enumerate(shown)
    ]
    if counts.sum() > counts[shown].sum():
        legend.append(Patch(facecolor=other, edgecolor=FRAME, label="another"))
    drawn.legend(
        handles=legend,
        loc="outside lower center",
        ncols=3,
        # In parts of the figure, so that it stays where it is when margins are cut off or added.
        bbox_to_anchor=(0.0, 0.0, 1.0, 1.0),
        bbox_transform=drawn.transFigure,
        title=f"largest |d ln f / d ln p| of {len(paths)} parameters",
    )
    return drawn


def _one_each(paths: Sequence[str], first: Array) -> str:
    """Return the parameter of each mode as a sentence; empty if a mode has several."""
    found = [np.unique(one[one >= 0]) for one in np.moveaxis(first, -1, 0)]
    if any(len(one) != 1 for one in found):
        return ""
    names = [paths[int(one[0])] for one in found]
    if len(set(names)) == 1:
        return f"At every pose each frequency changes most with {names[0]}, of {len(paths)} parameters."
    each = ", ".join(f"that of mode {mode} with {name}" for mode, name in enumerate(names, 1))
    return f"At every pose the frequencies change most with the same one of {len(paths)} parameters: {each}."


def middles(inside: Array) -> Iterator[tuple[int, int]]:
    """Yield a pose in the middle of each connected region that has room for a number, the widest first.

    Parameters
    ----------
    inside : ndarray of bool, shape (along, across)
    """
    left = np.array(inside, dtype=bool)
    while True:
        depth = _depth(left)
        if depth.max(initial=0) <= ROOM:
            return
        deepest = np.argwhere(depth == depth.max())
        place = deepest[int(np.argmin(np.abs(deepest - deepest.mean(axis=0)).sum(axis=1)))]
        yield int(place[0]), int(place[1])
        left &= ~_connected(left, place)


def _depth(inside: Array) -> Array:
    """Return how many steps each pose is away from the outside, 0 outside."""
    depth, left = np.zeros(inside.shape, dtype=int), inside
    while left.any():
        depth += left
        padded = np.pad(left, 1)
        left = left & padded[2:, 1:-1] & padded[:-2, 1:-1] & padded[1:-1, 2:] & padded[1:-1, :-2]
    return depth


def _connected(inside: Array, place: Array) -> Array:
    """Return the part of a region that is connected with a pose."""
    part = np.zeros_like(inside)
    part[tuple(place)] = True
    while True:
        padded = np.pad(part, 1)
        grown = padded[2:, 1:-1] | padded[:-2, 1:-1] | padded[1:-1, 2:] | padded[1:-1, :-2]
        larger = inside & (part | grown)
        if (larger == part).all():
            return part
        part = larger
