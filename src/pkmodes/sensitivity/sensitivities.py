"""Sensitivities of a robot at poses: derivatives of matrices, eigenvalues, frequencies and shapes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.eigen import has_stiff_joint, magnitude
from pkmodes.errors import PkmodesError, shown
from pkmodes.evaluation import evaluation, solve
from pkmodes.poses import CheckedPoses
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.modes import ROUNDING, groups, mode_derivatives
from pkmodes.sensitivity.paths import ParameterPath, paths, resolve_all
from pkmodes_generated.linear_delta import COORDINATES

Array = NDArray[np.float64]
#: Poses that are differentiated together: the matrices of one pose take a few hundred kilobytes.
TOGETHER = 64


@dataclass(frozen=True)
class Sensitivities:
    """Exact derivatives by T parameters, at fixed platform poses.

    The leading axes are those of the poses, then T; n coordinates and m modes as in `pkmodes.Modes`, SI units.
    Entries of poses that could not be evaluated are NaN.

    Attributes
    ----------
    parameters : tuple of str, length T
        Parameter paths.
    units : tuple of str, length T
        Their SI units.
    values : ndarray, shape (T,)
        Their values.
    mass_matrix, stiffness_matrix : ndarray, shape (..., T, n, n)
        dM/dtheta and dK/dtheta, in units of M and K by that of the parameter.  NaN for the compliance of a
        joint that is locked: it is not in the matrices, but the modes feel it.
    eigenvalues : ndarray, shape (..., T, m)
        d lambda / d theta [1/s^2 by the parameter's unit].
    frequencies : ndarray, shape (..., T, m)
        d f / d theta [Hz by the parameter's unit], with f as in `pkmodes.Modes`; NaN where f is 0 to rounding.
    shapes : ndarray, shape (..., T, m, n)
        Derivatives, by the parameter's unit, of the mass-normalised shapes that `pkmodes.Model.modes` gives at
        the same poses; in a group of several modes the part outside the group, which alone is determined, and
        what keeps the norm.
    groups : ndarray of int, shape (..., m)
        The same number for modes that are repeated or closer than asked; their eigenvalue derivatives are
        those of the branches into which the group splits, ascending.  -1 where a pose could not be evaluated.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    """

    parameters: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    mass_matrix: Array
    stiffness_matrix: Array
    eigenvalues: Array
    frequencies: Array
    shapes: Array
    groups: NDArray[np.intp]
    valid: NDArray[np.bool_]


def sensitivities(
    robot: Robot, poses: CheckedPoses, parameters: Sequence[str] | None, close: float
) -> Sensitivities:
    """Evaluate the sensitivities of a robot; see `pkmodes.Model.sensitivities`."""
    chosen = _chosen(robot, parameters)
    if not (isinstance(close, int | float) and 0.0 <= close < 1.0):
        raise PkmodesError(f"expected a fraction below 1, found {shown(close)}", "close", "use such as 1e-6")
    points = poses.points[poses.valid]
    # In parts of even size: a single pose is evaluated in another way, and repeated modes in another basis.
    together = np.array_split(points, max(-(-len(points) // TOGETHER), 1))
    parts = [_at(robot, p, chosen, close) for p in together]
    dM, dK, eigenvalues, frequencies, shapes, numbers = (
        poses.scatter(np.concatenate(column)) for column in zip(*parts, strict=True)
    )
    return Sensitivities(
        parameters=tuple(path.path for path in chosen),
        units=tuple(path.unit for path in chosen),
        values=np.array([path.value for path in chosen]),
        mass_matrix=dM,
        stiffness_matrix=dK,
        eigenvalues=eigenvalues,
        frequencies=frequencies,
        shapes=shapes,
        groups=np.where(np.isnan(numbers), -1, numbers).astype(np.intp),
        valid=poses.valid.reshape(poses.batch),
    )


def _chosen(robot: Robot, parameters: Sequence[str] | None) -> list[ParameterPath]:
    if parameters is None:
        # The radius of a joint at the centre has no direction; nobody asked for it by name.
        radial = robot.parameters.joint.any(axis=1).all()
        return resolve_all(robot, [path for path in paths(robot) if path != "axis.joint_radius" or radial])
    if isinstance(parameters, str) or not isinstance(parameters, Iterable):
        raise PkmodesError(
            f"expected a list of parameter paths, found {shown(parameters)}",
            "parameters",
            f"write [{shown(parameters)}]"
            if isinstance(parameters, str)
            else 'write such as ["platform.mass"]',
        )
    return resolve_all(robot, parameters)


def _at(robot: Robot, p: Array, chosen: list[ParameterPath], close: float) -> tuple[Array, ...]:
    derivatives = MatrixDerivatives(robot, p, chosen)
    # To the last digit the matrices of `Model.modes`: repeated modes must come out in the same basis.
    model, first = evaluation(robot.parameters, robot.effects), len(COORDINATES)
    M, K, eigenvalues, shapes = solve(model, p, robot.source)
    dM, dK = derivatives.dense()
    change = np.einsum("ptab,pib->ptia", dK, shapes)
    change -= eigenvalues[:, None, :, None] * np.einsum("ptab,pib->ptia", dM, shapes)
    norm = np.einsum("pia,ptab,pib->pti", shapes, dM, shapes, optimize=True)
    for t in derivatives.locked:
        change[:, t], norm[:, t] = derivatives.locked_change(t, eigenvalues, shapes)
    sizes = magnitude(eigenvalues, first, model.rigid_modes)
    group = groups(eigenvalues, close, sizes)
    d_eigenvalues, d_shapes = np.empty(norm.shape), np.empty(change.shape)
    for i in range(len(p)):
        d_eigenvalues[i], d_shapes[i] = mode_derivatives(
            M[i], K[i], eigenvalues[i], shapes[i], change[i], norm[i], group[i], sizes[i]
        )
    evaluated = [t for t in range(len(chosen)) if t not in derivatives.locked]
    for pose in np.flatnonzero(has_stiff_joint(eigenvalues, first, model.rigid_modes)).tolist():
        given = eigenvalues[pose], shapes[pose]
        other = derivatives.stiff_change(pose, *given, dM[pose], dK[pose])[evaluated]
        _, found = mode_derivatives(
            M[pose], K[pose], *given, other, norm[pose, evaluated], group[pose], sizes[pose]
        )
        d_shapes[pose, evaluated, first:] = found[:, first:]
    size = np.abs(eigenvalues)
    nothing = size <= ROUNDING * sizes  # sqrt has no derivative at 0
    frequencies = d_eigenvalues / (4.0 * np.pi * np.sqrt(np.where(nothing, np.nan, size))[:, None])
    return dM, dK, d_eigenvalues, frequencies, d_shapes, group.astype(float)
