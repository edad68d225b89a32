r"""Frequency responses from one decomposition, instead of a linear system for every frequency.

.. math:: H(\omega) = l \, (Z + i \omega D - \omega^2)^{-1} \, b

with symmetric complex Z and real D of size m, in modal coordinates.  Modes that nothing couples are summed one by
one; for coupled ones the poles s_k of the first-order form give :math:`H = \sum_k R_k / (i \omega - s_k)`.  Fast
modes take digits from slow ones: one step of iterative refinement gives them back, and modes beyond all frequencies,
such as those of a stiff joint, follow statically.  Where the poles have no independent vectors, or nearly none
(critical damping), the linear systems are solved after all.
Reference: Ewins, Modal Testing, 2nd edition, section 2.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Entries off the diagonal below this fraction of the geometric mean of those on it couple nothing.
COUPLED = 1e-13
#: Largest condition number of the vectors of the poles.
INDEPENDENT = 1e4
#: A mode follows statically if omega^2 is below this fraction of its eigenvalue, and damping is a small correction,
STATIC = 1e-14
#: below this fraction of the elastic force.
NEARLY_STATIC = 1e-8
#: Ratio of the fastest to the slowest mode from which the responses are refined.
WIDE = 500.0
#: Steps of refinement.
REFINED = 1


def receptance(Z: Complex, D: Array, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    """Return H, (F, outputs, inputs).

    Parameters
    ----------
    Z, D : ndarray, shape (m, m)
    b : ndarray, shape (m, inputs)
    l : ndarray, shape (outputs, m)
    omega : ndarray, shape (F,)
        Angular frequencies [rad/s].
    """
    coupled = (_coupling(Z) | _coupling(D)).any(axis=1)
    uncoupled, some = np.flatnonzero(~coupled), np.flatnonzero(coupled)
    z, d = np.diagonal(Z)[uncoupled], np.diagonal(D)[uncoupled]
    with np.errstate(divide="ignore", invalid="ignore"):  # infinite at a resonance without damping
        gain = 1.0 / (z + 1j * omega[:, None] * d - omega[:, None] ** 2)
        H = _summed(gain, l[:, uncoupled], b[uncoupled])
    if len(some):
        H = H + _of_coupled(Z[np.ix_(some, some)], D[np.ix_(some, some)], b[some], l[:, some], omega)
    return H


def _coupling(matrix: NDArray[np.generic]) -> NDArray[np.bool_]:
    size = np.abs(matrix)
    root = np.sqrt(np.diagonal(size))
    off = size > COUPLED * root[:, None] * root
    np.fill_diagonal(off, False)
    return np.asarray(off | off.T)


def _summed(gain: Any, l: Any, b: Any) -> Complex:  # noqa: E741
    """Return sum_k l_k b_k gain_k, (F, outputs, inputs)."""
    outputs, inputs = len(l), b.shape[1]
    residues = (l.T[:, :, None] * b[:, None, :]).reshape(len(b), outputs * inputs)
    summed: Complex = (gain @ residues).reshape(len(gain), outputs, inputs)
    return summed


def _of_coupled(Z: Complex, D: Any, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    size, highest = np.abs(np.diagonal(Z)), omega.max(initial=0.0)
    fast = (highest**2 <= STATIC * size) & (highest * np.diagonal(D) <= NEARLY_STATIC * size)
    if not fast.any() or fast.all():
        return _of_poles(Z, D, b, l, omega)
    f, s = ~fast, fast
    root = np.sqrt(size[s])  # of all sizes: each is a scale of its own
    scaled = Z[np.ix_(s, s)] / root[:, None] / root
    by_slow, by_forces = (
        np.linalg.solve(scaled, part / root[:, None]) / root[:, None] for part in (Z[np.ix_(s, f)], b[s])
    )
    damping = D[np.ix_(f, s)] @ by_slow
    H = _of_poles(
        Z[np.ix_(f, f)] - Z[np.ix_(f, s)] @ by_slow,
        D[np.ix_(f, f)] - damping - damping.T + by_slow.T @ D[np.ix_(s, s)] @ by_slow,
        b[f] - by_slow.T @ b[s],
        l[:, f] - l[:, s] @ by_slow,
        omega,
    )
    late = np.linalg.solve(scaled, (D[np.ix_(s, s)] @ by_forces) / root[:, None]) / root[:, None]
    return np.asarray(H + l[:, s] @ by_forces - 1j * omega[:, None, None] * (l[:, s] @ late))


def _of_poles(Z: Complex, D: Any, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    m = len(D)
    slowest = omega[omega > 0.0].min(initial=np.inf)
    size = np.sqrt(np.abs(np.diagonal(Z)))
    size = np.maximum(size, np.where(np.isfinite(slowest), slowest, size.max()))
    A = np.zeros((2 * m, 2 * m), dtype=complex)
    A[:m, m:] = np.diag(size)  # the states are size * eta and eta_dot
    A[m:, :m] = -Z / size
    A[m:, m:] = -D
    poles, V = _eig(A)
    if np.linalg.cond(V) > INDEPENDENT:
        dynamic = Z + 1j * omega[:, None, None] * D - omega[:, None, None] ** 2 * np.eye(m)
        return np.asarray(l @ np.linalg.solve(dynamic, np.broadcast_to(b, (len(omega), *b.shape))))
    begin = np.linalg.inv(V)[:, m:]
    shapes = V[:m] / size[:, None]
    if size.max() <= WIDE * size.min():
        return _summed(1.0 / (1j * omega[:, None] - poles), l @ shapes, begin @ b)
    gain = (1.0 / (1j * omega - poles[:, None]))[:, None, :]  # 2m, 1, F
    X = _through(shapes, gain, (begin @ b)[:, :, None])  # m, inputs, F
    for _ in range(REFINED):
        flat = X.reshape(m, -1)
        left = (
            b[:, :, None]
            - (Z @ flat).reshape(X.shape)
            - 1j * omega * (D @ flat).reshape(X.shape)
            + omega**2 * X
        )
        X = X + _through(shapes, gain, (begin @ left.reshape(m, -1)).reshape(2 * m, *X.shape[1:]))
    H = (l @ X.reshape(m, -1)).reshape(len(l), *X.shape[1:])
    return np.ascontiguousarray(np.moveaxis(H, -1, 0))


def _through(shapes: Complex, gain: Complex, driven: Complex) -> Complex:
    """Return how the modes answer forces on the poles, (m, inputs, F)."""
    answers = gain * driven
    found: Complex = (shapes @ answers.reshape(len(answers), -1)).reshape(len(shapes), *answers.shape[1:])
    return found


def _eig(A: Complex) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors, found in mixed coordinates.

    LAPACK scales rows and columns first, which spoils matrices with entries that are nothing but rounding, such as
    the stiffness of a rigid mode; where all entries are of one size it has nothing to scale.
    """
    n = len(A)
    v = np.cos(np.arange(n, dtype=float) ** 2 + 1.0)
    mixing = np.eye(n) - 2.0 * np.outer(v, v) / (v @ v)  # a reflection
    values, vectors = np.linalg.eig(mixing @ A @ mixing)
    return values, mixing @ vectors
