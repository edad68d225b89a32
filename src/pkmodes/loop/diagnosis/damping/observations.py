r"""Measured damping ratios beside what each loss would give, at the final model of the frequencies.

Errors of damping are factors, so ratios are compared by their logarithms.  The variance of each is

.. math:: (\sigma_\zeta / \zeta)^2 + s^2 + c^2

with the stated error, a floor s (`Criteria.damping.floor`), and the error c of the coefficients: how they change with
the fitted values of the model within their covariance, and how far they differ from those of a mode so close that
their shapes mix.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.problem import Array, Damped, Structure
from pkmodes.loop.measured.measurements import Measurements

Mask = NDArray[np.bool_]
#: Coefficients below this part of their median count as that part where their logarithms are compared.
NEGLIGIBLE = 1e-3
#: A ratio of 0 counts as this part of its standard deviation.
SMALLEST = 1e-3


@dataclass(frozen=True, eq=False)
class DampingObservations:
    """R measured damping ratios whose modes have a partner in the model, as the data of a fit.

    - index: rows of the measurements, (R,)
    - mode: numbers of the partners among the elastic modes of their setups, from 0, (R,)
    - ratio, stated: measured ratios and the standard deviations of their logarithms, (R,), as the file states them
    - unstated: root sum of squares of all other errors of the logarithms, (R,)
    - above: whether the ratio is significantly above 0, (R,); otherwise it only says that the mode is not damped more
    - frequency: (R,) [Hz]
    - least: ratio that a prediction of no damping counts as, (R,)
    - by_loss: damping ratio per unit of each loss, (R, J)
    """

    index: NDArray[np.intp]
    mode: NDArray[np.intp]
    ratio: Array
    stated: Array
    unstated: Array
    above: Mask
    frequency: Array
    least: Array
    by_loss: Array

    @property
    def sigma(self) -> Array:
        """Standard deviations of the logarithms, (R,)."""
        return np.hypot(self.stated, self.unstated)

    def some(self, mask: Mask) -> DampingObservations:
        """Return some of the rows."""
        return DampingObservations(*(getattr(self, name)[mask] for name in self.__dataclass_fields__))

    def with_errors(self, factor: float) -> DampingObservations:
        """Return the rows with stated errors larger by a factor."""
        return replace(self, stated=factor * self.stated)

    def with_scatter(self, scatter: float) -> DampingObservations:
        """Return the rows with a further error, a standard deviation of the logarithm."""
        return replace(self, unstated=np.hypot(self.unstated, scatter))

    # Beside predictions ------------------------------------------------------------------------------------

    @property
    def logarithms(self) -> Array:
        """Logarithms of the measured ratios, to be compared with those `predicted`, (R,)."""
        return np.asarray(np.log(self.ratio + self.least))

    def ratios(self, values: Array) -> Array:
        """Return the damping ratios of the model for values of the losses, (R,)."""
        return np.asarray(self.by_loss @ values)

    def predicted(self, values: Array) -> Array:
        """Return the logarithms of these ratios, (R,), which are finite where nothing dissipates."""
        return np.asarray(np.log(self.ratios(values) + self.least))

    def residual(self, values: Array) -> Array:
        """Return measured minus model in standard deviations, (R,): of logarithms, or of ratios not above 0.

        A ratio not above 0 has the stated error, and the model the others, which are parts of its ratio.
        """
        ratios = self.ratios(values)
        linear = (self.ratio - ratios) / np.hypot(self.stated * self.ratio, self.unstated * ratios)
        return np.where(self.above, (self.logarithms - self.predicted(values)) / self.sigma, linear)

    def rates(self, values: Array) -> Array:
        """Return the derivatives of the residual with respect to the losses, (R, J)."""
        ratios = self.ratios(values)
        variance = (self.stated * self.ratio) ** 2 + (self.unstated * ratios) ** 2
        linear = -(1.0 + (self.ratio - ratios) * self.unstated**2 * ratios / variance) / np.sqrt(variance)
        slopes = np.where(self.above, -1.0 / ((ratios + self.least) * self.sigma), linear)
        return np.asarray(slopes[:, None] * self.by_loss)


def observed(
    structure: Structure,
    data: Measurements,
    mode: NDArray[np.intp],
    states: Sequence[Array],
    criteria: Criteria,
) -> DampingObservations:
    """Return the rows with a damping ratio and a partner.

    - structure: at the setups of the measurements; one that knows what its modes dissipate
    - mode: number of the partner of each measured mode among the elastic modes of its setup, from 1, (rows,); 0
      without one
    - states: values of all parameters: those of the model, and each moved by one standard deviation of a combination
      that the fit leaves uncertain
    """
    assert isinstance(structure, Damped)
    index = np.flatnonzero(~np.isnan(data.damping) & (mode > 0))
    setup, number = data.pose[index], mode[index] - 1
    by_state = [structure.damping_rates(values) for values in states]
    at = by_state[0][setup, number]
    ratio = data.damping[index]
    stated = np.hypot(data.damping_sigma[index], criteria.damping.resolution)
    # A ratio of 0 with a standard deviation is known to be small; its logarithm is not used.
    ratio = np.where((ratio <= 0.0) & (data.damping_sigma[index] > 0.0), SMALLEST * stated, ratio)
    with np.errstate(divide="ignore", invalid="ignore"):
        stated = np.where(ratio > 0.0, stated / ratio, np.inf)
    logs = _logarithms(at)
    moved = [
        np.abs(_logarithms(rates[setup, number]) - logs).max(axis=1, initial=0.0) for rates in by_state[1:]
    ]
    mixed = _mixed(structure, states[0], by_state[0], setup, number, criteria)
    unstated = np.sqrt(criteria.damping.floor**2 + sum((d**2 for d in moved), mixed**2))
    above = stated < 1.0 / criteria.damping.resolved
    return DampingObservations(
        index=index,
        mode=number,
        ratio=ratio,
        stated=stated,
        unstated=unstated,
        above=above,
        frequency=data.frequency[index],
        least=criteria.damping.least * ratio,
        by_loss=at,
    )


def usable(rows: DampingObservations) -> Mask:
    """Return a mask of the rows that say something: a ratio of 0 without a standard deviation was not measured.

    Rows in which the measurements set the losses say nothing about them.
    """
    return np.isfinite(rows.stated) & np.isfinite(rows.by_loss).all(axis=1)


def _logarithms(rates: Array) -> Array:
    """Return logarithms of coefficients, (..., J), none far below the others of its loss."""
    flat = rates.reshape(-1, rates.shape[-1])
    typical = np.array([np.median(c[c > 0.0]) if (c > 0.0).any() else 1.0 for c in flat.T])
    return np.asarray(np.log(np.maximum(np.nan_to_num(rates), NEGLIGIBLE * typical)))


def _mixed(
    structure: Structure,
    values: Array,
    rates: Array,
    setup: NDArray[np.intp],
    number: NDArray[np.intp],
    criteria: Criteria,
) -> Array:
    """Return how far the shapes of close modes, which mix, leave the coefficients open, (R,).

    Between modes closer than `Criteria.pairing.close` nothing is known: half the difference of the coefficients
    counts.  With the distance of the frequencies, the angle by which a small error turns the shapes falls inversely.
    """
    prediction = structure.predict(values, ())
    logs = prediction.log_frequencies[:, prediction.rigid :]
    sizes, mixed = _logarithms(rates), np.zeros(len(setup))
    for i, (s, k) in enumerate(zip(setup, number, strict=True)):
        apart = np.abs(logs[s] - logs[s, k])
        apart[k] = np.inf
        part = np.where(
            apart < criteria.pairing.mixed,
            np.minimum(1.0, 0.5 * criteria.pairing.close / np.maximum(apart, 1e-12)),
            0.0,
        )
        mixed[i] = (0.5 * part[:, None] * np.abs(sizes[s] - sizes[s, k])).max(initial=0.0)
    return mixed
