"""A model with given values of its parameters, paired with all measured modes: declared, refitted, or with causes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.problem import Array, Prediction, Structure
from pkmodes.loop.measured.measurements import Measurements


@dataclass(frozen=True, eq=False)
class MatchStage:
    """A structure with given values of its parameters, and the partners of all R rows."""

    structure: Structure
    data: Measurements
    pairer: Pairer
    values: Array

    @cached_property
    def prediction(self) -> Prediction:
        """Modes of all setups."""
        return self.structure.predict(self.values, ())

    @cached_property
    def pairing(self) -> Pairing:
        """Partners of all rows as in a fit, those of another shape included."""
        return self.pairer.pair(self.prediction, np.ones(len(self.data.lines), dtype=bool))

    @cached_property
    def sigma(self) -> Array:
        """Relative standard deviations of the measured frequencies, (R,), including position errors."""
        data = self.data
        variance: Array = (data.sigma / data.frequency) ** 2
        position_prediction = self.structure.position_rates(self.values) if data.point_sigma.any() else None
        if position_prediction is not None:
            rates = position_prediction.log_rates[data.pose, np.maximum(self.pairing.partner, 0)]
            variance = variance + ((rates * data.point_sigma[data.pose]) ** 2).sum(axis=1)
        return np.sqrt(variance)

    @cached_property
    def predicted(self) -> PartnerPredictions:
        """Partners, differences and MAC, as they are told."""
        return PartnerPredictions.from_pairing(
            self.pairer, self.data, self.prediction, self.pairing, self.sigma
        )
