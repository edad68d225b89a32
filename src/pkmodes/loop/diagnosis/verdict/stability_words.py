"""Why a diagnosis changes with other errors or priors, as a clause for the terminal and the report."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.findings import Stability
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
    VERDICTS,
)

HALVED_ERRORS, DOUBLED_ERRORS, WIDENED_PRIORS = "sigma x 0.5", "sigma x 2", "priors x 2"
#: What explains the residual, or the part that the best explanation leaves, under each change.
EXPLAINED_BY_CHANGE = {
    DOUBLED_ERRORS: "errors twice as large would explain {what}",
    WIDENED_PRIORS: "the uncertain values would then make up for {what}",
}
#: Why nothing explains the residual any more: with halved errors even the right explanation leaves too much.
UNEXPLAINED_BY_CHANGE = {
    HALVED_ERRORS: "usual where the stated sigma is right",
    WIDENED_PRIORS: "the priors hold the explanation together",
}
#: Why other explanations are as good.
AMBIGUOUS_BY_CHANGE = {
    HALVED_ERRORS: "smaller errors make noise look significant",
    DOUBLED_ERRORS: "errors twice as large no longer tell it from others",
    WIDENED_PRIORS: "the uncertain values would then make up for the differences",
}


#: Changes of the verdict that the errors themselves explain: smaller errors turn noise into a residual, larger errors
#: turn a residual into noise.
EXPECTED_CHANGES = {(HALVED_ERRORS, UNEXPLAINED.word), (DOUBLED_ERRORS, ADEQUATE.word)}


def is_stable(result: Diagnosis) -> bool:
    """Return whether a verdict is stable: at most one change gives another verdict, which the errors explain."""
    different = [entry for entry in result.stability if not same_verdict(result, entry)]
    return len(different) <= 1 and all(
        (entry.change, entry.verdict) in EXPECTED_CHANGES for entry in different
    )


def same_verdict(result: Diagnosis, entry: Stability) -> bool:
    """Return whether a change leaves the verdict and its causes as they are."""
    claimed = {member for effect in result.effects for member in effect.members}
    return entry.verdict == result.verdict and (not claimed or set(entry.effects) <= claimed)


def reason_of_change(result: Diagnosis, entry: Stability) -> str:
    """Return why a change gives a diagnosis another verdict; empty if it does not, or for no known reason."""
    if same_verdict(result, entry) or INSUFFICIENT_DATA.word in (result.verdict, entry.verdict):
        return ""
    is_settled = VERDICTS[result.verdict].settled
    if entry.verdict == ADEQUATE.word:
        return EXPLAINED_BY_CHANGE.get(entry.change, "").format(what="the residual")
    if entry.verdict == UNEXPLAINED.word:
        return (
            UNEXPLAINED_BY_CHANGE.get(entry.change, "")
            if is_settled or result.verdict == AMBIGUOUS.word
            else ""
        )
    if result.verdict == UNEXPLAINED.word:
        return EXPLAINED_BY_CHANGE.get(entry.change, "").format(what="what it leaves")
    if result.verdict == ADEQUATE.word:
        return AMBIGUOUS_BY_CHANGE[HALVED_ERRORS] if entry.change == HALVED_ERRORS else ""
    if entry.verdict == AMBIGUOUS.word:
        return AMBIGUOUS_BY_CHANGE.get(entry.change, "")
    if result.verdict == AMBIGUOUS.word and entry.verdict == EFFECT_FOUND.word:
        return "smaller errors would decide" if entry.change == HALVED_ERRORS else ""
    return ""
