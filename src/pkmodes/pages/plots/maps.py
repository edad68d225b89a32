"""Maps of a plane: frequencies, directions and components of the platform's motion (figures 8 to 20 of the paper)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.machine.maps.left_out import unstable_mask, without_unrepresentative
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.panels import (
    MAX_HEIGHT_TO_WIDTH,
    MAX_PANEL_HEIGHT,
    MAX_TALL_COLUMNS,
    MIN_RELATIVE_SPAN,
    draw_own_scale,
    draw_shared_scale,
    mode_panels,
    panel_width,
    widened_limits,
)
from pkmodes.pages.plots.plane import UNIFORM_FRACTION, Plane, colour_limits, is_uniform
from pkmodes.pages.plots.sheet import Scales, Sheet
from pkmodes.pages.plots.style import BLACK, FIGURE_WIDTH, WHITE, contrasting_ink

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[Any]
#: Number of direction lines along the shorter side of a map.
STROKES_PER_SIDE = 9
#: Relative difference up to which the frequencies of two poses count as equal, as those of mirrored poses.
EXTREME_TOLERANCE = 1e-9
#: Maximum number of poses that share a marked extreme; an extreme of more poses is not marked.
MAX_SHARED_EXTREMES = 8
#: Minimum distance of numbers on contours from one another and from the edges of a panel, and minimum length of a
#: contour with a number [inch].
NUMBER_DISTANCE, EDGE_DISTANCE, MIN_CONTOUR_LENGTH = 0.22, 0.12, 0.5
#: Numbers on steeper contours are not rotated: upside down, 60 would be read as 09 [degree].
MAX_NUMBER_ROTATION = 60.0
#: Shown in place of a figure for a plane in which the platform turns.
NO_DIRECTIONS_SENTENCE = "The axes of this plane are not two directions of motion."
#: Blues up to this fraction of the scale are light enough for black lines, also in grey.
MAX_BLUE = 0.55


def frequencies(plane: Plane, motors: Array | None = None) -> Drawing | str:
    """Draw the frequency of each mode, with its extremes in the plane (figure 8).

    - motors: positions of the motors, (N, 2): abscissa and ordinate in display units

    Returns a sentence if no frequency depends on the pose.
    """
    values = plane.dataset["frequency"].values
    representative_values = without_unrepresentative(plane.dataset)["frequency"].values
    # A negative number is not a frequency: where the machine is unstable the panels are blank.
    values = np.where(unstable_mask(plane.dataset).values[..., None], np.nan, values)
    modes = values.shape[-1]
    if np.isfinite(values).any() and all(
        is_uniform(values[..., mode], scale=MIN_RELATIVE_SPAN * float(np.nanmax(np.abs(values[..., mode]))))
        for mode in range(modes)
    ):
        medians = ", ".join(f"{value:.2f}" for value in np.nanmedian(values, axis=(0, 1)))
        tolerance_percent = plain(100 * UNIFORM_FRACTION * MIN_RELATIVE_SPAN, 2)
        return f"Every frequency is the same within {tolerance_percent} % at every pose: {medians} Hz."

    def draw(sheet: Sheet) -> None:
        for mode, panel in mode_panels(sheet, plane, modes, scales="own", has_text_line=True):
            width = sheet.panel_width if sheet.narrow else panel_width(plane, modes, colour_bars=True)
            frequency, representative_frequency = values[..., mode], representative_values[..., mode]
            limits = colour_limits(representative_frequency)
            low, high = widened_limits(*limits)
            mesh = plane.draw(panel, frequency, vmin=low, vmax=high)
            _draw_contours(
                plane,
                panel.axes,
                mesh,
                frequency,
                float(np.ptp(plane.display_values(plane.abscissa))) / width,
            )
            _mark_extremes(plane, panel, representative_frequency)
            _mark_motors(panel, motors)
            panel.axes.annotate(
                _format_range(*limits),
                (0, 1),
                (0, 2),
                "axes fraction",
                "offset points",
                va="bottom",
                fontsize=7,
            )
            draw_own_scale(plane, panel, mesh, "f [Hz]")

    return Drawing(draw)


def directions(plane: Plane, body: str = "platform", lengths: Array | None = None) -> Drawing | str:
    """Draw the direction of the platform's motion in each mode (figures 9 to 14).

    Lines show the part in the plane, as long as its share of the motion; colours show the share perpendicular to it.
    Returns a sentence if no direction depends on the pose, or if the axes of the plane are not directions of motion.

    - body: noun for the body that moves
    - lengths: factors that turn the components of the platform's motion into lengths, (components,); None if it does
      not rotate
    """
    names = plane.dataset["direction"].values.tolist()
    if not plane.is_linear:
        return NO_DIRECTIONS_SENTENCE
    motion = plane.dataset["platform_shape"].values * (1.0 if lengths is None else lengths)
    abscissa_index, ordinate_index = names.index(plane.abscissa), names.index(plane.ordinate)
    magnitude = np.sqrt((motion**2).sum(axis=-1))
    unit_vectors = motion / np.where(magnitude > 0.0, magnitude, np.nan)[..., None]
    modes, has_rotations = motion.shape[2], lengths is not None
    # The sign of a direction has no meaning, so products of its components are compared.
    if is_uniform(unit_vectors[..., :, None] * unit_vectors[..., None, :], axes=(0, 1), scale=1.0):
        return f"In each mode the direction of motion of the {body} is almost the same at every pose."
    space_below = 0.0 if plane.is_tall or plane.normal is None else 0.5
    x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)
    step = max(1, round(min(len(x), len(y)) / STROKES_PER_SIDE))
    rows, columns = (slice(step // 2, None, step) for _ in range(2))
    stroke_length = step * (y[-1] - y[0]) / max(len(y) - 1, 1) * 0.45

    def draw(sheet: Sheet) -> None:
        from matplotlib import colormaps
        from matplotlib.colors import ListedColormap

        blues = ListedColormap(colormaps["Blues"](np.linspace(0.0, MAX_BLUE, 256)))
        mesh: Any = None
        scales: Scales = "" if plane.normal is None else "common"
        for mode, panel in mode_panels(sheet, plane, modes, scales=scales, space_below=space_below):
            perpendicular = np.sqrt(
                np.clip(
                    1.0
                    - unit_vectors[:, :, mode, abscissa_index] ** 2
                    - unit_vectors[:, :, mode, ordinate_index] ** 2,
                    0.0,
                    1.0,
                )
            )
            if has_rotations and plane.normal is not None:
                perpendicular = np.abs(unit_vectors[:, :, mode, names.index(plane.normal)])
            if plane.normal is None:
                perpendicular = np.where(np.isfinite(unit_vectors[:, :, mode, abscissa_index]), 0.0, np.nan)
            mesh = plane.draw(panel, perpendicular, vmin=0.0, vmax=1.0, cmap=blues)
            stroke_vectors = unit_vectors[rows, columns, mode]
            _draw_strokes(
                panel,
                x[columns],
                y[rows],
                stroke_length * stroke_vectors[..., abscissa_index],
                stroke_length * stroke_vectors[..., ordinate_index],
            )
        if plane.normal is not None:
            draw_shared_scale(sheet, plane, mesh, f"share of the motion along {plane.normal} [1]")

    return Drawing(draw)


def components(plane: Plane, body: str = "platform", lengths: Array | None = None) -> Drawing | str:
    """Draw the in-plane and out-of-plane motion of the platform in each mode, all on one scale (figures 15 to 20).

    For a platform that rotates, a third row shows the rotation times the characteristic length.

    Mass-normalised shapes are compared: the platform's motion for the same kinetic energy of the whole robot.

    Returns a sentence if no motion depends on the pose, or if the axes of the plane are not directions of motion.

    - body, lengths: as for `directions`, (components,)
    """
    if not plane.is_linear:
        return NO_DIRECTIONS_SENTENCE
    kinds = [("in plane", plane.dataset["in_plane"].values)]
    if plane.normal is not None:
        kinds.append((f"along {plane.normal}", plane.dataset["out_of_plane"].values))
    if lengths is not None:
        units = [
            plane.dataset.coords[name].attrs["units"] if name in plane.dataset.coords else ""
            for name in plane.dataset["direction"].values.tolist()
        ]
        rotation_indices = [i for i, unit in enumerate(units) if unit == "rad"]
        motion = plane.dataset["platform_shape"].values[..., rotation_indices] * lengths[rotation_indices]
        kinds.append(("rotation", np.sqrt((motion**2).sum(axis=-1))))
    modes = plane.dataset.sizes["mode"]
    motions = np.stack([values for _, values in kinds])
    high = colour_limits(motions)[1]
    if is_uniform(motions, axes=(1, 2), scale=high):
        return f"In each mode the motion of the {body} has almost the same size at every pose."
    panel_lines = -(-modes // MAX_TALL_COLUMNS)
    columns = -(-modes // panel_lines)
    width = (FIGURE_WIDTH - 1.3) / columns
    height = (
        panel_lines
        * len(kinds)
        * (min(plane.height_to_width * width, MAX_HEIGHT_TO_WIDTH * width, MAX_PANEL_HEIGHT) + 0.25)
        + 1.0
    )

    def draw(sheet: Sheet) -> None:
        sheet.figure.set_layout_engine("compressed")
        rows = (1.0,) * len(kinds)
        groups = sheet.groups(
            modes, columns, height, rows=rows, height_to_width=plane.fixed_height_to_width, scales="common"
        )
        mesh: Any = None
        for mode, panels in enumerate(groups):
            for panel, (title, values) in zip(panels, kinds, strict=True):
                mesh = plane.draw(panel, values[..., mode], vmin=0.0, vmax=high)
                if panel is panels[-1]:
                    panel.omitted_labels.discard("x")
                plane.label_panel(panel, f"mode {mode + 1}", row=title)
        draw_shared_scale(sheet, plane, mesh, "mass-normalised motion [1/\N{SQUARE ROOT}kg]", extend="max")

    return Drawing(draw)


def extremes(values: Array) -> dict[str, list[tuple[int, int]]]:
    """Return the poses of the minimum and the maximum, by the same definition as in the table of a map.

    - values: (rows, columns)

    Returns for ``minimum`` and ``maximum`` the indices of the poses: several poses if they share the value, as
    mirrored poses do; none if no pose can be evaluated, or if more than `MAX_SHARED_EXTREMES` share the value.
    """
    extreme_poses: dict[str, list[tuple[int, int]]] = {"minimum": [], "maximum": []}
    if not np.isfinite(values).any():
        return extreme_poses
    for name, value in (("minimum", np.nanmin(values)), ("maximum", np.nanmax(values))):
        poses = [
            (int(i), int(j)) for i, j in np.argwhere(np.abs(values - value) <= EXTREME_TOLERANCE * abs(value))
        ]
        extreme_poses[name] = poses if len(poses) <= MAX_SHARED_EXTREMES else []
    return extreme_poses


def _format_range(low: float, high: float) -> str:
    """Return the text of a range of frequencies, with enough decimals to distinguish its ends."""
    decimals = 1 if high <= low else max(0, min(4, 1 - math.floor(math.log10(high - low))))
    return f"{typeset(f'{low:.{decimals}f}')}\N{EN DASH}{typeset(f'{high:.{decimals}f}')} Hz"


def _draw_strokes(panel: Panel, x: Array, y: Array, half_x: Array, half_y: Array) -> None:
    """Draw a line through each pose in the direction of a vibration.

    - half_x, half_y: half of each line, in the units of the axes
    """
    finite = np.isfinite(half_x) & np.isfinite(half_y)
    ends = [
        np.stack([centres - half_lengths, centres + half_lengths], axis=-1)[finite]
        for centres, half_lengths in zip(np.meshgrid(x, y), (half_x, half_y), strict=True)
    ]
    panel.lines(*ends, colors=BLACK, linewidths=0.9)


def _draw_contours(plane: Plane, axes: Axes, mesh: Any, values: Array, inch_in_axis_units: float) -> None:
    """Draw contours at round frequencies, with their numbers, in black or white, whichever has more contrast.

    - inch_in_axis_units: approximate length of an inch of the panel in the units of its axes, used to leave out
      numbers that would overlap
    """
    from matplotlib.ticker import MaxNLocator

    low, high = mesh.get_clim()
    finite = values[np.isfinite(values)]
    if not len(finite):
        return
    levels = MaxNLocator(6, steps=[1, 2, 5, 10]).tick_values(low, high)
    levels = [level for level in levels if low < level < high and finite.min() < level < finite.max()]
    if not levels:
        return
    line_colours = [contrasting_ink(mesh.to_rgba(level)) for level in levels]
    x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)
    lines = axes.contour(x, y, np.ma.masked_invalid(values), levels, colors=line_colours, linewidths=0.5)
    mark_positions = [(x[j], y[i]) for poses in extremes(values).values() for i, j in poses]
    number_positions = _number_positions(
        [line for segments in lines.allsegs for line in segments], mark_positions, axes, inch_in_axis_units
    )
    if number_positions:
        settings: dict[str, Any] = {
            "colors": line_colours,
            "fontsize": 6.5,
            "fmt": lambda level: typeset(f"{level:g}"),
        }
        for text in axes.clabel(lines, inline_spacing=1.5, manual=number_positions, **settings):
            if abs((text.get_rotation() + 90.0) % 180.0 - 90.0) > MAX_NUMBER_ROTATION:
                text.set_rotation(0.0)


def _number_positions(
    lines: list[Array], mark_positions: list[Any], axes: Axes, inch_in_axis_units: float
) -> list[tuple[float, float]]:
    """Return a position for a number on each line that is long enough, away from other numbers, marks and edges."""
    positions: list[tuple[float, float]] = []
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    for line in lines:
        if np.hypot(*np.diff(line, axis=0).T).sum() < MIN_CONTOUR_LENGTH * inch_in_axis_units:
            continue
        for fraction in (0.5, 0.35, 0.65, 0.2, 0.8):
            x, y = map(float, line[int(fraction * (len(line) - 1))])
            is_near_edge = min(x - left, right - x, y - bottom, top - y) < EDGE_DISTANCE * inch_in_axis_units
            if not is_near_edge and all(
                math.hypot(x - other_x, y - other_y) >= NUMBER_DISTANCE * inch_in_axis_units
                for other_x, other_y in [*positions, *mark_positions]
            ):
                positions.append((x, y))
                break
    return positions


def _mark_extremes(plane: Plane, panel: Panel, values: Array) -> None:
    """Mark the extremes in the plane: a triangle that points down for the lowest, up for the highest frequency."""
    x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)
    for name, poses in extremes(values).items():
        for i, j in poses:
            _draw_mark(panel, x[j], y[i], "v" if name == "minimum" else "^", filled=False, size=5.5)


def _mark_motors(panel: Panel, motors: Array | None) -> None:
    """Mark motors as squares; motors beyond the map as hollow squares at its edge."""
    if motors is None:
        return
    (left, right), (bottom, top) = panel.axes.get_xlim(), panel.axes.get_ylim()
    for x, y in motors:
        position = float(np.clip(x, left, right)), float(np.clip(y, bottom, top))
        _draw_mark(panel, *position, "s", filled=position == (x, y), size=4.0)


def _draw_mark(panel: Panel, x: float, y: float, marker: str, *, filled: bool, size: float) -> None:
    """Draw a mark that is visible on any colour: black with a white edge, or white with a black edge."""
    face, edge = (BLACK, WHITE) if filled else (WHITE, BLACK)
    style: dict[str, Any] = {"markeredgewidth": 0.7, "markersize": size, "clip_on": False}
    panel.plot([x], [y], marker, color=face, markeredgecolor=edge, **style)
