"""Integration in time of small motions: exact for the linear part, with forces that are linear between samples.

Coulomb friction is a force in the interval from -F to F that opposes sliding, and any force in it that keeps the
joint at rest.  It is constant during a step and found from the velocities at the end of the step (Moreau's scheme),
so that sticking needs neither events nor a regularised sign of the velocity; its error is of the order of the step.

References
----------
Moreau, J. J. (1988). Unilateral contact and dry friction in finite freedom dynamics. In Nonsmooth Mechanics and
Applications, CISM Courses 302, Springer, 1-82.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.linalg import expm
from scipy.signal import lfilter

from pkmodes_rig.signals.small_motion import SmallMotion

#: Sweeps of the projected Gauss-Seidel iteration at each step, which starts from the friction of the step before.
SWEEPS = 3


def responses(
    machine: SmallMotion,
    step: float,
    forces: np.ndarray,
    into: np.ndarray,
    rows: np.ndarray,
    initial: np.ndarray | None = None,
) -> np.ndarray:
    """Integrate a machine without Coulomb friction and return accelerations, shape (N, S).

    Parameters
    ----------
    machine : SmallMotion
    step : float
        Between samples [s].
    forces : ndarray, shape (N, F)
        Linear between samples.
    into : ndarray, shape (F, m)
        Modal force of a unit of each; for a force along coordinates, their rows of the shapes.
    rows : ndarray, shape (S, m)
        Rows of the shapes at what is measured.
    initial : ndarray, shape (2 m,), optional
        Modal displacements and velocities; at rest by default.
    """
    poles, vectors = np.linalg.eig(machine.state_matrix)
    m = len(machine.eigenvalues)
    back = np.linalg.inv(vectors)
    kept = poles.imag >= 0.0
    twice = np.where(poles[kept].imag > 0.0, 2.0, 1.0)
    acceleration = machine.state_matrix[m:] @ vectors[:, kept] * twice
    gains, found = rows @ acceleration, forces @ (rows @ into.T).T
    entering = back[kept][:, m:] @ into.T
    begin = np.zeros(len(twice), complex) if initial is None else back[kept] @ initial
    for pole, gain, part, first in zip(poles[kept], gains.T, entering, begin, strict=True):
        z = pole * step
        growth = np.exp(z)
        one = np.expm1(z) / z
        two = (one - 1.0) / z
        driven = forces @ part
        moved = lfilter([step * two, step * (one - two)], [1.0, -growth], driven)
        # The filter takes the first sample for the end of a step; the motion begins there.
        moved += (first - step * two * driven[0]) * np.exp(pole * step * np.arange(len(driven)))
        found += np.real(moved[:, None] * gain)
    return found


def responses_with_friction(
    machines: Sequence[SmallMotion],
    step: float,
    forces: Sequence[np.ndarray],
    intos: Sequence[np.ndarray],
    rows: Sequence[np.ndarray],
    initial: np.ndarray | None = None,
) -> list[np.ndarray]:
    """Integrate several machines with Coulomb friction at once, each with its own forces.

    Parameters
    ----------
    machines : sequence of SmallMotion
        With equal numbers of modes, and friction at the same coordinates.
    step : float
        [s].
    forces, intos, rows : sequence of ndarray, shapes (N, F), (F, m), (S, m)
        As for `responses`, for each machine.
    initial
        As for `responses`, for all machines.

    Returns
    -------
    list of ndarray, shape (N, S)
        Accelerations.
    """
    names = tuple(machines[0].coulomb)
    m, count = len(machines[0].eigenvalues), len(forces[0])
    E, first, last, W, S, limits = (
        np.array(part) for part in zip(*(_discrete(one, step, names) for one in machines), strict=True)
    )
    modal = np.array([force @ into for force, into in zip(forces, intos, strict=True)])  # (R, N, m)
    pushes = np.einsum("rij,rnj->nri", first, modal[:, :-1]) + np.einsum("rij,rnj->nri", last, modal[:, 1:])
    delassus = S @ W
    diagonal = np.einsum("rii->ri", delassus)
    x = np.zeros((len(machines), 2 * m)) if initial is None else np.tile(initial, (len(machines), 1))
    states, frictions = np.empty((count, *x.shape)), np.zeros((count, len(machines), len(names)))
    states[0], friction = x, np.zeros((len(machines), len(names)))
    transposed = np.ascontiguousarray(E.transpose(0, 2, 1))
    of_velocity, of_friction = S.transpose(0, 2, 1), W.transpose(0, 2, 1)
    for k in range(count - 1):
        x = (x[:, None] @ transposed)[:, 0] + pushes[k]
        sliding = (x[:, None] @ of_velocity)[:, 0]
        friction = friction.copy()
        for _ in range(SWEEPS):
            for j in range(len(names)):
                velocity = sliding[:, j] + (delassus[:, j] * friction).sum(axis=1)
                wanted = friction[:, j] - velocity / diagonal[:, j]
                friction[:, j] = np.minimum(np.maximum(wanted, -limits[:, j]), limits[:, j])
        x = x + (friction[:, None] @ of_friction)[:, 0]
        states[k + 1], frictions[k + 1] = x, friction
    found = []
    for r, machine in enumerate(machines):
        inner = states[:, r] @ machine.state_matrix[m:].T + modal[r] + frictions[:, r] @ machine.rows(names)
        found.append(inner @ rows[r].T)
    return found


def _discrete(machine: SmallMotion, step: float, names: Sequence[str]) -> tuple[np.ndarray, ...]:
    """Return the step of the state, of forces at its two ends, of friction; and velocities and limits of friction."""
    m = len(machine.eigenvalues)
    enter = np.vstack([np.zeros((m, m)), np.eye(m)])
    block = np.zeros((4 * m, 4 * m))  # state, force, rate of the force: Van Loan's block matrix
    block[: 2 * m, : 2 * m], block[: 2 * m, 2 * m : 3 * m] = machine.state_matrix, enter
    block[2 * m : 3 * m, 3 * m :] = np.eye(m)
    power = expm(step * block)
    E, held, rising = power[: 2 * m, : 2 * m], power[: 2 * m, 2 * m : 3 * m], power[: 2 * m, 3 * m :] / step
    rubbing = machine.rows(names)
    S = np.hstack([np.zeros((len(names), m)), rubbing])
    limits = np.array([machine.coulomb[name] for name in names])
    return E, held - rising, rising, held @ rubbing.T, S, limits
