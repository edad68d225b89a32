r"""Uncertainty of fitted modes: the covariance of poles and shapes.

Least squares of a model with Jacobian J and weights W has

.. math:: \operatorname{cov} = (J^H W J)^{-1}\, J^H W V W J\, (J^H W J)^{-1}

where V is the covariance of the data, which need not be the inverse of W (the sandwich estimator: White,
Econometrica 50, 1982).  V is taken as the product of the correlation between lines, common to the band, and the
covariance between channels, from the residual in the window, which holds model errors as well as noise.  Estimated
parameters are circular: half of the variance is that of each real part.

The residual of one reference cannot show the scatter of the poles between references.  A mode whose pole differs
between references, since the structure or its sensors have changed in between, leaves each reference with a good fit
of its own.  Poles are therefore fitted for each reference alone as well.  Scatter that their fits do not
explain, pooled over all modes relative to frequency as there are only two or three references, is a variance between
references (Paule and Mandel, Journal of Research of the National Bureau of Standards 87, 1982).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

from pkmodes.modaltest.identification.frf_noise import apply_correlation
from pkmodes.modaltest.identification.frf_polish import (
    Window,
    WindowFit,
    derivative_columns,
    pole_basis,
    polish,
)

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: A component of a shape with a larger error than this, relative to the largest one, is left blank.
MAX_COMPONENT_SIGMA = 0.5
#: A reference is not used for a mode whose participation there, relative to its best reference, is below this.
MIN_PARTICIPATION = 0.05
#: The variance is searched below the square of this relative difference.
MAX_RELATIVE_SCATTER = 0.1


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """The uncertainty of N fitted modes.

    - poles: one standard deviation of the real part and of the imaginary part, (N, 2) [1/s]
    - shapes: covariances of the shapes at their scale, (N, S, S)
    - strength: energy of each mode relative to noise, whose expected energy is one unit at each channel, (N,)
    """

    poles: Array
    shapes: Complex
    strength: Array


def residual(window: Window, fit: WindowFit) -> Complex:
    """Return the residual of the fit, (F, S, R)."""
    E = pole_basis(window, fit.poles)[:, : len(fit.poles)]
    return np.asarray(window.H - np.tensordot(E, fit.residues, 1))


def removed_columns(window: Window, fit: WindowFit) -> Complex:
    """Return orthonormal columns that a fit removes from the noise of the lines, (F, K).

    Several channels share a pole, which removes less than a column from each: the derivative is left out for two or
    more channels.
    """
    N = len(fit.poles)
    E = pole_basis(window, fit.poles)
    E = E if np.count_nonzero(window.weights) == 1 else E[:, :N]
    orthonormal = np.linalg.svd(E / np.linalg.norm(E, axis=0), full_matrices=False)[0]
    return np.concatenate([window.smooth, orthonormal], axis=1)


def channel_covariance(
    window: Window, fit: WindowFit, grid_index: NDArray[np.int64], correlation: Complex
) -> Complex:
    """Return the covariance of the noise between channels, (S R, S R), from the residual."""
    remainder = residual(window, fit).reshape(len(window.s), -1)
    columns = removed_columns(window, fit)
    removed_lines = float(
        np.einsum("fk,fk->", columns.conj(), apply_correlation(columns, grid_index, correlation)).real
    )
    lines = max(len(window.s) - removed_lines, 1.0)
    return np.asarray(remainder.T @ remainder.conj() / lines)


def fit_uncertainty(
    window: Window,
    fit: WindowFit,
    noise_covariance: Complex,
    grid_index: NDArray[np.int64],
    correlation: Complex,
) -> Uncertainty:
    """Return the uncertainty of a fit.

    - noise_covariance: covariance of the noise between channels, (S R, S R)
    - grid_index: indices of the lines on the grid, (F,)
    - correlation: correlation of the noise of lines, from lag 0, (L,)

    References
    ----------
    White 1982.
    """
    N, S = fit.shapes.shape
    E = pole_basis(window, fit.poles)
    functions, vectors = derivative_columns(fit.shapes, fit.participation)
    P = len(functions)
    gram, noise_gram = E.conj().T @ E, E.conj().T @ apply_correlation(E, grid_index, correlation)
    weighted = (vectors * window.weights).reshape(P, -1)
    normal = (weighted.conj() @ vectors.reshape(P, -1).T) * gram[np.ix_(functions, functions)]
    middle = (weighted.conj() @ noise_covariance @ weighted.T) * noise_gram[np.ix_(functions, functions)]
    scale = np.sqrt(np.maximum(normal.diagonal().real, 1e-300))
    inverse = np.linalg.pinv(normal / np.outer(scale, scale), rcond=1e-13, hermitian=True) / np.outer(
        scale, scale
    )
    covariance = inverse @ middle @ inverse
    poles = np.sqrt(np.maximum(covariance.diagonal().real[:N], 0.0) / 2.0)
    shapes = np.array([covariance[_shape_slice(m, N, S), _shape_slice(m, N, S)] for m in range(N)])
    return Uncertainty(
        np.stack([poles, poles], axis=1), shapes, _strength(window, fit, noise_covariance, gram, noise_gram)
    )


def _shape_slice(m: int, N: int, S: int) -> slice:
    return slice(N + m * S, N + (m + 1) * S)


def component_sigmas(shape: Complex, covariance: Complex) -> Array:
    """Return the standard deviations of the real parts of shape / largest component, (S,); 0 for the largest."""
    if not shape.size:
        return np.zeros(0)
    largest = int(np.argmax(np.abs(shape)))
    scale = shape[largest] if shape[largest] != 0.0 else 1.0
    D = np.eye(len(shape), dtype=complex)
    D[:, largest] -= shape / scale
    D /= scale
    variance = np.einsum("ij,jk,ik->i", D, covariance, D.conj()).real
    sigmas = np.sqrt(np.maximum(variance, 0.0) / 2.0)
    sigmas[largest] = 0.0
    return np.asarray(sigmas)


def determined_components(shape: Complex, covariance: Complex) -> NDArray[np.bool_]:
    """Return which components of a shape (S,) have a sigma below `MAX_COMPONENT_SIGMA` of the largest.

    The component of a sensor measured only with a reference near a node of the mode is not determined.  The largest
    component is the largest of those above three times their own sigma.
    """
    size, sigma = np.abs(shape), np.sqrt(np.maximum(covariance.diagonal().real, 0.0))
    significant_size = size * (size > 3.0 * sigma)
    return np.asarray((size > 0.0) & (sigma < MAX_COMPONENT_SIGMA * significant_size.max(initial=0.0)))


def common_sigma(sigmas: Array) -> float:
    """Return a common sigma for several components: twice it covers as many errors as for equal components.

    The root mean square would cover fewer: components with more noise exceed it more often than the others stay
    below.
    """
    sigmas = sigmas[sigmas > 0.0]
    if not sigmas.size:
        return 0.0
    low, high = 0.0, float(sigmas.max())
    for _ in range(50):
        middle = 0.5 * (low + high)
        covered = np.mean(erf(math.sqrt(2.0) * middle / sigmas))
        low, high = (middle, high) if covered < math.erf(math.sqrt(2.0)) else (low, middle)
    return high


def _strength(
    window: Window, fit: WindowFit, noise_covariance: Complex, gram: Complex, noise_gram: Complex
) -> Array:
    """Return the energy of each mode that the others cannot replace, relative to that of noise."""
    N = len(fit.poles)
    block = gram[:N, :N]
    scale = np.sqrt(block.diagonal().real)
    inverse = np.linalg.pinv(block / np.outer(scale, scale), rcond=1e-13, hermitian=True) / np.outer(
        scale, scale
    )
    variance = (inverse @ noise_gram[:N, :N] @ inverse).diagonal().real  # of a residue, for unit noise
    noise = noise_covariance.diagonal().real.reshape(window.weights.shape)
    measured = window.weights > 0.0
    energy = (np.abs(fit.residues[:, measured]) ** 2 / np.maximum(noise[measured], 1e-300)).sum(axis=1)
    return np.asarray(energy / np.maximum(variance, 1e-300) + math.ulp(0.0))


def poles_by_reference(window: Window, fit: WindowFit) -> tuple[Complex, Array]:
    """Return the poles of each reference alone, (R, N) [1/s], NaN where unknown, and their variances (R, N)."""
    (N, R), S = fit.participation.shape, fit.shapes.shape[1]
    poles, variances = np.full((R, N), np.nan, complex), np.full((R, N), np.nan)
    for r in range(R):
        weights = np.zeros((S, R))
        weights[:, r] = window.weights[:, r]
        single = replace(window, H=window.H[..., r : r + 1], weights=weights[:, r : r + 1])
        if not weights.any() or (np.abs(fit.participation[:, r]) < MIN_PARTICIPATION).any():
            continue
        refit = polish(single, fit.poles, np.ones((N, 1), complex))
        if not refit.converged or (np.abs(refit.poles - fit.poles) > np.abs(fit.poles.real)).any():
            continue
        E = pole_basis(window, refit.poles)
        for m in range(N):
            other_columns = np.delete(E, N + m, axis=1)
            unexplained = (
                E[:, N + m] - other_columns @ np.linalg.lstsq(other_columns, E[:, N + m], rcond=1e-12)[0]
            )
            energy = float((weights[:, r] * np.abs(refit.shapes[m]) ** 2).sum())
            variances[r, m] = 0.5 / max(energy * float(np.vdot(unexplained, unexplained).real), 1e-300)
        poles[r] = refit.poles
    return poles, variances


def variance_between_groups(values: Sequence[Array], variances: Sequence[Array]) -> float:
    """Return the variance between groups, beyond their own variances, pooled over several quantities.

    - values, variances: values and variances of each quantity, k of at least 2, each (k,)

    References
    ----------
    Paule and Mandel 1982.
    """
    freedom = sum(len(sample) - 1 for sample in values)

    def excess(extra_variance: float) -> float:
        total = 0.0
        for value, variance in zip(values, variances, strict=True):
            weights = 1.0 / (variance + extra_variance)
            total += float((weights * (value - (weights @ value) / weights.sum()) ** 2).sum())
        return total - freedom

    if not freedom or excess(0.0) <= 0.0:
        return 0.0
    low, high = 0.0, MAX_RELATIVE_SCATTER**2
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return high
