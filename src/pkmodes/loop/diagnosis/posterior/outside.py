r"""The evidence that something outside the catalogue is behind a residual: a broad family of changes of M and K.

A change of M or K of low rank, the same at all setups, such as a mass or a spring between any coordinates, changes
the frequency of a mode with the mass-normalised shape phi by

.. math:: d \ln f = -\tfrac12 \phi^T dM \phi, \qquad d \ln f = \tfrac{1}{2 \lambda} \phi^T dK \phi :

a combination of the products of two components of the shape.  All products have the same prior, so the residual of
the frequencies, beside whatever is fitted, is normal with the covariance
:math:`s^2 I + \frac{a^2}{n} G G^T`, where G has the n unit signatures of these products and a is the size of the
change, log-uniform from `MIN_SIGNAL` to what changes the frequencies by `MAX_FREQUENCY_CHANGE`.  The factor s may be
larger than that of misstated errors: a change that differs between setups, or adds a mode, is not in this family and
looks like scatter.  Misstated errors, rows set aside and errors shared in a setup are treated as for the catalogue.
"""

from __future__ import annotations

import numpy as np
from scipy import special

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.posterior.linearised import LinearisedFit
from pkmodes.loop.diagnosis.posterior.marginal import (
    LOG_ERROR_FACTORS,
    marginal_log_likelihood,
    prior_of_error_factor,
)
from pkmodes.loop.diagnosis.problem import Array

#: Smallest signal of a change, largest relative change of the frequencies, and number of sizes in the quadrature.
MIN_SIGNAL, MAX_FREQUENCY_CHANGE, SIZE_COUNT = 5.0, 0.3, 15
#: Prior probability of a change that looks like scatter, and its largest factor on the errors.
P_SCATTER, MAX_ERROR_FACTOR = 0.5, 20.0
#: Directions with less than this variance at the largest size are left out as noise; smaller relative variances are
#: rounding.
MIN_VARIANCE, ROUNDING = 0.1, 1e-12


def log_evidence_outside(fitter: Fitter, model: LinearisedFit) -> float:
    """Return the logarithm of the evidence of something outside the catalogue in addition to a fit."""
    wide = ((LOG_ERROR_FACTORS >= 0.0) & (np.log(MAX_ERROR_FACTOR) >= LOG_ERROR_FACTORS)).astype(float)
    prior = (1.0 - P_SCATTER) * prior_of_error_factor() + P_SCATTER * wide / wide.sum()
    frequencies, *other_squares, priors = model.squares
    max_signal = float(np.linalg.norm(MAX_FREQUENCY_CHANGE / fitter.observations.sigma))
    log_evidence_of_changes = log_evidence_of_frequencies(
        *spectrum(fitter, model), frequencies, model.degrees[0], max_signal, prior
    )
    log_evidence_of_others = float(
        marginal_log_likelihood(np.array(other_squares), np.array(model.degrees[1:]), prior).sum()
    )
    return log_evidence_of_changes + log_evidence_of_others - 0.5 * priors + model.log_factor


def log_evidence_of_frequencies(
    g: Array, c: Array, squares: float, degrees: float, max_signal: float, prior: Array
) -> float:
    """Return the logarithm of the evidence of the frequencies, the size of the change and the errors integrated out.

    - g, c: variances of changes of unit size along their principal directions, and the squares along each, (k,)
    - squares, degrees: sum of squares of all frequencies, and its degrees of freedom
    - max_signal: largest signal of a change
    - prior: prior probabilities of the factors `LOG_ERROR_FACTORS` on the errors, (85,)
    """
    sizes = np.geomspace(MIN_SIGNAL, max(max_signal, 2.0 * MIN_SIGNAL), SIZE_COUNT)
    is_visible = sizes[-1] ** 2 * g > MIN_VARIANCE
    g, c = g[is_visible], c[is_visible]
    remainder, count = max(squares - float(c.sum()), 0.0), max(degrees - len(g), 0.0)
    log_error_factors, weights = LOG_ERROR_FACTORS[::2], prior[::2] / prior[::2].sum()
    variance = np.exp(2.0 * log_error_factors)[:, None, None] + sizes[:, None] ** 2 * g
    exponent = -0.5 * (np.log(variance) + c / variance).sum(axis=-1)
    exponent -= (0.5 * remainder * np.exp(-2.0 * log_error_factors) + count * log_error_factors)[:, None]
    return float(special.logsumexp(exponent, b=weights[:, None] / SIZE_COUNT))


def spectrum(fitter: Fitter, model: LinearisedFit) -> tuple[Array, Array]:
    """Return the variances of changes of unit size along their principal directions, and the squares there, (k,).

    The directions are orthogonal to the derivatives with respect to all fitted parameters.
    """
    fit, rows, partner = model.fit, fitter.observations.frequency_slice, model.fit.pairing.partner
    mode_index = fitter.observations.pairer.pose, np.maximum(partner, 0)
    shapes, eigenvalues = fit.prediction.shapes[mode_index], np.abs(fit.prediction.eigenvalues[mode_index])
    i, j = np.triu_indices(shapes.shape[1])
    products = shapes[:, i] * shapes[:, j]
    is_used = partner >= 0
    is_used[list(model.set_aside)] = False
    data = np.zeros((fitter.prior_slice.start, 2 * len(i)))
    data[rows] = np.hstack([products, products / np.maximum(eigenvalues, 1e-300)[:, None]]) * is_used[:, None]
    whitened = fitter.whitening(fit).whitened(data)[rows]
    norms = np.linalg.norm(whitened, axis=0)
    unit_signatures = whitened[:, norms > 0.0] / norms[norms > 0.0]
    # A root of the covariance with few columns, then that of its part orthogonal to what is fitted.
    values, vectors = np.linalg.eigh(unit_signatures @ unit_signatures.T / max(unit_signatures.shape[1], 1))
    significant = values > ROUNDING * max(values[-1], ROUNDING)
    root = vectors[:, significant] * np.sqrt(values[significant])
    projection = model.basis[rows].T @ root
    g, axes = np.linalg.eigh(root.T @ root - projection.T @ projection)
    is_significant = g > 100.0 * ROUNDING * g.max(initial=0.0)
    squares = (axes[:, is_significant].T @ (root.T @ model.white[rows])) ** 2
    return g[is_significant], squares / g[is_significant]
