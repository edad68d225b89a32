"""Test whether a term, one form at one place, explains what the catalogue does not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from msgspec import structs

from pkmodes.core.base.numbers import number_or_none
from pkmodes.loop.diagnosis.beyond.competing_terms import (
    competing_term,
    has_many_alternatives,
    terms_may_compete,
)
from pkmodes.loop.diagnosis.beyond.evidence import TermEvidence, name_of_explanation
from pkmodes.loop.diagnosis.beyond.rules import BEYOND_RULES
from pkmodes.loop.diagnosis.beyond.term_fits import try_terms
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Extensible
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.verdict.builder import DiagnosisBuilder
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Decision, Evidence, first_decision
from pkmodes.loop.diagnosis.verdict.limits import NO_LIMITS
from pkmodes.loop.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.loop.diagnosis.verdict.notes import notes
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.terms import Beyond, TermClass
from pkmodes.loop.diagnosis.verdict.unexplained import best_explanation
from pkmodes.loop.diagnosis.verdict.verdicts import AMBIGUOUS, EFFECT_FOUND, FOUND, NOTHING, UNEXPLAINED


class TermSearch:
    """A search among terms, run when it is first needed.

    - structure: at all measured setups
    - held_out: held-out setups
    """

    def __init__(self, structure: Extensible, held_out: Sequence[int], progress: Progress | None) -> None:
        self.structure, self.held_out, self.progress = structure, held_out, progress
        self._cached_evidence: tuple[Evidence, TermEvidence | None] | None = None

    def evidence(self, catalogue: Evidence) -> TermEvidence | None:
        """Return the evidence for terms in addition to that for the catalogue; None if there are no terms."""
        if self._cached_evidence is None or self._cached_evidence[0] is not catalogue:
            term_fits = try_terms(self.structure.with_terms(), catalogue, self.held_out, self.progress)
            self._cached_evidence = catalogue, None if term_fits is None else TermEvidence(term_fits)
        return self._cached_evidence[1]

    def replacement_fit(self, catalogue: Evidence) -> Fit | None:
        """Return the fit with one term that explains the data in place of the causes of the catalogue."""
        alternatives_compete = has_many_alternatives(catalogue) or has_terms_of_joints(
            self.structure, catalogue
        )
        if not alternatives_compete and not terms_may_compete(
            self.structure.with_terms(), catalogue, self.held_out
        ):
            return None
        term_evidence = self.evidence(catalogue)
        return None if term_evidence is None else competing_term(term_evidence, catalogue)

    def evidence_after(
        self, catalogue: Evidence, decision: Decision[Evidence, Answer]
    ) -> TermEvidence | None:
        """Return the evidence for terms; None where the catalogue's verdict leaves nothing to try."""
        open_to_terms = (
            decision.verdict in (AMBIGUOUS, UNEXPLAINED) and not decision.answer.decided_by_reading
        )
        claimed = decision.verdict is EFFECT_FOUND
        if not open_to_terms and not (claimed and has_terms_of_joints(self.structure, catalogue)):
            return None
        return self.evidence(catalogue)


def has_terms_of_joints(structure: Extensible, catalogue: Evidence) -> bool:
    """Return whether a claimed cause has a value for each joint, and several terms are one of these values each."""
    causes = catalogue.final.causes
    if len(causes) != 1 or len(causes[0].parameters) < 2:
        return False
    joints = {term.parameters[0] for term in structure.with_terms().candidates if term.form}
    return len(joints.intersection(causes[0].parameters)) > 1


def with_term_result(result: Diagnosis, evidence: TermEvidence | None, catalogue: Evidence) -> Diagnosis:
    """Return a diagnosis by the catalogue, extended by the verdict on terms."""
    if evidence is None:
        return result
    decision = first_decision(BEYOND_RULES, evidence)
    assert decision is not None  # the last rule always applies
    status, count = decision.verdict, len(evidence.term_fits.terms)
    groups = [] if status is NOTHING else evidence.groups
    classes = _classes(evidence, groups)
    # The best explanation of the catalogue, claimed or not, with its errors; that of the reason where this names one.
    fits = [fit for fit in catalogue.store.all_fits() if fit.causes and not fit.hypothesis.remote]
    best = best_explanation(catalogue) if result.verdict == UNEXPLAINED.word else None
    best = best or min(fits, key=catalogue.store.criterion, default=None)
    catalogue_best = None if best is None else (name_of_explanation(best), error_of(catalogue, best))
    beyond = Beyond(status.word, decision.reason, count, classes, catalogue_best, decision.rule.name)
    if sum(map(len, groups)) > 1:
        remaining_classes = [[(name_of_explanation(fit), fit) for fit in group] for group in groups]
        proposed, not_separated = next_measurement(evidence.store, None, remaining_classes)
        result = replace(result, next_measurement=proposed, not_separated=not_separated)
    elif status is FOUND:
        # Notes on the fit without the term do not apply to the fit with it.
        term_notes = tuple(notes(evidence.store, evidence.final, adequate=True))
        result = replace(result, next_measurement=None, not_separated=status.nothing_next, notes=term_notes)
    result = replace(result, beyond=beyond)
    if beyond.found is None:
        return result
    if not result.effects:
        name = beyond.found.finding.name
        fit = next(fit for fit in groups[0] if name_of_explanation(fit) == name)
        return _with_term_stage(
            replace(result, reason=f"{beyond.words()}; without it, {result.reason}"), evidence, fit
        )
    return replace(result, reason=f"{beyond.words()}; {result.reason}")


def _with_term_stage(result: Diagnosis, evidence: TermEvidence, fit: Fit) -> Diagnosis:
    """Return a diagnosis whose last stage is the model with a term."""
    assert result.stages is not None
    predicted = evidence.setups.stage(fit.values).predicted
    rows = tuple(
        structs.replace(
            row,
            beyond=number_or_none(predicted.frequency[i]),
            mac=number_or_none(predicted.partner_mac[i]),
            nearest=number_or_none(predicted.nearest_frequency[i]),
            nearest_mac=number_or_none(predicted.nearest_mac[i]),
        )
        for i, row in enumerate(result.rows)
    )
    without_term = evidence.setups.spectrum_without_causes(fit)
    return replace(result, rows=rows, stages=replace(result.stages, beyond=predicted, without=without_term))


def _classes(evidence: TermEvidence, groups: Sequence[Sequence[Fit]]) -> tuple[TermClass, ...]:
    """Return classes as parts of a result, each with its probability relative to the others."""
    store, builder = evidence.store, DiagnosisBuilder(evidence.setups)
    criteria = [np.array([store.criterion(fit) for fit in group]) for group in groups]
    lowest_criterion = min((float(values.min()) for values in criteria), default=0.0)
    weights = np.array([np.exp(-0.5 * (values - lowest_criterion)).sum() for values in criteria])
    return tuple(
        TermClass(
            finding=evidence.finding(k),
            probability=float(weights[k] / weights.sum()),
            forms={name_of_explanation(fit): "".join(cause.form for cause in fit.causes) for fit in group},
            errors={name_of_explanation(fit): error_of(evidence, fit) for fit in group},
            corrected=builder.corrected_values(group[0], NO_LIMITS),
        )
        for k, group in enumerate(groups)
    )


def error_of(evidence: Evidence, fit: Fit) -> Error:
    """Return the errors with an explanation."""
    setups = evidence.setups
    lines = evidence.fitter.data.lines[sorted(fit.hypothesis.excluded_rows)]
    stage, outlying = setups.stage(fit.values), np.isin(setups.data.lines, lines)
    return setups.error(stage, *evidence.store.frequency_misfit(fit), outlying)
