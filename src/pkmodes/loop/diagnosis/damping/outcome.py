"""The result of a diagnosis, extended by that of the damping, beside the verdict on frequencies and shapes.

That verdict and all that belongs to it stay as they are: real machines have friction that no linear model has, and
neither a cause that the frequencies show nor a model that they confirm must be lost because of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from msgspec import structs
from scipy.optimize import brentq

from pkmodes.core.support.grouping import grouped
from pkmodes.loop.diagnosis.damping import words
from pkmodes.loop.diagnosis.damping.evidence import DampingJudgement, contradicted
from pkmodes.loop.diagnosis.damping.explanation import loss_names, p_of_loss
from pkmodes.loop.diagnosis.damping.fit import NEARLY, LossFit, LossFitter
from pkmodes.loop.diagnosis.damping.observations import usable
from pkmodes.loop.diagnosis.damping.rules import NOT_PREDICTED
from pkmodes.loop.diagnosis.damping.stage import DampingStage
from pkmodes.loop.diagnosis.problem import Array, Loss
from pkmodes.loop.diagnosis.search.limits import ONE_SIDED
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    Examined,
    Finding,
    Limit,
    Refitted,
    Stability,
    Value,
)
from pkmodes.loop.diagnosis.verdict.limits import limit_key
from pkmodes.loop.diagnosis.verdict.result import Damping, Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)
from pkmodes.loop.measured.measurements import Measurements

#: Largest number of explanations beside which limits are determined.
MOST = 4
#: Largest number of doublings that bracket the end of a profile.
DOUBLINGS = 60


def undiagnosed(losses: Sequence[Loss], reason: str, notes: Sequence[str] = ()) -> Damping:
    """Return the result where damping was measured but not diagnosed."""
    suspected = [loss for loss in losses if loss.candidate and loss.claimable]
    return Damping(
        verdict=INSUFFICIENT_DATA.word,
        reason=reason,
        limits={
            limit_key(loss.parameter): Limit(loss.candidate, None, loss.parameter.unit) for loss in suspected
        },
        undetectable=tuple(loss.candidate for loss in suspected),
        notes=tuple(notes),
    )


def with_outcome(result: Diagnosis, data: Measurements, stage: DampingStage) -> Diagnosis:
    """Return a diagnosis with the result for its damping, and every measured ratio beside that of the model."""
    fitter, judged = stage.fitter, stage.judged
    effects = findings(fitter, judged)
    above, used, held = stage.all_rows.above, stage.used, stage.held
    with np.errstate(divide="ignore", invalid="ignore"):
        before, after = (np.log(stage.all_rows.ratio) - np.log(predicted) for predicted in stage.predicted)
    held_out = _rms_factor(after[held & above])
    notes = list(stage.notes)
    settled = judged.verdict in (ADEQUATE, EFFECT_FOUND)
    held_rows = stage.all_rows.some(held)
    if (
        settled
        and held_out is not None
        and contradicted(held_rows, stage.final.values, fitter.criteria, judged.says.scatter)
    ):
        notes.append(words.not_predicted_note(held_out))
    tests, limits = tested(stage, effects)
    corrected = _corrected(stage)
    nuisances = {fitter.losses[j].parameter.name for j in fitter.nuisances}
    damping = Damping(
        verdict=judged.verdict.word,
        reason=words.damping_clause(fitter, judged, effects),
        effects=effects,
        survivors=survivors(fitter, judged) if judged.verdict is AMBIGUOUS else (),
        limits=limits,
        refitted=tuple(Refitted.of(v) for v in corrected if v.name in nuisances),
        undetectable=tuple(test.name for test in tests if not test.detectable),
        candidates=tuple(tests),
        notes=tuple(notes),
        stability=_stability(stage),
        fitted=int(used.sum()),
        scatter=judged.says.scatter,
        before=_rms_factor(before[used & above]),
        after=_rms_factor(after[used & above]),
        held_out=held_out,
        corrected=corrected,
        correlation=tuple(map(tuple, stage.final.correlation.tolist())),
    )
    return replace(result, rows=_rows(result, data, stage), damping=damping)


def _rms_factor(log_differences: Array) -> float | None:
    """Return the root mean square of differences of logarithms as a factor; None without any."""
    if not len(log_differences) or not np.isfinite(log_differences).all():
        return None
    return float(np.exp(np.sqrt(np.mean(log_differences**2))))


def _rows(result: Diagnosis, data: Measurements, stage: DampingStage) -> tuple[Row, ...]:
    """Return every measured mode with its damping beside that of the model."""
    all_rows, used = stage.all_rows, stage.used
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
    sigma_used, informative = stage.sigma_used, usable(all_rows)
    for k, i in enumerate(all_rows.index.tolist()):
        old, new, width = (
            float(value[k]) if np.isfinite(value[k]) else None for value in (before, after, sigma_used)
        )
        remark: str | None = None
        if not used[k]:
            if rows[i].held_out:
                remark = "held out"
            elif not informative[k]:
                remark = "it says nothing about the losses"
            elif stage.strange[k]:
                remark = f"the shape is not that of its mode (MAC {rows[i].mac:.2f})"
            else:
                remark = "the frequency is an outlier" if rows[i].outlier else "set aside"
        rows[i] = structs.replace(
            rows[i],
            damping_before=old,
            damping_after=new,
            damping_used=bool(used[k]),
            sigma_damping_used=width,
            damping_remark=remark,
        )
    return tuple(rows)


def _stability(stage: DampingStage) -> tuple[Stability, ...]:
    """Return the verdicts on the damping with other errors and priors."""
    if stage.judged.verdict is INSUFFICIENT_DATA:
        return ()
    entries = []
    for change, trial in stage.trials.items():
        claimed = trial.verdict is EFFECT_FOUND
        if claimed and stage.judged.rule == NOT_PREDICTED:  # nor does it predict the held-out poses then
            entries.append(Stability(change, UNEXPLAINED.word, ()))
            continue
        names = tuple(stage.fitter.losses[j].candidate for j in trial.final.causes) if claimed else ()
        entries.append(Stability(change, trial.verdict.word, names))
    return tuple(entries)


def _corrected(stage: DampingStage) -> tuple[Corrected, ...]:
    """Return the fitted losses."""
    fitter, final, corrected = stage.fitter, stage.final, []
    for j in final.free:
        p, value = fitter.losses[j].parameter, loss_value(fitter, final, j)
        at_bound = value.value >= NEARLY * p.upper
        corrected.append(Corrected(value.name, value.value, value.sigma, p.unit, p.value, p.sigma, at_bound))
    return tuple(corrected)


def findings(fitter: LossFitter, judged: DampingJudgement) -> tuple[Finding, ...]:
    """Return the claimed losses with their classes."""
    if judged.verdict is not EFFECT_FOUND:
        return ()
    findings = []
    for cause, place, p_value in zip(judged.final.causes, judged.places, judged.p_values, strict=True):
        rest = set(judged.final.causes) - {cause}
        fits = {j: fit for fit in place for j in fit.causes if j not in rest}
        name, members = fitter.losses[cause].candidate, {fitter.losses[j].candidate: j for j in fits}
        values: dict[str, tuple[Value, ...]] = {
            member: (loss_value(fitter, fits[j], j),) for member, j in members.items()
        }
        spread = {member: ((fits[j].sigma_of(j) ** 2,),) for member, j in members.items()}
        sentence = fitter.losses[cause].sentence
        findings.append(Finding(name, tuple(members), values[name], values, p_value, sentence, spread))
    return tuple(findings)


def loss_value(fitter: LossFitter, fit: LossFit, loss: int) -> Value:
    """Return a fitted loss with its standard deviation."""
    p = fitter.losses[loss].parameter
    return Value(p.name, float(fit.values[loss]), fit.sigma_of(loss), p.unit)


def survivors(fitter: LossFitter, judged: DampingJudgement) -> tuple[tuple[str, ...], ...]:
    """Return the classes that remain, the best first."""
    claimed = [fit for place in judged.places for fit in place] if len(judged.places) == 1 else []
    remaining = [
        *claimed,
        *(fit for fit in judged.says.rivals if not any(fit is member for member in claimed)),
    ]
    near = fitter.criteria.claim.told_apart
    groups = grouped(remaining, lambda member, fit: fitter.difference(fit, member) < near)
    return tuple(tuple(loss_names(fitter, fit) for fit in group) for group in groups)


def members(findings: Sequence[Finding]) -> set[str]:
    """Return the names of all members of the classes of findings."""
    return {member for finding in findings for member in finding.members}


def tested(stage: DampingStage, findings: Sequence[Finding]) -> tuple[list[Examined], dict[str, Limit]]:
    """Return the tests and limits of the candidates that are not claimed."""
    fitter, judged, claimed = stage.fitter, stage.judged, members(findings)
    tests, limits = [], {}
    beside = judged.says.rivals[:MOST] or (judged.final,)
    remain = {fitter.losses[j].candidate for fit in judged.says.rivals for j in fit.causes}
    remain = remain if judged.verdict is AMBIGUOUS else set()
    for j, loss in enumerate(fitter.losses):
        if not loss.candidate or not loss.claimable:
            continue
        shown = j in fitter.candidates and judged.verdict is not INSUFFICIENT_DATA
        p_value = p_of_loss(fitter, j) if shown else 1.0
        limit = (
            _limit_of(fitter, beside, j)
            if j in fitter.candidates
            else Limit(loss.candidate, None, loss.parameter.unit)
        )
        explaining = loss.candidate in claimed | remain
        bounded = limit.value is not None
        tests.append(_examined(fitter, judged.final, j, p_value, bounded=bounded, shown=explaining))
        if loss.candidate not in claimed:
            limits[limit_key(loss.parameter)] = limit
    return tests, limits


def _limit_of(fitter: LossFitter, fits: Sequence[LossFit], loss: int) -> Limit:
    """Return how far a loss may be from its declared value at 95 %: the largest limit over the given fits.

    It is the one-sided end of the profile likelihood; there is none if even critical damping of a mode is allowed.
    """
    parameter, candidate = fitter.losses[loss].parameter, fitter.losses[loss].candidate
    if not np.isfinite(fitter.typical[loss]):
        return Limit(candidate, None, parameter.unit)
    sizes = [_size(fitter, fit, loss) for fit in fits]
    if any(size is None for size in sizes):
        return Limit(candidate, None, parameter.unit)
    return Limit(candidate, max(size for size in sizes if size is not None), parameter.unit)


def _size(fitter: LossFitter, fit: LossFit, loss: int) -> float | None:
    fitter = _as_large_as_left(fitter, fit)
    rest = tuple(j for j in fit.causes if j != loss)
    declared = float(fitter.declared[loss])
    best = fitter.fit((*rest, loss))
    start, least = best.values[loss], min(best.chi2, fitter.fit(rest).chi2)
    critical = min(
        fitter.losses[loss].parameter.upper, 1.0 / float(fitter.observations.by_loss[:, loss].max())
    )

    def excess(value: float) -> float:
        return fitter.fit(rest, {loss: value}).chi2 - least - ONE_SIDED**2

    upper = max(start, 1e-3 * fitter.typical[loss])
    for _ in range(DOUBLINGS):
        if upper >= critical:
            break
        if excess(upper) > 0.0:
            break
        upper *= 2.0
    upper = min(upper, critical)
    if excess(upper) <= 0.0:
        return None
    highest = (
        float(brentq(excess, min(start, upper), upper, rtol=1e-4)) if excess(min(start, upper)) < 0 else upper
    )
    if not declared:
        return highest
    lowest = 0.0 if excess(0.0) <= 0.0 else float(brentq(excess, 0.0, start, rtol=1e-4))
    return max(highest - declared, declared - lowest)


def _as_large_as_left(fitter: LossFitter, fit: LossFit) -> LossFitter:
    """Return a fitter with errors as large as the residual of a fit, where that is more than noise."""
    ratio = fit.chi2 / max(fit.degrees, 1)
    if fit.p_value > fitter.criteria.gate.surely or ratio <= 1.0:
        return fitter
    scale = float(np.sqrt(ratio))
    rows = fitter.observations
    return fitter.of(replace(rows, stated=scale * rows.stated, unstated=scale * rows.unstated))


def _examined(
    fitter: LossFitter, final: LossFit, loss: int, p_value: float, *, bounded: bool, shown: bool
) -> Examined:
    """Return the test of a loss, its smallest visible value beside a fit, and whether it is detectable.

    - bounded: whether the data bound it
    - shown: whether it is claimed, in the class of a claim, or remains as an explanation
    """
    c, suspect = fitter.criteria, fitter.losses[loss]
    sigma = _sigma(fitter, final, loss)
    size = c.claim.seen * sigma
    detectable = shown or bounded or p_value <= c.gate.surely
    if not (bounded or shown) or not np.isfinite(size) or size > suspect.parameter.upper:
        return Examined(suspect.candidate, p_value, (), detectable, suspect.sentence)
    visible = Value(suspect.parameter.name, float(size), float(sigma), suspect.parameter.unit)
    return Examined(suspect.candidate, p_value, (visible,), detectable, suspect.sentence)


def _sigma(fitter: LossFitter, fit: LossFit, loss: int) -> float:
    """Return the standard deviation that a loss would have beside a fit, in the linear model; inf if invisible."""
    rows = fitter.observations
    weighted = rows.by_loss / ((rows.ratios(fit.values) + rows.least) * rows.sigma)[:, None]
    signature, fitted = weighted[:, loss], weighted[:, [j for j in fit.free if j != loss]]
    remainder = signature - fitted @ np.linalg.lstsq(fitted, signature)[0] if fitted.shape[1] else signature
    size = float(np.linalg.norm(remainder))
    return 1.0 / size if size > 1e-6 * float(np.linalg.norm(signature)) > 0.0 else np.inf
