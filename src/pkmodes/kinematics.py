"""Kinematics of one robot at poses: which can be evaluated, carriages, assemblies, the platform's Jacobian.

Effects leave them as they are: the generated base model answers for every robot.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.errors import PkmodesError, PoseError, shown
from pkmodes.gathering import Gathered
from pkmodes.poses import (
    CHUNK,
    MAX_CONDITION,
    CheckedPoses,
    OnError,
    as_points,
    check_poses,
    largest_condition,
)
from pkmodes.results import PoseCheck
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta as generated

Array = NDArray[np.float64]


class Kinematics:
    """The part of `pkmodes.Model` that needs no dynamics.

    Parameters
    ----------
    robot : Robot
    max_condition : float
        Poses where the condition number of D_l is larger are refused as singular.
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        if not isinstance(robot, Robot):
            raise PkmodesError(f"expected a Robot, found {shown(robot)}", "Model", "use pkmodes.load(path)")
        self.max_condition = largest_condition(max_condition)
        self.robot = robot

    def check(self, poses: ArrayLike) -> PoseCheck:
        """Which poses can be evaluated, and why the others cannot.

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].

        Returns
        -------
        PoseCheck
            ``valid``, ``reason`` and ``sentences``, with the leading axes of the poses.

        Raises
        ------
        PoseError
            If the array is not one of poses.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> found = model.check([0.6, 0.0, -0.5])
        >>> print(found.reason, "-", found.sentences)
        reachable - the pose is out of reach: link 2 is 0.1385 m too short; choose a pose closer to the rails
        """
        checked = self._check(poses, "nan")
        return PoseCheck(
            codes=checked.codes.reshape(checked.batch),
            poses=checked.points.reshape((*checked.batch, 3)),
            parameters=self.robot.parameters,
        )

    def platform_jacobian(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Platform Jacobian D_p = dp/dx (equation 15).

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., 3, 3)
            Dimensionless; rows x, y, z of the base frame, one column for each carriage.

        Raises
        ------
        PoseError
            As `modes` does.
        """
        checked = self._check(poses, on_error)
        (D_p,) = self._evaluate(self._base(generated.platform_jacobian), checked)
        return D_p

    def inverse_kinematics(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Carriage positions on the branch that the robot file gives (equations 1 to 3).

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., 3)
            x_1, x_2, x_3 [m].

        Raises
        ------
        PoseError
            As `modes` does.
        """
        checked = self._check(poses, on_error)
        (x,) = self._evaluate(self._base(generated.inverse_kinematics), checked)
        return x

    def direct_kinematics(self, carriages: ArrayLike, assembly: int) -> Array:
        """Platform centre [m] for carriage positions of shape (3,) or (..., 3).

        Parameters
        ----------
        carriages : array_like, shape (3,) or (..., 3)
            x_1, x_2, x_3 [m].
        assembly : {1, -1}
            Assembly branch, see `assembly`.

        Returns
        -------
        ndarray, shape (3,) or (..., 3)
            Platform centres in the base frame [m]; the limits of the carriages are not looked at.

        Raises
        ------
        PoseError
            If the carriages are so far apart, or so close, that the links do not meet.
        """
        if not (isinstance(assembly, int | float | np.integer) and assembly in (1, -1)):
            raise PoseError(
                f"expected assembly 1 or -1, found {shown(assembly)}", "assembly", "choose a branch"
            )
        x, batch = as_points(carriages, "carriages", "give positions x_1, x_2, x_3 in metres")
        with np.errstate(all="ignore"):
            p: Array = generated.direct_kinematics(x, assembly, self.robot.parameters)
        bad = ~np.isfinite(p).all(axis=-1)
        if bad.any():
            index = int(np.argmax(bad))
            raise PoseError(
                "the three links do not meet",
                f"carriages {index}",
                "choose carriage positions that assemble",
                index,
            )
        return p.reshape((*batch, 3))

    def assembly(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Assembly branch of each pose: the sign of det D_l (equation 15).

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (...)
            1 or -1.

        Raises
        ------
        PoseError
            As `modes` does.
        """
        checked = self._check(poses, on_error)
        determinant, _ = self._evaluate(self._base(generated.jacobian_condition), checked)
        return np.sign(determinant)

    def _check(self, poses: ArrayLike, on_error: OnError) -> CheckedPoses:
        return check_poses(poses, self.robot.parameters, on_error, self.max_condition)

    def _base(self, function: Callable[..., Any]) -> Callable[[Array], Any]:
        """A function of the base model for this robot: effects leave the kinematics as they are."""
        return lambda p: function(p, self.robot.parameters)

    @staticmethod
    def _evaluate(function: Callable[[Array], Any], checked: CheckedPoses) -> tuple[Array, ...]:
        """Results of a function at the valid poses, chunk by chunk, in the shape of all poses."""
        gathered = Gathered(checked)
        for where, p in checked.parts(CHUNK):
            found = function(p)
            columns = found if isinstance(found, tuple) else (found,)
            gathered.put(where, {str(i): column for i, column in enumerate(columns)})
        return tuple(gathered.arrays.values())
