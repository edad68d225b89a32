"""Misfits of the measurements with different wirings of the sensors.

A wrong wiring changes the shapes, and with them the pairing: modes of nearly equal frequency are told apart by their
shapes alone.  So every wiring has its own pairing, and frequencies count as well as shapes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import channel_motion
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.diagnosis.readings.comparison import ModelDistances
from pkmodes.loop.diagnosis.readings.wirings import Wiring, as_in_file

#: Largest size of an array that is evaluated at once.
MAX_ARRAY_SIZE = 2_000_000
#: Number of setups, with the worst shapes, at which other wirings are tried first.
SETUPS_TRIED_FIRST = 3
#: Other wirings are examined only if one of them reduces the squares there by this factor.
MIN_GAIN_TO_EXAMINE = 1.5
#: Parameters are refitted for at most this many wirings, with deviances within this of the best.
MAX_REFITS, MAX_DEVIANCE_ABOVE_BEST = 6, 100.0


@dataclass(frozen=True)
class WiringMisfit:
    """Misfit of the measurements with one wiring.

    - squares: whitened sums of squares, (3,): of the frequencies, of shapes with stated errors, of the other shapes
    - count: numbers of these data, (3,)
    - min_squares: sums of squares for the smallest realistic errors, (3,); smaller sums count as these
    - difference: root mean square of the differences of the shapes, relative to the largest component of each
    """

    squares: Array
    count: Array
    min_squares: Array
    difference: float

    @classmethod
    def of(cls, fitter: Fitter, used_row_mask: NDArray[np.bool_], residual: Array) -> WiringMisfit:
        """Return the misfit of unwhitened residuals of all data, (R + R C,), of which some rows count."""
        observations = fitter.observations
        shapes, whitened = observations.shapes, residual / observations.noise.stated_sigma
        rows_with_shape = used_row_mask & shapes.known
        masks = rows_with_shape & shapes.stated, rows_with_shape & ~shapes.stated
        squares_by_row = (observations.by_row(SHAPE, whitened) ** 2).sum(axis=1)
        frequencies = (whitened[observations.frequency_slice][used_row_mask] ** 2).sum()
        count = np.array([used_row_mask.sum(), *(shapes.count[mask].sum() for mask in masks)], dtype=float)
        min_scatter = fitter.criteria.shapes.least_scatter / fitter.shape_scatter
        mean_square = (residual[observations.data_slice(SHAPE)] ** 2).sum() / max(count[1:].sum(), 1.0)
        return cls(
            squares=np.array([frequencies, *(squares_by_row[mask].sum() for mask in masks)]),
            count=count,
            min_squares=np.maximum(count * [1.0, 1.0, min_scatter**2], 1e-300),
            difference=float(np.sqrt(mean_square)),
        )

    def deviance(self, frequencies: bool = True) -> float:
        """Return the deviance, with the errors scaled to the misfit, whether they are stated or not.

        - frequencies: whether the frequencies count.  They do not if something else is missing in the model, because
          wrongly paired modes may then seem to fit better
        """
        counted = self.count > 0
        counted[0] &= frequencies
        squares = np.maximum(self.squares, self.min_squares)[counted]
        return float((self.count[counted] * np.log(squares / self.min_squares[counted])).sum())

    @property
    def shape_squares(self) -> float:
        """Sum of squares of the shapes, not below that of the smallest realistic errors."""
        return float(np.maximum(self.squares, self.min_squares)[1:].sum())

    @property
    def squares_per_value(self) -> tuple[float, float]:
        """Sums of squares per value of the frequencies and of the shapes with stated errors; 0 if there are none."""
        frequency_squares, stated_shape_squares = (self.squares / np.maximum(self.count, 1.0))[:2]
        return float(frequency_squares), float(stated_shape_squares)


def misfits_at_prediction(
    fitter: Fitter, used_row_mask: NDArray[np.bool_], prediction: Prediction, wirings: Sequence[Wiring]
) -> list[WiringMisfit]:
    """Return the misfit of each wiring with the modes of a model, many evaluated together; none without modes."""
    if not np.isfinite(prediction.eigenvalues).all():
        return []
    motion = channel_motion(fitter.structure.predict(fitter.declared, ()).shapes)
    size_of_wiring = (
        len(fitter.observations.log_frequencies) * prediction.shapes.shape[1] * len(fitter.data.channels)
    )
    batch_size, results = max(MAX_ARRAY_SIZE // max(size_of_wiring, 1), 1), list[WiringMisfit]()
    for batch in (wirings[start : start + batch_size] for start in range(0, len(wirings), batch_size)):
        tiled_observations, tiled_mask = (
            fitter.observations.tiled(len(batch)),
            np.tile(used_row_mask, len(batch)),
        )
        column_orders = [[fitter.structure.channels.index(name) for name in w.channels] for w in batch]
        tiled_observations.pairer.motion = np.concatenate([motion[:, columns] for columns in column_orders])
        # The modes once for each wiring, with its channels in the columns of the file.
        shapes = np.tile(prediction.shapes, (len(batch), 1, 1, 1))
        for rewired, columns, wiring in zip(shapes, column_orders, batch, strict=True):
            rewired[..., fitter.observations.pairer.columns] = prediction.shapes[..., columns] * wiring.signs
        eigenvalues = np.tile(prediction.eigenvalues, (len(batch), 1))
        tiled_prediction = _prediction_without_rates(eigenvalues, np.concatenate(shapes), prediction.rigid)
        pairing = tiled_observations.pairer.pair(tiled_prediction, tiled_mask, compare=False)
        residuals = tiled_observations.split_copies(
            tiled_observations.residual(tiled_prediction, pairing, tiled_mask)
        )
        results += [WiringMisfit.of(fitter, used_row_mask, residual) for residual in residuals]
    return results


def is_rewiring_promising(fitter: Fitter, fit: Fit, wirings: Sequence[Wiring]) -> bool:
    """Return whether some other wiring fits the shapes better where they fit worst.

    At these few setups a wrong wiring is obvious, and no wiring helps if there is only noise: for most files this is
    enough.
    """
    shapes, setups, pose = fitter.observations.shapes, len(fitter.data.labels), fitter.data.pose
    if setups <= 2 * SETUPS_TRIED_FIRST:
        return True
    squares = (fitter.observations.by_row(SHAPE, fit.white) ** 2).sum(axis=1)
    sums = np.bincount(pose, squares, setups) / np.maximum(np.bincount(pose, shapes.count, setups), 1.0)
    worst_setups = np.sort(np.argsort(sums)[-SETUPS_TRIED_FIRST:])
    worst_fitter = fitter.at_setups(worst_setups.tolist())
    all_wirings, used_row_mask = (
        [as_in_file(fitter.data.channels), *wirings],
        worst_fitter.observations.all_rows,
    )
    fitted_prediction = _prediction_without_rates(
        fit.prediction.eigenvalues[worst_setups], fit.prediction.shapes[worst_setups], fit.prediction.rigid
    )
    declared_prediction = worst_fitter.structure.predict(worst_fitter.declared, ())
    misfits_by_model = [
        misfits_at_prediction(worst_fitter, used_row_mask, prediction, all_wirings)
        for prediction in (declared_prediction, fitted_prediction)
    ]
    mean_differences = [
        min(misfit.shape_squares for misfit in alternatives)
        for alternatives in zip(*filter(None, misfits_by_model), strict=True)
    ]
    return bool(mean_differences) and ModelDistances(
        mean_differences[0], min(mean_differences[1:])
    ).far_better(MIN_GAIN_TO_EXAMINE)


def misfits_by_wiring(fitter: Fitter, fit: Fit, wirings: Sequence[Wiring]) -> dict[Wiring, WiringMisfit]:
    """Return the misfits of the file and of other wirings, each with the parameter values that suit it best.

    These are the declared ones, those of the fit, and those refitted with the best few wirings.
    """
    as_filed, used_row_mask = as_in_file(fitter.data.channels), fitter.used_row_mask(fit.hypothesis)
    all_wirings = [as_filed, *wirings]
    by_wiring = {as_filed: WiringMisfit.of(fitter, used_row_mask, fit.residual)}

    def keep_best(misfits: Iterable[tuple[Wiring, WiringMisfit]]) -> None:
        for wiring, misfit in misfits:
            if wiring not in by_wiring or misfit.deviance() < by_wiring[wiring].deviance():
                by_wiring[wiring] = misfit

    for prediction in (fitter.structure.predict(fitter.declared, ()), fit.prediction):
        keep_best(
            zip(
                all_wirings,
                misfits_at_prediction(fitter, used_row_mask, prediction, all_wirings),
                strict=False,
            )
        )
    best = sorted((w for w in by_wiring if w != as_filed), key=lambda wiring: by_wiring[wiring].deviance())
    max_deviance = by_wiring[best[0]].deviance() + MAX_DEVIANCE_ABOVE_BEST
    hypotheses = [
        Hypothesis(excluded_rows=fit.hypothesis.excluded_rows),
        *([fit.hypothesis] if fit.causes else []),
    ]
    refits: list[tuple[float, Prediction]] = []
    for wiring in [w for w in best if by_wiring[w].deviance() < max_deviance][:MAX_REFITS]:
        rewired = Fitter(
            fitter.structure,
            wiring.applied_to(fitter.data),
            fitter.criteria,
            fitter.shape_scatter,
            parameters=fitter.parameters,
        )
        for hypothesis in hypotheses:
            refit = rewired.fit(hypothesis, fit.values if hypothesis.causes else None)
            if refit is not None:
                misfit = WiringMisfit.of(fitter, used_row_mask, refit.residual)
                keep_best([(wiring, misfit)])
                refits.append((misfit.deviance(), refit.prediction))
    if refits:  # the parameters do not depend on the wiring
        prediction = min(refits, key=lambda entry: entry[0])[1]
        keep_best(
            zip(
                all_wirings,
                misfits_at_prediction(fitter, used_row_mask, prediction, all_wirings),
                strict=False,
            )
        )
    return by_wiring


def _prediction_without_rates(eigenvalues: Array, shapes: Array, rigid: int) -> Prediction:
    """Return modes without derivatives."""
    return Prediction(eigenvalues, np.zeros((*eigenvalues.shape, 0)), shapes, rigid)
