"""The modes of a record: how similar their shapes are, how complex, and how their frequencies scatter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.campaign.inspection import Repeats
from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import short_label
from pkmodes.pages.plots.mac_matrices import draw_matrix
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, PALETTE, PURPLE, VERMILLION

Array = NDArray[np.float64]
#: Maximum number of panels of complex shapes side by side.
MAX_COLUMNS = 6
#: Maximum number of poses named on an axis.
MAX_NAMED_POSES = 30


def auto_mac(macs: Array) -> Drawing:
    """Draw the matrix of the modal assurance criterion between the modes of a record, NaN where unknown."""

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.7 + min(2.7, 1.1 + 0.22 * len(macs)), height_to_width=1.0, scales="common")
        image = draw_matrix(panel, macs)
        panel.label(x="mode", y="mode")
        sheet.colour_scale(image, "MAC [1]", shrink=0.8, aspect=20)

    return Drawing(draw)


def complex_shapes(shapes: Sequence[tuple[str, Mapping[str, complex]]]) -> Drawing:
    """Draw shapes in the complex plane, each component as a line from the origin.

    - shapes: title and components of each
    """
    rows, columns = -(-len(shapes) // MAX_COLUMNS), min(MAX_COLUMNS, len(shapes))

    def draw(sheet: Sheet) -> None:
        width = max(1.02 * columns, 3.0)
        sheet.groups(len(shapes), columns, 1.25 * rows + 0.15, width, height_to_width=1.0, frames=False)
        circle = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 73))
        for panel, (title, shape) in zip(sheet.panels, shapes, strict=True):
            axes = panel.axes
            values = np.array(list(shape.values()))
            values = values / np.abs(values).max()
            axes.plot(circle.real, circle.imag, color=GREY, linewidth=0.6)
            x = np.stack([0.0 * values.real, values.real, np.full(len(values), np.nan)], axis=1).ravel()
            y = np.stack([0.0 * values.imag, values.imag, np.full(len(values), np.nan)], axis=1).ravel()
            panel.plot(x, y, color=BLUE, linewidth=1.1)
            panel.plot(values.real, values.imag, ".", color=BLUE, markersize=4.0)
            panel.label(title, fontsize=7.5, pad=3)
            axes.set_aspect("equal")
            axes.set_xlim(-1.1, 1.1)
            axes.set_ylim(-1.1, 1.1)
            axes.set_axis_off()

    return Drawing(draw)


def scatter_of_repeats(setups: Sequence[Repeats]) -> Drawing:
    """Draw the frequencies in each file, relative to their mean over the repeats of the setup [%]."""
    repeated_setups = [repeats for repeats in setups if len(repeats.files) > 1]
    means = sorted(
        float(np.mean(list(mode.values()))) for repeats in repeated_setups for mode in repeats.modes
    )
    distinct_frequencies = [
        f for index, f in enumerate(means) if index == 0 or f / means[index - 1] > 1.0 + 1e-3
    ]

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.3)
        axes = panel.axes
        marks.draw_zero_line(panel)
        for k, repeats in enumerate(repeated_setups):
            for file_index in range(len(repeats.files)):
                pairs = [
                    (mode[file_index], np.mean(list(mode.values())))
                    for mode in repeats.modes
                    if file_index in mode
                ]
                x = [int(np.searchsorted(distinct_frequencies, mean * (1.0 - 1e-9))) for _, mean in pairs]
                x = [min(index, len(distinct_frequencies) - 1) for index in x]
                deviations = [100.0 * (f / mean - 1.0) for f, mean in pairs]
                label = short_label(repeats.setup) if file_index == 0 and repeats.setup else None
                shift = 0.16 * (k - 0.5 * (len(repeated_setups) - 1))
                panel.plot(
                    np.array(x) + shift,
                    deviations,
                    "_" if len(repeats.files) > 8 else ".",
                    name=short_label(repeats.setup) if repeats.setup else "",
                    color=PALETTE[k % len(PALETTE)],
                    label=label,
                    zorder=3,
                )
        step = -(-len(distinct_frequencies) // 12)
        tick_labels = [f"{f:#.4g}".rstrip(".") for f in distinct_frequencies[::step]]
        panel.set_tick_names("x", range(0, len(distinct_frequencies), step), tick_labels)
        axes.set_xlim(-0.6, len(distinct_frequencies) - 0.4)
        panel.label(x="mean frequency [Hz]", y="file, above the mean [%]")
        axes.grid(visible=False, axis="x")
        if any(repeats.setup for repeats in repeated_setups):
            sheet.legend(panel, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4)

    return Drawing(draw)


def frequencies_by_pose(
    labels: Sequence[str], modes: Sequence[tuple[int, float, bool]], struck_out: Sequence[tuple[int, float]]
) -> Drawing:
    """Draw the frequencies at all poses.

    - labels: of the poses
    - modes: the index of the pose, the frequency [Hz], and whether the user added the mode
    - struck_out: index of the pose and frequency [Hz] of each mode that was struck out
    """

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.4)
        axes = panel.axes
        kinds = (
            ([(i, f) for i, f, added in modes if not added], "o", BLUE, "mode"),
            ([(i, f) for i, f, added in modes if added], "D", PURPLE, "added"),
            (list(struck_out), "x", VERMILLION, "struck out"),
        )
        for points, marker, colour, label in kinds:
            if points:
                x, y = zip(*points, strict=True)
                panel.plot(x, y, marker, color=colour, label=label, markersize=4.0)
        axes.set_ylim(0.0, None)
        axes.set_xlim(-0.7, len(labels) - 0.3)
        pose_label = "pose, in the order of the campaign"
        if len(labels) <= MAX_NAMED_POSES:
            names = [short_label(label) for label in labels]
            is_rotated = len(names) * max(map(len, names)) > 80
            panel.set_tick_names("x", range(len(names)), names, rotation=90 if is_rotated else 0)
            axes.grid(visible=False, axis="x")
            pose_label = "pose"
        panel.label(x=pose_label, y="frequency [Hz]")
        if sum(bool(points) for points, *_ in kinds) > 1:
            sheet.legend(panel, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3)

    return Drawing(draw)
