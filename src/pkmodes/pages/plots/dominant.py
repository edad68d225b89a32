"""Which parameter a frequency depends on most, at each pose of a plane."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

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
#: A number needs more than this many poses of its region on every side; smaller regions have no number.
NUMBER_MARGIN = 2


def dominant_parameters(plane: Plane, paths: Sequence[str], relative_sensitivities: Array) -> Drawing | str:
    """Draw, for each mode, the parameter with the largest influence at each pose.

    - paths: parameters
    - relative_sensitivities: d ln f / d ln p, (rows, columns, parameters, modes)

    Returns a sentence if the parameter is the same at every pose for each mode.
    """
    from matplotlib.colors import ListedColormap, to_rgb
    from matplotlib.patches import Patch

    magnitude = np.abs(relative_sensitivities)
    is_reachable = np.isfinite(magnitude).all(axis=2)
    strongest = np.where(is_reachable, np.nan_to_num(magnitude).argmax(axis=2), -1)
    modes = relative_sensitivities.shape[-1]
    if sentence := _single_parameter_sentence(paths, strongest):
        return sentence
    counts = np.bincount(strongest[strongest >= 0], minlength=len(paths))
    shown_paths = [
        int(i) for i in np.argsort(-counts, kind="stable")[: len(PARAMETER_COLOURS) - 1] if counts[i]
    ]
    colour_index = np.full(len(paths) + 1, float(len(shown_paths)))
    colour_index[shown_paths] = range(len(shown_paths))
    colour_index[-1] = np.nan
    *palette, rest_colour = PARAMETER_COLOURS
    used_colours = [*palette[: len(shown_paths)], rest_colour]
    value_names = [f"{i + 1}  {paths[path]}" for i, path in enumerate(shown_paths)]
    names = [f"{i + 1}  {one_name_per_line(paths[path])}" for i, path in enumerate(shown_paths)]
    has_others = counts.sum() > counts[shown_paths].sum()
    x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)

    def draw(sheet: Sheet) -> None:
        colours = {"cmap": ListedColormap(used_colours), "vmin": -0.5, "vmax": len(shown_paths) + 0.5}
        for mode, panel in mode_panels(sheet, plane, modes, space_below=0.9):
            values = colour_index[strongest[..., mode]]
            plane.draw(panel, values, value_names=[*value_names, OTHER_LABEL], **colours)
            for i in range(len(shown_paths)):
                style: dict[str, Any] = {
                    "color": contrasting_ink(to_rgb(used_colours[i])),
                    "ha": "center",
                    "va": "center",
                    "weight": "bold",
                }
                for row, column in region_centres(values == i):
                    panel.axes.text(x[column], y[row], str(i + 1), **style)
        legend_colours = [*used_colours[: len(shown_paths)], *([rest_colour] if has_others else [])]
        sheet.legend_from_handles(
            [Patch(facecolor=colour, edgecolor=FRAME_COLOUR) for colour in legend_colours],
            [*names, *([OTHER_LABEL] if has_others else [])],
            below_panels=True,
            loc="outside lower center",
            ncols=3,
            # In parts of the figure, so that it stays where it is when margins are cut off or added.
            bbox_to_anchor=(0.0, 0.0, 1.0, 1.0),
            bbox_transform=sheet.figure.transFigure,
            title=f"largest |d ln f / d ln p| of {len(paths)} parameters",
        )

    return Drawing(draw)


def _single_parameter_sentence(paths: Sequence[str], strongest: Array) -> str:
    """Return a sentence with the parameter of each mode; empty if a mode has several."""
    paths_of_modes = [np.unique(indices[indices >= 0]) for indices in np.moveaxis(strongest, -1, 0)]
    if any(len(indices) != 1 for indices in paths_of_modes):
        return ""
    names = [paths[int(indices[0])] for indices in paths_of_modes]
    if len(set(names)) == 1:
        return f"At every pose each frequency changes most with {names[0]}, of {len(paths)} parameters."
    clauses = ", ".join(f"that of mode {mode} with {name}" for mode, name in enumerate(names, 1))
    return (
        f"At every pose the frequencies change most with the same one of {len(paths)} parameters: {clauses}."
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
