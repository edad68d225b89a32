"""The rules of the verdict on damping, in a table: the first that applies decides.

A claim needs the same as for the frequencies: the explanation leaves noise, has no distinguishable rival,
improves significantly on the declared losses, and is specific.  Friction that depends on the amplitude, such as
Coulomb friction, is not a loss of the catalogue; it is refused because it leaves more than noise, or a trend with
frequency.

Repeated tests of one machine give ratios that scatter from mode to mode by more than their stated errors.  A model
that declares no loss predicts no damping, so a ratio common to all modes contradicts nothing, and names no
joint.  Neither does a common ratio that differs from the declared one by no more than repeated tests do.
"""

from __future__ import annotations

import math

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.damping import words
from pkmodes.loop.diagnosis.damping.evidence import (
    DampingJudgement,
    LossAnswer,
    LossEvidence,
    LossRules,
    contradicts_held_out,
)
from pkmodes.loop.diagnosis.damping.explanation import (
    MIN_SEPARATION,
    LossExplanation,
    loss_names,
    nearest_loss,
)
from pkmodes.loop.diagnosis.damping.fit import LossFit
from pkmodes.loop.diagnosis.verdict.evidence import Rule, first_decision
from pkmodes.loop.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)


def judge(evidence: LossEvidence, rules: LossRules) -> DampingJudgement:
    """Return the verdict of the first rule that applies."""
    decision = first_decision(rules, evidence)
    assert decision is not None  # the last rule always applies
    explanation = evidence.explanation if decision.verdict in (EFFECT_FOUND, AMBIGUOUS) else None
    return DampingJudgement(
        decision.rule.name,
        decision.verdict,
        evidence.base,
        final=explanation.best if explanation else evidence.base,
        classes=explanation.classes if explanation else (),
        p_values=explanation.p_values if explanation else (),
        answer=decision.answer,
    )


# Nothing to explain --------------------------------------------------------------------------------------------


def too_few(e: LossEvidence) -> str:
    """The resolved ratios are too few for the uncertain losses, a cause, and a test of it."""
    count = e.resolved_count
    if count >= len(e.fitter.nuisance_indices) + 1 + e.criteria.claim.redundancy:
        return ""
    subject = "1 resolved damping ratio is" if count == 1 else f"{count} resolved damping ratios are"
    return f"{subject} too few"


def as_declared(e: LossEvidence) -> LossAnswer | None:
    """The ratios are those of the declared losses, and no other loss improves on them."""
    level = e.criteria.gate.level
    return LossAnswer("") if e.base.p_value > level and e.p_one_more > level else None


# Several explanations, or none that names a joint --------------------------------------------------------------


def several(e: LossEvidence) -> LossAnswer | None:
    """Several explanations remain that do not form one class."""
    explanation = e.explanation
    return (
        LossAnswer("", rivals=(explanation.best, *explanation.rivals))
        if explanation and explanation.rivals
        else None
    )


def nearly_declared(e: LossEvidence) -> LossAnswer | None:
    """A common ratio other than the declared one explains them, and differs from it as repeated tests do."""
    if e.claim is None or not e.declares_losses or e.common_loss is None or len(e.claim.classes) != 1:
        return None
    fit = next((fit for fit in e.claim.classes[0] if fit.causes == (e.common_loss,)), None)
    if fit is None:
        return None
    ratio, declared = _fitted_loss(fit, e.common_loss), float(e.fitter.declared[e.common_loss])
    if not declared or abs(math.log(ratio[0] / declared)) > e.criteria.damping.scatter:
        return None
    return LossAnswer(words.nearly_declared_sentence(*ratio, declared), ratio_scatter=e.scatter_about(e.base))


def common_ratio(e: LossEvidence) -> str:
    """No damping is declared, and a ratio common to all modes, which names no joint, explains the measured ones."""
    if e.declares_losses or e.common_loss is None:
        return ""
    fit = e.fitter.fit((e.common_loss,))  # also where it is not among the chosen candidates
    if e.claim is None:
        is_only_explanation = fit.p_value > e.criteria.gate.level
    else:
        is_only_explanation = (
            e.claim.best.causes == (e.common_loss,) and not e.fitter.losses[e.common_loss].claimable
        )
    if not is_only_explanation:
        return ""
    return words.common_ratio_sentence(*_fitted_loss(fit, e.common_loss), e.criteria.damping.floor)


def scattered(e: LossEvidence) -> LossAnswer | None:
    """Nothing is claimed, and ratios scatter about a common one, or about those declared, as in repeated tests."""
    if e.claim is not None:
        return None
    if e.declares_losses:
        fit, center_ratio = e.base, None
    elif e.common_loss is not None:
        fit = e.fitter.fit((e.common_loss,))
        center_ratio = _fitted_loss(fit, e.common_loss)[0]
    else:
        return None
    scatter = e.scatter_about(fit)
    if scatter > e.criteria.damping.scatter:
        return None
    return LossAnswer(words.scatter_sentence(center_ratio, scatter), ratio_scatter=scatter)


def _fitted_loss(fit: LossFit, loss: int) -> tuple[float, float]:
    """Return a fitted loss and its standard deviation."""
    return float(fit.values[loss]), fit.sigma_of(loss)


# Doubts about an explanation -----------------------------------------------------------------------------------


def tells_nothing(e: LossEvidence) -> str:
    """All candidates are in one class although their effects differ."""
    explanation = e.explanation
    if explanation is None or len(explanation.best.causes) != 1:
        return ""
    class_fits = explanation.classes[0]
    differ = any(e.fitter.squared_difference(class_fits[0], fit) >= MIN_SEPARATION for fit in class_fits)
    if not differ or {fit.causes[0] for fit in class_fits} != set(e.fitter.candidates):
        return ""
    return "the damping ratios are too few or too uncertain to tell any of the losses apart"


def may_be_chance(e: LossEvidence) -> str:
    """The improvement may be chance: its p-value, corrected for the number of candidates, is above 0.1 %."""
    explanation = e.explanation
    if explanation is None or max(explanation.p_values) <= e.criteria.claim.claimed:
        return ""
    return _would_explain(
        e, explanation, f"but the improvement may be chance (p = {plain(max(explanation.p_values), 2)})"
    )


def leaves_a_trend(e: LossEvidence) -> str:
    """What the explanation leaves has a trend with the frequency."""
    explanation = e.explanation
    if explanation is None or e.p_trend > e.criteria.gate.level:
        return ""
    objection = (
        "but what it leaves follows the frequency: friction that depends on the amplitude, or something outside the "
        "candidates"
    )
    return _would_explain(e, explanation, objection)


def not_specific(e: LossEvidence) -> str:
    """Too many laws outside the candidates would look like one of them."""
    explanation = e.explanation
    if explanation is None or e.coincidence <= e.criteria.damping.specific[len(explanation.best.causes) - 1]:
        return ""
    objection = (
        "but the damping ratios are too few or too uncertain to rule out something outside the candidates: "
        f"{plain(100 * e.coincidence, 2)} % of such laws would look like a candidate"
    )
    return _would_explain(e, explanation, objection)


def _would_explain(e: LossEvidence, explanation: LossExplanation, objection: str) -> str:
    return f"{loss_names(e.fitter, explanation.best)} would explain it, {objection}"


def unexplained(e: LossEvidence) -> str:
    """No loss and no pair of losses leaves noise."""
    return "" if e.explanation else nearest_loss(e.fitter)


# Claims --------------------------------------------------------------------------------------------------------


def other_errors(e: LossEvidence) -> LossAnswer | None:
    """With errors halved or doubled, or priors twice as wide, another loss takes the place of a claimed one."""
    explanation = e.explanation
    assert explanation is not None  # the rule `unexplained` comes before
    for change, trial in e.trials.items():
        if trial.verdict is EFFECT_FOUND and not set(trial.final.causes) <= explanation.losses_of_classes:
            text = f"with {change}, {loss_names(e.fitter, trial.final)} would explain it better"
            return LossAnswer(text, rivals=(explanation.best, e.fitter.fit(trial.final.causes)))
    return None


def not_predicted(e: LossEvidence) -> str:
    """The ratios of the held-out poses contradict the explanation."""
    explanation = e.explanation
    if (
        explanation is None
        or e.held_out is None
        or not contradicts_held_out(e.held_out, explanation.best.values, e.criteria)
    ):
        return ""
    name = loss_names(e.fitter, explanation.best)
    return f"{name} would explain that of the fitted poses, but not that of the held-out ones"


def found(e: LossEvidence) -> LossAnswer:
    """One class of losses is left for each cause."""
    return LossAnswer("")


# The tables ----------------------------------------------------------------------------------------------------

_BEFORE_DOUBTS: LossRules = (
    Rule("damping.too_few", INSUFFICIENT_DATA, too_few),
    Rule("damping.adequate", ADEQUATE, as_declared),
    Rule("damping.several", AMBIGUOUS, several),
    Rule("damping.nearly_declared", ADEQUATE, nearly_declared),
    Rule("damping.common_ratio", ADEQUATE, common_ratio),
    Rule("damping.scattered", ADEQUATE, scattered),
)
_TELLS_NOTHING: Rule[LossEvidence, LossAnswer] = Rule(
    "damping.tells_nothing", INSUFFICIENT_DATA, tells_nothing
)
_UNEXPLAINED: Rule[LossEvidence, LossAnswer] = Rule("damping.unexplained", UNEXPLAINED, unexplained)
#: An explanation that does not predict the held-out poses.
NOT_PREDICTED = "damping.held_out"
_FOUND = Rule("damping.found", EFFECT_FOUND, found)

#: Where one of these applies, nothing is claimed.
DOUBTS: LossRules = (
    _TELLS_NOTHING,
    Rule("damping.chance", UNEXPLAINED, may_be_chance),
    Rule("damping.trend", UNEXPLAINED, leaves_a_trend),
    Rule("damping.not_specific", UNEXPLAINED, not_specific),
    _UNEXPLAINED,
)
#: Doubts in trials with other errors or priors: without the tests of chance, of a trend, and of specificity.
TRIAL_DOUBTS: LossRules = (_TELLS_NOTHING, _UNEXPLAINED)

#: The verdict on damping.
DAMPING_RULES: LossRules = (
    *_BEFORE_DOUBTS,
    *DOUBTS,
    Rule("damping.other_errors", AMBIGUOUS, other_errors),
    Rule(NOT_PREDICTED, UNEXPLAINED, not_predicted),
    _FOUND,
)
#: The verdict with other errors or priors.
TRIAL_RULES: LossRules = (*_BEFORE_DOUBTS, *TRIAL_DOUBTS, _FOUND)
