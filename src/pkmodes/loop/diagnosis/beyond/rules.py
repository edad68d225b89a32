"""The rules beyond the catalogue, in a table: the first that applies decides whether a term is found.

A term is claimed on the same conditions as a cause of the catalogue (`verdict.rules`), and on two more, since so many
are tried: its residual points to no other term, and nothing that varies with the position, the order of the setups or
the frequency explains as much.
"""

from __future__ import annotations

from pkmodes.core.base.numbers import p_in_words, plain
from pkmodes.loop.diagnosis.beyond.evidence import TermEvidence
from pkmodes.loop.diagnosis.verdict import rules
from pkmodes.loop.diagnosis.verdict.classes import are_added_modes_credible, count_distinct_causes
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Rule
from pkmodes.loop.diagnosis.verdict.misfit import size_in_words
from pkmodes.loop.diagnosis.verdict.naming import explanation_in_words
from pkmodes.loop.diagnosis.verdict.reasons import errors_in_words, names, without_mode
from pkmodes.loop.diagnosis.verdict.verdicts import FOUND, NOTHING, SEVERAL


def nothing(e: TermEvidence) -> str:
    """No term leaves noise."""
    if e.groups:
        return ""
    sentence = (
        f"none of the {len(e.term_fits.terms)} terms, each one form at one place, explains the measurements"
    )
    if not e.final.causes:
        return sentence
    best = f"the best, {e.term_names}, is refused"
    if e.final.at_bound:
        return f"{sentence}: {best}, because {', '.join(e.final.at_bound)} is at its bound"
    p_value = e.store.p_value(e.final)
    if p_value <= e.criteria.gate.surely < e.store.frequency_p_value(e.final):
        p = p_in_words(p_value)
        return f"{sentence}: the best, {e.term_names}, leaves frequencies as measured, but not shapes ({p})"
    if p_value <= e.criteria.gate.surely:
        size = size_in_words(e.store.frequency_misfit(e.final), p_value=p_value)
        return f"{sentence}: the best, {e.term_names}, leaves a residual {size}"
    if not are_added_modes_credible(e.search, e.final):
        return f"{sentence}: {best}, because it adds modes between the measured ones that were not measured"
    return f"{sentence}: {best}, because it does not help to predict setups left out of the fit"


def in_the_catalogue(e: TermEvidence) -> str:
    """The best explanation that leaves noise is one of the catalogue, and no term is in its class."""
    if e.has_term:
        return ""
    return (
        f"none of the {len(e.term_fits.terms)} terms, each one form at one place, explains the measurements as "
        f"well as {names(e.final.causes)} of the catalogue"
    )


def leaves_more(e: TermEvidence) -> str:
    """What the best term leaves is not noise in all respects, or points to another term."""
    gate, level = e.claim.last_gate, e.criteria.gate.surely
    opening = f"{e.term_names} would explain nearly all of the residual, but"
    if gate.unpaired_count:
        return f"{opening} with it the model has {without_mode(gate.unpaired_count)}"
    if gate.p_unmeasured <= level:
        return f"{opening} adds modes between the measured ones that were not measured"
    if not gate.passes_at(level):
        return f"{opening} what it leaves still points to a cause of the catalogue ({p_in_words(gate.p_candidates)})"
    if e.remaining_term is not None:
        term, p_value = e.remaining_term
        return (
            f"{opening} what it leaves still points to {term.sentence or term.name} ({p_in_words(p_value)})"
        )
    return ""


def like_a_law(e: TermEvidence) -> str:
    """Something that varies with the position, the order of the setups or the frequency explains as much."""
    law = e.law
    if law is None:
        return ""
    return f"{e.term_names} would explain the residual, but so would {law.quantity}, if it varied {law.dependence}"


def not_specific(e: TermEvidence) -> str:
    """More than 1 % of the residuals of this size that no term has would look like some term."""
    if e.p_outside <= e.criteria.claim.specific_term:
        return ""
    return (
        f"{e.term_names} would explain the residual, but the data are too few to rule out something that no term "
        f"has: {plain(100 * e.p_outside, 2)} % of such residuals would look like some term; measure more"
    )


def implausible(e: TermEvidence) -> str:
    """No member of the class has a value that such a part can have."""
    finding = e.finding(0)
    if any(finding.plausible.values()):
        return ""
    reason = finding.member(finding.name).implausible
    return f"{e.term_names} would explain the residual, but no such part has its value: {reason}"


def several(e: TermEvidence) -> str:
    """Several classes leave noise, or one of more than five members."""
    if len(e.groups) > 1:
        best = "; ".join(_member_list(e, k) for k in range(min(len(e.groups), rules.MAX_CAUSES_MENTIONED)))
        unlisted = len(e.groups) - rules.MAX_CAUSES_MENTIONED
        unlisted_clause = f"; and {unlisted} more" if unlisted > 0 else ""
        return f"{len(e.groups)} different explanations remain: {best}{unlisted_clause}"
    members = count_distinct_causes(e.groups[0])
    if members <= e.criteria.claim.most_members:
        return ""
    return f"these data cannot tell {members} explanations apart: {_member_list(e, 0)}"


def found(e: TermEvidence) -> Answer:
    """One class of at most five members is left."""
    setting_aside = errors_in_words(e.final, e.fitter.data.lines)
    outlier_clause = f"; {setting_aside}" if setting_aside else ""
    first = e.outcome.first_gate
    p = p_in_words(min(first.p_value, first.p_candidates))
    text = explanation_in_words([e.finding(0)])
    return Answer(
        f"{text}; the residual of the declared model is not noise ({p}), and the tests rule out all "
        f"others of the {len(e.term_fits.terms)} terms tried, each of one form at one place{outlier_clause}"
    )


def _member_list(e: TermEvidence, k: int) -> str:
    """Return the members of a class, and how many more it has."""
    group = e.groups[k]
    member_names = [
        names(fit.causes) + (" (implausible)" if fit.causes[-1].name in e.claim.implausible_names else "")
        for fit in group[: e.criteria.claim.most_members]
    ]
    unlisted = len(group) - len(member_names)
    return " or ".join(member_names) + (f" or {unlisted} more" if unlisted > 0 else "")


#: Rules for what was tried beyond the catalogue.
BEYOND_RULES: tuple[Rule[TermEvidence, Answer], ...] = (
    Rule("beyond.nothing", NOTHING, nothing),
    Rule("beyond.in_the_catalogue", NOTHING, in_the_catalogue),
    Rule("beyond.leaves_more", NOTHING, leaves_more),
    Rule("beyond.shapes", NOTHING, rules.modes_of_other_shapes),
    Rule("beyond.better_shapes", NOTHING, rules.better_shapes),
    Rule("beyond.one_row", NOTHING, rules.depends_on_one_row),
    Rule("beyond.errors", NOTHING, rules.measurement_errors),
    Rule("beyond.not_significant", NOTHING, rules.not_significant),
    Rule("beyond.no_value", NOTHING, rules.value_without_support),
    Rule("beyond.implausible", NOTHING, implausible),
    Rule("beyond.several", SEVERAL, several),
    Rule("beyond.law", NOTHING, like_a_law),
    Rule("beyond.not_specific", NOTHING, not_specific),
    Rule("beyond.other_errors", NOTHING, rules.another_with_other_errors),
    Rule("beyond.priors", NOTHING, rules.held_by_priors),
    Rule("beyond.held_out", NOTHING, rules.not_predicted),
    Rule("beyond.found", FOUND, found),
)
