"""The evaluator of one robot: poses in, modes, matrices and statics out.

It checks poses, calls the generated model chunk by chunk, solves, and puts the results in the caller's shape;
it holds no physics of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.eigen import natural_frequencies
from pkmodes.errors import PkmodesError, PoseError, shown
from pkmodes.evaluation import evaluation, solve
from pkmodes.poses import CHUNK, MAX_CONDITION, CheckedPoses, OnError, as_points, check_poses
from pkmodes.results import Modes, Statics
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta as generated

if TYPE_CHECKING:
    from pkmodes.sensitivity.sensitivities import Sensitivities

Array = NDArray[np.float64]


class Model:
    """Evaluator of one robot.

    Every method takes one pose of shape (3,) or an array of shape (..., 3), platform centres in the base
    frame in metres, and returns arrays with the same leading axes.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`; `pkmodes.load` makes the model of a robot file directly.
    max_condition : float
        Poses where the condition number of D_l is larger are refused as singular.

    Attributes
    ----------
    robot : Robot
    coordinates : tuple of str
        Names of the generalised coordinates (docs/model.md).
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        if not isinstance(robot, Robot):
            raise PkmodesError(f"expected a Robot, found {shown(robot)}", "Model", "use pkmodes.load(path)")
        self.robot = robot
        self._evaluation = evaluation(robot.parameters, robot.effects)
        self.coordinates = self._evaluation.coordinates
        self.max_condition = max_condition

    def __repr__(self) -> str:
        return f"Model({self.robot.name!r}, {self.robot.mechanism}, {len(self.coordinates)} coordinates)"

    def modes(self, poses: ArrayLike, on_error: OnError = "raise") -> Modes:
        """Natural frequencies, shapes and matrices.

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres [m].
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN and ``valid`` False.

        Returns
        -------
        Modes
            With the leading axes of the poses.

        Raises
        ------
        PoseError
            If the array is not one of poses; with ``on_error="raise"``, for the first bad pose.
        """
        checked = self._check(poses, on_error)
        parts = [self._solve(p) for p in self._chunks(checked)]
        M, K, eigenvalues, shapes, x, platform = (
            np.concatenate(column) for column in zip(*parts, strict=True)
        )
        return Modes(
            poses=checked.points.reshape((*checked.batch, 3)),
            coordinates=self.coordinates,
            frequencies=checked.scatter(natural_frequencies(eigenvalues)),
            shapes=checked.scatter(shapes),
            platform_shapes=checked.scatter(platform),
            carriage_positions=checked.scatter(x),
            mass_matrix=checked.scatter(M),
            stiffness_matrix=checked.scatter(K),
            rigid_modes=self._evaluation.rigid_modes,
            valid=checked.valid.reshape(checked.batch),
        )

    def matrices(self, poses: ArrayLike, on_error: OnError = "raise") -> tuple[Array, Array]:
        """Mass and stiffness matrices (equations 33 and 48).

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        M, K : ndarray, shape (..., n, n)
            In SI units and in the order of `coordinates`; NaN where a pose could not be evaluated.

        Raises
        ------
        PoseError
            As `modes` does.
        """
        checked = self._check(poses, on_error)
        M, K = self._evaluate(self._evaluation.matrices, checked)
        return checked.scatter(M), checked.scatter(K)

    def statics(self, poses: ArrayLike, on_error: OnError = "raise") -> Statics:
        """Torques and pulley rotations that hold the pose (equation 44).

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        Statics
            Torques [N m] and rotations [rad].

        Raises
        ------
        PoseError
            As `modes` does.
        """
        checked = self._check(poses, on_error)
        torques, rotations = self._evaluate(self._evaluation.statics, checked)
        return Statics(
            checked.scatter(torques), checked.scatter(rotations), checked.valid.reshape(checked.batch)
        )

    def sensitivities(
        self,
        poses: ArrayLike,
        parameters: Sequence[str] | None = None,
        *,
        close: float = 1e-6,
        on_error: OnError = "raise",
    ) -> Sensitivities:
        """Exact derivatives of matrices and modes by parameters, at fixed platform poses.

        Parameters
        ----------
        poses : array_like, shape (3,) or (..., 3)
            Platform centres in the base frame [m].
        parameters : sequence of str, optional
            Parameter paths (docs/sensitivities.md); by default all that the robot has and every effect's.
        close : float
            Modes whose eigenvalues differ by less than this fraction are one group.
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        Sensitivities
            With the leading axes of the poses.

        Raises
        ------
        PkmodesError
            If a path is unknown, with the nearest one.
        PoseError
            As `modes` does.
        """
        from pkmodes.sensitivity.sensitivities import sensitivities

        checked = self._check(poses, on_error)
        return sensitivities(self.robot, checked, parameters, close)

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
        return checked.scatter(D_p)

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
        return checked.scatter(x)

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
        return checked.scatter(np.sign(determinant))

    def _check(self, poses: ArrayLike, on_error: OnError) -> CheckedPoses:
        return check_poses(poses, self.robot.parameters, on_error, self.max_condition)

    def _base(self, function: Callable[..., Any]) -> Callable[[Array], Any]:
        """A function of the base model for this robot: effects leave the kinematics as they are."""
        return lambda p: function(p, self.robot.parameters)

    def _evaluate(self, function: Callable[[Array], Any], checked: CheckedPoses) -> tuple[Array, ...]:
        """Results of a function at the valid poses, chunk by chunk."""
        results = [function(p) for p in self._chunks(checked)]
        columns = zip(*results, strict=True) if isinstance(results[0], tuple) else [results]
        return tuple(np.concatenate(column) for column in columns)

    @staticmethod
    def _chunks(checked: CheckedPoses) -> list[Array]:
        """The valid poses in parts; one empty part when there are none, which has the right shapes."""
        points = checked.points[checked.valid]
        return [points[start : start + CHUNK] for start in range(0, max(len(points), 1), CHUNK)]

    def _solve(self, p: Array) -> tuple[Array, ...]:
        """Matrices, eigenvalues, shapes, carriages and platform motion at some poses."""
        M, K, eigenvalues, shapes = solve(self._evaluation, p, self.robot.source)
        platform = shapes @ np.swapaxes(self._evaluation.platform_motion(p), -1, -2)
        return M, K, eigenvalues, shapes, generated.inverse_kinematics(p, self.robot.parameters), platform
