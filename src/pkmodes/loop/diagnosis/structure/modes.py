r"""The modes of K phi = lambda M phi, where M may be singular, and their derivatives.

If M is singular, M N = 0, the motions N follow the others statically: :math:`N^T K (T q + N r) = 0`, which holds for
every q if :math:`N^T K T = 0`.  They add no modes, but appear in the shapes.  Coordinates with zero rows in M are
such motions, and so is every combination of coordinates without kinetic energy.

The derivative of a shape is its modal expansion (`support.expansion`) and that of the motions N without inertia:
:math:`-N (N^T K N)^{-1} N^T (dK - \lambda_i dM) \phi_i`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy import linalg

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes.core.support.expansion import modal_expansion
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.structure.supplied import MatrixPair

#: Smaller pivots of a matrix scaled to a unit diagonal are zero up to rounding.
PIVOT_TOLERANCE = 1e-13
#: Eigenvalues below zero by less than this fraction of the largest are zero up to rounding.
EIGENVALUE_TOLERANCE = 1e-9


class UnusableError(PkmodesError):
    """Matrices without modes: an error at the declared values; a fit avoids such values."""


class UnstableError(UnusableError):
    """A structure that is statically unstable."""


class CondensedMatrices(NamedTuple):
    """Coordinates x = T q with inertia, and motions N without, K-orthogonal to each other.

    - M, K: T^T M T, positive definite, and T^T K T, (p, p)
    - T: (n, p); None if every motion has inertia
    - N: (n, n - p)
    """

    M: Array
    K: Array
    T: Array | None
    N: Array | None


def condense(M: Array, K: Array) -> CondensedMatrices:
    """Separate the motions with inertia from those without.

    - M, K: symmetric, (n, n); M positive semidefinite, K positive definite for the motions without inertia

    Raises UnusableError if they are not.
    """
    diagonal = np.diagonal(M)
    is_massless = ~M.any(axis=1)
    if (diagonal < 0.0).any() or (is_massless != (diagonal == 0.0)).any():
        raise _indefinite()
    q, r = np.flatnonzero(~is_massless), np.flatnonzero(is_massless)
    scale = 1.0 / np.sqrt(diagonal[q])
    inertial_block = M if not r.size else M[np.ix_(q, q)]
    scaled = inertial_block * (scale[:, None] * scale)
    T = N = None
    if not is_positive_definite(scaled):
        energies, directions = np.linalg.eigh(scaled)
        has_no_energy = energies < PIVOT_TOLERANCE * max(len(q), 10)
        if (energies < -PIVOT_TOLERANCE * max(len(q), 10)).any():
            raise _indefinite()
        directions *= scale[:, None]
        T, N = np.zeros((len(M), (~has_no_energy).sum())), np.zeros((len(M), has_no_energy.sum() + r.size))
        T[q], N[q, : has_no_energy.sum()] = directions[:, ~has_no_energy], directions[:, has_no_energy]
        N[r, np.arange(has_no_energy.sum(), N.shape[1])] = 1.0
    elif r.size:
        T, N = np.eye(len(M))[:, q], np.eye(len(M))[:, r]
    if T is None or N is None:
        return CondensedMatrices(M, K, None, None)
    if not T.shape[1]:
        raise UnusableError("expected some mass, found none", "M", "give the structure masses")
    KN = K @ N
    massless_stiffness = N.T @ KN
    pivots = np.diagonal(massless_stiffness).copy()
    if (pivots <= 0.0).any() or not is_positive_definite(
        massless_stiffness / np.sqrt(pivots[:, None] * pivots)
    ):
        problem = "expected stiffness for every coordinate without mass, found a motion that has neither"
        raise UnusableError(problem, "K", "give it a mass or a stiffness, or remove it")
    T = T - N @ linalg.solve(massless_stiffness, KN.T @ T, assume_a="pos")
    mass, stiffness = T.T @ M @ T, T.T @ K @ T
    return CondensedMatrices(0.5 * (mass + mass.T), 0.5 * (stiffness + stiffness.T), T, N)


def _indefinite() -> UnusableError:
    problem = "expected M positive definite except for motions without mass, found a negative kinetic energy"
    return UnusableError(problem, "M", "check the signs of the masses")


def is_positive_definite(scaled: Array) -> bool:
    """Return whether a matrix with a unit diagonal is positive definite by more than rounding."""
    try:
        factor = np.linalg.cholesky(scaled)
    except np.linalg.LinAlgError:
        return False
    return bool((np.diagonal(factor) ** 2 > PIVOT_TOLERANCE).all())


class SetupModes(NamedTuple):
    """All modes of one setup.

    - eigenvalues: (m,)
    - shapes: mass-normalised, (m, n)
    - massless: motions without inertia, (n, n - m), None if there are none
    """

    eigenvalues: Array
    shapes: Array
    massless: Array | None

    @property
    def size(self) -> int:
        """Memory [bytes]."""
        return sum(a.nbytes for a in self if a is not None)


def setup_modes(pair: MatrixPair, rigid: int) -> SetupModes:
    """Compute the modes.

    - pair: M and K of one setup
    - rigid: number of modes that may be motions without stiffness

    Raises UnusableError if M has a negative kinetic energy, or a motion has neither mass nor stiffness.
    Raises UnstableError if a mode is unstable.
    """
    condensed = condense(pair.M, pair.K)
    try:
        eigenvalues, shapes = (
            solution[0] for solution in generalised_eigh(condensed.M[None], condensed.K[None])
        )
    except np.linalg.LinAlgError as error:
        raise UnusableError(f"no modes: {error}", "M", "check the masses") from error
    # A structure that buckles does not vibrate: sqrt(|lambda|) would not be a frequency.
    lowest_eigenvalue = eigenvalues[rigid : rigid + 1].min(initial=np.inf)
    if (
        not np.isfinite(eigenvalues).all()
        or lowest_eigenvalue < -EIGENVALUE_TOLERANCE * np.abs(eigenvalues).max()
    ):
        problem = f"expected a stable structure, found the eigenvalue {lowest_eigenvalue:.6g} 1/s^2"
        remedy = "check the sign of K, and that rigid counts every free motion"
        raise UnstableError(problem, "K", remedy)
    return SetupModes(eigenvalues, shapes if condensed.T is None else shapes @ condensed.T.T, condensed.N)


def modal_forces(modes: SetupModes, changes: Sequence[MatrixPair | None]) -> tuple[Array, Array]:
    """Return (dK - lambda dM) phi, (T, m, n), and phi^T dM phi, (T, m), of each parameter; zero where it is None."""
    forces = np.zeros((len(changes), *modes.shapes.shape))
    norm = np.zeros(forces.shape[:2])
    for t, change in enumerate(changes):
        if change is not None:
            inertia = modes.shapes @ change.M
            forces[t] = modes.shapes @ change.K - modes.eigenvalues[:, None] * inertia
            norm[t] = (modes.shapes * inertia).sum(axis=1)
    return forces, norm


def differentiate_shapes(K: Array, modes: SetupModes, forces: Array, norm: Array) -> Array:
    """Differentiate the shapes.

    - K: (n, n)
    - forces, norm: from `modal_forces`, (T, m, n) and (T, m)

    Returns (T, m, n).
    """
    eigenvalues, shapes, N = modes
    rates: Array = modal_expansion(forces[None], norm[None], eigenvalues[None], shapes[None])[0] @ shapes
    if N is not None:
        rates -= np.swapaxes(np.linalg.solve(N.T @ K @ N, N.T @ np.swapaxes(forces, -1, -2)), -1, -2) @ N.T
    return rates
