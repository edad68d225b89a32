"""The reachable workspace as a surface, or as an outline in a plane, found by checking poses of the robot.

Poses of a grid are checked, and the boundary is refined by bisection on every edge of the grid that crosses it.  A
cell's vertex is the mean of its crossings, and every crossed edge joins the cells around it (a dual contour).  It is
a picture: smoothing moves it by a fraction of a cell.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.model import Model
from pkmodes.machine.maps.workspace import PoseTest, branch_test, fixed_components

Array = NDArray[np.float64]
#: Grid cells along each component, and fraction by which the grid extends beyond the box on each side.
CELLS, MARGIN = {2: 48, 3: 30}, 0.05
BISECTIONS = 7
#: Smoothing steps, each half-way to the mean of the neighbours: creases would be ragged otherwise.
SMOOTHING = 5


@dataclass(frozen=True, eq=False)
class Surface:
    """The boundary of a workspace.

    - vertices: poses on the boundary, without rotations of the platform, (V, d)
    - faces: quadrilaterals in space, segments in a plane, (F, 4) or (F, 2)
    """

    vertices: Array
    faces: NDArray[np.intp]


def workspace(
    model: Model, pose: Array, box: tuple[Array, Array], inside: PoseTest | None = None
) -> Surface | None:
    """Find the boundary of the part of the workspace that contains a pose; the platform stays turned as it is.

    - pose: a valid pose, (d,)
    - box: from `pkmodes.machine.maps.workspace.box_of`, each (d,)
    - inside: tests whether poses belong to the workspace; by default whether they can be evaluated, on the branch of
      the pose

    Returns None unless the pose has two or three components besides rotations of the platform, all of them lengths.
    """
    linear_components = [i for i in range(len(pose)) if i not in fixed_components(model, pose)]
    if len(linear_components) not in CELLS or any(
        model.mechanism.pose[i].unit != "m" for i in linear_components
    ):
        return None
    pose_test = branch_test(model, pose) if inside is None else inside

    def is_inside(points: Array) -> NDArray[np.bool_]:
        poses = np.tile(pose, (len(points), 1))
        poses[:, linear_components] = points
        return pose_test(poses)

    low, high = (end[linear_components] for end in box)
    margin = MARGIN * (high - low)
    steps = [
        np.linspace(*ends, CELLS[len(linear_components)] + 1)
        for ends in zip(low - margin, high + margin, strict=True)
    ]
    mask = _connected_part(is_inside, steps, pose[linear_components])
    return _contour(is_inside, steps, mask) if mask.any() else None


def _connected_part(inside: PoseTest, steps: list[Array], pose: Array) -> NDArray[np.bool_]:
    """Return a mask of the grid nodes in the connected part of the workspace that is nearest to a pose."""
    from scipy.ndimage import label

    nodes = np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1)
    mask = inside(nodes.reshape(-1, len(steps))).reshape(nodes.shape[:-1])
    for axis in range(mask.ndim):  # nodes at the edge of the grid are outside, so that the boundary is closed
        edge = np.moveaxis(mask, axis, 0)
        edge[[0, -1]] = False
    labels, count = label(mask)
    if not count:
        return mask
    distance = np.where(mask, np.linalg.norm(nodes - pose, axis=-1), np.inf)
    return np.asarray(labels == labels[np.unravel_index(int(np.argmin(distance)), mask.shape)])


def _contour(inside: PoseTest, steps: list[Array], mask: NDArray[np.bool_]) -> Surface:
    """Return the dual contour of a mask, with crossings found by bisection."""
    d = mask.ndim
    sums, counts = np.zeros((*(n - 1 for n in mask.shape), d)), np.zeros([n - 1 for n in mask.shape])
    rings: list[Array] = []
    for axis in range(d):
        near = np.moveaxis(np.moveaxis(mask, axis, 0)[:-1], 0, axis)
        far = np.moveaxis(np.moveaxis(mask, axis, 0)[1:], 0, axis)
        edges = np.argwhere(near != far)
        ends = edges + np.eye(d, dtype=int)[axis]
        near_points, far_points = (
            np.stack([s[i] for s, i in zip(steps, e.T, strict=True)], axis=-1) for e in (edges, ends)
        )
        is_leaving = near[tuple(edges.T)]
        crossing = _bisect(
            inside,
            np.where(is_leaving[:, None], near_points, far_points),
            np.where(is_leaving[:, None], far_points, near_points),
        )
        cells = []
        for offset in _cell_offsets(d, axis):
            cell = edges + offset
            cells.append(cell)
            np.add.at(sums, tuple(cell.T), crossing)
            np.add.at(counts, tuple(cell.T), 1.0)
        ring = np.stack(cells, axis=1)
        ring[~is_leaving] = ring[~is_leaving, ::-1]  # seen from outside, every face turns the same way
        rings.append(ring)
    has_vertex = counts > 0
    vertex_number = np.full(counts.shape, -1, dtype=np.intp)
    vertex_number[has_vertex] = np.arange(np.count_nonzero(has_vertex))
    faces = np.concatenate([vertex_number[tuple(np.moveaxis(ring, -1, 0))] for ring in rings])
    return Surface(_smooth(sums[has_vertex] / counts[has_vertex][:, None], faces), faces)


def _smooth(vertices: Array, faces: NDArray[np.intp]) -> Array:
    """Return vertices moved towards the mean of those that share an edge of a face with them."""
    pairs = np.concatenate([np.stack([faces[:, i - 1], faces[:, i]], axis=1) for i in range(faces.shape[1])])
    pairs = np.unique(np.sort(pairs, axis=1), axis=0)
    smoothed = vertices
    for _ in range(SMOOTHING if len(pairs) else 0):
        sums, counts = np.zeros_like(smoothed), np.zeros(len(smoothed))
        for a, b in (pairs.T, pairs.T[::-1]):
            np.add.at(sums, a, smoothed[b])
            np.add.at(counts, a, 1.0)
        smoothed = 0.5 * (smoothed + sums / counts[:, None])
    return smoothed


def _cell_offsets(d: int, axis: int) -> list[NDArray[np.intp]]:
    """Return the offsets of the cells around an edge along an axis, in order around it."""
    across_axes = [(axis + k) % d for k in range(1, d)]
    all_shifts = list(product((-1, 0), repeat=d - 1))
    if d == 3:
        all_shifts = [(-1, -1), (0, -1), (0, 0), (-1, 0)]
    offsets = []
    for shifts in all_shifts:
        offset = np.zeros(d, dtype=np.intp)
        offset[across_axes] = shifts
        offsets.append(offset)
    return offsets


def _bisect(inside: PoseTest, inner: Array, outer: Array) -> Array:
    """Return the boundary points of the workspace between inner and outer points."""
    for _ in range(BISECTIONS if len(inner) else 0):
        middle = 0.5 * (inner + outer)
        middle_inside = inside(middle)[:, None]
        inner, outer = np.where(middle_inside, middle, inner), np.where(middle_inside, outer, middle)
    return 0.5 * (inner + outer)
