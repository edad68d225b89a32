"""The fit of a file: poles over model orders, and functions as measured and as synthesised from the modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.campaign.inspection import InspectedFunction, Inspection
from pkmodes.modaltest.identification.estimates import Stabilisation
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import label_decades, short_label
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.responses import draw_phases
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, INK, ORANGE, PURPLE, VERMILLION

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: A pole is stable if the previous order has one within these relative distances of its frequency and damping.
FREQUENCY_TOLERANCE, DAMPING_TOLERANCE = 0.005, 0.1
#: Half the height of the mark of a pole, relative to the smallest distance between orders.
MARK_HALF_HEIGHT = 0.3
#: Width of a digit relative to that of the axes on a narrow screen, and maximum number of label rows.
DIGIT_WIDTH, MAX_LABEL_ROWS = 0.032, 3
#: Decades of a magnitude drawn below its maximum.
MAX_DECADES = 5.0
POLE_STYLE: dict[str, Any] = {
    "color": GREY,
    "linewidth": 0.9,
    "solid_capstyle": "butt",
    "label": "pole",
    "zorder": 3,
}
STABLE_POLE_STYLE: dict[str, Any] = {**POLE_STYLE, "color": BLUE, "linewidth": 1.5, "label": "stable pole"}
MEASURED_STYLE: dict[str, Any] = {"color": VERMILLION, "linewidth": 2.4, "alpha": 0.55, "label": "measured"}
SYNTHESISED_STYLE: dict[str, Any] = {"color": BLUE, "linewidth": 1.1, "label": "synthesised"}


@dataclass(frozen=True)
class MarkedFrequencies:
    """Frequencies to be marked [Hz].

    - modes: frequency and number of each mode, and whether the campaign file added it
    - struck_out: frequencies of the modes that the campaign file strikes out
    - tones: frequencies of tones, which are no modes
    """

    modes: Sequence[tuple[float, int, bool]]
    struck_out: Sequence[float]
    tones: Sequence[float]


def stabilisation_diagram(
    inspection: Inspection, marked_frequencies: MarkedFrequencies, band: tuple[float, float]
) -> Drawing:
    """Draw the poles of all model orders over frequency, in front of the sum of the measured functions."""

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.7)
        axes = panel.axes
        sum_panel = sheet.add_panel(axes.twinx(), omitted_labels={"x"})
        axes.set_zorder(sum_panel.axes.get_zorder() + 1)
        magnitude = np.maximum(inspection.total, inspection.total.max() * 10.0**-MAX_DECADES)
        sum_panel.axes.set_yscale("log")
        sum_panel.plot(inspection.frequencies, magnitude, color=GREY, linewidth=1.0, alpha=0.8, zorder=0)
        sum_panel.axes.grid(visible=False)
        sum_panel.axes.spines["right"].set_visible(True)
        sum_panel.label(x="frequency [Hz]", y="sum of the functions [1]")
        label_decades(sum_panel.axes.yaxis)
        orders = inspection.stabilisation.orders
        for stable, style in ((False, POLE_STYLE), (True, STABLE_POLE_STYLE)):
            panel.plot(*_pole_marks(inspection.stabilisation, stable), **style)
        half_height = _mark_half_height(orders)
        axes.set_ylim(orders[0] - 1.5 * half_height, orders[-1] + 1.5 * half_height)
        axes.set_xlim(*band)
        panel.label(x="frequency [Hz]", y="model order")
        _draw_marked_frequencies(panel, marked_frequencies, band)
        axes.grid(visible=False, axis="x")
        placement: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.13)}
        sheet.legend(panel, ncols=6, columnspacing=1.2, fontsize=7.5, **placement)

    return Drawing(draw)


def _mark_half_height(orders: NDArray[np.int64]) -> float:
    """Return half the height of the mark of a pole, in orders."""
    return MARK_HALF_HEIGHT * float(np.diff(orders).min()) if len(orders) > 1 else MARK_HALF_HEIGHT


def _pole_marks(diagram: Stabilisation, stable: bool) -> tuple[Array, Array]:
    """Return a short vertical line for each pole, as one broken curve.

    - stable: whether for the stable poles, or for the others
    """
    x, y, half_height = [], [], _mark_half_height(diagram.orders)
    previous_poles: Complex = np.zeros(0, complex)
    for order, poles in zip(diagram.orders, diagram.poles, strict=True):
        frequencies = np.abs(poles[_is_stable(poles, previous_poles) == stable]) / (2.0 * np.pi)
        x.append(np.stack([frequencies, frequencies, np.full(len(frequencies), np.nan)], axis=1).ravel())
        y.append(np.tile([order - half_height, order + half_height, np.nan], len(frequencies)))
        previous_poles = poles
    return np.concatenate(x), np.concatenate(y)


def _is_stable(poles: Complex, previous_poles: Complex) -> NDArray[np.bool_]:
    """Return a mask of the poles that the previous order also has."""
    if not len(previous_poles) or not len(poles):
        return np.zeros(len(poles), bool)
    f, f0 = np.abs(poles)[:, None], np.abs(previous_poles)
    z, z0 = (-poles.real / np.abs(poles))[:, None], -previous_poles.real / np.abs(previous_poles)
    is_near = (np.abs(f0 / f - 1.0) < FREQUENCY_TOLERANCE) & (np.abs(z0 - z) < DAMPING_TOLERANCE * np.abs(z))
    return np.asarray(is_near.any(axis=1))


def _draw_marked_frequencies(
    panel: Panel, marked_frequencies: MarkedFrequencies, band: tuple[float, float]
) -> None:
    """Draw a line for each mode, with its number above, and for each mode struck out and each tone."""
    line_kinds: list[tuple[str, list[float], dict[str, Any]]] = [
        ("mode", [f for f, _, added in marked_frequencies.modes if not added], {"color": INK, "alpha": 0.9}),
        (
            "added",
            [f for f, _, added in marked_frequencies.modes if added],
            {"color": PURPLE, "linestyle": "-."},
        ),
        ("struck out", list(marked_frequencies.struck_out), {"color": VERMILLION, "linestyle": "--"}),
        ("tone", list(marked_frequencies.tones), {"color": ORANGE, "linestyle": ":", "linewidth": 1.2}),
    ]
    for name, frequencies, style in line_kinds:
        label: str | None = name
        for f in frequencies:
            panel.vertical_line(f, name, label=label, zorder=2, **{"linewidth": 0.8, "alpha": 0.75, **style})
            label = None
    fractions = [(f - band[0]) / (band[1] - band[0]) for f, _, _ in marked_frequencies.modes]
    numbers = [str(number) for _, number, _ in marked_frequencies.modes]
    transform = panel.axes.transAxes
    for x, number, row in zip(fractions, numbers, label_rows(fractions, numbers), strict=True):
        panel.axes.text(
            x, 1.01 + 0.035 * row, number, transform=transform, ha="center", va="bottom", fontsize=7
        )


def label_rows(positions: Sequence[float], labels: Sequence[str]) -> list[int]:
    """Return the row of each label, so that labels in a row do not overlap.

    - positions: ascending, as fractions of the width of the axes
    """
    ends, rows = [-1.0] * MAX_LABEL_ROWS, []
    for x, label in zip(positions, labels, strict=True):
        half_width = 0.5 * DIGIT_WIDTH * (len(label) + 0.5)
        row = next((k for k in range(MAX_LABEL_ROWS) if ends[k] <= x - half_width), int(np.argmin(ends)))
        ends[row] = x + half_width
        rows.append(row)
    return rows


def function_fits(
    inspection: Inspection, marked_frequencies: MarkedFrequencies, band: tuple[float, float], has_phase: bool
) -> Drawing:
    """Draw functions as measured and as synthesised from the modes: magnitude, phase, and coherence if known.

    - has_phase: whether the functions have a phase; power spectra have none
    """
    columns = min(2, len(inspection.curves))
    rows = -(-len(inspection.curves) // columns)
    has_coherence = any(curve.coherence is not None for curve in inspection.curves)
    height_ratios = [2.2, *([1.1] if has_phase else []), *([1.1] if has_coherence else [])]

    def draw(sheet: Sheet) -> None:
        height = (0.62 * sum(height_ratios) + 0.55) * rows + 0.25
        groups = sheet.groups(len(inspection.curves), columns, height, rows=height_ratios, share_x=True)
        labels = ["magnitude" if has_phase else "power"]
        labels += [*(["phase [\u00b0]"] if has_phase else []), *(["coherence"] if has_coherence else [])]
        for panels, curve in zip(groups, inspection.curves, strict=True):
            _draw_function(panels, curve, has_phase, has_coherence)
            for panel, label in zip(panels, labels, strict=True):
                for f, _, _ in marked_frequencies.modes:
                    panel.axes.axvline(f, color=INK, linewidth=0.5, alpha=0.35, zorder=1)
                panel.label(short_label(curve.name, 40), x="frequency [Hz]", y=label)
                if "x" not in panel.omitted_labels:
                    panel.axes.tick_params(labelbottom=True)
        groups[0][0].axes.set_xlim(*band)
        sheet.legend(groups[0][0], above_panel=False, loc="outside upper right", ncols=2)

    return Drawing(draw)


def _draw_function(
    panels: Sequence[Panel], curve: InspectedFunction, has_phase: bool, has_coherence: bool
) -> None:
    """Draw a function in its panels."""
    f, magnitude_panel = curve.frequencies, panels[0]
    magnitude_panel.axes.set_yscale("log")
    maximum = float(np.abs(curve.measured).max())
    curves = ((f, curve.measured, MEASURED_STYLE), (f, curve.synthesised, SYNTHESISED_STYLE))
    for _, values, style in curves:
        magnitude = np.abs(values)
        magnitude_panel.plot(
            f, np.where(magnitude > maximum * 10.0**-MAX_DECADES, magnitude, np.nan), **style
        )
    label_decades(magnitude_panel.axes.yaxis)
    if has_phase:
        draw_phases(panels[1], curves)
    if has_coherence:
        if curve.coherence is not None:
            panels[-1].plot(f, curve.coherence, color=VERMILLION, linewidth=0.9)
        panels[-1].axes.set_ylim(0.0, 1.05)
