r"""The evidence that something outside the catalogue is behind a residual: a broad family of changes of M and K.

A change of M or K of low rank, the same at all setups, such as a mass or a spring between any coordinates, changes
the frequency of a mode with the mass-normalised shape phi by

.. math:: d \ln f = -\tfrac12 \phi^T dM \phi, \qquad d \ln f = \tfrac{1}{2 \lambda} \phi^T dK \phi :

a combination of the products of two components of the shape.  All products have the same prior, so the residual of
the frequencies, beside whatever is fitted, is normal with the covariance
:math:`s^2 I + \frac{a^2}{n} G G^T`, where G has the n unit signatures of these products and a is the size of the
change, log-uniform from `LEAST` to what changes the frequencies by `MOST`.  The factor s may be larger than that of
misstated errors: what no such change describes, because it is another one at each setup or adds a mode, looks like
scatter.  Everything else is as for the catalogue: errors misstated, rows set aside, errors that a setup shares.
"""

from __future__ import annotations

import numpy as np
from scipy import special

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.opinion.evidence import LOG_SCALE, of_scaled, prior_of_scale
from pkmodes.diagnosis.opinion.left import Left
from pkmodes.diagnosis.problem import Array

#: Least signal of a change, its largest relative change of the frequencies, and number of sizes between them.
LEAST, MOST, SIZES = 5.0, 0.3, 15
#: Part of the changes that look like scatter, and their largest factor on the errors.
SCATTERED, FACTOR = 0.5, 20.0
#: Directions with less than this variance are noise whatever the size, and relative ones that are rounding.
SHOWN, ROUNDING = 0.1, 1e-12


def outside(fitter: Fitter, left: Left) -> float:
    """Return the evidence of something beside a fit."""
    wide = ((LOG_SCALE >= 0.0) & (np.log(FACTOR) >= LOG_SCALE)).astype(float)
    prior = (1.0 - SCATTERED) * prior_of_scale() + SCATTERED * wide / wide.sum()
    frequencies, shapes, priors = left.squares
    largest = float(np.linalg.norm(MOST / fitter.sigma))
    changes = of_changes(*spectrum(fitter, left), frequencies, left.degrees[0], largest, prior)
    rest = float(of_scaled(np.array(shapes), np.array(left.degrees[1]), prior))
    return changes + rest - 0.5 * priors + left.price


def of_changes(g: Array, c: Array, squares: float, degrees: float, largest: float, prior: Array) -> float:
    """Return the evidence of the frequencies.

    Parameters
    ----------
    g, c : ndarray, shape (k,)
        Variances of changes of unit size along their principal directions, and the squares along each.
    squares, degrees : float
        Of all frequencies.
    largest : float
        Largest signal of a change.
    prior : ndarray
        Of the factors on the errors.
    """
    sizes = np.geomspace(LEAST, max(largest, 2.0 * LEAST), SIZES)
    shown = sizes[-1] ** 2 * g > SHOWN
    g, c = g[shown], c[shown]
    other, count = max(squares - float(c.sum()), 0.0), max(degrees - len(g), 0.0)
    log, weights = LOG_SCALE[::2], prior[::2] / prior[::2].sum()
    variance = np.exp(2.0 * log)[:, None, None] + sizes[:, None] ** 2 * g
    exponent = -0.5 * (np.log(variance) + c / variance).sum(axis=-1)
    exponent -= (0.5 * other * np.exp(-2.0 * log) + count * log)[:, None]
    return float(special.logsumexp(exponent, b=weights[:, None] / SIZES))


def spectrum(fitter: Fitter, left: Left) -> tuple[Array, Array]:
    """Return the variances of changes of unit size along their principal directions, and the squares along these.

    The directions are orthogonal to the derivatives with respect to all that is fitted.
    """
    fit, rows, partner = left.fit, fitter.frequency_rows, left.fit.pairing.partner
    at = fitter.pairer.pose, np.maximum(partner, 0)
    shapes, eigenvalues = fit.prediction.shapes[at], np.abs(fit.prediction.eigenvalues[at])
    i, j = np.triu_indices(shapes.shape[1])
    products = shapes[:, i] * shapes[:, j]
    used = partner >= 0
    used[list(left.set_aside)] = False
    data = np.zeros((fitter.prior_rows.start, 2 * len(i)))
    data[rows] = np.hstack([products, products / np.maximum(eigenvalues, 1e-300)[:, None]]) * used[:, None]
    raw = fitter.whitening(fit).whitened(data)[rows]
    size = np.linalg.norm(raw, axis=0)
    unit = raw[:, size > 0.0] / size[size > 0.0]
    # A root of the covariance with few columns, then that of its part beside what is fitted.
    values, vectors = np.linalg.eigh(unit @ unit.T / max(unit.shape[1], 1))
    some = values > ROUNDING * max(values[-1], ROUNDING)
    root = vectors[:, some] * np.sqrt(values[some])
    inner = left.basis[rows].T @ root
    g, axes = np.linalg.eigh(root.T @ root - inner.T @ inner)
    kept = g > 100.0 * ROUNDING * g.max(initial=0.0)
    return g[kept], (axes[:, kept].T @ (root.T @ left.white[rows])) ** 2 / g[kept]
