"""A cache of fits, with their goodness of fit and criterion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.fit.cross_validation import predict_left_out
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, Misfit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.problem import Array, Candidate

#: A further parameter of a term does not count within this many standard deviations of 0.
ABSENT_SIGMAS = 1e-3

Key = tuple[frozenset[str], frozenset[int], bool]


def key(hypothesis: Hypothesis) -> Key:
    """Return a key of a hypothesis that is independent of the order of its causes."""
    return frozenset(c.name for c in hypothesis.causes), hypothesis.excluded_rows, hypothesis.has_shared_error


class FitStore:
    """Fits of hypotheses about one structure and one set of measurements.

    - previous: fits of the same data with other errors, which give start values
    """

    def __init__(self, fitter: Fitter, previous: FitStore | None = None) -> None:
        self.fitter = fitter
        previous_fits = {} if previous is None else previous._fits
        self._start_values = {k: fit.values for k, fit in previous_fits.items() if fit is not None}
        self._rows = len(fitter.observations.log_frequencies)
        self._data = fitter.observations.degrees_of_freedom(fitter.observations.all_rows)
        self._fits: dict[Key, Fit | None] = {}
        self._rough_keys: set[Key] = set()
        self._started: set[Key] = set()

    # Fits ------------------------------------------------------------------------------------------------------

    def fit(self, hypothesis: Hypothesis, start: Array | None = None) -> Fit | None:
        """Fit a hypothesis once; a rough fit is improved from the first start given."""
        k = key(hypothesis)
        if k not in self._fits:
            self._fits[k] = self.fitter.fit(
                hypothesis, self.start_values(hypothesis) if start is None else start
            )
            self._started.add(k)
        elif start is not None and k not in self._started:
            self._started.add(k)
            refit, previous = self.fitter.fit(hypothesis, start), self._fits[k]
            if refit is not None and (previous is None or refit.deviance < previous.deviance):
                self._fits[k] = refit
                self._rough_keys.discard(k)
        fit = self._fits[k]
        # The causes are in the order of the requested hypothesis.
        return fit if fit is None or fit.hypothesis == hypothesis else replace(fit, hypothesis=hypothesis)

    def refit(self, hypothesis: Hypothesis, start: Array) -> Fit | None:
        """Fit again from another start, and keep the better fit."""
        k = key(hypothesis)
        refit, previous = self.fitter.fit(hypothesis, start), self._fits.get(k)
        if refit is not None and (previous is None or refit.deviance < previous.deviance):
            self._fits[k] = refit
            self._rough_keys.discard(k)
        return self.fit(hypothesis)

    def is_fitted(self, hypothesis: Hypothesis) -> bool:
        """Return whether a hypothesis was already fitted."""
        return key(hypothesis) in self._fits

    def rough_fits(self, jobs: Sequence[tuple[Hypothesis, Sequence[Array]]]) -> list[Fit]:
        """Fit several hypotheses roughly, each from the best of several starts, and return those that succeed."""
        starts = [(hypothesis, values) for hypothesis, guesses in jobs for values in guesses]
        descents, fits = iter(self.fitter.rough_descents(starts)), []
        for hypothesis, guesses in jobs:
            best, k = (
                min((next(descents) for _ in guesses), key=lambda descent: descent.chi2),
                key(hypothesis),
            )
            if (
                hypothesis.has_shared_error or self.fitter.observations.noise.uncertain
            ):  # correlated errors: the rough fit is only a start
                self._fits[k] = self.fitter.fit(hypothesis, best.values)
            else:
                self._fits[k] = self.fitter.rough_fit(hypothesis, best)
                self._rough_keys.add(k)
            fits.append(self.fit(hypothesis))
        return [fit for fit in fits if fit is not None]

    def complete(self, fits: list[Fit]) -> list[Fit]:
        """Complete the rough fits among the best until none of these is rough; return all, best first."""
        c = self.fitter.criteria
        while fits:
            fits = sorted(fits, key=self.criterion)
            best = self.criterion(fits[0])
            # A converged fit is completed only if it may survive, or belong to the class of a survivor.
            limits = {True: best + c.search.survives + c.claim.told_apart, False: best + c.search.nearly}
            rough_index = next(
                (
                    i
                    for i, fit in enumerate(fits)
                    if key(fit.hypothesis) in self._rough_keys
                    and (i < c.search.best_few or self.criterion(fit) <= limits[fit.converged])
                ),
                None,
            )
            if rough_index is None:
                break
            k = key(fits[rough_index].hypothesis)
            self._rough_keys.discard(k)
            self._fits[k] = (
                self.fitter.fit(fits[rough_index].hypothesis, fits[rough_index].values) or fits[rough_index]
            )
            fits[rough_index] = self.fit(fits[rough_index].hypothesis) or fits[rough_index]
        return fits

    def start_values(self, hypothesis: Hypothesis) -> Array | None:
        """Return the values that the fit of a hypothesis reached with other errors."""
        return self._start_values.get(key(hypothesis))

    def all_fits(self) -> tuple[Fit, ...]:
        """Return all fits so far."""
        return tuple(fit for fit in self._fits.values() if fit is not None)

    def fit_without(self, fit: Fit, index: int) -> Fit | None:
        """Return the fit without one of its causes."""
        reduced = fit.hypothesis.without(index)
        return self.fit(reduced, self.values_without(fit, reduced))

    def values_without(self, fit: Fit, hypothesis: Hypothesis) -> Array:
        """Return the values of a fit, with the declared values for causes that a hypothesis does not have."""
        values = fit.values.copy()
        for cause in fit.causes:
            if cause not in hypothesis.causes:
                index = list(self.fitter.parameter_indices(cause))
                values[index] = self.fitter.declared[index]
        return values

    # Goodness of fit -------------------------------------------------------------------------------------------

    def degrees(self, fit: Fit) -> int:
        """Return the degrees of freedom: data less parameters without prior, excluded rows and the shared error."""
        h, fitter = fit.hypothesis, self.fitter
        count = fitter.observations.degrees_of_freedom(fitter.used_row_mask(h))
        return (
            count
            - sum(fitter.priors.row_of(i) is None for i in self.added_parameters(fit))
            - int(h.has_shared_error)
        )

    def p_value(self, fit: Fit) -> float:
        """Return the smallest p-value: of the frequencies with priors, and of other quantities with stated errors."""
        misfits = (
            self.fitter.misfit(fit, name, stated=True) for name in self.fitter.observations.other_quantities
        )
        return min(self.frequency_p_value(fit), *(misfit.p_value for misfit in misfits))

    def frequency_p_value(self, fit: Fit) -> float:
        """Return the p-value of the frequencies and priors alone."""
        squares, degrees = self.frequency_misfit(fit)
        return float(stats.chi2.sf(squares, max(degrees, 1.0)))

    def frequency_misfit(self, fit: Fit) -> Misfit:
        """Return the misfit of the frequencies and priors."""
        fitter, h, rows = self.fitter, fit.hypothesis, self.fitter.observations.frequency_slice
        if rows.stop == fitter.observations.size:
            return Misfit(fit.chi2, float(self.degrees(fit)))
        priors = fitter.priors.rows(fit.free)
        parts = [fit.leverage[rows], fit.leverage[fitter.prior_slice][priors]]
        white = [fit.white[rows], fit.white[fitter.prior_slice]]
        leverage = sum(float(part.sum()) for part in parts)
        count = self._rows - len(h.excluded_rows) + len(priors) - int(h.has_shared_error)
        return Misfit(sum(float(part @ part) for part in white), count - leverage)

    def criterion(self, fit: Fit) -> float:
        """Return the evidence against a fit: deviance plus a penalty for each addition; smaller is better.

        The penalty of a parameter is the logarithm of the number of data (Schwarz's BIC).  With a prior it is
        2 ln(prior sigma / sigma), from Laplace's approximation of the evidence.  Excluded rows have a separate
        penalty, and so have prior odds below 1.
        """
        h, fitter = fit.hypothesis, self.fitter
        price, per_parameter = sum(map(_odds, fit.causes), 0.0), self.parameter_price
        for i in self.added_parameters(fit):
            row = fitter.priors.row_of(i)
            if row is None:
                price += per_parameter
            else:
                k = fit.free.index(i)
                prior_sigma = fitter.priors.sigmas_in_units(fit.values)[row]
                price += max(float(np.log(prior_sigma**2 / max(fit.covariance[k, k], 1e-300))), 0.0)
        count = int(h.has_shared_error) + fitter.criteria.search.price_of_row * len(h.excluded_rows)
        return fit.deviance + price + per_parameter * count

    def price(self, candidate: Candidate) -> float:
        """Return the penalty of a candidate in the criterion, for its parameters without prior and its odds."""
        free = [i for i in self.fitter.parameter_indices(candidate) if self.fitter.priors.row_of(i) is None]
        return self.parameter_price * len(free) + _odds(candidate)

    @property
    def parameter_price(self) -> float:
        """Penalty of a parameter without prior in the criterion."""
        return float(np.log(self._data))

    def improves_prediction(self, fit: Fit, index: int | None = None) -> bool:
        """Return whether one of the causes, by default the last, improves the prediction of left-out setups."""
        reduced = self.fit_without(fit, len(fit.causes) - 1 if index is None else index)
        if reduced is None:
            return True
        data_indices, priors = self.fitter.observations.data_indices_by_setup(), self.fitter.prior_slice
        squares, leverage = predict_left_out(fit, data_indices)
        is_predicted = leverage < self.fitter.criteria.claim.alone
        baseline = predict_left_out(reduced, data_indices)[0]
        # A cause is credited for letting the nuisances stay near their declared values.
        prior_gain = float((reduced.white[priors] ** 2).sum() - (fit.white[priors] ** 2).sum())
        return is_predicted.sum() < 2 or bool(
            squares[is_predicted].sum() < baseline[is_predicted].sum() + prior_gain
        )

    def shape_scatter(self, fit: Fit) -> float | None:
        """Return the scatter of the shapes without stated errors at a fit; None if there are too few."""
        squares, degrees = self.fitter.misfit(fit, SHAPE, stated=False)
        if degrees < 1.0:
            return None
        return float(np.sqrt(squares / degrees)) * self.fitter.shape_scatter

    def added_parameters(self, fit: Fit) -> list[int]:
        """Return the indices of the parameters that the causes of a fit add.

        A further parameter of a term that is 0, such as the mass of a support, has no effect and is left out.
        """
        added_indices: list[int] = []
        for cause in fit.causes:
            first, *further_indices = self.fitter.parameter_indices(cause)
            added_indices.append(first)
            for i in further_indices:
                is_absent = (
                    cause.form
                    and self.fitter.parameters[i].value == 0.0
                    and abs(float(fit.values[i])) <= ABSENT_SIGMAS * fit.sigma_of(i)
                )
                if not is_absent:
                    added_indices.append(i)
        return added_indices


def _odds(candidate: Candidate) -> float:
    """Return the penalty of the prior odds of a candidate, on the scale of the deviance."""
    return -2.0 * float(np.log(candidate.odds))
