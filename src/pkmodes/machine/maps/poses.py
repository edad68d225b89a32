"""The poses of a map: a grid, or a list of poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PoseError, shown
from pkmodes.core.mechanism.poses import check_pose_array
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.pose_table import poses_by_name
from pkmodes.core.support.axes import check_axis_values
from pkmodes.machine.dataset.variables import POSE_AXIS

Array = NDArray[np.float64]
EXAMPLE = 'for example: {"x": numpy.linspace(0.3, 0.8, 51), "y": 0.0}'


@dataclass(frozen=True, eq=False)
class PoseGrid:
    """Poses on a grid.

    - axes: values of each component of the pose in the mechanism's order, ascending [SI]
    - usable_only: whether poses beyond the usable limits of a robot are left out, as in a grid chosen by default
    """

    axes: Mapping[str, Array]
    usable_only: bool = False

    @property
    def dims(self) -> tuple[str, ...]:
        """Names of the axes, the first component last: ``("z", "y", "x")``."""
        return tuple(reversed(list(self.axes)))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values along each of `dims`."""
        return tuple(len(self.axes[name]) for name in self.dims)

    def points(self, indices: NDArray[np.intp]) -> Array:
        """Return poses by their flat index, (N, d)."""
        axis_indices = np.unravel_index(indices, self.shape)
        return np.stack(
            [self.axes[name][i] for name, i in zip(reversed(self.dims), axis_indices[::-1], strict=True)], -1
        )

    def normal(self, directions: Sequence[str]) -> str | None:
        """Return the direction perpendicular to the plane of the grid.

        - directions: directions in which the platform moves

        Returns the component with a single value; if there is not exactly one, the third direction.  None for a
        mechanism that moves in a plane.
        """
        if len(directions) < 3:
            return None
        single = [name for name in directions if len(self.axes.get(name, ())) == 1]
        return single[0] if len(single) == 1 else directions[2]


@dataclass(frozen=True, eq=False)
class Poses:
    """A list of poses.

    - table: poses in SI units, (N, d)
    - names: components of a pose, length d
    - labels: one for each pose
    """

    table: Array
    names: tuple[str, ...]
    labels: tuple[str, ...] | None = None

    dims = (POSE_AXIS,)

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of poses."""
        return (len(self.table),)

    def points(self, indices: NDArray[np.intp]) -> Array:
        """Return poses by their index, (N, d)."""
        return self.table[indices]

    def normal(self, directions: Sequence[str]) -> str | None:
        """Return the third direction of the platform's motion, if there is one."""
        return directions[2] if len(directions) > 2 else None


MapPoses = PoseGrid | Poses


def checked_poses(mechanism: Mechanism, poses: Mapping[str, ArrayLike] | ArrayLike | MapPoses) -> MapPoses:
    """Check the poses of a map.

    - poses: ascending values, or one number, for each component of the pose, rotations 0 where they are not given; or
      a list of poses, (N, d)

    Raises PoseError if a component is missing or unknown, or its values do not ascend; or if it is not an array of
    poses.
    """
    if isinstance(poses, PoseGrid | Poses):
        return poses
    if not isinstance(poses, Mapping):
        points, _ = check_pose_array(poses_by_name(poses, mechanism), mechanism, "raise")
        return Poses(points, tuple(component.name for component in mechanism.pose))
    names = [component.name for component in mechanism.pose]
    for name in poses:
        if name not in names:
            problem = f"expected values of {', '.join(names)}, found {shown(name)}"
            raise PoseError(problem, "grid", EXAMPLE)
    poses = {**dict.fromkeys(mechanism.components[len(mechanism.directions) :], 0.0), **poses}
    missing = [name for name in names if name not in poses]
    if missing:
        problem = f"expected values of {', '.join(names)}, found none of {', '.join(missing)}"
        raise PoseError(problem, "grid", f"give one number or several, {EXAMPLE}")
    return PoseGrid(
        {name: check_axis_values(poses[name], name, f"grid: {name}", EXAMPLE, PoseError) for name in names}
    )
