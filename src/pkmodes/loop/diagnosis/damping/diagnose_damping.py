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
from pkmodes.loop.diagnosis.damping.observations import observed, usable
from pkmodes.loop.diagnosis.damping.outcome import undiagnosed, with_outcome
from pkmodes.loop.diagnosis.damping.rules import DOUBTS, LOSSES, ROUGH_DOUBTS, ROUGHLY, judge
from pkmodes.loop.diagnosis.damping.stage import DampingStage
from pkmodes.loop.diagnosis.problem import Array, Damped, Structure
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.stability import CHANGES
from pkmodes.loop.measured.measurements import Measurements

#: Logarithm of a factor of a hundred, and the largest distance from it that counts as one.
HUNDRED, CLOSE = float(np.log(100.0)), 0.7


def with_damping(
    structure: Structure, data: Measurements, result: Diagnosis, criteria: Criteria | None
) -> Diagnosis:
    """Return a diagnosis of frequencies and shapes extended by that of the damping."""
    c = criteria or Criteria()
    if np.isnan(data.damping).all():
        return result
    if not isinstance(structure, Damped) or not structure.losses:
        return replace(result, damping=undiagnosed((), words.NO_LOSSES_REASON))
    if not result.settled or result.stages is None:
        return replace(result, damping=undiagnosed(structure.losses, words.UNSETTLED_REASON))
    predicted = result.stages.after or result.stages.refit
    assert predicted is not None
    all_rows = observed(structure, data, predicted.mode, _states(structure, result), c)
    strange = predicted.mac[all_rows.index] < c.shapes.strange_mac  # not where no shape was measured: NaN
    held = np.array([row.held_out for row in result.rows])[all_rows.index]
    aside = np.array([row.outlier for row in result.rows])[all_rows.index]
    informative = usable(all_rows)
    good = informative & ~strange
    rows = all_rows.some(good & ~held & ~aside)
    fitter = LossFitter(rows, tuple(structure.losses), c)
    notes = []
    if not informative.all():
        notes.append(words.uninformative_note(data.lines[all_rows.index[~informative]].tolist()))
    if strange.any():
        notes.append(
            words.other_shape_note(data.lines[all_rows.index[strange]].tolist(), c.shapes.strange_mac)
        )
    median = float(np.median(rows.ratio[rows.above])) if rows.above.any() else 0.0
    if median > c.damping.most:
        return replace(result, damping=undiagnosed(structure.losses, words.per_cent_reason(median), notes))
    trials = {
        change: judge(LossEvidence(fitter.with_changes(errors, priors), ROUGH_DOUBTS), ROUGHLY)
        for change, (errors, priors) in CHANGES.items()
    }
    judged = judge(LossEvidence(fitter, DOUBTS, trials, all_rows.some(held & good)), LOSSES)
    if judged.final.outlier is not None:
        i = int(rows.index[judged.final.outlier])
        notes.append(
            words.outlier_note(int(data.lines[i]), data.labels[data.pose[i]], float(data.damping[i]))
        )
    if power := _hundreds(fitter):
        notes.append(words.factor_hundred_note(above=power > 0))
    return with_outcome(
        result, data, DampingStage(fitter, all_rows, held & good, strange, judged, trials, tuple(notes))
    )


def _hundreds(fitter: LossFitter) -> int:
    """Return 1 if measured ratios are about a hundred times those of the declared model, -1 if a hundredth, or 0."""
    rows, above = fitter.observations, fitter.observations.above
    if not above.any() or not rows.ratios(fitter.declared)[above].all():
        return 0
    away = float(np.median((rows.logarithms - rows.predicted(fitter.declared))[above]))
    return int(np.sign(away)) if abs(abs(away) - HUNDRED) < CLOSE else 0


def _states(structure: Structure, result: Diagnosis) -> list[Array]:
    """Return the values of the final model, and with each fitted value moved by its standard deviation.

    It moves within its bounds, to the side where it can move farther.
    """
    index = {p.name: i for i, p in enumerate(structure.parameters)}
    final = np.array([p.value for p in structure.parameters])
    for value in result.corrected:
        final[index[value.name]] = value.value
    states = [final]
    for value in result.corrected:
        p, moved = structure.parameters[index[value.name]], final.copy()
        up, down = min(p.upper, value.value + value.sigma), max(p.lower, value.value - value.sigma)
        moved[index[value.name]] = up if up - value.value >= value.value - down else down
        states.append(moved)
    return [v for v in states if np.isfinite(structure.predict(v, ()).eigenvalues).all()]
