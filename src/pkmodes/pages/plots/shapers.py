"""The vibration that remains with shapers: over the workspace, over frequency, and for wrong frequencies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import (
    BLUE,
    FIGURE_WIDTH,
    GREEN,
    GREY,
    INK,
    ORANGE,
    PALETTE,
    PURPLE,
    SKY,
    VERMILLION,
)

Array = NDArray[Any]
#: Colours of the shapers that are not recommended.
OTHER_COLOURS = (GREEN, ORANGE, PURPLE, SKY)
#: Upper end of an axis for values up to 100 %.
PERCENT_AXIS_TOP = 104.0
#: Poses that fill at least this fraction of a grid are drawn as its cells.
MIN_GRID_FRACTION = 0.25
#: Minimum and maximum ratio of height to width of a map; space for titles and labels [inch].
HEIGHT_TO_WIDTH_LIMITS, LABEL_HEIGHT = (0.3, 1.3), 0.75
#: Minimum number of maps by which the width of a figure is divided, so that a single map is not too large.
MIN_MAP_COLUMNS = 1.6


def over_plane(
    points: Array, names: Sequence[str], units: Sequence[tuple[str, float]], remaining: Mapping[str, Array]
) -> Drawing:
    """Draw the vibration that remains at poses in a plane, one map for each shaper, on a common scale.

    - points: SI, (N, 2)
    - names, units: of the two components, and the unit in which each is drawn with its factor
    - remaining: by shaper, each (N,) [%]
    """
    x, y = (points[:, i] * units[i][1] for i in (0, 1))
    same_units = units[0][0] == units[1][0]
    x_label, y_label = (f"{names[i]} [{units[i][0]}]" for i in (0, 1))
    ratio = float(np.ptp(y) / np.ptp(x))
    height_to_width = float(np.clip(ratio, *HEIGHT_TO_WIDTH_LIMITS)) if same_units else 0.8
    equal_scales = same_units and HEIGHT_TO_WIDTH_LIMITS[0] <= ratio <= HEIGHT_TO_WIDTH_LIMITS[1]
    highest = max(1e-9, *(float(values.max()) for values in remaining.values()))

    def draw(sheet: Sheet) -> None:
        count, panel_height_to_width = len(remaining), height_to_width if equal_scales else 0.0
        height = height_to_width * (FIGURE_WIDTH - 1.2) / max(count, MIN_MAP_COLUMNS) + LABEL_HEIGHT
        sheet.groups(
            count, count, height, share_y=True, height_to_width=panel_height_to_width, scales="common"
        )
        mesh: Any = None
        for panel, (title, values) in zip(sheet.panels, remaining.items(), strict=True):
            mesh = _draw_map(panel, x, y, values, highest, count)
            panel.label(title, x=x_label, y=y_label)
            panel.axes.grid(False)
            if equal_scales:
                panel.axes.set_aspect("equal")
        sheet.colour_scale(mesh, "left [%]", aspect=15)

    return Drawing(draw)


def _draw_map(panel: Panel, x: Array, y: Array, values: Array, highest: float, panel_count: int) -> Any:
    """Draw values over a plane: as the cells of a grid if the points form one, else as square marks."""
    columns, column_index = np.unique(x.round(9), return_inverse=True)
    rows, row_index = np.unique(y.round(9), return_inverse=True)
    if len(x) >= MIN_GRID_FRACTION * len(rows) * len(columns):
        cells = np.full((len(rows), len(columns)), np.nan)
        cells[np.ravel(row_index), np.ravel(column_index)] = values
        return panel.cells(columns, rows, cells, vmin=0, vmax=highest, rasterized=True)
    size = max(2.0, min(60.0, 9000.0 / len(x) / panel_count))
    style: dict[str, Any] = {"marker": "s", "linewidths": 0.0, "vmin": 0.0, "vmax": highest}
    return panel.scatter(x, y, values=values, s=size, rasterized=True, **style)


def along_line(
    positions: Array, name: str, unit: tuple[str, float], remaining: Mapping[str, Array]
) -> Drawing:
    """Draw the vibration that remains with each shaper at poses along a line.

    - positions: the component of the pose that varies, (N,) [SI]
    - remaining: by shaper, each (N,) [%]
    """
    order = np.argsort(positions)

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.6)
        panel.label(x=f"{name} [{unit[0]}]", y="left [%]")
        _draw_curves(
            sheet,
            panel,
            positions[order] * unit[1],
            {title: values[order] for title, values in remaining.items()},
        )

    return Drawing(draw)


def against_error(errors: Array, remaining: Mapping[str, Array], spread: float | None) -> Drawing:
    """Draw the vibration that remains with each shaper if all frequencies differ from those of the model.

    - errors: relative errors of the frequencies, (E,)
    - remaining: by shaper, each (E,) [%]: the root mean square over the poses, relative to that without a shaper
    - spread: mean relative standard deviation of the frequencies, shown as a band
    """

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.9)
        if spread is not None:
            panel.axes.axvspan(-100.0 * spread, 100.0 * spread, color=GREY, alpha=0.2, linewidth=0.0)
        panel.label(x="frequencies, above those of the model [%]", y="left, rms [%]")
        _draw_curves(sheet, panel, 100.0 * errors, remaining)

    return Drawing(draw)


def _draw_curves(sheet: Sheet, panel: Panel, x: Array, remaining: Mapping[str, Array]) -> None:
    styles = ("-", "--", ":", "-.")
    for i, (name, values) in enumerate(remaining.items()):
        panel.plot(x, values, styles[i % len(styles)], color=PALETTE[i % len(PALETTE)], label=name)
    panel.axes.set_xlim(x[0], x[-1])
    panel.axes.set_ylim(0.0, None)
    sheet.legend(panel, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, fontsize=7.5)


@dataclass(frozen=True)
class ShaperCurve:
    """The vibration of a mode that remains with a shaper, at each frequency of the mode [%]."""

    name: str
    remaining: Array
    is_recommended: bool


@dataclass(frozen=True)
class Spectrum:
    """Amplitudes of a measured spectrum, before and after the recommended shaper [% of the maximum before]."""

    frequencies: Array
    before: Array
    after: Array


@dataclass(frozen=True)
class MarkedModes:
    """Measured modes with the recommended shaper.

    - frequencies: in Hz
    - remaining, max_remaining: vibration that remains of the modes as measured, and at most within their errors [%]
    - range_label: label of the lines from the first to the second
    """

    frequencies: Array
    remaining: Array
    max_remaining: Array
    range_label: str


def over_frequency(
    frequencies: Array, curves: Sequence[ShaperCurve], spectrum: Spectrum | None, modes: MarkedModes | None
) -> Drawing:
    """Draw the vibration of a mode that remains at each frequency, over a measured spectrum if there is one.

    - frequencies: of the curves, (F,) [Hz]
    - curves: of all shapers, with the recommended one
    """
    frequency_label = "frequency [Hz]"

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.6)
        mode_panel = panel
        if spectrum is not None:
            mode_panel = sheet.add_panel(panel.axes.twinx(), omitted_labels={"x"})
            mode_panel.axes.grid(visible=False)
            mode_panel.axes.spines["right"].set_visible(True)
            _draw_spectrum(panel, spectrum)
            panel.label(x=frequency_label, y="amplitude of the spectrum [% of the highest]")
        mode_panel.label(x=frequency_label, y="left of a mode at this frequency [%]")
        colours = iter(OTHER_COLOURS)
        for curve in sorted(curves, key=lambda candidate: not candidate.is_recommended):
            style: dict[str, Any] = {"color": VERMILLION, "linewidth": 2.0, "zorder": 3}
            if not curve.is_recommended:
                style = {"color": next(colours), "linewidth": 1.1}
            mode_panel.plot(
                frequencies, curve.remaining, "-" if curve.is_recommended else "--", label=curve.name, **style
            )
        if modes is not None:
            segment_y = np.stack([modes.remaining, modes.max_remaining], axis=-1)
            segment_x = np.stack([modes.frequencies] * 2, axis=-1)
            mode_panel.lines(
                segment_x, segment_y, color=INK, linewidth=1.0, label=modes.range_label, zorder=4
            )
            dot_style: dict[str, Any] = {"marker": "o", "s": 14, "color": INK, "zorder": 5}
            mode_panel.scatter(modes.frequencies, modes.remaining, label="measured modes", **dot_style)
        mode_panel.axes.set_ylim(0.0, PERCENT_AXIS_TOP)
        panel.axes.set_xlim(0.0, frequencies[-1])
        legends = [
            axes_panel.axes.get_legend_handles_labels() for axes_panel in dict.fromkeys([panel, mode_panel])
        ]
        handles, names = (
            [handle for legend in legends for handle in legend[0]],
            [name for legend in legends for name in legend[1]],
        )
        placement: dict[str, Any] = {
            "loc": "lower center",
            "bbox_to_anchor": (0.5, 1.0),
            "ncols": 3,
            "fontsize": 7.0,
        }
        sheet.legend_from_handles(handles, names, above_panel=panel, **placement)

    return Drawing(draw)


def _draw_spectrum(panel: Panel, spectrum: Spectrum) -> None:
    """Draw the spectrum before and after the recommended shaper."""
    panel.axes.fill_between(spectrum.frequencies, 0.0, spectrum.before, color=GREY, alpha=0.25, linewidth=0.0)
    panel.plot(spectrum.frequencies, spectrum.before, color=GREY, linewidth=1.2, label="measured spectrum")
    panel.axes.fill_between(spectrum.frequencies, 0.0, spectrum.after, color=BLUE, alpha=0.35, linewidth=0.0)
    panel.plot(
        spectrum.frequencies, spectrum.after, color=BLUE, linewidth=1.4, label="after the recommended shaper"
    )
    panel.axes.set_ylim(0.0, PERCENT_AXIS_TOP)
