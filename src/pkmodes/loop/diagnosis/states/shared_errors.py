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
from pkmodes.loop.diagnosis.states.counterparts import expected_modes, paired_with
from pkmodes.loop.diagnosis.states.shared_shapes import corrected_shapes
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY

#: Standard deviation of the error of a model in a mode: any error is possible.
ANY = 0.3
#: Smallest standard deviation for a mode that the trusted state does not determine, and that of the part that differs
#: between setups if it follows from fewer than `FEW` differences.
UNKNOWN = 0.02
FEW = 3
#: The scatter between setups is taken at this upper confidence limit.
CONFIDENCE = 0.9
#: Setups are the same if no component of the pose differs by more than this part of the range of the trusted poses,
#: or by more than this [m or rad]; without positions, if the model has the same modes to this accuracy.
NEAR, SMALL, EQUAL = 0.02, 5e-4, 1e-9
#: Largest relative standard deviation of a frequency or of the components of a shape.
LARGEST = 0.9


@dataclass(frozen=True)
class SharedErrors:
    """The error of the model in each row of a later state, as determined by the trusted state.

    - offset, variance: of ln f, and its variance given the trusted state, large enough to treat the errors of
      different rows as independent, (R,)
    - measured_before: rows whose mode was measured in the trusted state, at any setup, (R,)
    - counterpart: row of the trusted state with the same mode at the same setup, (R,); -1 where there is none
    - of_modes: offset of each elastic mode at each setup, (S, m)
    - shapes, shape_sigma: shapes without the errors of those of the model, see `shared_shapes`, (R, C) and (R,)
    """

    offset: Array
    variance: Array
    measured_before: NDArray[np.bool_]
    counterpart: NDArray[np.intp]
    of_modes: Array
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
        places = {p.name: i for i, p in enumerate(structure.parameters)}
        values = np.array([p.value for p in structure.parameters])
        at = structure.predict(values, [places[name] for name in self.names], shape_rates=True)
        assert at.shape_rates is not None
        of_logs, of_shapes = (
            np.asarray(np.einsum("...i,ij,...j->...", rates, self.covariance, rates))
            for rates in (at.log_rates[setup, mode], at.shape_rates[setup, mode])
        )
        return of_logs, of_shapes


def shared_errors(
    trusted: Fitter,
    values: Array,
    structure: Structure,
    later: Measurements,
    shape_error: float = 0.0,
    fitted: FittedValues | None = None,
) -> SharedErrors:
    """Return the errors that the rows of a later state share with the trusted one.

    - trusted: of the trusted state
    - values: of its parameters, fitted to it
    - structure: at the setups of the later state, with these values as declared
    - shape_error: standard deviation of the components of shapes by which the model differs from the trusted state
    - fitted: the uncertainty of these values
    """
    pairing, residual, sigma, _ = trusted.evaluate(values, trusted.observations.all_rows)
    before, data = trusted.structure.predict(values, ()), trusted.data
    after = structure.predict(np.array([p.value for p in structure.parameters]), ())
    same = Setups(
        same_setups(data, before, data, before),
        same_setups(data, before, later, after),
        same_setups(later, after, later, after),
    )
    rows = TrustedRows(residual, sigma, pairing.partner, data.pose)
    errors = errors_of_modes(rows, same, after.eigenvalues.shape[1])
    columns = [structure.channels.index(name) for name in later.channels]
    motion = channel_motion(before.shapes).max(axis=0) if structure.channels else np.zeros(0)
    weights = motion_weights(motion)[columns]
    partner, counterpart = np.full((2, len(later.frequency)), -1, dtype=np.intp)
    for setup, nearest in enumerate(_nearest(data, later, same.across)):
        expected = expected_modes(
            (after.log_frequencies + errors.mean)[setup, after.rigid :],
            errors.scatter,
            after.shapes[setup, after.rigid :][:, columns],
            data,
            later.channels,
            np.where(rows.paired, pairing.partner - after.rigid, -1),
            int(nearest),
        )
        in_setup = np.flatnonzero(later.pose == setup)
        for row, place in paired_with(expected, later, in_setup, weights, trusted.criteria.pairing):
            if expected.mode[place] >= 0:
                partner[row] = expected.mode[place] + after.rigid
            counterpart[row] = expected.row[place]
    offset, variance = errors.of_rows(partner, later.pose)
    there = after.shapes[later.pose, np.maximum(partner, 0)][:, columns]
    modes = np.where((partner >= 0)[:, None], there, np.nan)
    spread = np.zeros(len(partner))
    paired = np.flatnonzero(partner >= 0)
    if fitted is not None and fitted.names and len(paired):
        of_logs, of_shapes = fitted.variances(structure, partner[paired], later.pose[paired])
        variance[paired] += of_logs
        spread[paired] = _relative_spread(weights * np.sqrt(of_shapes[:, columns]), weights * there[paired])
    shapes, shape_sigma = corrected_shapes(data, later, counterpart, modes, weights)
    unmatched = counterpart < 0
    shapes[unmatched], shape_sigma[unmatched] = less_certain(
        shapes[unmatched], shape_sigma[unmatched], shape_error, spread[unmatched]
    )
    return SharedErrors(
        offset,
        variance,
        np.isin(partner, np.unique(pairing.partner[rows.paired])),
        counterpart,
        errors.mean[:, after.rigid :],
        shapes,
        shape_sigma,
    )


def _relative_spread(sigma: Array, shapes: Array) -> Array:
    """Return the largest standard deviation of a component, relative to the largest component, (R,)."""
    size = np.abs(shapes).max(axis=1, initial=0.0)
    return np.asarray(sigma.max(axis=1, initial=0.0) / np.where(size > 0.0, size, 1.0))


def less_certain(shapes: Array, sigma: Array, error: float, spread: Array) -> tuple[Array, Array]:
    """Return shapes without a counterpart, and their standard deviations with the error of the model there.

    Where none is stated, all such shapes share one scatter, and those on which the uncertainty of the fitted values
    has a larger influence are left out.

    - shapes, sigma: (R, C) and (R,)
    - error: standard deviation of the model's shapes in the trusted state
    - spread: standard deviation due to the fitted values, (R,)
    """
    lost = np.isnan(sigma) & (spread > error)
    larger = np.sqrt(sigma**2 + error**2 + spread**2)
    return np.where(lost[:, None], np.nan, shapes), np.minimum(larger, LARGEST)


class Setups(NamedTuple):
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


class ErrorsOfModes(NamedTuple):
    """The errors of the model in the modes at S setups of a later state.

    - mean: of ln f, (S, m)
    - covariances: of each mode at all setups, (m, S, S)
    - scatter: standard deviation of the part that differs between setups
    - unknown: standard deviation for a mode that the trusted state does not determine
    """

    mean: Array
    covariances: Array
    scatter: float
    unknown: float

    def of_rows(self, partner: NDArray[np.intp], pose: NDArray[np.int_]) -> tuple[Array, Array]:
        """Return the errors of rows with these modes at these setups, and their variances as if independent.

        The sum of the moduli in a row of a covariance bounds it by a diagonal one.
        """
        mean, variance = np.zeros(len(partner)), np.full(len(partner), self.unknown**2)
        for mode in np.unique(partner[partner >= 0]):
            rows = np.flatnonzero(partner == mode)
            mean[rows] = self.mean[pose[rows], mode]
            variance[rows] = np.abs(self.covariances[mode][np.ix_(pose[rows], pose[rows])]).sum(axis=1)
        return mean, variance


def errors_of_modes(rows: TrustedRows, same: Setups, count: int) -> ErrorsOfModes:
    """Return the best linear unbiased prediction of the errors of some modes at the setups of a later state."""
    residual, sigma, partner, pose = rows
    paired = rows.paired
    scatter = between_setups(residual[paired], sigma[paired], partner[paired], same.trusted, pose[paired])
    unknown = max(UNKNOWN, float(np.sqrt(np.mean(residual[paired] ** 2))) if paired.any() else 0.0)
    mean, covariances = np.zeros((len(same.later), count)), []
    for mode in range(count):
        of_mode = np.flatnonzero(partner == mode)
        at = pose[of_mode]
        if not len(of_mode):
            covariances.append(np.full(same.later.shape, unknown**2) + scatter**2 * same.later)
            continue
        among = ANY**2 + scatter**2 * same.trusted[np.ix_(at, at)] + np.diag(sigma[of_mode] ** 2)
        across = ANY**2 + scatter**2 * same.across[:, at]
        gain = np.linalg.solve(among, across.T).T
        mean[:, mode] = gain @ residual[of_mode]
        covariances.append(ANY**2 + scatter**2 * same.later - gain @ across.T)
    return ErrorsOfModes(mean, np.array(covariances), scatter, unknown)


def _nearest(trusted: Measurements, later: Measurements, same: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the trusted setup that is the same as each later one, the nearest if there are several; -1 if none."""
    apart = np.linalg.norm(later.points[:, None] - trusted.points[None], axis=-1)
    nearest = np.where(same, apart, np.inf).argmin(axis=1)
    return np.where(same.any(axis=1), nearest, -1)


def between_setups(
    residual: Array, sigma: Array, partner: NDArray[np.intp], among: NDArray[np.bool_], pose: NDArray[np.int_]
) -> float:
    """Return an upper limit of the standard deviation, between setups, of the error of the model in one mode.

    - residual, sigma: of ln f, (R,)
    - partner, pose: mode and setup of each row, (R,)
    - among: which setups are the same, (S, S)
    """
    squares, degrees = 0.0, 0
    for mode in np.unique(partner):
        rows = np.flatnonzero(partner == mode)
        weights = sigma[rows] ** -2
        mean = float(weights @ residual[rows] / weights.sum())
        squares += float(weights @ (residual[rows] - mean) ** 2)
        degrees += int(np.linalg.matrix_rank(among[np.ix_(pose[rows], pose[rows])].astype(float))) - 1
    if degrees < FEW:
        return UNKNOWN
    larger = squares / float(stats.chi2.ppf(1.0 - CONFIDENCE, degrees))
    return float(np.sqrt(max(larger - 1.0, 0.0)) * np.median(sigma))


def same_setups(
    first: Measurements, modes: Prediction, second: Measurements, other_modes: Prediction
) -> NDArray[np.bool_]:
    """Return which setups of the second measurements are those of the first, (S_2, S_1).

    They are at one position with the same drives and set values; without positions, the model has the same modes.
    """
    conditions = [(first.drives[i], first.load(i)) for i in range(len(first.labels))]
    second_conditions = [(second.drives[i], second.load(i)) for i in range(len(second.labels))]
    alike = np.array(
        [
            [condition == second_condition for condition in conditions]
            for second_condition in second_conditions
        ]
    )
    if first.points.any() and second.points.any():
        reach = np.maximum(NEAR * np.ptp(first.points, axis=0), SMALL)
        apart = np.abs(second.points[:, None] - first.points[None])
        return np.asarray(alike & (apart <= reach).all(axis=-1))
    count = min(modes.eigenvalues.shape[1], other_modes.eigenvalues.shape[1])
    a, b = modes.eigenvalues[None, :, :count], other_modes.eigenvalues[:, None, :count]
    largest = np.abs(a).max(axis=-1, keepdims=True)
    return np.asarray(alike & (np.abs(a - b) <= EQUAL * largest).all(axis=-1))


def without_shared_errors(data: Measurements, shared: SharedErrors) -> Measurements:
    """Return measurements of a later state without the errors of the model that the trusted state shows."""
    factor = np.exp(-shared.offset)
    sigma = np.sqrt(FREQUENCY.transformed_sigma(data) ** 2 + shared.variance)
    frequency = data.frequency * factor
    numbers = {name: np.array(column) for name, column in data.numbers.items()}
    numbers |= {"frequency": frequency, "sigma": np.minimum(sigma, LARGEST) * frequency}
    numbers |= {name: np.full(len(frequency), np.nan) for name in ("damping", "damping_sigma")}
    band = None if data.band is None else (data.band[0] * factor.min(), data.band[1] * factor.max())
    return replace(data, numbers=numbers, band=band, shapes=shared.shapes, shape_sigma=shared.shape_sigma)
