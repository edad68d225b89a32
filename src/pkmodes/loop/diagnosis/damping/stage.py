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

    - fitter: fits losses to the rows that are neither held out nor set aside
    - all_rows: all rows with a damping ratio and a partner
    - held_out_mask: mask of the informative held-out rows among these
    - mismatched_shape_mask: mask of the rows whose shapes differ from those of their partners
    - trials: verdicts with other errors or priors, by change
    """

    fitter: LossFitter
    all_rows: DampingObservations
    held_out_mask: NDArray[np.bool_]
    mismatched_shape_mask: NDArray[np.bool_]
    judgement: DampingJudgement
    trials: dict[str, DampingJudgement]
    notes: tuple[str, ...]

    @property
    def final_fit(self) -> LossFit:
        """The fit with the claimed losses, or that of the declared losses within their priors if none is claimed."""
        return self.judgement.final if self.judgement.verdict is EFFECT_FOUND else self.judgement.base

    @property
    def used_mask(self) -> NDArray[np.bool_]:
        """Mask of the rows that took part."""
        index, outlier = self.fitter.observations.index, self.final_fit.outlier
        return np.isin(self.all_rows.index, index if outlier is None else np.delete(index, outlier))

    @property
    def ratios_before_and_after(self) -> tuple[Array, Array]:
        """Ratios of the model for all rows, with the losses as declared and as diagnosed."""
        return self.all_rows.ratios(self.fitter.declared), self.all_rows.ratios(self.final_fit.values)

    @property
    def comparison_sigma(self) -> Array:
        """Standard deviations used to compare the measured ratios with the model, (rows,).

        Each consists of the stated error, the floor, the error of the model's coefficients, and a scatter that the
        verdict allows for.  Errors of a logarithm are multiplied by the measured ratio.  Where that ratio is not
        significantly above 0, all but the stated error are multiplied by the model's ratio instead.
        """
        rows = self.all_rows
        unstated_sigma = np.hypot(rows.unstated_sigma, self.judgement.answer.ratio_scatter)
        model_ratio = np.where(rows.resolved_mask, rows.ratio, self.ratios_before_and_after[1])
        with np.errstate(invalid="ignore"):  # a ratio of 0 without a standard deviation has no logarithm
            return np.asarray(np.hypot(rows.stated_sigma * rows.ratio, unstated_sigma * model_ratio))
