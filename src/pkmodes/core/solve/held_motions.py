r"""Motions of a robot that only soft springs to ground hold: solved with separate parts of K, or refused.

Without springs to ground, the stiffness :math:`K_s` of belts and reducers leaves some motions free: it has as many
eigenvalues that are zero.  A spring to ground, and gravity, add a part :math:`K_w` that may be many orders smaller.
In the sum it would be lost, first in the entries of the matrix and then in the solver, whose errors are rounding of
the largest eigenvalue.  So the parts are kept separate: with the modes :math:`\Phi` of :math:`K_s`, whose zeros are
known and not computed, the problem becomes

.. math:: H = \operatorname{diag}(0, \ldots, 0, \lambda_s) + \Phi^T K_w \Phi ,

which is graded, and `pkmodes.core.linalg.graded` solves it.

Frequencies of vibration have nine correct digits, or the robot is refused; where springs and gravity nearly cancel,
the digits are those of the springs.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.base.numbers import plain
from pkmodes.core.linalg.eigen import (
    base_eigenvalue_scale,
    condensed_eigh,
    has_soft_ground_springs,
    natural_frequencies,
    with_sign_convention,
    without_inertia,
)
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.system.evaluation import Evaluation
from pkmodes.core.system.stiffness_parts import StiffnessParts

Array = NDArray[np.float64]
#: Eigenvalues have an error of some 1e-16 of the largest.  Below this fraction of the largest, a vibration frequency
#: no longer has nine correct digits.
MIN_RESOLVED_RATIO = 1e-7
#: Likewise for a spring to ground beside gravity: where gravity does not act on a motion, its part of K is a
#: cancellation of rounded numbers, with an error of up to 2e-15 of its largest entries, depending on the processor.
MIN_RATIO_TO_GRAVITY = 4e-6
#: Below this [1/s^2], floating-point numbers have fewer digits.
MIN_EIGENVALUE = 1e-290


def solve_held(state: RobotAtPoses, eigenvalues: Array, shapes: Array) -> None:
    """Solve again, in place, where motions that springs to ground hold have lost digits.

    - eigenvalues: from `pkmodes.core.linalg.eigen.condensed_eigh`, (N, m)
    - shapes: (N, m, n)

    Raises numpy.linalg.LinAlgError if the springs are too soft to be represented.
    """
    system = state.system
    soft = has_soft_ground_springs(eigenvalues, system.loose_motions)
    if not soft.any():
        return
    parts, M = state.stiffness_parts, state.mass_matrix
    weak = parts.ground + parts.gravity
    indices = np.flatnonzero(soft & ~_ground_is_stiffer(system, parts, M))
    if not len(indices):
        return
    eigenvalues[indices], shapes[indices] = _held_eigh(
        M[indices], parts.machine[indices], weak[indices], system.base_count, system.loose_motions
    )


def _held_eigh(M: Array, stiff: Array, weak: Array, first: int, motion_count: int) -> tuple[Array, Array]:
    """Solve (stiff + soft) phi = lambda M phi where `stiff` leaves some motions free.

    - M, stiff, weak: symmetric, (N, n, n); `stiff` has `motion_count` eigenvalues that are zero, the others positive
    - first: index of the first released joint
    - motion_count: number of free motions

    Returns, in this order:
    - eigenvalues: ascending, (N, m); errors of the lowest ones are relative to the soft part
    - shapes: as returned by `condensed_eigh`, (N, m, n)

    Raises numpy.linalg.LinAlgError if M is not positive definite, or the soft part is too small to be represented.
    """
    from pkmodes.core.linalg.graded import graded_eigh  # SciPy's linear algebra takes a while to import

    levels, modes = condensed_eigh(M, stiff, first, motion_count)
    H = modes @ weak @ np.swapaxes(modes, -1, -2)
    massless = np.flatnonzero(without_inertia(M, first))
    massless_motion = None
    if len(massless):  # in `modes` these coordinates follow the stiff part only
        forces = (weak @ np.swapaxes(modes, -1, -2))[:, massless]
        massless_motion = -np.linalg.solve((stiff + weak)[:, massless[:, None], massless], forces)
        H += np.swapaxes(forces, -1, -2) @ massless_motion
    levels[:, :motion_count] = 0.0
    H += levels[:, :, None] * np.eye(H.shape[-1])
    eigenvalues, shapes = np.empty_like(levels), np.empty_like(modes)
    for i, matrix in enumerate(H):
        coupling = matrix[:motion_count, motion_count:]
        elastic = levels[i, motion_count:]
        coupling_stiffness = np.linalg.norm(
            np.divide(coupling, elastic, out=np.zeros_like(coupling), where=elastic > 0.0) @ coupling.T
        )
        shift = 2.0 * float(np.linalg.norm(matrix[:motion_count, :motion_count]) + coupling_stiffness)
        eigenvalues[i], coefficients = graded_eigh(np.eye(len(matrix)), matrix, motion_count, shift)
        shapes[i] = coefficients @ modes[i]
        if massless_motion is not None:
            shapes[i][:, massless] += coefficients @ massless_motion[i].T
    return eigenvalues, with_sign_convention(shapes, M)


def refuse_unresolved(state: RobotAtPoses, eigenvalues: Array, shapes: Array) -> None:
    """Refuse robots with held motions whose frequencies of vibration are lost in rounding.

    A motion that springs hold and gravity destabilises is not refused, however closely the two balance; nor is a
    motion that no spring holds: it is a rigid mode, at 0 Hz if gravity does not act on it either.

    - eigenvalues, shapes: after `solve_held`, (N, m) and (N, m, n)

    Raises PoseError with the smallest stiffness of the spring to ground that can be resolved, if that spring is the
    cause.
    """
    system, motions = state.system, state.system.loose_motions
    indices = np.flatnonzero(has_soft_ground_springs(eigenvalues, motions))
    if not len(indices):
        return
    parts, M = StiffnessParts(*(part[indices] for part in state.stiffness_parts)), state.mass_matrix[indices]
    ground_is_stiffer = _ground_is_stiffer(system, parts, M)
    levels, _ = condensed_eigh(M, parts.machine, system.base_count, motions)
    lowest_held = np.sort(np.abs(eigenvalues[indices, :motions]))[:, system.rigid_modes]
    lowest = np.where(ground_is_stiffer, lowest_held, levels[:, motions])
    highest = base_eigenvalue_scale(M, state.stiffness_matrix[indices], system.base_count)
    lost = np.abs(lowest) < MIN_RESOLVED_RATIO * highest
    if lost.any():
        index = int(np.argmax(lost))
        raise lost_in_rounding(
            state, lowest[index], highest[index], by_springs=bool(ground_is_stiffer[index])
        )
    held_shapes, held_eigenvalues = shapes[indices, :motions], np.abs(eigenvalues[indices, :motions])
    spring_stiffness, gravity_stiffness = (
        np.einsum("Nia,Nab,Nib->Ni", held_shapes, part, held_shapes) for part in (parts.ground, parts.gravity)
    )
    minimum = np.maximum(
        MIN_RATIO_TO_GRAVITY * np.abs(gravity_stiffness).max(axis=1, keepdims=True), MIN_EIGENVALUE
    )
    too_small = (held_eigenvalues < minimum) & (spring_stiffness < minimum)
    np.put_along_axis(too_small, np.argsort(spring_stiffness)[:, : system.rigid_modes], values=False, axis=1)
    if too_small.any():
        pose, mode = np.unravel_index(int(np.argmax(too_small)), too_small.shape)
        raise _too_soft(state, held_eigenvalues[pose, mode], spring_stiffness[pose, mode] / minimum[pose, 0])


def _ground_is_stiffer(system: Evaluation, parts: StiffnessParts, M: Array) -> NDArray[np.bool_]:
    """Return where springs to ground and gravity are stiffer than belts and reducers."""
    base = slice(system.base_count)
    inertia = np.diagonal(M, axis1=-2, axis2=-1)[:, base]
    ground, machine = (
        np.abs(part[:, base, base] / np.sqrt(inertia[:, :, None] * inertia[:, None, :])).max(axis=(1, 2))
        for part in (parts.ground + parts.gravity, parts.machine)
    )
    return np.asarray(ground > machine)


def lost_in_rounding(
    state: RobotAtPoses, lowest: float, highest: float, *, by_springs: bool = False
) -> PoseError:
    """Return the error that a frequency of vibration has lost its digits, from two eigenvalues."""
    low, high = natural_frequencies(np.array([lowest, highest]))
    lost = f"vibration at {plain(abs(low), 2)} Hz is lost in rounding against {high:.4g} Hz"
    if by_springs:
        springs = " and ".join(map(path_in_file, state.system.springs_to_ground))
        return PoseError(f"a {lost}", state.source, f"make the springs to ground softer: {springs}")
    if len(state.system.coordinates) > state.system.base_count:
        remedy = "check the compliances under [effects]: make the joint stiffer"
        return PoseError(f"a joint is so soft that its {lost}", state.source, remedy)
    remedy = "check the robot's masses, inertias, lengths and stiffnesses, and their units"
    return PoseError(f"a {lost}", state.source, remedy)


def _too_soft(state: RobotAtPoses, eigenvalue: float, ratio: float) -> PoseError:
    springs = state.system.springs_to_ground
    low = natural_frequencies(np.array([eigenvalue]))[0]
    problem = (
        f"springs to ground are so soft that their vibration at {plain(abs(low), 2)} Hz is lost in rounding"
    )
    if len(springs) > 1 or not 0.0 < ratio < 1.0 or min(springs.values()) < MIN_EIGENVALUE:
        return PoseError(
            problem,
            state.source,
            f"make them stiffer or leave them out: {', '.join(map(path_in_file, springs))}",
        )
    ((path, value),) = springs.items()
    effect, name, *_ = path.split(".")
    unit = next(p.unit for p in state.system.mechanism.effects[effect].parameters if p.name == name)
    minimum = float(f"{1.05 * value / ratio:.1e}")
    return PoseError(
        problem, state.source, f"give {path_in_file(path)} at least {minimum:g} {unit}, or leave it out"
    )


def path_in_file(path: str) -> str:
    """Return the place of an effect parameter in the robot file."""
    return f"effects.{path}"
