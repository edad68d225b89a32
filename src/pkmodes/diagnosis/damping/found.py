"""What is claimed of losses, what remains, and how large the others may be: parts of a result."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.diagnosis.damping.fit import LossFit, LossFitter
from pkmodes.diagnosis.damping.judgement import DampingJudgement, names_of, p_of_loss
from pkmodes.diagnosis.damping.limits import examined, limit_of
from pkmodes.diagnosis.damping.stage import Stage
from pkmodes.diagnosis.verdict.findings import Examined, Finding, Value
from pkmodes.diagnosis.verdict.limits import name_of
from pkmodes.diagnosis.verdict.unseen import Limit
from pkmodes.diagnosis.verdict.verdicts import AMBIGUOUS, EFFECT_FOUND, INSUFFICIENT_DATA

#: Explanations beside which limits are found.
MOST = 4


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
            member: (value_of(fitter, fits[j], j),) for member, j in members.items()
        }
        spread = {member: ((fits[j].sigma_of(j) ** 2,),) for member, j in members.items()}
        sentence = fitter.losses[cause].sentence
        findings.append(Finding(name, tuple(members), values[name], values, p_value, sentence, spread))
    return tuple(findings)


def value_of(fitter: LossFitter, fit: LossFit, loss: int) -> Value:
    """Return a fitted loss with its standard deviation."""
    p = fitter.losses[loss].parameter
    return Value(p.name, float(fit.values[loss]), fit.sigma_of(loss), p.unit)


def survivors(fitter: LossFitter, judged: DampingJudgement) -> tuple[tuple[str, ...], ...]:
    """Return the classes that remain, the best first."""
    groups: list[list[LossFit]] = []
    own = [fit for place in judged.places for fit in place] if len(judged.places) == 1 else []
    for fit in (*own, *(fit for fit in judged.rivals if not any(fit is one for one in own))):
        near = fitter.criteria.told_apart
        home = next((g for g in groups if any(fitter.difference(fit, one) < near for one in g)), None)
        if home is None:
            groups.append([fit])
        else:
            home.append(fit)
    return tuple(tuple(names_of(fitter, fit) for fit in group) for group in groups)


def members(findings: Sequence[Finding]) -> set[str]:
    """Return the names of all members of the classes of findings."""
    return {member for finding in findings for member in finding.members}


def tested(stage: Stage, findings: Sequence[Finding]) -> tuple[list[Examined], dict[str, Limit]]:
    """Return the tests and limits of the candidates that are not claimed."""
    fitter, judged, claimed = stage.fitter, stage.judged, members(findings)
    tests, limits = [], {}
    beside = judged.rivals[:MOST] or (judged.final,)
    remain = {fitter.losses[j].candidate for fit in judged.rivals for j in fit.causes}
    remain = remain if judged.verdict is AMBIGUOUS else set()
    for j, loss in enumerate(fitter.losses):
        if not loss.candidate or not loss.claimable:
            continue
        shown = j in fitter.candidates and judged.verdict is not INSUFFICIENT_DATA
        p_value = p_of_loss(fitter, j) if shown else 1.0
        limit = (
            limit_of(fitter, beside, j)
            if j in fitter.candidates
            else Limit(loss.candidate, None, loss.parameter.unit)
        )
        seen = loss.candidate in claimed | remain
        bounded = limit.value is not None
        tests.append(examined(fitter, judged.final, j, p_value, bounded=bounded, shown=seen))
        if loss.candidate not in claimed:
            limits[name_of(loss.parameter)] = limit
    return tests, limits
