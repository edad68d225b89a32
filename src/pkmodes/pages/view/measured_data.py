"""Measured modes as data of a page: components in the scale of the picture, and where they can be drawn.

Components are drawn of the platform, of parts that one coordinate alone moves, and of wheels that a coordinate turns.
The others are only in the table, which has all measured components of a mode beside those of the model.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.view.measured_modes import channel_weights, scale_factor
from pkmodes.pages.view.scene import Scene

Array = NDArray[np.float64]
#: Kinds of elements on which a coordinate is drawn as a displacement; decimals of components.
MOVING_KINDS = ("carriage", "arm", "gantry", "toolhead", "platform", "body")
DECIMALS = 4
#: Units of components for a largest displacement of 1 mm.
SCALED_UNITS = {"m": "mm", "rad": "mrad"}


def measured_data(scene: Scene) -> dict[str, Any] | None:
    """Return the measured modes of a scene; components are for a largest displacement of the model of 1 m."""
    if scene.measured is None:
        return None
    modes = []
    for measured in scene.measured:
        pose, mode, mac = measured.pose, measured.mode, measured.mac
        entry: dict[str, Any] = {
            "pose": pose,
            "mode": mode,
            "name": measured.name,
            "frequency": round(measured.frequency, 4),
            "sigma": float(f"{measured.sigma:.3g}"),
            "mac": None if mac is None or np.isnan(mac) else round(mac, 4),
            "shape": measured.has_shape,
        }
        modes.append(entry)
        if mode is None or not measured.has_shape:
            continue
        shapes, shape, scale = channel_shapes(scene, pose), np.array(measured.shape), scene.scale(pose, mode)
        scaled_shape = scale * scale_factor(shape, shapes[mode], channel_weights(shapes)) * shape
        arrows, turns = _drawn_components(scene, pose, scaled_shape)
        entry |= {
            "measured": [
                None if np.isnan(value) else round(value, DECIMALS) + 0.0 for value in scaled_shape.tolist()
            ],
            "model": [round(value, DECIMALS) + 0.0 for value in (scale * shapes[mode]).tolist()],
            "arrows": arrows,
            "turns": turns,
        }
    channels = [{"name": channel.name, "unit": channel.unit} for channel in scene.channels]
    return {"channels": channels, "modes": modes}


def channel_shapes(scene: Scene, pose: int) -> Array:
    """Return the shapes of all modes at the channels, (m, C); 0 for a coordinate that the model locks."""
    shapes = np.zeros((scene.frequencies.shape[1], len(scene.channels)))
    platform = [component.name for component in scene.platform]
    for k, channel in enumerate(scene.channels):
        if channel.name in scene.coordinates:
            shapes[:, k] = scene.shapes[pose, :, scene.coordinates.index(channel.name)]
        elif channel.name in platform:
            shapes[:, k] = scene.platform_shapes[pose, :, platform.index(channel.name)]
    return shapes


def _drawn_components(scene: Scene, pose: int, scaled_shape: Array) -> tuple[list[Any], list[Any]]:
    """Return displacements as [point, x, y, z], and rotations as [element, angle], of the measured components."""
    platform, arrows, turns = np.zeros(3), [], []
    linear_names = [component.name for component in scene.platform if component.unit == "m"]
    for channel, value in zip(scene.channels, scaled_shape.tolist(), strict=True):
        if np.isnan(value):
            continue
        if channel.name in linear_names:
            platform["xyz".index(channel.name[-1])] = value
        elif wheels := [i for i, e in enumerate(scene.elements) if e.turns and e.turns == channel.name]:
            turns += [[i, round(value, DECIMALS)] for i in wheels]
        elif (moved_point := _moved_point(scene, pose, channel.name)) is not None:
            point, displacement = moved_point
            arrows.append([point, *(round(v, DECIMALS) + 0.0 for v in (displacement * value).tolist())])
    if platform.any():
        arrows.insert(0, [0, *(round(v, DECIMALS) + 0.0 for v in platform.tolist())])
    return arrows, turns


def _moved_point(scene: Scene, pose: int, name: str) -> tuple[int, Array] | None:
    """Return a point of a part that a coordinate moves alone, and its displacement per unit; None without one."""
    if name not in scene.coordinates:
        return None
    column = scene.coordinates.index(name)
    other_columns = [
        k for k, coordinate in enumerate(scene.coordinates) if coordinate in scene.independent and k != column
    ]
    best_point = None
    for element in scene.elements:
        for point in element.points if element.kind in MOVING_KINDS else ():
            motion = scene.motions[pose, scene.motions_of[point]]
            size = float(np.linalg.norm(motion[:, column]))
            moves_alone = size > 1e-9 and np.abs(motion[:, other_columns]).max(initial=0.0) < 1e-9 * size
            if moves_alone and (best_point is None or size > np.linalg.norm(best_point[1]) * (1 + 1e-9)):
                best_point = int(point), motion[:, column]
    return best_point


def measured_table(scene: Scene, prefix: str) -> str:
    """Return the table of the first mode at the pose that is shown first; empty without measured components.

    - prefix: prefix of identifiers, escaped
    """
    data = measured_data(scene)
    if data is None or not scene.channels:
        return '<p hidden data-part="compared"></p>' if data is not None else ""
    mode = min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    shown_entries = [
        entry for entry in data["modes"] if entry["pose"] == scene.chosen and entry["mode"] == mode
    ]
    rows = []
    for index, channel in enumerate(scene.channels):
        cells = ""
        for name in ("measured", "model"):
            value = (
                shown_entries[0][name][index] if shown_entries and "measured" in shown_entries[0] else None
            )
            text = "\u2013" if value is None else f"{value + 0.0:.3f}".replace("-", "\u2212")
            cells += f'<td data-part="of-{name}">{text}</td>'
        unit = escape(SCALED_UNITS.get(channel.unit, channel.unit))
        rows.append(
            f'<tr data-part="component"><th scope="row">{escape(channel.name)} [{unit}]</th>{cells}</tr>'
        )
    number = mode - scene.rigid_modes + 1
    caption = (
        f'<b>Measured against model:</b> components of <span data-part="compared">mode {number}</span>, for a largest'
        " displacement of the model of 1 mm.  The measured shape is scaled to the model&#8217;s by least squares, and"
        " drawn where its sensors are; nothing else was measured: all other motion in the picture is the"
        " model&#8217;s."
    )
    head_cells = '<th scope="col">measured</th><th scope="col">model</th>'
    return numbers_table(f"{prefix}-measured", caption, head_cells, rows)


def numbers_table(identifier: str, caption: str, head_cells: str, rows: Sequence[str]) -> str:
    """Return a table of the viewer from its parts in HTML, with its caption under an identifier."""
    return (
        f'<div class="pkview-numbers"><p id="{identifier}">{caption}</p>'
        f'<div class="pkview-table" role="region" aria-labelledby="{identifier}" tabindex="0">'
        f'<table aria-labelledby="{identifier}"><thead><tr><td></td>{head_cells}</tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div></div>"
    )


def measured_sentence(scene: Scene) -> str:
    """Return a sentence on the measurement of the mode that is shown first."""
    mode = min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    shown_modes = [
        measured
        for measured in scene.measured or ()
        if (measured.pose, measured.mode) == (scene.chosen, mode)
    ]
    if not shown_modes:
        return "Not measured at this pose."
    (measured_mode, *_) = shown_modes
    digits = min(max(0, 1 - math.floor(math.log10(measured_mode.sigma))), 4)
    text = f"Measured: {measured_mode.frequency:.{digits}f} \u00b1 {measured_mode.sigma:.{digits}f} Hz"
    if not measured_mode.has_shape:
        return f"{text}, without a shape."
    return text + (
        "."
        if measured_mode.mac is None or math.isnan(measured_mode.mac)
        else f", MAC {measured_mode.mac:.3f}."
    )
