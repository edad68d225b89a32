"""Evidence for the rules of a verdict, before and after a search; rules and their answers."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Assumption, Candidate
from pkmodes.loop.diagnosis.readings.amplitude import level_dependence
from pkmodes.loop.diagnosis.search.limits import ONE_SIDED_SIGMAS, value_shifts_by_default
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.verdict import misfit, reasons
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.caveats import Caveats
from pkmodes.loop.diagnosis.verdict.claim import Claim, claim_of, name_of_last_cause
from pkmodes.loop.diagnosis.verdict.findings import MIN_NOTICEABLE_RATIO
from pkmodes.loop.diagnosis.verdict.held_out import HeldOut, check_held_out
from pkmodes.loop.diagnosis.verdict.joint_alone import joint_alone
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.naming import number_in_words
from pkmodes.loop.diagnosis.verdict.stability import Trial, trials
from pkmodes.loop.diagnosis.verdict.values import shows_in_one_row_only
from pkmodes.loop.diagnosis.verdict.verdicts import Verdict
from pkmodes.loop.measured.amplitude import AmplitudeDependence

#: Largest number of causes named that would remove a contradiction where data are too few.
MAX_HINTS = 4


class Start:
    """The declared model compared with the fitted setups, before any search.

    - store: fits of the declared model
    - claimable: candidates that may be claimed
    """

    def __init__(self, setups: AllSetups) -> None:
        self.setups, self.fitter, self.criteria = setups, setups.fitter, setups.fitter.criteria
        self.store = FitStore(setups.fitter)
        self.claimable = [
            candidate for candidate in setups.fitter.structure.candidates if candidate.claimable
        ]

    def answer_with(self, text: str) -> Answer:
        """Return a reason as an answer."""
        return Answer(text)

    @cached_property
    def declared_fit(self) -> Fit | None:
        """The refit of the uncertain values; None if the model cannot be evaluated."""
        return self.store.fit(Hypothesis())

    @property
    def effective_parameters(self) -> float:
        r"""Number of uncertain values that the data determine, in parts: :math:`\operatorname{tr} J C J^T`.

        It is the effective number of parameters of a ridge regression: 1 for a value without a prior, 0 for one that
        its prior holds.
        """
        if self.declared_fit is None:
            return float(len(self.fitter.nuisance_indices))
        return float(self.declared_fit.leverage[: self.fitter.prior_slice.start].sum())

    @cached_property
    def is_contradicted(self) -> bool:
        """Whether the data contradict the model and its priors, however few they are."""
        return (
            self.declared_fit is not None
            and self.store.p_value(self.declared_fit) <= self.criteria.gate.surely
        )

    @cached_property
    def hints(self) -> list[str]:
        """Causes that would remove the contradiction, best first."""
        if not self.is_contradicted:
            return []
        sufficient = Search(self.store, self.claimable).additions.sufficient_causes()
        return [single.causes[0].name for single in sufficient[:MAX_HINTS]]


class Evidence:
    """The result of a search, and what else decides; costly results are computed when a rule first needs them.

    - claim: by default, the claim that follows from the outcome of the search
    - term_instead: returns the fit with one term that explains the data in place of this evidence's causes; None if
      none does

    Its attributes:
    - claim: what would be claimed, and its final fit
    """

    def __init__(
        self,
        setups: AllSetups,
        search: Search,
        outcome: Outcome,
        claim: Claim | None = None,
        term_instead: Callable[[Evidence], Fit | None] | None = None,
    ) -> None:
        self.setups, self.search, self.outcome = setups, search, outcome
        self._term_instead = term_instead
        self.store, self.fitter, self.criteria = search.store, search.store.fitter, search.criteria
        self.claim = claim or claim_of(search, outcome)
        self.final = self.claim.final

    def answer_with(self, text: str) -> Answer:
        """Return a reason as an answer, which names the causes that would be claimed."""
        return Answer.naming(text, self.final.causes)

    @property
    def explains(self) -> str:
        """The beginning of a clause: the causes would explain, or the declared model explains."""
        if not self.final.causes:
            return reasons.explains(())
        return f"{self.cause_names} would explain"

    @property
    def cause_names(self) -> str:
        """The names of the causes; of a single one, those of all that the data cannot tell from it."""
        members = self.members
        if len(members) < 2:
            return reasons.names(self.final.causes)
        max_named = self.criteria.claim.most_members
        named_members = members[:max_named] if len(members) <= max_named else members[: max_named - 1]
        unnamed_count = len(members) - len(named_members)
        if unnamed_count:
            others = f"{number_in_words(unnamed_count)} others"
            return f"{', '.join(named_members)} or {others}, which these data cannot tell apart,"
        return f"{', '.join(named_members[:-1])} or {named_members[-1]}, which these data cannot tell apart,"

    @property
    def members(self) -> list[str]:
        """The names of a single cause and of all that the data cannot tell from it; empty for several causes."""
        classes = self.claim.class_of_each_cause
        if len(self.final.causes) != 1 or not classes:
            return []
        own_name = name_of_last_cause(self.final)
        return [own_name, *(name for fit in classes[0] if (name := name_of_last_cause(fit)) != own_name)]

    @cached_property
    def trials(self) -> list[Trial]:
        """The explanations with other errors and priors."""
        return trials(self.search, self.final, self.claim.class_of_each_cause)

    @cached_property
    def held_out(self) -> HeldOut:
        """The test of the final fit by the held-out setups."""
        return check_held_out(self.setups, self.search, self.final)

    @cached_property
    def amplitude(self) -> AmplitudeDependence | None:
        """How the frequencies of the fitted setups depend on the level; None if none differ in their level alone."""
        return level_dependence(self.fitter, self.final.values)

    @cached_property
    def single_joints(self) -> dict[str, JointAlone]:
        """The one joint that explains the data as well, of each remaining cause with a value for each joint."""
        fits = {
            name_of_last_cause(fit): fit
            for groups in self.claim.classes_by_cause
            for fits in groups
            for fit in fits
        }
        by_name = {name: joint_alone(self.setups, self.search, fit) for name, fit in fits.items()}
        return {name: joint for name, joint in by_name.items() if joint is not None}

    @cached_property
    def p_declared(self) -> float:
        """The p-value of the frequencies of the model as declared, over the rows that the final fit used."""
        return misfit.p_declared(self.store, self.final)

    @property
    def refit_needed(self) -> bool:
        """Whether the residual of the model as declared is more than noise."""
        return self.p_declared <= self.outcome.last_gate.level

    @cached_property
    def term_instead(self) -> Fit | None:
        """The fit with one term, beyond the catalogue, that explains the data in place of the causes."""
        return None if self._term_instead is None else self._term_instead(self)

    @cached_property
    def defaults(self) -> list[Assumption]:
        """The defaults on which values of the causes depend noticeably."""
        shifts = value_shifts_by_default(self.store, self.final)
        indices = [i for cause in self.final.causes for i in self.fitter.parameter_indices(cause)]
        return [
            assumption
            for assumption, shift in shifts.items()
            if any(
                math.hypot(self.final.sigma_of(i), shift[i] / ONE_SIDED_SIGMAS)
                > MIN_NOTICEABLE_RATIO * self.final.sigma_of(i)
                for i in indices
            )
        ]

    @cached_property
    def errors_instead(self) -> str:
        """The measurement errors that explain the residual nearly as well as the causes; empty if none do.

        These are outliers and a shared error as found by the search, or frequency errors larger than stated by their
        most likely factor, with the outliers and the shared error of the final fit.
        """
        store, c, final = self.store, self.criteria, self.final
        max_criterion = store.criterion(final) + c.search.survives
        error_fits = [
            fit
            for fit in self.search.additions.with_errors_only(max_criterion)
            if store.p_value(fit) > c.gate.surely and not self._causes_show_only_in_these_rows(fit.hypothesis)
        ]
        best = min(error_fits, key=store.criterion, default=None)
        if best is not None and store.criterion(best) <= max_criterion:
            errors = reasons.errors_in_words(best, store.fitter.data.lines)
            fit_without_errors = store.fit(Hypothesis())
            pattern = (
                reasons.variation_with_pose(store.fitter, fit_without_errors)
                if fit_without_errors is not None and best.hypothesis.has_shared_error
                else ""
            )
            return f"{errors}; {pattern}" if pattern else errors
        hypothesis = final.hypothesis
        declared_fit = store.fit(
            Hypothesis(excluded_rows=hypothesis.excluded_rows, has_shared_error=hypothesis.has_shared_error)
        )
        if declared_fit is None:
            return ""
        rows = len(store.fitter.observations.log_frequencies)
        squares, count = store.frequency_misfit(declared_fit)[0], rows - len(hypothesis.excluded_rows)
        ratio = max(squares / count, 1.0)
        criterion_with_larger_errors = store.criterion(declared_fit) - squares + count * (1.0 + np.log(ratio))
        if criterion_with_larger_errors + np.log(rows) > max_criterion or ratio > c.claim.wrong_errors**2:
            return ""
        part = store.frequency_misfit(declared_fit)
        return f"errors {misfit.size_in_words(part, ' without the cause', stated='the stated ones')}"

    def _causes_show_only_in_these_rows(self, errors: Hypothesis) -> bool:
        """Return whether each row set aside is the only one in which a cause shows (`shows_in_one_row_only`)."""
        rows = errors.excluded_rows - self.final.hypothesis.excluded_rows
        return bool(rows) and all(
            any(shows_in_one_row_only(self.search, self.final, cause, row) for cause in self.final.causes)
            for row in rows
        )


@dataclass(frozen=True)
class Answer:
    """The answer of a rule that applies.

    - text: the reason of the verdict
    - named: candidates to which, according to it, the data point without a claim: these cannot be undetectable
    - better_explanation: an explanation that is better with other errors or priors
    - decided_by_reading: whether another reading of the data decided, because the file is wrong, or no linear
      model can explain it.  The text is then also the first note, and explanations of the data as they stand have no
      probabilities.
    """

    text: str
    named: frozenset[str] = frozenset()
    better_explanation: Fit | None = None
    decided_by_reading: bool = False

    @classmethod
    def naming(cls, text: str, causes: Iterable[Candidate], better_explanation: Fit | None = None) -> Answer:
        """Return an answer that names some candidates."""
        return cls(text, frozenset(cause.name for cause in causes), better_explanation)


A = TypeVar("A", bound=Answer)
A_co = TypeVar("A_co", bound=Answer, covariant=True)


class RuleEvidence(Protocol[A_co]):
    """The evidence to which rules are applied, with the type of their answers."""

    def answer_with(self, text: str) -> A_co:
        """Return a reason as an answer."""


T = TypeVar("T", bound=RuleEvidence[Any])


@dataclass(frozen=True)
class Rule(Generic[T, A]):
    """A rule of a verdict, applied before a search (T = Start), after it (T = Evidence), or to damping.

    - name: preceded by that of its table: "claims.found"
    - ask: returns the answer to its question; None or an empty text if it does not apply
    """

    name: str
    verdict: Verdict
    ask: Callable[[T], A | str | None]

    @property
    def applies_when(self) -> str:
        """When it applies."""
        return (self.ask.__doc__ or "").partition("\n")[0].removesuffix(".")

    def answer(self, evidence: T) -> A | None:
        """Return the answer; None if the rule does not apply."""
        answer = self.ask(evidence)
        if not isinstance(answer, str):
            return answer
        reply: A | None = evidence.answer_with(answer) if answer else None
        return reply


@dataclass(frozen=True)
class Decision(Generic[T, A]):
    """The rule that gave the verdict, its answer, and its caveats."""

    rule: Rule[T, A]
    answer: A
    caveats: Caveats = field(default_factory=Caveats)

    @property
    def verdict(self) -> Verdict:
        """The verdict."""
        return self.rule.verdict

    @property
    def reason(self) -> str:
        """The answer with the caveats."""
        return self.caveats.appended_to(self.answer.text)


def first_decision(rules: Sequence[Rule[T, A]], evidence: T) -> Decision[T, A] | None:
    """Return the decision of the first rule that applies; None if none does."""
    answers = ((rule, rule.answer(evidence)) for rule in rules)
    return next((Decision(rule, answer) for rule, answer in answers if answer is not None), None)
