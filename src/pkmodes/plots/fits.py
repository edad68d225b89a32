"""The fit of a file: poles over model orders, and functions as measured and as synthesised from the modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.campaign.inspection import Curve, Inspection
from pkmodes.identification.estimates import Stabilisation
from pkmodes.plots.labels import decades, short, typeset
from pkmodes.plots.style import BLUE, GREY, INK, ORANGE, PURPLE, VERMILLION, figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: A pole is stable if the order before has one within these of its frequency and damping, relative.
SAME_FREQUENCY, SAME_DAMPING = 0.005, 0.1
#: Half the height of a pole's mark, relative to the least distance of orders.
HALF = 0.3
#: Width of a digit relative to that of the axes on a narrow screen, and rows of labels at most.
DIGIT, ROWS = 0.032, 3
#: Decades of a magnitude below its highest value that are drawn.
DECADES = 5.0
POLE: dict[str, Any] = {
    "color": GREY,
    "linewidth": 0.9,
    "solid_capstyle": "butt",
    "label": "pole",
    "zorder": 3,
}
STABLE: dict[str, Any] = {**POLE, "color": BLUE, "linewidth": 1.5, "label": "stable pole"}
MEASURED: dict[str, Any] = {"color": VERMILLION, "linewidth": 2.4, "alpha": 0.55, "label": "measured"}
SYNTHESISED: dict[str, Any] = {"color": BLUE, "linewidth": 1.1, "label": "synthesised"}


@dataclass(frozen=True)
class Lines:
    """Frequencies that are marked [Hz]: modes with their numbers, modes struck out, and tones."""

    modes: Sequence[tuple[float, int, bool]]
    struck: Sequence[float]
    tones: Sequence[float]


def stabilisation(one: Inspection, marked: Lines, band: tuple[float, float]) -> Figure:
    """Return the poles of all model orders over frequency, above the sum of the measured functions."""
    with styled():
        drawn = figure(3.7)
        axes = drawn.subplots()
        behind = axes.twinx()
        axes.set_zorder(behind.get_zorder() + 1)
        size = np.maximum(one.total, one.total.max() * 10.0**-DECADES)
        behind.semilogy(one.frequencies, size, color=GREY, linewidth=1.0, alpha=0.8, zorder=0)
        behind.grid(visible=False)
        behind.spines["right"].set_visible(True)
        behind.set_ylabel("sum of the functions [1]")
        decades(behind.yaxis, lambda value: typeset(f"{value:.0e}"))
        orders = one.stabilisation.orders
        for stable, style in ((False, POLE), (True, STABLE)):
            axes.plot(*_dashes(one.stabilisation, stable), **style)
        half = _half(orders)
        axes.set_ylim(orders[0] - 1.5 * half, orders[-1] + 1.5 * half)
        axes.set_xlim(*band)
        axes.set_ylabel("model order")
        axes.set_xlabel("frequency [Hz]")
        _mark(axes, marked, band)
        axes.grid(visible=False, axis="x")
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.13), ncols=6, columnspacing=1.2, fontsize=7.5)
    return drawn


def _half(orders: NDArray[np.int64]) -> float:
    """Return half the height of a pole's mark, in orders."""
    return HALF * float(np.diff(orders).min()) if len(orders) > 1 else HALF


def _dashes(of: Stabilisation, stable: bool) -> tuple[Array, Array]:
    """Return a short vertical line for each pole of one kind, as one broken curve."""
    x, y, half = [], [], _half(of.orders)
    before: Complex = np.zeros(0, complex)
    for order, poles in zip(of.orders, of.poles, strict=True):
        chosen = np.abs(poles[_stable(poles, before) == stable]) / (2.0 * np.pi)
        x.append(np.stack([chosen, chosen, np.full(len(chosen), np.nan)], axis=1).ravel())
        y.append(np.tile([order - half, order + half, np.nan], len(chosen)))
        before = poles
    return np.concatenate(x), np.concatenate(y)


def _stable(poles: Complex, before: Complex) -> NDArray[np.bool_]:
    """Return which poles the order before has, too."""
    if not len(before) or not len(poles):
        return np.zeros(len(poles), bool)
    f, f0 = np.abs(poles)[:, None], np.abs(before)
    z, z0 = (-poles.real / np.abs(poles))[:, None], -before.real / np.abs(before)
    near = (np.abs(f0 / f - 1.0) < SAME_FREQUENCY) & (np.abs(z0 - z) < SAME_DAMPING * np.abs(z))
    return np.asarray(near.any(axis=1))


def _mark(axes: Axes, marked: Lines, band: tuple[float, float]) -> None:
    """Draw a line for each mode, with its number above, and for each mode struck out and each tone."""
    kinds: list[tuple[list[float], dict[str, Any]]] = [
        ([f for f, _, added in marked.modes if not added], {"color": INK, "alpha": 0.45, "label": "mode"}),
        (
            [f for f, _, added in marked.modes if added],
            {"color": PURPLE, "linestyle": "-.", "label": "added"},
        ),
        (list(marked.struck), {"color": VERMILLION, "linestyle": "--", "label": "struck out"}),
        (list(marked.tones), {"color": ORANGE, "linestyle": ":", "linewidth": 1.2, "label": "tone"}),
    ]
    for frequencies, style in kinds:
        for f in frequencies:
            axes.axvline(f, zorder=2, **{"linewidth": 0.8, "alpha": 0.75, **style})
            style = {**style, "label": None}
    at = [(f - band[0]) / (band[1] - band[0]) for f, _, _ in marked.modes]
    names = [str(number) for _, number, _ in marked.modes]
    for x, name, row in zip(at, names, rows_of(at, names), strict=True):
        axes.text(x, 1.01 + 0.035 * row, name, transform=axes.transAxes, ha="center", va="bottom", fontsize=7)


def rows_of(at: Sequence[float], names: Sequence[str]) -> list[int]:
    """Return the row of each label, ascending in place, so that labels in a row do not overlap."""
    ends, rows = [-1.0] * ROWS, []
    for x, name in zip(at, names, strict=True):
        half = 0.5 * DIGIT * (len(name) + 0.5)
        row = next((k for k in range(ROWS) if ends[k] <= x - half), int(np.argmin(ends)))
        ends[row] = x + half
        rows.append(row)
    return rows


def functions(one: Inspection, marked: Lines, band: tuple[float, float], phase: bool) -> Figure:
    """Return functions as measured and as synthesised from the modes: magnitude, phase, and coherence if known.

    Parameters
    ----------
    phase : bool
        Whether the functions have one; power spectra have not.
    """
    columns = min(2, len(one.curves))
    rows = -(-len(one.curves) // columns)
    coherence = any(curve.coherence is not None for curve in one.curves)
    ratios = [2.2, *([1.1] if phase else []), *([1.1] if coherence else [])]
    with styled():
        drawn = figure((0.62 * sum(ratios) + 0.55) * rows + 0.25)
        panels = drawn.subplots(
            len(ratios) * rows,
            columns,
            squeeze=False,
            sharex=True,
            gridspec_kw={"height_ratios": ratios * rows},
        )
        for k, curve in enumerate(one.curves):
            row, column = divmod(k, columns)
            own = [panels[len(ratios) * row + i, column] for i in range(len(ratios))]
            _curve(own, curve, phase, coherence, column == 0)
            own[0].set_title(short(curve.name, 40))
            for axes in own:
                for f, _, _ in marked.modes:
                    axes.axvline(f, color=INK, linewidth=0.5, alpha=0.35, zorder=1)
            if row == rows - 1 or k + columns >= len(one.curves):
                own[-1].set_xlabel("frequency [Hz]")
                own[-1].tick_params(labelbottom=True)
        for k in range(len(one.curves), rows * columns):
            for i in range(len(ratios)):
                panels[len(ratios) * (k // columns) + i, k % columns].set_visible(False)
        panels[0, 0].set_xlim(*band)
        handles, labels = panels[0, 0].get_legend_handles_labels()
        drawn.legend(handles, labels, loc="outside upper right", ncols=2)
    return drawn


def _curve(panels: Sequence[Axes], curve: Curve, phase: bool, coherence: bool, first: bool) -> None:
    """Draw a function in its panels."""
    f = curve.frequencies
    top = float(np.abs(curve.measured).max())
    for values, style in ((curve.measured, MEASURED), (curve.synthesised, SYNTHESISED)):
        size = np.abs(values)
        panels[0].semilogy(f, np.where(size > top * 10.0**-DECADES, size, np.nan), **style)
        if phase:
            panels[1].plot(*_unbroken(f, np.degrees(np.angle(values))), **style)
    decades(panels[0].yaxis, lambda value: typeset(f"{value:.0e}"))
    if first:
        panels[0].set_ylabel("magnitude" if phase else "power")
    if phase:
        panels[1].set_ylim(-190.0, 190.0)
        panels[1].set_yticks([-180, 0, 180])
        if first:
            panels[1].set_ylabel("phase [\u00b0]")
    if coherence:
        if curve.coherence is not None:
            panels[-1].plot(f, curve.coherence, color=VERMILLION, linewidth=0.9)
        panels[-1].set_ylim(0.0, 1.05)
        if first:
            panels[-1].set_ylabel("coherence")


def _unbroken(f: Array, phase: Array) -> tuple[Array, Array]:
    """Return a phase without the lines that would join +180 and -180 degrees."""
    jumps = np.flatnonzero(np.abs(np.diff(phase)) > 180.0) + 1
    return np.insert(f, jumps, f[jumps]), np.insert(phase, jumps, np.nan)
