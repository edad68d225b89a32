"""Kinematics of one robot at poses: validity, joint positions, assembly branches, the platform Jacobian.

Effects do not change the kinematics, so the generated base model serves every robot.  The notes of `Kinematics` on
poses, ``on_error`` and errors apply to every method.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.errors import PkmodesError, PoseError, shown
from pkmodes.dataset.fields import condition_number
from pkmodes.measured.pose_table import by_name, poses_by_name
from pkmodes.mechanism.generated import Generated
from pkmodes.mechanism.poses import (
    CHUNK,
    MAX_CONDITION,
    CheckedPoses,
    OnError,
    as_points,
    check_poses,
    largest_condition,
)
from pkmodes.robot.robot import Robot
from pkmodes.robot.usable import reasons_of
from pkmodes.solve.field_arrays import FieldArrays
from pkmodes.solve.results import PoseCheck

Array = NDArray[np.float64]


class Kinematics:
    """The part of a model that does not need dynamics; its methods are those of `pkmodes.Model`.

    Parameters
    ----------
    robot : Robot
    max_condition : float
        Poses at which the condition number of the mechanism is larger are rejected as singular.

    Attributes
    ----------
    robot : Robot
    mechanism : Mechanism
        Description of the mechanism.

    Notes
    -----
    ``poses`` is one pose of shape (d,) or an array of shape (..., d), in SI units, with the mechanism's pose
    components (`mechanism.pose`); results have the same leading axes.  With ``on_error="raise"`` the first pose that
    cannot be evaluated raises a `PoseError`; with ``"nan"`` it gives NaN.  An array that does not hold poses always
    raises a `PoseError`.
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        if not isinstance(robot, Robot):
            raise PkmodesError(f"expected a Robot, found {shown(robot)}", "Model", "use pkmodes.load(path)")
        self.max_condition = largest_condition(max_condition)
        self.robot = robot
        self.mechanism = robot.mechanism
        self._generated = Generated(self.mechanism.model, robot.parameters)

    @property
    def reasons(self) -> dict[str, str]:
        """Codes that ``reason`` may have for a pose that cannot be evaluated, with their meanings."""
        return reasons_of(self.robot)

    def check(self, poses: ArrayLike) -> PoseCheck:
        """Check which poses can be evaluated, and why the others cannot.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.

        Returns
        -------
        PoseCheck
            ``valid``, ``reason`` and ``sentences``, with the leading axes of the poses.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> check = model.check([0.6, 0.0, -0.5])
        >>> print(check.reason, "-", check.sentences)
        reachable - the pose is out of reach: link 2 is 0.1385 m too short; choose a pose closer to the rails
        """
        checked = self.checked(poses, "nan")
        return PoseCheck(
            codes=checked.codes.reshape(checked.batch),
            known=checked.known,
            poses=checked.points.reshape((*checked.batch, -1)),
            robot=self.robot,
        )

    def platform_jacobian(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Compute the platform Jacobian D_p = dp/dq (equation 15).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        ndarray, shape (..., d, k)
            One row per pose component, one column per independent coordinate.
        """
        (D_p,) = self._at(poses, on_error, "platform_jacobian")
        return D_p

    def condition(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Compute the condition number of the platform Jacobian D_p: its largest singular value over its smallest.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        ndarray, shape (...)
            At least 1; 1 where the platform moves equally far in every direction.
        """
        function = self._generated.platform_jacobian
        (condition,) = self.evaluated(lambda p: condition_number(function(p)), self.checked(poses, on_error))
        return condition

    def inverse_kinematics(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Compute the independent coordinates on the branch given in the robot file (equations 1 to 3).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        ndarray, shape (..., k)
            In SI units, in the order of ``mechanism.independent``.
        """
        (q,) = self._at(poses, on_error, "inverse_kinematics")
        return q

    def direct_kinematics(self, positions: ArrayLike, assembly: int) -> Array:
        """Compute the pose from the independent coordinates.

        Parameters
        ----------
        positions : array_like, shape (k,) or (..., k)
            In the order of ``mechanism.independent``, in SI units.
        assembly : {1, -1}
            Assembly branch, see `assembly`.

        Returns
        -------
        ndarray, shape (d,) or (..., d)
            Poses; limits are not checked.

        Raises
        ------
        PoseError
            If the links do not meet.
        PkmodesError
            If the mechanism has no closed-form direct kinematics.
        """
        function = self._function("direct_kinematics")
        if not (isinstance(assembly, int | float | np.integer) and assembly in (1, -1)):
            raise PoseError(
                f"expected assembly 1 or -1, found {shown(assembly)}", "assembly", "choose a branch"
            )
        what = self.mechanism.independent_are
        size, names = len(self.mechanism.independent), ", ".join(self.mechanism.independent)
        units = {q.name: q.unit for q in self.mechanism.coordinates}
        given = by_name(positions, {name: units[name] for name in self.mechanism.independent}, what)
        q, batch = as_points(given, what, size, lambda: f"give {names} in SI units")
        with np.errstate(all="ignore"):
            p: Array = function(q, assembly)
        bad = ~np.isfinite(p).all(axis=-1)
        if bad.any():
            index = int(np.argmax(bad))
            raise PoseError("the links do not meet", f"{what} {index}", f"choose {what} that assemble", index)
        return p.reshape((*batch, -1))

    @property
    def has_assemblies(self) -> bool:
        """Whether the mechanism has several assembly branches: see `assembly`."""
        return self._generated.has("direct_kinematics")

    def assembly(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Compute the assembly branch of each pose: the sign of det D_l (equation 15).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        ndarray, shape (...)
            1 or -1.

        Raises
        ------
        PkmodesError
            If the mechanism has only one assembly branch.
        """
        self._function("direct_kinematics")
        determinant, _ = self._at(poses, on_error, "jacobian_condition")
        return np.sign(determinant)

    def checked(self, poses: ArrayLike, on_error: OnError) -> CheckedPoses:
        """Check poses, and refuse those that cannot be evaluated with ``on_error="raise"``."""
        points = poses_by_name(poses, self.mechanism)
        return check_poses(points, self.mechanism, self.robot.parameters, on_error, self.max_condition)

    def _function(self, name: str) -> Callable[..., Any]:
        """Return a function of the base model that not every mechanism has."""
        if not self._generated.has(name):
            what = (
                f"the mechanism {self.mechanism.name} has no {name.replace('_', ' ')} with assembly branches"
            )
            raise PkmodesError(what, self.robot.source, "start from poses: Model.inverse_kinematics")
        return getattr(self._generated, name)  # type: ignore[no-any-return]

    def _at(self, poses: ArrayLike, on_error: OnError, name: str) -> tuple[Array, ...]:
        """Evaluate a function of the base model and return its results with the poses' leading axes."""
        return self.evaluated(getattr(self._generated, name), self.checked(poses, on_error))

    @staticmethod
    def evaluated(function: Callable[[Array], Any], checked: CheckedPoses) -> tuple[Array, ...]:
        """Evaluate a function at the valid poses, chunk by chunk; results have the leading axes of all poses."""
        fields = FieldArrays(checked.batch, blank=bool(checked.codes.any()))
        for where, p in checked.parts(CHUNK):
            values = function(p)
            columns = values if isinstance(values, tuple) else (values,)
            fields.put(where, {str(i): column for i, column in enumerate(columns)})
        return tuple(fields.finish().values())
