r"""Fit a hypothesis to measured frequencies: bounded nonlinear least squares in whitened logarithms.

The residual is :math:`\ln f_{measured} - \ln f_{model}`, whitened with its covariance (`pkmodes.diagnosis.noise`).
Nuisance parameters add their priors as further residuals, so that the least sum of squares of a true
hypothesis is chi-square distributed with as many degrees of freedom as there are rows, less its free
parameters without prior.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from pkmodes.diagnosis.noise import Noise, Whitening, log_determinant
from pkmodes.diagnosis.pairing import REACH, Pairer, Pairing
from pkmodes.diagnosis.problem import Array, Candidate, Parameter, Prediction, Structure
from pkmodes.measured.measurements import Measurements

#: Steps of a fit; four or five are enough where the data tell.
MOST_STEPS = 18
#: Steps of a rough fit, which shows whether more are worth their time.
ROUGH_STEPS = 6
#: Rounds of pairing and fitting; the pairing is stable after two or three.
ROUNDS = 3
#: Length of the solver's first step, at least, in standard deviations.
FIRST_STEP = 10.0
#: Close eigenvalues: below this relative gap the derivatives of single modes are not defined.
REPEATED = 1e-7


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
        Whitened sum of squares, priors included.
    deviance : float
        chi2 and the logarithm of the determinant of V: twice the negative log likelihood.
    scatter : float
        Standard deviation of the error shared in a setup, tau.
    prediction : Prediction
    pairing : Pairing
    residual : ndarray, shape (R,)
        ln f measured minus model; clipped where there is no partner, 0 where excluded.
    white, jacobian : ndarray, shape (R + priors,) and (R + priors, k)
        Whitened residual and its derivatives by the fitted parameters.
    shape_misfit : ndarray, shape (R,)
        1 - MAC; 0 where no shape was measured or the row is excluded.
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
    shape_misfit: Array
    at_bound: tuple[str, ...]
    converged: bool

    @property
    def causes(self) -> tuple[Candidate, ...]:
        """Causes of the hypothesis."""
        return self.hypothesis.causes


class Fitter:
    """Fits hypotheses about one structure to one set of measurements.

    Parameters
    ----------
    structure : Structure
        At the setups of the measurements.
    data : Measurements
    """

    def __init__(self, structure: Structure, data: Measurements) -> None:
        self.structure, self.data = structure, data
        self.parameters: tuple[Parameter, ...] = structure.parameters
        self._index = {p.name: i for i, p in enumerate(self.parameters)}
        self.declared = np.array([p.value for p in self.parameters])
        self.nuisances = tuple(i for i, p in enumerate(self.parameters) if p.sigma)
        self.log = np.log(data.frequency)
        self.noise = Noise(data)
        self.sigma = self.noise.sigma
        self.pairer = Pairer(data, structure.channels, structure.predict(self.declared, ()))

    def indices(self, cause: Candidate) -> tuple[int, ...]:
        """Indices of a cause's parameters."""
        return tuple(self._index[name] for name in cause.parameters)

    def used(self, hypothesis: Hypothesis) -> NDArray[np.bool_]:
        """Rows that take part."""
        used = np.ones(len(self.log), dtype=bool)
        used[list(hypothesis.excluded)] = False
        return used

    # Predictions -------------------------------------------------------------------------------------------

    def residual(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Measured minus model in ln f; a mode that the model lacks counts with the reach of the pairing."""
        logs = prediction.log_frequencies[self.data.pose, np.maximum(pairing.partner, 0)]
        found = np.clip(self.log - logs, -REACH, REACH)
        found = np.where(pairing.partner >= 0, found, REACH)
        return np.where(used, found, 0.0)

    def rates(self, prediction: Prediction, pairing: Pairing) -> Array:
        """Derivatives of ln f of the partners by the parameters that were asked for, (R, T)."""
        rates = _averaged(prediction)
        found = rates[self.data.pose, np.maximum(pairing.partner, 0)]
        return np.asarray(np.where((pairing.partner >= 0)[:, None], found, 0.0))

    def chi2_of(self, values: Array, hypothesis: Hypothesis) -> float:
        """Sum of squares of the frequencies alone at these values, without any fit; infinite out of reach."""
        prediction = self.structure.predict(values, ())
        if not np.isfinite(prediction.eigenvalues).all():
            return np.inf
        used = self.used(hypothesis)
        pairing = self.pairer.pair(prediction, used, compare=False)
        residual = self.residual(prediction, pairing, used)
        return float(np.sum((residual / self.sigma) ** 2))

    def unfitted(self, values: Array, used: NDArray[np.bool_]) -> tuple[Pairing, Array, Array, float]:
        """What these values give without any fit, the errors of uncertain positions counted.

        Returns
        -------
        pairing : Pairing
        residual, sigma : ndarray, shape (R,)
            ln f measured minus model, and its standard deviation.
        chi2 : float
            Whitened sum of squares of the rows in use.
        """
        prediction = self.structure.predict(values, ())
        pairing = self.pairer.pair(prediction, used)
        motion = self._motion(values, pairing)
        residual = self.residual(prediction, pairing, used)
        white = self.noise.whitened(residual, self.noise.whitening(motion, used, 0.0))
        return pairing, residual, self.noise.standard_deviations(motion), float(white @ white)

    # Fits --------------------------------------------------------------------------------------------------

    def fit(self, hypothesis: Hypothesis, start: Array | None = None, *, rough: bool = False) -> Fit | None:
        """Fit a hypothesis; None where the structure cannot be evaluated.

        Parameters
        ----------
        hypothesis : Hypothesis
        start : ndarray, optional
            Values of all parameters to begin with; by default the declared ones.
        rough : bool, optional
            Stop after a few steps, wherever they lead.
        """
        values = np.array(self.declared if start is None else start)
        added = (i for cause in hypothesis.causes for i in self.indices(cause))
        free = tuple(dict.fromkeys([*self.nuisances, *added]))  # causes may share a parameter
        used, tau, pairing, converged = self.used(hypothesis), 0.0, None, True
        steps = ROUGH_STEPS if rough else MOST_STEPS
        for _ in range(ROUNDS):
            prediction = self.structure.predict(values, ())
            if not np.isfinite(prediction.eigenvalues).all():
                return None
            before, pairing = pairing, self.pairer.pair(prediction, used, compare=False)
            if (
                before is not None
                and np.array_equal(before.partner, pairing.partner)
                and not hypothesis.scatter
            ):
                break
            whitening = self.noise.whitening(self._motion(values, pairing), used, tau)
            values, converged = self._least_squares(values, free, pairing, used, whitening, steps)
            if hypothesis.scatter:
                residual = self.residual(self.structure.predict(values, ()), pairing, used)
                tau = self.noise.shared_error(residual, self._motion(values, pairing), used)
        return self._finished(hypothesis, values, free, used, tau, converged)

    def _finished(
        self,
        hypothesis: Hypothesis,
        values: Array,
        free: tuple[int, ...],
        used: NDArray[np.bool_],
        tau: float,
        converged: bool,
    ) -> Fit | None:
        prediction = self.structure.predict(values, free)
        if not np.isfinite(prediction.eigenvalues).all():
            return None
        pairing = self.pairer.pair(prediction, used)
        whitening = self.noise.whitening(self._motion(values, pairing), used, tau)
        residual = self.residual(prediction, pairing, used)
        white = np.concatenate([self.noise.whitened(residual, whitening), self._prior(values)])
        jacobian = np.vstack(
            [-self.noise.whitened(self.rates(prediction, pairing), whitening), self._prior_rates(free)]
        )
        chi2 = float(white @ white)
        lacking = np.where(np.isnan(pairing.mac), 0.0, 1.0 - pairing.mac)
        return Fit(
            hypothesis=hypothesis,
            values=values,
            free=free,
            covariance=_inverse_of_square(jacobian),
            chi2=chi2,
            deviance=chi2 + log_determinant(whitening),
            scatter=tau,
            prediction=prediction,
            pairing=pairing,
            residual=residual,
            white=white,
            jacobian=jacobian,
            shape_misfit=np.where(used, lacking, 0.0),
            at_bound=self._at_bound(hypothesis, values),
            converged=converged,
        )

    def difference(self, a: Fit, b: Fit) -> float:
        """Sum of squares by which the predictions and nuisances of two fits differ, whitened as the first is."""
        used = self.used(a.hypothesis) & self.used(b.hypothesis)
        whitening = self.noise.whitening(
            self._motion(a.values, a.pairing), self.used(a.hypothesis), a.scatter
        )
        between = self.noise.whitened(np.where(used, a.residual - b.residual, 0.0), whitening)
        priors = self._prior(a.values) - self._prior(b.values)
        return float(between @ between + priors @ priors)

    def signatures(self, fit: Fit, by: Sequence[int]) -> tuple[Array, Array]:
        """Derivatives of ln f by parameters at a fit, (R, T), and whitened with no priors, (R + priors, T)."""
        prediction = self.structure.predict(fit.values, by)
        used = self.used(fit.hypothesis)
        rates = np.where(used[:, None], self.rates(prediction, fit.pairing), 0.0)
        whitening = self.noise.whitening(self._motion(fit.values, fit.pairing), used, fit.scatter)
        return rates, np.vstack(
            [self.noise.whitened(rates, whitening), np.zeros((len(self.nuisances), len(by)))]
        )

    def _least_squares(
        self,
        values: Array,
        free: tuple[int, ...],
        pairing: Pairing,
        used: NDArray[np.bool_],
        whitening: Whitening,
        steps: int,
    ) -> tuple[Array, bool]:
        if not free:
            return values, True
        index = list(free)
        lower = np.array([self.parameters[i].lower for i in free])
        upper = np.array([self.parameters[i].upper for i in free])

        first = np.clip(values[index], lower, upper)

        def rates(full: Array) -> Array:
            found = self.rates(self.structure.predict(full, free), pairing)
            found = np.where(used[:, None], found, 0.0)
            return np.vstack([-self.noise.whitened(found, whitening), self._prior_rates(free)])

        # Solved in units of one standard deviation each, the solver's limits then mean the same in kg and in Pa; and
        # away from 0, because its first step is as long as its start: a cause that is absent would stay so.
        start = values.copy()
        start[index] = first
        size = np.linalg.norm(rates(start), axis=0)
        unit = 1.0 / np.where(size > 0.0, size, 1.0)
        origin = first - np.maximum(np.abs(first), FIRST_STEP * unit)

        def at(u: Array) -> Array:
            full = values.copy()
            full[index] = np.clip(origin + u * unit, lower, upper)
            return full

        def residual(u: Array) -> Array:
            full = at(u)
            found = self.residual(self.structure.predict(full, ()), pairing, used)
            return np.concatenate([self.noise.whitened(found, whitening), self._prior(full)])

        def jacobian(u: Array) -> Array:
            return np.asarray(rates(at(u)) * unit)

        bounds = ((lower - origin) / unit, (upper - origin) / unit)
        found = least_squares(
            residual,
            (first - origin) / unit,
            jacobian,
            bounds,
            ftol=1e-6,
            xtol=1e-8,
            gtol=1e-8,
            max_nfev=steps,
        )
        return at(found.x), bool(found.status > 0)

    def _prior(self, values: Array) -> Array:
        return np.array(
            [(values[i] - self.declared[i]) / (self.parameters[i].sigma or 1.0) for i in self.nuisances]
        )

    def _prior_rates(self, free: tuple[int, ...]) -> Array:
        rates = np.zeros((len(self.nuisances), len(free)))
        for row, i in enumerate(self.nuisances):
            rates[row, free.index(i)] = 1.0 / (self.parameters[i].sigma or 1.0)
        return rates

    def _at_bound(self, hypothesis: Hypothesis, values: Array) -> tuple[str, ...]:
        found = []
        for cause in hypothesis.causes:
            for i in self.indices(cause):
                p = self.parameters[i]
                width = max(abs(p.value), abs(values[i])) * 1e-3
                for bound in (p.lower, p.upper):
                    if bound != p.value and np.isfinite(bound) and abs(values[i] - bound) <= width:
                        found.append(p.name)
        return tuple(found)

    def _motion(self, values: Array, pairing: Pairing) -> Array | None:
        """Derivatives of ln f of the partners by the position of their setup, (R, 3), where it is uncertain."""
        rates = self.structure.position_rates(values) if self.noise.uncertain else None
        if rates is None:
            return None
        eigenvalues = self.structure.predict(values, ()).eigenvalues
        return self.rates(Prediction(eigenvalues, rates, rates), pairing)


def _inverse_of_square(jacobian: Array) -> Array:
    """Inverse of J^T J, columns scaled; what the data do not determine gets a very large variance."""
    if not jacobian.shape[1]:
        return np.zeros((0, 0))
    size = np.linalg.norm(jacobian, axis=0)
    scale = np.where(size > 0.0, 1.0 / np.where(size > 0.0, size, 1.0), 1.0)
    _, s, vt = np.linalg.svd(jacobian * scale, full_matrices=False)
    weights = 1.0 / np.maximum(s, 1e-8) ** 2
    found: Array = (vt.T * weights) @ vt * scale[:, None] * scale
    return found


def _averaged(prediction: Prediction) -> Array:
    """Derivatives of ln f; those of repeated modes, which have none of their own, are the group's mean."""
    rates = np.array(prediction.log_rates)
    eigenvalues = prediction.eigenvalues
    gap = np.diff(eigenvalues, axis=1) <= REPEATED * np.abs(eigenvalues[:, 1:])
    for setup in np.flatnonzero(gap.any(axis=1)):
        number = np.concatenate([[0], np.cumsum(~gap[setup])])
        for k in np.unique(number):
            members = number == k
            if (
                members.sum() > 1 and np.isfinite(rates[setup, members]).all()
            ):  # rigid modes have none at 0 Hz
                rates[setup, members] = rates[setup, members].mean(axis=0)
    return rates
