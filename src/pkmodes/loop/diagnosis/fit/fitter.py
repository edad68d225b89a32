r"""Fit a hypothesis to measured modes: bounded nonlinear least squares in whitened logarithms and shapes.

The residual is :math:`\ln f_{measured} - \ln f_{model}` and the shape residuals (`fit.shapes`), whitened with its
covariance (`fit.noise`).  Priors are additional residuals, so the least sum of squares of a true hypothesis is
chi-square distributed; its degrees of freedom are the number of data less the free parameters without a prior.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, Misfit
from pkmodes.loop.diagnosis.fit.lockstep import Descent, Lockstep
from pkmodes.loop.diagnosis.fit.noise import Whitening
from pkmodes.loop.diagnosis.fit.observations import Observations
from pkmodes.loop.diagnosis.fit.priors import Priors
from pkmodes.loop.diagnosis.fit.solver import bounded_least_squares
from pkmodes.loop.diagnosis.match.pairing import Pairing
from pkmodes.loop.diagnosis.problem import Array, Candidate, Parameter, Structure, reached_bounds
from pkmodes.loop.measured.measurements import Measurements

#: If there are more than twice this many setups, start values are determined from this many.
SUBSAMPLE_SETUPS = 12


class Fitter:
    """Fits hypotheses about one structure to one set of measurements.

    - structure: at the setups of the measurements
    - shape_scatter: standard deviation of shape components without a stated one, relative to the row's largest
    - prior_factor: factor by which all priors are wider than declared
    - parameters: the structure's parameters with replaced priors; by default its own
    """

    def __init__(
        self,
        structure: Structure,
        data: Measurements,
        criteria: Criteria | None = None,
        shape_scatter: float | None = None,
        *,
        prior_factor: float = 1.0,
        parameters: Sequence[Parameter] | None = None,
    ) -> None:
        self.structure, self.data = structure, data
        self.criteria = criteria or Criteria()
        self.shape_scatter = self.criteria.shapes.scatter if shape_scatter is None else shape_scatter
        self.parameters = tuple(structure.parameters if parameters is None else parameters)
        self._index_by_name = {p.name: i for i, p in enumerate(self.parameters)}
        self.declared = np.array([p.value for p in self.parameters])
        self.lower = np.array([p.lower for p in self.parameters])
        self.upper = np.array([p.upper for p in self.parameters])
        self.nuisance_indices = tuple(i for i, p in enumerate(self.parameters) if p.sigma)
        self._prior_factor = prior_factor
        self.priors = Priors(self.parameters, structure.candidates, prior_factor)
        reference = structure.predict(self.declared, ())
        self.observations = Observations(data, structure, reference, self.shape_scatter, self.criteria)
        self.prior_slice = slice(self.observations.size, None)

    def parameter_indices(self, cause: Candidate) -> tuple[int, ...]:
        """Return the indices of a cause's parameters."""
        return tuple(self._index_by_name[name] for name in cause.parameters)

    def pad_with_declared(self, values: Array) -> Array:
        """Append declared values to those of a fit that had only the first parameters."""
        return np.concatenate([values, self.declared[len(values) :]])

    def used_row_mask(self, hypothesis: Hypothesis) -> NDArray[np.bool_]:
        """Return a mask of the rows that a hypothesis does not exclude."""
        used_row_mask = self.observations.all_rows
        used_row_mask[list(hypothesis.excluded_rows)] = False
        return used_row_mask

    # Predictions -------------------------------------------------------------------------------------------

    @cached_property
    def subsample_fitter(self) -> Fitter:
        """The same fitter at some of the setups if there are many: enough to find start values."""
        count = len(self.data.labels)
        if count <= 2 * SUBSAMPLE_SETUPS:
            return self
        return self.at_setups([int((k + 0.5) * count / SUBSAMPLE_SETUPS) for k in range(SUBSAMPLE_SETUPS)])

    def at_setups(self, setups: list[int]) -> Fitter:
        """Return the fitter of some of the setups."""
        return Fitter(
            self.structure.subset(setups),
            self.data.at(setups),
            self.criteria,
            self.shape_scatter,
            prior_factor=self._prior_factor,
            parameters=self.parameters,
        )

    def chi2_of_many(self, trials: Sequence[tuple[Hypothesis, Array]]) -> list[float]:
        """Return sums of squares for several hypotheses and values, without fitting and without priors.

        They are inf where the structure cannot be evaluated.
        """
        sums, noise = [np.inf] * len(trials), self.observations.noise
        values = np.array([start for _, start in trials])
        used_row_masks = [self.used_row_mask(hypothesis) for hypothesis, _ in trials]
        for evaluation in self.observations.evaluate_many(
            self.structure, values, [()] * len(trials), used_row_masks
        ):
            white = evaluation.residual / noise.stated_sigma
            sums[evaluation.set_index] = float(white @ white)
        return sums

    def evaluate(
        self, values: Array, used_row_mask: NDArray[np.bool_], pairing: Pairing | None = None
    ) -> tuple[Pairing, Array, Array, float]:
        """Evaluate given values without any fit, including the errors of uncertain positions.

        - pairing: with the prediction of these values; by default the used rows are paired

        Returns, in this order:
        - pairing
        - residual, sigma: ln f measured minus model, and its standard deviation, (R,)
        - chi2: whitened sum of squares of the frequencies of the used rows
        """
        prediction = self.structure.predict(values, ())
        pairing = pairing or self.observations.pairer.pair(prediction, used_row_mask)
        position_rates = self._position_rates(values, pairing, used_row_mask)
        residual = self.observations.residual(prediction, pairing, used_row_mask)
        rows, noise = self.observations.frequency_slice, self.observations.noise
        white = noise.whitening(position_rates, used_row_mask, 0.0).whitened(residual)[rows]
        return pairing, residual[rows], noise.standard_deviations(position_rates), float(white @ white)

    # Fits --------------------------------------------------------------------------------------------------

    def fit(self, hypothesis: Hypothesis, start: Array | None = None) -> Fit | None:
        """Fit a hypothesis; None if the structure cannot be evaluated.

        - start: start values of all parameters; by default the declared ones
        """
        values = np.array(self.declared if start is None else start)
        free, used_row_mask = self._free_indices(hypothesis), self.used_row_mask(hypothesis)
        shared_error, previous_pairing, solver_converged = 0.0, None, True
        for _ in range(self.criteria.fits.rounds):
            prediction = self.structure.predict(values, ())
            if not np.isfinite(prediction.eigenvalues).all():
                return None
            pairing = self.observations.pairer.pair(prediction, used_row_mask, compare=False)
            is_same_pairing = previous_pairing is not None and np.array_equal(
                previous_pairing.partner, pairing.partner
            )
            if is_same_pairing and not hypothesis.has_shared_error:
                break  # the pairing is stable
            previous_pairing = pairing
            whitening = self._whitening(values, pairing, used_row_mask, shared_error)
            values, solver_converged = self._least_squares(values, free, pairing, used_row_mask, whitening)
            if hypothesis.has_shared_error:
                residual = self.observations.residual(
                    self.structure.predict(values, ()), pairing, used_row_mask
                )
                shared_error = self.observations.noise.shared_error(
                    residual, self._position_rates(values, pairing, used_row_mask), used_row_mask
                )
        return self._fit_result(hypothesis, values, free, used_row_mask, shared_error, solver_converged)

    def rough_descents(self, starts: Sequence[tuple[Hypothesis, Array]]) -> list[Descent]:
        """Take a few steps from all starts in lockstep.

        Shared errors and position errors are neglected.
        """
        lockstep = Lockstep(self.structure, (self.lower, self.upper), self.observations, self.priors)
        return lockstep.descend(
            [(values, self._free_indices(h), self.used_row_mask(h)) for h, values in starts],
            self.criteria.fits.rough_steps,
        )

    def rough_fit(self, hypothesis: Hypothesis, descent: Descent) -> Fit | None:
        """Return the result of a descent as a fit; None if the structure cannot be evaluated."""
        evaluation = descent.evaluation
        if evaluation is None:
            return None
        used_row_mask = self.used_row_mask(hypothesis)
        return Fit(
            hypothesis=hypothesis,
            values=descent.values,
            free=descent.free,
            log_determinant=self.observations.noise.whitening(None, used_row_mask, 0.0).log_determinant,
            shared_error=0.0,
            prediction=evaluation.prediction,
            pairing=self.observations.pairer.pair(evaluation.prediction, used_row_mask),
            residual=evaluation.residual,
            white=evaluation.white,
            jacobian=evaluation.jacobian,
            at_bound=self._parameters_at_bound(hypothesis, descent.values),
            converged=descent.converged,
        )

    def _free_indices(self, hypothesis: Hypothesis) -> tuple[int, ...]:
        """Return the indices of the fitted parameters: nuisances, then those of the causes, which may share some."""
        cause_indices = (i for cause in hypothesis.causes for i in self.parameter_indices(cause))
        return tuple(dict.fromkeys([*self.nuisance_indices, *cause_indices]))

    def _fit_result(
        self,
        hypothesis: Hypothesis,
        values: Array,
        free: tuple[int, ...],
        used_row_mask: NDArray[np.bool_],
        shared_error: float,
        converged: bool,
    ) -> Fit | None:
        prediction = self.structure.predict(values, free, shape_rates=self.observations.shape_rates)
        if not np.isfinite(prediction.eigenvalues).all():
            return None
        pairing = self.observations.pairer.pair(prediction, used_row_mask)
        whitening = self._whitening(values, pairing, used_row_mask, shared_error)
        residual = self.observations.residual(prediction, pairing, used_row_mask)
        white = np.concatenate([whitening.whitened(residual), self.priors.residual(values)])
        jacobian = np.vstack(
            [
                -whitening.whitened(self.observations.rates(prediction, pairing, used_row_mask)),
                self.priors.rates(values, free),
            ]
        )
        return Fit(
            hypothesis=hypothesis,
            values=values,
            free=free,
            log_determinant=whitening.log_determinant,
            shared_error=shared_error,
            prediction=replace(prediction, shape_rates=None),
            pairing=pairing,
            residual=residual,
            white=white,
            jacobian=jacobian,
            at_bound=self._parameters_at_bound(hypothesis, values),
            converged=converged,
        )

    def fit_at_values(self, hypothesis: Hypothesis, values: Array, shared_error: float) -> Fit | None:
        """Return given values as a fit of a hypothesis; None if the structure cannot be evaluated.

        - shared_error: standard deviation of the error that the modes of a setup share
        """
        free, used_row_mask = self._free_indices(hypothesis), self.used_row_mask(hypothesis)
        return self._fit_result(hypothesis, values, free, used_row_mask, shared_error, True)

    def squared_difference(self, a: Fit, b: Fit) -> float:
        """Return the squared difference of the predictions and priors of two fits, whitened as for the first."""
        common_row_mask = self.used_row_mask(a.hypothesis) & self.used_row_mask(b.hypothesis)
        position_rates = self._position_rates(a.values, a.pairing, common_row_mask)
        whitening = self.observations.noise.whitening(
            position_rates, self.used_row_mask(a.hypothesis), a.shared_error
        )
        data_difference = whitening.whitened(
            np.where(self.observations.data_mask(common_row_mask), a.residual - b.residual, 0.0)
        )
        prior_difference = self.priors.residual(a.values) - self.priors.residual(b.values)
        return float(data_difference @ data_difference + prior_difference @ prior_difference)

    def whitening(self, fit: Fit) -> Whitening:
        """Return the square root of the covariance of the data at a fit."""
        return self._whitening(fit.values, fit.pairing, self.used_row_mask(fit.hypothesis), fit.shared_error)

    def signatures(self, fit: Fit, parameter_indices: Sequence[int]) -> tuple[Array, Array]:
        """Return the derivatives with respect to some parameters.

        Those of ln f, (R, T), and those of the whitened data and priors, (D, T).
        """
        prediction = self.structure.predict(
            fit.values, parameter_indices, shape_rates=self.observations.shape_rates
        )
        used_row_mask = self.used_row_mask(fit.hypothesis)
        rates = self.observations.rates(prediction, fit.pairing, used_row_mask)
        whitening = self.whitening(fit)
        # The prior of a free parameter pulls it towards its declared value.
        return rates[self.observations.frequency_slice], np.vstack(
            [whitening.whitened(rates), -self.priors.rates(fit.values, parameter_indices)]
        )

    def misfit(self, fit: Fit, name: str, *, stated: bool) -> Misfit:
        """Return the misfit of a quantity other than the frequencies, for rows with (or without) a stated error."""
        observations, quantity = self.observations, self.observations.other_quantities[name]
        rows = self.used_row_mask(fit.hypothesis) & quantity.known & (quantity.stated == stated)
        squares = (observations.by_row(name, fit.white) ** 2).sum(axis=1)
        leverage = observations.by_row(name, fit.leverage).sum(axis=1)
        return Misfit(float(squares[rows].sum()), float(quantity.count[rows].sum() - leverage[rows].sum()))

    def rows_by_residual(self, fit: Fit) -> tuple[NDArray[np.intp], Array]:
        """Return the rows by descending frequency residual, and the residual of each in standard deviations, (R,)."""
        normalised_residuals = np.abs(
            fit.residual[self.observations.frequency_slice] / self.observations.sigma
        )
        return np.argsort(normalised_residuals)[::-1], normalised_residuals

    def _least_squares(
        self,
        values: Array,
        free: tuple[int, ...],
        pairing: Pairing,
        used_row_mask: NDArray[np.bool_],
        whitening: Whitening,
    ) -> tuple[Array, bool]:
        """Return the least-squares values for a given pairing, and whether the solver converged."""

        def residual(all_values: Array) -> Array:
            prediction = self.structure.predict(all_values, ())
            unwhitened = self.observations.residual(prediction, pairing.limited_to(prediction), used_row_mask)
            return np.concatenate([whitening.whitened(unwhitened), self.priors.residual(all_values)])

        def jacobian(all_values: Array) -> Array:
            prediction = self.structure.predict(all_values, free, shape_rates=self.observations.shape_rates)
            unwhitened = self.observations.rates(prediction, pairing.limited_to(prediction), used_row_mask)
            return np.vstack([-whitening.whitened(unwhitened), self.priors.rates(all_values, free)])

        bounds = self.lower[list(free)], self.upper[list(free)]
        return bounded_least_squares(residual, jacobian, values, free, bounds, self.criteria.fits.steps)

    def _parameters_at_bound(self, hypothesis: Hypothesis, values: Array) -> tuple[str, ...]:
        parameters = [
            (i, self.parameters[i]) for cause in hypothesis.causes for i in self.parameter_indices(cause)
        ]
        return tuple(
            p.name for i, p in parameters for bound in reached_bounds(p, values[i]) if bound != p.value
        )

    def _whitening(
        self, values: Array, pairing: Pairing, used_row_mask: NDArray[np.bool_], shared_error: float
    ) -> Whitening:
        position_rates = self._position_rates(values, pairing, used_row_mask)
        return self.observations.noise.whitening(position_rates, used_row_mask, shared_error)

    def _position_rates(
        self, values: Array, pairing: Pairing, used_row_mask: NDArray[np.bool_]
    ) -> Array | None:
        """Return the derivatives of the data with respect to uncertain positions, (D, d); None if there are none."""
        if not self.observations.noise.uncertain:
            return None
        prediction = self.structure.position_rates(values, shape_rates=self.observations.shape_rates)
        return None if prediction is None else self.observations.rates(prediction, pairing, used_row_mask)
