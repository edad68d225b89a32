"""The linear model at a fit, and its evidence: squares and degrees of freedom of frequencies and shapes, and factors.

A row that is not a mode must not count against the true hypothesis.  The fit without it follows from that of all rows
by deleting its data from the linear model.  A row is set aside where this gains more than its price: such rows are
rare, and may lie anywhere within reach.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pkmodes.loop.diagnosis.fit.cross_validation import deleted_residual
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, orthonormal
from pkmodes.loop.diagnosis.posterior.marginal import (
    log_occam_factor,
    marginal_log_likelihood,
    prior_of_error_factor,
)
from pkmodes.loop.diagnosis.problem import Array, Candidate
from pkmodes.loop.diagnosis.search.score import allowed_sign

#: Prior probabilities that a row is not a mode, and that the modes of a setup share an error.
P_WRONG_ROW, P_SHARED_ERROR = 0.01, 0.02
#: Cap on the largest plausible signal of a cause, used where nothing bounds its size.
MAX_SIGNAL = 1e3
#: Factor by which a size must exceed its plausible range to be beyond it: fits end at bounds up to rounding.
RANGE_TOLERANCE = 1.001
#: The largest plausible signal is at least this many times that of the fit.
MIN_SIGNAL_RATIO = 1.1
#: Cap on the square of a datum in `capped_deviance`: about the price of a row.
MAX_SQUARE = 20.0


@dataclass(frozen=True)
class LinearisedFit:
    """The linear model at a fit, without the rows that are set aside.

    The D data are those of the fit.

    - log_factor: logarithm of all factors of the evidence except the likelihood: the priors of rows set aside and of
      a shared error, and the Occam factors of uncertain values and of sizes of causes; minus infinity if a size is
      not plausible
    - parts: frequencies, each other quantity, and priors among the data
    - degrees: degrees of freedom of all these except the priors, without the rows set aside
    - basis, white: orthonormal basis of the derivatives, and the whitened residual, (D, k) and (D,), 0 for rows set
      aside
    - set_aside: rows
    """

    fit: Fit
    log_factor: float
    parts: tuple[slice, ...]
    degrees: tuple[float, ...]
    basis: Array
    white: Array
    set_aside: frozenset[int]

    @cached_property
    def squares(self) -> tuple[float, ...]:
        """Sums of squares of the parts of the data."""
        return tuple(float(self.white[part] @ self.white[part]) for part in self.parts)

    @cached_property
    def log_evidence(self) -> float:
        """The logarithm of the evidence of the fit without additions."""
        zeros = np.zeros((len(self.white), 1))
        return float(self.log_evidence_with(zeros, zeros)[0])

    def log_evidence_with(self, removed_residuals: Array, leverages: Array) -> Array:
        """Return the logarithm of the evidence with each of n linear additions, without their Occam factors, (n,).

        - removed_residuals: parts of the residual that they remove, (D, n)
        - leverages: leverages of their directions, (D, n)
        """
        residual = self.white[:, None] - removed_residuals
        squares = [(residual[part] ** 2).sum(axis=0) for part in self.parts]
        total, prior = self.log_factor - 0.5 * squares[-1], prior_of_error_factor()
        for sums, part, degrees in zip(squares, self.parts, self.degrees, strict=False):
            total += marginal_log_likelihood(
                sums, np.maximum(degrees - leverages[part].sum(axis=0), 0.0), prior
            )
        return np.asarray(total)


def linearise(fitter: Fitter, fit: Fit, max_deviations: Mapping[int, float]) -> LinearisedFit:
    """Return the linear model at a fit, without rows that are not modes.

    - max_deviations: largest plausible deviations of parameters of causes from their declared values
    """
    white, basis, rows_set_aside = fit.white, fit.basis, set(fit.hypothesis.excluded_rows)
    observations = fitter.observations
    frequencies, other_quantities = observations.frequency_slice, observations.other_quantities
    while len(rows_set_aside) < max(
        1, len(observations.log_frequencies) // fitter.criteria.search.rows_per_outlier
    ):
        row = int(np.argmax(np.abs(white[frequencies])))
        indices = observations.data_indices(np.array([row]))
        if white[indices] @ deleted_residual(basis[indices], white[indices]) <= 2.0 * _price_of_row(
            fitter, row
        ):
            break
        rows_set_aside.add(row)
        white, basis = np.array(white), np.array(basis)
        white[indices] = basis[indices] = 0.0
        basis = orthonormal(basis)
        white -= basis @ (basis.T @ white)
    used_row_mask = fitter.used_row_mask(fit.hypothesis)
    used_row_mask[list(rows_set_aside)] = False
    leverage = (basis**2).sum(axis=1)
    counts = [observations.frequencies.count, *(quantity.count for quantity in other_quantities.values())]
    parts = [frequencies, *map(observations.data_slice, other_quantities)]
    degrees = tuple(
        max(float(count[used_row_mask].sum() - leverage[part].sum()), 0.0)
        for count, part in zip(counts, parts, strict=True)
    )
    log_factor = -sum(_price_of_row(fitter, row) for row in rows_set_aside) - 0.5 * fit.log_determinant
    if fit.hypothesis.has_shared_error:
        log_factor += float(np.log(P_SHARED_ERROR) - 0.5 * np.log(len(used_row_mask)))
    log_factor += _log_occam_factor_of_values(fitter, fit) + sum(
        _log_occam_factor_of_cause(fitter, fit, cause, max_deviations) for cause in fit.causes
    )
    all_parts = (*parts, fitter.prior_slice)
    return LinearisedFit(fit, log_factor, all_parts, degrees, basis, white, frozenset(rows_set_aside))


def capped_deviance(fitter: Fitter, fit: Fit) -> float:
    """Return twice the negative log likelihood of a fit, with the square of each datum capped at `MAX_SQUARE`."""
    squares = fit.white**2
    data = squares[: fitter.prior_slice.start]
    data[:] = np.minimum(data, MAX_SQUARE)
    return float(squares.sum()) + fit.log_determinant


def _price_of_row(fitter: Fitter, row: int) -> float:
    """Return the negative logarithm of the density of a row that is not a mode, relative to one that is right."""
    frequency_range, shapes = 2.0 * fitter.criteria.pairing.reach, fitter.observations.shapes
    frequency = np.log(frequency_range / (np.sqrt(2.0 * np.pi) * fitter.observations.sigma[row])) - np.log(
        P_WRONG_ROW
    )
    shape = -np.log(np.sqrt(2.0 * np.pi) * shapes.sigma[row]) if shapes.known[row] else np.zeros(1)
    return float(max(frequency, 0.0) + np.maximum(shape, 0.0).mean() * shapes.count[row])


def _log_occam_factor_of_values(fitter: Fitter, fit: Fit) -> float:
    """Return the logarithm of the Occam factor of the uncertain values, up to a constant for the same data."""
    prior_sigmas = fitter.priors.sigmas_in_units(fitter.declared)[fitter.priors.rows(fitter.nuisance_indices)]
    scaled = fit.jacobian[:, : len(prior_sigmas)] * prior_sigmas
    return -0.5 * float(np.linalg.slogdet(scaled.T @ scaled)[1])


def _log_occam_factor_of_cause(
    fitter: Fitter, fit: Fit, cause: Candidate, max_deviations: Mapping[int, float]
) -> float:
    """Return the logarithm of the Occam factor of a cause, given the others; minus infinity if implausible."""
    index = list(fitter.parameter_indices(cause))
    deviations, covariance = fit.values[index] - fitter.declared[index], fit.covariance_of(index)
    if cause.sigma is not None:
        prior_sigmas = fitter.priors.sigmas_in_units(fit.values)[fitter.priors.rows(index)]
        return 0.5 * float(np.linalg.slogdet(covariance / np.outer(prior_sigmas, prior_sigmas))[1])
    limits, sigma = np.array([max_deviations.get(i, np.inf) for i in index]), np.sqrt(np.diagonal(covariance))
    if (np.abs(deviations) > RANGE_TOLERANCE * limits).any():
        return -np.inf
    information = np.linalg.pinv(covariance / np.outer(sigma, sigma), hermitian=True)
    ratio, z = np.minimum(limits / sigma, MAX_SIGNAL), deviations / sigma
    signals = np.linalg.eigvalsh(information * np.outer(ratio, ratio))
    signal = float(np.sqrt(max(z @ information @ z, 0.0)))
    max_signal = max(float(np.sqrt(max(signals[-1], 1.0))), MIN_SIGNAL_RATIO * signal)
    dimensions, is_one_sided = max(int((signals > 1.0).sum()), 1), allowed_sign(fitter, cause) != 0
    return float(
        log_occam_factor(
            *(np.array([argument]) for argument in (signal, dimensions, max_signal, is_one_sided))
        )[0]
    )
