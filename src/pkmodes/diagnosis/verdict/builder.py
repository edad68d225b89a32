"""The result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.problem import reached_bounds
from pkmodes.diagnosis.search.ranges import plausible_sizes
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import caveats, held_out, limits, misfit
from pkmodes.diagnosis.verdict.all_setups import AllSetups
from pkmodes.diagnosis.verdict.detectable import examined
from pkmodes.diagnosis.verdict.findings import Corrected, Finding, Refitted, Stability, Value
from pkmodes.diagnosis.verdict.judgement import Judgement
from pkmodes.diagnosis.verdict.limits import Limits
from pkmodes.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.diagnosis.verdict.notes import notes
from pkmodes.diagnosis.verdict.possible import member
from pkmodes.diagnosis.verdict.result import Diagnosis, Stages
from pkmodes.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, Verdict


class DiagnosisBuilder:
    """Assembles the result."""

    def __init__(self, setups: AllSetups) -> None:
        self.setups, self.fitter = setups, setups.fitter

    def after_search(
        self,
        search: Search,
        outcome: Outcome,
        judged: Judgement,
        reason: str,
        pointed: Collection[str],
        remarks: Sequence[str],
        stability: tuple[Stability, ...],
    ) -> Diagnosis:
        """Return the result of a search and its judgement.

        Parameters
        ----------
        pointed : collection of str
            Candidates to which the reason says that the data point.
        """
        verdict, final, grouped = judged.verdict, judged.final, judged.grouped
        findings = self.findings(judged) if verdict is EFFECT_FOUND else ()
        remaining = remains(judged) if verdict is AMBIGUOUS else []
        contested = [named[0] for named in remaining] if len(remaining) != 1 else remaining[0]
        if verdict is EFFECT_FOUND:
            # The class of the first cause that the data cannot tell from others.
            own = [groups[0] for groups in grouped]
            contested = [(_name(fit), fit) for fit in next((fits for fits in own if len(fits) > 1), own[0])]
        # Beside a claimed cause, the other members of its class are not detectable; they are listed with it.
        claimed = {name for finding in findings for name in finding.members}
        unclaimed = [candidate for candidate in search.candidates if candidate.name not in claimed]
        if verdict.settled:
            bounded = limits.beside(search.store, [final], unclaimed, noise=True)
        else:
            open_fits = [fit for named in remaining for _, fit in named] or [outcome.nuisances]
            bounded = limits.beside(search.store, open_fits, unclaimed, noise=False)
        last = judged.last.scores if verdict.settled else outcome.first.scores
        shown = claimed | {cause.name for named in remaining for _, fit in named for cause in fit.causes}
        shown |= {*pointed, *(name for entry in stability for name in entry.effects)}
        apart = [candidate for candidate in search.candidates if candidate.name not in bounded.candidates]
        tested = examined(
            self.fitter,
            outcome.first.scores,
            last,
            {**plausible_sizes(self.fitter, outcome.nuisances, apart), **bounded.plausible},
            shown=shown,
            limited=bounded.limited,
            unbounded=bounded.unbounded - shown,
        )
        undetectable = tuple(one.name for one in tested if not one.detectable)
        diagnosis = self.without_search(
            verdict,
            reason,
            search.store,
            final if verdict is ADEQUATE else outcome.nuisances,
            undetectable,
            remarks,
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
            self.fitter.criteria.worse,
        )
        proposed, not_separated = next_measurement(self.fitter, contested)
        reason, headline = self._with_caveats(search.store, judged, diagnosis)
        return replace(
            diagnosis,
            reason=reason,
            headline=headline,
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining),
            next_measurement=proposed,
            not_separated=not_separated,
            candidates=tested,
            notes=(*diagnosis.notes, *judged.left_out, *contradictions),
        )

    def _with_caveats(self, store: FitStore, judged: Judgement, diagnosis: Diagnosis) -> tuple[str, str]:
        """Return the reason with what belongs beside a settled verdict, and what of this is in the headline."""
        if not judged.verdict.settled:
            return diagnosis.reason, ""
        values = [value for value in diagnosis.corrected if value.prior_sigma is not None]
        if judged.verdict is not ADEQUATE:
            headline = caveats.conspicuous(values, needed=False)
            return "; ".join(part for part in (diagnosis.reason, headline) if part), headline
        needed = misfit.p_declared(store, judged.final) <= judged.last.level
        headline = caveats.conspicuous(values, needed=needed)
        limited = any(limit.value is not None for limit in diagnosis.limits.values())
        parts = (
            f"{diagnosis.reason}: {caveats.refitted(values)}" if needed else diagnosis.reason,
            headline if not needed else "",
            caveats.unseen(diagnosis.undetectable, limited),
        )
        return "; ".join(part for part in parts if part), headline

    def without_search(
        self,
        verdict: Verdict,
        reason: str,
        store: FitStore,
        fit: Fit | None,
        undetectable: tuple[str, ...],
        remarks: Sequence[str],
        stability: tuple[Stability, ...],
        bounded: Limits,
        causes: Fit | None = None,
    ) -> Diagnosis:
        """Return the result without what a search adds: for too few data, or an obvious mistake in these.

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
            verdict=verdict.word,
            reason=reason,
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
            notes=(*remarks, *(() if last is None else notes(store, last, verdict.settled))),
            stability=stability,
            shape_scatter=None if last is None else store.shape_scatter(last),
            limits=bounded.of,
            stages=Stages(
                declared.predicted,
                None if refit is None else refit.predicted,
                None if after is None else after.predicted,
            ),
        )

    def findings(self, judged: Judgement) -> tuple[Finding, ...]:
        """Return all claimed causes with their classes."""
        return tuple(self._finding(judged, place, groups[0]) for place, groups in enumerate(judged.grouped))

    def _finding(self, judged: Judgement, place: int, members: list[Fit]) -> Finding:
        """Return one cause with its class."""
        cause = judged.final.causes[place]
        index = {_name(fit): self.fitter.indices(fit.causes[-1]) for fit in members}
        alternatives = {_name(fit): self.values(fit, index[_name(fit)]) for fit in members}
        covariances = {
            _name(fit): tuple(map(tuple, fit.covariance_of(index[_name(fit)]).tolist())) for fit in members
        }
        names = [cause.name, *(name for name in alternatives if name != cause.name)]
        return Finding(
            name=cause.name,
            members=tuple(names),
            parameters=alternatives[cause.name],
            alternatives={name: alternatives[name] for name in names},
            p_value=judged.p_values[place],
            sentence=cause.sentence,
            covariances={name: covariances[name] for name in names},
            about={_name(fit): member(self.fitter, fit, judged.plausible) for fit in members},
        )

    def values(self, fit: Fit, index: Sequence[int]) -> tuple[Value, ...]:
        """Return fitted parameters with their standard deviations."""
        values = []
        for i in index:
            p = self.fitter.parameters[i]
            values.append(Value(p.name, float(fit.values[i]), fit.sigma_of(i), p.unit))
        return tuple(values)

    def corrected(self, fit: Fit, bounded: Limits) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values, priors, and what was not seen."""
        width, corrected = self.fitter.priors.width(fit.values), []
        for i, v in zip(fit.free, self.values(fit, fit.free), strict=True):
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


def remains(judged: Judgement) -> list[list[tuple[str, Fit]]]:
    """Return the remaining explanations with their names: classes of one cause, or else pairs of causes."""
    if judged.instead is not None:
        return [[(_names(fit), fit)] for fit in (judged.final, judged.instead)]
    for groups in judged.grouped:
        if len(groups) > 1 or len(judged.final.causes) == 1:
            return [[(_name(fit), fit) for fit in fits] for fits in groups]
    pairs = (judged.final, *judged.others)
    return [[(_names(fit), fit)] for fit in pairs]


def _names(fit: Fit) -> str:
    return " + ".join(cause.name for cause in fit.causes)


def _name(fit: Fit) -> str:
    return fit.causes[-1].name
