"""Fit losses to measured damping ratios: least squares in the logarithms of ratios, over positive losses.

The ratio of a mode is the sum over the losses of coefficient times value.  The logarithm of a measured ratio that is
not significantly above 0 has no normal error, but the ratio shows that the mode is not damped more.  The variables
are the logarithms of the fitted losses, so that a single loss without any declared one is a linear problem,
and none is ever negative.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy import stats
from scipy.optimize import least_squares

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping.observations import DampingObservations
from pkmodes.loop.diagnosis.fit.hypothesis import Fitted
from pkmodes.loop.diagnosis.fit.priors import Priors
from pkmodes.loop.diagnosis.problem import Array, Loss

#: A loss is absent below this part of the value that would explain a typical mode alone.
ABSENT_FRACTION = 1e-4
#: A loss is at its bound above this part of it.
AT_BOUND_FRACTION = 0.999
#: Start values of the largest loss and of the others, as parts of the values that would explain a typical mode alone.
#: Each loss is the largest in one start.
START_FRACTIONS = (0.9, 0.1)


@dataclass(frozen=True, eq=False)
class LossFit(Fitted):
    """Losses fitted to damping ratios; all parameters are the values of the J losses.

    - free: losses with a prior, then the causes
    - white: the residual of a row set aside is 0, (R + priors,)
    - causes: losses that may differ from their declared values
    - count, degrees: number R of ratios, and of residuals less the fitted losses without a prior
    - outlier: row set aside
    - absent_losses: fitted losses that are practically 0
    """

    causes: tuple[int, ...]
    count: int
    degrees: int
    outlier: int | None = None
    absent_losses: tuple[int, ...] = ()

    @cached_property
    def p_value(self) -> float:
        """Probability of residuals at least as large if they are noise."""
        return float(stats.chi2.sf(self.chi2, self.degrees)) if self.degrees > 0 else 1.0

    @property
    def price(self) -> float:
        """Penalty for a row set aside, which was chosen among all rows."""
        return 0.0 if self.outlier is None else 3.0 * float(np.log(self.count))

    @property
    def criterion(self) -> float:
        """Schwarz's criterion."""
        return self.chi2 + self.price + len(self.causes) * float(np.log(max(self.count, 2)))


@dataclass(frozen=True, eq=False)
class LossFitter:
    """Fits losses to damping ratios.

    - prior_factor: factor by which priors are wider than declared
    """

    observations: DampingObservations
    losses: tuple[Loss, ...]
    criteria: Criteria
    prior_factor: float = 1.0
    _fits: dict[object, LossFit] = field(default_factory=dict, repr=False)

    @property
    def nuisance_indices(self) -> tuple[int, ...]:
        """Losses with a prior."""
        return tuple(j for j, loss in enumerate(self.losses) if loss.parameter.sigma)

    @cached_property
    def candidates(self) -> tuple[int, ...]:
        """Losses that are suspected and affect some row."""
        return tuple(
            j for j, loss in enumerate(self.losses) if loss.candidate and self.typical_values[j] < np.inf
        )

    @cached_property
    def typical_values(self) -> Array:
        """Value of each loss that would give a typical row its ratio alone, (J,); inf if it affects no row."""
        rows = self.observations
        with np.errstate(divide="ignore"):
            sufficient_values = np.where(
                rows.coefficients > 0.0, rows.ratio[:, None] / rows.coefficients, np.inf
            )
        sufficient_values = (
            sufficient_values[rows.resolved_mask] if rows.resolved_mask.any() else sufficient_values
        )
        return (
            np.asarray(np.median(sufficient_values, axis=0))
            if len(sufficient_values)
            else np.full(len(self.losses), np.inf)
        )

    @cached_property
    def declared(self) -> Array:
        """Declared values, (J,)."""
        return np.array([loss.parameter.value for loss in self.losses])

    def with_observations(self, observations: DampingObservations) -> LossFitter:
        """Return the fitter of other observations."""
        return replace(self, observations=observations, _fits={})

    def with_changes(self, error_factor: float, prior_factor: float) -> LossFitter:
        """Return the fitter with stated errors and priors larger by factors."""
        observations = self.observations.with_errors(error_factor)
        return replace(self, observations=observations, prior_factor=prior_factor, _fits={})

    def fit(self, causes: Sequence[int] = (), fixed_values: dict[int, float] | None = None) -> LossFit:
        """Fit losses; a row that contradicts all others is set aside.

        - causes: losses that are fitted freely
        - fixed_values: values of some losses, which are not fitted
        """
        causes, fixed_values, c = tuple(causes), fixed_values or {}, self.criteria
        key = causes, tuple(fixed_values.items())
        if key in self._fits:
            return self._fits[key]
        fit = self._fit_once(causes, fixed_values, None)
        if fit.p_value <= c.gate.level and fit.count >= c.search.rows_to_set_aside:
            worst_row = int(np.abs(fit.white[: fit.count]).argmax())
            fit_without_row = self._fit_once(causes, fixed_values, worst_row)
            is_outlier = (
                abs(self.observations.residual(fit_without_row.values)[worst_row]) > c.damping.outlier
            )
            fit = fit_without_row if is_outlier and fit_without_row.p_value > c.gate.level else fit
        self._fits[key] = fit
        return fit

    def _fit_once(
        self, causes: tuple[int, ...], fixed_values: dict[int, float], outlier: int | None
    ) -> LossFit:
        rows, count = self.observations, len(self.observations.ratio)
        free = tuple(j for j in dict.fromkeys((*self.nuisance_indices, *causes)) if j not in fixed_values)
        index, values = list(free), self.declared.copy()
        for j, value in fixed_values.items():
            values[j] = value
        row_weights = np.where(np.arange(count) == outlier, 0.0, 1.0)
        parameters = [loss.parameter for loss in self.losses]
        prior_parameters = [
            replace(p, sigma=None) if j in fixed_values else p for j, p in enumerate(parameters)
        ]
        priors = Priors(prior_parameters, (), self.prior_factor)

        def values_at(x: Array) -> Array:
            all_values = values.copy()
            all_values[index] = np.exp(x)
            return all_values

        def residual(x: Array) -> Array:
            all_values = values_at(x)
            return np.concatenate([row_weights * rows.residual(all_values), priors.residual(all_values)])

        def jacobian(all_values: Array) -> Array:
            return np.vstack(
                [row_weights[:, None] * rows.rates(all_values)[:, index], priors.rates(all_values, free)]
            )

        def rates(x: Array) -> Array:
            return np.asarray(jacobian(values_at(x)) * np.exp(x))

        lower = np.log([ABSENT_FRACTION * 1e-2 * self._scale(j) for j in free])
        upper = np.log([max(parameters[j].upper, 0.0) for j in free])
        best, white = np.zeros(0), residual(np.zeros(0)) if not free else None
        for start in self._starts(free, causes):
            start_point = np.clip(start, lower + 1e-9, upper - 1e-9)
            solution = least_squares(
                residual, start_point, rates, (lower, upper), x_scale=1.0, xtol=1e-12, ftol=1e-12
            )
            if white is None or solution.fun @ solution.fun < white @ white:
                best, white = solution.x, solution.fun
        assert white is not None
        final_values = values_at(best)
        return LossFit(
            values=final_values,
            free=free,
            white=white,
            jacobian=jacobian(final_values),
            causes=causes,
            count=count,
            degrees=count - (outlier is not None) - sum(priors.row_of(j) is None for j in free),
            outlier=outlier,
            absent_losses=tuple(j for j in free if final_values[j] < ABSENT_FRACTION * self._scale(j)),
        )

    def _scale(self, j: int) -> float:
        """Return a typical value of a loss."""
        declared_size = self.declared[j] + (self.losses[j].parameter.sigma or 0.0)
        return float(self.typical_values[j] if np.isfinite(self.typical_values[j]) else declared_size or 1.0)

    def _starts(self, free: tuple[int, ...], causes: tuple[int, ...]) -> list[Array]:
        """Return start values of the logarithms of the fitted losses."""
        if not free:
            return []
        declared = {j: self.declared[j] or 0.1 * self._scale(j) for j in free}
        fractions_by_start = [
            {c: START_FRACTIONS[0] if c == largest_cause else START_FRACTIONS[1] for c in causes}
            for largest_cause in causes
        ] or [{}]
        return [
            np.log([fractions[j] * self._scale(j) if j in fractions else declared[j] for j in free])
            for fractions in fractions_by_start
        ]

    def squared_difference(self, a: LossFit, b: LossFit) -> float:
        """Return the squared difference of the predictions of two fits in standard deviations."""
        residual_difference = self.observations.residual(a.values) - self.observations.residual(b.values)
        return float(residual_difference @ residual_difference)
