r"""Errors that a later state shares with the trusted one: those of the model in each mode at each setup.

A model that is 3 % wrong is as wrong after a change as before it.  Its error :math:`\delta` in the logarithm of a
frequency has a part of the mode, :math:`a_m`, and one of the mode at a setup, :math:`b_{sm}`:

.. math:: \ln f_{measured} - \ln f_{model} = a_m + b_{sm} + e .

The trusted rows determine it: :math:`\delta` of each later row is predicted from them with its variance (best linear
unbiased prediction; Robinson, That BLUP is a good thing, Statist. Sci. 6, 1991, 15).  At a setup of the trusted state
this is, for errors of the model far above those of the measurement, the difference of two measurements.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.core.support.mac import channel_motion, motion_weights
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.problem import Array, Prediction, Structure
from pkmodes.loop.diagnosis.states.counterparts import expected_modes, pair_with_expected
from pkmodes.loop.diagnosis.states.shared_shapes import corrected_shapes
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.positions import is_same_position
from pkmodes.loop.measured.quantities import FREQUENCY

#: Standard deviation of the error of a model in a mode: any error is possible.
MODE_SIGMA = 0.3
#: Smallest standard deviation for a mode that the trusted state does not determine, and that of the part that differs
#: between setups if it follows from fewer than `MIN_DIFFERENCES` differences.
MIN_SIGMA = 0.02
MIN_DIFFERENCES = 3
#: The scatter between setups is taken at this upper confidence limit.
CONFIDENCE_LEVEL = 0.9
#: Without positions, setups are the same if the eigenvalues of the model are equal to this fraction of the largest.
EIGENVALUE_TOLERANCE = 1e-9
#: Largest relative standard deviation of a frequency or of the components of a shape.
MAX_SIGMA = 0.9


@dataclass(frozen=True)
class SharedErrors:
    """The error of the model in each row of a later state, as determined by the trusted state.

    - offset, variance: error of ln f, and its variance given the trusted state, large enough to treat the errors of
      different rows as independent, (R,)
    - measured_before: rows whose mode was measured in the trusted state, at any setup, (R,)
    - counterpart: row of the trusted state with the same mode at the same setup, (R,); -1 where there is none
    - mode_offsets: offset of each elastic mode at each setup, (S, m)
    - shapes, shape_sigma: shapes without the errors of those of the model, see `shared_shapes`, (R, C) and (R,)
    """

    offset: Array
    variance: Array
    measured_before: NDArray[np.bool_]
    counterpart: NDArray[np.intp]
    mode_offsets: Array
    shapes: Array
    shape_sigma: Array

    @property
    def compared(self) -> NDArray[np.bool_]:
        """Rows with a counterpart, (R,)."""
        return np.asarray(self.counterpart >= 0)


class FittedValues(NamedTuple):
    """Uncertain values fitted to the trusted state: their names, and their covariance, (k, k)."""

    names: tuple[str, ...]
    covariance: Array

    def variances(
        self, structure: Structure, mode: NDArray[np.intp], setup: NDArray[np.int_]
    ) -> tuple[Array, Array]:
        """Return the variances that these cause in modes at setups: of ln f, (R,), and of shapes, (R, C)."""
        index_of = {p.name: i for i, p in enumerate(structure.parameters)}
        values = np.array([p.value for p in structure.parameters])
        prediction = structure.predict(values, [index_of[name] for name in self.names], shape_rates=True)
        assert prediction.shape_rates is not None
        of_logs, of_shapes = (
            np.asarray(np.einsum("...i,ij,...j->...", rates, self.covariance, rates))
            for rates in (prediction.log_rates[setup, mode], prediction.shape_rates[setup, mode])
        )
        return of_logs, of_shapes


def shared_errors(
    trusted: Fitter,
    values: Array,
    structure: Structure,
    later: Measurements,
    shape_error: float = 0.0,
    fitted_values: FittedValues | None = None,
) -> SharedErrors:
    """Return the errors that the rows of a later state share with the trusted one.

    - trusted: fitter of the trusted state
    - values: values of its parameters, fitted to it
    - structure: at the setups of the later state, with these values as declared
    - shape_error: standard deviation of the components of shapes by which the model differs from the trusted state
    - fitted_values: the uncertainty of these values
    """
    pairing, residual, sigma, _ = trusted.evaluate(values, trusted.observations.all_rows)
    trusted_prediction, data = trusted.structure.predict(values, ()), trusted.data
    later_prediction = structure.predict(np.array([p.value for p in structure.parameters]), ())
    same_setups_of_states = SameSetups(
        same_setups(data, trusted_prediction, data, trusted_prediction),
        same_setups(data, trusted_prediction, later, later_prediction),
        same_setups(later, later_prediction, later, later_prediction),
    )
    rows = TrustedRows(residual, sigma, pairing.partner, data.pose)
    mode_errors = predict_mode_errors(rows, same_setups_of_states, later_prediction.eigenvalues.shape[1])
    columns = [structure.channels.index(name) for name in later.channels]
    motion = channel_motion(trusted_prediction.shapes).max(axis=0) if structure.channels else np.zeros(0)
    weights = motion_weights(motion)[columns]
    partner, counterpart = np.full((2, len(later.frequency)), -1, dtype=np.intp)
    for setup, trusted_setup in enumerate(_nearest_setups(data, later, same_setups_of_states.across)):
        expected = expected_modes(
            (later_prediction.log_frequencies + mode_errors.mean)[setup, later_prediction.rigid :],
            mode_errors.scatter,
            later_prediction.shapes[setup, later_prediction.rigid :][:, columns],
            data,
            later.channels,
            np.where(rows.paired, pairing.partner - later_prediction.rigid, -1),
            int(trusted_setup),
        )
        in_setup = np.flatnonzero(later.pose == setup)
        for row, position in pair_with_expected(expected, later, in_setup, weights):
            if expected.model_mode[position] >= 0:
                partner[row] = expected.model_mode[position] + later_prediction.rigid
            counterpart[row] = expected.trusted_row[position]
    offset, variance = mode_errors.errors_of_rows(partner, later.pose)
    model_shapes = later_prediction.shapes[later.pose, np.maximum(partner, 0)][:, columns]
    paired_shapes = np.where((partner >= 0)[:, None], model_shapes, np.nan)
    value_spread = np.zeros(len(partner))
    paired_rows = np.flatnonzero(partner >= 0)
    if fitted_values is not None and fitted_values.names and len(paired_rows):
        of_logs, of_shapes = fitted_values.variances(structure, partner[paired_rows], later.pose[paired_rows])
        variance[paired_rows] += of_logs
        value_spread[paired_rows] = _relative_spread(
            weights * np.sqrt(of_shapes[:, columns]), weights * model_shapes[paired_rows]
        )
    shapes, shape_sigma = corrected_shapes(data, later, counterpart, paired_shapes, weights)
    unmatched = counterpart < 0
    shapes[unmatched], shape_sigma[unmatched] = with_model_uncertainty(
        shapes[unmatched], shape_sigma[unmatched], shape_error, value_spread[unmatched]
    )
    return SharedErrors(
        offset,
        variance,
        np.isin(partner, np.unique(pairing.partner[rows.paired])),
        counterpart,
        mode_errors.mean[:, later_prediction.rigid :],
        shapes,
        shape_sigma,
    )


def _relative_spread(sigma: Array, shapes: Array) -> Array:
    """Return the largest standard deviation of a component, relative to the largest component, (R,)."""
    size = np.abs(shapes).max(axis=1, initial=0.0)
    return np.asarray(sigma.max(axis=1, initial=0.0) / np.where(size > 0.0, size, 1.0))


def with_model_uncertainty(shapes: Array, sigma: Array, error: float, spread: Array) -> tuple[Array, Array]:
    """Return shapes without a counterpart, and their standard deviations with the error of the model there.

    Where none is stated, all such shapes share one scatter, and those on which the uncertainty of the fitted values
    has a larger influence are left out.

    - shapes, sigma: (R, C) and (R,)
    - error: standard deviation of the model's shapes in the trusted state
    - spread: standard deviation due to the fitted values, (R,)
    """
    is_too_uncertain = np.isnan(sigma) & (spread > error)
    total_sigma = np.sqrt(sigma**2 + error**2 + spread**2)
    return np.where(is_too_uncertain[:, None], np.nan, shapes), np.minimum(total_sigma, MAX_SIGMA)


class SameSetups(NamedTuple):
    """Which setups are the same: within the trusted state, across both (rows: later), and within the later one."""

    trusted: NDArray[np.bool_]
    across: NDArray[np.bool_]
    later: NDArray[np.bool_]


class TrustedRows(NamedTuple):
    """Residuals of the trusted rows in ln f, (R,), with their standard deviations, modes and setups."""

    residual: Array
    sigma: Array
    partner: NDArray[np.intp]
    pose: NDArray[np.int_]

    @property
    def paired(self) -> NDArray[np.bool_]:
        """Rows with a mode of the model, (R,)."""
        return np.asarray(self.partner >= 0)


class ModeErrors(NamedTuple):
    """The errors of the model in the modes at S setups of a later state.

    - mean: mean error of ln f, (S, m)
    - covariances: covariance of each mode's error at all setups, (m, S, S)
    - scatter: standard deviation of the part that differs between setups
    - unknown_sigma: standard deviation for a mode that the trusted state does not determine
    """

    mean: Array
    covariances: Array
    scatter: float
    unknown_sigma: float

    def errors_of_rows(self, partner: NDArray[np.intp], pose: NDArray[np.int_]) -> tuple[Array, Array]:
        """Return the errors of rows with these modes at these setups, and their variances as if independent.

        The sum of the moduli in a row of a covariance bounds it by a diagonal one.
        """
        mean, variance = np.zeros(len(partner)), np.full(len(partner), self.unknown_sigma**2)
        for mode in np.unique(partner[partner >= 0]):
            rows = np.flatnonzero(partner == mode)
            mean[rows] = self.mean[pose[rows], mode]
            variance[rows] = np.abs(self.covariances[mode][np.ix_(pose[rows], pose[rows])]).sum(axis=1)
        return mean, variance


def predict_mode_errors(rows: TrustedRows, setups: SameSetups, count: int) -> ModeErrors:
    """Return the best linear unbiased prediction of the errors of some modes at the setups of a later state."""
    residual, sigma, partner, pose = rows
    paired = rows.paired
    scatter = scatter_between_setups(
        residual[paired], sigma[paired], partner[paired], setups.trusted, pose[paired]
    )
    unknown_sigma = max(MIN_SIGMA, float(np.sqrt(np.mean(residual[paired] ** 2))) if paired.any() else 0.0)
    mean, covariances = np.zeros((len(setups.later), count)), []
    for mode in range(count):
        rows_of_mode = np.flatnonzero(partner == mode)
        setups_of_rows = pose[rows_of_mode]
        if not len(rows_of_mode):
            covariances.append(np.full(setups.later.shape, unknown_sigma**2) + scatter**2 * setups.later)
            continue
        covariance = (
            MODE_SIGMA**2
            + scatter**2 * setups.trusted[np.ix_(setups_of_rows, setups_of_rows)]
            + np.diag(sigma[rows_of_mode] ** 2)
        )
        cross_covariance = MODE_SIGMA**2 + scatter**2 * setups.across[:, setups_of_rows]
        gain = np.linalg.solve(covariance, cross_covariance.T).T
        mean[:, mode] = gain @ residual[rows_of_mode]
        covariances.append(MODE_SIGMA**2 + scatter**2 * setups.later - gain @ cross_covariance.T)
    return ModeErrors(mean, np.array(covariances), scatter, unknown_sigma)


def _nearest_setups(
    trusted: Measurements, later: Measurements, same_setup: NDArray[np.bool_]
) -> NDArray[np.intp]:
    """Return the trusted setup that is the same as each later one, the nearest if there are several; -1 if none."""
    distance = np.linalg.norm(later.points[:, None] - trusted.points[None], axis=-1)
    nearest_setups = np.where(same_setup, distance, np.inf).argmin(axis=1)
    return np.where(same_setup.any(axis=1), nearest_setups, -1)


def scatter_between_setups(
    residual: Array,
    sigma: Array,
    partner: NDArray[np.intp],
    same_setup: NDArray[np.bool_],
    pose: NDArray[np.int_],
) -> float:
    """Return an upper limit of the standard deviation, between setups, of the error of the model in one mode.

    - residual, sigma: residual of ln f, and its standard deviation, (R,)
    - partner, pose: mode and setup of each row, (R,)
    - same_setup: which setups are the same, (S, S)
    """
    squares, degrees = 0.0, 0
    for mode in np.unique(partner):
        rows = np.flatnonzero(partner == mode)
        weights = sigma[rows] ** -2
        mean = float(weights @ residual[rows] / weights.sum())
        squares += float(weights @ (residual[rows] - mean) ** 2)
        degrees += int(np.linalg.matrix_rank(same_setup[np.ix_(pose[rows], pose[rows])].astype(float))) - 1
    if degrees < MIN_DIFFERENCES:
        return MIN_SIGMA
    upper_ratio = squares / float(stats.chi2.ppf(1.0 - CONFIDENCE_LEVEL, degrees))
    return float(np.sqrt(max(upper_ratio - 1.0, 0.0)) * np.median(sigma))


def same_setups(
    first: Measurements, modes: Prediction, second: Measurements, other_modes: Prediction
) -> NDArray[np.bool_]:
    """Return which setups of the second measurements are those of the first, (S_2, S_1).

    They are at one position with the same drives and set values; without positions, the model has the same modes.
    """
    conditions = [(first.drives[i], first.load(i)) for i in range(len(first.labels))]
    second_conditions = [(second.drives[i], second.load(i)) for i in range(len(second.labels))]
    same_conditions = np.array(
        [
            [condition == second_condition for condition in conditions]
            for second_condition in second_conditions
        ]
    )
    if first.points.any() and second.points.any():
        return np.asarray(same_conditions & is_same_position(first, second))
    count = min(modes.eigenvalues.shape[1], other_modes.eigenvalues.shape[1])
    a, b = modes.eigenvalues[None, :, :count], other_modes.eigenvalues[:, None, :count]
    max_magnitude = np.abs(a).max(axis=-1, keepdims=True)
    return np.asarray(same_conditions & (np.abs(a - b) <= EIGENVALUE_TOLERANCE * max_magnitude).all(axis=-1))


def without_shared_errors(data: Measurements, shared: SharedErrors) -> Measurements:
    """Return measurements of a later state without the errors of the model that the trusted state shows."""
    factor = np.exp(-shared.offset)
    sigma = np.sqrt(FREQUENCY.transformed_sigma(data) ** 2 + shared.variance)
    frequency = data.frequency * factor
    numbers = {name: np.array(column) for name, column in data.numbers.items()}
    numbers |= {"frequency": frequency, "sigma": np.minimum(sigma, MAX_SIGMA) * frequency}
    numbers |= {name: np.full(len(frequency), np.nan) for name in ("damping", "damping_sigma")}
    band = None if data.band is None else (data.band[0] * factor.min(), data.band[1] * factor.max())
    return replace(data, numbers=numbers, band=band, shapes=shared.shapes, shape_sigma=shared.shape_sigma)
