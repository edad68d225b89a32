"""One result from the two stages of a diagnosis: frequencies and shapes first, then damping.

The frequencies decide what is claimed about mass and stiffness, whatever the damping says: real machines have
friction that no linear model has, and a cause that the frequencies show must not be lost because of it.  Where they
find nothing missing, the damping decides.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.damping import words
from pkmodes.diagnosis.damping.fit import NEARLY, LossFit, LossFitter
from pkmodes.diagnosis.damping.found import findings as findings_of
from pkmodes.diagnosis.damping.found import survivors, tested, value_of
from pkmodes.diagnosis.damping.judgement import DampingJudgement, names_of
from pkmodes.diagnosis.damping.outcome import Damping
from pkmodes.diagnosis.damping.stage import Stage
from pkmodes.diagnosis.fit.solver import correlation
from pkmodes.diagnosis.problem import Loss
from pkmodes.diagnosis.verdict.limits import name_of
from pkmodes.diagnosis.verdict.result import (
    Corrected,
    Diagnosis,
    Refitted,
    Stability,
)
from pkmodes.diagnosis.verdict.rows import Row
from pkmodes.diagnosis.verdict.unseen import Limit
from pkmodes.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
    VERDICTS,
    Verdict,
)
from pkmodes.measured.measurements import Measurements

#: Why damping is not diagnosed where the first stage does not settle.
UNSETTLED = (
    "the damping is not diagnosed: without an explanation of the frequencies, its modes may be the wrong ones"
)


def combined(first: Verdict, damping: Verdict) -> Verdict:
    """Return the verdict on both, from that on frequencies and shapes and that on damping."""
    if not first.settled or damping in (ADEQUATE, INSUFFICIENT_DATA):
        return first
    return damping if first is ADEQUATE else EFFECT_FOUND


def without_outcome(
    result: Diagnosis, losses: Sequence[Loss], notes: Sequence[str] = (UNSETTLED,)
) -> Diagnosis:
    """Return a diagnosis whose damping is not diagnosed."""
    suspected = [loss for loss in losses if loss.candidate and loss.claimable]
    limits = {name_of(loss.parameter): Limit(loss.candidate, None, loss.parameter.unit) for loss in suspected}
    return replace(
        result,
        undetectable=(*result.undetectable, *(loss.candidate for loss in suspected)),
        limits={**result.limits, **limits},
        notes=(*result.notes, *notes),
    )


def with_outcome(result: Diagnosis, data: Measurements, stage: Stage) -> Diagnosis:
    """Return a diagnosis with what its damping says."""
    stage = _withdrawn(stage)
    fitter, judged = stage.fitter, stage.judged
    found = findings_of(fitter, judged)
    sentence = words.sentence(fitter, judged, found)
    damping = _outcome(stage, sentence)
    verdict = combined(VERDICTS[result.verdict], judged.verdict)
    notes = [*result.notes, *stage.notes]
    if (judged.verdict is INSUFFICIENT_DATA and judged.why and not stage.notes) or (
        result.effects and judged.verdict in (AMBIGUOUS, UNEXPLAINED)
    ):
        notes.append(sentence)
    if damping.held_out is not None and _contradicted(stage):
        notes.append(
            f"the damping of the held-out poses is not predicted: a factor of {damping.held_out:.2g} in the mean"
        )
    tests, limits = tested(stage, found)
    unseen = [one.name for one in tests if not one.detectable]
    corrected = _corrected(result, fitter, stage.final)
    both = replace(
        result,
        rows=_rows(result, data, stage),
        verdict=verdict.word,
        reason=_reason(result, judged, verdict, sentence),
        effects=(*result.effects, *found),
        survivors=survivors(fitter, judged) if verdict is AMBIGUOUS else result.survivors,
        candidates=(*result.candidates, *tests),
        undetectable=(*result.undetectable, *unseen),
        limits={**result.limits, **limits},
        notes=tuple(notes),
        stability=tuple(_stability(one, stage) for one in result.stability),
        damping=damping,
        corrected=corrected,
        correlation=_correlation(result, corrected, fitter, stage.final),
        refitted=_refitted(result, fitter, stage.final),
    )
    return _with_last_stage(both) if found else both


def _reason(result: Diagnosis, judged: DampingJudgement, verdict: Verdict, sentence: str) -> str:
    if judged.verdict is INSUFFICIENT_DATA or (result.effects and judged.verdict in (AMBIGUOUS, UNEXPLAINED)):
        return result.reason
    if verdict.settled:
        return f"{result.reason}; {sentence}"
    return f"frequencies and shapes agree with the model, but {sentence}"


def _with_last_stage(result: Diagnosis) -> Diagnosis:
    """Return a result with a stage after its causes; losses leave that of the frequencies as it was."""
    if result.after is not None or result.stages is None:
        return result
    rows = tuple(replace(row, after=row.refit) for row in result.rows)
    return replace(
        result, after=result.refit, rows=rows, stages=replace(result.stages, after=result.stages.refit)
    )


def _rows(result: Diagnosis, data: Measurements, stage: Stage) -> tuple[Row, ...]:
    """Return every measured mode with its damping beside that of the model."""
    every, used = stage.every, stage.used
    rows = list(result.rows)
    for i in np.flatnonzero(~np.isnan(data.damping)).tolist():
        measured, sigma = float(data.damping[i]), float(data.damping_sigma[i])
        rows[i] = replace(rows[i], damping=measured, sigma_damping=sigma, damping_used=False)
    before, after = stage.predicted
    for k, i in enumerate(every.index.tolist()):
        old, new = (None if np.isnan(ratio[k]) else float(ratio[k]) for ratio in (before, after))
        rows[i] = replace(rows[i], damping_before=old, damping_after=new, damping_used=bool(used[k]))
    return tuple(rows)


def _outcome(stage: Stage, sentence: str) -> Damping:
    """Return what the damping says, and how far the model is from it."""
    above, used, held = stage.every.above, stage.used, stage.held
    with np.errstate(divide="ignore", invalid="ignore"):
        before, after = (np.log(stage.every.ratio) - np.log(predicted) for predicted in stage.predicted)
    return Damping(
        verdict=stage.judged.verdict.word,
        sentence=sentence,
        fitted=int(used.sum()),
        before=words.factor_of(before[used & above]),
        after=words.factor_of(after[used & above]),
        held_out=words.factor_of(after[held & above]),
    )


def _withdrawn(stage: Stage) -> Stage:
    """Return what is left of an explanation that does not predict the damping of the held-out poses."""
    judged = stage.judged
    if judged.verdict is not EFFECT_FOUND or not stage.held.any() or not _contradicted(stage):
        return stage
    name = names_of(stage.fitter, judged.final)
    why = f"{name} would explain that of the fitted poses, but not that of the held-out ones"
    nothing = DampingJudgement(UNEXPLAINED, judged.base, judged.base, why=why)
    claims = {change: trial for change, trial in stage.trials.items() if trial.verdict is EFFECT_FOUND}
    return replace(stage, judged=nothing, trials={**stage.trials, **dict.fromkeys(claims, nothing)})


def _contradicted(stage: Stage) -> bool:
    """Return whether the held-out rows contradict the losses of an explanation."""
    held, judged = stage.every.some(stage.held), stage.judged
    if judged.verdict not in (ADEQUATE, EFFECT_FOUND):
        return False
    there = replace(stage.fitter, rows=held)
    white = there.whitened(stage.final.values)
    return bool(stats.chi2.sf(float(white @ white), len(white)) <= stage.fitter.criteria.surely)


def _stability(entry: Stability, stage: Stage) -> Stability:
    """Return what the verdict on both becomes under a change."""
    trial = stage.trials.get(entry.change)
    if trial is None or stage.judged.verdict is INSUFFICIENT_DATA:
        return entry
    verdict = combined(VERDICTS[entry.verdict], trial.verdict)
    found = trial.verdict is EFFECT_FOUND and VERDICTS[entry.verdict].settled
    causes = [stage.fitter.losses[j].candidate for j in trial.final.causes] if found else []
    return Stability(entry.change, verdict.word, (*entry.effects, *causes))


def _corrected(result: Diagnosis, fitter: LossFitter, final: LossFit) -> tuple[Corrected, ...]:
    """Return the changed values of the first stage with the fitted losses among them."""
    corrected = {value.name: value for value in result.corrected}
    for j in final.free:
        p, value = fitter.losses[j].parameter, value_of(fitter, final, j)
        at_bound = value.value >= NEARLY * p.upper
        corrected[p.name] = Corrected(
            value.name, value.value, value.sigma, p.unit, p.value, p.sigma, at_bound
        )
    return tuple(corrected.values())


def _correlation(
    result: Diagnosis, corrected: Sequence[Corrected], fitter: LossFitter, final: LossFit
) -> tuple[tuple[float, ...], ...]:
    """Return the correlation of the changed values: each stage has that of its fit."""
    place = {value.name: i for i, value in enumerate(corrected)}
    losses = [place[fitter.losses[j].parameter.name] for j in final.free]
    every, first = np.eye(len(corrected)), [place[value.name] for value in result.corrected]
    every[np.ix_(first, first)] = result.correlation
    every[losses, :], every[:, losses] = (
        0.0,
        0.0,
    )  # a loss with a prior is in the first stage, too, which has no data on it
    every[np.ix_(losses, losses)] = correlation(final.covariance)
    return tuple(map(tuple, every.tolist()))


def _refitted(result: Diagnosis, fitter: LossFitter, final: LossFit) -> tuple[Refitted, ...]:
    """Return the nuisance parameters of both stages."""
    refitted = {value.name: value for value in result.refitted}
    for j in fitter.nuisances:
        p, value = fitter.losses[j].parameter, value_of(fitter, final, j)
        refitted[p.name] = Refitted(p.name, p.value, value.value, value.sigma, value.sigma, p.unit)
    return tuple(refitted.values())
