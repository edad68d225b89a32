"""Caveats of a verdict: which values were refitted and by how much, and what the data cannot show."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pkmodes.core.base.numbers import plain, round_to_sigma
from pkmodes.core.support.ordering import listed
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.search.limits import ONE_SIDED_SIGMAS
from pkmodes.loop.diagnosis.verdict.findings import Corrected

#: Smallest distance of a conspicuous refitted value from its declared one, in standard deviations of prior or fit.
MIN_CONSPICUOUS_SIGMAS = Criteria.reasons.far
#: Largest numbers of values and of candidates named in a sentence.
MAX_VALUES, MAX_NAMES = 3, 4


@dataclass(frozen=True)
class Caveats:
    """The caveats of a settled decision; a field is empty where it does not apply.

    - refitted: which values were refitted, where the residual is noise only because of that
    - conspicuous: which refitted values are also in the headline
    - unseen: what an adequate model may still lack
    """

    refitted: str = ""
    conspicuous: str = ""
    unseen: str = ""

    def appended_to(self, reason: str) -> str:
        """Return a reason followed by the caveats; the refitted values include the conspicuous ones."""
        clauses = (
            f"{reason}: {self.refitted}" if self.refitted else reason,
            "" if self.refitted else self.conspicuous,
            self.unseen,
        )
        return "; ".join(clause for clause in clauses if clause)


def refitted_in_words(values: Sequence[Corrected]) -> str:
    """Return which uncertain values a fit moved most, and by how much; empty where there are none."""
    ranked = sorted((v for v in values if v.prior_sigma), key=lambda v: -abs(_deviation(v)))
    reported = [v for v in ranked if abs(_deviation(v)) >= 1.0][:MAX_VALUES] or ranked[:1]
    reported += [v for v in ranked if v not in reported and _may_be_due_to_unseen(v)]
    return ", ".join(
        f"{_name(v)} {_change_in_words(v)} ({_deviation(v):+.1f} sigma{_same_effect_clause(v)})"
        for v in reported
    )


def conspicuous_in_words(values: Sequence[Corrected], *, refit_was_needed: bool) -> str:
    """Return which refitted values belong in the headline; empty if none does.

    - refit_was_needed: whether the refit alone made the residual noise: then also values that an unseen candidate
      could have moved
    """
    far_values = [v for v in values if v.prior_sigma and abs(_deviation(v)) > MIN_CONSPICUOUS_SIGMAS]
    parts = [f"{_name(v)} is {abs(_deviation(v)):.1f} sigma from its declared value" for v in far_values]
    if refit_was_needed:
        due_to_unseen = (v for v in values if v not in far_values and _may_be_due_to_unseen(v))
        parts += [
            f"{_name(v)} was refitted {_change_in_words(v)} ({_deviation(v):+.1f} sigma{_same_effect_clause(v)})"
            for v in due_to_unseen
        ]
    return ", ".join(parts[:MAX_VALUES])


def undetectable_in_words(undetectable: Sequence[str], others_are_limited: bool) -> str:
    """Return what an adequate model may still lack; empty where nothing was suspected.

    - undetectable: candidates that these data cannot show
    - others_are_limited: whether other candidates have limits
    """
    if undetectable:
        others = ", nor other causes below their limits" if others_are_limited else ""
        return f"these data cannot show {listed(undetectable, MAX_NAMES)}{others}"
    return "these data cannot show causes below their limits" if others_are_limited else ""


def _may_be_due_to_unseen(value: Corrected) -> bool:
    """Return whether a fit clearly moved a value, and an unseen candidate could have caused all of that."""
    change = abs(value.value - value.declared)
    return (
        value.prior_sigma is not None
        and value.unseen is not None
        and MIN_CONSPICUOUS_SIGMAS * value.sigma < change <= ONE_SIDED_SIGMAS * value.unseen.sigma
    )


def _same_effect_clause(value: Corrected) -> str:
    if value.unseen is None or not _may_be_due_to_unseen(value):
        return ""
    return f"; {value.unseen.agent} would have the same effect"


def _deviation(value: Corrected) -> float:
    """Return the deviation from the declared value, in standard deviations of its prior; 0 without a prior."""
    return (value.value - value.declared) / value.prior_sigma if value.prior_sigma else 0.0


def _name(value: Corrected) -> str:
    return value.name.removeprefix("effects.")


def _change_in_words(value: Corrected) -> str:
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"from {plain(value.declared, 4)} to {round_to_sigma(value.value, value.saved_sigma)}{unit}"
