"""The result of a diagnosis with what its damping says, beside the verdict on frequencies and shapes.

That verdict and all that belongs to it stay as they are: real machines have friction that no linear model has, and
neither a cause that the frequencies show nor a model that they confirm must be lost because of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from msgspec import structs
from scipy import stats

from pkmodes.diagnosis.damping import words
from pkmodes.diagnosis.damping.fit import NEARLY
from pkmodes.diagnosis.damping.found import findings as findings_of
from pkmodes.diagnosis.damping.found import survivors, tested, value_of
from pkmodes.diagnosis.damping.judgement import DampingJudgement, names_of
from pkmodes.diagnosis.damping.rows import usable
from pkmodes.diagnosis.damping.stage import Stage
from pkmodes.diagnosis.fit.solver import correlation
from pkmodes.diagnosis.problem import Loss
from pkmodes.diagnosis.verdict.findings import Corrected, Refitted, Stability
from pkmodes.diagnosis.verdict.limits import name_of
from pkmodes.diagnosis.verdict.result import Damping, Diagnosis
from pkmodes.diagnosis.verdict.rows import Row
from pkmodes.diagnosis.verdict.unseen import Limit
from pkmodes.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)
from pkmodes.measured.measurements import Measurements


def undiagnosed(losses: Sequence[Loss], reason: str, notes: Sequence[str] = ()) -> Damping:
    """Return what is said where the damping was measured, but not diagnosed."""
    suspected = [loss for loss in losses if loss.candidate and loss.claimable]
    return Damping(
        verdict=INSUFFICIENT_DATA.word,
        reason=reason,
        limits={
            name_of(loss.parameter): Limit(loss.candidate, None, loss.parameter.unit) for loss in suspected
        },
        undetectable=tuple(loss.candidate for loss in suspected),
        notes=tuple(notes),
    )


def with_outcome(result: Diagnosis, data: Measurements, stage: Stage) -> Diagnosis:
    """Return a diagnosis with what its damping says, and every measured ratio beside that of the model."""
    stage = _withdrawn(stage)
    return replace(result, rows=_rows(result, data, stage), damping=_outcome(stage))


def _outcome(stage: Stage) -> Damping:
    fitter, judged = stage.fitter, stage.judged
    found = findings_of(fitter, judged)
    above, used, held = stage.every.above, stage.used, stage.held
    with np.errstate(divide="ignore", invalid="ignore"):
        before, after = (np.log(stage.every.ratio) - np.log(predicted) for predicted in stage.predicted)
    held_out = words.factor_of(after[held & above])
    notes = list(stage.notes)
    if held_out is not None and _contradicted(stage):
        notes.append(words.not_predicted(held_out))
    tests, limits = tested(stage, found)
    corrected = _corrected(stage)
    nuisances = {fitter.losses[j].parameter.name for j in fitter.nuisances}
    return Damping(
        verdict=judged.verdict.word,
        reason=words.sentence(fitter, judged, found),
        effects=found,
        survivors=survivors(fitter, judged) if judged.verdict is AMBIGUOUS else (),
        limits=limits,
        refitted=tuple(
            Refitted(v.name, v.declared, v.value, v.sigma, v.saved_sigma, v.unit)
            for v in corrected
            if v.name in nuisances
        ),
        undetectable=tuple(one.name for one in tests if not one.detectable),
        candidates=tuple(tests),
        notes=tuple(notes),
        stability=_stability(stage),
        fitted=int(used.sum()),
        scatter=judged.scatter,
        before=words.factor_of(before[used & above]),
        after=words.factor_of(after[used & above]),
        held_out=held_out,
        corrected=corrected,
        correlation=tuple(map(tuple, correlation(stage.final.covariance).tolist())),
    )


def _rows(result: Diagnosis, data: Measurements, stage: Stage) -> tuple[Row, ...]:
    """Return every measured mode with its damping beside that of the model."""
    every, used = stage.every, stage.used
    rows = list(result.rows)
    for i in np.flatnonzero(~np.isnan(data.damping)).tolist():
        measured, sigma = float(data.damping[i]), float(data.damping_sigma[i])
        rows[i] = structs.replace(
            rows[i],
            damping=measured,
            sigma_damping=sigma,
            damping_used=False,
            damping_remark="the mode has no partner",
        )
    before, after = stage.predicted
    sigma_used, known = stage.sigma_used, usable(every)
    for k, i in enumerate(every.index.tolist()):
        old, new, width = (
            float(value[k]) if np.isfinite(value[k]) else None for value in (before, after, sigma_used)
        )
        rows[i] = structs.replace(
            rows[i],
            damping_before=old,
            damping_after=new,
            damping_used=bool(used[k]),
            sigma_damping_used=width,
            damping_remark=None if used[k] else _remark(rows[i], bool(known[k]), bool(stage.strange[k])),
        )
    return tuple(rows)


def _remark(row: Row, known: bool, strange: bool) -> str:
    """Return why the ratio of a row takes no part."""
    if row.held_out:
        return "held out"
    if not known:
        return "it says nothing of the losses"
    if strange:
        return f"the shape is another one (MAC {row.mac:.2f})"
    return "the frequency is an outlier" if row.outlier else "set aside"


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
    if judged.verdict not in (ADEQUATE, EFFECT_FOUND) or not stage.final.values.any():
        return False
    held = replace(held, other=np.hypot(held.other, judged.scatter))
    there = replace(stage.fitter, rows=held)
    white = there.whitened(stage.final.values)
    return bool(stats.chi2.sf(float(white @ white), len(white)) <= stage.fitter.criteria.surely)


def _stability(stage: Stage) -> tuple[Stability, ...]:
    """Return what the verdict on the damping becomes with other errors and priors."""
    if stage.judged.verdict is INSUFFICIENT_DATA:
        return ()
    entries = []
    for change, trial in stage.trials.items():
        causes = trial.final.causes if trial.verdict is EFFECT_FOUND else ()
        names = tuple(stage.fitter.losses[j].candidate for j in causes)
        entries.append(Stability(change, trial.verdict.word, names))
    return tuple(entries)


def _corrected(stage: Stage) -> tuple[Corrected, ...]:
    """Return the fitted losses."""
    fitter, final, corrected = stage.fitter, stage.final, []
    for j in final.free:
        p, value = fitter.losses[j].parameter, value_of(fitter, final, j)
        at_bound = value.value >= NEARLY * p.upper
        corrected.append(Corrected(value.name, value.value, value.sigma, p.unit, p.value, p.sigma, at_bound))
    return tuple(corrected)
