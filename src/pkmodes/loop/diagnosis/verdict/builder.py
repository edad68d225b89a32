"""Assemble the result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.predicted import spectrum_of
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.posterior.probabilities import probabilities
from pkmodes.loop.diagnosis.problem import Array, reached_bounds
from pkmodes.loop.diagnosis.readings.amplitude import dependence_in_words, note, notes_on_amplitude
from pkmodes.loop.diagnosis.readings.table import declared_otherwise, reading_remarks
from pkmodes.loop.diagnosis.search.ranges import plausible_sizes
from pkmodes.loop.diagnosis.verdict import caveats, held_out, limits
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.claim import fitted_values, name_of_last_cause
from pkmodes.loop.diagnosis.verdict.detectable import examined
from pkmodes.loop.diagnosis.verdict.evidence import Decision, Evidence, Says, Start
from pkmodes.loop.diagnosis.verdict.explanations import NamedFits
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined, Finding, Refitted
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
    - corrected: values of the last model
    - notes: on its fit
    - without: its spectrum without its causes, (S, m)
    - limits: of the candidates that are not claimed
    """

    last: Fit | None
    outlying: NDArray[np.bool_]
    limits: CandidateLimits
    declared: tuple[MatchStage, Error]
    refit: tuple[MatchStage, Error] | None
    after: tuple[MatchStage, Error] | None
    corrected: tuple[Corrected, ...]
    shape_scatter: float | None
    notes: tuple[str, ...]
    without: Array | None


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
        return replace(
            self._result(decision, models),
            undetectable=unseen,
            notes=(*remarks, *models.notes),
            stability=unchanged(verdict),
        )

    def after_search(self, evidence: Evidence, decision: Decision[Evidence, Says]) -> Diagnosis:
        """Return the result of a search and its verdict."""
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        verdict, final = decision.verdict, claim.final
        findings = claim.findings(self.fitter, evidence.single_joints) if verdict is EFFECT_FOUND else ()
        remaining = claim.remains(decision.says.instead) if verdict is AMBIGUOUS else []
        bounded, plausible, tested = self._candidates(evidence, decision, findings, remaining)
        unseen = tuple(test.name for test in tested if not test.detectable)
        refit = final if verdict is ADEQUATE else outcome.nuisances
        causes = final if verdict is EFFECT_FOUND else None
        models = self._models(search.store, refit, causes, bounded, verdict.settled)
        # Another reading of the data contradicts all explanations of it as it stands.
        probable, accepted = None, verdict is not UNEXPLAINED
        if not decision.says.of_reading:
            probable = probabilities(search, plausible, outcome, accepted=accepted)
        undecided = remaining
        if verdict is EFFECT_FOUND:
            # The class of the first cause that the data cannot tell from others.
            claimed_class = next((fits for fits in claim.own if len(fits) > 1), claim.own[0])
            undecided = [[(name_of_last_cause(fit), fit) for fit in claimed_class]]
        proposed, not_separated = next_measurement(search.store, probable, undecided)
        if verdict.settled:
            needed = verdict is ADEQUATE and evidence.refit_needed
            decision = replace(
                decision,
                caveats=caveats.Caveats(
                    refitted=caveats.refitted(models.corrected) if needed else "",
                    conspicuous=caveats.conspicuous(models.corrected, needed=needed),
                    unseen=caveats.unseen(unseen, bool(bounded.limited)) if verdict is ADEQUATE else "",
                ),
            )
        return replace(
            self._result(decision, models),
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining),
            undetectable=unseen,
            next_measurement=proposed,
            not_separated=not_separated,
            candidates=tested,
            alone=evidence.single_joints if findings or remaining else {},
            notes=tuple(self._notes(evidence, decision, models)),
            stability=tuple(trial.entry for trial in evidence.trials),
            probabilities=probable,
        )

    def _candidates(
        self,
        evidence: Evidence,
        decision: Decision[Evidence, Says],
        findings: Sequence[Finding],
        remaining: Sequence[NamedFits],
    ) -> tuple[CandidateLimits, dict[int, float], tuple[Examined, ...]]:
        """Return the limits of the candidates that are not claimed, all plausible sizes, and all tests.

        - findings, remaining: the claimed causes, and the explanations that remain
        """
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        # Beside a claimed cause, the other members of its class are not detectable; they are listed with it.
        claimed = {name for finding in findings for name in finding.members}
        unclaimed = [candidate for candidate in search.candidates if candidate.name not in claimed]
        if decision.verdict.settled:
            bounded = limits.beside(search.store, [claim.final], unclaimed, noise=True)
            last = claim.last.scores
        else:
            open_fits = [fit for named in remaining for _, fit in named] or [outcome.nuisances]
            bounded = limits.beside(search.store, open_fits, unclaimed, noise=False)
            last = outcome.first.scores
        shown = claimed | {cause.name for named in remaining for _, fit in named for cause in fit.causes}
        shown |= {*decision.says.named, *(name for trial in evidence.trials for name in trial.entry.effects)}
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
        return bounded, plausible, tested

    def _notes(
        self, evidence: Evidence, decision: Decision[Evidence, Says], models: _Models
    ) -> Iterator[str]:
        """Yield the notes on the result of a search: on the data, on the fit, and on what the result leaves out."""
        verdict, of_reading, reason = decision.verdict, decision.says.of_reading, decision.says.text
        if of_reading:
            yield reason
        trend, data = evidence.amplitude, self.fitter.data
        if trend is not None and trend.significant and dependence_in_words(trend, data) not in reason:
            yield note(trend, data)
        yield from self._remarked(evidence.final)
        if verdict.settled:
            yield from evidence.held_out.notes
        if verdict is UNEXPLAINED and not of_reading:
            yield from low_modes(models.declared[0])
        yield from models.notes
        yield from evidence.claim.left_out
        assert models.refit is not None
        stage, _ = models.after or models.refit
        yield from held_out.held_out_remarks(
            self.setups.data,
            self.setups.is_held,
            stage.predicted.frequency,
            models.refit[1],
            None if models.after is None else models.after[1],
        )

    def _remarked(self, fit: Fit) -> tuple[str, ...]:
        return reading_remarks(self.setups.stage(fit.values), self.fitter.criteria.readings)

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

        declared, without = setups.stage(self.fitter.declared), None
        if causes is not None:
            index = [i for cause in causes.causes for i in self.fitter.indices(cause)]
            values = causes.values.copy()
            values[index] = self.fitter.declared[index]
            without = spectrum_of(setups.stage(values).prediction, setups.data)
        return _Models(
            last=last,
            outlying=outlying,
            limits=bounded,
            declared=(declared, setups.declared_error(declared, outlying)),
            refit=beside(refit),
            after=beside(causes),
            corrected=() if last is None else self.corrected(last, bounded),
            shape_scatter=None if last is None else store.shape_scatter(last),
            notes=() if last is None else tuple(notes(store, last, settled)),
            without=without,
        )

    def _result(self, decision: Decision[Any, Says], models: _Models) -> Diagnosis:
        """Return what every result has: the decision with its reason, the errors, and the values of the models."""
        last, (declared, before) = models.last, models.declared
        (refit, refit_error), (after, after_error) = models.refit or NONE, models.after or NONE
        nuisances = {self.fitter.parameters[i].name for i in self.fitter.nuisances}
        stages = Stages(
            declared.predicted,
            None if refit is None else refit.predicted,
            None if after is None else after.predicted,
            models.without,
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
            scatter=0.0 if last is None else last.scatter,
            corrected=models.corrected,
            correlation=() if last is None else tuple(map(tuple, last.correlation.tolist())),
            shape_scatter=models.shape_scatter,
            limits=models.limits.of,
            stages=stages,
        )

    def corrected(self, fit: Fit, bounded: CandidateLimits) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values, priors, and unseen influences."""
        width, corrected = self.fitter.priors.sigmas_in_units(fit.values), []
        plausible = plausible_sizes(self.fitter, fit, fit.causes)
        for i, v in zip(fit.free, fitted_values(self.fitter, fit, fit.free), strict=True):
            p, row = self.fitter.parameters[i], self.fitter.priors.row_of(i)
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
