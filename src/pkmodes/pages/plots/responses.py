"""Frequency responses: magnitude and phase of each channel, measured ones behind those of the model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.machine.response.drawn_channels import without_response
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import label_decades
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, VERMILLION

Array = NDArray[Any]
#: Height of a channel [inch], and maximum number of channels: more would be illegible.
CHANNEL_HEIGHT, MAX_CHANNELS = 2.4, 12
#: Ratio of the last to the first frequency above which the axis is logarithmic.
LOG_AXIS_RATIO = 30.0
FREQUENCY_LABEL = "frequency [Hz]"
#: Line styles: the line of the model stays visible on top of a measured one that it fits.
BEFORE_STYLE = {"color": GREY, "linewidth": 1.1, "dashes": (4.0, 2.0), "label": "before", "zorder": 2.5}
MODEL_STYLE = {"color": BLUE, "linewidth": 1.1, "label": "model", "zorder": 3}
MEASURED_STYLE = {"color": VERMILLION, "linewidth": 2.4, "alpha": 0.55, "label": "measured", "zorder": 2}


def responses(
    frequencies: Array,
    model: Mapping[str, Array],
    units: Mapping[str, str],
    measured: tuple[Array, Mapping[str, Array]] | None = None,
    title: str = "",
    before: Mapping[str, Array] | None = None,
) -> Drawing:
    """Draw responses: two channels side by side, magnitude above phase.

    - frequencies: in Hz, (F,)
    - model: by channel, each (F,)
    - units: of the magnitudes, by channel
    - measured: frequencies, and responses by channel
    - title: above the figure
    - before: responses of another model by channel, such as the one before a correction, each (F,)
    """
    names, without_model_response = list(model)[:MAX_CHANNELS], without_response(model, units)
    columns = min(2, len(names))
    rows = -(-len(names) // columns)
    height = CHANNEL_HEIGHT * rows + 0.3 + (0.25 if title else 0.0)

    def draw(sheet: Sheet) -> None:
        if title:
            sheet.figure.suptitle(title, fontsize=8.5, x=0.01, ha="left", wrap=True)
        groups = sheet.groups(len(names), columns, height, rows=(2.2, 1.0), share_x=True)
        has_legend = False
        for k, (name, (magnitude_panel, phase_panel)) in enumerate(zip(names, groups, strict=True)):
            style = MODEL_STYLE if before is None else {**MODEL_STYLE, "label": "after"}
            curves: list[tuple[Array, Array, dict[str, Any]]] = [(frequencies, model[name], style)]
            if before is not None and name in before:
                curves.append((frequencies, before[name], BEFORE_STYLE))
            if measured is not None and name in measured[1]:
                curves.append((measured[0], measured[1][name], MEASURED_STYLE))
            if name in without_model_response:
                curves = curves[1:]
                annotation = "no response in the model"
                magnitude_panel.axes.annotate(annotation, (0.5, 0.5), xycoords="axes fraction", ha="center")
            _draw_channel(
                magnitude_panel, phase_panel, curves, (float(frequencies[0]), float(frequencies[-1]))
            )
            # Each channel has its own units, so every panel keeps the label of its vertical axis.
            magnitude_panel.omitted_labels, phase_panel.omitted_labels = (
                {"x"},
                {"title"} if k // columns == rows - 1 else {"title", "x"},
            )
            magnitude_panel.label(name, x=FREQUENCY_LABEL, y=f"magnitude [{units[name]}]")
            phase_panel.label(name, x=FREQUENCY_LABEL, y="phase [\u00b0]")
            if len(curves) > 1 and not has_legend:
                magnitude_panel.axes.legend()
                has_legend = True

    return Drawing(draw)


def _draw_channel(
    magnitude_panel: Panel,
    phase_panel: Panel,
    curves: list[tuple[Array, Array, dict[str, Any]]],
    frequency_range: tuple[float, float],
) -> None:
    """Draw the magnitude and the phase of a channel in a range of frequencies."""
    is_single_frequency = frequency_range[0] == frequency_range[1]
    if curves:
        magnitude_panel.axes.set_yscale("log")
    visible_curves = []
    for f, values, style in curves:
        in_range = (f >= frequency_range[0]) & (f <= frequency_range[1])
        visible_curves.append(
            (f[in_range], values[in_range], {**style, "marker": "." if is_single_frequency else ""})
        )
    for f, values, style in visible_curves:
        magnitude = np.abs(values)
        magnitude_panel.plot(f, np.where(magnitude > 0.0, magnitude, np.nan), **style)
    draw_phases(phase_panel, visible_curves)
    if curves:
        label_decades(magnitude_panel.axes.yaxis)
    else:
        magnitude_panel.axes.set_yticks([])
    if is_single_frequency:
        return
    magnitude_panel.axes.set_xlim(*frequency_range)
    if frequency_range[0] > 0.0 and frequency_range[1] / frequency_range[0] > LOG_AXIS_RATIO:
        phase_panel.axes.set_xscale("log")
        label_decades(phase_panel.axes.xaxis, lambda value: f"{value:g}")


def draw_phases(panel: Panel, curves: Iterable[tuple[Array, Array, dict[str, Any]]]) -> None:
    """Draw the phases of complex values over frequency, each with its style."""
    for f, values, style in curves:
        phase = np.degrees(np.angle(values))
        # Break the curve where the phase jumps between +180 and -180 degrees.
        jumps = np.flatnonzero(np.abs(np.diff(phase)) > 180.0) + 1
        panel.plot(np.insert(f, jumps, f[jumps]), np.insert(phase, jumps, np.nan), **style)
    panel.axes.set_ylim(-190.0, 190.0)
    panel.axes.set_yticks([-180, 0, 180])
