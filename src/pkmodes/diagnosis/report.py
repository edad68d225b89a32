"""From fits to a result: verdict, causes with their classes, errors before and after, every row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis import reasons
from pkmodes.diagnosis.fitting import Fit, Fitter, Hypothesis
from pkmodes.diagnosis.gate import Gate
from pkmodes.diagnosis.judgement import Judgement, judge
from pkmodes.diagnosis.next_measurement import next_measurement
from pkmodes.diagnosis.pairing import Pairer, Pairing
from pkmodes.diagnosis.problem import Array, Structure
from pkmodes.diagnosis.result import Diagnosis, Error, Examined, Finding, Refitted, Row, Value, Verdict
from pkmodes.diagnosis.score import Scores
from pkmodes.diagnosis.search import Outcome, Search
from pkmodes.measured.measurements import Measurements

#: A change of this many standard deviations would probably have been seen among so many candidates.
SEEN = 5.0
#: A cause counts as undetectable if even a change of some frequency by this fraction would not have been seen.
NOTICEABLE = 0.1
#: Factor by which stated errors may be wrong; a larger residual is the model's.
LARGEST_FACTOR = 10.0


@dataclass(frozen=True)
class Stage:
    """A model at one stage: values of its parameters, predictions and partners of all rows."""

    values: Array
    frequencies: Array
    pairing: Pairing


class Report:
    """Turns fits into a result."""

    def __init__(
        self,
        structure: Structure,
        data: Measurements,
        fitter: Fitter,
        search: Search,
        fitted: list[int],
        held: list[int],
    ) -> None:
        self.structure, self.data, self.fitter, self.search = structure, data, fitter, search
        self.held = held
        self.is_held = np.isin(data.pose, held)
        self.lines = data.at(fitted).lines
        self.pairer = Pairer(data, structure.channels, structure.predict(fitter.declared, ()))

    def of(self, outcome: Outcome) -> Diagnosis:
        """Decide the verdict."""
        judged = judge(self.search, outcome)
        verdict, final, last, grouped = judged.verdict, judged.final, judged.last, judged.grouped
        found = verdict == "effect_found"
        reported = final if verdict in ("effect_found", "adequate") else outcome.nuisances
        nuisances = final if verdict == "adequate" else outcome.nuisances
        declared = self.stage(self.fitter.declared)
        refit, after = self.stage(nuisances.values), self.stage(final.values) if found else None
        findings = (
            tuple(
                self.finding(final, place, groups[0], judged.p_values[place])
                for place, groups in enumerate(grouped)
            )
            if found
            else ()
        )
        remaining = _remaining(judged) if verdict == "ambiguous" else []
        contested = (
            [(_name(fit), fit) for fit in grouped[0][0]] if found else [named[0] for named in remaining]
        )
        names = tuple(tuple(name for name, _ in named) for named in remaining)
        outlying = np.isin(self.data.lines, self.lines[sorted(reported.hypothesis.excluded)])
        return Diagnosis(
            verdict=verdict,
            reason=judged.doubt or self.reason(verdict, outcome, final, findings, names),
            effects=findings,
            survivors=names,
            refitted=self.refitted(reported),
            before=self.error(declared, self.chi2(self.fitter.declared), len(self.fitter.log), outlying),
            refit=self.error(refit, nuisances.chi2, self.search.degrees(nuisances), outlying),
            after=None
            if after is None
            else self.error(after, final.chi2, self.search.degrees(final), outlying),
            held_out_poses=tuple(self.data.labels[i] for i in self.held),
            undetectable=tuple(c.name for c in self.examined(last.scores) if not c.detectable),
            next_measurement=next_measurement(self.fitter, contested),
            candidates=self.examined(outcome.first.scores),
            rows=self.rows(declared, refit, after, outlying),
            scatter=reported.scatter,
            corrected=self.values(reported, reported.free),
        )

    def insufficient(self) -> Diagnosis:
        """Fewer measurements than unknowns."""
        declared = self.stage(self.fitter.declared)
        nothing = np.zeros(len(self.data.lines), dtype=bool)
        fit = self.fitter.fit(Hypothesis())  # the priors determine it, however few the data
        refit = None if fit is None else self.stage(fit.values)
        return Diagnosis(
            verdict="insufficient_data",
            reason=reasons.insufficient(
                len(self.fitter.log), [self.fitter.parameters[i].name for i in self.fitter.nuisances]
            ),
            effects=(),
            survivors=(),
            refitted=() if fit is None else self.refitted(fit),
            before=self.error(declared, self.chi2(self.fitter.declared), len(self.fitter.log), nothing),
            refit=None
            if fit is None or refit is None
            else self.error(refit, fit.chi2, self.search.degrees(fit), nothing),
            after=None,
            held_out_poses=tuple(self.data.labels[i] for i in self.held),
            undetectable=tuple(candidate.name for candidate in self.search.candidates),
            next_measurement=None,
            candidates=(),
            rows=self.rows(declared, refit, None, nothing),
            scatter=0.0,
            corrected=(),
        )

    def stage(self, values: Array) -> Stage:
        """Predictions for all rows, held-out ones included."""
        prediction = self.structure.predict(values, ())
        pairing = self.pairer.pair(prediction, np.ones(len(self.data.lines), dtype=bool))
        logs = prediction.log_frequencies[self.data.pose, np.maximum(pairing.partner, 0)]
        return Stage(values, np.where(pairing.partner >= 0, np.exp(logs), np.nan), pairing)

    def chi2(self, values: Array) -> float:
        """Sum of squares as it stands, without any fit."""
        return self.fitter.unfitted(values, np.ones(len(self.fitter.log), dtype=bool))[-1]

    def error(self, stage: Stage, chi2: float, degrees: int, outlying: NDArray[np.bool_]) -> Error:
        """Errors of a stage over the rows that have a partner and are no outliers."""
        relative = stage.frequencies / self.data.frequency - 1.0
        counted = np.isfinite(relative) & ~outlying

        def rms(rows: NDArray[np.bool_]) -> float | None:
            return float(np.sqrt(np.mean(relative[rows] ** 2))) if rows.any() else None

        return Error(rms(counted & ~self.is_held), rms(counted & self.is_held), chi2 / max(degrees, 1))

    def values(self, fit: Fit, index: Sequence[int]) -> tuple[Value, ...]:
        """Fitted parameters with their standard deviations."""
        found = []
        for i in index:
            p, k = self.fitter.parameters[i], fit.free.index(i)
            found.append(Value(p.name, float(fit.values[i]), float(np.sqrt(fit.covariance[k, k])), p.unit))
        return tuple(found)

    def refitted(self, fit: Fit) -> tuple[Refitted, ...]:
        """Nuisance parameters before and after."""
        before = {i: self.fitter.declared[i] for i in self.fitter.nuisances}
        return tuple(
            Refitted(v.name, float(before[i]), v.value, v.sigma, v.unit)
            for i, v in zip(self.fitter.nuisances, self.values(fit, self.fitter.nuisances), strict=True)
        )

    def finding(self, final: Fit, place: int, members: list[Fit], p_value: float) -> Finding:
        """One cause with its class."""
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
        """What each candidate's score says, and how large it would have to be."""
        found = []
        for one in scores.each:
            visible: tuple[Value, ...] = ()
            detectable = False
            if one.visible and np.isfinite(one.sigma).all():
                sizes = SEEN * one.sigma
                parameters = [self.fitter.parameters[i] for i in self.fitter.indices(one.candidate)]
                visible = tuple(
                    Value(p.name, float(size), float(size / SEEN), p.unit)
                    for p, size in zip(parameters, sizes, strict=True)
                )
                detectable = bool((sizes * one.largest <= NOTICEABLE).all())
            found.append(Examined(one.candidate.name, one.p_value, visible, detectable))
        return tuple(found)

    def rows(
        self, declared: Stage, refit: Stage | None, after: Stage | None, outlying: NDArray[np.bool_]
    ) -> tuple[Row, ...]:
        """Every measured mode with its predictions."""
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
            )
            for i in range(len(self.data.lines))
        )

    def reason(
        self,
        verdict: Verdict,
        outcome: Outcome,
        final: Fit,
        findings: tuple[Finding, ...],
        names: tuple[tuple[str, ...], ...],
    ) -> str:
        """One sentence."""
        noise = reasons.noise(final.hypothesis, final.scatter, self.lines)
        if verdict == "adequate":
            return reasons.adequate(outcome.last, noise)
        if verdict == "effect_found":
            return reasons.found(findings, outcome.first, noise)
        if verdict == "ambiguous":
            return reasons.ambiguous(names)
        degrees = self.search.degrees(outcome.nuisances)
        dispersed = _dispersed(outcome.first, outcome.nuisances, self.search)
        return reasons.unexplained(outcome.nuisances, final, degrees, outcome.first, outcome.last, dispersed)


def _remaining(judged: Judgement) -> list[list[tuple[str, Fit]]]:
    """Explanations that remain, with their names: classes in the place of one cause, or else pairs of causes."""
    for groups in judged.grouped:
        if len(groups) > 1:
            return [[(_name(fit), fit) for fit in fits] for fits in groups]
    pairs = (judged.final, *judged.others)
    return [[(" + ".join(cause.name for cause in fit.causes), fit)] for fit in pairs]


def _dispersed(gate: Gate, fit: Fit, search: Search) -> bool:
    """Whether what is left has no direction, once it is scaled to its own size: larger errors than stated."""
    scale = fit.chi2 / max(search.degrees(fit), 1)
    most = max((s.gain / scale / max(len(s.candidate.parameters), 1) for s in gate.scores.each), default=0.0)
    return bool(1.5 < scale < LARGEST_FACTOR**2 and most < 9.0)


def _name(fit: Fit) -> str:
    return fit.causes[-1].name
