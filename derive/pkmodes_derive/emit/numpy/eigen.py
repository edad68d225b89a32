"""Statuses and modes of a robot, batch first: the functions below are copied into its module.

They are NumPy code, which the derivation does not import.
"""

import numpy as np

#: Components of a shape that differ from the largest by less than this fraction count as equal to it.
_TIE = 1e-6
#: Below this fraction of the largest eigenvalue, rounding leaves the frequency of a vibration fewer than six digits.
_RESOLVED = 1e-9


def _first_violated(p, margins):
    """Return the status of poses: 0, 1 where they are not finite, or 2 and more for the first margin violated.

    Parameters
    ----------
    p : array, shape (..., d)
    margins : sequence of (values, comparison, bound)
        In order; values of shape (...), or with further axes on which all must hold.
    """
    found = np.where(np.isfinite(p).all(axis=-1), 0, 1)
    for number, (values, holds, bound) in enumerate(margins, start=2):
        compared = np.asarray(holds(values, bound))
        kept = compared.all(axis=tuple(range(p.ndim - 1, compared.ndim)))
        found = np.where((found == 0) & ~kept, number, found)
    return found[()]


def _solved(M, K):
    """Solve K phi = lambda M phi: M is scaled to a unit diagonal and factored (Cholesky).

    Returns
    -------
    eigenvalues : array, shape (..., n)
        Ascending.
    shapes : array, shape (..., n, n)
        Row i is mode i, phi^T M phi = 1; in units of the scale, the first of its largest components is positive.
    """
    scale = 1.0 / np.sqrt(np.diagonal(M, axis1=-2, axis2=-1))
    both = scale[..., :, None] * scale[..., None, :]
    inverse = np.linalg.inv(np.linalg.cholesky(M * both))
    standard = inverse @ (K * both) @ np.swapaxes(inverse, -1, -2)
    eigenvalues, y = np.linalg.eigh(0.5 * (standard + np.swapaxes(standard, -1, -2)))
    shapes = np.swapaxes(y, -1, -2) @ inverse
    size = np.abs(shapes)
    first = np.argmax(size >= (1.0 - _TIE) * size.max(axis=-1, keepdims=True), axis=-1)
    signs = np.sign(np.take_along_axis(shapes, first[..., None], axis=-1))
    return eigenvalues, shapes * signs * scale[..., None, :]


def _modes(p, status, matrices, vibration):
    """Return frequencies and shapes at poses; NaN where their status is not 0.

    Parameters
    ----------
    p : array, shape (..., d)
    status : array of int, shape (...)
    matrices : callable
        Mass and stiffness matrices at poses.
    vibration : int
        The first mode that is no rigid-body mode.
    """
    valid = status == 0
    eigenvalues, shapes = _solved(*matrices(p[valid]))
    n, size = eigenvalues.shape[-1], np.abs(eigenvalues)
    if (size[:, vibration:] < _RESOLVED * size[:, -1:]).any():
        raise np.linalg.LinAlgError(
            "a vibration is lost in rounding: the magnitudes of the robot differ too much"
        )
    f, phi = np.full((*valid.shape, n), np.nan), np.full((*valid.shape, n, n), np.nan)
    f[valid] = np.copysign(np.sqrt(np.abs(eigenvalues)), eigenvalues) / (2.0 * np.pi)
    phi[valid] = shapes
    return f, phi
