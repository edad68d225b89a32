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
from pkmodes.loop.diagnosis.readings.comparison import Apart
from pkmodes.loop.diagnosis.readings.wirings import Wiring, as_in_file

#: Largest size of an array that is evaluated at once.
AT_ONCE = 2_000_000
#: Number of setups, with the worst shapes, at which other wirings are tried first.
WORST = 3
#: Other wirings are examined only if one of them reduces the squares there by this factor.
PERHAPS = 1.5
#: Parameters are refitted for at most this many wirings, with deviances within this of the best.
REFITS, NEAR = 6, 100.0


@dataclass(frozen=True)
class WiringMisfit:
    """Misfit of the measurements with one wiring.

    - squares: whitened sums of squares, (3,): of the frequencies, of shapes with stated errors, of the other shapes
    - count: numbers of these data, (3,)
    - least: sums of squares for the smallest realistic errors, (3,); smaller sums count as these
    - difference: root mean square of the differences of the shapes, relative to the largest component of each
    """

    squares: Array
    count: Array
    least: Array
    difference: float

    @classmethod
    def of(cls, fitter: Fitter, used: NDArray[np.bool_], residual: Array) -> WiringMisfit:
        """Return the misfit of unwhitened residuals of all data, (R + R C,), of which some rows count."""
        observations = fitter.observations
        shapes, white = observations.shapes, residual / observations.noise.stated_sigma
        shaped = used & shapes.known
        masks = shaped & shapes.stated, shaped & ~shapes.stated
        by_row = (observations.by_row(SHAPE, white) ** 2).sum(axis=1)
        frequencies = (white[observations.frequency_rows][used] ** 2).sum()
        count = np.array([used.sum(), *(shapes.count[mask].sum() for mask in masks)], dtype=float)
        smallest = fitter.criteria.shapes.least_scatter / fitter.shape_scatter
        apart = (residual[observations.data_slice(SHAPE)] ** 2).sum() / max(count[1:].sum(), 1.0)
        return cls(
            squares=np.array([frequencies, *(by_row[mask].sum() for mask in masks)]),
            count=count,
            least=np.maximum(count * [1.0, 1.0, smallest**2], 1e-300),
            difference=float(np.sqrt(apart)),
        )

    def deviance(self, frequencies: bool = True) -> float:
        """Return the deviance, with errors of the size that the misfit shows, whether they are stated or not.

        - frequencies: whether the frequencies count: not if something else is missing in the model, because modes
          paired wrongly may then seem to fit better
        """
        counted = self.count > 0
        counted[0] &= frequencies
        squares = np.maximum(self.squares, self.least)[counted]
        return float((self.count[counted] * np.log(squares / self.least[counted])).sum())

    @property
    def shapes(self) -> float:
        """Sum of squares of the shapes relative to the least one."""
        return float(np.maximum(self.squares, self.least)[1:].sum())

    @property
    def per_value(self) -> tuple[float, float]:
        """Sums of squares per value of the frequencies and of the shapes with stated errors; 0 if there are none."""
        frequency, stated = (self.squares / np.maximum(self.count, 1.0))[:2]
        return float(frequency), float(stated)


def at_prediction(
    fitter: Fitter, used: NDArray[np.bool_], prediction: Prediction, wirings: Sequence[Wiring]
) -> list[WiringMisfit]:
    """Return the misfit of each wiring with the modes of a model, many evaluated together; none without modes."""
    if not np.isfinite(prediction.eigenvalues).all():
        return []
    motion = channel_motion(fitter.structure.predict(fitter.declared, ()).shapes)
    numbers = (
        len(fitter.observations.log_frequencies) * prediction.shapes.shape[1] * len(fitter.data.channels)
    )
    batch_size, results = max(AT_ONCE // max(numbers, 1), 1), list[WiringMisfit]()
    for batch in (wirings[start : start + batch_size] for start in range(0, len(wirings), batch_size)):
        rows, tiled = fitter.observations.tiled(len(batch)), np.tile(used, len(batch))
        order = [[fitter.structure.channels.index(name) for name in w.channels] for w in batch]
        rows.pairer.motion = np.concatenate([motion[:, columns] for columns in order])
        # The modes once for each wiring, with its channels in the columns of the file.
        shapes = np.tile(prediction.shapes, (len(batch), 1, 1, 1))
        for rewired, columns, wiring in zip(shapes, order, batch, strict=True):
            rewired[..., fitter.observations.pairer.columns] = prediction.shapes[..., columns] * wiring.signs
        eigenvalues = np.tile(prediction.eigenvalues, (len(batch), 1))
        stacked = _modes(eigenvalues, np.concatenate(shapes), prediction.rigid)
        pairing = rows.pairer.pair(stacked, tiled, compare=False)
        residuals = rows.split_copies(rows.residual(stacked, pairing, tiled))
        results += [WiringMisfit.of(fitter, used, residual) for residual in residuals]
    return results


def promising(fitter: Fitter, fit: Fit, wirings: Sequence[Wiring]) -> bool:
    """Return whether some other wiring fits the shapes better where they fit worst.

    At these few setups a wrong wiring is obvious, and no wiring helps if there is only noise: for most files this is
    enough.
    """
    shapes, setups, pose = fitter.observations.shapes, len(fitter.data.labels), fitter.data.pose
    if setups <= 2 * WORST:
        return True
    squares = (fitter.observations.by_row(SHAPE, fit.white) ** 2).sum(axis=1)
    sums = np.bincount(pose, squares, setups) / np.maximum(np.bincount(pose, shapes.count, setups), 1.0)
    worst = np.sort(np.argsort(sums)[-WORST:])
    part = fitter.at(worst.tolist())
    all_wirings, used = [as_in_file(fitter.data.channels), *wirings], part.observations.all_rows
    there = _modes(fit.prediction.eigenvalues[worst], fit.prediction.shapes[worst], fit.prediction.rigid)
    declared = part.structure.predict(part.declared, ())
    by_model = [at_prediction(part, used, prediction, all_wirings) for prediction in (declared, there)]
    least = [
        min(misfit.shapes for misfit in alternatives)
        for alternatives in zip(*filter(None, by_model), strict=True)
    ]
    return bool(least) and Apart(least[0], min(least[1:])).far_better(PERHAPS)


def misfits(fitter: Fitter, fit: Fit, wirings: Sequence[Wiring]) -> dict[Wiring, WiringMisfit]:
    """Return the misfits of the file and of other wirings, each with the parameter values that suit it best.

    These are the declared ones, those of the fit, and those refitted with the best few wirings.
    """
    as_filed, used = as_in_file(fitter.data.channels), fitter.used_rows(fit.hypothesis)
    all_wirings = [as_filed, *wirings]
    by_wiring = {as_filed: WiringMisfit.of(fitter, used, fit.residual)}

    def keep(misfits: Iterable[tuple[Wiring, WiringMisfit]]) -> None:
        for wiring, misfit in misfits:
            if wiring not in by_wiring or misfit.deviance() < by_wiring[wiring].deviance():
                by_wiring[wiring] = misfit

    for prediction in (fitter.structure.predict(fitter.declared, ()), fit.prediction):
        keep(zip(all_wirings, at_prediction(fitter, used, prediction, all_wirings), strict=False))
    best = sorted((w for w in by_wiring if w != as_filed), key=lambda wiring: by_wiring[wiring].deviance())
    near = by_wiring[best[0]].deviance() + NEAR
    hypotheses = [Hypothesis(excluded=fit.hypothesis.excluded), *([fit.hypothesis] if fit.causes else [])]
    again: list[tuple[float, Prediction]] = []
    for wiring in [w for w in best if by_wiring[w].deviance() < near][:REFITS]:
        rewired = Fitter(
            fitter.structure,
            wiring.of(fitter.data),
            fitter.criteria,
            fitter.shape_scatter,
            parameters=fitter.parameters,
        )
        for hypothesis in hypotheses:
            refit = rewired.fit(hypothesis, fit.values if hypothesis.causes else None)
            if refit is not None:
                misfit = WiringMisfit.of(fitter, used, refit.residual)
                keep([(wiring, misfit)])
                again.append((misfit.deviance(), refit.prediction))
    if again:  # the parameters do not depend on the wiring
        prediction = min(again, key=lambda entry: entry[0])[1]
        keep(zip(all_wirings, at_prediction(fitter, used, prediction, all_wirings), strict=False))
    return by_wiring


def _modes(eigenvalues: Array, shapes: Array, rigid: int) -> Prediction:
    """Return modes without derivatives."""
    return Prediction(eigenvalues, np.zeros((*eigenvalues.shape, 0)), shapes, rigid)
