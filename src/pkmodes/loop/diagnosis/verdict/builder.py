"""Assemble the result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.predicted import spectrum_of
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.loop.diagnosis.posterior.probabilities import probabilities
from pkmodes.loop.diagnosis.problem import Array, reached_bounds
from pkmodes.loop.diagnosis.readings.amplitude import dependence_in_words, note, notes_on_amplitude
from pkmodes.loop.diagnosis.readings.table import declared_otherwise, reading_remarks
from pkmodes.loop.diagnosis.search.ranges import plausible_sizes
from pkmodes.loop.diagnosis.verdict import caveats, held_out, limits, misfit
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.claim import fitted_values, name_of_last_cause
from pkmodes.loop.diagnosis.verdict.detectable import examined
from pkmodes.loop.diagnosis.verdict.evidence import Decision, Evidence, Says, Start
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    Examined,
    Finding,
    NextMeasurement,
    Refitted,
    Stability,
)
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.loop.diagnosis.verdict.limits import CandidateLimits
from pkmodes.loop.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.loop.diagnosis.verdict.notes import low_modes, notes
from pkmodes.loop.diagnosis.verdict.possible import usual_size
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, Stages
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.stability import unchanged
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, UNEXPLAINED

#: Stage and error of a model that a result does not have.
NONE: tuple[None, None] = (None, None)


@dataclass(frozen=True)
class _Models:
    """The models of a result beside all rows, with their errors: as declared, refitted, and with the causes.

    - last: of the last model; None if there are too few data to fit any
    - outlying: rows that it sets aside, (R,)
    - corrected: its values
    - notes: on its fit
    - without: its spectrum without its causes, (S, m)
    """

    last: Fit | None
    outlying: NDArray[np.bool_]
    declared: tuple[MatchStage, Error]
    refit: tuple[MatchStage, Error] | None
    after: tuple[MatchStage, Error] | None
    corrected: tuple[Corrected, ...]
    shape_scatter: float | None
    notes: tuple[str, ...]
    without: Array | None

    @property
    def stages(self) -> Stages:
        """Partners, differences and MAC of all rows with each model."""
        before, refit, after = (
            None if model is None else model[0].predicted for model in (self.declared, self.refit, self.after)
        )
        assert before is not None
        return Stages(before, refit, after, self.without)


@dataclass(frozen=True)
class _Searched:
    """The reason, and the parts of a result that only a search adds, see `Diagnosis`."""

    reason: str
    headline: str = ""
    effects: tuple[Finding, ...] = ()
    survivors: tuple[tuple[str, ...], ...] = ()
    next_measurement: NextMeasurement | None = None
    not_separated: str = ""
    candidates: tuple[Examined, ...] = ()
    probabilities: Probabilities | None = None
    single_joints: Mapping[str, JointAlone] = field(default_factory=dict)


class DiagnosisBuilder:
    """Assembles the result."""

    def __init__(self, setups: AllSetups) -> None:
        self.setups, self.fitter = setups, setups.fitter

    def before_search(self, start: Start, decision: Decision[Start, Says]) -> Diagnosis:
        """Return the result where data are too few, or obviously mistaken: nothing is searched for."""
        verdict, store = decision.verdict, start.plain
        unseen = tuple(candidate.name for candidate in start.suspected)
        bounded, fit = limits.unknown(store, start.suspected), None
        remarks: tuple[str, ...] = (decision.says.text,)
        if not decision.says.of_reading:
            fit, remarks = start.first, declared_otherwise(self.fitter)
            if fit is not None:
                remarks = (*remarks, *self._remarked(fit), *notes_on_amplitude(self.fitter, fit.values))
                bounded = limits.beside(store, [fit], start.suspected, noise=not start.contradicted)
            unseen = tuple(name for name in unseen if name not in {*bounded.limited, *start.hints})
        models = self._models(store, fit, None, bounded, verdict.settled)
        notes = (*remarks, *models.notes)
        searched = _Searched(decision.says.text)
        return self._result(decision, models, bounded, unseen, notes, unchanged(verdict), searched)

    def after_search(self, evidence: Evidence, decision: Decision[Evidence, Says]) -> Diagnosis:
        """Return the result of a search and its verdict."""
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        verdict, final = decision.verdict, claim.final
        findings = claim.findings(self.fitter, evidence.single_joints) if verdict is EFFECT_FOUND else ()
        remaining = claim.remains(decision.says.instead) if verdict is AMBIGUOUS else []
        undecided = remaining
        if verdict is EFFECT_FOUND:
            # The class of the first cause that the data cannot tell from others.
            claimed_class = next((fits for fits in claim.own if len(fits) > 1), claim.own[0])
            undecided = [[(name_of_last_cause(fit), fit) for fit in claimed_class]]
        # Beside a claimed cause, the other members of its class are not detectable; they are listed with it.
        claimed = {name for finding in findings for name in finding.members}
        unclaimed = [candidate for candidate in search.candidates if candidate.name not in claimed]
        if verdict.settled:
            bounded = limits.beside(search.store, [final], unclaimed, noise=True)
        else:
            open_fits = [fit for named in remaining for _, fit in named] or [outcome.nuisances]
            bounded = limits.beside(search.store, open_fits, unclaimed, noise=False)
        last = claim.last.scores if verdict.settled else outcome.first.scores
        shown = claimed | {cause.name for named in remaining for _, fit in named for cause in fit.causes}
        stability = tuple(trial.entry for trial in evidence.trials)
        shown |= {*decision.says.named, *(name for entry in stability for name in entry.effects)}
        apart = [candidate for candidate in search.candidates if candidate.name not in bounded.candidates]
        plausible = {**plausible_sizes(self.fitter, outcome.nuisances, apart), **bounded.plausible}
        tested = examined(
            self.fitter,
            outcome.first.scores,
            last,
            plausible,
            shown=shown,
            limited=bounded.limited,
            unbounded=bounded.unbounded - shown,
        )
        unseen = tuple(test.name for test in tested if not test.detectable)
        refit = final if verdict is ADEQUATE else outcome.nuisances
        causes = final if verdict is EFFECT_FOUND else None
        models = self._models(search.store, refit, causes, bounded, verdict.settled)
        # Another reading of the data contradicts all explanations of it as it stands.
        probable, accepted = None, verdict is not UNEXPLAINED
        if not decision.says.of_reading:
            probable = probabilities(search, plausible, outcome, accepted=accepted)
        proposed, not_separated = next_measurement(search.store, probable, undecided)
        reason, headline = self._with_caveats(evidence, decision, models.corrected, bounded, unseen)
        searched = _Searched(
            reason=reason,
            headline=headline,
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining),
            next_measurement=proposed,
            not_separated=not_separated,
            candidates=tested,
            probabilities=probable,
            single_joints=evidence.single_joints if findings or remaining else {},
        )
        remarks, contradictions = self._remarks(evidence, decision), self._contradictions(models)
        unexplained = verdict is UNEXPLAINED and not decision.says.of_reading
        low = low_modes(models.declared[0]) if unexplained else []
        notes = (*remarks, *low, *models.notes, *claim.left_out, *contradictions)
        return self._result(decision, models, bounded, unseen, notes, stability, searched)

    def _remarks(self, evidence: Evidence, decision: Decision[Evidence, Says]) -> tuple[str, ...]:
        """Return notes on the data: another reading that decided, mistakes found in all setups, held-out rows."""
        reading = (decision.says.text,) if decision.says.of_reading else ()
        trend, data = evidence.amplitude, self.fitter.data
        if (
            trend is not None
            and trend.significant
            and dependence_in_words(trend, data) not in decision.says.text
        ):
            reading = (*reading, note(trend, data))
        held_out = evidence.held_out.notes if decision.verdict.settled else ()
        return (*reading, *self._remarked(evidence.final), *held_out)

    def _remarked(self, fit: Fit) -> tuple[str, ...]:
        return reading_remarks(self.setups.stage(fit.values), self.fitter.criteria.readings)

    def _contradictions(self, models: _Models) -> tuple[str, ...]:
        """Return sentences about held-out rows that the result does not predict."""
        assert models.refit is not None
        stage, _ = models.after or models.refit
        return tuple(
            held_out.held_out_remarks(
                self.setups.data,
                self.setups.is_held,
                stage.predicted.frequency,
                models.refit[1],
                None if models.after is None else models.after[1],
            )
        )

    def _with_caveats(
        self,
        evidence: Evidence,
        decision: Decision[Evidence, Says],
        corrected: Sequence[Corrected],
        bounded: CandidateLimits,
        unseen: tuple[str, ...],
    ) -> tuple[str, str]:
        """Return the reason with the caveats of a settled verdict, and those that the headline has too."""
        reason = decision.says.text
        if not decision.verdict.settled:
            return reason, ""
        moved = [value for value in corrected if value.prior_sigma is not None]
        if decision.verdict is not ADEQUATE:
            headline = caveats.conspicuous(moved, needed=False)
            return "; ".join(part for part in (reason, headline) if part), headline
        needed = misfit.p_declared(evidence.store, evidence.final) <= evidence.claim.last.level
        headline = caveats.conspicuous(moved, needed=needed)
        parts = (
            f"{reason}: {caveats.refitted(moved)}" if needed else reason,
            headline if not needed else "",
            caveats.unseen(unseen, bool(bounded.limited)),
        )
        return "; ".join(part for part in parts if part), headline

    def _models(
        self, store: FitStore, refit: Fit | None, causes: Fit | None, bounded: CandidateLimits, settled: bool
    ) -> _Models:
        """Return the models of a result.

        - refit: of the nuisances
        - causes: with the claimed causes
        - bounded: of the candidates that are not claimed
        - settled: whether the last one leaves only noise
        """
        setups, last = self.setups, causes or refit
        excluded = [] if last is None else sorted(last.hypothesis.excluded)
        outlying = np.isin(setups.data.lines, self.fitter.data.lines[excluded])

        def beside(fit: Fit | None) -> tuple[MatchStage, Error] | None:
            if fit is None:
                return None
            stage = setups.stage(fit.values)
            return stage, setups.error(stage, *store.frequency_misfit(fit), outlying)

        declared = setups.stage(self.fitter.declared)
        return _Models(
            last=last,
            outlying=outlying,
            declared=(declared, setups.declared_error(declared, outlying)),
            refit=beside(refit),
            after=beside(causes),
            corrected=() if last is None else self.corrected(last, bounded),
            shape_scatter=None if last is None else store.shape_scatter(last),
            notes=() if last is None else tuple(notes(store, last, settled)),
            without=None if causes is None else self._without(causes),
        )

    def _without(self, fit: Fit) -> Array:
        """Return the spectrum of a model whose causes are as declared, and all other values as fitted, (S, m)."""
        values = fit.values.copy()
        for cause in fit.causes:
            index = list(self.fitter.indices(cause))
            values[index] = self.fitter.declared[index]
        return spectrum_of(self.setups.stage(values).prediction, self.setups.data)

    def _result(
        self,
        decision: Decision[Any, Says],
        models: _Models,
        bounded: CandidateLimits,
        unseen: tuple[str, ...],
        notes: tuple[str, ...],
        stability: tuple[Stability, ...],
        searched: _Searched,
    ) -> Diagnosis:
        """Return the result.

        - bounded: of the candidates that are not claimed
        - unseen: names of candidates that are not detectable
        """
        last, (declared, before) = models.last, models.declared
        (refit, refit_error), (after, after_error) = models.refit or NONE, models.after or NONE
        nuisances = {self.fitter.parameters[i].name for i in self.fitter.nuisances}
        return Diagnosis(
            verdict=decision.verdict.word,
            reason=searched.reason,
            headline=searched.headline,
            rule=decision.rule.name,
            effects=searched.effects,
            survivors=searched.survivors,
            refitted=tuple(Refitted.of(v) for v in models.corrected if v.name in nuisances),
            before=before,
            refit=refit_error,
            after=after_error,
            held_out_poses=self.setups.held_out_poses,
            undetectable=unseen,
            next_measurement=searched.next_measurement,
            not_separated=searched.not_separated,
            candidates=searched.candidates,
            alone=searched.single_joints,
            rows=self.setups.rows(declared, refit, after, models.outlying),
            scatter=0.0 if last is None else last.scatter,
            corrected=models.corrected,
            correlation=() if last is None else tuple(map(tuple, last.correlation.tolist())),
            notes=notes,
            stability=stability,
            shape_scatter=models.shape_scatter,
            limits=bounded.of,
            stages=models.stages,
            probabilities=searched.probabilities,
        )

    def corrected(self, fit: Fit, bounded: CandidateLimits) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values, priors, and unseen influences."""
        width, corrected = self.fitter.priors.width(fit.values), []
        plausible = plausible_sizes(self.fitter, fit, fit.causes)
        for i, v in zip(fit.free, fitted_values(self.fitter, fit, fit.free), strict=True):
            p, row = self.fitter.parameters[i], self.fitter.priors.of(i)
            corrected.append(
                Corrected(
                    name=v.name,
                    value=v.value,
                    sigma=v.sigma,
                    unit=v.unit,
                    declared=p.value,
                    prior_sigma=None if row is None else float(width[row]),
                    at_bound=any(bound != p.value for bound in reached_bounds(p, v.value, p.sigma or 0.0)),
                    unseen=bounded.unseen.get(i),
                    plausible=min(plausible.get(i, np.inf), usual_size(p)),
                )
            )
        return tuple(corrected)
