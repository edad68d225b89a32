"""Maps of a plane: frequencies, directions and components of the platform's motion (figures 8 to 20 of the paper)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.plane import Plane, limits_of
from pkmodes.plots.style import INK, VERMILLION, WHITE, WIDTH, figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Part of the centre line at each end where its extremes are not looked for.
EDGE = 0.05
#: Lines along the shorter side of a map.
STROKES = 9
#: Space for labels and colour bars beside and below each panel [inch].
BESIDE, BELOW, UNDER = 0.62, 1.0, 0.62
#: Height of a panel over its width at most.
TALLEST = 3.5


def frequencies(plane: Plane, motors: Array | None = None) -> Figure:
    """Draw the frequency of each mode, with its extremes along the centre line (figure 8).

    Parameters
    ----------
    motors : ndarray, shape (N, 2), optional
        Positions of the motors (across, along) in the drawn units.
    """
    values = plane.dataset["frequency"].values
    modes = values.shape[-1]
    drawn, panels = panels_of(plane, modes, colour_bars=True)
    for mode, axes in mode_panels(plane, panels, modes):
        one = values[..., mode]
        low, high = limits_of(one)
        mesh = plane.draw(axes, one, vmin=low, vmax=high)
        _contours(plane, axes, one, low, high)
        _extremes(plane, axes, one)
        _motors(axes, motors)
        scale_beside(plane, axes, mesh, "f [Hz]")
    return drawn


def directions(plane: Plane) -> Figure:
    """Draw the direction of the platform's motion in each mode (figures 9 to 14).

    Lines show the part in the plane, as long as its share of the motion; colours the share perpendicular to it.
    """
    motion = plane.dataset["platform_shape"].values
    names = plane.dataset["direction"].values.tolist()
    across, along = names.index(plane.across), names.index(plane.along)
    length = np.sqrt((motion**2).sum(axis=-1))
    unit = motion / np.where(length > 0.0, length, np.nan)[..., None]
    modes = motion.shape[2]
    drawn, panels = panels_of(plane, modes, colour_bars=False)
    x, y = plane.drawn(plane.across), plane.drawn(plane.along)
    step = max(1, round(min(len(x), len(y)) / STROKES))
    rows, columns = (slice(step // 2, None, step) for _ in range(2))
    mesh = None
    for mode, axes in mode_panels(plane, panels, modes):
        perpendicular = np.sqrt(
            np.clip(1.0 - unit[:, :, mode, across] ** 2 - unit[:, :, mode, along] ** 2, 0.0, 1.0)
        )
        if plane.normal is None:
            perpendicular = np.where(np.isfinite(unit[:, :, mode, across]), 0.0, np.nan)
        mesh = plane.draw(axes, perpendicular, vmin=0.0, vmax=1.0, cmap="Blues")
        part = unit[rows, columns, mode]
        reach = step * (y[-1] - y[0]) / max(len(y) - 1, 1) * 0.45
        _strokes(axes, x[columns], y[rows], reach * part[..., across], reach * part[..., along])
    if mesh is not None and plane.normal is not None:
        bar = drawn.colorbar(mesh, ax=panels, location="right", shrink=0.9, aspect=35)
        bar.set_label(f"share of the motion along {plane.normal} [1]")
    return drawn


def components(plane: Plane) -> Figure:
    """Draw the in-plane and out-of-plane motion of the platform in each mode, all on one scale (figures 15 to 20).

    Mass-normalised shapes are compared: the platform's motion for the same kinetic energy of the whole robot.
    """
    rows = [("in_plane", "in plane")]
    if plane.normal is not None:
        rows.append(("out_of_plane", f"along {plane.normal}"))
    modes = plane.dataset.sizes["mode"]
    every = np.concatenate([plane.dataset[name].values.ravel() for name, _ in rows])
    high = limits_of(every)[1]
    width = (WIDTH - 1.3) / modes
    drawn = _figure(len(rows) * (min(plane.height, TALLEST) * width + 0.2) + 0.8)
    panels = drawn.subplots(len(rows), modes, squeeze=False)
    mesh = None
    for row, (name, title) in enumerate(rows):
        for mode in range(modes):
            axes = panels[row, mode]
            mesh = plane.draw(axes, plane.dataset[name].values[..., mode], vmin=0.0, vmax=high)
            axes.set_title(f"mode {mode + 1}" if row == 0 else "")
            plane.label_axes(axes, left=mode == 0, bottom=row == len(rows) - 1)
        panels[row, 0].set_ylabel(f"{title}\n{plane.label(plane.along)}")
    if mesh is not None:
        bar = drawn.colorbar(mesh, ax=panels, location="right", shrink=0.7, aspect=30, extend="max")
        bar.set_label("mass-normalised motion [1/\N{SQUARE ROOT}kg]")
    return drawn


def scale_beside(plane: Plane, axes: Axes, mesh: Any, label: str) -> None:
    """Draw the colour scale of one panel: below a tall map, right of another."""
    from matplotlib.ticker import MaxNLocator

    inches = min(plane.height, TALLEST) * WIDTH / 7
    below = (0.0, -UNDER / inches, 1.0, 0.08 / inches)
    inset = axes.inset_axes(below if plane.is_tall else (1.05, 0.0, 0.06, 1.0))
    orientation = "horizontal" if plane.is_tall else "vertical"
    bar = axes.figure.colorbar(mesh, cax=inset, orientation=orientation, extend="both")
    bar.set_label(label)
    bar.locator = MaxNLocator(2 if plane.is_tall else 5)
    bar.update_ticks()
    bar.ax.tick_params(length=2)


def _strokes(axes: Axes, x: Array, y: Array, across: Array, along: Array) -> None:
    """Draw a line through each pose in the direction of a vibration, which has no sign."""
    from matplotlib.collections import LineCollection

    place = np.stack(np.meshgrid(x, y), axis=-1)
    half = np.stack([across, along], axis=-1)
    lines = np.stack([place - half, place + half], axis=-2).reshape(-1, 2, 2)
    axes.add_collection(
        LineCollection(lines[np.isfinite(lines).all(axis=(1, 2))], colors=VERMILLION, linewidths=1.2)
    )


def _figure(height: float) -> Figure:
    drawn = figure(height)
    drawn.set_layout_engine("compressed")
    return drawn


def panels_of(plane: Plane, modes: int, *, colour_bars: bool) -> tuple[Figure, Any]:
    """Return a figure with a panel for each mode: one row of tall maps, otherwise rows of three."""
    columns = modes if plane.is_tall and modes <= 6 else min(modes, 3)
    rows = -(-modes // columns)
    beside = BESIDE if colour_bars and not plane.is_tall else 0.15
    width = WIDTH / columns - beside
    height = min(plane.height, TALLEST) * width + (BELOW if colour_bars and plane.is_tall else 0.25)
    drawn = _figure(rows * (height + 0.3) + 0.3)
    return drawn, drawn.subplots(rows, columns, squeeze=False)


def mode_panels(plane: Plane, panels: Any, modes: int) -> Iterator[tuple[int, Axes]]:
    """Yield each mode with its panel, titled, and labelled where no panel is beside or below; others stay empty."""
    columns = panels.shape[1]
    for mode, axes in enumerate(panels.flat):
        if mode >= modes:
            axes.set_axis_off()
            continue
        yield mode, axes
        axes.set_title(f"mode {mode + 1}")
        plane.label_axes(axes, left=mode % columns == 0, bottom=mode + columns >= modes)


def _contours(plane: Plane, axes: Axes, values: Array, low: float, high: float) -> None:
    levels = np.linspace(low, high, 9)[1:-1]
    finite = np.isfinite(values)
    if finite.any() and values[finite].min() < levels[-1] and values[finite].max() > levels[0]:
        axes.contour(
            plane.drawn(plane.across),
            plane.drawn(plane.along),
            np.ma.masked_invalid(values),
            levels,
            colors=WHITE,
            linewidths=0.4,
            alpha=0.7,
        )


def extremes(plane: Plane, values: Array) -> dict[str, tuple[int, float]]:
    """Return the minimum and maximum along the centre line, without its ends.

    Parameters
    ----------
    values : ndarray, shape (along, across)

    Returns
    -------
    dict
        For ``minimum`` and ``maximum`` the index along the line and the value; empty if no pose can be evaluated.
    """
    line = values[:, plane.middle]
    reached = np.flatnonzero(np.isfinite(line))
    if not len(reached):
        return {}
    place = plane.dataset[plane.along].values
    margin = EDGE * (place[reached[-1]] - place[reached[0]])
    kept = reached[
        (place[reached] >= place[reached[0]] + margin) & (place[reached] <= place[reached[-1]] - margin)
    ]
    kept = kept if len(kept) else reached
    lowest, highest = kept[np.argmin(line[kept])], kept[np.argmax(line[kept])]
    return {"minimum": (int(lowest), float(line[lowest])), "maximum": (int(highest), float(line[highest]))}


def _extremes(plane: Plane, axes: Axes, values: Array) -> None:
    """Mark the extremes along the centre line: a triangle down for the minimum, up for the maximum."""
    x, y = plane.drawn(plane.across)[plane.middle], plane.drawn(plane.along)
    for name, (place, _) in extremes(plane, values).items():
        marker = "v" if name == "minimum" else "^"
        axes.plot(x, y[place], marker, color=VERMILLION, markeredgecolor=WHITE, markersize=6, clip_on=False)


def _motors(axes: Axes, motors: Array | None) -> None:
    if motors is None:
        return
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    # A motor beyond the map is marked at its edge.
    x, y = np.clip(motors[:, 0], left, right), np.clip(motors[:, 1], bottom, top)
    axes.plot(x, y, "s", color=INK, markersize=4.5, clip_on=False)
