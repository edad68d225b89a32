r"""Rough fits of many hypotheses in lockstep.

Evaluating all their models together takes little longer than evaluating one, so they descend together by a bounded
Levenberg-Marquardt method: each step solves :math:`(J^T J + \mu D) \delta = -J^T r` over the parameters that are not
at a bound, with a separate damping :math:`\mu` for each hypothesis (Nocedal and Wright, Numerical Optimization,
section 10.3).  Modes are paired again at every step.  Fits near the best are completed by `solver`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.observations import Observations
from pkmodes.loop.diagnosis.fit.priors import Priors
from pkmodes.loop.diagnosis.problem import Array, Prediction, Structure

#: Initial damping relative to the diagonal, and its factors after a successful and after a failed step.
INITIAL_DAMPING, DAMPING_DECREASE, DAMPING_INCREASE = 1e-3, 0.1, 10.0
MIN_DAMPING = 1e-8
#: A fit has converged if a step promises less than this sum of squares, or less than this part of the current one.
CONVERGED_DECREASE, CONVERGED_FRACTION = 0.05, 1e-3


class DescentEvaluation(NamedTuple):
    """A hypothesis evaluated at some values.

    - chi2: whitened sum of squares with priors
    - white, jacobian: whitened residual with priors, and its derivatives, (D,) and (D, k)
    - residual: (R + R C,)
    """

    chi2: float
    white: Array
    jacobian: Array
    residual: Array
    prediction: Prediction


@dataclass
class Descent:
    """The descent of one hypothesis.

    - values: values of all parameters, (P,)
    - free: indices of the free parameters
    - used_row_mask: used rows, (R,)
    - evaluation: evaluation at these values; None if the structure cannot be evaluated
    - converged: whether the descent has converged
    """

    values: Array
    free: tuple[int, ...]
    used_row_mask: NDArray[np.bool_]
    evaluation: DescentEvaluation | None = None
    damping: float = INITIAL_DAMPING
    converged: bool = False

    @property
    def chi2(self) -> float:
        """Current sum of squares."""
        return np.inf if self.evaluation is None else self.evaluation.chi2


class Lockstep:
    """Rough fits of many hypotheses about one structure and one set of measurements.

    - bounds: lower and upper bounds of all parameters, each (P,)
    - observations: measurements, whose errors are taken as uncorrelated
    """

    def __init__(
        self,
        structure: Structure,
        bounds: tuple[Array, Array],
        observations: Observations,
        priors: Priors,
    ) -> None:
        self._structure, self._observations, self._priors = structure, observations, priors
        self._lower, self._upper = bounds

    def descend(
        self, starts: Sequence[tuple[Array, tuple[int, ...], NDArray[np.bool_]]], steps: int
    ) -> list[Descent]:
        """Take at most `steps` steps from each start: values, free parameters, and used rows."""
        fits = [
            Descent(np.clip(values, self._lower, self._upper), free, used_row_mask)
            for values, free, used_row_mask in starts
        ]
        for fit, evaluation in zip(fits, self._evaluate(fits, [fit.values for fit in fits]), strict=True):
            fit.evaluation = evaluation
        active_fits = [fit for fit in fits if fit.free]
        for _ in range(steps):
            moving_fits, values = [], []
            for fit in active_fits:
                if fit.evaluation is None:
                    continue
                new_values, predicted_decrease = self._step(fit, fit.evaluation)
                fit.converged = predicted_decrease <= max(
                    CONVERGED_DECREASE, CONVERGED_FRACTION * fit.evaluation.chi2
                )
                if not fit.converged:
                    moving_fits.append(fit)
                    values.append(new_values)
            for fit, new_values, evaluation in zip(
                moving_fits, values, self._evaluate(moving_fits, values), strict=True
            ):
                if evaluation is not None and evaluation.chi2 < fit.chi2:
                    fit.values, fit.evaluation = new_values, evaluation
                    fit.damping = max(fit.damping * DAMPING_DECREASE, MIN_DAMPING)
                else:
                    fit.damping *= DAMPING_INCREASE
            active_fits = moving_fits
        return fits

    def _evaluate(self, fits: Sequence[Descent], values: Sequence[Array]) -> list[DescentEvaluation | None]:
        """Evaluate each fit at given values."""
        evaluations: list[DescentEvaluation | None] = [None] * len(fits)
        free_parameters, sigma = [fit.free for fit in fits], self._observations.noise.stated_sigma
        evaluated_sets = self._observations.evaluate_many(
            self._structure, np.array(values), free_parameters, [fit.used_row_mask for fit in fits]
        )
        for k, residual, rate, prediction in evaluated_sets:
            white = np.concatenate([residual / sigma, self._priors.residual(values[k])])
            jacobian = np.vstack([-rate / sigma[:, None], self._priors.rates(values[k], free_parameters[k])])
            evaluations[k] = DescentEvaluation(float(white @ white), white, jacobian, residual, prediction)
        return evaluations

    def _step(self, fit: Descent, evaluation: DescentEvaluation) -> tuple[Array, float]:
        """Return the values after a step within the bounds, and the decrease that the linear model promises."""
        index = list(fit.free)
        current, lower, upper = fit.values[index], self._lower[index], self._upper[index]
        gradient = evaluation.jacobian.T @ evaluation.white
        size = np.linalg.norm(evaluation.jacobian, axis=0)
        scale = 1.0 / np.where(size > 0.0, size, 1.0)
        normal_matrix = (evaluation.jacobian.T @ evaluation.jacobian) * scale[:, None] * scale
        normal_matrix[np.diag_indices_from(normal_matrix)] = 1.0 + fit.damping
        is_free = ~(((current <= lower) & (gradient > 0.0)) | ((current >= upper) & (gradient < 0.0))) & (
            size > 0.0
        )
        step = np.zeros(len(index))
        while is_free.any():
            active = np.flatnonzero(is_free)
            step[:] = 0.0
            step[active] = -scale[active] * np.linalg.solve(
                normal_matrix[np.ix_(active, active)], gradient[active] * scale[active]
            )
            # Parameters at a bound that the step would leave are fixed there.
            reaches_bound = is_free & (
                ((current <= lower) & (step < 0.0)) | ((current >= upper) & (step > 0.0))
            )
            if not reaches_bound.any():
                break
            is_free &= ~reaches_bound
            step[:] = 0.0
        new_values = np.clip(current + step, lower, upper)
        bounded_step = new_values - current
        linear_residual = evaluation.white + evaluation.jacobian @ bounded_step
        values = fit.values.copy()
        values[index] = new_values
        return values, evaluation.chi2 - float(linear_residual @ linear_residual)
