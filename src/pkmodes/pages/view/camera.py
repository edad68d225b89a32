"""Where a robot is looked at from: so that its springs and what moves are seen, and no plate or block hides them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.view.projection import hull, rim, view_rotation
from pkmodes.pages.view.scene import Scene
from pkmodes_description import Element

Array = NDArray[np.float64]
#: Turns to the right and changes of the elevation that are tried, from the usual direction [deg].
TURNS, RISES = tuple(range(-45, 46, 15)), (-10.0, 0.0, 10.0)
#: Loss for each degree away from the usual direction, and the gain below which that is kept.
LOSS_PER_DEGREE, MIN_GAIN = 0.001, 0.04
#: Points along each line and spoke that are tested, and the size of gaps that hide nothing, relative to the robot.
SAMPLES, GAP = 12, 0.01
#: Share of a spring that a plate may hide without being drawn transparent.
MAX_HIDDEN_SHARE = 0.1
#: Kinds of elements that move with the pose.
MOVING_KINDS = ("platform", "toolhead", "bed", "carriage")


def camera(scene: Scene) -> Array:
    """Return the rotation to (right, up, towards the viewer), (3, 3), from which a robot is seen best.

    The usual direction is kept unless another one shows clearly more of the springs and of what moves.
    """
    usual = view_rotation(scene)
    best, best_score = usual, seen_share(scene, usual) + MIN_GAIN
    for turn, rise in product(TURNS, RISES):
        rotation = view_rotation(scene, turn, rise)
        score = seen_share(scene, rotation) - LOSS_PER_DEGREE * (abs(turn) + abs(rise))
        if score > best_score + 1e-9:
            best, best_score = rotation, score
    return best


def seen_share(scene: Scene, rotation: Array) -> float:
    """Return how much of the springs and of what moves is seen, from 0 to 1: hidden or seen end-on counts less."""
    shares: dict[str, list[float]] = {}
    for element, facing, hidden_by in _visibility(scene, rotation):
        hidden = np.logical_or.reduce(list(hidden_by.values())) if hidden_by else np.array(False)
        shares.setdefault(element.name, []).append(facing * (1.0 - float(hidden.mean())))
    return float(np.mean([np.mean(values) for values in shares.values()])) if shares else 1.0


def hiding_plates(scene: Scene) -> frozenset[int]:
    """Return the indices of plates that hide a part of a spring from the camera: drawings let it shine through."""
    return frozenset(
        k
        for element, _, hidden_by in _visibility(scene, camera(scene))
        for k, hidden in hidden_by.items()
        if element.spring >= 0 and scene.elements[k].shape == "plate" and hidden.mean() > MAX_HIDDEN_SHARE
    )


def _visibility(
    scene: Scene, rotation: Array
) -> Iterator[tuple[Element, float, dict[int, NDArray[np.bool_]]]]:
    """Yield each spring and each part that moves, how much it faces the viewer, and what hides its points.

    What hides it: for the index of each element that hides any, whether it hides each sample, (n,).
    """
    points = scene.points[scene.chosen] @ rotation.T
    indices = [i for i, e in enumerate(scene.elements) if e.spring >= 0 or e.kind in MOVING_KINDS]
    parts = [_samples(scene.elements[i], points) for i in indices]
    samples = np.concatenate([part for part, _ in parts]) if parts else np.zeros((0, 3))
    ends = np.cumsum([len(part) for part, _ in parts])
    hidden = {}
    for k, element in enumerate(scene.elements):
        if (cover := _cover(element, points)) is not None:
            polygon, plane = cover
            depth = samples[:, :2] @ plane[:2] + plane[2]
            is_behind = _is_inside(samples[:, :2], polygon) & (samples[:, 2] < depth - GAP * scene.size)
            hidden[k] = np.split(is_behind, ends[:-1])
    for number, (i, (_, facing)) in enumerate(zip(indices, parts, strict=True)):
        hidden_by = {
            k: of_parts[number] for k, of_parts in hidden.items() if k != i and of_parts[number].any()
        }
        yield scene.elements[i], facing, hidden_by


def _samples(element: Element, points: Array) -> tuple[Array, float]:
    """Return points of an element, (n, 3), and how much of it faces the viewer, from 0 to 1."""
    positions = points[list(element.points)]
    if element.shape == "line":
        ends = np.linspace(0.0, 1.0, SAMPLES)[:, None, None]
        along = np.diff(positions, axis=0)
        length = float(np.linalg.norm(along, axis=1).sum())
        facing = float(np.linalg.norm(along[:, :2], axis=1).sum()) / length if length > 0.0 else 1.0
        return (positions[:-1] + ends * along).reshape(-1, 3), facing
    if element.shape == "wheel" and (axis := positions[1] - positions[0]).any():
        facing = 0.5 + 0.5 * abs(float(axis[2])) / float(np.linalg.norm(axis))
        return rim(positions[0], axis, 0.0, SAMPLES), facing
    return np.vstack([positions, positions.mean(axis=0)]), 1.0


def _cover(element: Element, points: Array) -> tuple[Array, Array] | None:
    """Return the outline of an element that hides what is behind it, (n, 2), and its depth as a plane (a, b, c)."""
    positions = points[list(element.points)]
    if element.shape == "wheel" and (axis := positions[1] - positions[0]).any():
        corners = rim(positions[0], axis, 0.0, SAMPLES)
    elif element.shape == "plate" and len(positions) > 2:
        corners = positions
    elif element.shape == "block":
        half = float(np.linalg.norm(positions[1] - positions[0]))
        corners = positions[0] + half * np.array(list(product((-1.0, 1.0), (-1.0, 1.0), (0.0,))))
    else:
        return None
    outline = hull(corners[:, :2])
    columns = np.column_stack([corners[:, :2], np.ones(len(corners))])
    area = 0.5 * abs(
        float(np.sum(outline[:, 0] * np.roll(outline[:, 1], -1) - outline[:, 1] * np.roll(outline[:, 0], -1)))
    )
    if area < 1e-3 * float(np.ptp(corners, axis=0).max()) ** 2:
        return None  # seen from its edge
    return outline, np.asarray(np.linalg.lstsq(columns, corners[:, 2], rcond=None)[0], dtype=float)


def _is_inside(points: Array, polygon: Array) -> NDArray[np.bool_]:
    """Return whether points, (n, 2), lie within a convex polygon whose corners are in order."""
    edges = np.roll(polygon, -1, axis=0) - polygon
    offsets = points[:, None] - polygon
    sides = edges[:, 0] * offsets[..., 1] - edges[:, 1] * offsets[..., 0]
    return np.asarray((sides > 0.0).all(axis=1) | (sides < 0.0).all(axis=1))
