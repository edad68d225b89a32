r"""Shapes and residual terms of known poles by the least-squares frequency-domain method (LSFD).

With shared participations L of the references (Peeters et al., Shock and Vibration 11, 2004, equation 16),

.. math:: H_{sr}(\omega) = (j \omega)^p \left( \sum_m \frac{\phi_{sm} L_{rm}}{j \omega - \lambda_m}
    + \frac{\bar\phi_{sm} \bar L_{rm}}{j \omega - \bar\lambda_m} + U_{sr} - \frac{D_{sr}}{\omega^2} \right)

where p is 0, 1 or 2 for displacement, velocity or acceleration, and the upper and lower residual terms U and D stand
for the modes above the band and below it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Residues(IdentifiedModes):
    """Modes with residual terms: shapes phi, which are those of the displacement, and participations L.

    - upper, lower: U and D, (S, R), NaN where not measured
    - derivative_order: p
    """

    upper: Complex
    lower: Complex
    derivative_order: int

    def response(self, frequencies: Array) -> Complex:
        """Return the synthesised functions, (F, S, R), at frequencies [Hz]."""
        w = 2.0 * math.pi * frequencies[:, None, None]
        total = super().response(frequencies) + self.upper - self.lower / w**2
        return np.asarray((1j * w) ** self.derivative_order * total)


def lsfd(
    frequencies: Array,
    H: Complex,
    weights: Array,
    poles: Complex,
    participations: Complex,
    derivative_order: int,
) -> Residues:
    """Fit shapes and residual terms.

    - frequencies: above 0, (F,) [Hz]
    - H: columns that were not measured are NaN, (F, S, R)
    - weights: inverse standard deviations of the lines, (F, S)
    - poles: (N,) [1/s]
    - participations: participations, at any scale, (N, R)
    - derivative_order: p

    References
    ----------
    Peeters et al. 2004, equation 16.
    """
    (F, S, R), N = H.shape, len(poles)
    s: Complex = np.asarray(2j * math.pi * frequencies, dtype=complex)
    derivative: Complex = np.asarray(s**derivative_order, dtype=complex)
    pole_terms, conjugate_terms = (derivative[:, None] / (s[:, None] - p) for p in (poles, poles.conj()))
    shapes = np.full((N, S), np.nan, complex)
    upper, lower = np.full((S, R), np.nan, complex), np.full((S, R), np.nan, complex)
    for o in range(S):
        measured = np.flatnonzero(np.isfinite(H[:, o]).all(axis=0))
        if not measured.size:
            continue
        direct = pole_terms[:, None] * participations[:, measured].T
        conjugate = conjugate_terms[:, None] * participations[:, measured].T.conj()
        # Columns of the real and imaginary parts of the shape.
        shape_columns = np.concatenate([direct + conjugate, 1j * (direct - conjugate)], axis=2)
        residual_columns = np.zeros((F, measured.size, measured.size, 4), complex)
        index = np.arange(measured.size)
        residual_columns[:, index, index] = _residual_columns(derivative, s)[:, None]
        A = (
            np.concatenate([shape_columns, residual_columns.reshape(F, measured.size, -1)], axis=2)
            * weights[:, o, None, None]
        )
        solution = _least_squares(
            A.reshape(F * measured.size, -1), (H[:, o, measured] * weights[:, o, None]).ravel()
        )
        shapes[:, o] = solution[:N] + 1j * solution[N : 2 * N]
        residual_terms = solution[2 * N :].reshape(measured.size, 4)
        upper[o, measured] = residual_terms[:, 0] + 1j * residual_terms[:, 1]
        lower[o, measured] = residual_terms[:, 2] + 1j * residual_terms[:, 3]
    return Residues(poles, shapes, participations, upper, lower, derivative_order)


def fit_residual_terms(
    frequencies: Array, H: Complex, weights: Array, modes: IdentifiedModes, derivative_order: int
) -> Residues:
    """Fit the residual terms alone, to known modes of the displacement; see `lsfd`."""
    s: Complex = np.asarray(2j * math.pi * frequencies, dtype=complex)
    derivative: Complex = np.asarray(s**derivative_order, dtype=complex)
    remainder = H - derivative[:, None, None] * modes.response(frequencies)
    columns = _residual_columns(derivative, s)[:, [0, 2]]
    upper, lower = np.full(H.shape[1:], np.nan, complex), np.full(H.shape[1:], np.nan, complex)
    for o in range(H.shape[1]):
        measured = np.isfinite(H[:, o]).all(axis=0)
        if not measured.any():
            continue
        A = columns * weights[:, o, None]
        column_norms = np.linalg.norm(A, axis=0)
        solution = np.linalg.lstsq(
            A / column_norms, remainder[:, o, measured] * weights[:, o, None], rcond=None
        )[0]
        upper[o, measured], lower[o, measured] = solution / column_norms[:, None]
    return Residues(modes.poles, modes.shapes, modes.participation, upper, lower, derivative_order)


def _residual_columns(derivative: Complex, s: Complex) -> Complex:
    """Return the columns of the real and imaginary parts of U and D, (F, 4)."""
    upper, lower = derivative, derivative / s**2  # -1/omega^2 is 1/s^2
    return np.stack([upper, 1j * upper, lower, 1j * lower], axis=1)


def _least_squares(A: NDArray[Any], b: NDArray[Any]) -> Array:
    """Return the real solution of complex equations."""
    stacked = np.concatenate([A.real, A.imag])
    column_norms = np.linalg.norm(stacked, axis=0)
    column_norms = np.where(column_norms > 0.0, column_norms, 1.0)
    solution = np.linalg.lstsq(stacked / column_norms, np.concatenate([b.real, b.imag]), rcond=1e-12)[0]
    return np.asarray(solution / column_norms)
