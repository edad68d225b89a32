"""The rules of the verdict, in tables (docs/reference/verdicts.md): the first of those tried that applies decides.

A rule has a name, which begins with that of its table, the verdict that it gives, and a function of the evidence,
whose docstring says when the rule applies, and which returns the reason of the verdict.  Those of
`rules_before_search` are tried first; if one applies, there is no search.  After a search come `rules_after_search`,
then `ADEQUACY_RULES` where the declared model leaves noise, `CLAIM_RULES` where causes do, else `UNEXPLAINED_RULES`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator

import numpy as np

from pkmodes.core.base.numbers import p_in_words, p_text, plain
from pkmodes.loop.diagnosis.readings import table
from pkmodes.loop.diagnosis.verdict.amplitude import depends_on_amplitude
from pkmodes.loop.diagnosis.verdict.classes import count_distinct_causes, find_more_general, lacks_whole
from pkmodes.loop.diagnosis.verdict.defaults import rests_on_undeclared_default
from pkmodes.loop.diagnosis.verdict.dispersion import frequency_dependent_stiffness
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Decision, Evidence, Rule, Start, T, first_decision
from pkmodes.loop.diagnosis.verdict.naming import explanation_in_words
from pkmodes.loop.diagnosis.verdict.notes import drift
from pkmodes.loop.diagnosis.verdict.reasons import causes_in_words, errors_in_words, names
from pkmodes.loop.diagnosis.verdict.shapes import better_by_shape, shapes_disagree
from pkmodes.loop.diagnosis.verdict.specificity import p_coincidence
from pkmodes.loop.diagnosis.verdict.too_few import too_few
from pkmodes.loop.diagnosis.verdict.unexplained import UNEXPLAINED_RULES, reason_of_refusal
from pkmodes.loop.diagnosis.verdict.values import single_row_in_words, single_row_objection, value_objection
from pkmodes.loop.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)

#: Largest number of other causes mentioned in a reason.
MAX_CAUSES_MENTIONED = 4


def decide_before_search(start: Start) -> Decision[Start, Answer] | None:
    """Return the verdict that needs no search; None if one is needed."""
    return first_decision(rules_before_search(), start)


def decide(evidence: Evidence) -> Decision[Evidence, Answer]:
    """Return the verdict after a search, and why it is given."""
    table_if_noise = CLAIM_RULES if evidence.final.causes else ADEQUACY_RULES
    last_table = table_if_noise if evidence.outcome.last_gate.passed else UNEXPLAINED_RULES
    decision = first_decision((*rules_after_search(), *last_table), evidence)
    assert decision is not None  # the last rule of each table always applies
    return decision


# The declared model leaves noise -------------------------------------------------------------------------------


def modes_of_other_shapes(e: Evidence) -> str:
    """The measured shapes are not those of the modes with their frequencies."""
    if not shapes_disagree(e.store, e.final):
        return ""
    return f"{e.explains} the frequencies, but not the shapes of some of these modes (MAC)"


def extra_modes(e: Evidence) -> str:
    """A row was set aside near which the model has no mode left: it is a mode that the model lacks."""
    fitter, final, lines = e.fitter, e.final, []
    for row in sorted(final.hypothesis.excluded_rows):
        setup = fitter.data.pose[row]
        # Modes that an error could have moved here, without those that were measured as well.
        difference = final.prediction.log_frequencies[setup] - fitter.observations.log_frequencies[row]
        is_near = np.abs(difference) < e.criteria.pairing.reach
        is_near[: final.prediction.rigid] = False
        partner = final.pairing.partner[fitter.observations.noise.rows[setup]]
        is_near[partner[partner >= 0]] = False
        if not is_near.any():
            lines.append(int(fitter.data.lines[row]))
    if not lines:
        return ""
    several = f"lines {', '.join(map(str, lines))} are modes"
    row_clause = several if len(lines) > 1 else f"line {lines[0]} is a mode"
    return (
        f"the declared model explains all other rows, but {row_clause} that it does not have: all its modes near "
        "there were measured as well"
    )


def unstated_error(e: Evidence) -> str:
    """The residual is noise only with an error that the modes of a pose share and the file does not state."""
    if not e.final.hypothesis.has_shared_error:
        return ""
    pattern = drift(e.fitter, e.final)
    drift_clause = f"; {pattern}" if pattern else ""
    return (
        f"the declared model explains the residual only with an error of {plain(100 * e.final.shared_error, 2)} % "
        f"that the modes of a pose share and the file does not state{drift_clause}: something changed between the "
        "poses, or an effect is missing"
    )


def not_predicted(e: Evidence) -> str:
    """The held-out poses contradict the result, or another cause explains all poses better."""
    return e.held_out.doubt


def nothing_missing(e: Evidence) -> Answer:
    """The residual is noise, as declared or with the uncertain values refitted."""
    gate = e.outcome.last_gate
    errors = errors_in_words(e.final, e.fitter.data.lines)
    errors_clause = f", with {errors}" if errors else ""
    p_values = f"({p_in_words(gate.p_value)}, and {p_text(gate.p_candidates)} for the best of all candidates)"
    if not e.refit_needed:
        return Answer(f"the residual of the declared model is noise {p_values}{errors_clause}")
    refit_clause = "the residual is noise once the uncertain values are refitted"
    return Answer(f"{refit_clause} {p_values}, not as declared ({p_in_words(e.p_declared)}){errors_clause}")


# Causes leave noise --------------------------------------------------------------------------------------------


def remote_cause(e: Evidence) -> str:
    """A remote cause, which is never claimed, is needed, survives, or explains far more."""
    final, rivals = e.final, e.claim.rivals
    is_doubtful = len(final.causes) == 1 and not e.claim.last_gate.passes_at(e.criteria.gate.plainly)
    better_fits = e.search.better_remote_causes(final) if is_doubtful else []
    remote_causes = [cause for fit in (final, *rivals, *better_fits) for cause in fit.causes if cause.remote]
    if not remote_causes:
        return ""
    cause, remedy = remote_causes[0], "look there"
    remedy += ", or add it to the candidates" if cause.nameable else ""
    return f"no candidate explains the residual alone, but {cause.name} would: {remedy}"


def in_one_joint(e: Evidence) -> str:
    """The cause in one of its joints alone explains as much as in all of them.

    A claim for all joints needs the same evidence against each joint alone as against another class.
    """
    store, c, final = e.store, e.criteria, e.final
    if len(final.causes) != 1:
        return ""
    fits, limit = e.search.single_joint_causes(final), final.deviance + c.claim.told_apart
    single = next((fit for fit in fits if fit.deviance < limit and store.p_value(fit) > c.gate.surely), None)
    if single is None:
        return ""
    return f"{e.explains} the residual, and so would {names(single.causes)}: look there, and measure more"


def better_shapes(e: Evidence) -> str:
    """Another explanation fits the measured shapes significantly better."""
    rival = better_by_shape(e.store, e.final)
    if rival is None:
        return ""
    rival_names = names(rival.causes) if rival.causes else "the declared model"
    verb = "fit" if len(rival.causes) > 1 else "fits"
    return f"{e.explains} the frequencies, but {rival_names} {verb} the shapes significantly better"


def general_cause(e: Evidence) -> str:
    """The residual points to a more general form of a cause, with a value of its own for each joint (score test)."""
    pair = find_more_general(e.search, e.final)
    if pair is None:
        return ""
    cause, general = pair
    return f"{cause.name} would explain the residual, but {general.name} would do so significantly better: look there"


def not_significant(e: Evidence) -> str:
    """The improvement may be chance: its p-value, corrected for the number of candidates, is above 0.1 %."""
    if all(p <= e.criteria.claim.claimed for p in e.claim.p_values):
        return ""
    errors = e.errors_instead
    errors_clause = f"; measurement errors would explain it too: {errors}" if errors else ""
    return (
        f"the residual points to {e.cause_names.removesuffix(',')}, but not clearly enough for a claim "
        f"({p_in_words(max(e.claim.p_values))} among all candidates): measure more{errors_clause}"
    )


def two_of_few(e: Evidence) -> str:
    """Two causes would be claimed from fewer than ten measured modes, or two changes at once."""
    rows, needed_rows = len(e.fitter.observations.log_frequencies), e.criteria.claim.rows_for_two
    if len(e.final.causes) < 2:
        return ""
    if not e.criteria.claim.claims_several:
        return (
            f"{names(e.final.causes)} together would explain the residual, but two changes at once are not claimed: "
            "measure a state between them"
        )
    if rows >= needed_rows:
        return ""
    return (
        f"{names(e.final.causes)} together would explain the residual, but two causes are not claimed from {rows} "
        f"measured modes: measure {needed_rows} or more"
    )


def measurement_errors(e: Evidence) -> str:
    """Errors of the measurement explain the residual nearly as well."""
    if not e.errors_instead:
        return ""
    return f"{e.explains} the residual, but measurement errors would do so nearly as well: {e.errors_instead}"


def not_specific(e: Evidence) -> str:
    """The data are too few: a residual that no candidate caused would look like one in more than 5 % of draws."""
    p_value = p_coincidence(e.search, e.final)
    if p_value <= e.criteria.claim.specific:
        return ""
    # Other single causes that would explain the residual, best first.
    store = e.store
    fits = [
        fit
        for fit in store.all_fits()
        if len(fit.causes) == 1
        and not (fit.hypothesis.remote or fit.at_bound)
        and fit.causes != e.final.causes
        and fit.causes[0].name not in e.members
    ]
    passing_fits = sorted((f for f in fits if store.p_value(f) > e.criteria.gate.surely), key=store.criterion)
    alternatives = [fit.causes[0].name for fit in passing_fits[:MAX_CAUSES_MENTIONED]]
    alternatives_clause = f" (and so would {', '.join(alternatives)})" if alternatives else ""
    return (
        f"{e.explains} the residual{alternatives_clause}, but the data are too few to rule out a cause outside the "
        f"candidates: {plain(100 * p_value, 2)} % of such causes would look like a candidate; measure more"
    )


def value_without_support(e: Evidence) -> str:
    """A value is within a standard deviation of a bound, or does not differ significantly from the declared one."""
    return value_objection(e.search, e.final)


def depends_on_one_row(e: Evidence) -> str:
    """A cause is not detected without one row, or its value moves by five standard deviations."""
    return single_row_objection(e.search, e.final)


def not_settled(e: Evidence) -> Answer | str:
    """The preferred causes do not pass the gate, or do not survive in their places."""
    causes, (refusal, indicated_candidates) = e.final.causes, reason_of_refusal(e, e.final)
    if refusal:
        text = f"the best explanation, {names(causes)}, is not claimed: {refusal}"
        return Answer.naming(text, [*causes, *indicated_candidates])
    if e.claim.causes_survive:
        return ""
    unhelpful_causes = [
        cause for place, cause in enumerate(causes) if not e.store.improves_prediction(e.final, place)
    ]
    if not unhelpful_causes:
        return f"{e.explains} the residual, but the comparison with other causes settles on none"
    subject = f"{names(unhelpful_causes)} " if len(unhelpful_causes) < len(causes) else ""
    verb = "does" if len(unhelpful_causes) == 1 else "do"
    clause = f"{subject}{verb} not help to predict poses left out of the fit"
    return f"{e.explains} the residual, but {clause}: measure at more poses"


def several_explanations(e: Evidence) -> Answer | None:
    """Several classes or pairs survive, or one class of more than five members, or of directions without a whole."""
    claim, limit = e.claim, e.criteria.claim.most_members
    is_large = any(
        count_distinct_causes(fits) > limit or lacks_whole(fits) for fits in claim.class_of_each_cause
    )
    are_several = claim.rivals or any(len(groups) > 1 for groups in claim.classes_by_cause)
    if not are_several and not is_large:
        return None
    single_joints = {name: joint.sentence for name, joint in e.single_joints.items()}
    remarks = single_joints | dict.fromkeys(claim.implausible_names, "implausible")
    remaining_names = [
        [f"{name} ({remarks[name]})" if name in remarks else name for name, _ in group]
        for group in claim.remaining_explanations()
    ]
    listed = "; ".join(" or ".join(group) for group in remaining_names)
    if len(remaining_names) == 1:
        return Answer(f"these data cannot tell {len(remaining_names[0])} explanations apart: {listed}")
    return Answer(f"{len(remaining_names)} different explanations remain: {listed}")


def another_with_other_errors(e: Evidence) -> Answer | None:
    """With errors halved or doubled, or priors twice as wide, another cause takes the place of a claimed one."""
    for trial in e.trials:
        if trial.better_rival is not None:
            text = (
                f"{e.explains} the residual, but with {trial.stability.change}, {names(trial.better_rival.causes)} "
                "would do so better"
            )
            return Answer.naming(text, e.final.causes, trial.better_rival)
    return None


def held_by_priors(e: Evidence) -> str:
    """With priors twice as wide the value of a cause changes."""
    if not any(trial.value_moved for trial in e.trials):
        return ""
    subject = "its value changes" if len(e.final.causes) == 1 else "their values change"
    explanation = "some uncertain parameter is far from its declared value and compensates for something else"
    return f"{e.explains} the residual, but {subject} with priors twice as wide: {explanation}"


def one_term(e: Evidence) -> str:
    """A term, beyond the catalogue, is clearly better, or survives beside several causes or a value of one axis."""
    term = e.term_instead
    if term is None:
        return ""
    description = causes_in_words(term.causes)
    if len(e.final.causes) > 1:
        return f"{names(e.final.causes)} together would explain the residual, but {description} would do so alone"
    return f"{e.explains} the residual, but so would {description}"


def causes_found(e: Evidence) -> Answer:
    """One class for each cause is left."""
    gate, errors = e.outcome.first_gate, errors_in_words(e.final, e.fitter.data.lines)
    min_p_value = min(gate.p_value, gate.p_candidates)
    errors_clause = f"; {errors}" if errors else ""
    explanation = explanation_in_words(e.claim.findings(e.fitter, e.single_joints))
    single_row = single_row_in_words(e.search, e.final)
    single_row_clause = f"; {single_row}" if single_row else ""
    return Answer(
        f"the residual of the declared model is not noise ({p_in_words(min_p_value)}); "
        f"{explanation}{single_row_clause}{errors_clause}"
    )


# The tables ----------------------------------------------------------------------------------------------------


def rules_before_search() -> tuple[Rule[Start, Answer], ...]:
    """Return the rules that are tried before a search."""
    return (
        *_reading_rules(
            "before", lambda reading: None if reading.refitted else reading.declared, lambda s: (s.fitter,)
        ),
        Rule("before.too_few", INSUFFICIENT_DATA, too_few),
        *_reading_rules("before", lambda reading: reading.refitted, lambda s: (s.store,)),
    )


def rules_after_search() -> tuple[Rule[Evidence, Answer], ...]:
    """Return the rules that are tried after a search, whatever its result."""
    return (
        *_reading_rules("after", lambda reading: reading.explained, lambda e: (e.fitter, e.final)),
        Rule[Evidence, Answer]("after.amplitude", UNEXPLAINED, depends_on_amplitude),
    )


def _reading_rules(
    prefix: str,
    question: Callable[[table.Reading], Callable[..., str] | None],
    arguments: Callable[[T], tuple[object, ...]],
) -> Iterator[Rule[T, Answer]]:
    """Yield the rules about other readings of the data."""
    for reading in table.READINGS:
        if ask := question(reading):
            answer = functools.partial(_answer_of_reading, ask, arguments)
            yield Rule(f"{prefix}.{reading.name}", UNEXPLAINED, functools.wraps(ask)(answer))


def _answer_of_reading(
    ask: Callable[..., str], arguments: Callable[[T], tuple[object, ...]], evidence: T
) -> Answer | None:
    """Return what is wrong in the file: nothing is claimed, and no cause named."""
    text = ask(*arguments(evidence))
    return Answer(text, decided_by_reading=True) if text else None


#: Tried if the declared model leaves noise.
ADEQUACY_RULES: tuple[Rule[Evidence, Answer], ...] = (
    Rule("adequacy.shapes", UNEXPLAINED, modes_of_other_shapes),
    Rule("adequacy.extra_modes", UNEXPLAINED, extra_modes),
    Rule("adequacy.unstated_error", UNEXPLAINED, unstated_error),
    Rule("adequacy.held_out", UNEXPLAINED, not_predicted),
    Rule("adequacy.adequate", ADEQUATE, nothing_missing),
)

#: Tried if causes leave noise.
CLAIM_RULES: tuple[Rule[Evidence, Answer], ...] = (
    Rule("claims.remote", UNEXPLAINED, remote_cause),
    Rule("claims.one_joint", UNEXPLAINED, in_one_joint),
    Rule("claims.shapes", UNEXPLAINED, modes_of_other_shapes),
    Rule("claims.better_shapes", UNEXPLAINED, better_shapes),
    Rule("claims.more_general", UNEXPLAINED, general_cause),
    Rule("claims.not_significant", UNEXPLAINED, not_significant),
    Rule("claims.two_of_few", UNEXPLAINED, two_of_few),
    Rule("claims.errors", UNEXPLAINED, measurement_errors),
    Rule("claims.not_specific", UNEXPLAINED, not_specific),
    Rule("claims.no_value", UNEXPLAINED, value_without_support),
    Rule("claims.one_row", UNEXPLAINED, depends_on_one_row),
    Rule("claims.not_settled", UNEXPLAINED, not_settled),
    Rule("claims.several", AMBIGUOUS, several_explanations),
    Rule("claims.default", AMBIGUOUS, rests_on_undeclared_default),
    Rule("claims.other_errors", AMBIGUOUS, another_with_other_errors),
    Rule("claims.priors", UNEXPLAINED, held_by_priors),
    Rule("claims.dispersion", UNEXPLAINED, frequency_dependent_stiffness),
    Rule("claims.held_out", UNEXPLAINED, not_predicted),
    Rule("claims.one_term", AMBIGUOUS, one_term),
    Rule("claims.found", EFFECT_FOUND, causes_found),
)
