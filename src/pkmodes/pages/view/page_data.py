"""A scene as the data of a page: rounded numbers, and for every pose and mode a displacement of at most 1 m."""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.length import unit_vectors
from pkmodes.pages.view.interpolation import largest_around
from pkmodes.pages.view.measured_data import measured_data
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes.pages.view.workspace import Surface

Array = NDArray[np.float64]
#: Decimals of positions [m], of displacements and rotations per metre, of shares, and of errors between states.
PLACES, MOVES, SHARES, OFF = 5, 4, 4, 5
#: Most characters of JSON that a page holds as they are; deflated, they are a third.
PLAIN = 1_000_000


def as_data(scene: Scene) -> dict[str, Any]:
    """Return the data of a page; arrays of a pose or mode are flat lists."""
    turned = list(dict.fromkeys(element.turns for element in scene.elements if element.turns))
    shares = scene.shares
    moved, turns = _moves(scene, turned)
    levels, deviations = None, None
    if scene.levels is not None:  # of poses to a micrometre, of parameters as they are
        levels = [values.tolist() if scene.varied else _rounded(values, 6) for values in scene.levels]
    if scene.deviations is not None:  # at the places of `interpolation.deviations`; None where unknown
        sizes = largest_around(scene.deviations).ravel().tolist()
        deviations = [_rounded(size, OFF) if np.isfinite(size) else None for size in sizes]
    return {
        "size": _rounded(scene.size, PLACES),
        "amplitude": AMPLITUDE,
        "vertical": _rounded(scene.vertical, 6),
        "pose": [{"name": c.name, "unit": c.unit} for c in scene.pose],
        "components": list(scene.moves),
        "elements": [
            {
                "shape": element.shape,
                "kind": element.kind,
                "name": element.name,
                "points": list(element.points),
                "spring": element.spring,
                "turns": turned.index(element.turns) if element.turns else -1,
                **({"marked": True} if i in scene.marked else {}),
            }
            for i, element in enumerate(scene.elements)
        ],
        "springs": [spring.name for spring in scene.springs],
        "motionsOf": scene.motions_of.tolist(),
        "rigid": scene.rigid_modes,
        "chosen": scene.chosen,
        "levels": levels,
        "places": None if scene.places is None else scene.places.ravel().tolist(),
        "order": None if scene.order is None else scene.order.tolist(),
        "deviations": deviations,
        "checked": scene.checked,
        "poses": _rounded(scene.poses, 6),
        "axes": [{"name": c.name, "unit": c.unit} for c in scene.axes],
        "varied": bool(scene.varied),
        "declared": scene.declared,
        "labels": list(scene.labels),
        "measured": measured_data(scene),
        "points": _rounded(scene.points.reshape(len(scene.poses), -1), PLACES),
        "frequencies": _rounded(scene.frequencies, 4),
        "moved": _rounded(moved, MOVES),
        "turned": _rounded(turns, MOVES),
        "shares": [
            [None if np.isnan(held).any() else _rounded(held, SHARES) for held in modes] for modes in shares
        ],
        "directions": _rounded(platform_directions(scene), MOVES),
        "workspace": _surface(scene, scene.workspace),
    }


def platform_directions(scene: Scene) -> Array:
    """Return the unit vectors of the platform's motion, (N, m, components); zero where it does not move."""
    return unit_vectors(scene.platform_shapes, scene.lengths)


def packed(data: dict[str, Any]) -> str:
    """Return the script element with the data of a view: plain JSON, or deflated where that is large."""
    text = embedded(data)
    if len(text) <= PLAIN:
        return f'<script type="application/json">{text}</script>'
    deflated = b64encode(zlib.compress(text.encode("utf-8"), 9)).decode("ascii")
    return f'<script type="application/x-deflated-json">{deflated}</script>'


def embedded(data: dict[str, Any]) -> str:
    """Return JSON that cannot end the script element it stands in."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _moves(scene: Scene, turned: list[str]) -> tuple[Array, Array]:
    """Return displacements (N, m, 3 B) and rotations (N, m, turned), for a largest displacement of 1 m."""
    count, modes = scene.frequencies.shape
    scales = np.array([[scene.scale(i, k) for k in range(modes)] for i in range(count)])
    shapes = scene.shapes * scales[:, :, None]
    moved = np.einsum("pbcn,pmn->pmbc", scene.motions, shapes).reshape(count, modes, -1)
    return moved, shapes[:, :, [scene.coordinates.index(name) for name in turned]]


def _surface(scene: Scene, surface: Surface | None) -> dict[str, Any] | None:
    if surface is None:
        return None
    vertices = np.tile(scene.points[scene.chosen, 0], (len(surface.vertices), 1))
    vertices[:, ["xyz".index(name) for name in scene.directions]] = surface.vertices
    return {
        "corners": surface.faces.shape[1],
        "vertices": _rounded(vertices.ravel(), 4),
        "faces": surface.faces.ravel().tolist(),
    }


def _rounded(values: Any, digits: int) -> Any:
    """Return nested lists of rounded numbers, whole ones as integers: fewer characters in the page."""
    if isinstance(values, float):
        values = round(values, digits)
        return int(values) if values == int(values) else values
    if isinstance(values, list):
        return [_rounded(value, digits) for value in values]
    return _rounded(np.asarray(values, dtype=float).tolist(), digits)
