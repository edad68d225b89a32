"""A model compared with all measured modes, including the held-out ones, and its errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import number_or_none
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.match.pairing import Pairer
from pkmodes.loop.diagnosis.match.predicted import elastic_frequencies_of
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import Array, Structure
from pkmodes.loop.diagnosis.verdict.rows import Error, Row, drives_of
from pkmodes.loop.measured.measurements import Measurements


class AllSetups:
    """A structure at all measured setups.

    - fitter: at the fitted setups
    - held_out: held-out setups
    """

    def __init__(self, structure: Structure, data: Measurements, fitter: Fitter, held_out: list[int]) -> None:
        self.structure, self.data, self.fitter = structure, data, fitter
        self.held_out_poses = tuple(data.labels[i] for i in held_out)
        self.is_held_out = np.isin(data.pose, held_out)
        self.pairer = Pairer(
            data, structure.channels, structure.predict(fitter.declared, ()), fitter.criteria
        )

    def stage(self, values: Array) -> MatchStage:
        """Return the structure with values of all its parameters."""
        return MatchStage(self.structure, self.data, self.pairer, values)

    def spectrum_without_causes(self, fit: Fit) -> Array:
        """Return the elastic frequencies at the values of a fit, but with its causes as declared, (S, m) [Hz]."""
        values = fit.values.copy()
        index = [i for cause in fit.causes for i in self.fitter.parameter_indices(cause)]
        values[index] = self.fitter.declared[index]
        return elastic_frequencies_of(self.stage(values).prediction, self.data)

    def declared_error(self, declared: MatchStage, outlying: NDArray[np.bool_]) -> Error:
        """Return the errors of the declared model, without any fit."""
        count = len(self.fitter.observations.log_frequencies)
        *_, chi2 = self.fitter.evaluate(declared.values, np.ones(count, dtype=bool))
        return self.error(declared, chi2, count, outlying)

    def error(self, stage: MatchStage, chi2: float, degrees: float, outlying: NDArray[np.bool_]) -> Error:
        """Return the errors of a stage over the rows that have a partner and are not outliers."""
        relative = stage.predicted.frequency / self.data.frequency - 1.0
        counted = np.isfinite(relative) & ~outlying

        def rms(rows: NDArray[np.bool_]) -> float | None:
            return float(np.sqrt(np.mean(relative[rows] ** 2))) if rows.any() else None

        return Error(
            rms(counted & ~self.is_held_out), rms(counted & self.is_held_out), chi2 / max(degrees, 1.0)
        )

    def rows(
        self,
        declared: MatchStage,
        refit: MatchStage | None,
        after: MatchStage | None,
        outlying: NDArray[np.bool_],
    ) -> tuple[Row, ...]:
        """Return every measured mode with its predictions."""
        last_stage, drives = (after or refit or declared).predicted, drives_of(self.structure, self.data)

        def value(stage: MatchStage | None, i: int) -> float | None:
            return None if stage is None else number_or_none(stage.predicted.frequency[i])

        return tuple(
            Row(
                pose=self.data.labels[self.data.pose[i]],
                line=int(self.data.lines[i]),
                mode=self.data.mode[i],
                measured=float(self.data.frequency[i]),
                sigma=float(self.data.sigma[i]),
                drives=drives[i],
                before=value(declared, i),
                refit=value(refit, i),
                after=value(after, i),
                mac=number_or_none(last_stage.partner_mac[i]),
                held_out=bool(self.is_held_out[i]),
                outlier=bool(outlying[i]),
                load=self.data.load(int(self.data.pose[i])),
                level=self.data.level_at(int(self.data.pose[i])),
                nearest=number_or_none(last_stage.nearest_frequency[i]),
                nearest_mac=number_or_none(last_stage.nearest_mac[i]),
            )
            for i in range(len(self.data.lines))
        )
