"""The second stage of a diagnosis: damping, at the final model of the frequencies and shapes.

Losses change neither frequencies nor shapes, so the first stage needs no damping, and the second one takes its model,
its values and its pairing as they are.  If the first stage does not settle, its modes may be the wrong ones, and
damping is not diagnosed.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.damping import words
from pkmodes.diagnosis.damping.combined import with_outcome, without_outcome
from pkmodes.diagnosis.damping.fit import LossFitter
from pkmodes.diagnosis.damping.judgement import DampingJudgement, judge_damping, names_of
from pkmodes.diagnosis.damping.rows import damping_rows, usable
from pkmodes.diagnosis.damping.stage import Stage
from pkmodes.diagnosis.problem import Array, Damped, Parameter, Structure
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.verdicts import AMBIGUOUS, EFFECT_FOUND, INSUFFICIENT_DATA, UNEXPLAINED
from pkmodes.measured.measurements import Measurements

#: Factors of the errors and of the priors, as for the frequencies.
CHANGES = {"sigma x 0.5": (0.5, 1.0), "sigma x 2": (2.0, 1.0), "priors x 2": (1.0, 2.0)}
#: Logarithm within which a common factor is a hundred.
HUNDRED, CLOSE = float(np.log(100.0)), 0.7


def with_damping(
    structure: Structure, data: Measurements, result: Diagnosis, criteria: Criteria | None
) -> Diagnosis:
    """Return a diagnosis of frequencies and shapes with what the damping adds to it."""
    c = criteria or Criteria()
    if not isinstance(structure, Damped) or not structure.losses or np.isnan(data.damping).all():
        return result
    if not result.settled or result.stages is None:
        return without_outcome(result, structure.losses)
    predicted = result.stages.after or result.stages.refit
    assert predicted is not None
    every = damping_rows(structure, data, predicted.mode, _states(structure, result), c)
    held = np.array([row.held_out for row in result.rows])[every.index]
    aside = np.array([row.outlier for row in result.rows])[every.index]
    good = usable(every)
    rows = every.some(good & ~held & ~aside)
    fitter = LossFitter(rows, tuple(structure.losses), c)
    notes = []
    if not good.all():
        notes.append(words.unresolved(data.lines[every.index[~good]].tolist()))
    median = float(np.median(rows.ratio[rows.above])) if rows.above.any() else 0.0
    if median > c.damping_most:
        mistake = words.per_cent(median)
        return without_outcome(result, structure.losses, (mistake, *notes))
    judged = judge_damping(fitter)
    trials = {
        change: judge_damping(fitter.with_errors(errors).with_priors(priors), roughly=True)
        for change, (errors, priors) in CHANGES.items()
    }
    judged, note = _of_undeclared(fitter, _stable(fitter, judged, trials))
    if judged.final.outlier is not None:
        i = int(rows.index[judged.final.outlier])
        notes.append(words.set_aside(int(data.lines[i]), data.labels[data.pose[i]], float(data.damping[i])))
    notes += [text for text in (note, _hundred(fitter, judged)) if text]
    return with_outcome(result, data, Stage(fitter, every, held & good, judged, trials, tuple(notes)))


def _states(structure: Structure, result: Diagnosis) -> list[Array]:
    """Return the values of the final model, and with each fitted value moved by its standard deviation."""
    index = {p.name: i for i, p in enumerate(structure.parameters)}
    final = np.array([p.value for p in structure.parameters])
    for value in result.corrected:
        final[index[value.name]] = value.value
    states = [final]
    for value in result.corrected:
        moved = final.copy()
        moved[index[value.name]] = _moved(structure.parameters[index[value.name]], value.value, value.sigma)
        states.append(moved)
    return [v for v in states if np.isfinite(structure.predict(v, ()).eigenvalues).all()]


def _moved(p: Parameter, value: float, sigma: float) -> float:
    """Return a value moved by a standard deviation within its bounds, to the side where it can move farther."""
    up, down = min(p.upper, value + sigma), max(p.lower, value - sigma)
    return up if up - value >= value - down else down


def _stable(
    fitter: LossFitter, judged: DampingJudgement, trials: dict[str, DampingJudgement]
) -> DampingJudgement:
    """Withdraw a claim that other errors or priors would change."""
    if judged.verdict is not EFFECT_FOUND:
        return judged
    members = [{j for fit in place for j in fit.causes} for place in judged.places]
    known = set().union(*members)
    for change, trial in trials.items():
        other = set(trial.final.causes)
        if trial.verdict is EFFECT_FOUND and not other <= known:
            what = f"with {change}, {names_of(fitter, trial.final)} would explain it better"
            again = fitter.fit(trial.final.causes)
            return replace(judged, verdict=AMBIGUOUS, rivals=(judged.final, again), why=what)
    return judged


def _of_undeclared(fitter: LossFitter, judged: DampingJudgement) -> tuple[DampingJudgement, str]:
    """Return the judgement of a model that declares no loss at all, and a note.

    Such a model says nothing about damping.  A ratio common to all modes, or ratios that scatter like those of
    repeated tests, contradict nothing and name no joint.
    """
    if any(loss.declared for loss in fitter.losses):
        return judged, ""
    common = next((j for j, loss in enumerate(fitter.losses) if not loss.effect), None)
    silent = replace(judged, verdict=INSUFFICIENT_DATA, final=judged.base, places=(), p_values=())
    if judged.verdict is EFFECT_FOUND and not any(fitter.losses[j].claimable for j in judged.final.causes):
        (cause,) = judged.final.causes
        return silent, words.common_ratio(*words.ratio_of(judged.final, cause))
    if judged.verdict is UNEXPLAINED and common is not None:
        fit = fitter.fit((common,))
        if fit.p_value > fitter.criteria.gate:  # it is not among the chosen candidates
            return silent, words.common_ratio(*words.ratio_of(fit, common))
        above = fitter.rows.above
        left = (fitter.measured - fitter.logarithms(fit.values))[above]
        variance = float(np.mean(left**2) - np.mean(fitter.rows.stated[above] ** 2))
        scatter = max(variance, 0.0) ** 0.5
        if scatter <= fitter.criteria.damping_scatter:
            return silent, words.scattered(float(fit.values[common]), float(np.exp(scatter)))
    return judged, ""


def _hundred(fitter: LossFitter, judged: DampingJudgement) -> str:
    """Return a note if measured ratios are about a hundred times those of the declared model, or a hundredth."""
    above = fitter.rows.above
    if not above.any() or not fitter.predicted(fitter.declared)[above].all():
        return ""
    away = float(np.median((fitter.measured - fitter.logarithms(fitter.declared))[above]))
    return words.factor_hundred(above=away > 0.0) if abs(abs(away) - HUNDRED) < CLOSE else ""
