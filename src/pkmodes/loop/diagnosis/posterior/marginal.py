r"""The evidence of a hypothesis, or marginal likelihood: the density of the data, all its unknowns integrated out.

The evidence ranks hypotheses with different numbers of parameters: each parameter costs an Occam factor, the part of
its prior range that the data leave (MacKay, Information Theory, Inference, and Learning Algorithms, 2003, chapter 28;
Kass and Raftery, Bayes Factors, Journal of the American Statistical Association 90, 1995, 773).  All values here are
logarithms, up to the same constant for the same data.  Three kinds of unknowns are integrated out:

* uncertain values, which have priors: by Laplace's approximation at the fit;
* the size of a cause.  Its signal r, the root of the squares that it adds to chi-square, has a log-uniform prior from
  1 to the largest plausible signal R, and every direction of several parameters the same one: a mixture of Zellner's
  g-priors (Liang, Paulo, Molina, Clyde and Berger, Journal of the American Statistical Association 103, 2008, 410).
  A signal below 1 is indistinguishable from none, so it counts as the hypothesis that nothing is missing;
* the factor s by which stated errors are wrong, separately for frequencies and shapes.
"""

from __future__ import annotations

import numpy as np
from scipy import special

from pkmodes.loop.diagnosis.problem import Array

#: Logarithms of the factor on the stated errors, and its inverse square.  Its prior is a mixture of two normal
#: distributions of the logarithm: their standard deviations, and the weight of the wide one.
LOG_SCALE = np.linspace(-1.2, 3.0, 85)
INVERSE_SQUARES = np.exp(-2.0 * LOG_SCALE)
NARROW_SIGMA, WIDE_SIGMA, WIDE_WEIGHT = 0.1, 0.5, 0.1
#: Half width of the range of the quadrature over the signal, number of points, and weights of the trapezoidal rule.
HALF_WIDTH, POINTS = 6.0, 49
TRAPEZOID = np.concatenate([[0.5], np.ones(POINTS - 2), [0.5]])


def prior_of_scale() -> Array:
    """Return the prior probabilities of the factors `LOG_SCALE` on stated errors, (85,)."""
    components = [
        (1.0 - WIDE_WEIGHT, np.exp(-0.5 * (LOG_SCALE / NARROW_SIGMA) ** 2)),
        (WIDE_WEIGHT, np.exp(-0.5 * (LOG_SCALE / WIDE_SIGMA) ** 2)),
    ]
    return np.asarray(sum(weight * density / density.sum() for weight, density in components))


def marginal_log_likelihood(squares: Array, degrees: Array, prior: Array) -> Array:
    r"""Return :math:`\ln \int p(s) s^{-\nu} e^{-q / 2 s^2} ds`, the factor s on the errors integrated out, (n,).

    - squares, degrees: sums of squares q, and their degrees of freedom nu, (n,)
    - prior: probabilities p of the factors `LOG_SCALE`, (85,)
    """
    q, nu = np.asarray(squares)[..., None], np.asarray(degrees)[..., None]
    return np.asarray(special.logsumexp(-nu * LOG_SCALE - 0.5 * q * INVERSE_SQUARES, axis=-1, b=prior))


def log_occam_factor(signal: Array, degrees: Array, largest: Array, one_sided: Array) -> Array:
    """Return the logarithms of the Occam factors of causes: their evidence over their likelihood at the fit, (n,).

    - signal: root of the squares by which the best size lowers chi-square, all else fitted, (n,); 0 for a cause that
      would have the wrong sign
    - degrees: number of parameters that the data determine, (n,)
    - largest: largest plausible signal, (n,)
    - one_sided: whether a single parameter can have one sign only, (n,)
    """
    signal, largest = signal[:, None], np.maximum(largest, 2.0)[:, None]
    low = np.clip(signal - HALF_WIDTH, 1.0, largest)
    high = np.clip(signal + HALF_WIDTH, 1.0, largest)
    r = low + (high - low) * np.linspace(0.0, 1.0, POINTS)
    # The mean of exp(r signal (cos - 1)) over both signs, or over the directions of a sphere: the normalisation of
    # the von Mises-Fisher distribution (Mardia and Jupp, Directional Statistics, 2000, section 9.3).
    x, order = np.maximum(r * signal, 1e-6), 0.5 * np.maximum(degrees, 2)[:, None] - 1.0
    log_mean_of_signs = np.log(0.5 * (1.0 + np.exp(-2.0 * x)))
    log_mean_of_sphere = (
        np.log(special.ive(order, x)) + special.gammaln(order + 1.0) + order * np.log(2.0 / x)
    )
    direction_of_many = np.where((degrees > 1)[:, None], log_mean_of_sphere, log_mean_of_signs)
    direction = np.where(one_sided[:, None], 0.0, direction_of_many)
    exponent = direction - 0.5 * (r - signal) ** 2 - np.log(r * np.log(largest))
    with np.errstate(divide="ignore"):
        width = np.log((high - low)[:, 0] / (POINTS - 1))
    return np.asarray(special.logsumexp(exponent, axis=-1, b=TRAPEZOID) + width)
