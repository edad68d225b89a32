"""The values in the figures of measured modes: measurements, and the model at one or two stages."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.ordering import natural_order
from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
#: Names of the stages of a model.
DECLARED, REFITTED, CORRECTED = "as declared", "refitted", "with the cause"
WITH_TERM, CHANGED = "with what was found", "with what changed"


@dataclass(frozen=True)
class ModelStage:
    """A stage of the model: its key in the JSON, its title, and its predictions."""

    key: str
    title: str
    predicted: PartnerPredictions

    @cached_property
    def paired(self) -> Mask:
        """Mask of the rows that are paired with a mode of the model, (R,)."""
        return self.predicted.partner_mode > 0


@dataclass(frozen=True)
class PlottedEvidence:
    """R measured modes at S setups, and the stages of the model.

    - labels: labels of the setups in their natural order
    - setup_indices: index of the setup of each row, (R,)
    - measured, sigma: frequencies and their standard deviations, (R,) [Hz]
    - held_out, outlier: (R,)
    - stages: the declared model first; a comparison has no further stage
    - poses: in SI units, (S, d); d = 0 where they are unknown, or the structure has no positions
    - components, units: length d
    - setup_noun: noun for a setup, such as pose
    - frequency_sigma: standard deviations of the frequencies of the declared model, propagated from those in the
      robot file, (S, m) [Hz]
    """

    labels: tuple[str, ...]
    setup_indices: NDArray[np.intp]
    measured: Array
    sigma: Array
    held_out: Mask
    outlier: Mask
    stages: tuple[ModelStage, ...]
    poses: Array
    components: tuple[str, ...]
    units: tuple[str, ...]
    setup_noun: str
    frequency_sigma: Array | None = None

    @classmethod
    def of(
        cls,
        result: Diagnosis | Comparison,
        data: Measurements | None = None,
        setup_noun: str = "pose",
        frequency_sigma: Array | None = None,
    ) -> PlottedEvidence:
        """Return the values to be drawn for a result.

        - data: the measurements of the result: their poses are the axes of some figures
        - setup_noun: noun for a setup, such as pose, or setup for a structure without positions
        - frequency_sigma: standard deviations of the frequencies of the declared model, (S, m) [Hz]

        Raises PkmodesError if the measurements are not those of the result.
        """
        measured_labels = tuple(dict.fromkeys(row.pose for row in result.rows))
        order = natural_order(measured_labels)
        labels = tuple(measured_labels[i] for i in order)
        index_of_label = {label: i for i, label in enumerate(labels)}
        if data is not None and (
            data.labels != measured_labels or data.frequency.tolist() != [row.measured for row in result.rows]
        ):
            problem = f"expected the measurements of the result, found others ({shown(data.source)})"
            raise PkmodesError(problem, "data", "give those that were passed to diagnose or compare")
        # A structure without positions has all of them at 0.
        data_with_positions = None if data is None or not data.points.any() else data
        stages = _stages(result)
        if order != list(range(len(order))):
            stages = tuple(
                replace(
                    stage,
                    predicted=replace(
                        stage.predicted, elastic_frequencies=stage.predicted.elastic_frequencies[order]
                    ),
                )
                for stage in stages
            )
        return cls(
            labels=labels,
            setup_indices=np.array([index_of_label[row.pose] for row in result.rows], dtype=np.intp),
            measured=np.array([row.measured for row in result.rows]),
            sigma=np.array([row.sigma for row in result.rows]),
            held_out=np.array([getattr(row, "held_out", False) for row in result.rows], dtype=bool),
            outlier=np.array([getattr(row, "outlier", False) for row in result.rows], dtype=bool),
            stages=stages,
            poses=np.empty((len(labels), 0))
            if data_with_positions is None
            else data_with_positions.points[order],
            components=() if data_with_positions is None else data_with_positions.components,
            units=() if data_with_positions is None else data_with_positions.component_units,
            setup_noun=setup_noun,
            frequency_sigma=frequency_sigma,
        )

    @property
    def last_stage(self) -> ModelStage:
        """The last stage, to which the verdict applies."""
        return self.stages[-1]

    @cached_property
    def mode_count(self) -> int:
        """Number of elastic modes of the model up to the highest paired one, at least 1."""
        return max(int(stage.predicted.partner_mode.max(initial=1)) for stage in self.stages)

    def difference(self, stage: ModelStage) -> Array:
        """Return f_model / f_measured - 1, (R,), NaN if unmatched."""
        return stage.predicted.frequency / self.measured - 1.0

    def mode_numbers(self) -> NDArray[np.intp]:
        """Return the number of the mode paired with each row at the last stage that pairs it, (R,); 0 if unpaired."""
        modes = np.zeros(len(self.measured), dtype=np.intp)
        for stage in self.stages:
            modes = np.where(stage.paired, stage.predicted.partner_mode, modes)
        return modes


def _stages(result: Diagnosis | Comparison) -> tuple[ModelStage, ...]:
    """Return the declared model and, for a diagnosis, its last stage."""
    if isinstance(result, Comparison):
        return () if result.stage is None else (ModelStage("predicted", DECLARED, result.stage),)
    predictions = result.stages
    if predictions is None:
        return ()
    declared, refitted, corrected, with_term = (
        (DECLARED, REFITTED, CORRECTED + ("s" if len(result.effects) > 1 else ""), WITH_TERM)
        if not isinstance(result, Change)
        else (f"as in {result.states[0]}", f"as in {result.states[0]}, on another day", CHANGED, CHANGED)
    )
    stages = [ModelStage("before", declared, predictions.before)]
    if predictions.after is not None:
        stages.append(ModelStage("after", corrected, predictions.after))
    elif predictions.beyond is not None:
        stages.append(ModelStage("beyond", with_term, predictions.beyond))
    elif predictions.refit is not None:
        stages.append(ModelStage("refit", refitted, predictions.refit))
    return tuple(stages)
