r"""Covariance-driven stochastic subspace identification (SSI) in a part of the band.

Peeters and De Roeck (Mechanical Systems and Signal Processing 13(6), 1999).  With white excitation, the correlation
functions of the responses are sums of the modes' free decays,

.. math:: R(\tau) = E\, y(t + \tau)\, y(t)^H = \sum_i \psi_i \lambda_i^\tau g_i^T , \qquad \tau > 0 .

Their block Hankel matrix is a product O Z.  The shift of the observability matrix O by a block row is the state
matrix A, whose eigenvalues are the lambda_i, and whose eigenvectors give the shapes psi_i from the first block row.
One singular value decomposition gives O in all model orders.

The correlation functions are those of the analytic signal of a narrow part of the band, moved to low frequency (see
`pkmodes.modaltest.identification.ssi_bands`): the lags then span many periods of a mode with few block rows, and a
mode is one pole.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Subspace:
    """The range of a block Hankel matrix of correlations.

    - left: observability matrix of the largest order n, whose first columns are those of lower orders, ((q + 1) S, n)
    - right: left = Hankel matrix @ right, (q r, n)
    - sensors: S
    """

    left: Complex
    right: Complex
    sensors: int


@dataclass(frozen=True, eq=False)
class OrderModes:
    """The modes of one model order n, before any choice among them.

    - values: eigenvalues lambda of the state matrix, (n,)
    - shapes: (S, n)
    - rows: left eigenvectors of the state matrix times the pseudo-inverse of the upper observability matrix, (n, q S)
    - columns: right factor of the Hankel matrix times the eigenvectors, (q r, n): see
      `pkmodes.modaltest.identification.ssi_uncertainty`
    """

    values: Complex
    shapes: Complex
    rows: Complex
    columns: Complex


def hankel(correlations: Complex, blocks: int) -> Complex:
    """Return the block Hankel matrix ((q + 1) S, q r) of correlations at successive lags.

    - correlations: correlations of S responses with r references, (2 q, S, r)
    - blocks: q
    """
    lag_index = np.arange(blocks + 1)[:, None] + np.arange(blocks)[None, :]
    _, S, r = correlations.shape
    return np.asarray(correlations[lag_index].transpose(0, 2, 1, 3).reshape((blocks + 1) * S, blocks * r))


def subspace(correlations: Complex, blocks: int, max_order: int) -> Subspace:
    """Return the range of the Hankel matrix.

    - correlations: (2 q, S, r)
    - blocks: q
    - max_order: largest model order
    """
    U, values, Vh = np.linalg.svd(hankel(correlations, blocks), full_matrices=False)
    rank = min(max_order, int((values > 1e-12 * values[0]).sum()))
    root = np.sqrt(values[:rank])
    return Subspace(U[:, :rank] * root, Vh[:rank].conj().T / root, correlations.shape[1])


def modes_of_order(space: Subspace, n: int) -> OrderModes:
    """Return the modes of model order n."""
    observability, S = space.left[:, :n], space.sensors
    upper = np.linalg.pinv(observability[:-S])
    values, vectors = np.linalg.eig(upper @ observability[S:])
    rows = np.asarray(np.linalg.solve(vectors, upper), dtype=complex)
    return OrderModes(values, observability[:S] @ vectors, rows, space.right[:, :n] @ vectors)
