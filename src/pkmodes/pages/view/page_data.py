"""A scene as the data of a page: rounded numbers, and for every pose and mode a displacement of at most 1 m."""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.length import unit_vectors
from pkmodes.pages.view.camera import camera, hiding_plates
from pkmodes.pages.view.interpolation import largest_around
from pkmodes.pages.view.measured_data import measured_data
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes.pages.view.workspace import Surface

Array = NDArray[np.float64]
#: Decimals of positions [m], of displacements and rotations per metre of the largest displacement, of shares, and of
#: interpolation errors.
POSITION_DECIMALS, MOTION_DECIMALS, SHARE_DECIMALS, ERROR_DECIMALS = 5, 4, 4, 5
#: Longest JSON that a page holds as plain text [characters]; longer data are deflated, to about a third.
MAX_PLAIN_CHARACTERS = 1_000_000


def scene_data(scene: Scene) -> dict[str, Any]:
    """Return the data of a page; arrays of a pose or mode are flat lists."""
    turning_coordinates = list(dict.fromkeys(element.turns for element in scene.elements if element.turns))
    shares = scene.shares
    displacements, rotations = _displacements_and_rotations(scene, turning_coordinates)
    levels, deviations, clear_plates = None, None, hiding_plates(scene)
    if scene.levels is not None:  # components of poses to a micrometre, values of parameters unrounded
        levels = [values.tolist() if scene.varied else _round_nested(values, 6) for values in scene.levels]
    if scene.deviations is not None:  # an entry for every one of `interpolation_errors`; None where unknown
        sizes = largest_around(scene.deviations).ravel().tolist()
        deviations = [_round_nested(size, ERROR_DECIMALS) if np.isfinite(size) else None for size in sizes]
    return {
        "size": _round_nested(scene.size, POSITION_DECIMALS),
        "amplitude": AMPLITUDE,
        "vertical": _round_nested(scene.vertical, 6),
        "towards": _round_nested(camera(scene)[2], 4),
        "pose": [{"name": c.name, "unit": c.unit} for c in scene.pose],
        "components": list(scene.moves),
        "bodies": list(scene.bodies),
        "elements": [
            {
                "shape": element.shape,
                "kind": element.kind,
                "name": element.name,
                "points": list(element.points),
                "spring": element.spring,
                "turns": turning_coordinates.index(element.turns) if element.turns else -1,
                **({"marked": True} if i in scene.marked else {}),
                **({"clear": True} if i in clear_plates else {}),
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
        "poses": _round_nested(scene.poses, 6),
        "axes": [{"name": c.name, "unit": c.unit} for c in scene.axes],
        "varied": bool(scene.varied),
        "declared": scene.declared,
        "labels": list(scene.labels),
        "measured": measured_data(scene),
        "points": _round_nested(scene.points.reshape(len(scene.poses), -1), POSITION_DECIMALS),
        "frequencies": _round_nested(scene.frequencies, 4),
        "sigmas": None if scene.sigmas is None else _rounded_sigmas(scene.sigmas),
        "moved": _round_nested(displacements, MOTION_DECIMALS),
        "turned": _round_nested(rotations, MOTION_DECIMALS),
        "shares": [
            [
                None if np.isnan(mode_shares).any() else _round_nested(mode_shares, SHARE_DECIMALS)
                for mode_shares in pose_shares
            ]
            for pose_shares in shares
        ],
        "directions": _round_nested(platform_directions(scene), MOTION_DECIMALS),
        "workspace": _surface_data(scene, scene.workspace),
    }


def platform_directions(scene: Scene) -> Array:
    """Return the unit vectors of the platform's motion, (N, m, components); zero where it does not move."""
    return unit_vectors(scene.platform_shapes, scene.lengths)


def data_element(data: dict[str, Any]) -> str:
    """Return the script element with the data of a view: plain JSON, or deflated where that is large."""
    text = script_json(data)
    if len(text) <= MAX_PLAIN_CHARACTERS:
        return f'<script type="application/json">{text}</script>'
    deflated = b64encode(zlib.compress(text.encode("utf-8"), 9)).decode("ascii")
    return f'<script type="application/x-deflated-json">{deflated}</script>'


def script_json(data: dict[str, Any]) -> str:
    """Return JSON for a script element, without characters that could end the element."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _displacements_and_rotations(scene: Scene, turning_coordinates: list[str]) -> tuple[Array, Array]:
    """Return displacements (N, m, 3 B) and rotations (N, m, turned), for a largest displacement of 1 m."""
    count, modes = scene.frequencies.shape
    scales = np.array([[scene.scale(i, k) for k in range(modes)] for i in range(count)])
    shapes = scene.shapes * scales[:, :, None]
    displacements = np.einsum("pbcn,pmn->pmbc", scene.motions, shapes).reshape(count, modes, -1)
    return displacements, shapes[:, :, [scene.coordinates.index(name) for name in turning_coordinates]]


def _rounded_sigmas(sigmas: Array) -> list[list[float | None]]:
    """Return standard deviations with six digits; None where there is none."""
    return [[float(f"{sigma:.6g}") if sigma > 0.0 else None for sigma in row] for row in sigmas.tolist()]


def _surface_data(scene: Scene, surface: Surface | None) -> dict[str, Any] | None:
    if surface is None:
        return None
    vertices = np.tile(scene.points[scene.chosen, 0], (len(surface.vertices), 1))
    vertices[:, ["xyz".index(name) for name in scene.directions]] = surface.vertices
    return {
        "corners": surface.faces.shape[1],
        "vertices": _round_nested(vertices.ravel(), 4),
        "faces": surface.faces.ravel().tolist(),
    }


def _round_nested(values: Any, digits: int) -> Any:
    """Return nested lists of rounded numbers, whole ones as integers: fewer characters in the page."""
    if isinstance(values, float):
        values = round(values, digits)
        return int(values) if values == int(values) else values
    if isinstance(values, list):
        return [_round_nested(value, digits) for value in values]
    return _round_nested(np.asarray(values, dtype=float).tolist(), digits)
