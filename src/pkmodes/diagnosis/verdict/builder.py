"""The result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.posterior.probabilities import probabilities
from pkmodes.diagnosis.problem import reached_bounds
from pkmodes.diagnosis.readings.table import declared_otherwise, remarks
from pkmodes.diagnosis.search.ranges import plausible_sizes
from pkmodes.diagnosis.verdict import caveats, held_out, limits, misfit
from pkmodes.diagnosis.verdict.all_setups import AllSetups
from pkmodes.diagnosis.verdict.claim import name_of, values
from pkmodes.diagnosis.verdict.detectable import examined
from pkmodes.diagnosis.verdict.evidence import Decision, Evidence, Says, Start
from pkmodes.diagnosis.verdict.findings import Corrected, Refitted, Stability
from pkmodes.diagnosis.verdict.limits import Limits
from pkmodes.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.diagnosis.verdict.notes import notes
from pkmodes.diagnosis.verdict.result import Diagnosis, Stages
from pkmodes.diagnosis.verdict.stability import unchanged
from pkmodes.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND


class DiagnosisBuilder:
    """Assembles the result."""

    def __init__(self, setups: AllSetups) -> None:
        self.setups, self.fitter = setups, setups.fitter

    def before_search(self, start: Start, decision: Decision[Start, Says]) -> Diagnosis:
        """Return the result for too few data, or for an obvious mistake in these: nothing is searched for."""
        verdict, store = decision.verdict, start.plain
        if decision.says.of_reading:
            names = tuple(one.name for one in start.suspected)
            bounded = limits.unknown(store, start.suspected)
            said = (decision.says.text,)
            return self._result(decision, store, None, names, said, unchanged(verdict), bounded)
        fit = start.first
        about = (*declared_otherwise(self.fitter), *(() if fit is None else self._remarked(fit)))
        if fit is None:
            bounded = limits.unknown(store, start.suspected)
        else:
            bounded = limits.beside(store, [fit], start.suspected, noise=not start.contradicted)
        known = {*bounded.limited, *start.hints}
        unseen = tuple(one.name for one in start.suspected if one.name not in known)
        return self._result(decision, store, fit, unseen, about, unchanged(verdict), bounded)

    def after_search(self, evidence: Evidence, decision: Decision[Evidence, Says]) -> Diagnosis:
        """Return the result of a search and its verdict."""
        search, outcome, claim = evidence.search, evidence.outcome, evidence.claim
        verdict, final = decision.verdict, claim.final
        findings = claim.findings(self.fitter) if verdict is EFFECT_FOUND else ()
        remaining = claim.remains(decision.says.instead) if verdict is AMBIGUOUS else []
        contested = [named[0] for named in remaining] if len(remaining) != 1 else remaining[0]
        if verdict is EFFECT_FOUND:
            # The class of the first cause that the data cannot tell from others.
            own = next((fits for fits in claim.own if len(fits) > 1), claim.own[0])
            contested = [(name_of(fit), fit) for fit in own]
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
        undetectable = tuple(one.name for one in tested if not one.detectable)
        diagnosis = self._result(
            decision,
            search.store,
            final if verdict is ADEQUATE else outcome.nuisances,
            undetectable,
            self._remarks(evidence, decision),
            stability,
            bounded,
            causes=final if verdict is EFFECT_FOUND else None,
        )
        stages = diagnosis.stages
        assert stages is not None
        assert diagnosis.refit is not None
        contradictions = held_out.remarks(
            self.setups.data,
            self.setups.is_held,
            (stages.after or stages.refit or stages.before).frequency,
            diagnosis.refit,
            diagnosis.after,
            self.fitter.criteria.claim.worse,
        )
        proposed, not_separated = next_measurement(self.fitter, contested)
        reason, headline = self._with_caveats(evidence, decision, diagnosis)
        return replace(
            diagnosis,
            reason=reason,
            headline=headline,
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining),
            next_measurement=proposed,
            not_separated=not_separated,
            candidates=tested,
            notes=(*diagnosis.notes, *claim.left_out, *contradictions),
            # Another reading of the data contradicts all explanations of it as it stands.
            probabilities=None if decision.says.of_reading else probabilities(search, plausible, outcome),
        )

    def _remarks(self, evidence: Evidence, decision: Decision[Evidence, Says]) -> tuple[str, ...]:
        """Return notes on the data: another reading that decided, mistakes seen in all setups, held-out rows."""
        reading = (decision.says.text,) if decision.says.of_reading else ()
        held_out = evidence.held_out.notes if decision.verdict.settled else ()
        return (*reading, *self._remarked(evidence.final), *held_out)

    def _remarked(self, fit: Fit) -> tuple[str, ...]:
        return remarks(self.setups.stage(fit.values), self.fitter.criteria.readings)

    def _with_caveats(
        self, evidence: Evidence, decision: Decision[Evidence, Says], diagnosis: Diagnosis
    ) -> tuple[str, str]:
        """Return the reason with what belongs beside a settled verdict, and what of this is in the headline."""
        if not decision.verdict.settled:
            return diagnosis.reason, ""
        moved = [value for value in diagnosis.corrected if value.prior_sigma is not None]
        if decision.verdict is not ADEQUATE:
            headline = caveats.conspicuous(moved, needed=False)
            return "; ".join(part for part in (diagnosis.reason, headline) if part), headline
        needed = misfit.p_declared(evidence.store, evidence.final) <= evidence.claim.last.level
        headline = caveats.conspicuous(moved, needed=needed)
        limited = any(limit.value is not None for limit in diagnosis.limits.values())
        parts = (
            f"{diagnosis.reason}: {caveats.refitted(moved)}" if needed else diagnosis.reason,
            headline if not needed else "",
            caveats.unseen(diagnosis.undetectable, limited),
        )
        return "; ".join(part for part in parts if part), headline

    def _result(
        self,
        decision: Decision[Any, Says],
        store: FitStore,
        fit: Fit | None,
        undetectable: tuple[str, ...],
        remarks: Sequence[str],
        stability: tuple[Stability, ...],
        bounded: Limits,
        causes: Fit | None = None,
    ) -> Diagnosis:
        """Return the result without what a search adds.

        Parameters
        ----------
        fit : Fit or None
            Of the nuisances.
        undetectable : tuple of str
            Names of candidates.
        remarks : sequence of str
            Notes on the data.
        bounded : Limits
            Of the candidates that are not claimed.
        causes : Fit, optional
            With the claimed causes.
        """
        setups, fitter, last = self.setups, self.fitter, causes or fit
        excluded = [] if last is None else sorted(last.hypothesis.excluded)
        outlying = np.isin(setups.data.lines, fitter.data.lines[excluded])
        declared = setups.stage(fitter.declared)
        refit, after = (None if one is None else setups.stage(one.values) for one in (fit, causes))
        errors = [
            None
            if one is None or stage is None
            else setups.error(stage, *store.frequency_misfit(one), outlying)
            for one, stage in ((fit, refit), (causes, after))
        ]
        return Diagnosis(
            verdict=decision.verdict.word,
            reason=decision.says.text,
            effects=(),
            survivors=(),
            refitted=() if last is None else self.refitted(last, bounded),
            before=setups.declared_error(declared, outlying),
            refit=errors[0],
            after=errors[1],
            held_out_poses=setups.held_out_poses,
            undetectable=undetectable,
            next_measurement=None,
            candidates=(),
            rows=setups.rows(declared, refit, after, outlying),
            scatter=0.0 if last is None else last.scatter,
            corrected=() if last is None else self.corrected(last, bounded),
            correlation=() if last is None else tuple(map(tuple, last.correlation.tolist())),
            notes=(*remarks, *(() if last is None else notes(store, last, decision.verdict.settled))),
            stability=stability,
            shape_scatter=None if last is None else store.shape_scatter(last),
            limits=bounded.of,
            rule=decision.rule.name,
            stages=Stages(
                declared.predicted,
                None if refit is None else refit.predicted,
                None if after is None else after.predicted,
            ),
        )

    def corrected(self, fit: Fit, bounded: Limits) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values, priors, and what was not seen."""
        width, corrected = self.fitter.priors.width(fit.values), []
        for i, v in zip(fit.free, values(self.fitter, fit, fit.free), strict=True):
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
                )
            )
        return tuple(corrected)

    def refitted(self, fit: Fit, bounded: Limits) -> tuple[Refitted, ...]:
        """Return the nuisance parameters before and after the fit."""
        names = {self.fitter.parameters[i].name for i in self.fitter.nuisances}
        return tuple(
            Refitted(v.name, v.declared, v.value, v.sigma, v.saved_sigma, v.unit)
            for v in self.corrected(fit, bounded)
            if v.name in names
        )
