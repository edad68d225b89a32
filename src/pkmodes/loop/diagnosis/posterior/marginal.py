r"""The evidence of a hypothesis, or marginal likelihood: the density of the data, all its unknowns integrated out.

The evidence ranks hypotheses with different numbers of parameters: each parameter costs an Occam factor, the fraction
of its prior range that remains plausible given the data (MacKay, Information Theory, Inference, and Learning
Algorithms, 2003, chapter 28; Kass and Raftery, Bayes Factors, Journal of the American Statistical Association 90,
1995, 773).  All values here are logarithms, up to the same constant for the same data.  Three kinds of unknowns are
integrated out:

* uncertain values, which have priors: by Laplace's approximation at the fit;
* the size of a cause.  Its signal r, the square root of what it adds to chi-square, has a log-uniform prior from 1 to
  the largest plausible signal R; with several parameters, all directions are equally likely: a mixture of Zellner's
  g-priors (Liang, Paulo, Molina, Clyde and Berger, Journal of the American Statistical Association 103, 2008, 410).
  A signal below 1 is indistinguishable from none, so it counts as the hypothesis that nothing is missing;
* the factor s by which stated errors are wrong, separately for frequencies and shapes.
"""

from __future__ import annotations

import numpy as np
from scipy import special

from pkmodes.loop.diagnosis.problem import Array

#: Grid of logarithms of the factor on stated errors, and the factors' inverse squares.  The prior of the factor is a
#: mixture of two normal distributions of its logarithm: their standard deviations, and the weight of the wide one.
LOG_ERROR_FACTORS = np.linspace(-1.2, 3.0, 85)
INVERSE_SQUARE_FACTORS = np.exp(-2.0 * LOG_ERROR_FACTORS)
NARROW_SIGMA, WIDE_SIGMA, WIDE_WEIGHT = 0.1, 0.5, 0.1
#: Half width of the range of the quadrature over the signal, number of points, and weights of the trapezoidal rule.
QUADRATURE_HALF_WIDTH, QUADRATURE_POINTS = 6.0, 49
TRAPEZOID_WEIGHTS = np.concatenate([[0.5], np.ones(QUADRATURE_POINTS - 2), [0.5]])


def prior_of_error_factor() -> Array:
    """Return the prior probabilities of the factors `LOG_ERROR_FACTORS` on stated errors, (85,)."""
    components = [
        (1.0 - WIDE_WEIGHT, np.exp(-0.5 * (LOG_ERROR_FACTORS / NARROW_SIGMA) ** 2)),
        (WIDE_WEIGHT, np.exp(-0.5 * (LOG_ERROR_FACTORS / WIDE_SIGMA) ** 2)),
    ]
    return np.asarray(sum(weight * density / density.sum() for weight, density in components))


def marginal_log_likelihood(squares: Array, degrees: Array, prior: Array) -> Array:
    r"""Return :math:`\ln \int p(s) s^{-\nu} e^{-q / 2 s^2} ds`, the factor s on the errors integrated out, (n,).

    - squares, degrees: sums of squares q, and their degrees of freedom nu, (n,)
    - prior: probabilities p of the factors `LOG_ERROR_FACTORS`, (85,)
    """
    q, nu = np.asarray(squares)[..., None], np.asarray(degrees)[..., None]
    return np.asarray(
        special.logsumexp(-nu * LOG_ERROR_FACTORS - 0.5 * q * INVERSE_SQUARE_FACTORS, axis=-1, b=prior)
    )


def log_occam_factor(signal: Array, dimensions: Array, max_signal: Array, is_one_sided: Array) -> Array:
    """Return the logarithms of the Occam factors of causes: their evidence over their likelihood at the fit, (n,).

    - signal: square root of the decrease in chi-square at the best size, with everything else refitted, (n,); 0 for
      a cause that would have the wrong sign
    - dimensions: number of parameters that the data determine, (n,)
    - max_signal: largest plausible signal, (n,)
    - is_one_sided: whether a single parameter can have one sign only, (n,)
    """
    signal, max_signal = signal[:, None], np.maximum(max_signal, 2.0)[:, None]
    low = np.clip(signal - QUADRATURE_HALF_WIDTH, 1.0, max_signal)
    high = np.clip(signal + QUADRATURE_HALF_WIDTH, 1.0, max_signal)
    r = low + (high - low) * np.linspace(0.0, 1.0, QUADRATURE_POINTS)
    log_mean = _log_mean_over_directions(np.maximum(r * signal, 1e-6), dimensions[:, None])
    log_direction_factor = np.where(is_one_sided[:, None], 0.0, log_mean)
    exponent = log_direction_factor - 0.5 * (r - signal) ** 2 - np.log(r * np.log(max_signal))
    with np.errstate(divide="ignore"):
        log_step = np.log((high - low)[:, 0] / (QUADRATURE_POINTS - 1))
    return np.asarray(special.logsumexp(exponent, axis=-1, b=TRAPEZOID_WEIGHTS) + log_step)


def _log_mean_over_directions(x: Array, dimensions: Array) -> Array:
    """Return the logarithm of the mean of exp(x (cos - 1)) over all directions, or over both signs.

    It is the normalisation of the von Mises-Fisher distribution (Mardia and Jupp, Directional Statistics, 2000,
    section 9.3).
    """
    log_mean_over_signs = np.log(0.5 * (1.0 + np.exp(-2.0 * x)))
    bessel_order = 0.5 * np.maximum(dimensions, 2) - 1.0
    log_mean_over_sphere = (
        np.log(special.ive(bessel_order, x))
        + special.gammaln(bessel_order + 1.0)
        + bessel_order * np.log(2.0 / x)
    )
    return np.where(dimensions > 1, log_mean_over_sphere, log_mean_over_signs)
