"""The table of the measured components of a mode beside those of the model: what the moving marks say, in numbers."""

from __future__ import annotations

import math
from html import escape

from pkmodes.view.measured_data import measured_data
from pkmodes.view.scene import Scene

#: Units of components, for a largest displacement of 1 mm.
SMALL = {"m": "mm", "rad": "mrad"}


def measured_table(scene: Scene, key: str) -> str:
    """Return the table of the first mode at the pose that is shown first; empty without measured components.

    Parameters
    ----------
    key : str
        Prefix of identifiers, escaped.
    """
    data = measured_data(scene)
    if data is None or not scene.channels:
        return '<p hidden data-part="compared"></p>' if data is not None else ""
    mode = min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    here = [one for one in data["modes"] if one["pose"] == scene.chosen and one["mode"] == mode]
    rows = []
    for k, channel in enumerate(scene.channels):
        cells = "".join(
            f'<td data-part="of-{name}">{_cell(here[0][name][k] if here and "measured" in here[0] else None)}</td>'
            for name in ("measured", "model")
        )
        unit = escape(SMALL.get(channel.unit, channel.unit))
        rows.append(
            f'<tr data-part="component"><th scope="row">{escape(channel.name)} [{unit}]</th>{cells}</tr>'
        )
    number = mode - scene.rigid_modes + 1
    return (
        f'<div class="pkview-numbers"><p id="{key}-measured"><b>Measured against model:</b> components of'
        f' <span data-part="compared">mode {number}</span>, for a largest displacement of the model of 1 mm.  The'
        " measured shape is scaled to the model&#8217;s by least squares, and drawn where its sensors are; nothing"
        " else was measured: all other motion in the picture is the model&#8217;s.</p>"
        f'<div class="pkview-table" role="region" aria-labelledby="{key}-measured" tabindex="0">'
        f'<table aria-labelledby="{key}-measured"><thead><tr><td></td><th scope="col">measured</th>'
        f'<th scope="col">model</th></tr></thead><tbody>{"".join(rows)}</tbody></table></div></div>'
    )


def observed(scene: Scene) -> str:
    """Return what was measured of the mode that is shown first, in words."""
    mode = min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    here = [one for one in scene.measured or () if (one.pose, one.mode) == (scene.chosen, mode)]
    if not here:
        return "Not measured at this pose."
    (one, *_) = here
    digits = min(max(0, 1 - math.floor(math.log10(one.sigma))), 4)
    said = f"Measured: {one.frequency:.{digits}f} \u00b1 {one.sigma:.{digits}f} Hz"
    if not one.has_shape:
        return f"{said}, without a shape."
    return said + ("." if one.mac is None or math.isnan(one.mac) else f", MAC {one.mac:.3f}.")


def _cell(value: float | None) -> str:
    return "\u2013" if value is None else f"{value + 0.0:.3f}".replace("-", "\u2212")
