r"""Priors as additional data: of nuisances always, of parameters of candidates if the candidate is assumed.

Correlated priors are whitened: with their distances d in standard deviations and the correlation R, the data are
:math:`R^{-1/2} d`, whose sum of squares is :math:`d^T R^{-1} d`.  R may be singular, as for values that are exactly
proportional.  Its eigenvalues are raised to `MIN_EIGENVALUE` at least: the standard deviation of a combination
without any uncertainty is then a ten-thousandth of that of its values, which fixes it and keeps the least squares
well conditioned.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.problem import Array, Candidate, Parameter

#: Smallest eigenvalue to which those of a correlation matrix are raised, and rounding allowed in a declared one.
MIN_EIGENVALUE, MAX_ROUNDING = 1e-8, 1e-6


class Priors:
    """Normal and log-normal priors of the parameters that have one.

    - prior_factor: factor on all standard deviations

    Its attributes:
    - index: indices of the parameters with a prior, (P,)
    - sigma: their standard deviations, of the logarithms if they are log-normal, (P,)
    - whitening: the symmetric inverse root of their correlation, (P, P); None if all are independent

    Raises PkmodesError if correlations are asymmetric or impossible, a prior is not positive, a candidate does not
    have one for each parameter, two candidates contradict each other, or a log-normal parameter is not positive.
    """

    def __init__(
        self, parameters: Sequence[Parameter], candidates: Sequence[Candidate], prior_factor: float = 1.0
    ) -> None:
        sigmas = {i: p.sigma for i, p in enumerate(parameters) if p.sigma}
        names = {p.name: i for i, p in enumerate(parameters)}
        for candidate in candidates:
            if candidate.sigma is None:
                continue
            where = f"candidate {shown(candidate.name)}"
            if len(candidate.sigma) != len(candidate.parameters):
                problem = (
                    f"expected {len(candidate.parameters)} standard deviations, found {len(candidate.sigma)}"
                )
                raise PkmodesError(problem, where, "give one for each of its parameters")
            for name, sigma in zip(candidate.parameters, candidate.sigma, strict=True):
                if not 0.0 < sigma < np.inf:
                    problem = f"expected a standard deviation above 0, found {sigma:g}"
                    raise PkmodesError(problem, where, "leave sigma out if unknown")
                if sigmas.setdefault(names[name], sigma) != sigma:
                    problem = f"{shown(name)} has two priors: {sigmas[names[name]]:g} and {sigma:g}"
                    raise PkmodesError(problem, where, "give the same one in every candidate")
        self.index: NDArray[np.intp] = np.array(sorted(sigmas), dtype=np.intp)
        self._row = {i: row for row, i in enumerate(self.index.tolist())}
        self.sigma = prior_factor * np.array([sigmas[i] for i in sorted(sigmas)], dtype=float)
        self._declared = np.array([parameters[i].value for i in self.index])
        self._log = np.array([parameters[i].log for i in self.index], dtype=bool)
        for i in self.index[self._log & (self._declared <= 0.0)]:
            problem = f"expected a positive value for a log-normal prior, found {parameters[i].value:g}"
            raise PkmodesError(problem, f"parameter {shown(parameters[i].name)}", "leave out log=True")
        self.whitening = whitening_matrix([parameters[i] for i in self.index])

    def residual(self, values: Array) -> Array:
        """Return the whitened distances from the declared values, (P,): independent, of variance 1."""
        distances = self.distances(values)
        return distances if self.whitening is None else np.asarray(self.whitening @ distances)

    def distances(self, values: Array) -> Array:
        """Return the distance of each value from its declared one in its standard deviations, (P,)."""
        prior_values = values[self.index]
        with np.errstate(divide="ignore", invalid="ignore"):
            distances = np.where(
                self._log,
                np.log(np.maximum(prior_values, 1e-300) / np.where(self._log, self._declared, 1.0)),
                0.0,
            )
        distances = np.where(self._log, distances, prior_values - self._declared)
        return np.asarray(distances / self.sigma)

    def rates(self, values: Array, free: Sequence[int]) -> Array:
        """Return the derivatives of the residual with respect to some parameters, (P, k)."""
        derivatives, sigmas = np.zeros((len(self.index), len(free))), self.sigmas_in_units(values)
        for column, i in enumerate(free):
            if (row := self.row_of(i)) is not None:
                derivatives[row, column] = sigmas[row] ** -1
        return derivatives if self.whitening is None else np.asarray(self.whitening @ derivatives)

    def sigmas_in_units(self, values: Array) -> Array:
        """Return the standard deviations in the units of the parameters, (P,)."""
        return np.where(self._log, self.sigma * np.maximum(np.abs(values[self.index]), 1e-300), self.sigma)

    def row_of(self, i: int) -> int | None:
        """Return the index of a parameter among those with a prior; None if it has none."""
        return self._row.get(i)

    def rows(self, index: Iterable[int]) -> list[int]:
        """Return the indices of some parameters among those with a prior, without those that have none."""
        return [row for i in index if (row := self.row_of(i)) is not None]


def whitening_matrix(parameters: Sequence[Parameter]) -> Array | None:
    """Return the symmetric inverse root of the correlation of priors, (P, P); None if they are independent.

    - parameters: correlations with other parameters do not count

    Raises PkmodesError if the correlations are asymmetric or impossible.
    """
    index_of = {p.name: i for i, p in enumerate(parameters)}
    correlation = np.eye(len(parameters))
    for i, p in enumerate(parameters):
        for name, coefficient in p.correlated:
            if (k := index_of.get(name)) is not None and k != i:
                correlation[i, k] = coefficient
    is_off_diagonal = correlation != np.eye(len(correlation))
    correlated = np.flatnonzero(is_off_diagonal.any(axis=1) | is_off_diagonal.any(axis=0))
    if not len(correlated):
        return None
    submatrix = correlation[np.ix_(correlated, correlated)]
    values, vectors = np.linalg.eigh(0.5 * (submatrix + submatrix.T))
    if not np.allclose(submatrix, submatrix.T, rtol=0.0, atol=MAX_ROUNDING) or values[0] < -MAX_ROUNDING:
        names = ", ".join(parameters[i].name for i in correlated.tolist())
        problem = "expected a symmetric, positive semidefinite matrix of correlations, found another one"
        raise PkmodesError(
            problem, f"parameters {names}", "give each correlation with both of its parameters"
        )
    white = np.eye(len(parameters))
    white[np.ix_(correlated, correlated)] = (
        vectors / np.sqrt(np.maximum(values, MIN_EIGENVALUE))
    ) @ vectors.T
    return white
