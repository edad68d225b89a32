"""A hypothesis about what the declared model lacks, its fit, and the goodness of that fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.core.linalg.decomposition import thin_svd
from pkmodes.loop.diagnosis.fit.solver import correlation, inverse_of_square
from pkmodes.loop.diagnosis.match.pairing import Pairing
from pkmodes.loop.diagnosis.problem import Array, Candidate, Prediction

#: Smallest cosine of the angle between the changes of all modes by two parameters that count as the same.
MIN_COSINE = 1.0 - 1e-6


class Misfit(NamedTuple):
    """Sum of squares of a part of the data, and its degrees of freedom."""

    squares: float
    degrees: float

    @property
    def ratio(self) -> float:
        """Squares per degree of freedom: about 1 for noise."""
        return self.squares / max(self.degrees, 1.0)

    @property
    def p_value(self) -> float:
        """Probability of a sum at least as large for noise."""
        return float(stats.chi2.sf(self.squares, max(self.degrees, 1.0))) if self.degrees > 0.0 else 1.0


@dataclass(frozen=True)
class Hypothesis:
    """Assumptions beyond the declared model and its nuisances.

    - causes: added causes
    - excluded_rows: rows treated as outliers
    - has_shared_error: whether the modes of a setup share an error
    """

    causes: tuple[Candidate, ...] = ()
    excluded_rows: frozenset[int] = frozenset()
    has_shared_error: bool = False

    @property
    def remote(self) -> bool:
        """Whether it has a remote cause that is no term."""
        return any(cause.remote and not cause.form for cause in self.causes)

    def allows(self, cause: Candidate) -> bool:
        """Return whether a cause may be added: a whole and a part of it are one cause in two forms."""
        return not any(
            cause.part_of == own_cause.name or own_cause.part_of == cause.name for own_cause in self.causes
        )

    def with_cause(self, cause: Candidate) -> Hypothesis:
        """Return the hypothesis with an additional cause."""
        return replace(self, causes=(*self.causes, cause))

    def without(self, index: int) -> Hypothesis:
        """Return the hypothesis without one of its causes."""
        return replace(self, causes=(*self.causes[:index], *self.causes[index + 1 :]))


@dataclass(frozen=True, eq=False)
class Fitted:
    """Parameters fitted to data by least squares.

    - values: all parameters, (P,)
    - free: indices of the k fitted ones
    - white, jacobian: whitened residual of data and priors, and its derivatives with respect to the fitted
      parameters, (D,) and (D, k)
    """

    values: Array
    free: tuple[int, ...]
    white: Array
    jacobian: Array

    @property
    def chi2(self) -> float:
        """Whitened sum of squares, including shapes and priors."""
        return float(self.white @ self.white)

    @cached_property
    def covariance(self) -> Array:
        """Covariance of the fitted parameters, (k, k)."""
        return inverse_of_square(self.jacobian)

    @property
    def correlation(self) -> Array:
        """Correlation of the fitted parameters, (k, k)."""
        return correlation(self.covariance)

    def covariance_of(self, index: Sequence[int]) -> Array:
        """Return the covariance of some of the fitted parameters."""
        positions = [self.free.index(i) for i in index]
        return self.covariance[np.ix_(positions, positions)]

    def sigma_of(self, i: int) -> float:
        """Return the standard deviation of a fitted parameter."""
        k = self.free.index(i)
        return float(np.sqrt(self.covariance[k, k]))

    @cached_property
    def basis(self) -> Array:
        """Orthonormal basis of the column space of the Jacobian."""
        return orthonormal(self.jacobian)

    @cached_property
    def leverage(self) -> Array:
        """Diagonal of the projection onto that space: the leverage of each datum."""
        diagonal: Array = (self.basis**2).sum(axis=1)
        return diagonal


@dataclass(frozen=True, eq=False)
class Fit(Fitted):
    """A fitted hypothesis.

    The data are those of `Observations` (0 where not measured), then the priors.

    - free: nuisances first, then the parameters of the causes
    - log_determinant: log determinant of the covariance V of the data
    - shared_error: standard deviation of the error shared in a setup, tau
    - residual: measured minus model, of ln f clipped if unmatched, (D,); 0 if excluded
    - at_bound: parameters of causes at a bound other than their null value
    - converged: whether the solver converged
    """

    hypothesis: Hypothesis
    log_determinant: float
    shared_error: float
    prediction: Prediction
    pairing: Pairing
    residual: Array
    at_bound: tuple[str, ...]
    converged: bool

    @property
    def causes(self) -> tuple[Candidate, ...]:
        """Causes of the hypothesis."""
        return self.hypothesis.causes

    @property
    def deviance(self) -> float:
        """Twice the negative log likelihood."""
        return self.chi2 + self.log_determinant


def parallel_parameters(rates: Array) -> NDArray[np.bool_]:
    """Return which of T parameters change all modes alike, up to a factor, (T, T).

    - rates: derivatives of the eigenvalues, (S, m, T); modes for which some are unknown are left out
    """
    finite = rates[np.isfinite(rates).all(axis=-1)]
    size = np.linalg.norm(finite, axis=0)
    unit_columns = finite / np.where(size > 0.0, size, 1.0)
    return np.asarray(np.abs(unit_columns.T @ unit_columns) >= MIN_COSINE)


def orthonormal(columns: Array) -> Array:
    """Return an orthonormal basis of the columns, independent of their units."""
    size = np.linalg.norm(columns, axis=0)
    columns = columns[:, size > 0.0] / size[size > 0.0]
    if not columns.shape[1]:
        return np.zeros((len(columns), 0))
    u, s, _ = thin_svd(columns)
    basis: Array = u[:, s > 1e-9]
    return basis
