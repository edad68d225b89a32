"""Fit losses to measured damping ratios: least squares in the logarithms of ratios, over positive losses.

The ratio of a mode is the sum of what each loss gives, coefficient times value.  A measured ratio that is not
significantly above 0 has no logarithm with a normal error, but says that the mode is not damped more.  The logarithm
of each fitted loss is the variable, so that a single loss without a declared one beside it is a linear problem, and
none is ever negative.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy import stats
from scipy.optimize import least_squares

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.damping.rows import DampingRows
from pkmodes.diagnosis.fit.priors import whitening
from pkmodes.diagnosis.fit.solver import inverse_of_square
from pkmodes.diagnosis.problem import Array, Loss

#: A loss below this part of what would explain a typical mode alone is absent.
ABSENT = 1e-4
#: A loss above this part of its bound is at the bound.
NEARLY = 0.999
#: Parts of a typical mode that fitted losses start from: each the largest once, and all alike.
PARTS = (0.9, 0.1)


@dataclass(frozen=True, eq=False)
class LossFit:
    """Losses fitted to damping ratios.

    Attributes
    ----------
    causes : tuple of int
        Losses that may differ from their declared values.
    free : tuple of int
        Fitted losses: those with a prior, then the causes.
    values : ndarray, shape (J,)
    white : ndarray, shape (R,)
        Residuals of the logarithms, measured minus predicted, in standard deviations; 0 for a row set aside.
    squares : float
        Sum of their squares and those of the priors.
    degrees : int
        Number of residuals less the fitted losses without a prior.
    covariance : ndarray, shape (k, k)
        Of the fitted losses.
    outlier : int or None
        Row set aside.
    absent : tuple of int
        Fitted losses that are practically 0.
    """

    causes: tuple[int, ...]
    free: tuple[int, ...]
    values: Array
    white: Array
    squares: float
    degrees: int
    covariance: Array
    outlier: int | None = None
    absent: tuple[int, ...] = ()

    @cached_property
    def p_value(self) -> float:
        """Probability of residuals at least as large if they are noise."""
        return float(stats.chi2.sf(self.squares, self.degrees)) if self.degrees > 0 else 1.0

    @property
    def price(self) -> float:
        """Squares that a row set aside costs: it was chosen among all rows."""
        return 0.0 if self.outlier is None else 3.0 * float(np.log(len(self.white)))

    @property
    def criterion(self) -> float:
        """Schwarz's criterion."""
        return self.squares + self.price + len(self.causes) * float(np.log(max(len(self.white), 2)))

    def sigma_of(self, loss: int) -> float:
        """Return the standard deviation of a fitted loss."""
        k = self.free.index(loss)
        return float(np.sqrt(self.covariance[k, k]))


@dataclass(frozen=True, eq=False)
class LossFitter:
    """Fits losses to damping ratios.

    Attributes
    ----------
    rows : DampingRows
    losses : tuple of Loss
    widened : float
        Factor by which priors are wider than declared.
    """

    rows: DampingRows
    losses: tuple[Loss, ...]
    criteria: Criteria
    widened: float = 1.0
    _fits: dict[object, LossFit] = field(default_factory=dict, repr=False)

    @property
    def nuisances(self) -> tuple[int, ...]:
        """Losses with a prior."""
        return tuple(j for j, loss in enumerate(self.losses) if loss.parameter.sigma)

    @cached_property
    def candidates(self) -> tuple[int, ...]:
        """Losses that are suspected and show in some row."""
        return tuple(j for j, loss in enumerate(self.losses) if loss.candidate and self.typical[j] < np.inf)

    @cached_property
    def typical(self) -> Array:
        """Value of each loss that alone would give a typical row its ratio, (J,); inf where it shows in none."""
        with np.errstate(divide="ignore"):
            alone = np.where(self.rows.rates > 0.0, self.rows.ratio[:, None] / self.rows.rates, np.inf)
        alone = alone[self.rows.above] if self.rows.above.any() else alone
        return np.asarray(np.median(alone, axis=0)) if len(alone) else np.full(len(self.losses), np.inf)

    @cached_property
    def declared(self) -> Array:
        """Declared values, (J,)."""
        return np.array([loss.parameter.value for loss in self.losses])

    @cached_property
    def least(self) -> Array:
        """What a prediction of no damping counts as, (R,)."""
        return self.criteria.damping.least * self.rows.ratio

    @cached_property
    def measured(self) -> Array:
        """Logarithms of the measured ratios, to be compared with `logarithms`, (R,)."""
        return np.log(self.rows.ratio + self.least)

    def with_errors(self, factor: float) -> LossFitter:
        """Return the fitter with other stated errors."""
        return replace(self, rows=self.rows.with_errors(factor), _fits={})

    def with_priors(self, factor: float) -> LossFitter:
        """Return the fitter with wider priors."""
        return replace(self, widened=factor, _fits={})

    def predicted(self, values: Array, rates: Array | None = None) -> Array:
        """Return the damping ratios for values of the losses, (R,)."""
        return np.asarray((self.rows.rates if rates is None else rates) @ values)

    def logarithms(self, values: Array) -> Array:
        """Return the logarithms of the predicted ratios, (R,), which are finite where nothing dissipates."""
        return np.log(self.predicted(values) + self.least)

    def whitened(self, values: Array) -> Array:
        """Return the residuals in standard deviations, (R,): of logarithms, or of ratios not above 0.

        A ratio not above 0 has the stated error, and the model the others, which are parts of its ratio.
        """
        rows, predicted = self.rows, self.predicted(values)
        stated, other = rows.stated * rows.ratio, rows.other * predicted
        linear = (rows.ratio - predicted) / np.hypot(stated, other)
        return np.where(rows.above, (self.measured - self.logarithms(values)) / rows.sigma, linear)

    def slopes(self, values: Array) -> Array:
        """Return the derivatives of these with respect to the predicted ratios, (R,)."""
        rows, predicted = self.rows, self.predicted(values)
        variance = (rows.stated * rows.ratio) ** 2 + (rows.other * predicted) ** 2
        linear = -(1.0 + (rows.ratio - predicted) * rows.other**2 * predicted / variance) / np.sqrt(variance)
        return np.where(rows.above, -1.0 / ((predicted + self.least) * rows.sigma), linear)

    def fit(self, causes: Sequence[int] = (), fixed: dict[int, float] | None = None) -> LossFit:
        """Fit losses; a row that contradicts all others is set aside.

        Parameters
        ----------
        causes : sequence of int
            Losses that are fitted freely.
        fixed : dict of int to float, optional
            Values of some losses, which are not fitted.
        """
        key = tuple(causes), tuple((fixed or {}).items())
        if key not in self._fits:
            self._fits[key] = self._robust(tuple(causes), fixed or {})
        return self._fits[key]

    def _robust(self, causes: tuple[int, ...], fixed: dict[int, float]) -> LossFit:
        c = self.criteria
        fit = self._fitted(causes, fixed, None)
        if fit.p_value > c.gate.level or len(fit.white) < c.search.rows_to_set_aside:
            return fit
        worst = int(np.abs(fit.white).argmax())
        without = self._fitted(causes, fixed, worst)
        gross = abs(self.whitened(without.values)[worst]) > c.damping.outlier
        return without if gross and without.p_value > c.gate.level else fit

    def _fitted(self, causes: tuple[int, ...], fixed: dict[int, float], outlier: int | None) -> LossFit:
        nuisances = self.nuisances
        free = tuple(j for j in dict.fromkeys((*nuisances, *causes)) if j not in fixed)
        values = self.declared.copy()
        for j, value in fixed.items():
            values[j] = value
        used = np.where(np.arange(len(self.rows.ratio)) == outlier, 0.0, 1.0)
        with_prior = [j for j in nuisances if j not in fixed]
        width = np.array([self.widened * (self.losses[j].parameter.sigma or np.inf) for j in with_prior])
        white, centre = np.diag(1.0 / width), self.declared[with_prior]
        if (mixed := whitening([self.losses[j].parameter for j in with_prior])) is not None:
            white = mixed / width

        def at(x: Array) -> Array:
            full = values.copy()
            full[list(free)] = np.exp(x)
            return full

        def residual(x: Array) -> Array:
            full = at(x)
            return np.concatenate([used * self.whitened(full), white @ (full[with_prior] - centre)])

        def rates(x: Array) -> Array:
            return by_value(at(x)) * np.exp(x)

        def by_value(full: Array) -> Array:
            prior = np.zeros((len(with_prior), len(free)))
            for k, j in enumerate(with_prior):
                prior[:, free.index(j)] = white[:, k]
            return np.vstack([(used * self.slopes(full))[:, None] * self.rows.rates[:, list(free)], prior])

        best, x = residual(np.zeros(0)) if not free else None, np.zeros(0)
        for start in self._starts(free, causes):
            lower = np.log([ABSENT * 1e-2 * self._scale(j) for j in free])
            upper = np.log([max(self.losses[j].parameter.upper, 0.0) for j in free])
            first = np.clip(start, lower + 1e-9, upper - 1e-9)
            found = least_squares(residual, first, rates, (lower, upper), x_scale=1.0, xtol=1e-12, ftol=1e-12)
            if best is None or found.fun @ found.fun < best @ best:
                best, x = found.fun, found.x
        assert best is not None
        full = at(x) if free else values
        count = len(used) - (outlier is not None)
        absent = tuple(j for j in free if full[j] < ABSENT * self._scale(j))
        return LossFit(
            causes=causes,
            free=free,
            values=full,
            white=best[: len(used)],
            squares=float(best @ best),
            degrees=count - len([j for j in free if j not in with_prior]),
            covariance=inverse_of_square(by_value(full)) if free else np.zeros((0, 0)),
            outlier=outlier,
            absent=absent,
        )

    def _scale(self, j: int) -> float:
        """Return a typical value of a loss."""
        own = self.declared[j] + (self.losses[j].parameter.sigma or 0.0)
        return float(self.typical[j] if np.isfinite(self.typical[j]) else own or 1.0)

    def _starts(self, free: tuple[int, ...], causes: tuple[int, ...]) -> list[Array]:
        """Return start values of the logarithms of the fitted losses."""
        if not free:
            return []
        declared = {j: self.declared[j] or 0.1 * self._scale(j) for j in free}
        shares = [{c: PARTS[0] if c == large else PARTS[1] for c in causes} for large in causes] or [{}]
        return [
            np.log([share[j] * self._scale(j) if j in share else declared[j] for j in free])
            for share in shares
        ]

    def difference(self, a: LossFit, b: LossFit) -> float:
        """Return the squared difference of the predictions of two fits in standard deviations."""
        apart = self.whitened(a.values) - self.whitened(b.values)
        return float(apart @ apart)
