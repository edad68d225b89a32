"""The second stage of a diagnosis: damping, at the final model of the frequencies and shapes.

Losses change neither frequencies nor shapes, so the first stage needs no damping, and the second stage reuses the
first one's model, values and pairing.  If the first stage is not settled, its modes may be the wrong ones, and
damping is not diagnosed.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping import words
from pkmodes.loop.diagnosis.damping.evidence import LossEvidence
from pkmodes.loop.diagnosis.damping.fit import LossFitter
from pkmodes.loop.diagnosis.damping.observations import (
    DampingObservations,
    damping_observations,
    informative_mask,
)
from pkmodes.loop.diagnosis.damping.outcome import undiagnosed_damping, with_damping_result
from pkmodes.loop.diagnosis.damping.rules import DAMPING_RULES, DOUBTS, TRIAL_DOUBTS, TRIAL_RULES, judge
from pkmodes.loop.diagnosis.damping.stage import DampingStage
from pkmodes.loop.diagnosis.problem import Array, Damped, Structure
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.stability import CHANGES
from pkmodes.loop.measured.measurements import Measurements

#: Logarithm of a factor of a hundred, and the largest distance from it that counts as one.
LOG_HUNDRED, MAX_LOG_DISTANCE = float(np.log(100.0)), 0.7


def add_damping_diagnosis(
    structure: Structure, data: Measurements, result: Diagnosis, criteria: Criteria | None
) -> Diagnosis:
    """Return a diagnosis of frequencies and shapes extended by that of the damping."""
    criteria = criteria or Criteria()
    if np.isnan(data.damping).all():
        return result
    if not isinstance(structure, Damped) or not structure.losses:
        return replace(result, damping=undiagnosed_damping((), words.NO_LOSSES_REASON))
    if not result.settled or result.stages is None:
        return replace(result, damping=undiagnosed_damping(structure.losses, words.UNSETTLED_REASON))
    predicted = result.stages.after or result.stages.refit
    assert predicted is not None
    all_rows = damping_observations(
        structure, data, predicted.partner_mode, _perturbed_values(structure, result), criteria
    )
    # False where no shape was measured, since a comparison with NaN is False.
    mismatched_shape_mask = predicted.fitted_mac[all_rows.index] < criteria.shapes.strange_mac
    unmatched_rows = np.flatnonzero(np.isfinite(predicted.nearest_mac) & ~np.isnan(data.damping))
    has_information = informative_mask(all_rows)
    usable_mask = has_information & ~mismatched_shape_mask
    held_out_mask = np.array([row.held_out for row in result.rows])[all_rows.index] & usable_mask
    outlier_mask = np.array([row.outlier for row in result.rows])[all_rows.index]
    fitted_observations = all_rows.select(usable_mask & ~held_out_mask & ~outlier_mask)
    other_shapes = np.union1d(all_rows.index[mismatched_shape_mask], unmatched_rows)
    notes = _notes_on_unusable_rows(data, all_rows, has_information, other_shapes, criteria)
    resolved_ratios = fitted_observations.ratio[fitted_observations.resolved_mask]
    median_ratio = float(np.median(resolved_ratios)) if len(resolved_ratios) else 0.0
    if median_ratio > criteria.damping.most:
        return replace(
            result, damping=undiagnosed_damping(structure.losses, words.per_cent_reason(median_ratio), notes)
        )
    fitter = LossFitter(fitted_observations, tuple(structure.losses), criteria)
    trials = {
        change: judge(
            LossEvidence(fitter.with_changes(error_factor, prior_factor), TRIAL_DOUBTS), TRIAL_RULES
        )
        for change, (error_factor, prior_factor) in CHANGES.items()
    }
    judgement = judge(LossEvidence(fitter, DOUBTS, trials, all_rows.select(held_out_mask)), DAMPING_RULES)
    if judgement.final.outlier is not None:
        i = int(fitted_observations.index[judgement.final.outlier])
        notes.append(
            words.outlier_note(int(data.lines[i]), data.labels[data.pose[i]], float(data.damping[i]))
        )
    if hundredfold_sign := _factor_hundred_sign(fitter):
        notes.append(words.factor_hundred_note(above=hundredfold_sign > 0))
    stage = DampingStage(
        fitter, all_rows, held_out_mask, mismatched_shape_mask, judgement, trials, tuple(notes)
    )
    return with_damping_result(result, data, stage)


def _notes_on_unusable_rows(
    data: Measurements,
    all_rows: DampingObservations,
    has_information: NDArray[np.bool_],
    other_shapes: NDArray[np.intp],
    criteria: Criteria,
) -> list[str]:
    """Return notes on the rows without information about the losses, and on those with the shape of another mode.

    - other_shapes: indices of the rows whose shapes are not those of the nearest modes
    """
    notes = []
    if not has_information.all():
        notes.append(words.uninformative_note(data.lines[all_rows.index[~has_information]].tolist()))
    if len(other_shapes):
        lines = data.lines[other_shapes].tolist()
        notes.append(words.other_shape_note(lines, criteria.shapes.strange_mac))
    return notes


def _factor_hundred_sign(fitter: LossFitter) -> int:
    """Return 1 if measured ratios are about a hundred times those of the declared model, -1 if a hundredth, or 0."""
    rows, resolved = fitter.observations, fitter.observations.resolved_mask
    if not resolved.any() or not rows.ratios(fitter.declared)[resolved].all():
        return 0
    log_ratio = float(np.median((rows.logarithms - rows.predicted_logarithms(fitter.declared))[resolved]))
    return int(np.sign(log_ratio)) if abs(abs(log_ratio) - LOG_HUNDRED) < MAX_LOG_DISTANCE else 0


def _perturbed_values(structure: Structure, result: Diagnosis) -> list[Array]:
    """Return the final values, then a copy for each fitted value, moved by one standard deviation.

    It is moved towards the side with more room, and limited by its bounds.
    """
    index = {p.name: i for i, p in enumerate(structure.parameters)}
    final = np.array([p.value for p in structure.parameters])
    for value in result.corrected:
        final[index[value.name]] = value.value
    states = [final]
    for value in result.corrected:
        p, moved_values = structure.parameters[index[value.name]], final.copy()
        upper, lower = min(p.upper, value.value + value.sigma), max(p.lower, value.value - value.sigma)
        moved_values[index[value.name]] = upper if upper - value.value >= value.value - lower else lower
        states.append(moved_values)
    return [v for v in states if np.isfinite(structure.predict(v, ()).eigenvalues).all()]
