"""The second stage of a diagnosis: damping, at the final model of the frequencies and shapes.

Losses change neither frequencies nor shapes, so the first stage needs no damping, and the second one takes its model,
its values and its pairing as they are.  If the first stage is not settled, its modes may be the wrong ones, and
damping is not diagnosed.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping import words
from pkmodes.loop.diagnosis.damping.evidence import LossEvidence
from pkmodes.loop.diagnosis.damping.fit import LossFitter
from pkmodes.loop.diagnosis.damping.observations import damping_observations, usable_mask
from pkmodes.loop.diagnosis.damping.outcome import undiagnosed_damping, with_damping_result
from pkmodes.loop.diagnosis.damping.rules import DAMPING_RULES, DOUBTS, TRIAL_DOUBTS, TRIAL_RULES, judge
from pkmodes.loop.diagnosis.damping.stage import DampingStage
from pkmodes.loop.diagnosis.problem import Array, Damped, Structure
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.stability import CHANGES
from pkmodes.loop.measured.measurements import Measurements

#: Logarithm of a factor of a hundred, and the largest distance from it that counts as one.
LOG_HUNDRED, MAX_LOG_DISTANCE = float(np.log(100.0)), 0.7


def with_damping(
    structure: Structure, data: Measurements, result: Diagnosis, criteria: Criteria | None
) -> Diagnosis:
    """Return a diagnosis of frequencies and shapes extended by that of the damping."""
    c = criteria or Criteria()
    if np.isnan(data.damping).all():
        return result
    if not isinstance(structure, Damped) or not structure.losses:
        return replace(result, damping=undiagnosed_damping((), words.NO_LOSSES_REASON))
    if not result.settled or result.stages is None:
        return replace(result, damping=undiagnosed_damping(structure.losses, words.UNSETTLED_REASON))
    predicted = result.stages.after or result.stages.refit
    assert predicted is not None
    all_rows = damping_observations(structure, data, predicted.mode, _parameter_states(structure, result), c)
    other_shape = predicted.mac[all_rows.index] < c.shapes.strange_mac  # not where no shape was measured: NaN
    held_out = np.array([row.held_out for row in result.rows])[all_rows.index]
    outliers = np.array([row.outlier for row in result.rows])[all_rows.index]
    informative = usable_mask(all_rows)
    usable_rows = informative & ~other_shape
    rows = all_rows.select(usable_rows & ~held_out & ~outliers)
    fitter = LossFitter(rows, tuple(structure.losses), c)
    notes = []
    if not informative.all():
        notes.append(words.uninformative_note(data.lines[all_rows.index[~informative]].tolist()))
    if other_shape.any():
        notes.append(
            words.other_shape_note(data.lines[all_rows.index[other_shape]].tolist(), c.shapes.strange_mac)
        )
    median = float(np.median(rows.ratio[rows.resolved])) if rows.resolved.any() else 0.0
    if median > c.damping.most:
        return replace(
            result, damping=undiagnosed_damping(structure.losses, words.per_cent_reason(median), notes)
        )
    trials = {
        change: judge(LossEvidence(fitter.with_changes(errors, priors), TRIAL_DOUBTS), TRIAL_RULES)
        for change, (errors, priors) in CHANGES.items()
    }
    judgement = judge(
        LossEvidence(fitter, DOUBTS, trials, all_rows.select(held_out & usable_rows)), DAMPING_RULES
    )
    if judgement.final.outlier is not None:
        i = int(rows.index[judgement.final.outlier])
        notes.append(
            words.outlier_note(int(data.lines[i]), data.labels[data.pose[i]], float(data.damping[i]))
        )
    if sign := _factor_hundred_sign(fitter):
        notes.append(words.factor_hundred_note(above=sign > 0))
    return with_damping_result(
        result,
        data,
        DampingStage(fitter, all_rows, held_out & usable_rows, other_shape, judgement, trials, tuple(notes)),
    )


def _factor_hundred_sign(fitter: LossFitter) -> int:
    """Return 1 if measured ratios are about a hundred times those of the declared model, -1 if a hundredth, or 0."""
    rows, above = fitter.observations, fitter.observations.resolved
    if not above.any() or not rows.ratios(fitter.declared)[above].all():
        return 0
    log_ratio = float(np.median((rows.logarithms - rows.predicted(fitter.declared))[above]))
    return int(np.sign(log_ratio)) if abs(abs(log_ratio) - LOG_HUNDRED) < MAX_LOG_DISTANCE else 0


def _parameter_states(structure: Structure, result: Diagnosis) -> list[Array]:
    """Return the values of the final model, and with each fitted value moved by its standard deviation.

    It moves within its bounds, to the side where it can move farther.
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
