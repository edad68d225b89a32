"""What shapers leave of the vibration: over the workspace, and where frequencies differ from the model's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.style import GREY, PALETTE, WIDTH, figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Share of a grid that poses fill, from which on it is drawn as one.
FILLED = 0.25
#: Height of a map over its width, at least and at most; space for titles and labels [inch].
SHAPES, AROUND = (0.3, 1.3), 0.75
#: Part of the width that a single map has, as one over this.
ALONE = 1.6


def over_plane(
    points: Array, names: Sequence[str], units: Sequence[tuple[str, float]], left: Mapping[str, Array]
) -> Figure:
    """Draw what shapers leave at poses in a plane, one map for each, on a common scale.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        SI.
    names, units : sequence
        Of the two components, and the unit in which each is drawn with its factor.
    left : mapping of str to ndarray, shape (N,)
        By shaper [%].
    """
    x, y = (points[:, i] * units[i][1] for i in (0, 1))
    alike = units[0][0] == units[1][0]
    shape = float(np.clip(np.ptp(y) / np.ptp(x), *SHAPES)) if alike else 0.8
    drawn = figure(shape * (WIDTH - 1.2) / max(len(left), ALONE) + AROUND)
    panels = drawn.subplots(1, len(left), squeeze=False, sharey=True)[0]
    highest = max(1e-9, *(float(values.max()) for values in left.values()))
    for axes, (title, values) in zip(panels, left.items(), strict=True):
        mesh = _map(axes, x, y, values, highest, len(left))
        axes.set_title(title)
        axes.set_xlabel(f"{names[0]} [{units[0][0]}]")
        axes.grid(False)
        if alike and SHAPES[0] <= np.ptp(y) / np.ptp(x) <= SHAPES[1]:
            axes.set_aspect("equal")
    panels[0].set_ylabel(f"{names[1]} [{units[1][0]}]")
    bar = drawn.colorbar(mesh, ax=panels, aspect=15)
    bar.set_label("left [%]")
    return drawn


def _map(axes: Axes, x: Array, y: Array, values: Array, highest: float, panels: int) -> Any:
    """Draw values over a plane: as cells of a grid where the points form one, else as squares."""
    columns, i = np.unique(x.round(9), return_inverse=True)
    rows, k = np.unique(y.round(9), return_inverse=True)
    if len(x) >= FILLED * len(rows) * len(columns):
        cells = np.full((len(rows), len(columns)), np.nan)
        cells[np.ravel(k), np.ravel(i)] = values
        return axes.pcolormesh(columns, rows, cells, shading="nearest", vmin=0, vmax=highest, rasterized=True)
    size = max(2.0, min(60.0, 9000.0 / len(x) / panels))
    style: dict[str, Any] = {"marker": "s", "linewidths": 0.0, "vmin": 0.0, "vmax": highest}
    return axes.scatter(x, y, c=values, s=size, rasterized=True, **style)


def along_line(at: Array, name: str, unit: tuple[str, float], left: Mapping[str, Array]) -> Figure:
    """Draw what shapers leave at poses along a line.

    Parameters
    ----------
    at : ndarray, shape (N,)
        The component of the pose that changes [SI].
    left : mapping of str to ndarray, shape (N,)
        By shaper [%].
    """
    drawn = figure(2.6)
    axes = drawn.subplots()
    order = np.argsort(at)
    _curves(axes, at[order] * unit[1], {title: values[order] for title, values in left.items()})
    axes.set_xlabel(f"{name} [{unit[0]}]")
    axes.set_ylabel("left [%]")
    return drawn


def against_error(errors: Array, left: Mapping[str, Array], spread: float | None) -> Figure:
    """Draw what shapers leave where all frequencies differ from those of the model.

    Parameters
    ----------
    errors : ndarray, shape (E,)
        Relative errors of the frequencies.
    left : mapping of str to ndarray, shape (E,)
        By shaper [%]: the root mean square over the poses, relative to none.
    spread : float or None
        Mean standard deviation of the frequencies, as a band.
    """
    drawn = figure(2.9)
    axes = drawn.subplots()
    if spread is not None:
        axes.axvspan(-100.0 * spread, 100.0 * spread, color=GREY, alpha=0.2, linewidth=0.0)
    _curves(axes, 100.0 * errors, left)
    axes.set_xlabel("frequencies, above those of the model [%]")
    axes.set_ylabel("left, rms [%]")
    return drawn


def _curves(axes: Axes, x: Array, left: Mapping[str, Array]) -> None:
    styles = ("-", "--", ":", "-.")
    for i, (name, values) in enumerate(left.items()):
        axes.plot(x, values, styles[i % len(styles)], color=PALETTE[i % len(PALETTE)], label=name)
    axes.set_xlim(x[0], x[-1])
    axes.set_ylim(0.0, None)
    axes.legend(ncols=2, fontsize=7.5, loc="lower center", bbox_to_anchor=(0.5, 1.0))
