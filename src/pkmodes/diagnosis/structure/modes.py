r"""The modes of K phi = lambda M phi, where M may be singular, and their derivatives.

With :math:`f_i = (dK - \lambda_i dM) \phi_i`, the derivative of shape i has three parts: the other modes j,
:math:`\phi_j \phi_j^T f_i / (\lambda_i - \lambda_j)`; the motions N without inertia,
:math:`-N (N^T K N)^{-1} N^T f_i`; and the normalisation, :math:`-\phi_i \phi_i^T dM \phi_i / 2`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy import linalg

from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.structure.massless import UnstableError, UnusableError, condense
from pkmodes.diagnosis.structure.supplied import Pair

#: Eigenvalues below zero by less than this fraction of the largest are zero up to rounding.
STABLE = 1e-9
#: Smaller relative gaps of two eigenvalues are set to this: derivatives of a single mode are not defined there.
GAP = 1e-6


class Modes(NamedTuple):
    """All modes of one setup.

    Attributes
    ----------
    eigenvalues : ndarray, shape (m,)
    shapes : ndarray, shape (m, n)
        Mass-normalised.
    massless : ndarray, shape (n, n - m), or None
        Motions without inertia, None if there are none.
    """

    eigenvalues: Array
    shapes: Array
    massless: Array | None

    @property
    def size(self) -> int:
        """Memory [bytes]."""
        return sum(a.nbytes for a in self if a is not None)

    @property
    def scale(self) -> float:
        """Size of the largest eigenvalue."""
        return float(np.abs(self.eigenvalues).max())


def modes_of(pair: Pair, rigid: int) -> Modes:
    """Compute the modes.

    Parameters
    ----------
    pair : Pair
        M and K of one setup.
    rigid : int
        Number of modes that may be motions without stiffness.

    Raises
    ------
    UnusableError
        If M has a negative kinetic energy, or a motion has neither mass nor stiffness.
    UnstableError
        If a mode is unstable.
    """
    part = condense(pair.M, pair.K)
    try:
        eigenvalues, shapes = (solution[0] for solution in generalised_eigh(part.M[None], part.K[None]))
    except np.linalg.LinAlgError as error:
        raise UnusableError(f"no modes: {error}", "M", "check the masses") from error
    modes = Modes(eigenvalues, shapes if part.T is None else shapes @ part.T.T, part.N)
    # A structure that buckles does not vibrate: sqrt(|lambda|) would not be a frequency.
    lowest = eigenvalues[rigid : rigid + 1].min(initial=np.inf)
    if not np.isfinite(eigenvalues).all() or lowest < -STABLE * modes.scale:
        what = f"expected a stable structure, found the eigenvalue {lowest:.6g} 1/s^2"
        remedy = "check the sign of K, and that rigid counts every free motion"
        raise UnstableError(what, "K", remedy)
    return modes


def eigenvalue_rates(modes: Modes, count: int, changes: Sequence[Pair | None]) -> Array:
    """Differentiate the lowest eigenvalues: phi^T (dK - lambda dM) phi, (count, T)."""
    forces, _ = _forces(modes, count, changes)
    rates: Array = np.einsum("tin,in->it", forces, modes.shapes[:count])
    return rates


def shape_rates(K: Array, modes: Modes, count: int, changes: Sequence[Pair | None]) -> Array:
    """Differentiate the shapes of the lowest modes.

    Parameters
    ----------
    K : ndarray, shape (n, n)
    modes : Modes
    count : int
        Number of modes whose shapes are differentiated.
    changes : sequence of Pair or None, length T
        Derivatives of M and K with respect to each parameter, None if zero.

    Returns
    -------
    ndarray, shape (count, n, T)
    """
    forces, inertial = _forces(modes, count, changes)
    factors = np.einsum("tin,jn->tij", forces, modes.shapes, optimize=True) / _gaps(modes, count)
    factors[:, np.arange(count), np.arange(count)] = 0.0
    derivatives = factors @ modes.shapes
    if (N := modes.massless) is not None:
        held = linalg.solve(N.T @ (K @ N), N.T @ forces.reshape(-1, len(N)).T)
        derivatives -= held.T.reshape(*forces.shape[:2], -1) @ N.T
    derivatives -= 0.5 * inertial[..., None] * modes.shapes[:count]
    rates: Array = np.moveaxis(derivatives, 0, -1)
    return rates


def _forces(modes: Modes, count: int, changes: Sequence[Pair | None]) -> tuple[Array, Array]:
    """Return (dK - lambda_i dM) phi_i, (T, count, n), and phi_i^T dM phi_i, (T, count)."""
    eigenvalues, phi = modes.eigenvalues[:count], modes.shapes[:count]
    forces, inertial = np.zeros((len(changes), *phi.shape)), np.zeros((len(changes), count))
    for t, change in enumerate(changes):
        if change is not None:
            inertia = (change.M @ phi.T).T
            forces[t] = (change.K @ phi.T).T - eigenvalues[:, None] * inertia
            inertial[t] = (phi * inertia).sum(axis=1)
    return forces, inertial


def _gaps(modes: Modes, count: int) -> Array:
    """Return lambda_i - lambda_j, bounded away from zero with its sign; for equal ones, the sign of their order."""
    every = modes.eigenvalues
    some = every[:count]
    gaps = some[:, None] - every
    largest = np.maximum(np.abs(some)[:, None], np.abs(every))
    least = np.maximum(GAP * largest, STABLE * GAP * (modes.scale or 1.0))
    order = np.sign(np.arange(count)[:, None] - np.arange(len(every)))
    sign = np.where(gaps == 0.0, order, np.sign(gaps))
    return np.where(np.abs(gaps) < least, np.where(sign == 0.0, 1.0, sign) * least, gaps)
