"""Which parameter a frequency depends on most, at each pose of a plane; several where their influences are alike."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.loop.sensitivity.alike import TIE_FRACTION
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import one_name_per_line
from pkmodes.pages.plots.panels import mode_panels
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import contrasting_ink

Array = NDArray[Any]
#: Colours of the parameters, those with the largest areas first, and the colour of all others.  No two have the same
#: grey, and a page redefines none of them: an image keeps its colours on a dark page.
PARAMETER_COLOURS = ("#0072b3", "#e69f01", "#00264d", "#bfe3f8", "#009e74", "#7a2f00", "#f2f2f2")
FRAME_COLOUR = "#80868c"
OTHER_LABEL = "another"
#: Columns of the legend, and height of one of its lines [inch].
LEGEND_COLUMNS, LEGEND_LINE = 3, 0.15
#: Minimum share of the poses at which a tie is drawn as a region of its own.
MIN_TIE_SHARE = 0.01
#: A number needs more than this many poses of its region on every side; smaller regions have no number.
NUMBER_MARGIN = 2


def dominant_parameters(plane: Plane, paths: Sequence[str], relative_sensitivities: Array) -> Drawing | str:
    """Draw, for each mode, the parameter with the largest influence at each pose, or those that are alike.

    - paths: parameters
    - relative_sensitivities: d ln f / d ln p, (rows, columns, parameters, modes)

    Returns a sentence if it is the same at every pose for each mode.
    """
    from matplotlib.colors import ListedColormap, to_rgb
    from matplotlib.patches import Patch

    sets, strongest = strongest_parameters(relative_sensitivities)
    modes = relative_sensitivities.shape[-1]
    if sentence := _same_everywhere_sentence(paths, sets, strongest):
        return sentence
    counts = np.bincount(strongest[strongest >= 0], minlength=len(sets))
    shown_sets = [int(i) for i in np.argsort(-counts, kind="stable")[: len(PARAMETER_COLOURS) - 1]]
    colour_index = np.full(len(sets) + 1, float(len(shown_sets)))
    colour_index[shown_sets] = range(len(shown_sets))
    colour_index[-1] = np.nan
    *palette, rest_colour = PARAMETER_COLOURS
    used_colours = [*palette[: len(shown_sets)], rest_colour]
    value_names = [f"{i + 1}  {_set_name(paths, sets[k])}" for i, k in enumerate(shown_sets)]
    names = [one_name_per_line(name.replace(" and ", " and\n")) for name in value_names]
    legend_rows = -(-(len(names) + 1) // LEGEND_COLUMNS)
    legend_lines = 1 + legend_rows * max((1 + name.count("\n") for name in names), default=1)
    has_others = counts.sum() > counts[shown_sets].sum()
    is_tie_shown = any(len(sets[k]) > 1 for k in shown_sets)
    tie_note = f"; alike: within {plain(100 * TIE_FRACTION)} %" if is_tie_shown else ""
    x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)

    def draw(sheet: Sheet) -> None:
        colours = {"cmap": ListedColormap(used_colours), "vmin": -0.5, "vmax": len(shown_sets) + 0.5}
        for mode, panel in mode_panels(sheet, plane, modes, space_below=0.3 + LEGEND_LINE * legend_lines):
            values = colour_index[strongest[..., mode]]
            plane.draw(panel, values, value_names=[*value_names, OTHER_LABEL], **colours)
            for i in range(len(shown_sets)):
                style: dict[str, Any] = {
                    "color": contrasting_ink(to_rgb(used_colours[i])),
                    "ha": "center",
                    "va": "center",
                    "weight": "bold",
                }
                for row, column in region_centres(values == i):
                    panel.axes.text(x[column], y[row], str(i + 1), **style)
        legend_colours = [*used_colours[: len(shown_sets)], *([rest_colour] if has_others else [])]
        sheet.legend_from_handles(
            [Patch(facecolor=colour, edgecolor=FRAME_COLOUR) for colour in legend_colours],
            [*names, *([OTHER_LABEL] if has_others else [])],
            below_panels=True,
            loc="outside lower center",
            ncols=LEGEND_COLUMNS,
            # In parts of the figure, so that it stays where it is when margins are cut off or added.
            bbox_to_anchor=(0.0, 0.0, 1.0, 1.0),
            bbox_transform=sheet.figure.transFigure,
            title=f"largest |d ln f / d ln p| of {len(paths)} parameters{tie_note}",
        )

    return Drawing(draw)


def strongest_parameters(relative_sensitivities: Array) -> tuple[list[tuple[int, ...]], Array]:
    """Return the parameters with the largest influence on each frequency at each pose.

    Several share a pose where their influences are within `TIE_FRACTION` of the largest; such a tie at less than
    `MIN_TIE_SHARE` of the poses, as on the line between two regions, counts as its largest alone.

    - relative_sensitivities: (rows, columns, parameters, modes)

    Returns, in this order:
    - sets: indices of the parameters of each set, single parameters first
    - index: index of the set at each pose, -1 where it cannot be evaluated, (rows, columns, modes)
    """
    magnitude = np.moveaxis(np.abs(relative_sensitivities), 2, -1)
    is_reachable = np.isfinite(magnitude).all(axis=-1)
    values = magnitude[is_reachable]
    largest = values.max(axis=-1, keepdims=True, initial=0.0)
    is_strongest = values >= (1.0 - TIE_FRACTION) * largest
    _, pattern, counts = np.unique(is_strongest, axis=0, return_inverse=True, return_counts=True)
    is_rare = counts[pattern.ravel()] < MIN_TIE_SHARE * len(values)
    is_strongest[is_rare] = np.eye(values.shape[-1], dtype=bool)[values[is_rare].argmax(axis=-1)]
    patterns, pattern = np.unique(is_strongest, axis=0, return_inverse=True)
    order = sorted(
        range(len(patterns)), key=lambda k: (patterns[k].sum(), np.flatnonzero(patterns[k]).tolist())
    )
    index = np.full(is_reachable.shape, -1)
    index[is_reachable] = np.argsort(order)[pattern.ravel()]
    return [tuple(np.flatnonzero(patterns[k]).tolist()) for k in order], index


def _set_name(paths: Sequence[str], members: Sequence[int]) -> str:
    """Return the names of parameters with one influence: "a and b alike"."""
    return joined([paths[i] for i in members]) + (" alike" if len(members) > 1 else "")


def _same_everywhere_sentence(paths: Sequence[str], sets: Sequence[tuple[int, ...]], strongest: Array) -> str:
    """Return a sentence with the parameters of each mode; empty if they differ between the poses of a mode."""
    sets_of_modes = [np.unique(indices[indices >= 0]) for indices in np.moveaxis(strongest, -1, 0)]
    if any(len(indices) != 1 for indices in sets_of_modes):
        return ""
    members = [sets[int(indices[0])] for indices in sets_of_modes]
    names = [_set_name(paths, indices) for indices in members]
    tolerance = f" (within {plain(100 * TIE_FRACTION)} %)"
    tie_note = tolerance if any(len(indices) > 1 for indices in members) else ""
    if len(set(names)) == 1:
        return f"At every pose each frequency changes most with {names[0]}{tie_note}, of {len(paths)} parameters."
    clauses = "; ".join(f"that of mode {mode} with {name}" for mode, name in enumerate(names, 1))
    return (
        f"At every pose the frequencies change most with the same ones of {len(paths)} parameters: "
        f"{clauses}{tie_note}."
    )


def region_centres(inside: Array) -> Iterator[tuple[int, int]]:
    """Yield a pose in the middle of each connected region that has room for a number, the widest first.

    - inside: (rows, columns)
    """
    remaining = np.array(inside, dtype=bool)
    while True:
        depth = _steps_to_edge(remaining)
        if depth.max(initial=0) <= NUMBER_MARGIN:
            return
        deepest = np.argwhere(depth == depth.max())
        centre = deepest[int(np.argmin(np.abs(deepest - deepest.mean(axis=0)).sum(axis=1)))]
        yield int(centre[0]), int(centre[1])
        remaining &= ~_connected_region(remaining, centre)


def _steps_to_edge(inside: Array) -> Array:
    """Return the number of grid steps from each pose to the outside of the region, 0 outside."""
    depth, remaining = np.zeros(inside.shape, dtype=int), inside
    while remaining.any():
        depth += remaining
        padded = np.pad(remaining, 1)
        remaining = remaining & padded[2:, 1:-1] & padded[:-2, 1:-1] & padded[1:-1, 2:] & padded[1:-1, :-2]
    return depth


def _connected_region(inside: Array, start: Array) -> Array:
    """Return the part of a region that is connected to a pose."""
    region = np.zeros_like(inside)
    region[tuple(start)] = True
    while True:
        padded = np.pad(region, 1)
        neighbours = padded[2:, 1:-1] | padded[:-2, 1:-1] | padded[1:-1, 2:] | padded[1:-1, :-2]
        grown_region = inside & (region | neighbours)
        if (grown_region == region).all():
            return region
        region = grown_region
