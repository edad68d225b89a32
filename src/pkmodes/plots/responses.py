"""Frequency responses: magnitude and phase of each channel, measured ones over those of the model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.labels import typeset
from pkmodes.plots.style import BLUE, VERMILLION, WIDTH, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Height of a channel [inch], and channels drawn at most: more cannot be read.
HEIGHT, MOST = 2.4, 12
#: A response below this fraction of the largest one of the same unit is rounding.
NOTHING = 1e-10
#: Ratio of the last to the first frequency from which on the axis is logarithmic.
DECADES = 30.0


def responses(
    frequencies: Array,
    model: Mapping[str, Array],
    units: Mapping[str, str],
    measured: tuple[Array, Mapping[str, Array]] | None = None,
) -> Figure:
    """Draw responses: two channels side by side, magnitude above phase.

    Parameters
    ----------
    frequencies : ndarray, shape (F,)
        In Hz.
    model : mapping of str to ndarray, shape (F,)
        By channel.
    units : mapping of str to str
        Of the magnitudes, by channel.
    measured : tuple of ndarray and mapping, optional
        Frequencies, and responses by channel.
    """
    names = list(model)[:MOST]
    columns = min(2, len(names))
    rows = -(-len(names) // columns)
    drawn = figure(HEIGHT * rows + 0.3, WIDTH)
    panels = drawn.subplots(
        2 * rows, columns, squeeze=False, sharex=True, gridspec_kw={"height_ratios": [2.2, 1.0] * rows}
    )
    for k, name in enumerate(names):
        row, column = divmod(k, columns)
        above, below = panels[2 * row, column], panels[2 * row + 1, column]
        curves: list[tuple[Array, Array, dict[str, Any]]] = [
            (frequencies, model[name], {"color": BLUE, "label": "model"})
        ]
        if measured is not None and name in measured[1]:
            over = {"color": VERMILLION, "linewidth": 0.9, "label": "measured"}
            curves.append((measured[0], measured[1][name], over))
        largest = max(np.abs(model[other]).max() for other in model if units[other] == units[name])
        if np.abs(model[name]).max() <= NOTHING * largest:
            curves = curves[1:]
            above.annotate("no response in the model", (0.5, 0.5), xycoords="axes fraction", ha="center")
        for f, values, style in curves:
            seen = (f >= frequencies[0]) & (f <= frequencies[-1])
            size = np.abs(values[seen])
            above.semilogy(f[seen], np.where(size > 0.0, size, np.nan), **style)
            below.plot(f[seen], np.degrees(np.angle(values[seen])), **style)
        above.set_title(name)
        above.set_ylabel(f"[{units[name]}]")
        below.set_ylim(-190.0, 190.0)
        below.set_yticks([-180, 0, 180])
        below.set_ylabel("phase [deg]")
        if curves:
            above.yaxis.set_major_formatter(lambda value, _: typeset(f"{value:.0e}"))
        else:
            above.set_yticks([])
        above.set_xlim(frequencies[0], frequencies[-1])
        if len(curves) > 1:
            above.legend()
        if frequencies[0] > 0.0 and frequencies[-1] / frequencies[0] > DECADES:
            below.set_xscale("log")
        if row == rows - 1:
            below.set_xlabel("frequency [Hz]")
    if len(names) % columns:
        for panel in panels[2 * rows - 2 :, columns - 1]:
            panel.set_visible(False)
    return drawn
