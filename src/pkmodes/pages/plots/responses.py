"""Frequency responses: magnitude and phase of each channel, measured ones beneath those of the model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.machine.response.drawn_channels import without_response
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import decades
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, VERMILLION

Array = NDArray[Any]
#: Height of a channel [inch], and most channels drawn: more would be illegible.
HEIGHT, MOST = 2.4, 12
#: Ratio of the last to the first frequency above which the axis is logarithmic.
DECADES = 30.0
FREQUENCY = "frequency [Hz]"
#: Line styles: the line of the model stays visible on top of a measured one that it fits.
BEFORE = {"color": GREY, "linewidth": 1.1, "dashes": (4.0, 2.0), "label": "before", "zorder": 2.5}
MODEL = {"color": BLUE, "linewidth": 1.1, "label": "model", "zorder": 3}
MEASURED = {"color": VERMILLION, "linewidth": 2.4, "alpha": 0.55, "label": "measured", "zorder": 2}


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
    - title: above all
    - before: responses of another model by channel, such as the one before a correction, each (F,)
    """
    names, without_model_response = list(model)[:MOST], without_response(model, units)
    columns = min(2, len(names))
    rows = -(-len(names) // columns)
    height = HEIGHT * rows + 0.3 + (0.25 if title else 0.0)

    def draw(sheet: Sheet) -> None:
        if title:
            sheet.figure.suptitle(title, fontsize=8.5, x=0.01, ha="left", wrap=True)
        groups = sheet.groups(len(names), columns, height, rows=(2.2, 1.0), share_x=True)
        has_legend = False
        for k, (name, (above, below)) in enumerate(zip(names, groups, strict=True)):
            style = MODEL if before is None else {**MODEL, "label": "after"}
            curves: list[tuple[Array, Array, dict[str, Any]]] = [(frequencies, model[name], style)]
            if before is not None and name in before:
                curves.append((frequencies, before[name], BEFORE))
            if measured is not None and name in measured[1]:
                curves.append((measured[0], measured[1][name], MEASURED))
            if name in without_model_response:
                curves = curves[1:]
                annotation = "no response in the model"
                above.axes.annotate(annotation, (0.5, 0.5), xycoords="axes fraction", ha="center")
            _channel(above, below, curves, (float(frequencies[0]), float(frequencies[-1])))
            # Each channel has units of its own, so that every panel keeps the label of its vertical axis.
            above.inner, below.inner = {"x"}, {"title"} if k // columns == rows - 1 else {"title", "x"}
            above.label(name, x=FREQUENCY, y=f"magnitude [{units[name]}]")
            below.label(name, x=FREQUENCY, y="phase [\u00b0]")
            if len(curves) > 1 and not has_legend:
                above.axes.legend()
                has_legend = True

    return Drawing(draw)


def _channel(
    above: Panel, below: Panel, curves: list[tuple[Array, Array, dict[str, Any]]], ends: tuple[float, float]
) -> None:
    """Draw one channel: its magnitude and its phase, between two frequencies."""
    is_single = ends[0] == ends[1]
    if curves:
        above.axes.set_yscale("log")
    visible_curves = []
    for f, values, style in curves:
        in_range = (f >= ends[0]) & (f <= ends[1])
        visible_curves.append((f[in_range], values[in_range], {**style, "marker": "." if is_single else ""}))
    for f, values, style in visible_curves:
        magnitude = np.abs(values)
        above.plot(f, np.where(magnitude > 0.0, magnitude, np.nan), **style)
    draw_phases(below, visible_curves)
    if curves:
        decades(above.axes.yaxis)
    else:
        above.axes.set_yticks([])
    if is_single:
        return
    above.axes.set_xlim(*ends)
    if ends[0] > 0.0 and ends[1] / ends[0] > DECADES:
        below.axes.set_xscale("log")
        decades(below.axes.xaxis, lambda value: f"{value:g}")


def draw_phases(panel: Panel, curves: Iterable[tuple[Array, Array, dict[str, Any]]]) -> None:
    """Draw the phases of complex values over frequency, each with its style."""
    for f, values, style in curves:
        phase = np.degrees(np.angle(values))
        # No line joins +180 and -180 degrees.
        jumps = np.flatnonzero(np.abs(np.diff(phase)) > 180.0) + 1
        panel.plot(np.insert(f, jumps, f[jumps]), np.insert(phase, jumps, np.nan), **style)
    panel.axes.set_ylim(-190.0, 190.0)
    panel.axes.set_yticks([-180, 0, 180])
