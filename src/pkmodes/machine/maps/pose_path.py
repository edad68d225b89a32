"""A path through the workspace: straight lines from pose to pose, and how far each pose is along it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.machine.maps.poses import Poses

Array = NDArray[np.float64]
#: Number of poses at equal distances along a path, to which its corners are added.
EVEN_POSE_COUNT = 101
#: Decimals of a distance stay below this number: floating-point numbers have no more.
MAX_DECIMALS = 16


@dataclass(frozen=True, eq=False)
class PosePath:
    """Poses along a path.

    - poses: poses in the order of the path
    - distance: distance of each pose from the beginning, (N,), in `unit`
    - corners: distance of each corner and end of the path from the beginning, (K,), in `unit`
    - unit: unit of the distance in figures, such as mm
    """

    poses: Poses
    distance: Array
    corners: Array
    unit: str

    @classmethod
    def through(cls, mechanism: Mechanism, corners: Sequence[Sequence[float]]) -> PosePath:
        """Return a path through poses, at equal distances and at the corners.

        Distances are those of the platform's centre; of a path that only turns, of its angles.

        - corners: components in SI units, (K, d)

        Raises PoseError if there are fewer than two, or two that follow each other are equal.
        """
        if len(corners) < 2:
            names = ",".join(component.name for component in mechanism.pose).upper()
            problem = f"expected at least two poses, found {len(corners)}"
            raise PoseError(problem, "--path", f'write --path "{names};{names}"')
        points = np.asarray(corners, dtype=float)
        units = [component.unit for component in mechanism.pose]
        moves_mask = np.array([unit == units[0] for unit in units])
        if not np.ptp(points[:, moves_mask], axis=0).any():
            moves_mask = ~moves_mask
        steps = np.linalg.norm(np.diff(points[:, moves_mask], axis=0), axis=1)
        if not moves_mask.any() or not steps.all():
            raise PoseError(
                "two poses of the path that follow each other are equal", "--path", "leave one out"
            )
        corner_distances = np.concatenate([[0.0], np.cumsum(steps)])
        distances = np.unique(
            np.concatenate([np.linspace(0.0, corner_distances[-1], EVEN_POSE_COUNT), corner_distances])
        )
        distances = distances[np.concatenate([[True], np.diff(distances) > 1e-9 * corner_distances[-1]])]
        table = np.stack(
            [np.interp(distances, corner_distances, points[:, k]) for k in range(points.shape[1])], axis=1
        )
        unit, factor = DISPLAY_UNITS.get(
            units[int(np.argmax(moves_mask))], (units[int(np.argmax(moves_mask))], 1.0)
        )
        labels = _distance_labels(factor * distances, unit)
        components = tuple(component.name for component in mechanism.pose)
        return cls(Poses(table, components, labels), factor * distances, factor * corner_distances, unit)


def _distance_labels(distances: Array, unit: str) -> tuple[str, ...]:
    """Return distances as labels, with as many decimals as tell their steps apart."""
    step = float(distances[-1]) / EVEN_POSE_COUNT
    for decimals in range(max(0, 1 - math.floor(math.log10(step))), MAX_DECIMALS):
        labels = tuple(f"{distance:.{decimals}f} {unit}" for distance in distances)
        if len(set(labels)) == len(labels):
            break
    return labels
