"""The result from the fits: verdict, causes with their classes, errors before and after, all rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.diagnosis.match.predicted import Predicted
from pkmodes.diagnosis.problem import Array, Prediction, Structure
from pkmodes.diagnosis.search.score import Scores
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import held_out
from pkmodes.diagnosis.verdict.judgement import Judgement
from pkmodes.diagnosis.verdict.next_measurement import next_measurement
from pkmodes.diagnosis.verdict.notes import notes
from pkmodes.diagnosis.verdict.result import (
    Corrected,
    Diagnosis,
    Error,
    Examined,
    Finding,
    Refitted,
    Row,
    Stability,
    Stages,
    Value,
    Verdict,
)
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.quantities import FREQUENCY


@dataclass(frozen=True)
class Stage:
    """A model at one stage: parameter values, and predictions and partners of all rows."""

    values: Array
    frequencies: Array
    pairing: Pairing
    prediction: Prediction


class Report:
    """Assembles the result.

    Parameters
    ----------
    structure : Structure
        At all setups, including held-out ones.
    data : Measurements
    fitter : Fitter
        At the fitted setups.
    held : list of int
        Held-out setups.
    """

    def __init__(self, structure: Structure, data: Measurements, fitter: Fitter, held: list[int]) -> None:
        self.structure, self.data, self.fitter, self.held = structure, data, fitter, held
        self.is_held = np.isin(data.pose, held)
        self.pairer = Pairer(
            data, structure.channels, structure.predict(fitter.declared, ()), fitter.criteria
        )

    def of(
        self,
        search: Search,
        outcome: Outcome,
        judged: Judgement,
        reason: str,
        remarks: Sequence[str],
        stability: tuple[Stability, ...],
    ) -> Diagnosis:
        """Return the result of a search and its judgement."""
        verdict, final, last, grouped = judged.verdict, judged.final, judged.last, judged.grouped
        found = verdict == "effect_found"
        reported = final if verdict in ("effect_found", "adequate") else outcome.nuisances
        nuisances = final if verdict == "adequate" else outcome.nuisances
        declared = self.stage(self.fitter.declared)
        refit, after = self.stage(nuisances.values), self.stage(final.values) if found else None
        remaining = remains(judged) if verdict == "ambiguous" else []
        contested = (
            [(_name(fit), fit) for fit in grouped[0][0]] if found else [named[0] for named in remaining]
        )
        if len(remaining) == 1:
            contested = remaining[0]
        outlying = np.isin(self.data.lines, self.fitter.data.lines[sorted(reported.hypothesis.excluded)])
        store = search.store
        before = self.error(refit, *store.frequency_misfit(nuisances), outlying)
        with_causes = None if after is None else self.error(after, *store.frequency_misfit(final), outlying)
        predicted = (after or refit).frequencies
        findings = self.findings(judged) if found else ()
        claimed = {name for finding in findings for name in finding.members}
        return Diagnosis(
            verdict=verdict,
            reason=reason,
            effects=findings,
            survivors=tuple(tuple(name for name, _ in named) for named in remaining),
            refitted=self.refitted(reported),
            before=self.error(declared, self.chi2(self.fitter.declared), len(self.fitter.log), outlying),
            refit=before,
            after=with_causes,
            held_out_poses=tuple(self.data.labels[i] for i in self.held),
            # Beside a claimed cause, the other members of its class are not detectable; they are listed with it.
            undetectable=tuple(
                c.name for c in self.examined(last.scores) if not c.detectable and c.name not in claimed
            ),
            next_measurement=next_measurement(self.fitter, contested),
            candidates=self.examined(outcome.first.scores),
            rows=self.rows(declared, refit, after, outlying),
            scatter=reported.scatter,
            corrected=self.corrected(reported),
            notes=(
                *remarks,
                *notes(store, reported, verdict in ("adequate", "effect_found")),
                *held_out.remarks(
                    self.data, self.is_held, predicted, before, with_causes, self.fitter.criteria.worse
                ),
            ),
            stability=stability,
            shape_scatter=store.shape_scatter(reported),
            stages=self.stages(declared, refit, after),
        )

    def without_search(
        self,
        verdict: Verdict,
        reason: str,
        store: FitStore,
        fit: Fit | None,
        undetectable: tuple[str, ...],
        remarks: Sequence[str],
        stability: tuple[Stability, ...],
    ) -> Diagnosis:
        """Return the result without a search: too few data, or an obvious mistake in the measurements."""
        declared = self.stage(self.fitter.declared)
        nothing = np.zeros(len(self.data.lines), dtype=bool)
        refit = None if fit is None else self.stage(fit.values)
        return Diagnosis(
            verdict=verdict,
            reason=reason,
            effects=(),
            survivors=(),
            refitted=() if fit is None else self.refitted(fit),
            before=self.error(declared, self.chi2(self.fitter.declared), len(self.fitter.log), nothing),
            refit=None
            if fit is None or refit is None
            else self.error(refit, *store.frequency_misfit(fit), nothing),
            after=None,
            held_out_poses=tuple(self.data.labels[i] for i in self.held),
            undetectable=undetectable,
            next_measurement=None,
            candidates=(),
            rows=self.rows(declared, refit, None, nothing),
            scatter=0.0,
            corrected=() if fit is None else self.corrected(fit),
            notes=(*remarks, *(notes(store, fit, False) if fit is not None else ())),
            stability=stability,
            shape_scatter=None if fit is None else store.shape_scatter(fit),
            stages=self.stages(declared, refit, None),
        )

    def findings(self, judged: Judgement) -> tuple[Finding, ...]:
        """Return all claimed causes with their classes."""
        return tuple(
            self.finding(judged.final, place, groups[0], judged.p_values[place])
            for place, groups in enumerate(judged.grouped)
        )

    def stage(self, values: Array) -> Stage:
        """Return the predictions for all rows, including held-out ones."""
        prediction = self.structure.predict(values, ())
        pairing = self.pairer.pair(prediction, np.ones(len(self.data.lines), dtype=bool))
        logs = prediction.log_frequencies[self.data.pose, np.maximum(pairing.partner, 0)]
        return Stage(values, np.where(pairing.partner >= 0, np.exp(logs), np.nan), pairing, prediction)

    def sigma(self, stage: Stage) -> Array:
        """Return the relative standard deviations of the frequencies, (R,), including position errors."""
        data = self.data
        variance: Array = FREQUENCY.transformed_sigma(data) ** 2
        moved = self.structure.position_rates(stage.values) if data.point_sigma.any() else None
        if moved is not None:
            rates = moved.log_rates[data.pose, np.maximum(stage.pairing.partner, 0)]
            variance = variance + ((rates * data.point_sigma[data.pose]) ** 2).sum(axis=1)
        return np.sqrt(variance)

    def stages(self, before: Stage, refit: Stage | None, after: Stage | None) -> Stages:
        """Return the stages beside the measurements."""

        def beside(stage: Stage) -> Predicted:
            return Predicted.of(self.pairer, self.data, stage.prediction, stage.pairing, self.sigma(stage))

        return Stages(
            beside(before),
            None if refit is None else beside(refit),
            None if after is None else beside(after),
        )

    def chi2(self, values: Array) -> float:
        """Return the sum of squares without any fit."""
        return self.fitter.unfitted(values, np.ones(len(self.fitter.log), dtype=bool))[-1]

    def error(self, stage: Stage, chi2: float, degrees: float, outlying: NDArray[np.bool_]) -> Error:
        """Return the errors of a stage over the rows that have a partner and are not outliers."""
        relative = stage.frequencies / self.data.frequency - 1.0
        counted = np.isfinite(relative) & ~outlying

        def rms(rows: NDArray[np.bool_]) -> float | None:
            return float(np.sqrt(np.mean(relative[rows] ** 2))) if rows.any() else None

        return Error(rms(counted & ~self.is_held), rms(counted & self.is_held), chi2 / max(degrees, 1.0))

    def values(self, fit: Fit, index: Sequence[int]) -> tuple[Value, ...]:
        """Return fitted parameters with their standard deviations."""
        found = []
        for i in index:
            p, k = self.fitter.parameters[i], fit.free.index(i)
            found.append(Value(p.name, float(fit.values[i]), float(np.sqrt(fit.covariance[k, k])), p.unit))
        return tuple(found)

    def corrected(self, fit: Fit) -> tuple[Corrected, ...]:
        """Return all fitted parameters with their declared values and priors."""
        width, found = self.fitter.priors.width(fit.values), []
        for i, v in zip(fit.free, self.values(fit, fit.free), strict=True):
            p, row = self.fitter.parameters[i], self.fitter.priors.of(i)
            near = 1e-3 * max(abs(p.value), abs(v.value), p.sigma or 0.0)
            bounds = [bound for bound in (p.lower, p.upper) if np.isfinite(bound) and bound != p.value]
            found.append(
                Corrected(
                    name=v.name,
                    value=v.value,
                    sigma=v.sigma,
                    unit=v.unit,
                    declared=p.value,
                    prior_sigma=None if row is None else float(width[row]),
                    at_bound=any(abs(v.value - bound) <= near for bound in bounds),
                )
            )
        return tuple(found)

    def refitted(self, fit: Fit) -> tuple[Refitted, ...]:
        """Return the nuisance parameters before and after the fit."""
        before = {i: self.fitter.declared[i] for i in self.fitter.nuisances}
        return tuple(
            Refitted(v.name, float(before[i]), v.value, v.sigma, v.unit)
            for i, v in zip(self.fitter.nuisances, self.values(fit, self.fitter.nuisances), strict=True)
        )

    def finding(self, final: Fit, place: int, members: list[Fit], p_value: float) -> Finding:
        """Return one cause with its class."""
        cause = final.causes[place]
        alternatives = {_name(fit): self.values(fit, self.fitter.indices(fit.causes[-1])) for fit in members}
        names = [cause.name, *(name for name in alternatives if name != cause.name)]
        return Finding(
            name=cause.name,
            members=tuple(names),
            parameters=alternatives[cause.name],
            alternatives={name: alternatives[name] for name in names},
            p_value=p_value,
            sentence=cause.sentence,
        )

    def examined(self, scores: Scores) -> tuple[Examined, ...]:
        """Return each candidate's p-value, and its smallest detectable size."""
        found, criteria = [], self.fitter.criteria
        for one in scores.each:
            visible: tuple[Value, ...] = ()
            detectable = False
            if one.visible and np.isfinite(one.sigma).all():
                sizes = criteria.seen * one.sigma
                parameters = [self.fitter.parameters[i] for i in self.fitter.indices(one.candidate)]
                visible = tuple(
                    Value(p.name, float(size), float(size / criteria.seen), p.unit)
                    for p, size in zip(parameters, sizes, strict=True)
                )
                detectable = bool((sizes * one.largest <= criteria.noticeable).all())
            found.append(Examined(one.candidate.name, one.p_value, visible, detectable))
        return tuple(found)

    def rows(
        self, declared: Stage, refit: Stage | None, after: Stage | None, outlying: NDArray[np.bool_]
    ) -> tuple[Row, ...]:
        """Return every measured mode with its predictions."""
        last = after or refit or declared

        def value(stage: Stage | None, i: int) -> float | None:
            return None if stage is None or np.isnan(stage.frequencies[i]) else float(stage.frequencies[i])

        return tuple(
            Row(
                pose=self.data.labels[self.data.pose[i]],
                line=int(self.data.lines[i]),
                mode=self.data.mode[i],
                measured=float(self.data.frequency[i]),
                sigma=float(self.data.sigma[i]),
                before=value(declared, i),
                refit=value(refit, i),
                after=value(after, i),
                mac=None if np.isnan(last.pairing.mac[i]) else float(last.pairing.mac[i]),
                held_out=bool(self.is_held[i]),
                outlier=bool(outlying[i]),
                load=self.data.load(int(self.data.pose[i])),
            )
            for i in range(len(self.data.lines))
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
