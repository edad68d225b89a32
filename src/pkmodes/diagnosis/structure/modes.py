r"""The modes of K phi = lambda M phi, where M may be singular, and their derivatives.

The derivative of a shape is its modal expansion (`core.linalg.expansion`) and that of the motions N without inertia,
which follow statically: :math:`-N (N^T K N)^{-1} N^T (dK - \lambda_i dM) \phi_i`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes.core.linalg.expansion import modal_expansion
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.structure.massless import UnstableError, UnusableError, condense
from pkmodes.diagnosis.structure.supplied import Pair

#: Eigenvalues below zero by less than this fraction of the largest are zero up to rounding.
STABLE = 1e-9


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
    # A structure that buckles does not vibrate: sqrt(|lambda|) would not be a frequency.
    lowest = eigenvalues[rigid : rigid + 1].min(initial=np.inf)
    if not np.isfinite(eigenvalues).all() or lowest < -STABLE * np.abs(eigenvalues).max():
        what = f"expected a stable structure, found the eigenvalue {lowest:.6g} 1/s^2"
        remedy = "check the sign of K, and that rigid counts every free motion"
        raise UnstableError(what, "K", remedy)
    return Modes(eigenvalues, shapes if part.T is None else shapes @ part.T.T, part.N)


def changes_of(modes: Modes, changes: Sequence[Pair | None]) -> tuple[Array, Array]:
    """Return (dK - lambda dM) phi, (T, m, n), and phi^T dM phi, (T, m), of each parameter; zero where it is None."""
    forces = np.zeros((len(changes), *modes.shapes.shape))
    norm = np.zeros(forces.shape[:2])
    for t, change in enumerate(changes):
        if change is not None:
            inertia = modes.shapes @ change.M
            forces[t] = modes.shapes @ change.K - modes.eigenvalues[:, None] * inertia
            norm[t] = (modes.shapes * inertia).sum(axis=1)
    return forces, norm


def shape_rates_of(K: Array, modes: Modes, forces: Array, norm: Array) -> Array:
    """Differentiate the shapes.

    Parameters
    ----------
    K : ndarray, shape (n, n)
    modes : Modes
    forces, norm : ndarray, shape (T, m, n) and (T, m)
        From `changes_of`.

    Returns
    -------
    ndarray, shape (T, m, n)
    """
    eigenvalues, shapes, N = modes
    rates: Array = modal_expansion(forces[None], norm[None], eigenvalues[None], shapes[None])[0] @ shapes
    if N is not None:
        rates -= np.swapaxes(np.linalg.solve(N.T @ K @ N, N.T @ np.swapaxes(forces, -1, -2)), -1, -2) @ N.T
    return rates
