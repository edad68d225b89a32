"""The result of a diagnosis extended by the verdict on damping.

The verdict on frequencies and shapes stays as it is: real machines have friction that no linear model has, and
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
from pkmodes.loop.diagnosis.damping.evidence import DampingJudgement, contradicts_held_out
from pkmodes.loop.diagnosis.damping.explanation import loss_names, p_of_loss
from pkmodes.loop.diagnosis.damping.fit import AT_BOUND_FRACTION, LossFit, LossFitter
from pkmodes.loop.diagnosis.damping.observations import informative_mask
from pkmodes.loop.diagnosis.damping.rules import NOT_PREDICTED
from pkmodes.loop.diagnosis.damping.stage import DampingStage
from pkmodes.loop.diagnosis.problem import Array, Loss
from pkmodes.loop.diagnosis.search.limits import ONE_SIDED_SIGMAS
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

#: Largest number of explanations for which limits of the other losses are determined.
MAX_EXPLANATIONS = 4
#: Largest number of doublings that bracket the end of a profile.
MAX_DOUBLINGS = 60


def undiagnosed_damping(losses: Sequence[Loss], reason: str, notes: Sequence[str] = ()) -> Damping:
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


def with_damping_result(result: Diagnosis, data: Measurements, stage: DampingStage) -> Diagnosis:
    """Return a diagnosis with the result for its damping, and every measured ratio with that of the model."""
    fitter, judgement = stage.fitter, stage.judgement
    effects = damping_findings(fitter, judgement)
    resolved, used_mask, held_out_mask = stage.all_rows.resolved_mask, stage.used_mask, stage.held_out_mask
    with np.errstate(divide="ignore", invalid="ignore"):
        before, after = (
            np.log(stage.all_rows.ratio) - np.log(predicted) for predicted in stage.ratios_before_and_after
        )
    held_out_factor = _rms_factor(after[held_out_mask & resolved])
    notes = list(stage.notes)
    settled = judgement.verdict in (ADEQUATE, EFFECT_FOUND)
    held_out_observations = stage.all_rows.select(held_out_mask)
    if (
        settled
        and held_out_factor is not None
        and contradicts_held_out(
            held_out_observations, stage.final_fit.values, fitter.criteria, judgement.answer.ratio_scatter
        )
    ):
        notes.append(words.not_predicted_note(held_out_factor))
    examined, limits = test_candidates(stage, effects)
    corrected = _corrected_losses(stage)
    nuisances = {fitter.losses[j].parameter.name for j in fitter.nuisance_indices}
    damping = Damping(
        verdict=judgement.verdict.word,
        reason=words.damping_clause(fitter, judgement, effects),
        effects=effects,
        survivors=surviving_classes(fitter, judgement) if judgement.verdict is AMBIGUOUS else (),
        limits=limits,
        refitted=tuple(Refitted.of(v) for v in corrected if v.name in nuisances),
        undetectable=tuple(test.name for test in examined if not test.detectable),
        candidates=tuple(examined),
        notes=tuple(notes),
        stability=_stability(stage),
        fitted=int(used_mask.sum()),
        scatter=judgement.answer.ratio_scatter,
        before=_rms_factor(before[used_mask & resolved]),
        after=_rms_factor(after[used_mask & resolved]),
        held_out=held_out_factor,
        corrected=corrected,
        correlation=tuple(map(tuple, stage.final_fit.correlation.tolist())),
    )
    return replace(result, rows=_rows(result, data, stage), damping=damping)


def _rms_factor(log_differences: Array) -> float | None:
    """Return the root mean square of differences of logarithms as a factor; None if there are none."""
    if not len(log_differences) or not np.isfinite(log_differences).all():
        return None
    return float(np.exp(np.sqrt(np.mean(log_differences**2))))


def _rows(result: Diagnosis, data: Measurements, stage: DampingStage) -> tuple[Row, ...]:
    """Return every measured mode with its measured damping and that of the model."""
    all_rows, used_mask, fitter = stage.all_rows, stage.used_mask, stage.fitter
    rows = list(result.rows)
    for i in np.flatnonzero(~np.isnan(data.damping)).tolist():
        measured, sigma = float(data.damping[i]), float(data.damping_sigma[i])
        rows[i] = structs.replace(
            rows[i],
            damping=measured,
            sigma_damping=sigma,
            damping_used=False,
            damping_remark="the mode has no partner"
            if rows[i].nearest_mac is None
            else f"the mode has no partner: the shape is not that of the nearest one (MAC {rows[i].nearest_mac:.2f})",
        )
    before, after = stage.ratios_before_and_after
    comparison_sigma, is_informative = stage.comparison_sigma, informative_mask(all_rows)
    for k, i in enumerate(all_rows.index.tolist()):
        ratio_before, ratio_after, sigma_of_row = (
            float(value[k]) if np.isfinite(value[k]) else None for value in (before, after, comparison_sigma)
        )
        remark: str | None = None
        if not used_mask[k]:
            if rows[i].held_out:
                remark = "held out"
            elif not is_informative[k]:
                remark = "it says nothing about the losses"
            elif stage.mismatched_shape_mask[k]:
                mac = rows[i].mac or 0.0
                is_one_mode = mac < fitter.criteria.shapes.strange_mac
                remark = (
                    f"the shape is not that of its mode (MAC {mac:.2f})"
                    if is_one_mode
                    else "the shape is that of several close modes"
                )
            else:
                remark = "the frequency is an outlier" if rows[i].outlier else "set aside"
        rows[i] = structs.replace(
            rows[i],
            damping_before=ratio_before,
            damping_after=ratio_after,
            damping_used=bool(used_mask[k]),
            sigma_damping_used=sigma_of_row,
            damping_remark=remark,
        )
    return tuple(rows)


def _stability(stage: DampingStage) -> tuple[Stability, ...]:
    """Return the verdicts on the damping with other errors and priors."""
    if stage.judgement.verdict is INSUFFICIENT_DATA:
        return ()
    entries = []
    for change, trial in stage.trials.items():
        claimed = trial.verdict is EFFECT_FOUND
        if (
            claimed and stage.judgement.rule == NOT_PREDICTED
        ):  # the trial does not predict the held-out poses either
            entries.append(Stability(change, UNEXPLAINED.word, ()))
            continue
        names = tuple(stage.fitter.losses[j].candidate for j in trial.final.causes) if claimed else ()
        entries.append(Stability(change, trial.verdict.word, names))
    return tuple(entries)


def _corrected_losses(stage: DampingStage) -> tuple[Corrected, ...]:
    """Return the fitted losses."""
    fitter, final, corrected = stage.fitter, stage.final_fit, []
    for j in final.free:
        p, value = fitter.losses[j].parameter, loss_value(fitter, final, j)
        at_bound = value.value >= AT_BOUND_FRACTION * p.upper
        corrected.append(Corrected(value.name, value.value, value.sigma, p.unit, p.value, p.sigma, at_bound))
    return tuple(corrected)


def damping_findings(fitter: LossFitter, judgement: DampingJudgement) -> tuple[Finding, ...]:
    """Return the claimed losses with their classes."""
    if judgement.verdict is not EFFECT_FOUND:
        return ()
    findings = []
    for cause, class_fits, p_value in zip(
        judgement.final.causes, judgement.classes, judgement.p_values, strict=True
    ):
        other_causes = set(judgement.final.causes) - {cause}
        fits = {j: fit for fit in class_fits for j in fit.causes if j not in other_causes}
        name, members = fitter.losses[cause].candidate, {fitter.losses[j].candidate: j for j in fits}
        values: dict[str, tuple[Value, ...]] = {
            member: (loss_value(fitter, fits[j], j),) for member, j in members.items()
        }
        variances = {member: ((fits[j].sigma_of(j) ** 2,),) for member, j in members.items()}
        sentence = fitter.losses[cause].sentence
        findings.append(Finding(name, tuple(members), values[name], values, p_value, sentence, variances))
    return tuple(findings)


def loss_value(fitter: LossFitter, fit: LossFit, loss: int) -> Value:
    """Return a fitted loss with its standard deviation."""
    p = fitter.losses[loss].parameter
    return Value(p.name, float(fit.values[loss]), fit.sigma_of(loss), p.unit)


def surviving_classes(fitter: LossFitter, judgement: DampingJudgement) -> tuple[tuple[str, ...], ...]:
    """Return the classes that remain, the best first."""
    class_members = (
        [fit for class_fits in judgement.classes for fit in class_fits] if len(judgement.classes) == 1 else []
    )
    remaining_fits = [
        *class_members,
        *(fit for fit in judgement.answer.rivals if not any(fit is member for member in class_members)),
    ]
    threshold = fitter.criteria.claim.told_apart
    groups = grouped(remaining_fits, lambda member, fit: fitter.squared_difference(fit, member) < threshold)
    return tuple(tuple(loss_names(fitter, fit) for fit in group) for group in groups)


def member_names(findings: Sequence[Finding]) -> set[str]:
    """Return the names of all members of the classes of findings."""
    return {member for finding in findings for member in finding.members}


def test_candidates(
    stage: DampingStage, findings: Sequence[Finding]
) -> tuple[list[Examined], dict[str, Limit]]:
    """Return the tests and limits of the candidates that are not claimed."""
    fitter, judgement, claimed = stage.fitter, stage.judgement, member_names(findings)
    tests, limits = [], {}
    base_fits = judgement.answer.rivals[:MAX_EXPLANATIONS] or (judgement.final,)
    remaining_names = {fitter.losses[j].candidate for fit in judgement.answer.rivals for j in fit.causes}
    remaining_names = remaining_names if judgement.verdict is AMBIGUOUS else set()
    for j, loss in enumerate(fitter.losses):
        if not loss.candidate or not loss.claimable:
            continue
        is_tested = j in fitter.candidates and judgement.verdict is not INSUFFICIENT_DATA
        p_value = p_of_loss(fitter, j) if is_tested else 1.0
        limit = (
            _limit_of(fitter, base_fits, j)
            if j in fitter.candidates
            else Limit(loss.candidate, None, loss.parameter.unit)
        )
        explains = loss.candidate in claimed | remaining_names
        is_bounded = limit.value is not None
        tests.append(
            _test_of_loss(fitter, judgement.final, j, p_value, is_bounded=is_bounded, explains=explains)
        )
        if loss.candidate not in claimed:
            limits[limit_key(loss.parameter)] = limit
    return tests, limits


def _limit_of(fitter: LossFitter, fits: Sequence[LossFit], loss: int) -> Limit:
    """Return how far a loss may be from its declared value at 95 %: the largest limit over the given fits.

    It is the one-sided end of the profile likelihood; there is none if even critical damping of a mode is allowed.
    """
    parameter, candidate = fitter.losses[loss].parameter, fitter.losses[loss].candidate
    if not np.isfinite(fitter.typical_values[loss]):
        return Limit(candidate, None, parameter.unit)
    sizes = [_profile_limit(fitter, fit, loss) for fit in fits]
    if any(size is None for size in sizes):
        return Limit(candidate, None, parameter.unit)
    return Limit(candidate, max(size for size in sizes if size is not None), parameter.unit)


def _profile_limit(fitter: LossFitter, fit: LossFit, loss: int) -> float | None:
    ratio, rows = fit.chi2 / max(fit.degrees, 1), fitter.observations
    if not (fit.p_value > fitter.criteria.gate.surely or ratio <= 1.0):
        # Errors as large as the residual, which is more than noise.
        scale = float(np.sqrt(ratio))
        fitter = fitter.with_observations(
            replace(rows, stated_sigma=scale * rows.stated_sigma, unstated_sigma=scale * rows.unstated_sigma)
        )
    other_causes = tuple(j for j in fit.causes if j != loss)
    declared = float(fitter.declared[loss])
    best = fitter.fit((*other_causes, loss))
    start, least_chi2 = best.values[loss], min(best.chi2, fitter.fit(other_causes).chi2)
    critical = min(
        fitter.losses[loss].parameter.upper, 1.0 / float(fitter.observations.coefficients[:, loss].max())
    )

    def excess(value: float) -> float:
        return fitter.fit(other_causes, {loss: value}).chi2 - least_chi2 - ONE_SIDED_SIGMAS**2

    upper = max(start, 1e-3 * fitter.typical_values[loss])
    for _ in range(MAX_DOUBLINGS):
        if upper >= critical:
            break
        if excess(upper) > 0.0:
            break
        upper *= 2.0
    upper = min(upper, critical)
    if excess(upper) <= 0.0:
        return None
    upper_end = (
        float(brentq(excess, min(start, upper), upper, rtol=1e-4)) if excess(min(start, upper)) < 0 else upper
    )
    if not declared:
        return upper_end
    lower_end = 0.0 if excess(0.0) <= 0.0 else float(brentq(excess, 0.0, start, rtol=1e-4))
    return max(upper_end - declared, declared - lower_end)


def _test_of_loss(
    fitter: LossFitter, final: LossFit, loss: int, p_value: float, *, is_bounded: bool, explains: bool
) -> Examined:
    """Return the test of a loss, its smallest visible value when added to a fit, and whether it is detectable.

    - is_bounded: whether the data bound it
    - explains: whether it is claimed, in the class of a claim, or remains as an explanation
    """
    c, suspect = fitter.criteria, fitter.losses[loss]
    # Standard deviation of the loss beside the fit, in the linear model; infinite where the loss is invisible.
    rows = fitter.observations
    weighted = rows.coefficients / ((rows.ratios(final.values) + rows.ratio_floor) * rows.sigma)[:, None]
    signature, fitted = weighted[:, loss], weighted[:, [j for j in final.free if j != loss]]
    remainder = signature - fitted @ np.linalg.lstsq(fitted, signature)[0] if fitted.shape[1] else signature
    norm = float(np.linalg.norm(remainder))
    sigma = 1.0 / norm if norm > 1e-6 * float(np.linalg.norm(signature)) > 0.0 else np.inf
    size = c.claim.seen * sigma
    is_detectable = explains or is_bounded or p_value <= c.gate.surely
    if not (is_bounded or explains) or not np.isfinite(size) or size > suspect.parameter.upper:
        return Examined(suspect.candidate, p_value, (), is_detectable, suspect.sentence)
    visible_value = Value(suspect.parameter.name, float(size), float(sigma), suspect.parameter.unit)
    return Examined(suspect.candidate, p_value, (visible_value,), is_detectable, suspect.sentence)
