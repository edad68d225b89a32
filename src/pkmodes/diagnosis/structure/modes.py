"""The lowest modes of K phi = lambda M phi, for matrices that may be large, and M that may be singular.

Small or dense matrices are solved by LAPACK, large sparse ones by shift-invert Lanczos (ARPACK).  The Lanczos result
is refined by one Rayleigh-Ritz step, and accepted only if Sylvester's law of inertia counts as many eigenvalues below
the highest: Lanczos may miss one of several coincident eigenvalues.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy import linalg, sparse
from scipy.sparse import linalg as iterative

from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.structure.forms import is_sparse
from pkmodes.diagnosis.structure.massless import SINGULAR, UnstableError, UnusableError, condense, definite
from pkmodes.diagnosis.structure.supplied import Pair

#: If more than this fraction of the modes is needed, all are computed: that is then cheaper.
PART = 0.3
#: Eigenvalues below zero by less than this fraction of the largest are zero up to rounding.
STABLE = 1e-9
#: Largest relative residual of a Lanczos mode due to rounding.
RESIDUAL = 1e-8


class Inverse(NamedTuple):
    """The inverse of K - shift M.

    Attributes
    ----------
    solve : callable
        Multiplies the inverse with an array (n, k).
    size : int
        Memory [bytes].
    """

    shift: float
    solve: Callable[[Array], Array]
    size: int


class Modes(NamedTuple):
    """Lowest modes of one setup.

    Attributes
    ----------
    eigenvalues : ndarray, shape (m,)
    shapes : ndarray, shape (m, n)
        Mass-normalised.
    massless : ndarray, shape (n, z), or None
        Motions without inertia, if known.
    complete : bool
        Whether these modes and `massless` span all motions.
    scale : float
        Order of magnitude of the largest eigenvalue.
    inverse : Inverse or None
        The inverse from which the modes were computed, if any.
    """

    eigenvalues: Array
    shapes: Array
    massless: Array | None
    complete: bool
    scale: float
    inverse: Inverse | None = None

    @property
    def size(self) -> int:
        """Memory [bytes]."""
        arrays = (self.eigenvalues, self.shapes, self.massless)
        return sum(a.nbytes for a in arrays if a is not None) + (self.inverse.size if self.inverse else 0)


def lowest_modes(pair: Pair, count: int, rigid: int) -> Modes:
    """Compute the lowest modes.

    Parameters
    ----------
    pair : Pair
        M and K of one setup.
    count : int
        Number of modes; fewer are returned if the matrices have fewer.
    rigid : int
        Number of modes that may be motions without stiffness.

    Raises
    ------
    UnusableError
        If M has a negative kinetic energy, or a motion has neither mass nor stiffness.
    UnstableError
        If a mode is unstable.
    """
    modes = None
    if is_sparse(pair.K):
        if count <= PART * np.count_nonzero(pair.M.diagonal()):
            modes = _by_lanczos(pair, count, rigid)
        if modes is None:
            pair = Pair(pair.M.toarray(), pair.K.toarray())
    if modes is None:
        modes = _by_lapack(pair, count, rigid)
    # A structure that buckles does not vibrate: sqrt(|lambda|) would not be a frequency.
    lowest = modes.eigenvalues[rigid : rigid + 1].min(initial=np.inf)
    if not np.isfinite(modes.eigenvalues).all() or lowest < -STABLE * modes.scale:
        what = f"expected a stable structure, found the eigenvalue {lowest:.6g} 1/s^2"
        remedy = "check the sign of K, and that rigid counts every free motion"
        raise UnstableError(what, "K", remedy)
    return modes


def modes_below(pair: Pair, limit: float) -> int:
    """Return the number of eigenvalues below a limit [1/s^2], by Sylvester's law of inertia."""
    if is_sparse(pair.K):
        factor = _Factor(pair.K - limit * pair.M)
        if factor.negative is not None:
            return factor.negative
        pair = Pair(pair.M.toarray(), pair.K.toarray())
    _, blocks, _ = linalg.ldl(pair.K - limit * pair.M)
    return int((np.linalg.eigvalsh(blocks) < 0.0).sum())


def _by_lapack(pair: Pair, count: int, rigid: int) -> Modes:
    part = condense(pair.M, pair.K)
    n = len(part.M)
    try:
        if count > PART * n:
            eigenvalues, shapes = (solution[0] for solution in generalised_eigh(part.M[None], part.K[None]))
            eigenvalues, shapes, complete = eigenvalues[:count], shapes[:count], count >= n
            scale = float(np.abs(eigenvalues).max())
        else:
            (eigenvalues, shapes), complete = _part(part.M, part.K, count, rigid), False
            scale = float(np.abs(np.diagonal(part.K) / np.diagonal(part.M)).max())
    except np.linalg.LinAlgError as error:
        raise UnusableError(f"no modes: {error}", "M", "check the masses") from error
    if part.T is not None:
        shapes = shapes @ part.T.T
    return Modes(eigenvalues, shapes, part.N, complete, scale)


def _part(M: Array, K: Array, count: int, rigid: int) -> tuple[Array, Array]:
    """Return the lowest modes of dense matrices."""
    n = len(M)
    # If K can be factorised, the lowest modes are most accurate as the largest eigenvalues of M phi = mu K phi.
    diagonal = np.diagonal(K)
    if not rigid and (diagonal > 0.0).all():
        scale = 1.0 / np.sqrt(diagonal)
        scaled = K * (scale[:, None] * scale)
        if definite(scaled):
            both = scale[:, None] * scale
            inverses, shapes = linalg.eigh(M * both, scaled, subset_by_index=(n - count, n - 1))
            if (inverses > 0.0).all():
                return 1.0 / inverses[::-1], ((shapes * scale[:, None]) / np.sqrt(inverses)).T[::-1]
    scale = 1.0 / np.sqrt(np.diagonal(M))  # removes mixed units before M is factorised
    both = scale[:, None] * scale
    eigenvalues, shapes = linalg.eigh(K * both, M * both, subset_by_index=(0, count - 1))
    return eigenvalues, (shapes * scale[:, None]).T


class _Factor:
    """L D L^T of a sparse symmetric matrix, scaled to a unit diagonal, without pivoting.

    Attributes
    ----------
    negative : int or None
        Number of negative eigenvalues; None if the factor is not reliable.
    size : int
        Memory [bytes].
    """

    def __init__(self, A: Any) -> None:
        diagonal = np.abs(A.diagonal())
        self.scale = 1.0 / np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
        scaling = sparse.diags_array(self.scale)
        self.negative: int | None = None
        self.size = 0
        try:
            self.factor = iterative.splu(
                sparse.csc_matrix(scaling @ A @ scaling),
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # exactly singular
            return
        self.size = 12 * self.factor.nnz  # a number and an index of four bytes each
        pivots = self.factor.U.diagonal()
        if (self.factor.perm_r == self.factor.perm_c).all() and (np.abs(pivots) > SINGULAR).all():
            self.negative = int((pivots < 0.0).sum())

    def solve(self, right: Array) -> Array:
        scale = self.scale if right.ndim == 1 else self.scale[:, None]
        solution: Array = scale * self.factor.solve(scale * right)
        return solution


def _by_lanczos(pair: Pair, count: int, rigid: int) -> Modes | None:
    """Return the lowest modes of sparse matrices; None if LAPACK is needed."""
    M, K = pair
    diagonal = M.diagonal()
    moving = diagonal > 0.0
    if (diagonal < 0.0).any() or not moving.any():
        return None
    scale = float(np.abs(K.diagonal()[moving] / diagonal[moving]).max())
    shift, factor = 0.0, _Factor(K)
    if rigid or factor.negative != 0:
        shift = -STABLE * scale
        factor = _Factor(K - shift * M)
        if factor.negative != 0:
            return None
    start = np.random.default_rng(0).standard_normal(K.shape[0])
    if rigid:  # between the rigid and the elastic modes, so that neither dominates
        near = _lanczos(M, shift, factor, rigid + 1, start)
        if near is None:
            return None
        shift = -0.5 * float(np.abs(near[0]).max())
        factor = _Factor(K - shift * M)
        if factor.negative != 0:
            return None
    # One more than requested shows whether there is a gap above them.
    lowest = _lanczos(M, shift, factor, count + 1, start)
    if lowest is None:
        return None
    basis = lowest[1] / np.abs(lowest[1]).max(axis=0)
    try:
        eigenvalues, mixed = linalg.eigh(basis.T @ (K @ basis), basis.T @ (M @ basis))
    except np.linalg.LinAlgError:
        return None
    shapes = (basis @ mixed).T
    inertia = (M @ shapes.T).T
    forces = (K @ shapes.T).T
    apart = np.linalg.norm((forces - eigenvalues[:, None] * inertia)[:count], axis=1)
    size = np.linalg.norm(np.abs(K) @ np.abs(shapes[:count].T), axis=0)
    if not (apart <= RESIDUAL * size).all() or not _none_missed(pair, eigenvalues, count):
        return None
    return Modes(
        eigenvalues[:count], shapes[:count], None, False, scale, Inverse(shift, factor.solve, factor.size)
    )


def _lanczos(M: Any, shift: float, factor: _Factor, count: int, start: Array) -> tuple[Array, Array] | None:
    n = M.shape[0]
    inverse = iterative.LinearOperator((n, n), matvec=factor.solve, dtype=float)
    stiffness = iterative.LinearOperator((n, n), matvec=lambda x: x, dtype=float)  # only its shape is used
    # In the start vector, and so in all iterates, motions without inertia only follow the others.
    with contextlib.suppress(iterative.ArpackError):
        eigenvalues, shapes = iterative.eigsh(
            stiffness, count, M, sigma=shift, OPinv=inverse, v0=factor.solve(M @ start)
        )
        return eigenvalues, shapes
    return None


def _none_missed(pair: Pair, eigenvalues: Array, count: int) -> bool:
    """Return whether the number of eigenvalues below the middle of the last gap is that of those found."""
    gaps = np.diff(eigenvalues)
    wide = np.flatnonzero(gaps > 1e-6 * np.abs(eigenvalues[1:]))
    if not wide.size:
        return False
    # The highest gap among those found: coincident eigenvalues at the end cannot be counted separately.
    last = int(wide[-1])
    below = _Factor(pair.K - 0.5 * (eigenvalues[last] + eigenvalues[last + 1]) * pair.M).negative
    return below == last + 1
