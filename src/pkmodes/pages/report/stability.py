"""How a diagnosis changes with other stated errors and priors, and why, in one sentence."""

from __future__ import annotations

from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.verdict.findings import Stability
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.stability_words import (
    DOUBLED_ERRORS,
    HALVED_ERRORS,
    WIDENED_PRIORS,
    reason_of_change,
    same_verdict,
)
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, EFFECT_FOUND, INSUFFICIENT_DATA, UNEXPLAINED

#: The changes of the stability test, in words.
CHANGE_TITLES = {
    HALVED_ERRORS: "sigma halved",
    DOUBLED_ERRORS: "sigma doubled",
    WIDENED_PRIORS: "priors twice as wide",
}
NO_EXPLANATION = "nothing explains the residual"


def stability_sentence(result: Diagnosis) -> str:
    """Return what the changes of the stability test find; empty where nothing was tested.

    It begins with "stable" where no change gives another verdict; where a term was found, with "the catalogue alone".
    """
    if not result.stability or result.verdict == INSUFFICIENT_DATA.word:
        return ""
    claimed = {member for effect in result.effects for member in effect.members}
    outcomes: dict[tuple[str, str], list[str]] = {}
    for entry in result.stability:
        key = _outcome(result, entry, claimed), reason_of_change(result, entry)
        outcomes.setdefault(key, []).append(entry.change)
    same_outcome = _same_outcome(result)
    order = sorted(outcomes, key=lambda outcome: outcome[0] != same_outcome)  # what stays comes first
    outcome_texts = []
    for outcome, reason in order:
        words = joined([CHANGE_TITLES.get(change, change) for change in outcomes[outcome, reason]])
        also_word = "also " if len(outcomes) == 1 and " " not in outcome else ""
        outcome_texts.append(f"{outcome} {also_word}with {words}{f' ({reason})' if reason else ''}")
    catalogue_clause = (
        "the catalogue alone, " if result.beyond is not None and result.beyond.found is not None else ""
    )
    unchanged = all(same_verdict(result, entry) for entry in result.stability)
    return f"{catalogue_clause}{'stable' if unchanged else 'stability'}: {'; '.join(outcome_texts)}"


def _outcome(result: Diagnosis, entry: Stability, claimed: set[str]) -> str:
    """Return what one change finds."""
    names = " and ".join(entry.effects)
    if entry.verdict == ADEQUATE.word:
        return "no cause is needed" if claimed else ADEQUATE.word
    if entry.verdict == UNEXPLAINED.word:
        return NO_EXPLANATION if claimed else UNEXPLAINED.word
    if not names or (not claimed and entry.verdict == result.verdict):
        return entry.verdict
    if claimed and set(entry.effects) <= claimed:
        return (
            _same_outcome(result)
            if entry.verdict == result.verdict
            else f"{_same_outcome(result)}, but not alone,"
        )
    explanation = names if entry.verdict == EFFECT_FOUND.word else f"{names}, but not alone,"
    return (
        f"{explanation} instead"
        if claimed
        else f"the best explanation, which is not claimed, is {explanation}"
    )


def _same_outcome(result: Diagnosis) -> str:
    if result.effects:
        return "the same cause" + ("s" if len(result.effects) > 1 else "")
    return result.verdict
