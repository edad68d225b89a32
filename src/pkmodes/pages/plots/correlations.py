"""Correlations of the fitted values, and error ellipses of the strongly correlated pairs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.loop.diagnosis.verdict.findings import Corrected
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import short_label, typeset
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, VERMILLION, contrasting_ink

Array = NDArray[np.float64]
#: Maximum number of values in the matrix, and maximum length of a name, on a wide and on a narrow sheet.
MAX_VALUES, MAX_NAME_LENGTH, MAX_NARROW_NAME_LENGTH = 16, 40, 16
#: Correlation at which one value explains half of the variance of the other: its square is 0.5.
NOTABLE_CORRELATION = 0.5**0.5
#: Maximum number of pairs with ellipses, and number of points of an ellipse.
MAX_PAIRS, ELLIPSE_POINTS = 4, 121
#: Probabilities that an ellipse contains the true pair of values, each with its line style.
PROBABILITY_LINE_STYLES = ((0.68, "-"), (0.95, "--"))
#: A value within this many standard deviations of 0 is near 0: the ellipse of 95 % may reach it.
NEAR_ZERO_SIGMAS = 3.0
#: The number of a part, such as a leg, in the name of a value, with the dot or underscore before it.
PART_NUMBER = re.compile(r"[._]?\d+")
#: Declared values further than this many standard deviations from the fitted ones are not drawn.
MAX_DECLARED_SIGMAS = 6.0


def correlation_matrix(values: Sequence[Corrected], correlation: Array) -> Drawing | None:
    """Draw the correlation of each pair of values, in the order of the table; None for fewer than two.

    - correlation: of the n values, (n, n)
    """
    count = min(len(values), MAX_VALUES)
    if count < 2:
        return None
    shown_correlation, cell_centres = correlation[:count, :count], np.arange(1.0, count + 1)

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.75 + 0.27 * count)
        mesh = panel.cells(cell_centres, cell_centres, shown_correlation, cmap="PuOr", vmin=-1.0, vmax=1.0)
        names = [value.name.removeprefix("effects.") for value in values[:count]]
        max_length = MAX_NARROW_NAME_LENGTH if sheet.narrow else MAX_NAME_LENGTH
        labels = [f"{short_label(name, max_length)}  {k}" for k, name in enumerate(names, start=1)]
        panel.set_tick_names("y", cell_centres.tolist(), labels, names)
        panel.set_tick_names("x", cell_centres.tolist(), [str(k) for k in range(1, count + 1)], names)
        panel.axes.invert_yaxis()
        panel.axes.grid(visible=False)
        panel.axes.tick_params(length=0)
        for (i, k), value in np.ndenumerate(shown_correlation):
            text_colour = contrasting_ink(mesh.to_rgba(np.asarray(value)))
            text = typeset(f"{value:+.2f}") if i != k else "1"
            panel.axes.text(k + 1, i + 1, text, color=text_colour, ha="center", va="center", fontsize=7.5)
        sheet.colour_scale(mesh, "correlation [1]", aspect=25)

    return Drawing(draw)


def notable_pairs(values: Sequence[Corrected], correlation: Array) -> list[tuple[int, int]]:
    """Return the pairs of values with a notable correlation, the largest first."""
    pairs = [
        (i, k)
        for i, k in combinations(range(len(values)), 2)
        if abs(correlation[i, k]) >= NOTABLE_CORRELATION
    ]
    return sorted(pairs, key=lambda pair: -abs(correlation[pair]))


def drawn_pairs(values: Sequence[Corrected], correlation: Array) -> list[tuple[int, int]]:
    """Return the notable pairs, without pairs of the same quantity of two parts, such as two legs."""
    return [
        (i, k)
        for i, k in notable_pairs(values, correlation)
        if name_without_numbers(values[i].name) != name_without_numbers(values[k].name)
        and values[i].sigma > 0.0 < values[k].sigma
    ]


def name_without_numbers(name: str) -> str:
    """Return the name of a quantity without the numbers of its parts, to be compared with that of another part."""
    return PART_NUMBER.sub("", name)


def deviation_unit(value: Corrected) -> tuple[str, float]:
    """Return the unit in which deviations from a value are drawn, and the factor from SI units to it.

    The unit is per cent of the value; if the value is near 0, its own unit, mm for lengths.
    """
    if abs(value.value) > NEAR_ZERO_SIGMAS * value.sigma:
        return "%", 100.0 / abs(value.value)
    return DISPLAY_UNITS.get(value.unit, (value.unit, 1.0))


def ellipse_points(sigma: tuple[float, float], correlation: float, probability: float) -> Array:
    """Return points (2, P) on the ellipse about 0 that contains a normally distributed pair with a probability."""
    from scipy.stats import chi2

    angle = np.linspace(0.0, 2.0 * np.pi, ELLIPSE_POINTS)
    independent_part = max(1.0 - correlation**2, 0.0) ** 0.5
    circle = float(chi2.ppf(probability, 2)) ** 0.5 * np.stack([np.cos(angle), np.sin(angle)])
    points: Array = np.diag(sigma) @ np.array([[1.0, 0.0], [correlation, independent_part]]) @ circle
    return points


def error_ellipses(values: Sequence[Corrected], correlation: Array) -> Drawing | None:
    """Draw the error ellipses of each notable pair of values, about the fitted values; None without such a pair.

    Deviations are in per cent of the fitted value, or, where that is near 0, in its unit.
    """
    pairs = drawn_pairs(values, correlation)[:MAX_PAIRS]
    if not pairs:
        return None

    def draw(sheet: Sheet) -> None:
        columns = min(2, len(pairs))
        groups = sheet.groups(len(pairs), columns, 2.8 * -(-len(pairs) // columns) + 0.3)
        for (i, k), (panel,) in zip(pairs, groups, strict=True):
            pair_values = values[i], values[k]
            (x_unit, x_factor), (y_unit, y_factor) = map(deviation_unit, pair_values)
            factors = x_factor, y_factor
            sigma = pair_values[0].sigma * factors[0], pair_values[1].sigma * factors[1]
            for probability, line_style in PROBABILITY_LINE_STYLES:
                x, y = ellipse_points(sigma, float(correlation[i, k]), probability)
                panel.plot(
                    x, y, line_style, color=BLUE, linewidth=1.4, label=f"{100 * probability:.0f}\u00a0%"
                )
            panel.plot([0.0], [0.0], "o", color=BLUE, markersize=4.0, label="fitted")
            declared_offset = [
                (value.declared - value.value) * factor
                for value, factor in zip(pair_values, factors, strict=True)
            ]
            if all(
                abs(offset) <= MAX_DECLARED_SIGMAS * standard_deviation
                for offset, standard_deviation in zip(declared_offset, sigma, strict=True)
            ):
                panel.plot(
                    declared_offset[:1],
                    declared_offset[1:],
                    "x",
                    color=VERMILLION,
                    markersize=6.0,
                    label="declared",
                )
            names = [
                short_label(value.name.removeprefix("effects."), MAX_NAME_LENGTH) for value in pair_values
            ]
            panel.omitted_labels = set()
            panel.label(
                f"correlation {typeset(f'{correlation[i, k]:+.2f}')}",
                x=f"{names[0]} [{x_unit}]",
                y=f"{names[1]} [{y_unit}]",
            )
        handle_by_label = {
            name: legend_handle
            for (panel,) in groups
            for legend_handle, name in zip(*panel.axes.get_legend_handles_labels(), strict=True)
        }
        sheet.legend_from_handles(
            [*handle_by_label.values()],
            [*handle_by_label],
            loc="outside upper right",
            ncols=len(handle_by_label),
        )

    return Drawing(draw)
