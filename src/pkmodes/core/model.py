"""The evaluator of one robot: poses in, modes, frequencies, matrices, statics and kinematics out.

Poses are checked, a solver evaluates them, and the results get the caller's axes.  There is no physics here; the way
of a pose through the files of `pkmodes.core` is in its README.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.drives import FREE, checked_drives
from pkmodes.core.base.errors import PkmodesError, PoseError, shown
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.length import characteristic_length, lengths_of
from pkmodes.core.mechanism.poses import (
    CHUNK,
    MAX_CONDITION,
    CheckedPoses,
    OnError,
    as_points,
    check_max_condition,
)
from pkmodes.core.robot.pose_table import ordered_by_name
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import meanings_of_reason_codes
from pkmodes.core.solve.backends import AUTO, checked_threads, choose_backend, solver_of
from pkmodes.core.solve.batch import run_job
from pkmodes.core.solve.field_arrays import FieldArrays, FieldNames, OutArrays, chosen_fields
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.solve.gravity import gravitational_stiffness
from pkmodes.core.solve.mode_fields import DeferredFields, FieldPlan, ModeFields
from pkmodes.core.solve.results import Modes, PoseCheck, Statics
from pkmodes.core.solve.solver import Solver
from pkmodes.core.system.dissipation import Dissipation
from pkmodes.core.system.evaluation import Evaluation, evaluation
from pkmodes.core.system.motors import extended_system, solved_system

Array = NDArray[np.float64]


class Model:
    """Evaluator of one robot.

    Every method takes one pose of shape (d,) or an array of shape (..., d), in SI units and with the mechanism's
    pose components, and returns arrays with the same leading axes.  A table, as of pandas, is taken by the names of
    its columns, which may have units (``x [mm]``).  With ``on_error="raise"`` the first pose that cannot be evaluated
    raises a `PoseError`; with ``"nan"`` it gives NaN.  An array that does not hold poses always raises a
    `PoseError`.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`; `pkmodes.load` creates the model of a robot file directly.
    max_condition : float
        Poses at which the condition number of the mechanism is larger are rejected as singular.

    Attributes
    ----------
    robot : Robot
    mechanism : Mechanism
        Description of the mechanism: pose components, coordinates, drives.
    max_condition : float
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        if not isinstance(robot, Robot):
            raise PkmodesError(f"expected a Robot, found {shown(robot)}", "Model", "use pkmodes.load(path)")
        self.max_condition = check_max_condition(max_condition)
        self.robot, self.mechanism = robot, robot.mechanism
        # Effects do not change the kinematics: the generated base model serves every robot.
        self._generated = Generated(self.mechanism.model, robot.parameters)
        self._solvers: dict[tuple[str, str], Solver] = {}
        self._solved: dict[str, Evaluation] = {}
        self._fields_of: dict[tuple[object, ...], ModeFields] = {}
        self._plans: dict[tuple[object, ...], FieldPlan] = {}
        #: Results that applications keep between calls, each under a key of its own.
        self.kept: dict[object, Any] = {}

    def __repr__(self) -> str:
        return f"Model({self.robot.name!r}, {self.robot.mechanism_name}, {len(self.coordinates)} coordinates)"

    def __reduce__(self) -> tuple[Any, ...]:
        # The evaluation may hold modules, which cannot be pickled; it is rebuilt from the robot.
        return type(self), (self.robot, self.max_condition)

    def with_values(self, values: Mapping[str, Any]) -> Self:
        """Return the evaluator of the robot with other values.

        Parameters
        ----------
        values : mapping of str to value
            By dotted path, as for `pkmodes.Robot.with_values`.

        Returns
        -------
        Model
            With the same largest condition number.

        Raises
        ------
        PkmodesError
            As for `pkmodes.Robot.with_values`.
        """
        return type(self)(self.robot.with_values(values), self.max_condition)

    @cached_property
    def system(self) -> Evaluation:
        """M, K and statics of the robot, motors free."""
        return evaluation(self.robot)

    @cached_property
    def characteristic_length(self) -> float:
        """Length that makes the platform's rotations comparable with displacements [m] (docs/model.md).

        1 where the platform does not turn.
        """
        return characteristic_length(self.mechanism, self.robot.parameters)

    @cached_property
    def dissipation(self) -> Dissipation:
        """What damps the robot."""
        return Dissipation(self.robot, self.system)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the generalised coordinates (docs/model.md)."""
        return self.system.coordinates

    def modes(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        fields: FieldNames = None,
        drives: str | None = None,
        out: OutArrays = None,
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
        drives : {"free", "held"}, optional
            What the motors do: they turn freely, or position loops far stiffer than the machine hold them
            (docs/model.md); by default as the robot file says, else "free".
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
        requested = None
        if fields is not None or out is not None:
            requested = chosen_fields(fields, out, Modes.fields_of(self.robot.mechanism))
        number = checked_threads(threads)
        drives = self.robot.drives if drives is None else drives
        plan = self._plan(requested, out, backend, drives)
        checked, arrays = self._run(plan.fields, poses, on_error, out, number)
        for name, same in plan.shared.items():
            arrays[name] = arrays[same]
        later = None
        if plan.deferred:
            later = DeferredFields(plan, self.robot, self.max_condition, checked, number)
        return Modes(
            codes=checked.codes.reshape(checked.batch),
            known=checked.reasons,
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
        drives: str | None = None,
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
        out_arrays = None if out is None else {"frequencies": out}
        requested: tuple[str, ...] = ("frequencies",)
        if out_arrays:
            requested = chosen_fields(requested, out_arrays, Modes.fields_of(self.robot.mechanism))
        number = checked_threads(threads)
        plan = self._plan(requested, out_arrays, backend, self.robot.drives if drives is None else drives)
        _, arrays = self._run(plan.fields, poses, on_error, out_arrays, number)
        return arrays["frequencies"]

    def matrices(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        out: OutArrays = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> tuple[Array, Array]:
        """Compute the mass and stiffness matrices (equations 33 and 48), motors free.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.
        out : mapping of str to ndarray, optional
            Arrays to fill in place and return: ``"mass_matrix"``, ``"stiffness_matrix"``, or both.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.
        threads : int, optional
            As for `modes`.

        Returns
        -------
        M : ndarray, shape (..., n, n)
            In SI units, in the order of `coordinates`; NaN where a pose could not be evaluated.
        K : ndarray, shape (..., n, n)
            Likewise.

        Raises
        ------
        PkmodesError
            As for `modes`.
        """
        names = "mass_matrix", "stiffness_matrix"
        _, arrays = self._evaluate_into(out, names, poses, on_error, backend, threads)
        return arrays["mass_matrix"], arrays["stiffness_matrix"]

    def gravitational_stiffness(
        self, poses: ArrayLike, on_error: OnError = "raise", *, backend: str = AUTO
    ) -> Array:
        """Compute the part of the stiffness matrix that is due to gravity (equation 48), motors free.

        The elastic part is ``K - K_g``: belts, reducers, springs to ground and released joints.  Gravity is often
        ten thousand times less: K alone does not have it to many digits.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., n, n)
            K_g in SI units, in the order of `coordinates`.

        Raises
        ------
        PkmodesError
            As for `modes`.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/clavel-delta.toml")
        >>> float(model.gravitational_stiffness([0.03, 0.02, -0.45]).max().round(2))  # N m/rad
        0.29
        """
        solver, system = self.solver(backend), extended_system(self.system)
        checked = self.checked(poses, on_error)
        (values,) = self.evaluated(lambda p: gravitational_stiffness(solver, system, p), checked)
        return values

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
        checked, arrays = self._evaluate_into(None, ("static_torque", "static_rotation"), poses, on_error)
        poses = checked.points.reshape((*checked.batch, -1))
        codes = checked.codes.reshape(checked.batch)
        torques, rotations = arrays["static_torque"], arrays["static_rotation"]
        return Statics(codes, checked.reasons, poses, torques, rotations, self.robot)

    @property
    def reasons(self) -> dict[str, str]:
        """Codes that ``reason`` may have for a pose that cannot be evaluated, with their meanings."""
        return meanings_of_reason_codes(self.mechanism, self.robot.usable)

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
            known=checked.reasons,
            poses=checked.points.reshape((*checked.batch, -1)),
            robot=self.robot,
        )

    def platform_jacobian(
        self, poses: ArrayLike, on_error: OnError = "raise", *, out: Array | None = None
    ) -> Array:
        """Compute the platform Jacobian D_p = dp/dq (equation 15); rotations are small ones about base axes.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.
        out : ndarray of float, optional
            Of the shape of the result: filled in place and returned.

        Returns
        -------
        ndarray, shape (..., d, k)
            One row per pose component, one column per independent coordinate.
        """
        return self._field("platform_jacobian", poses, on_error, out)

    def condition(self, poses: ArrayLike, on_error: OnError = "raise", *, out: Array | None = None) -> Array:
        """Compute the condition number of the platform Jacobian D_p: its largest singular value over its smallest.

        Rotations are multiplied by the characteristic length of the platform (docs/model.md).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.
        out : ndarray of float, optional
            Of the shape of the result: filled in place and returned.

        Returns
        -------
        ndarray, shape (...)
            At least 1; 1 where the platform moves equally far in every direction.
        """
        return self._field("condition", poses, on_error, out)

    def inverse_kinematics(
        self, poses: ArrayLike, on_error: OnError = "raise", *, out: Array | None = None
    ) -> Array:
        """Compute the independent coordinates on the branch given in the robot file (equations 1 to 3).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.
        out : ndarray of float, optional
            Of the shape of the result: filled in place and returned.

        Returns
        -------
        ndarray, shape (..., k)
            In SI units, in the order of ``mechanism.independent``.
        """
        return self._field("joint_positions", poses, on_error, out)

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
        kind = self.mechanism.independent_are
        size, names = len(self.mechanism.independent), ", ".join(self.mechanism.independent)
        units = {q.name: q.unit for q in self.mechanism.coordinates}
        ordered = ordered_by_name(positions, {name: units[name] for name in self.mechanism.independent}, kind)
        q, batch = as_points(ordered, kind, size, lambda: f"give {names} in SI units")
        with np.errstate(all="ignore"):
            p: Array = function(q, assembly)
        invalid = ~np.isfinite(p).all(axis=-1)
        if invalid.any():
            index = int(np.argmax(invalid))
            raise PoseError("the links do not meet", f"{kind} {index}", f"choose {kind} that assemble", index)
        return p.reshape((*batch, -1))

    @property
    def has_assemblies(self) -> bool:
        """Whether the mechanism has several assembly branches: see `assembly`."""
        return self._generated.has("direct_kinematics") or bool(self.mechanism.rotations)

    def assembly(self, poses: ArrayLike, on_error: OnError = "raise") -> Array:
        """Compute the assembly branch of each pose: the sign of det D_l (equation 15).

        Where the platform turns, it is the sign of det D_p.

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
        if self.mechanism.rotations:
            D_p = self.platform_jacobian(poses, on_error)
            with np.errstate(invalid="ignore"):
                return np.asarray(np.sign(np.linalg.det(D_p)))
        self._function("direct_kinematics")
        checked = self.checked(poses, on_error)
        determinant, _ = self.evaluated(self._generated.jacobian_condition, checked)
        return np.sign(determinant)

    # Shared by the methods above and the applications.

    def fields_at(
        self,
        poses: ArrayLike,
        on_error: OnError,
        names: Sequence[str],
        backend: str,
        *,
        drives: str = FREE,
        out: OutArrays = None,
        threads: int = 1,
        given: Mapping[str, Any] | None = None,
    ) -> tuple[CheckedPoses, dict[str, Array]]:
        """Evaluate fields of the table in ``pkmodes.core.solve.fields``.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`.
        names : sequence of str
            Of the fields.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.
        drives : {"free", "held"}
            As for `modes`.
        out : mapping of str to ndarray, optional
            As for `modes`.
        threads : int
            Of the compiled library.
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

    def _evaluate_into(
        self,
        out: OutArrays,
        names: tuple[str, ...],
        poses: ArrayLike,
        on_error: OnError,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> tuple[CheckedPoses, dict[str, Array]]:
        """Evaluate fields with free motors, into arrays of the caller if there are any."""
        if out is not None:
            chosen_fields(names, out, names)
        number = checked_threads(threads)
        return self.fields_at(poses, on_error, names, backend, out=out, threads=number)

    def _field(self, name: str, poses: ArrayLike, on_error: OnError, out: Array | None) -> Array:
        """Evaluate one field with free motors."""
        _, arrays = self._evaluate_into(None if out is None else {name: out}, (name,), poses, on_error)
        return arrays[name]

    def _run(
        self, fields: ModeFields, poses: ArrayLike, on_error: OnError, out: OutArrays, threads: int
    ) -> tuple[CheckedPoses, dict[str, Array]]:
        """Evaluate fields at poses."""
        return run_job(fields.job, self.robot, self.max_condition, poses, on_error, out, threads)

    def _fields(
        self, names: Sequence[str], solver: Solver, drives: str, extra: Mapping[str, Any] | None = None
    ) -> ModeFields:
        """Return how a solver evaluates fields; kept unless extra quantities are given."""
        key = (solver, *names)
        fields = None if extra else self._fields_of.get(key)
        if fields is None:
            lengths = lengths_of(self.mechanism, self.robot.parameters)
            quantities = {"dissipation": self.dissipation, "lengths": lengths, **(extra or {})}
            fields = ModeFields(
                solver, self.system, self.solved(drives), self.robot.source, names, quantities
            )
            if not extra:
                self._fields_of[key] = fields
        return fields

    def _plan(
        self, requested: tuple[str, ...] | None, out: OutArrays, backend: str, drives: str
    ) -> FieldPlan:
        """Return what a call does; kept, so that a call for one pose takes microseconds.

        - requested: fields, in their order; None for all, of which some are evaluated when they are read
        """
        separate = tuple(name for name in requested or () if out and name in out and FIELDS[name].same_as)
        key = requested, separate, choose_backend(backend), drives, len(FIELDS)
        try:
            return self._plans[key]
        except (KeyError, TypeError):  # a new one, or drives that cannot be a key
            solver = self.solver(backend, drives)
        names = Modes.fields_of(self.robot.mechanism) if requested is None else requested
        # Two names of the same values share one array unless the caller passes a second one.
        shared = {
            name: FIELDS[name].same_as
            for name in names
            if FIELDS[name].same_as in names and name not in separate
        }
        later = [
            name
            for name in names
            if requested is None and FIELDS[name].on_demand and name not in solver.cheap_fields
        ]
        at_once = [name for name in names if name not in shared and name not in later]
        plan = self._plans[key] = FieldPlan(
            fields=self._fields(at_once, solver, drives),
            shared=shared,
            deferred={name: self._fields([name], solver, drives) for name in later},
            deferred_pairs={
                name: self._fields(sorted({name, FIELDS[name].read_with} & set(later)), solver, drives)
                for name in later
            },
            rigid_modes=self.solved(drives).rigid_modes,
            backend=solver.name,
        )
        return plan

    def solver(self, backend: str, drives: str = FREE) -> Solver:
        """Return the solver that a back end has for the robot.

        Parameters
        ----------
        backend, drives : str
            As for `modes`.

        Returns
        -------
        Solver
            Kept from call to call.
        """
        key = choose_backend(backend), checked_drives(drives)
        if key not in self._solvers:
            free = None if drives == FREE else self.solver(key[0], FREE)
            solver = solver_of(self.solved(drives), self.max_condition, key[0], free)
            self._solvers[key] = solver
        return self._solvers[key]

    def solved(self, drives: str) -> Evaluation:
        """Return the system that is solved for the robot.

        Parameters
        ----------
        drives : {"free", "held"}
            As for `modes`.

        Returns
        -------
        Evaluation
            ``system``, or the one in which the motors do not move.
        """
        if drives not in self._solved:
            self._solved[drives] = solved_system(self.system, drives)
        return self._solved[drives]

    def checked(self, poses: ArrayLike, on_error: OnError) -> CheckedPoses:
        """Check poses, and refuse those that cannot be evaluated with ``on_error="raise"``.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", the codes say which poses cannot be evaluated.

        Returns
        -------
        CheckedPoses
            The poses one after the other, with the code of each.
        """
        checked, _ = self._evaluate_into(None, (), poses, on_error)
        return checked

    def _function(self, name: str) -> Callable[..., Any]:
        """Return a function of the base model that not every mechanism has."""
        if not self._generated.has(name):
            problem = (
                f"the mechanism {self.mechanism.name} has no {name.replace('_', ' ')} with assembly branches"
            )
            raise PkmodesError(problem, self.robot.source, "start from poses: Model.inverse_kinematics")
        return getattr(self._generated, name)  # type: ignore[no-any-return]

    @staticmethod
    def evaluated(function: Callable[[Array], Any], checked: CheckedPoses) -> tuple[Array, ...]:
        """Evaluate a function at the valid poses, chunk by chunk; results have the leading axes of all poses."""
        fields = FieldArrays(checked.batch, filled_with_nan=bool(checked.codes.any()))
        for indices, p in checked.parts(CHUNK):
            values = function(p)
            columns = values if isinstance(values, tuple) else (values,)
            fields.put(indices, {str(i): column for i, column in enumerate(columns)})
        return tuple(fields.finish().values())
