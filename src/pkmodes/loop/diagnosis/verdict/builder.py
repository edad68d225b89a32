"""Assemble the result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.posterior.probabilities import probabilities
from pkmodes.loop.diagnosis.problem import Array, reached_bounds
from pkmodes.loop.diagnosis.readings.amplitude import (
    format_amplitude_note,
    format_level_dependence,
    notes_on_amplitude,
)
from pkmodes.loop.diagnosis.readings.table import answer_for_declared_model, reading_remarks
from pkmodes.loop.diagnosis.search.ranges import max_plausible_deviations
from pkmodes.loop.diagnosis.verdict import caveats, held_out, limits
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.claim import fitted_values, name_of_last_cause
from pkmodes.loop.diagnosis.verdict.detectable import examine_candidates
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Decision, Evidence, Start
from pkmodes.loop.diagnosis.verdict.explanations import NamedFits
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined, Finding, Refitted
from pkmodes.loop.diagnosis.verdict.limits import CandidateLimits
from pkmodes.loop.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.loop.diagnosis.verdict.notes import low_modes, motors_that_give_way, notes
from pkmodes.loop.diagnosis.verdict.possible import usual_size
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, Stages
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.stability import unchanged_entries
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, UNEXPLAINED

#: Stage and error of a model that a result does not have.
NO_STAGE: tuple[None, None] = (None, None)


@dataclass(frozen=True)
class _Models:
    """The models of a result for all rows, with their errors: as declared, refitted, and with the causes.

    - last_fit: fit of the last model; None if there are too few data to fit any
    - outlying: mask of the rows that this fit sets aside, (R,)
    - corrected: values of the last model
    - notes: notes on its fit
    - spectrum_without_causes: spectrum of the last model without its causes, (S, m)
    - limits: limits of the candidates that are not claimed
    """

    last_fit: Fit | None
    outlying: NDArray[np.bool_]
    limits: CandidateLimits
    declared: tuple[MatchStage, Error]
    refit: tuple[MatchStage, Error] | None
    after: tuple[MatchStage, Error] | None
    corrected: tuple[Corrected, ...]
    shape_scatter: float | None
    notes: tuple[str, ...]
    spectrum_without_causes: Array | None


class DiagnosisBuilder:
    """Assembles the result."""

    def __init__(self, setups: AllSetups) -> None:
        self.setups, self.fitter = setups, setups.fitter

    def before_search(self, start: Start, decision: Decision[Start, Answer]) -> Diagnosis:
        """Return the result where data are too few, or obviously mistaken: nothing is searched for."""
        verdict, store = decision.verdict, start.store
        undetectable = tuple(candidate.name for candidate in start.claimable)
        candidate_limits, fit = limits.unknown_limits(store, start.claimable), None
        remarks: tuple[str, ...] = (decision.answer.text,)
        if not decision.answer.decided_by_reading:
            fit, remarks = start.declared_fit, answer_for_declared_model(self.fitter)
            if fit is not None:
                remarks = (
                    *remarks,
                    *self._reading_remarks(fit),
                    *notes_on_amplitude(self.fitter, fit.values),
                )
                candidate_limits = limits.limits_beside(
                    store, [fit], start.claimable, residual_is_noise=not start.is_contradicted
                )
            undetectable = tuple(
                name for name in undetectable if name not in {*candidate_limits.limited, *start.hints}
            )
        models = self._models(store, fit, None, candidate_limits, verdict.settled)
        return replace(
            self._result(decision, models),
            undetectable=undetectable,
            notes=(*remarks, *models.notes),
            stability=unchanged_entries(verdict),
        )

    def after_search(self, evidence: Evidence, decision: Decision[Evidence, Answer]) -> Diagnosis:
        """Return the result of a search and its verdict."""
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        verdict, final = decision.verdict, claim.final
        findings = claim.findings(self.fitter, evidence.single_joints) if verdict is EFFECT_FOUND else ()
        remaining_explanations = (
            claim.remaining_explanations(decision.answer.better_explanation) if verdict is AMBIGUOUS else []
        )
        candidate_limits, max_deviations, examined_candidates = self._candidates(
            evidence, decision, findings, remaining_explanations
        )
        undetectable = tuple(test.name for test in examined_candidates if not test.detectable)
        refit = final if verdict is ADEQUATE else outcome.nuisance_fit
        causes = final if verdict is EFFECT_FOUND else None
        models = self._models(search.store, refit, causes, candidate_limits, verdict.settled)
        # Another reading of the data contradicts all explanations of it as it stands.
        explanation_probabilities, accepted = None, verdict is not UNEXPLAINED
        if not decision.answer.decided_by_reading:
            explanation_probabilities = probabilities(search, max_deviations, outcome, accepted=accepted)
        undecided = remaining_explanations
        if verdict is EFFECT_FOUND:
            # The class of the first cause that the data cannot tell from others.
            claimed_class = next(
                (fits for fits in claim.class_of_each_cause if len(fits) > 1), claim.class_of_each_cause[0]
            )
            undecided = [[(name_of_last_cause(fit), fit) for fit in claimed_class]]
        proposal, not_separated = next_measurement(search.store, explanation_probabilities, undecided)
        if verdict.settled:
            refit_was_needed = verdict is ADEQUATE and evidence.refit_needed
            decision = replace(
                decision,
                caveats=caveats.Caveats(
                    refitted=caveats.refitted_in_words(models.corrected) if refit_was_needed else "",
                    conspicuous=caveats.conspicuous_in_words(
                        models.corrected, refit_was_needed=refit_was_needed
                    ),
                    unseen=caveats.undetectable_in_words(undetectable, bool(candidate_limits.limited))
                    if verdict is ADEQUATE
                    else "",
                ),
            )
        return replace(
            self._result(decision, models),
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining_explanations),
            undetectable=undetectable,
            next_measurement=proposal,
            not_separated=not_separated,
            candidates=examined_candidates,
            alone=evidence.single_joints if findings or remaining_explanations else {},
            notes=tuple(self._notes(evidence, decision, models, findings)),
            stability=tuple(trial.stability for trial in evidence.trials),
            probabilities=explanation_probabilities,
        )

    def _candidates(
        self,
        evidence: Evidence,
        decision: Decision[Evidence, Answer],
        findings: Sequence[Finding],
        remaining_explanations: Sequence[NamedFits],
    ) -> tuple[CandidateLimits, dict[int, float], tuple[Examined, ...]]:
        """Return the limits of the candidates that are not claimed, all plausible sizes, and all tests.

        - findings, remaining_explanations: the claimed causes, and the explanations that remain
        """
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        # Beside a claimed cause, the other members of its class are not detectable; they are listed with it.
        claimed = {name for finding in findings for name in finding.members}
        unclaimed = [candidate for candidate in search.candidates if candidate.name not in claimed]
        if decision.verdict.settled:
            candidate_limits = limits.limits_beside(
                search.store, [claim.final], unclaimed, residual_is_noise=True
            )
            last_scores = claim.last_gate.scores
        else:
            open_fits = [fit for named in remaining_explanations for _, fit in named] or [
                outcome.nuisance_fit
            ]
            candidate_limits = limits.limits_beside(
                search.store, open_fits, unclaimed, residual_is_noise=False
            )
            last_scores = outcome.first_gate.scores
        named_candidates = claimed | {
            cause.name for named in remaining_explanations for _, fit in named for cause in fit.causes
        }
        named_candidates |= {
            *decision.answer.named,
            *(name for trial in evidence.trials for name in trial.stability.effects),
        }
        without_limits = [
            candidate for candidate in search.candidates if candidate.name not in candidate_limits.candidates
        ]
        max_deviations = {
            **max_plausible_deviations(self.fitter, outcome.nuisance_fit, without_limits),
            **candidate_limits.max_deviations,
        }
        examined_candidates = examine_candidates(
            self.fitter,
            outcome.first_gate.scores,
            last_scores,
            max_deviations,
            named=named_candidates,
            limited=candidate_limits.limited,
            unbounded=candidate_limits.unbounded - named_candidates,
        )
        return candidate_limits, max_deviations, examined_candidates

    def _notes(
        self,
        evidence: Evidence,
        decision: Decision[Evidence, Answer],
        models: _Models,
        findings: Sequence[Finding],
    ) -> Iterator[str]:
        """Yield the notes on the result of a search: on the data, on the fit, and on what the result leaves out."""
        verdict = decision.verdict
        decided_by_reading = decision.answer.decided_by_reading
        reason = decision.answer.text
        if decided_by_reading:
            yield reason
        trend, data = evidence.amplitude, self.fitter.data
        if trend is not None and trend.significant and format_level_dependence(trend, data) not in reason:
            yield format_amplitude_note(trend, data)
        yield from self._reading_remarks(evidence.final)
        if verdict.settled:
            yield from evidence.held_out.notes
        if verdict is UNEXPLAINED and not decided_by_reading:
            yield from low_modes(models.declared[0])
        if verdict is not ADEQUATE and not decided_by_reading:
            claimed = {name for finding in findings for name in finding.members}
            yield from motors_that_give_way(self.fitter, claimed)
        yield from models.notes
        yield from evidence.claim.left_out
        assert models.refit is not None
        stage, _ = models.after or models.refit
        yield from held_out.held_out_remarks(
            self.setups.data,
            self.setups.is_held_out,
            stage.predicted.frequency,
            models.refit[1],
            None if models.after is None else models.after[1],
        )

    def _reading_remarks(self, fit: Fit) -> tuple[str, ...]:
        return reading_remarks(self.setups.stage(fit.values), self.fitter.criteria.readings)

    def _models(
        self,
        store: FitStore,
        refit: Fit | None,
        causes: Fit | None,
        candidate_limits: CandidateLimits,
        is_settled: bool,
    ) -> _Models:
        """Return the models of a result.

        - refit: fit of the nuisances
        - causes: fit with the claimed causes
        - candidate_limits: limits of the candidates that are not claimed
        - is_settled: whether the last model leaves only noise
        """
        setups, last_fit = self.setups, causes or refit
        excluded_rows = [] if last_fit is None else sorted(last_fit.hypothesis.excluded_rows)
        outlying = np.isin(setups.data.lines, self.fitter.data.lines[excluded_rows])

        def stage_and_error(fit: Fit | None) -> tuple[MatchStage, Error] | None:
            if fit is None:
                return None
            stage = setups.stage(fit.values)
            return stage, setups.error(stage, *store.frequency_misfit(fit), outlying)

        declared = setups.stage(self.fitter.declared)
        return _Models(
            last_fit=last_fit,
            outlying=outlying,
            limits=candidate_limits,
            declared=(declared, setups.declared_error(declared, outlying)),
            refit=stage_and_error(refit),
            after=stage_and_error(causes),
            corrected=() if last_fit is None else self.corrected_values(last_fit, candidate_limits),
            shape_scatter=None if last_fit is None else store.shape_scatter(last_fit),
            notes=() if last_fit is None else tuple(notes(store, last_fit, is_settled)),
            spectrum_without_causes=None if causes is None else setups.spectrum_without_causes(causes),
        )

    def _result(self, decision: Decision[Any, Answer], models: _Models) -> Diagnosis:
        """Return what every result has: the decision with its reason, the errors, and the values of the models."""
        last_fit, (declared, before) = models.last_fit, models.declared
        (refit, refit_error), (after, after_error) = models.refit or NO_STAGE, models.after or NO_STAGE
        nuisances = {self.fitter.parameters[i].name for i in self.fitter.nuisance_indices}
        stages = Stages(
            declared.predicted,
            None if refit is None else refit.predicted,
            None if after is None else after.predicted,
            models.spectrum_without_causes,
        )
        return Diagnosis(
            verdict=decision.verdict.word,
            reason=decision.reason,
            headline=decision.caveats.conspicuous,
            rule=decision.rule.name,
            effects=(),
            survivors=(),
            refitted=tuple(Refitted.of(v) for v in models.corrected if v.name in nuisances),
            before=before,
            refit=refit_error,
            after=after_error,
            held_out_poses=self.setups.held_out_poses,
            undetectable=(),
            next_measurement=None,
            candidates=(),
            rows=self.setups.rows(declared, refit, after, models.outlying),
            scatter=0.0 if last_fit is None else last_fit.shared_error,
            corrected=models.corrected,
            correlation=() if last_fit is None else tuple(map(tuple, last_fit.correlation.tolist())),
            shape_scatter=models.shape_scatter,
            limits=models.limits.by_parameter,
            stages=stages,
        )

    def corrected_values(self, fit: Fit, candidate_limits: CandidateLimits) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values, priors, and unseen influences."""
        prior_widths, corrected = self.fitter.priors.sigmas_in_units(fit.values), []
        max_deviations = max_plausible_deviations(self.fitter, fit, fit.causes)
        for i, v in zip(fit.free, fitted_values(self.fitter, fit, fit.free), strict=True):
            p, row = self.fitter.parameters[i], self.fitter.priors.row_of(i)
            corrected.append(
                Corrected(
                    name=v.name,
                    value=v.value,
                    sigma=v.sigma,
                    unit=v.unit,
                    declared=p.value,
                    prior_sigma=None if row is None else float(prior_widths[row]),
                    at_bound=any(bound != p.value for bound in reached_bounds(p, v.value, p.sigma or 0.0)),
                    unseen=candidate_limits.unseen.get(i),
                    plausible=min(max_deviations.get(i, np.inf), usual_size(p)),
                )
            )
        return tuple(corrected)
