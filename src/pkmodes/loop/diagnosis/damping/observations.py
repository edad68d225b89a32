r"""Measured damping ratios, and those that each loss would give, at the final model of the frequencies.

Errors of damping are factors, so ratios are compared by their logarithms.  The variance of each is

.. math:: (\sigma_\zeta / \zeta)^2 + s^2 + c^2

with the stated error, a floor s (`Criteria.damping.floor`), and the error c of the coefficients: how they change with
the fitted values of the model within their covariance, and how far they differ from the coefficients of a mode so
close that the shapes mix.
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
#: Coefficients are raised to at least this part of their median where their logarithms are compared.
NEGLIGIBLE_FRACTION = 1e-3
#: A ratio of 0 counts as this part of its standard deviation.
ZERO_RATIO_FRACTION = 1e-3


@dataclass(frozen=True, eq=False)
class DampingObservations:
    """R measured damping ratios whose modes have a partner in the model, as the data of a fit.

    - index: rows of the measurements, (R,)
    - mode: numbers of the partners among the elastic modes of their setups, from 0, (R,)
    - ratio, stated_sigma: measured ratios, and the stated standard deviations of their logarithms, (R,)
    - unstated_sigma: root sum of squares of all other errors of the logarithms, (R,)
    - resolved_mask: whether the ratio is significantly above 0, (R,); otherwise it is only an upper limit
    - frequency: (R,) [Hz]
    - ratio_floor: ratio that is added before logarithms are compared, so that no damping is finite, (R,)
    - coefficients: damping ratio per unit of each loss, (R, J)
    """

    index: NDArray[np.intp]
    mode: NDArray[np.intp]
    ratio: Array
    stated_sigma: Array
    unstated_sigma: Array
    resolved_mask: Mask
    frequency: Array
    ratio_floor: Array
    coefficients: Array

    @property
    def sigma(self) -> Array:
        """Standard deviations of the logarithms, (R,)."""
        return np.hypot(self.stated_sigma, self.unstated_sigma)

    def select(self, mask: Mask) -> DampingObservations:
        """Return some of the rows."""
        return DampingObservations(*(getattr(self, name)[mask] for name in self.__dataclass_fields__))

    def with_errors(self, factor: float) -> DampingObservations:
        """Return the rows with stated errors larger by a factor."""
        return replace(self, stated_sigma=factor * self.stated_sigma)

    def with_scatter(self, scatter: float) -> DampingObservations:
        """Return the rows with a further error, a standard deviation of the logarithm."""
        return replace(self, unstated_sigma=np.hypot(self.unstated_sigma, scatter))

    # Comparison with predictions ---------------------------------------------------------------------------

    @property
    def logarithms(self) -> Array:
        """Logarithms of the measured ratios, to be compared with those `predicted`, (R,)."""
        return np.asarray(np.log(self.ratio + self.ratio_floor))

    def ratios(self, values: Array) -> Array:
        """Return the damping ratios of the model for values of the losses, (R,)."""
        return np.asarray(self.coefficients @ values)

    def predicted_logarithms(self, values: Array) -> Array:
        """Return the logarithms of the model's ratios plus the floor, (R,), finite also where nothing dissipates."""
        return np.asarray(np.log(self.ratios(values) + self.ratio_floor))

    def residual(self, values: Array) -> Array:
        """Return measured minus model in standard deviations, (R,): of logarithms, or of ratios not above 0.

        A ratio not above 0 has the stated error, and the model the others, which are parts of its ratio.
        """
        ratios = self.ratios(values)
        linear = (self.ratio - ratios) / np.hypot(
            self.stated_sigma * self.ratio, self.unstated_sigma * ratios
        )
        return np.where(
            self.resolved_mask, (self.logarithms - self.predicted_logarithms(values)) / self.sigma, linear
        )

    def rates(self, values: Array) -> Array:
        """Return the derivatives of the residual with respect to the losses, (R, J)."""
        ratios = self.ratios(values)
        variance = (self.stated_sigma * self.ratio) ** 2 + (self.unstated_sigma * ratios) ** 2
        linear = -(1.0 + (self.ratio - ratios) * self.unstated_sigma**2 * ratios / variance) / np.sqrt(
            variance
        )
        slopes = np.where(self.resolved_mask, -1.0 / ((ratios + self.ratio_floor) * self.sigma), linear)
        return np.asarray(slopes[:, None] * self.coefficients)


def damping_observations(
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
    setup, mode_index = data.pose[index], mode[index] - 1
    by_state = [structure.damping_rates(values) for values in states]
    coefficients = by_state[0][setup, mode_index]
    ratio = data.damping[index]
    stated_sigma = np.hypot(data.damping_sigma[index], criteria.damping.resolution)
    # A ratio of 0 with a standard deviation is known to be small; its logarithm is not used.
    ratio = np.where(
        (ratio <= 0.0) & (data.damping_sigma[index] > 0.0), ZERO_RATIO_FRACTION * stated_sigma, ratio
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        stated_sigma = np.where(ratio > 0.0, stated_sigma / ratio, np.inf)
    log_coefficients = _logarithms(coefficients)
    state_errors = [
        np.abs(_logarithms(rates[setup, mode_index]) - log_coefficients).max(axis=1, initial=0.0)
        for rates in by_state[1:]
    ]
    mixing_errors = _mixing_errors(structure, states[0], by_state[0], setup, mode_index, criteria)
    unstated_sigma = np.sqrt(criteria.damping.floor**2 + sum((d**2 for d in state_errors), mixing_errors**2))
    resolved_mask = stated_sigma < 1.0 / criteria.damping.resolved
    return DampingObservations(
        index=index,
        mode=mode_index,
        ratio=ratio,
        stated_sigma=stated_sigma,
        unstated_sigma=unstated_sigma,
        resolved_mask=resolved_mask,
        frequency=data.frequency[index],
        ratio_floor=criteria.damping.least * ratio,
        coefficients=coefficients,
    )


def informative_mask(rows: DampingObservations) -> Mask:
    """Return a mask of the rows that have information about the losses.

    The others are a ratio of 0 without a standard deviation, which was not measured, and a row in which the
    measurements set the losses.
    """
    return np.isfinite(rows.stated_sigma) & np.isfinite(rows.coefficients).all(axis=1)


def _logarithms(rates: Array) -> Array:
    """Return logarithms of coefficients, (..., J); those far below the median of their loss are raised."""
    flat = rates.reshape(-1, rates.shape[-1])
    typical = np.array([np.median(c[c > 0.0]) if (c > 0.0).any() else 1.0 for c in flat.T])
    return np.asarray(np.log(np.maximum(np.nan_to_num(rates), NEGLIGIBLE_FRACTION * typical)))


def _mixing_errors(
    structure: Structure,
    values: Array,
    rates: Array,
    setup: NDArray[np.intp],
    mode_index: NDArray[np.intp],
    criteria: Criteria,
) -> Array:
    """Return the errors of the logarithms of the coefficients from close modes, whose shapes mix, (R,).

    For modes closer than `Criteria.pairing.close`, half the difference of their coefficients is the error.  For
    others, the angle by which a small error rotates the shapes is inversely proportional to their distance.
    """
    prediction = structure.predict(values, ())
    logs = prediction.log_frequencies[:, prediction.rigid :]
    logarithms, errors = _logarithms(rates), np.zeros(len(setup))
    for i, (s, k) in enumerate(zip(setup, mode_index, strict=True)):
        distance = np.abs(logs[s] - logs[s, k])
        distance[k] = np.inf
        weight = np.where(
            distance < criteria.pairing.mixed,
            np.minimum(1.0, 0.5 * criteria.pairing.close / np.maximum(distance, 1e-12)),
            0.0,
        )
        errors[i] = (0.5 * weight[:, None] * np.abs(logarithms[s] - logarithms[s, k])).max(initial=0.0)
    return errors
