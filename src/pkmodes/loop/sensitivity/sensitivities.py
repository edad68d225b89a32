"""Sensitivities of a robot at poses: derivatives of matrices, eigenvalues, frequencies and shapes."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import is_all
from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PkmodesError, checked_list, shown
from pkmodes.core.compiled.lanes import FULL_MATRIX_FIELDS, MATRIX_RATE_FIELDS, Terms
from pkmodes.core.linalg.eigen import has_stiff_joint, rounding_scale
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.robot.layout import effect_parameters
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.backends import AUTO, checked_threads
from pkmodes.core.solve.batch import run_job
from pkmodes.core.solve.field_arrays import FieldArrays, FieldNames, OutArrays, chosen_fields
from pkmodes.core.solve.results import ChosenFields
from pkmodes.core.solve.solver import Solver
from pkmodes.core.support.solutions import solve_modes
from pkmodes.core.system.evaluation import ExtendedSystem, evaluation
from pkmodes.core.system.motors import MotorsHeld, solved_system
from pkmodes.loop.sensitivity.compiled import RATES, derivatives_of, rates_job, terms_of
from pkmodes.loop.sensitivity.locked import LockedJoints, locked_joints
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives
from pkmodes.loop.sensitivity.modes import ROUNDING, branch_rates, group_modes, mode_derivatives
from pkmodes.loop.sensitivity.paths import ParameterPath, paths, resolve_all

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Number of poses differentiated together: the matrices of one pose take a few hundred kilobytes.
POSES_PER_PART = 64
#: The fields that do not depend on modes.
MATRICES = frozenset({"mass_matrix", "stiffness_matrix"})


@dataclass(frozen=True, repr=False, eq=False)
class Sensitivities(ChosenFields):
    """Exact derivatives with respect to T parameters, at fixed platform poses.

    The leading dimensions are those of the poses, then T; n coordinates and m modes as in `pkmodes.Modes`, SI units.
    Entries of poses that could not be evaluated are NaN.

    Attributes
    ----------
    parameters : tuple of str, length T
        Parameter paths.
    units : tuple of str, length T
        Their SI units.
    values : ndarray, shape (T,)
        Their values.
    drives : {"free", "held"}
        What the motors do; M and K are those with free motors, and shapes are given in their coordinates.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    reason : ndarray of str, shape (...)
        Why the others could not (`pkmodes.Model.reasons`), ``""`` where valid; for a single pose a string.
    mass_matrix, stiffness_matrix : ndarray, shape (..., T, n, n)
        dM/dtheta and dK/dtheta, in units of M and K per unit of the parameter.  NaN for the compliance of a locked
        joint, which affects the modes but is not in the matrices.
    eigenvalues : ndarray, shape (..., T, m)
        d lambda / d theta [1/s^2 per unit of the parameter].
    frequencies : ndarray, shape (..., T, m)
        d f / d theta [Hz per unit of the parameter], with f as in `pkmodes.Modes`; NaN where f is 0 to rounding.
    shapes : ndarray, shape (..., T, m, n)
        Derivatives, per unit of the parameter, of the mass-normalised mode shapes from `pkmodes.Model.modes` at
        the same poses.  In a group of several modes, only the part outside the group, which alone is determined,
        and the part that keeps the norm.
    groups : ndarray of int, shape (..., m)
        The same number for modes that are repeated or closer than `close`; their eigenvalue derivatives are those
        of the branches into which the group splits, ascending.  -1 where a pose could not be evaluated.

    Raises
    ------
    NotComputedError
        If `mass_matrix` or a later field is read but was not requested.
    """

    FIELDS: ClassVar[tuple[str, ...]] = (
        "mass_matrix",
        "stiffness_matrix",
        "eigenvalues",
        "frequencies",
        "shapes",
        "groups",
    )
    METHOD: ClassVar[str] = "Model.sensitivities"

    parameters: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    drives: str = FREE
    mass_matrix: Array = field(init=False)
    stiffness_matrix: Array = field(init=False)
    eigenvalues: Array = field(init=False)
    frequencies: Array = field(init=False)
    shapes: Array = field(init=False)
    groups: NDArray[np.intp] = field(init=False)


class ResolvedPaths:
    """Parameter paths of a robot, resolved once for any number of calls.

    - parameters: paths, perhaps resolved; by default all that can vary
    - drives: what the motors do, "free" or "held"

    Its attributes:
    - names, units: paths and SI units, length T
    - values: as the robot has them, (T,)
    - system: of the robot, with free or held motors

    Raises PkmodesError if a path is unknown or cannot vary.
    """

    def __init__(
        self, robot: Robot, parameters: Sequence[str | ParameterPath] | None, drives: str = FREE
    ) -> None:
        if parameters is None or is_all(parameters):
            mechanism = robot.mechanism
            # A zero vector has no direction along which its radius could change; it was not requested by name.
            excluded = {
                group.path
                for group in mechanism.parameter_groups
                if group.kind == "radius" and not getattr(robot.parameters, group.field).any(axis=1).all()
            }
            dissipating = mechanism.effects.keys() - mechanism.conservative_effects.keys()
            excluded |= {path for path in effect_parameters(mechanism) if path.split(".")[1] in dissipating}
            requested = [path for path in paths(robot) if path not in excluded]
        else:
            requested = checked_list(parameters, "parameter paths", "parameters", '"platform.mass"')
        self.robot, self.paths, self.drives = robot, resolve_all(robot, requested), drives
        self.names = tuple(path.path for path in self.paths)
        self.units = tuple(path.unit for path in self.paths)
        self.values = np.array([path.value for path in self.paths])
        self.system = solved_system(evaluation(robot), drives)

    @cached_property
    def extended(self) -> ExtendedSystem:
        """The robot's system with all released joints."""
        return self.system if isinstance(self.system, ExtendedSystem) else ExtendedSystem.of(self.robot)

    @cached_property
    def free_motor_system(self) -> ExtendedSystem:
        """The extended system with free motors, in whose coordinates the results are given."""
        return ExtendedSystem.of(self.robot) if isinstance(self.system, MotorsHeld) else self.extended

    @cached_property
    def terms(self) -> Terms:
        """The paths as the compiled evaluator takes them."""
        return terms_of(self.extended, self.paths)

    @cached_property
    def locked(self) -> LockedJoints:
        """The locked joints that paths would release."""
        return locked_joints(self.extended, self.paths)

    @cached_property
    def free_motor_terms(self) -> Terms:
        """The paths as the compiled evaluator takes them with free motors."""
        return (
            self.terms
            if self.free_motor_system is self.extended
            else terms_of(self.free_motor_system, self.paths)
        )


class _Solvers(NamedTuple):
    """Solver of the system with its actual drives, in its own coordinates, and of that with free motors."""

    solved: Solver
    free: Solver


def sensitivities_at(
    model: Model,
    poses: ArrayLike,
    parameters: Sequence[str | ParameterPath] | None = None,
    *,
    close: float = 1e-6,
    on_error: OnError = "raise",
    fields: FieldNames = None,
    drives: str | None = None,
    out: OutArrays = None,
    backend: str = AUTO,
    threads: int | None = None,
) -> Sensitivities:
    """Compute exact derivatives of matrices and modes with respect to parameters, at fixed platform poses.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        In SI units.
    parameters : sequence of str, optional
        Parameter paths (docs/reference/parameter-paths.md); by default all quantities of the robot and all effect
        parameters.
    close : float
        Modes whose eigenvalues differ by less than this fraction form one group.
    on_error : {"raise", "nan"}
        As for `modes`.
    fields : sequence of str, optional
        Which of ``Sensitivities.FIELDS`` to compute and keep; by default all, or the fields in `out`.
        ``"frequencies"`` and ``"eigenvalues"`` alone take a seventh of the time at one pose and a hundredth at many;
        without the compiled library, at many poses a third.
    drives : {"free", "held"}, optional
        As for `modes`.
    out : mapping of str to ndarray, optional
        As for `modes`.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`: what solves the eigenproblem and evaluates these two fields.  With the same back end,
        repeated modes have the same basis.
    threads : int, optional
        As for `modes`.

    Returns
    -------
    Sensitivities
        With the leading axes of the poses.

    Raises
    ------
    PkmodesError
        If a path is unknown (the message suggests the nearest), or a field or an array in `out` is invalid as
        in `modes`.
    """
    drives = model.robot.resolve_drives(drives)
    resolved = _resolve_parameters(model, parameters, drives)
    solver, thread_count = model.solver(backend, drives).inner, checked_threads(threads)
    solvers = _Solvers(solver, solver if drives == FREE else model.solver(backend, FREE))
    robot, system = resolved.robot, resolved.system
    if not (isinstance(close, int | float | np.integer | np.floating) and 0.0 <= close < 1.0):
        raise PkmodesError(f"expected a fraction below 1, found {shown(close)}", "close", "for example: 1e-6")
    requested = chosen_fields(fields, out, Sensitivities.FIELDS)
    limit = float(close)
    if solver.differentiates and set(requested) <= RATES.keys():

        def by_numpy(points: Array) -> dict[str, Array]:
            starts = range(0, len(points), POSES_PER_PART)
            parts = [points[start : start + POSES_PER_PART] for start in starts]
            fields_of_parts = [_fields_at(resolved, part, limit, requested, solvers) for part in parts]
            return {name: np.concatenate([part[name] for part in fields_of_parts]) for name in requested}

        job = rates_job(solver, system, robot.source, resolved.terms, limit, requested, by_numpy)
        checked, arrays = run_job(job, robot, model.max_condition, poses, on_error, out, thread_count)
    else:
        checked = model.checked(poses, on_error)
        is_buffered = on_error == "raise" and len(system.coordinates) > system.base_count
        field_arrays = FieldArrays(
            checked.batch, out, deferred=is_buffered, filled_with_nan=bool(checked.codes.any())
        )
        # In parts of equal size: a single pose is evaluated differently, which gives repeated modes another basis.
        for where, p in checked.parts(POSES_PER_PART, even=True):
            field_arrays.put(where, _fields_at(resolved, p, limit, requested, solvers))
        arrays = field_arrays.finish()
    return Sensitivities(
        codes=checked.codes.reshape(checked.batch),
        known=checked.reasons,
        arrays=arrays,
        parameters=resolved.names,
        units=resolved.units,
        values=resolved.values.copy(),
        drives=resolved.drives,
    )


def _resolve_parameters(
    model: Model, parameters: Sequence[str | ParameterPath] | None, drives: str
) -> ResolvedPaths:
    """Resolve parameter paths; those of the last call are kept with the model."""
    if parameters is None:
        names: tuple[str, ...] | None = None
    elif isinstance(parameters, list | tuple) and all(isinstance(path, str) for path in parameters):
        names = tuple(str(path) for path in parameters)
    else:  # paths that are resolved already; anything else is refused
        return ResolvedPaths(model.robot, parameters, drives)
    key, last = (names, drives), model.kept.get(ResolvedPaths)
    if last is None or last[0] != key:
        last = model.kept[ResolvedPaths] = key, ResolvedPaths(model.robot, parameters, drives)
    resolved: ResolvedPaths = last[1]
    return resolved


def _fields_at(
    resolved: ResolvedPaths, p: Array, close: float, requested: Collection[str], solvers: _Solvers
) -> dict[str, NDArray[Any]]:
    """Compute the requested fields at some poses."""
    derivatives, fields = None, dict[str, NDArray[Any]]()
    if not MATRICES.issuperset(requested):
        derivatives, fields = _mode_rates(resolved, p, close, requested, solvers.solved)
    if not MATRICES.isdisjoint(requested):
        # M and K are those with free motors.
        if derivatives is None or isinstance(resolved.extended, MotorsHeld):
            terms = resolved.free_motor_terms
            derivatives = derivatives_of(
                solvers.free, resolved.free_motor_system, p, [resolved.paths], None, terms, MATRIX_RATE_FIELDS
            )
        fields["mass_matrix"], fields["stiffness_matrix"] = derivatives.dense()
    return {name: fields[name] for name in requested}


def _mode_rates(
    resolved: ResolvedPaths, p: Array, close: float, requested: Collection[str], solver: Solver
) -> tuple[MatrixDerivatives, dict[str, NDArray[Any]]]:
    """Return the derivatives of M and K at the modes, and the fields that follow from them."""
    robot, system, extended = resolved.robot, resolved.system, resolved.extended
    with_shapes = "shapes" in requested
    # Bitwise the matrices of `Model.modes`, so that repeated modes have the same basis.
    solved_poses = solve_modes(solver, system, p, robot.source, *(sorted(MATRICES) if with_shapes else ()))
    eigenvalues, shapes = solved_poses["eigenvalues"], solved_poses["shapes"]
    along_fields = list[str]()
    if with_shapes:
        along_fields += ["changes", "norms", *(FULL_MATRIX_FIELDS if resolved.terms.locked_joints else ())]
        if not (isinstance(extended, MotorsHeld) or MATRICES.isdisjoint(requested)):
            along_fields += MATRIX_RATE_FIELDS
    derivatives = derivatives_of(
        solver,
        extended,
        solved_poses.points,
        [resolved.paths],
        (eigenvalues, shapes),
        resolved.terms,
        along_fields,
        matrices=solved_poses.evaluated("all_coordinates") if extended is system else None,
        locked=resolved.locked,
    )
    sizes = rounding_scale(eigenvalues, system.base_count, system.rigid_modes, system.loose_motions)
    group = group_modes(eigenvalues, close, sizes)
    fields: dict[str, NDArray[Any]] = {"groups": group}
    if with_shapes:
        fields["eigenvalues"], fields["shapes"] = _eigenvalue_and_shape_rates(
            derivatives, solved_poses, group, sizes
        )
        if isinstance(extended, MotorsHeld):
            fields["shapes"] = extended.to_free_motor_coordinates(fields["shapes"])
    elif {"eigenvalues", "frequencies"} & set(requested):
        fields["eigenvalues"] = _eigenvalue_rates(derivatives, eigenvalues, shapes, group)
    if "frequencies" in requested:
        size = np.abs(eigenvalues)
        is_zero = size <= ROUNDING * sizes  # sqrt has no derivative at 0
        denominator = 4.0 * np.pi * np.sqrt(np.where(is_zero, np.nan, size))
        fields["frequencies"] = fields["eigenvalues"] / denominator[:, None]
    return derivatives, fields


def _eigenvalue_and_shape_rates(
    derivatives: MatrixDerivatives, solved_poses: RobotAtPoses, group: Index, sizes: Array
) -> tuple[Array, Array]:
    """Compute the derivatives of eigenvalues, (N, T, m), and shapes, (N, T, m, n)."""
    modes = M, K, eigenvalues, shapes = tuple(
        solved_poses[name] for name in ("mass_matrix", "stiffness_matrix", "eigenvalues", "shapes")
    )
    change, norm = derivatives.changes(eigenvalues, shapes)
    rates, shape_rates = np.empty(norm.shape), np.empty(change.shape)
    for i, arguments in enumerate(zip(*modes, change, norm, group, sizes, strict=True)):
        rates[i], shape_rates[i] = mode_derivatives(*arguments)
    first = solved_poses.system.base_count
    stiff_poses = np.flatnonzero(has_stiff_joint(eigenvalues, first, solved_poses.system.rigid_modes))
    if len(stiff_poses):
        evaluated = np.setdiff1d(np.arange(norm.shape[1]), derivatives.locked_paths)
        for i, dM, dK in zip(stiff_poses.tolist(), *derivatives.dense(stiff_poses), strict=True):
            mode = eigenvalues[i], shapes[i]
            forces = derivatives.stiff_change(i, *mode, dM, dK)[evaluated]
            _, stiff_rates = mode_derivatives(
                M[i], K[i], *mode, forces, norm[i, evaluated], group[i], sizes[i]
            )
            shape_rates[i, evaluated, first:] = stiff_rates[:, first:]
    return rates, shape_rates


def _eigenvalue_rates(
    derivatives: MatrixDerivatives, eigenvalues: Array, shapes: Array, group: Index
) -> Array:
    """Compute only the eigenvalue derivatives, (N, T, m), from the entries that change, without linear systems."""
    rates = np.swapaxes(derivatives.eigenvalues(eigenvalues, shapes), -1, -2)
    repeated = np.flatnonzero(group[:, -1] < group.shape[1] - 1)
    if len(repeated):
        change, _ = derivatives.changes(eigenvalues, shapes, repeated)
        for i, pose_change in zip(repeated, change, strict=True):
            rates[i] = branch_rates(pose_change, shapes[i], group[i])
    return rates
