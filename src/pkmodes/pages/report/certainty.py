"""How certain the verdict of a diagnosis is, in sentences: its probability, its limits, and the size of a cause."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE
from pkmodes.loop.diagnosis.verdict.findings import saved_as
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.stability_words import (
    is_stable,
    same_verdict,
)
from pkmodes.loop.diagnosis.verdict.terms import Beyond, TermClass
from pkmodes.loop.diagnosis.verdict.verdicts import VERDICTS
from pkmodes.pages.report.blocks import Cell
from pkmodes.pages.report.formatting import explanation_with_names, to_sentence
from pkmodes.pages.report.stability import CHANGE_TITLES

#: Wording of a probability, by its lower bound: 96, 80 and 52 % of the most probable explanations were right
#: (docs/reference/results.md).
PROBABILITY_PHRASES = ((0.9, "very likely that"), (0.7, "likely that"), (0.0, "doubtful whether"))
#: Probability below which a claim is doubtful.
MIN_LIKELY_PROBABILITY = PROBABILITY_PHRASES[1][0]
#: Chi-square per degree of freedom below which the stated errors are far larger than the residual: twice as large.
MIN_CHI2_PER_DOF = 0.25
#: Relative standard deviation of a size from which it is told also where the verdict depends on the stated errors.
MIN_TOLD_SIGMA = 0.2
#: Probabilities above this are not distinguished.
MAX_STATED_PROBABILITY = 0.99


def certainty(result: Diagnosis) -> list[Cell]:
    """Return how certain the verdict is, what limits it, and how well the size of a cause is known."""
    if result.beyond is not None and (term_class := claimed_term_class(result)):
        return [Cell(" ".join(map(to_sentence, _certainty_of_terms(result.beyond, term_class))))]
    p, excluded = _claim_probability(result)
    likelihood = (
        "the tests allow that"
        if p is None
        else f"it is {next(phrase for minimum, phrase in PROBABILITY_PHRASES if p >= minimum)}"
    )
    has_several_causes = len(result.effects) > 1
    has_alternatives = any(len(effect.members) > 1 for effect in result.effects)
    subject = "these" if has_several_causes else "one of these" if has_alternatives else "this"
    causes_clause = f"{subject} {'are the causes' if has_several_causes else 'is the cause'}"
    if excluded:
        noun = "pair" if has_several_causes else "explanation"
        others = (
            f"one other {noun} that acts" if excluded == 1 else f"one of {excluded} other {noun}s that act"
        )
        causes_clause = f"the cause{'s are' if has_several_causes else ' is'} {subject} or {others} alike"
    claim = VERDICTS[result.verdict].sure.format(likely=likelihood, what=causes_clause)
    of_all = " for all of them together" if excluded else ""
    sentences = [claim if p is None else f"{claim} (probability {_probability_text(p)}{of_all})"]
    if excluded:
        remaining = "the alternatives named" if subject == "one of these" else subject
        sentences.append(f"of these, the tests of the verdict leave only {remaining}")
    if doubtful_probability(result) and result.probabilities is not None:
        explanation, top_probability = result.probabilities.top
        if explanation == OUTSIDE:
            outside = _probability_text(top_probability)
            sentences.append(f"more probable is something that is not among the candidates ({outside})")
    if has_alternatives:
        sentences.append("these data cannot tell which of the alternatives it is")
    values = [
        value for effect in result.effects for name in effect.members for value in effect.alternatives[name]
    ]
    saved = saved_as(values[0], result.corrected) if len(values) == 1 else None
    if saved is not None and saved.value != saved.declared:
        relative_sigma = saved.saved_sigma / abs(saved.value - saved.declared)
        depends_on_errors = any(not same_verdict(result, entry) for entry in result.stability)
        # A small error is not told where the verdict depends on the stated ones; that a size is hardly known, always.
        error = None if depends_on_errors and relative_sigma < MIN_TOLD_SIGMA else result.after
        sentences += [accuracy] if (accuracy := _accuracy_of_size(relative_sigma, error)) else []
    if clause := deciding_errors(result):
        sentences.append(clause)
    if not result.settled and not result.survivors and result.probabilities is not None:
        explanation, p = result.probabilities.top
        if explanation == OUTSIDE:
            sentences.append(
                f"most probable is something that is not among the candidates ({_probability_text(p)})"
            )
        else:
            members = (explanation,) if isinstance(explanation, str) else explanation
            first_member = members[0] if isinstance(members[0], str) else " + ".join(members[0])
            lookalike_clause = ", or what acts like this" if len(members) > 1 else ""
            words = f"{explanation_in_words(first_member, result)}{lookalike_clause}"
            sentences.append(
                f"the most probable explanation, not certain enough to be claimed, is: {words} "
                f"({_probability_text(p)})"
            )
    text = " ".join(map(to_sentence, sentences))
    return [Cell(text)]


def _accuracy_of_size(relative_sigma: float, error: Error | None) -> str:
    """Return how well the size of a cause is known, relative to it; empty where the errors with it are unknown.

    - error: of the model with the cause: with a residual far below the stated errors, these are wrong
    """
    if error is None:
        return ""
    text = f"its size is known to within {plain(100.0 * relative_sigma, 2)} % (one standard deviation"
    if error.chi2_per_dof < MIN_CHI2_PER_DOF:
        return f"{text} by the stated errors, which are far larger than the residual)"
    return f"{text})"


def _certainty_of_terms(beyond: Beyond, term_class: TermClass) -> Iterator[str]:
    """Yield how certain a claim beyond the catalogue is."""
    has_alternatives = len(term_class.finding.members) > 1
    yield (
        f"of {beyond.tried} changes at a single place that were tried where the catalogue does not explain the "
        f"measurements, the tests leave {'only these' if has_alternatives else 'only this one'}"
    )
    if has_alternatives:
        yield "these data cannot tell which of the alternatives it is"
    elif len(term_class.finding.parameters) == 1:
        (value,) = term_class.finding.parameters
        declared = next(
            (parameter.declared for parameter in term_class.corrected if parameter.name == value.name), 0.0
        )
        if value.value != declared:
            relative_sigma = value.sigma / abs(value.value - declared)
            yield _accuracy_of_size(relative_sigma, term_class.errors[term_class.finding.name])


def doubtful_probability(result: Diagnosis) -> str:
    """Return the probability of a claim that is doubtful, in per cent; empty where none is."""
    p, _ = _claim_probability(result)
    return _probability_text(p) if result.effects and p is not None and p < MIN_LIKELY_PROBABILITY else ""


def deciding_errors(result: Diagnosis) -> str:
    """Return with which other errors or priors a claim has another verdict, as a clause; empty if it is stable."""
    if not result.settled or not result.stability or is_stable(result):
        return ""
    deciding_changes = [entry.change for entry in result.stability if not same_verdict(result, entry)]
    words = joined([CHANGE_TITLES.get(change, change) for change in deciding_changes], "or")
    return f"with {words}, the verdict changes"


def claim_condition(result: Diagnosis) -> str:
    """Return with which other errors or priors a claimed cause falls, as a clause; empty if there are none."""
    return deciding_errors(result) if result.effects else ""


def is_claim_in_doubt(result: Diagnosis) -> bool:
    """Return whether a claimed cause is doubtful, or falls with other errors or priors."""
    return bool(doubtful_probability(result) or claim_condition(result))


def _claim_probability(result: Diagnosis) -> tuple[float | None, int]:
    """Return the probability of the claim, and how many explanations in it the tests of the verdict excluded.

    None if nothing is claimed, or its probability is unknown.
    """
    probabilities = result.probabilities
    if probabilities is None or not result.settled:
        return None, 0
    if not result.effects:
        return probabilities.nothing_missing, 0
    claimed = [set(effect.members) for effect in result.effects]
    p, excluded = 0.0, 0
    for statement in probabilities.classes if len(claimed) == 1 else probabilities.pairs:
        causes = [(member,) if isinstance(member, str) else member for member in statement.members]
        matches = [  # whether they are those claimed, one of each class
            any(all(map(set.__contains__, claimed, order)) for order in permutations(names))
            for names in causes
        ]
        if any(matches):
            p, excluded = p + statement.probability, excluded + matches.count(False)
    return p, excluded


def _probability_text(p: float) -> str:
    return f"over {100 * MAX_STATED_PROBABILITY:.0f} %" if p > MAX_STATED_PROBABILITY else f"{100 * p:.0f} %"


def claimed_term_class(result: Diagnosis) -> TermClass | None:
    """Return the class found beyond the catalogue; None if the catalogue itself names a cause."""
    return result.beyond.found if result.beyond is not None and not result.effects else None


def explanation_in_words(name: str, result: Diagnosis) -> str:
    """Return an explanation in words, with its names."""
    if name == NOTHING_MISSING:
        return "nothing is missing"
    sentences = dict(result.sentences)
    for term_class in result.beyond.classes if result.beyond is not None else ():
        sentences |= {name: term_class.finding.member(name).sentence for name in term_class.finding.members}
    return explanation_with_names(name, sentences)
