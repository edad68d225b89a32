r"""Derivatives of mass-normalised mode shapes.

With :math:`f_i = (dK - \lambda_i dM) \phi_i`, the derivative of shape i has three parts: the known modes j,
:math:`\phi_j \phi_j^T f_i / (\lambda_i - \lambda_j)`; the remaining motions x, M-orthogonal to the known modes, which
solve :math:`(K - \lambda_i M) x = -f_i`; and the normalisation, :math:`-\phi_i \phi_i^T dM \phi_i / 2`.

If all modes are known, the remaining motions are those without inertia, :math:`x = -N (N^T K N)^{-1} N^T f_i`.
Otherwise the factor of :math:`K - \sigma M` that gave the modes suffices for all of them:
:math:`x = (K - \sigma M)^{-1} (-f_i + (\lambda_i - \sigma) M x)` is iterated, M-orthogonal to the known modes, and an
error in the direction of another mode j shrinks by :math:`(\lambda_i - \sigma) / (\lambda_j - \sigma)` in each step
(K. F. Alvin, Efficient computation of eigenvector sensitivities for structural dynamics, AIAA Journal, 1997).  If a
mode is too close to the unknown ones, the system is bordered by the known modes near it, which makes it regular
(R. B. Nelson, Simplified calculation of eigenvector derivatives, AIAA Journal 14 (1976), 1201-1205, here for several
modes at once).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy import linalg, sparse
from scipy.sparse import linalg as iterative

from pkmodes.diagnosis.problem import Array, Index
from pkmodes.diagnosis.structure.forms import is_sparse
from pkmodes.diagnosis.structure.modes import STABLE, Inverse, Modes
from pkmodes.diagnosis.structure.supplied import Pair

#: Smaller relative gaps of two eigenvalues are set to this: derivatives of a single mode are not defined there.
GAP = 1e-6
#: Modes within this relative distance are handled by the sum.
NEAR = 1e-2
#: The iteration is used if an error shrinks to this part or less in each step, until this part of it is left.
SHRINKS, LEFT = 0.5, 1e-14


class ShapeRates:
    """Derivatives of the shapes in all setups, computed for requested modes only.

    Parameters
    ----------
    setups : sequence of callable or None
        For each setup, a function that returns the derivatives (W, C, T) of some of its modes; None if it has none.
    shape : tuple of int
        Numbers of setups, modes, channels and parameters.
    """

    def __init__(
        self, setups: Sequence[Callable[[Index], Array] | None], shape: tuple[int, int, int, int]
    ) -> None:
        self._setups, self.shape = setups, shape
        self._known: dict[tuple[int, int], Array] = {}

    def __getitem__(self, at: tuple[Index, Index]) -> Array:
        setups, modes = np.broadcast_arrays(*at)
        pairs, place = np.unique(
            np.column_stack([setups.ravel(), modes.ravel()]), axis=0, return_inverse=True
        )
        wanted: dict[int, list[int]] = {}
        for setup, mode in pairs.tolist():
            if (setup, mode) not in self._known:
                wanted.setdefault(setup, []).append(mode)
        for setup, some in wanted.items():
            derive = self._setups[setup]
            rates = (
                np.full((len(some), *self.shape[2:]), np.nan) if derive is None else derive(np.array(some))
            )
            self._known |= {(setup, mode): one for mode, one in zip(some, rates, strict=True)}
        each = np.empty((len(pairs), *self.shape[2:]))
        for k, (setup, mode) in enumerate(pairs.tolist()):
            each[k] = self._known[setup, mode]
        return np.asarray(each[place.ravel()].reshape(*setups.shape, *self.shape[2:]))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        setups, modes = np.indices(self.shape[:2], dtype=np.intp)
        rates: Array = np.asarray(self[setups, modes], dtype=dtype)
        return rates


def eigenvalue_rates(modes: Modes, some: Index, changes: Sequence[Pair | None]) -> Array:
    """Differentiate some of the eigenvalues: phi^T (dK - lambda dM) phi, (W, T)."""
    forces, _ = _forces(modes, some, changes)
    rates: Array = np.einsum("tin,in->it", forces, modes.shapes[some])
    return rates


def shape_rates(pair: Pair, modes: Modes, some: Index, changes: Sequence[Pair | None]) -> Array:
    """Differentiate some of the shapes.

    Parameters
    ----------
    pair : Pair
        M and K.
    modes : Modes
        The known modes.
    some : ndarray of int, shape (W,)
        Modes whose shapes are differentiated.
    changes : sequence of Pair or None, length T
        Derivatives of M and K with respect to each parameter, None if zero.

    Returns
    -------
    ndarray, shape (W, n, T)
    """
    eigenvalues, shapes = modes.eigenvalues, modes.shapes
    forces, inertial = _forces(modes, some, changes)
    coupling = np.einsum("tin,jn->tij", forces, shapes, optimize=True)
    factors = coupling / _gaps(some, eigenvalues, modes.scale)
    factors[:, np.arange(len(some)), some] = 0.0
    derivatives = factors @ shapes
    if modes.complete:
        if modes.massless is not None:
            N = modes.massless
            held = linalg.solve(N.T @ (pair.K @ N), N.T @ forces.reshape(-1, len(N)).T)
            derivatives -= held.T.reshape(*forces.shape[:2], -1) @ N.T
    else:
        inertia = (pair.M @ shapes.T).T
        inverse = _inverse(pair, modes)
        shrinks = np.ones(len(some))
        if inverse is not None:
            shrinks = (eigenvalues[some] - inverse.shift) / (eigenvalues[-1] - inverse.shift)
            soon = shrinks <= SHRINKS
            right = coupling[:, soon] @ inertia - forces[:, soon]
            away = eigenvalues[some[soon]] - inverse.shift
            derivatives[:, soon] += _iterated(pair.M, inverse, away, shrinks[soon], right, shapes, inertia)
        for i in np.flatnonzero(shrinks > SHRINKS):
            apart = np.abs(eigenvalues - eigenvalues[some[i]])
            near = apart <= np.maximum(NEAR * np.abs(eigenvalues[some[i]]), STABLE * modes.scale)
            right = coupling[:, i, near] @ inertia[near] - forces[:, i]
            rest = _bordered(pair, eigenvalues[some[i]], inertia[near], right)
            derivatives[:, i] = rest + factors[:, i, near] @ shapes[near]
    derivatives -= 0.5 * inertial[..., None] * shapes[some]
    rates: Array = np.moveaxis(derivatives, 0, -1)
    return rates


def _forces(modes: Modes, some: Index, changes: Sequence[Pair | None]) -> tuple[Array, Array]:
    """Return (dK - lambda_i dM) phi_i, (T, W, n), and phi_i^T dM phi_i, (T, W)."""
    eigenvalues, phi = modes.eigenvalues[some], modes.shapes[some]
    forces, inertial = np.zeros((len(changes), *phi.shape)), np.zeros((len(changes), len(some)))
    for t, change in enumerate(changes):
        if change is not None:
            inertia = (change.M @ phi.T).T
            forces[t] = (change.K @ phi.T).T - eigenvalues[:, None] * inertia
            inertial[t] = (phi * inertia).sum(axis=1)
    return forces, inertial


def _gaps(of: Index, eigenvalues: Array, scale: float) -> Array:
    """Return lambda_i - lambda_j, bounded away from zero with its sign; for equal ones, the sign of their order."""
    some = eigenvalues[of]
    gaps = some[:, None] - eigenvalues
    largest = np.maximum(np.abs(some)[:, None], np.abs(eigenvalues))
    least = np.maximum(GAP * largest, STABLE * GAP * (scale or 1.0))
    order = np.sign(of[:, None] - np.arange(len(eigenvalues)))
    sign = np.where(gaps == 0.0, order, np.sign(gaps))
    return np.where(np.abs(gaps) < least, np.where(sign == 0.0, 1.0, sign) * least, gaps)


def _inverse(pair: Pair, modes: Modes) -> Inverse | None:
    """Return the inverse of K - sigma M that gave the modes, or another one; None if it is not definite."""
    if modes.inverse is not None or is_sparse(pair.K):
        return modes.inverse
    stiff = modes.eigenvalues[modes.eigenvalues > STABLE * modes.scale]
    shift = 0.0 if len(stiff) == len(modes.eigenvalues) else -0.5 * float(stiff.min(initial=np.inf))
    A = pair.K - shift * pair.M if np.isfinite(shift) else -pair.K
    if (A.diagonal() <= 0.0).any():
        return None
    scale = 1.0 / np.sqrt(A.diagonal())
    try:
        factor = linalg.cho_factor(A * (scale[:, None] * scale))
    except np.linalg.LinAlgError:
        return None

    def solve(right: Array) -> Array:
        solution: Array = scale[:, None] * linalg.cho_solve(factor, scale[:, None] * right)
        return solution

    return Inverse(shift, solve, A.nbytes)


def _iterated(
    M: Any, inverse: Inverse, away: Array, shrinks: Array, right: Array, shapes: Array, inertia: Array
) -> Array:
    """Solve (K - sigma M - away M) x = right for x that is M-orthogonal to the known modes, (T, W, n)."""
    # A step scales errors by factors from 0 to `shrinks`; relaxation centres this range on zero.
    relaxed = 2.0 / (2.0 - shrinks)
    steps = np.ceil(np.log(LEFT) / np.log(np.maximum(shrinks / (2.0 - shrinks), LEFT))).astype(int)
    x, n = np.zeros_like(right), right.shape[-1]
    for step in range(int(steps.max(initial=0))):
        going = np.flatnonzero(steps > step)
        now = x[:, going]
        inert = (M @ now.reshape(-1, n).T).T.reshape(now.shape)
        forces = right[:, going] + away[going, None] * inert
        ahead = inverse.solve(forces.reshape(-1, n).T).T.reshape(now.shape)
        ahead -= (ahead @ inertia.T) @ shapes
        x[:, going] = ahead if step == 0 else now + relaxed[going, None] * (ahead - now)
    return x


def _bordered(pair: Pair, eigenvalue: float, border: Array, right: Array) -> Array:
    """Solve (K - lambda M) x = right for x that is M-orthogonal to some modes, whose M phi is the border."""
    A = pair.K - eigenvalue * pair.M
    n, size = A.shape[0], np.abs(A.diagonal())
    scale = 1.0 / np.sqrt(np.where(size > 0.0, size, size.max()))
    border = border * scale
    border = border / np.linalg.norm(border, axis=1)[:, None]
    b = np.zeros((n + len(border), len(right)))
    b[:n] = (right * scale).T
    if is_sparse(A):
        scaling = sparse.diags_array(scale)
        edge: Any = sparse.csc_array(border)
        whole: Any = sparse.block_array([[scaling @ A @ scaling, edge.T], [edge, None]], format="csc")
        x = iterative.splu(whole).solve(b)
    else:
        whole = np.zeros((len(b), len(b)))
        whole[:n, :n], whole[:n, n:], whole[n:, :n] = A * (scale[:, None] * scale), border.T, border
        x = linalg.solve(whole, b, assume_a="sym")
    solution: Array = (x[:n] * scale[:, None]).T
    return solution
