"""Predictions of explanations elsewhere: where, and in which ways, a structure could be measured next.

A prediction is uncertain by errors like those of the measurements, and by the uncertainty of the fitted values,
linearised.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, cast

import numpy as np

from pkmodes.core.base.drives import HELD, Drives, other_drives
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.posterior.marginal import marginal_log_likelihood, prior_of_error_factor
from pkmodes.loop.diagnosis.problem import Array, Driven, Loadable, Structure
from pkmodes.loop.diagnosis.verdict.information import separations


class MeasuringCondition(NamedTuple):
    """A way to measure: the structure at the poses to choose from, the state of its motors, and the values set there.

    - has_other_drives: whether its motors are in another state than in most of the measurements
    """

    structure: Structure
    drives: Drives | None
    load: Mapping[str, float]
    has_other_drives: bool = False

    @property
    def effort(self) -> int:
        """Additional work compared with measuring another pose."""
        return 2 if self.load else int(self.has_other_drives)


class PredictionElsewhere(NamedTuple):
    """What an explanation predicts at S poses, in standard deviations of a measured frequency.

    - mean, errors: logarithms of the lowest frequencies, and the covariance of the errors of their measurement,
      (S, m) and (S, m, m)
    - rates: derivatives with respect to the fitted values, (S, m, k)
    """

    fit: Fit
    mean: Array
    rates: Array
    errors: Array

    def covariance(self, exact: int | None = None) -> Array:
        """Return the covariance of what would be measured, (S, m, m), with one value exact if given."""
        C = self.fit.covariance
        if exact is not None:
            k = self.fit.free.index(exact)
            C = C - np.outer(C[k], C[k]) / max(C[k, k], 1e-300)
        return np.asarray(self.errors + self.rates @ C @ self.rates.swapaxes(1, 2))


def measuring_conditions(
    structure: Structure, points: Array, *, may_hold_motors: bool = True
) -> Iterator[MeasuringCondition]:
    """Yield the ways to measure at these poses, the simplest first.

    - may_hold_motors: whether motors that are free may be held
    """
    drives = cast("Drives", structure.drives) if isinstance(structure, Driven) else None
    yield MeasuringCondition(structure, drives, {})
    if isinstance(structure, Driven) and (may_hold_motors or drives == HELD):
        switched = structure.with_other_drives(range(len(points)))
        yield MeasuringCondition(
            switched, cast("Drives", other_drives(structure.drives)), {}, has_other_drives=True
        )
    for load, loaded in structure.loaded() if isinstance(structure, Loadable) else ():
        yield MeasuringCondition(loaded, drives, load)


def predict_elsewhere(fitter: Fitter, condition: MeasuringCondition, fit: Fit) -> PredictionElsewhere:
    """Return what an explanation predicts; NaN if its cause is a wrong load, which setting it would not remove.

    With motors in another state, modes that were not measured do not show which are measurable.
    """
    structure, sigma = condition.structure, float(np.median(fitter.observations.sigma))
    prediction = structure.predict(fit.values, fit.free)
    partners = fit.pairing.partner[fit.pairing.partner >= 0]
    modes_below_measured = int(partners.min()) - fit.prediction.rigid if len(partners) else 0
    first_mode = max(
        prediction.rigid
        + (min(modes_below_measured, 0) if condition.has_other_drives else modes_below_measured),
        0,
    )
    lowest_modes = slice(first_mode, first_mode + int(np.median(np.bincount(fitter.data.pose))))
    mean = prediction.log_frequencies[:, lowest_modes] / sigma
    if condition.load.keys() & {name for cause in fit.causes for name in cause.parameters}:
        mean = np.full_like(mean, np.nan)
    errors = _mean_square_error_factor(fitter, fit) * np.eye(mean.shape[1]) + (fit.shared_error / sigma) ** 2
    position_rates = structure.position_rates(fit.values) if fitter.observations.noise.uncertain else None
    if position_rates is not None:
        motion = (
            position_rates.log_rates[:, lowest_modes] / sigma * np.median(fitter.data.point_sigma, axis=0)
        )
        errors = errors + motion @ motion.swapaxes(1, 2)
    errors = np.broadcast_to(errors, (*mean.shape, mean.shape[1]))
    return PredictionElsewhere(fit, mean, prediction.log_rates[:, lowest_modes] / sigma, errors)


def _mean_square_error_factor(fitter: Fitter, fit: Fit) -> float:
    """Return the mean of the square of the factor by which the stated errors of frequencies may be wrong."""
    rows = fitter.observations.frequency_slice
    squares = np.array((fit.white[rows] ** 2).sum())
    degrees = max(fitter.used_row_mask(fit.hypothesis).sum() - fit.leverage[rows].sum(), 0.0)
    log_evidences = marginal_log_likelihood(squares, degrees - np.array([2.0, 0.0]), prior_of_error_factor())
    return float(np.exp(log_evidences[0] - log_evidences[1]))


def explanation_distances(
    predicted: Sequence[PredictionElsewhere], poses: Sequence[int], exact: int | None = None
) -> tuple[Array, Array, Array]:
    """Return how far explanations are apart at some poses (`separations`), with one value exact if given."""
    mode_count, pose_indices = min(prediction.mean.shape[1] for prediction in predicted), list(poses)
    return separations(
        np.array([prediction.mean[pose_indices, :mode_count] for prediction in predicted]),
        np.array(
            [prediction.covariance(exact)[pose_indices, :mode_count, :mode_count] for prediction in predicted]
        ),
    )
