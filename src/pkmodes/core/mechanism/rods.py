"""The rods of a mechanism and their angles to their singular directions, from the derived drawing of the mechanism.

A rod joins a carriage or an arm, which one independent coordinate moves along a direction t, to a body that others
move too.  It is singular if the vector s along the rod is perpendicular to t: that coordinate then no longer moves
the body along the rod.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.poses import CHUNK
from pkmodes.core.mechanism.regular import sample_parameters

Array = NDArray[np.float64]
#: Kind of the elements of a drawing that are rods.
ROD_KIND = "link"


class Rod(NamedTuple):
    """A rod: its drawn points, the one at the carriage first, with the motion and the coordinate of that point."""

    foot: int
    end: int
    motion: int
    coordinate: int


@cache
def rods_of(mechanism: Mechanism) -> tuple[Rod, ...]:
    """Return the rods that have a singular direction; empty for a mechanism without any."""
    lines = [e.points for e in mechanism.drawing.elements if e.kind == ROD_KIND and len(e.points) == 2]
    if not lines:
        return ()
    # Entries that depend on the pose are NaN here: a coordinate whose entry is not 0 may move the point.
    with np.errstate(all="ignore"):
        unknown_pose = np.full(len(mechanism.pose), np.nan)
        moves = _motions(mechanism, sample_parameters(mechanism), unknown_pose) != 0.0
    rods = []
    for points in lines:
        motions = [moves[mechanism.drawing.motions[point]].any(axis=0) for point in points]
        for (foot, end), (at_foot, at_end) in zip(
            (points, points[::-1]), (motions, motions[::-1]), strict=True
        ):
            if at_foot.sum() == 1 and (at_end & ~at_foot).any():
                rods.append(Rod(foot, end, mechanism.drawing.motions[foot], int(at_foot.argmax())))
                break
    return tuple(rods)


def singular_angles(mechanism: Mechanism, parameters: Any, points: Array) -> Array:
    """Return the angle of every rod to its singular direction, (N, rods) [rad], at poses (N, d).

    From 0, where the rod is perpendicular to the motion of its carriage or arm, to pi/2; NaN where a pose is out of
    reach.
    """
    rods = rods_of(mechanism)
    angles = np.empty((len(points), len(rods)))
    if not rods:
        return angles
    feet, ends, motions, coordinates = (list(column) for column in zip(*rods, strict=True))
    generated = Generated(mechanism.drawn, parameters, mechanism.extended.Effects())
    for start in range(0, len(points), CHUNK):
        p = points[start : start + CHUNK]
        with np.errstate(all="ignore"):
            points_drawn = np.asarray(
                generated.drawing_points(p, *_upright_vectors(mechanism, p)), dtype=float
            )
            s = points_drawn[:, ends] - points_drawn[:, feet]
            t = _motions(mechanism, parameters, p)[
                :, motions, :, coordinates
            ]  # NumPy puts the axis of the rods first
            t = np.moveaxis(t, 0, 1)
            sine = np.abs((s * t).sum(axis=-1)) / (np.linalg.norm(s, axis=-1) * np.linalg.norm(t, axis=-1))
        angles[start : start + CHUNK] = np.arcsin(np.minimum(sine, 1.0))
    return angles


def _motions(mechanism: Mechanism, parameters: Any, points: Array) -> Array:
    """Return the Jacobians of the drawn points with respect to the independent coordinates, (..., motions, 3, k)."""
    generated = Generated(mechanism.drawn, parameters, mechanism.extended.Effects())
    names = list(mechanism.drawn.COORDINATES)
    columns = [names.index(name) for name in mechanism.independent]
    motions = np.asarray(generated.drawing_motion(points, *_upright_vectors(mechanism, points)), dtype=float)
    return np.broadcast_to(motions, (*points.shape[:-1], *motions.shape[-3:]))[..., columns]


def _upright_vectors(mechanism: Mechanism, points: Array) -> tuple[Array, ...]:
    """Return the vectors of the uprights: 0, since the sides of a parallelogram are parallel."""
    uprights = mechanism.drawing.uprights
    return (np.zeros((*points.shape[:-1], 3 * uprights)),) if uprights else ()
