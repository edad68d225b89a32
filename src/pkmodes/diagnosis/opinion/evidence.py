r"""The evidence of a hypothesis: the probability density of the data, all its unknowns integrated out.

The evidence ranks hypotheses with different numbers of parameters: what a parameter could have been, but is not,
counts against it (MacKay, Information Theory, Inference, and Learning Algorithms, 2003, chapter 28; Kass and
Raftery, Bayes Factors, Journal of the American Statistical Association 90, 1995, 773).  All are logarithms, and
relative to the same data.  Three kinds of unknowns are integrated out:

* uncertain values, which have priors: by Laplace's approximation at the fit;
* the size of a cause.  Its signal r, the root of the squares that it adds to chi-square, has a log-uniform prior from
  1 to the largest plausible signal R, and every direction of several parameters the same one: a mixture of Zellner's
  g-priors (Liang, Paulo, Molina, Clyde and Berger, Journal of the American Statistical Association 103, 2008, 410).
  A cause that the data could not show is no other hypothesis than that nothing is missing;
* the factor s by which stated errors are wrong, separately for frequencies and shapes.
"""

from __future__ import annotations

import numpy as np
from scipy import special

from pkmodes.diagnosis.problem import Array

#: Factors on the stated errors, as logarithms, and their prior: stated errors are mostly right within the first
#: standard deviation, and some, this part of them, only within the second one.
LOG_SCALE = np.linspace(-1.2, 3.0, 85)
SHRUNK = np.exp(-2.0 * LOG_SCALE)
SCALE_SIGMA, SCALE_WIDE, WIDE = 0.1, 0.5, 0.1
#: Half width of the range of a quadrature over the signal, and its points.
REACH, POINTS = 6.0, 49
TRAPEZOID = np.concatenate([[0.5], np.ones(POINTS - 2), [0.5]])


def prior_of_scale() -> Array:
    """Return the prior of the factors on stated errors."""
    parts = [
        (1.0 - WIDE, np.exp(-0.5 * (LOG_SCALE / SCALE_SIGMA) ** 2)),
        (WIDE, np.exp(-0.5 * (LOG_SCALE / SCALE_WIDE) ** 2)),
    ]
    return np.asarray(sum(weight * density / density.sum() for weight, density in parts))


def of_scaled(squares: Array, degrees: Array, prior: Array) -> Array:
    r"""Return :math:`\ln \int p(s) s^{-\nu} e^{-q / 2 s^2} ds` for squares q with nu degrees of freedom, (n,).

    Parameters
    ----------
    prior : ndarray
        Weights of the factors `LOG_SCALE`.
    """
    q, nu = np.asarray(squares)[..., None], np.asarray(degrees)[..., None]
    return np.asarray(special.logsumexp(-nu * LOG_SCALE - 0.5 * q * SHRUNK, axis=-1, b=prior))


def of_size(signal: Array, degrees: Array, largest: Array, one_sided: Array) -> Array:
    """Return the evidence of causes relative to the least squares that they leave: the price of their sizes, (n,).

    Parameters
    ----------
    signal : ndarray
        Root of the squares by which the best size lowers chi-square, all else fitted; 0 for a cause that would have
        the wrong sign.
    degrees : ndarray
        Number of parameters that the data determine.
    largest : ndarray
        Largest plausible signal.
    one_sided : ndarray
        Whether a single parameter can have one sign only.
    """
    signal, largest = signal[:, None], np.maximum(largest, 2.0)[:, None]
    low = np.clip(signal - REACH, 1.0, largest)
    high = np.clip(signal + REACH, 1.0, largest)
    r = low + (high - low) * np.linspace(0.0, 1.0, POINTS)
    # The mean over the directions of exp(r signal (cos - 1)): of two, or of a sphere (von Mises and Fisher).
    x, order = np.maximum(r * signal, 1e-6), 0.5 * np.maximum(degrees, 2)[:, None] - 1.0
    both = np.log(0.5 * (1.0 + np.exp(-2.0 * x)))
    sphere = np.log(special.ive(order, x)) + special.gammaln(order + 1.0) + order * np.log(2.0 / x)
    several = np.where((degrees > 1)[:, None], sphere, both)
    direction = np.where(one_sided[:, None], 0.0, several)
    exponent = direction - 0.5 * (r - signal) ** 2 - np.log(r * np.log(largest))
    with np.errstate(divide="ignore"):
        width = np.log((high - low)[:, 0] / (POINTS - 1))
    return np.asarray(special.logsumexp(exponent, axis=-1, b=TRAPEZOID) + width)
