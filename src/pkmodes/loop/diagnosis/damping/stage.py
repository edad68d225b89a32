"""The second stage of a diagnosis, before it becomes a result."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.damping.evidence import DampingJudgement
from pkmodes.loop.diagnosis.damping.fit import LossFit, LossFitter
from pkmodes.loop.diagnosis.damping.observations import DampingObservations
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict.verdicts import EFFECT_FOUND


@dataclass(frozen=True, eq=False)
class DampingStage:
    """Damping at the final model.

    - fitter: of the rows that are fitted
    - all_rows: all rows with a damping ratio and a partner
    - held_out: mask of the informative held-out rows among these
    - other_shape: mask of the rows whose shapes differ from those of their partners
    - trials: verdicts with other errors or priors, by change
    """

    fitter: LossFitter
    all_rows: DampingObservations
    held_out: NDArray[np.bool_]
    other_shape: NDArray[np.bool_]
    judgement: DampingJudgement
    trials: dict[str, DampingJudgement]
    notes: tuple[str, ...]

    @property
    def final(self) -> LossFit:
        """The fit with the claimed losses, or that of the declared losses within their priors if none is claimed."""
        return self.judgement.final if self.judgement.verdict is EFFECT_FOUND else self.judgement.base

    @property
    def used(self) -> NDArray[np.bool_]:
        """Mask of the rows that took part."""
        index, outlier = self.fitter.observations.index, self.final.outlier
        return np.isin(self.all_rows.index, index if outlier is None else np.delete(index, outlier))

    @property
    def predicted(self) -> tuple[Array, Array]:
        """Ratios of the model for all rows, with the losses as declared and as diagnosed."""
        return self.all_rows.ratios(self.fitter.declared), self.all_rows.ratios(self.final.values)

    @property
    def sigma_used(self) -> Array:
        """Standard deviations of all measured ratios with which these are compared with the model, (rows,).

        Each has the stated error, the floor, what the shape of its mode leaves open, and a scatter that the verdict
        allows for.  An error of the logarithm is a part of the measured ratio; of a ratio that is not above 0, the
        others are parts of that of the model.
        """
        rows = self.all_rows
        unstated_sigma = np.hypot(rows.unstated_sigma, self.judgement.says.scatter)
        model_ratio = np.where(rows.resolved, rows.ratio, self.predicted[1])
        with np.errstate(invalid="ignore"):  # a ratio of 0 without a standard deviation has no logarithm
            return np.asarray(np.hypot(rows.stated_sigma * rows.ratio, unstated_sigma * model_ratio))
