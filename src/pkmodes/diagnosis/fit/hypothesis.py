"""A hypothesis about what the declared model lacks, and a fit of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from pkmodes.diagnosis.match.pairing import Pairing
from pkmodes.diagnosis.problem import Array, Candidate, Prediction


@dataclass(frozen=True)
class Hypothesis:
    """What is assumed beyond the declared model and its nuisances.

    Attributes
    ----------
    causes : tuple of Candidate
        Added causes.
    excluded : frozenset of int
        Rows that are taken as outliers.
    scatter : bool
        Whether the modes of a setup share an error.
    """

    causes: tuple[Candidate, ...] = ()
    excluded: frozenset[int] = frozenset()
    scatter: bool = False

    def adding(self, cause: Candidate) -> Hypothesis:
        """Return the hypothesis with one cause more."""
        return replace(self, causes=(*self.causes, cause))


@dataclass(frozen=True)
class Fit:
    """A fitted hypothesis.

    The data are R frequencies, then R times C shape components (zeros where none was measured), then the priors.

    Attributes
    ----------
    hypothesis : Hypothesis
    values : ndarray, shape (number of parameters,)
        All parameters of the structure.
    free : tuple of int
        The fitted ones: nuisances first, then those of the causes.
    covariance : ndarray, shape (k, k)
        Of the fitted ones.
    chi2 : float
        Whitened sum of squares, shapes and priors included.
    deviance : float
        chi2 and the logarithm of the determinant of V: twice the negative log likelihood.
    scatter : float
        Standard deviation of the error shared in a setup, tau.
    prediction : Prediction
    pairing : Pairing
    residual : ndarray, shape (R + R C,)
        Measured minus model: ln f, clipped where there is no partner, and shapes; 0 where excluded.
    white, jacobian : ndarray, shape (R + R C + priors,) and (R + R C + priors, k)
        Whitened residual and its derivatives with respect to the fitted parameters.
    at_bound : tuple of str
        Parameters of causes that stopped at a bound other than their absence.
    converged : bool
        Whether the steps were enough.
    """

    hypothesis: Hypothesis
    values: Array
    free: tuple[int, ...]
    covariance: Array
    chi2: float
    deviance: float
    scatter: float
    prediction: Prediction
    pairing: Pairing
    residual: Array
    white: Array
    jacobian: Array
    at_bound: tuple[str, ...]
    converged: bool

    @property
    def causes(self) -> tuple[Candidate, ...]:
        """Causes of the hypothesis."""
        return self.hypothesis.causes

    @cached_property
    def basis(self) -> Array:
        """Orthonormal basis of the space of the data that the fit has used up."""
        return orthonormal(self.jacobian)

    @cached_property
    def leverage(self) -> Array:
        """Diagonal of the projection on that space: what part of each datum the fit took from itself."""
        found: Array = (self.basis**2).sum(axis=1)
        return found


def orthonormal(columns: Array) -> Array:
    """Orthonormal basis of the columns, whatever their units."""
    size = np.linalg.norm(columns, axis=0)
    columns = columns[:, size > 0.0] / size[size > 0.0]
    if not columns.shape[1]:
        return np.zeros((len(columns), 0))
    u, s, _ = np.linalg.svd(columns, full_matrices=False)
    basis: Array = u[:, s > 1e-9]
    return basis
