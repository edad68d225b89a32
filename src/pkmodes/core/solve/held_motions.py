r"""Motions of a robot that springs to ground hold softly: solved with the parts of K kept apart, or refused.

Without springs to ground, the stiffness :math:`K_s` of belts and reducers leaves some motions free: it has as many
eigenvalues that are zero.  A spring to ground, and gravity, add a part :math:`K_w` that may be many orders smaller.
In the sum it would be lost, first in the entries of the matrix and then in the solver, whose errors are rounding of
the largest eigenvalue.  So the parts are kept apart: with the modes :math:`\Phi` of :math:`K_s`, whose zeros are
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
RESOLVED = 1e-7
#: Likewise for a spring to ground beside gravity: where gravity does not act on a motion, its part of K is a
#: cancellation of rounded numbers, with an error of up to 2e-15 of its largest entries, depending on the processor.
BESIDE_GRAVITY = 4e-6
#: Below this [1/s^2], floating-point numbers have fewer digits.
SMALLEST = 1e-290


def solve_held(at: RobotAtPoses, eigenvalues: Array, shapes: Array) -> None:
    """Solve again, in place, where motions that springs to ground hold have lost digits.

    - eigenvalues: from `pkmodes.core.linalg.eigen.condensed_eigh`, (N, m)
    - shapes: (N, m, n)

    Raises numpy.linalg.LinAlgError if the springs are too soft for any number.
    """
    system = at.system
    softly = has_soft_ground_springs(eigenvalues, system.loose_motions)
    if not softly.any():
        return
    parts, M = at.stiffness_parts, at.mass_matrix
    soft = parts.ground + parts.gravity
    where = np.flatnonzero(softly & ~_stiffer(system, parts, M))
    if not len(where):
        return
    eigenvalues[where], shapes[where] = _held_eigh(
        M[where], parts.machine[where], soft[where], system.first, system.loose_motions
    )


def _held_eigh(M: Array, stiff: Array, soft: Array, first: int, motions: int) -> tuple[Array, Array]:
    """Solve (stiff + soft) phi = lambda M phi where `stiff` leaves some motions free.

    - M, stiff, soft: symmetric, (N, n, n); `stiff` has `motions` eigenvalues that are zero, the others positive
    - first: index of the first released joint
    - motions: number of free motions

    Returns, in this order:
    - eigenvalues: ascending, (N, m); errors of the lowest ones are relative to the soft part
    - shapes: as returned by `condensed_eigh`, (N, m, n)

    Raises numpy.linalg.LinAlgError if M is not positive definite, or the soft part is too small to be represented.
    """
    from pkmodes.core.linalg.graded import graded_eigh  # SciPy's linear algebra takes a while to import

    levels, modes = condensed_eigh(M, stiff, first, motions)
    H = modes @ soft @ np.swapaxes(modes, -1, -2)
    r = np.flatnonzero(without_inertia(M, first))
    yields = None
    if len(r):  # they followed the stiff part alone
        forces = (soft @ np.swapaxes(modes, -1, -2))[:, r]
        yields = -np.linalg.solve((stiff + soft)[:, r[:, None], r], forces)
        H += np.swapaxes(forces, -1, -2) @ yields
    levels[:, :motions] = 0.0
    H += levels[:, :, None] * np.eye(H.shape[-1])
    eigenvalues, shapes = np.empty_like(levels), np.empty_like(modes)
    for i, matrix in enumerate(H):
        across = matrix[:motions, motions:]
        elastic = levels[i, motions:]
        bent = np.linalg.norm(
            np.divide(across, elastic, out=np.zeros_like(across), where=elastic > 0.0) @ across.T
        )
        shift = 2.0 * float(np.linalg.norm(matrix[:motions, :motions]) + bent)
        eigenvalues[i], turned = graded_eigh(np.eye(len(matrix)), matrix, motions, shift)
        shapes[i] = turned @ modes[i]
        if yields is not None:
            shapes[i][:, r] += turned @ yields[i].T
    return eigenvalues, with_sign_convention(shapes, M)


def refuse_unresolved(at: RobotAtPoses, eigenvalues: Array, shapes: Array) -> None:
    """Refuse robots with held motions whose frequencies of vibration are lost in rounding.

    A motion that springs hold and gravity destabilises is not refused, however near to balance they are; nor is one
    that no spring holds, which is a rigid mode: at 0 Hz where gravity leaves it alone, too.

    - eigenvalues, shapes: after `solve_held`, (N, m) and (N, m, n)

    Raises PoseError with the smallest stiffness of a spring to ground that is resolved, if it is to blame.
    """
    system, motions = at.system, at.system.loose_motions
    where = np.flatnonzero(has_soft_ground_springs(eigenvalues, motions))
    if not len(where):
        return
    parts, M = StiffnessParts(*(part[where] for part in at.stiffness_parts)), at.mass_matrix[where]
    stiffer = _stiffer(system, parts, M)
    levels, _ = condensed_eigh(M, parts.machine, system.first, motions)
    lowest_held = np.sort(np.abs(eigenvalues[where, :motions]))[:, system.rigid_modes]
    lowest = np.where(stiffer, lowest_held, levels[:, motions])
    highest = base_eigenvalue_scale(M, at.stiffness_matrix[where], system.first)
    lost = np.abs(lowest) < RESOLVED * highest
    if lost.any():
        which = int(np.argmax(lost))
        raise lost_in_rounding(at, lowest[which], highest[which], by_springs=bool(stiffer[which]))
    slow, size = shapes[where, :motions], np.abs(eigenvalues[where, :motions])
    springs, pull = (np.einsum("Nia,Nab,Nib->Ni", slow, part, slow) for part in (parts.ground, parts.gravity))
    least = np.maximum(BESIDE_GRAVITY * np.abs(pull).max(axis=1, keepdims=True), SMALLEST)
    small = (size < least) & (springs < least)
    np.put_along_axis(small, np.argsort(springs)[:, : system.rigid_modes], values=False, axis=1)
    if small.any():
        pose, mode = np.unravel_index(int(np.argmax(small)), small.shape)
        raise _too_soft(at, size[pose, mode], springs[pose, mode] / least[pose, 0])


def _stiffer(system: Evaluation, parts: StiffnessParts, M: Array) -> NDArray[np.bool_]:
    """Return where springs to ground and gravity are stiffer than belts and reducers."""
    base = slice(system.first)
    inertia = np.diagonal(M, axis1=-2, axis2=-1)[:, base]
    soft, machine = (
        np.abs(part[:, base, base] / np.sqrt(inertia[:, :, None] * inertia[:, None, :])).max(axis=(1, 2))
        for part in (parts.ground + parts.gravity, parts.machine)
    )
    return np.asarray(soft > machine)


def lost_in_rounding(
    at: RobotAtPoses, lowest: float, highest: float, *, by_springs: bool = False
) -> PoseError:
    """Return the error that a frequency of vibration has lost its digits, from two eigenvalues."""
    low, high = natural_frequencies(np.array([lowest, highest]))
    lost = f"vibration at {plain(abs(low), 2)} Hz is lost in rounding against {high:.4g} Hz"
    if by_springs:
        springs = " and ".join(map(in_effects, at.system.springs_to_ground))
        return PoseError(f"a {lost}", at.source, f"make the springs to ground softer: {springs}")
    if len(at.system.coordinates) > at.system.first:
        remedy = "check the compliances under [effects]: make the joint stiffer"
        return PoseError(f"a joint is so soft that its {lost}", at.source, remedy)
    remedy = "check the robot's masses, inertias, lengths and stiffnesses, and their units"
    return PoseError(f"a {lost}", at.source, remedy)


def _too_soft(at: RobotAtPoses, eigenvalue: float, share: float) -> PoseError:
    springs = at.system.springs_to_ground
    low = natural_frequencies(np.array([eigenvalue]))[0]
    problem = (
        f"springs to ground are so soft that their vibration at {plain(abs(low), 2)} Hz is lost in rounding"
    )
    if len(springs) > 1 or not 0.0 < share < 1.0 or min(springs.values()) < SMALLEST:
        return PoseError(
            problem, at.source, f"make them stiffer or leave them out: {', '.join(map(in_effects, springs))}"
        )
    ((path, value),) = springs.items()
    effect, name, *_ = path.split(".")
    unit = next(p.unit for p in at.system.mechanism.effects[effect].parameters if p.name == name)
    least = float(f"{1.05 * value / share:.1e}")
    return PoseError(
        problem, at.source, f"give {in_effects(path)} at least {least:g} {unit}, or leave it out"
    )


def in_effects(path: str) -> str:
    """Return the place of an effect parameter in the robot file."""
    return f"effects.{path}"
