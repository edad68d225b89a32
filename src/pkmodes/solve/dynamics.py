"""Dynamics of one robot at poses: modes, frequencies, matrices and statics.

Poses are checked, a solver evaluates them, and the results get the caller's axes.  There is no physics here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.drives import FREE, checked_drives
from pkmodes.dataset.fields import FIELDS
from pkmodes.mechanism.poses import CheckedPoses, OnError
from pkmodes.robot.robot import Robot
from pkmodes.solve.backends import AUTO, checked_threads, chosen, solver_of
from pkmodes.solve.batch import run
from pkmodes.solve.field_arrays import Fields, Out, chosen_fields
from pkmodes.solve.kinematics import Kinematics
from pkmodes.solve.mode_fields import ModeFields
from pkmodes.solve.plans import Later, Plan
from pkmodes.solve.results import Modes, Statics
from pkmodes.solve.solver import Solver
from pkmodes.system.dissipation import Dissipation
from pkmodes.system.evaluation import Evaluation, ExtendedSystem, evaluation, matrices
from pkmodes.system.motors import solved_system

Array = NDArray[np.float64]


class Dynamics:
    """The part of a model that computes vibrations and static equilibria; its methods are those of `pkmodes.Model`.

    Parameters
    ----------
    kinematics : Kinematics
        Of the robot.

    Attributes
    ----------
    robot : Robot
    kinematics : Kinematics
    system : Evaluation
    dissipation : Dissipation
    coordinates : tuple of str
        Names of the generalised coordinates (docs/model.md).
    """

    def __init__(self, kinematics: Kinematics) -> None:
        self.kinematics, self.robot = kinematics, kinematics.robot
        self.system = evaluation(self.robot)
        self.dissipation = Dissipation(self.robot, self.system)
        self.coordinates = self.system.coordinates
        self._solvers: dict[tuple[str, str], Solver] = {}
        self._solved: dict[str, Evaluation] = {FREE: self.system}
        self._fields_of: dict[tuple[object, ...], ModeFields] = {}
        self._plans: dict[tuple[object, ...], Plan] = {}

    @classmethod
    def of(cls, robot: Robot, max_condition: float) -> Dynamics:
        """Return the dynamics of a robot, with its kinematics."""
        return cls(Kinematics(robot, max_condition))

    def modes(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        fields: Fields = None,
        drives: str = FREE,
        out: Out = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Modes:
        """Compute natural frequencies, mode shapes and matrices.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN, ``valid`` False, and a ``reason``.
        fields : sequence of str, optional
            Which of ``Modes.FIELDS`` to compute and keep, such as ``("frequencies", "platform_shapes")``; by default
            all, or the fields in `out`.  The values of a field do not depend on the other fields requested.
        drives : {"free", "held"}
            What the motors do: they turn freely, or position loops far stiffer than the machine hold them
            (docs/model.md).
        out : mapping of str to ndarray, optional
            Arrays to fill in place, by field, with the shapes given in `Modes`; they become the fields.
        backend : {"auto", "numpy", "compiled"}
            What evaluates the modes: by default the compiled library if there is one, unless the environment variable
            ``PKMODES_BACKEND`` says otherwise.  ``Modes.backend`` tells which one ran.
        threads : int, optional
            Threads of the compiled library, by default one per core; the results do not depend on it.

        Returns
        -------
        Modes
            With the leading axes of the poses.

        Raises
        ------
        PkmodesError
            If a field is unknown, or an array in `out` has the wrong shape or type or is read-only. Also if
            `backend` is "compiled" and there is no compiled library, or `drives` is neither word.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> modes = model.modes([[0.6, 0.0, -0.245], [0.1, 0.0, -0.245]], "nan", fields=["frequencies"])
        >>> modes.frequencies[:, 3].round(3)
        array([55.559,    nan])
        >>> modes.reason
        array(['', 'limits'], dtype='<U9')
        """
        asked = None
        if fields is not None or out is not None:
            asked = chosen_fields(fields, out, Modes.fields_of(self.robot.mechanism))
        number = checked_threads(threads)
        plan = self._plan(asked, out, backend, drives)
        checked, arrays = self._run(plan.fields, poses, on_error, out, number)
        for name, same in plan.shared.items():
            arrays[name] = arrays[same]
        later = None
        if plan.later:
            later = Later(plan.later, self.robot, self.kinematics.max_condition, checked, number)
        return Modes(
            codes=checked.codes.reshape(checked.batch),
            known=checked.known,
            arrays=arrays,
            poses=checked.points.reshape((*checked.batch, -1)),
            coordinates=self.coordinates,
            rigid_modes=plan.rigid_modes,
            robot=self.robot,
            backend=plan.backend,
            drives=drives,
            _later=later,
        )

    def frequencies(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        drives: str = FREE,
        out: Array | None = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Array:
        """Compute only the natural frequencies; they equal those of `modes` to the last digit.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`; `check` says why a pose gives NaN.
        drives : {"free", "held"}
            As for `modes`.
        out : ndarray of float, shape (..., m), optional
            Filled in place and returned.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.
        threads : int, optional
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., m)
            In Hz: sqrt(abs(lambda)) / (2 pi) with the sign of lambda, the rigid-body modes first.
        """
        given = None if out is None else {"frequencies": out}
        asked: tuple[str, ...] = ("frequencies",)
        if given:
            asked = chosen_fields(asked, given, Modes.fields_of(self.robot.mechanism))
        number = checked_threads(threads)
        plan = self._plan(asked, given, backend, drives)
        _, arrays = self._run(plan.fields, poses, on_error, given, number)
        return arrays["frequencies"]

    def fields_at(
        self,
        poses: ArrayLike,
        on_error: OnError,
        names: Sequence[str],
        backend: str,
        *,
        drives: str = FREE,
        out: Out = None,
        threads: int = 1,
        given: Mapping[str, Any] | None = None,
    ) -> tuple[CheckedPoses, dict[str, Array]]:
        """Evaluate fields of `pkmodes.dataset.fields.FIELDS`.

        Parameters
        ----------
        poses, on_error, drives, out
            As for `modes`.
        names : sequence of str
        backend : str
            As for `modes`.
        threads : int
        given : mapping of str to object, optional
            Quantities that fields need and a robot does not have.

        Returns
        -------
        CheckedPoses
            With the code of each pose.
        dict of str to ndarray
            By field, with the leading axes of the poses.
        """
        fields = self._fields(names, self.solver(backend, drives), drives, given)
        return self._run(fields, poses, on_error, out, threads)

    def _run(
        self, fields: ModeFields, poses: ArrayLike, on_error: OnError, out: Out, threads: int
    ) -> tuple[CheckedPoses, dict[str, Array]]:
        """Evaluate fields at poses."""
        return run(fields.job, self.robot, self.kinematics.max_condition, poses, on_error, out, threads)

    def _fields(
        self, names: Sequence[str], solver: Solver, drives: str, given: Mapping[str, Any] | None = None
    ) -> ModeFields:
        """Return how a solver evaluates fields; kept unless something is given."""
        key = (solver, *names)
        fields = None if given else self._fields_of.get(key)
        if fields is None:
            known = {"dissipation": self.dissipation, **(given or {})}
            fields = ModeFields(solver, self.system, self.solved(drives), self.robot.source, names, known)
            if not given:
                self._fields_of[key] = fields
        return fields

    def _plan(self, asked: tuple[str, ...] | None, out: Out, backend: str, drives: str) -> Plan:
        """Return what a call does; kept, so that a call of a pose takes microseconds.

        Parameters
        ----------
        asked : tuple of str, optional
            Fields, in their order; None for all, of which some are evaluated when they are read.
        """
        apart = tuple(name for name in asked or () if out and name in out and FIELDS[name].same_as)
        key = asked, apart, chosen(backend), drives, len(FIELDS)
        try:
            return self._plans[key]
        except (KeyError, TypeError):  # a new one, or drives that are no word
            solver = self.solver(backend, drives)
        names = Modes.fields_of(self.robot.mechanism) if asked is None else asked
        # Two names of the same values share one array unless the caller passes a second one.
        shared = {
            name: FIELDS[name].same_as
            for name in names
            if FIELDS[name].same_as in names and name not in apart
        }
        later = [
            name for name in names if asked is None and FIELDS[name].on_demand and name not in solver.at_hand
        ]
        at_once = [name for name in names if name not in shared and name not in later]
        plan = self._plans[key] = Plan(
            fields=self._fields(at_once, solver, drives),
            shared=shared,
            later={name: self._fields([name], solver, drives) for name in later},
            rigid_modes=self.solved(drives).rigid_modes,
            backend=solver.name,
        )
        return plan

    def solver(self, backend: str, drives: str = FREE) -> Solver:
        """Return the solver that a back end has for the robot."""
        key = chosen(backend), checked_drives(drives)
        if key not in self._solvers:
            # Without effects, a library has the digits of NumPy in M and K; with them it rounds K in another order.
            same = drives != FREE and not isinstance(self.system, ExtendedSystem)
            free = self.solver(key[0], FREE) if same else None
            solver = solver_of(self.solved(drives), self.kinematics.max_condition, key[0], free)
            self._solvers[key] = solver
        return self._solvers[key]

    def solved(self, drives: str) -> Evaluation:
        """Return the system that is solved for the robot, with free or held motors."""
        if drives not in self._solved:
            self._solved[drives] = solved_system(self.system, drives)
        return self._solved[drives]

    def matrices(self, poses: ArrayLike, on_error: OnError = "raise") -> tuple[Array, Array]:
        """Compute the mass and stiffness matrices (equations 33 and 48).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        M : ndarray, shape (..., n, n)
            In SI units, in the order of `coordinates`; NaN where a pose could not be evaluated.
        K : ndarray, shape (..., n, n)
            Likewise.
        """
        checked = self.kinematics.checked(poses, on_error)
        M, K = self.kinematics.evaluated(lambda p: matrices(self.system, p), checked)
        return M, K

    def statics(self, poses: ArrayLike, on_error: OnError = "raise") -> Statics:
        """Compute the torques and rotations that hold the pose (equation 44).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        Statics
            With the leading axes of the poses.
        """
        checked = self.kinematics.checked(poses, on_error)
        torques, rotations = self.kinematics.evaluated(self.system.statics, checked)
        return Statics(checked.codes.reshape(checked.batch), checked.known, torques, rotations)
