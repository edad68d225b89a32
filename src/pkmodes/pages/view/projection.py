"""A still camera: the direction from which pictures without a viewer show a robot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.view.scene import Scene
from pkmodes_description import Element

Array = NDArray[np.float64]
#: Shapes of elements whose outlines enclose an area.
AREA_SHAPES = ("wheel", "plate")
#: Azimuth and elevation from which robots are seen, and flat ones that move in a plane [deg].
AZIMUTH, ELEVATION = -60.0, 18.0
FLAT_AZIMUTH, FLAT_ELEVATION = -81.0, 48.0
#: A robot is flat whose height is below this fraction of its size.
FLAT_FRACTION = 0.2


def view_rotation(scene: Scene, turn: float = 0.0, rise: float = 0.0) -> Array:
    """Return the rotation to (right, up, towards the viewer), (3, 3), for the usual direction of view, or one beside.

    - turn, rise: by how much the viewer is further to the right, and higher [deg]
    """
    up = np.array([0.0, 0.0, 1.0]) if len(scene.directions) < 3 else scene.vertical
    side = np.cross(up, [1.0, 0.0, 0.0] if abs(up[0]) < 0.9 else [0.0, 1.0, 0.0])
    east = np.cross(side, up)
    east, side = east / np.linalg.norm(east), side / np.linalg.norm(side)
    height = float(np.ptp(scene.points[scene.chosen] @ up))
    flat = len(scene.directions) < 3 and height < FLAT_FRACTION * scene.size
    azimuth = np.radians((FLAT_AZIMUTH if flat else AZIMUTH) + turn)
    elevation = np.radians((FLAT_ELEVATION if flat else ELEVATION) + rise)
    towards_viewer = (
        np.cos(elevation) * (np.cos(azimuth) * east + np.sin(azimuth) * side) + np.sin(elevation) * up
    )
    right = np.cross(up, towards_viewer)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards_viewer, right), towards_viewer])


def outline(element: Element, points: Array, angle: float = 0.0) -> Array:
    """Return what the camera sees of an element, (n, 2): a line, the edge of one of `AREAS`, or the point of a ball.

    - points: of the whole machine, (p, 3): to the right, up, and towards the viewer
    - angle: by which a wheel is turned [rad]
    """
    positions = points[list(element.points)]
    if element.shape == "wheel":
        axis = positions[1] - positions[0]
        positions = rim(positions[0], axis, angle) if axis.any() else positions[:1]
    elif element.shape == "ball":
        positions = positions[:1]
    elif element.shape == "block":
        positions = np.stack([2.0 * positions[0] - positions[1], positions[1]])
    projected = positions[:, :2]
    return hull(projected) if element.shape == "plate" else projected


def hull(points: Array) -> Array:
    """Return the corners of the convex hull of points in a plane, (n, 2), in order."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(points[ConvexHull(points).vertices])
    except QhullError:  # all on a line: a plate seen from the side
        return points


def rim(centre: Array, axis: Array, angle: float, corners: int = 48) -> Array:
    """Return points around the rim of a wheel, (corners + 1, 3); the first is turned by an angle about the axis.

    - centre, axis: (3,); the length of the axis is the radius
    - angle: rad
    """
    radius = float(np.linalg.norm(axis))
    unit_axis = axis / radius
    helper = np.array([0.0, 0.0, 1.0]) if abs(unit_axis[2]) < 0.9 else np.array([1.0, 0.0, 0.0])
    first = np.cross(unit_axis, helper)
    first /= np.linalg.norm(first)
    angles = np.linspace(0.0, 2.0 * np.pi, corners + 1)[:, None] + angle
    rim_points: Array = centre + radius * (
        np.cos(angles) * first + np.sin(angles) * np.cross(unit_axis, first)
    )
    return rim_points
