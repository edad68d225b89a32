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

#: Initial damping, relative to the diagonal; its factors after a successful and after a failed step.
DAMPING, LESS, MORE = 1e-3, 0.1, 10.0
LEAST_DAMPING = 1e-8
#: A fit has converged if a step promises less than this sum of squares, or less than this part of the current one.
ENOUGH, PART = 0.05, 1e-3


class Evaluated(NamedTuple):
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
    - used: used rows, (R,)
    - at: evaluation at these values; None if the structure cannot be evaluated
    - arrived: whether the descent has converged
    """

    values: Array
    free: tuple[int, ...]
    used: NDArray[np.bool_]
    at: Evaluated | None = None
    damping: float = DAMPING
    arrived: bool = False

    @property
    def chi2(self) -> float:
        """Current sum of squares."""
        return np.inf if self.at is None else self.at.chi2


class Lockstep:
    """Rough fits of many hypotheses about one structure and one set of measurements.

    - bounds: of all parameters, each (P,)
    - observations: their errors are taken as uncorrelated
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

    def descended(
        self, starts: Sequence[tuple[Array, tuple[int, ...], NDArray[np.bool_]]], steps: int
    ) -> list[Descent]:
        """Take at most `steps` steps from each start: values, free parameters, and used rows."""
        fits = [
            Descent(np.clip(values, self._lower, self._upper), free, used) for values, free, used in starts
        ]
        for fit, evaluated in zip(fits, self._evaluated(fits, [fit.values for fit in fits]), strict=True):
            fit.at = evaluated
        going = [fit for fit in fits if fit.free]
        for _ in range(steps):
            tried, values = [], []
            for fit in going:
                if fit.at is None:
                    continue
                there, promised = self._step(fit, fit.at)
                fit.arrived = promised <= max(ENOUGH, PART * fit.at.chi2)
                if not fit.arrived:
                    tried.append(fit)
                    values.append(there)
            for fit, there, evaluated in zip(tried, values, self._evaluated(tried, values), strict=True):
                if evaluated is not None and evaluated.chi2 < fit.chi2:
                    fit.values, fit.at = there, evaluated
                    fit.damping = max(fit.damping * LESS, LEAST_DAMPING)
                else:
                    fit.damping *= MORE
            going = tried
        return fits

    def _evaluated(self, fits: Sequence[Descent], values: Sequence[Array]) -> list[Evaluated | None]:
        """Evaluate each fit at given values."""
        evaluated: list[Evaluated | None] = [None] * len(fits)
        free_parameters, sigma = [fit.free for fit in fits], self._observations.noise.stated
        evaluated_sets = self._observations.evaluate_many(
            self._structure, np.array(values), free_parameters, [fit.used for fit in fits]
        )
        for k, residual, rate, prediction in evaluated_sets:
            white = np.concatenate([residual / sigma, self._priors.residual(values[k])])
            jacobian = np.vstack([-rate / sigma[:, None], self._priors.rates(values[k], free_parameters[k])])
            evaluated[k] = Evaluated(float(white @ white), white, jacobian, residual, prediction)
        return evaluated

    def _step(self, fit: Descent, now: Evaluated) -> tuple[Array, float]:
        """Return the values after a step within the bounds, and the decrease that the linear model promises."""
        index = list(fit.free)
        at, lower, upper = fit.values[index], self._lower[index], self._upper[index]
        gradient = now.jacobian.T @ now.white
        size = np.linalg.norm(now.jacobian, axis=0)
        scale = 1.0 / np.where(size > 0.0, size, 1.0)
        square = (now.jacobian.T @ now.jacobian) * scale[:, None] * scale
        square[np.diag_indices_from(square)] = 1.0 + fit.damping
        moving = ~(((at <= lower) & (gradient > 0.0)) | ((at >= upper) & (gradient < 0.0))) & (size > 0.0)
        step = np.zeros(len(index))
        while moving.any():
            active = np.flatnonzero(moving)
            step[:] = 0.0
            step[active] = -scale[active] * np.linalg.solve(
                square[np.ix_(active, active)], gradient[active] * scale[active]
            )
            # Parameters at a bound that the step would leave are fixed there.
            held = moving & (((at <= lower) & (step < 0.0)) | ((at >= upper) & (step > 0.0)))
            if not held.any():
                break
            moving &= ~held
            step[:] = 0.0
        there = np.clip(at + step, lower, upper)
        taken = there - at
        linear = now.white + now.jacobian @ taken
        values = fit.values.copy()
        values[index] = there
        return values, now.chi2 - float(linear @ linear)
