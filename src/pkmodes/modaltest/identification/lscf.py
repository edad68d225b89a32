r"""Poles of frequency responses by the polyreference least-squares complex frequency-domain method (PolyMAX).

Guillaume, Verboven, Vanlanduit, Van der Auweraer and Peeters, IMAC XXI, 2003; Peeters, Van der Auweraer, Guillaume
and Leuridan, Shock and Vibration 11, 2004, equations 3 to 14.  The responses are a right matrix fraction,

.. math:: H_o(f)\, A(z) = B_o(z), \qquad A(z) = \sum_{i=0}^n A_i z^i, \quad z = e^{2 \pi j T (f - f_0)},

linear in its coefficients.  Those of each output are eliminated, which leaves the normal equations of A.  All sums
over the lines are of powers of z, thus Toeplitz: each is computed once, for all orders.

The band is mapped to most of the unit circle, which keeps high orders well conditioned wherever the band begins.  A
band that does not begin at 0 has no symmetry about its first line, and its coefficients are complex: conjugate poles
would be assumed where there are none.  A_0 = 1 moves the roots that only fit noise out of the unit circle
(Cauberghe, Guillaume, Verboven, Vanlanduit and Parloo, Mechanical Systems and Signal Processing 19, 2005), so that
they show negative damping.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import toeplitz

from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Fraction of the unit circle that the band covers: the rest keeps its two ends apart.
COVERED_SHARE = 0.9
#: Regularisation relative to the mean of the diagonal: below the rounding of the sums of any measurement, above that
#: of exact functions.
RIDGE = 1e-13


@dataclass(frozen=True, eq=False)
class OrderPoles(IdentifiedModes):
    """Poles of one model order n, also unstable ones and those outside the band, with shapes at any scale."""

    order: int


def lscf(frequencies: Array, H: Complex, weights: Array, orders: Sequence[int]) -> list[OrderPoles]:
    """Return the poles of several model orders.

    - frequencies: ascending, even or not, (F,) [Hz]
    - H: finite, (F, S, R)
    - weights: weights of each output's lines, (F, S): the inverse of the standard deviation of their noise
    - orders: each at least 1; order n has n R poles

    References
    ----------
    Peeters et al. 2004.
    """
    F, S, R = H.shape
    low, high = float(frequencies[0]), float(frequencies[-1])
    step = COVERED_SHARE / (high - low)
    max_order = max(orders)
    z = np.exp(2j * math.pi * step * (frequencies - low))
    positive_powers = z[:, None] ** np.arange(max_order + 1)
    powers = np.concatenate([positive_powers[:, :0:-1].conj(), positive_powers], axis=1)
    squares = weights[:, :, None] ** 2
    products = (H[..., :, None].conj() * H[..., None, :]).reshape(F, S, R * R)
    data = np.concatenate([squares, squares * H, squares * products], axis=2)
    # The sums over the lines of w^2 z^k (1, H_r, conj(H_q) H_r), (2 n + 1, S, 1 + R + R R), k from -n.
    sums = (powers.T @ data.reshape(F, -1)).reshape(2 * max_order + 1, S, -1)
    return [_poles_of_order(sums, n, S, R, step, low) for n in orders]


def _poles_of_order(sums: Complex, n: int, S: int, R: int, step: float, low: float) -> OrderPoles:
    max_order = len(sums) // 2
    lags = sums[max_order - n : max_order + n + 1]

    def toeplitz_matrix(column: Complex) -> Complex:
        return np.asarray(toeplitz(column[n::-1], column[n:]))  # entry (i, j) is the sum of z^(j - i)

    size = (n + 1) * R
    M = np.zeros((n + 1, R, n + 1, R), complex)
    numerators = np.empty((S, n + 1, size), complex)
    for o in range(S):
        X = toeplitz_matrix(lags[:, o, 0])
        X[np.diag_indices(n + 1)] += RIDGE * X[0, 0].real
        Y = np.stack([toeplitz_matrix(lags[:, o, 1 + r]) for r in range(R)], axis=2).reshape(n + 1, size)
        numerators[o] = np.linalg.solve(X, Y)  # the numerator is this times the denominator
        M -= (Y.conj().T @ numerators[o]).reshape(n + 1, R, n + 1, R)
    total = lags[:, :, 1 + R :].sum(axis=1)
    for q in range(R):
        for r in range(R):
            M[:, q, :, r] += toeplitz_matrix(total[:, q * R + r])
    normal = M.reshape(size, size)
    block = normal[R:, R:].copy()
    block[np.diag_indices(n * R)] += RIDGE * float(np.trace(normal).real) / size
    coefficients = -np.linalg.solve(block, normal[R:, :R])
    # The denominator that makes the sum of squares least, with A_0 = 1, (n + 1, R, R).
    A = np.concatenate([np.eye(R, dtype=complex)[None], coefficients.reshape(n, R, R)])
    inverse, vectors = _roots(A)
    z = 1.0 / inverse
    angle = np.mod(np.angle(z) + math.pi * (1.0 - COVERED_SHARE), 2.0 * math.pi) - math.pi * (
        1.0 - COVERED_SHARE
    )
    poles = (np.log(np.abs(z)) + 1j * angle) / step + 2j * math.pi * low
    # z^i / z^n, (P, n + 1), so that roots inside the circle stay finite.
    scaled = inverse[:, None] ** np.arange(n, -1, -1)
    scaled /= np.abs(scaled).max(axis=1, keepdims=True)
    products = (numerators.reshape(S * (n + 1), size) @ A.reshape(size, R)).reshape(S, n + 1, R)
    at_pole = np.einsum("pi,oir->por", scaled, products)
    shapes = np.einsum("por,pr->po", at_pole, vectors)
    left_vectors = np.linalg.svd(np.einsum("pi,iqr->pqr", scaled, A))[0][:, :, -1]
    return OrderPoles(poles, shapes, left_vectors.conj(), n)


def _roots(A: Complex) -> tuple[Complex, Complex]:
    """Return the inverse roots 1/z of det A(z) = 0, (n R,), and v with A(z) v = 0, (n R, R)."""
    n, R = len(A) - 1, A.shape[1]
    companion = np.zeros((n * R, n * R), complex)
    companion[:R] = -A[1:].transpose(1, 0, 2).reshape(R, n * R)
    companion[R:, :-R] = np.eye((n - 1) * R)
    values, vectors = np.linalg.eig(companion)
    finite = np.abs(values) > 1e-8  # a root at infinity has no frequency
    first = vectors[:R, finite].T  # inverse^(n - 1) v, the largest block of the roots inside the circle
    return values[finite], first / np.maximum(np.linalg.norm(first, axis=1, keepdims=True), 1e-300)
