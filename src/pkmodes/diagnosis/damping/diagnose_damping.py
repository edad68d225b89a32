"""The second stage of a diagnosis: damping, at the final model of the frequencies and shapes.

Losses change neither frequencies nor shapes, so the first stage needs no damping, and the second one takes its model,
its values and its pairing as they are.  If the first stage does not settle, its modes may be the wrong ones, and
damping is not diagnosed.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.damping import words
from pkmodes.diagnosis.damping.fit import LossFit, LossFitter
from pkmodes.diagnosis.damping.judgement import DampingJudgement, judge_damping, names_of, too_few
from pkmodes.diagnosis.damping.outcome import undiagnosed, with_outcome
from pkmodes.diagnosis.damping.rows import damping_rows, usable
from pkmodes.diagnosis.damping.stage import Stage
from pkmodes.diagnosis.problem import Array, Damped, Parameter, Structure
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)
from pkmodes.measured.measurements import Measurements

#: Factors of the errors and of the priors, as for the frequencies.
CHANGES = {"sigma x 0.5": (0.5, 1.0), "sigma x 2": (2.0, 1.0), "priors x 2": (1.0, 2.0)}
#: Verdicts without an explanation, which a scatter may give.
OPEN = UNEXPLAINED, INSUFFICIENT_DATA
#: Logarithm within which a common factor is a hundred.
HUNDRED, CLOSE = float(np.log(100.0)), 0.7


def with_damping(
    structure: Structure, data: Measurements, result: Diagnosis, criteria: Criteria | None
) -> Diagnosis:
    """Return a diagnosis of frequencies and shapes with what the damping says, beside its verdict."""
    c = criteria or Criteria()
    if np.isnan(data.damping).all():
        return result
    if not isinstance(structure, Damped) or not structure.losses:
        return replace(result, damping=undiagnosed((), words.NO_LOSSES))
    if not result.settled or result.stages is None:
        return replace(result, damping=undiagnosed(structure.losses, words.UNSETTLED))
    predicted = result.stages.after or result.stages.refit
    assert predicted is not None
    every = damping_rows(structure, data, predicted.mode, _states(structure, result), c)
    strange = predicted.mac[every.index] < c.shapes.strange_mac  # not where no shape was measured: NaN
    held = np.array([row.held_out for row in result.rows])[every.index]
    aside = np.array([row.outlier for row in result.rows])[every.index]
    known = usable(every)
    good = known & ~strange
    rows = every.some(good & ~held & ~aside)
    fitter = LossFitter(rows, tuple(structure.losses), c)
    notes = []
    if not known.all():
        notes.append(words.unresolved(data.lines[every.index[~known]].tolist()))
    if strange.any():
        notes.append(words.other_shape(data.lines[every.index[strange]].tolist(), c.shapes.strange_mac))
    median = float(np.median(rows.ratio[rows.above])) if rows.above.any() else 0.0
    if median > c.damping.most:
        return replace(result, damping=undiagnosed(structure.losses, words.per_cent(median), notes))
    judged = _of_repeated_tests(fitter, judge_damping(fitter))
    trials = {}
    for change, (errors, priors) in CHANGES.items():
        other = fitter.with_errors(errors).with_priors(priors)
        trials[change] = _of_repeated_tests(other, judge_damping(other, roughly=True))
    judged = _stable(fitter, judged, trials)
    if judged.final.outlier is not None:
        i = int(rows.index[judged.final.outlier])
        notes.append(words.set_aside(int(data.lines[i]), data.labels[data.pose[i]], float(data.damping[i])))
    notes += [text] if (text := _hundred(fitter, judged)) else []
    return with_outcome(
        result, data, Stage(fitter, every, held & good, strange, judged, trials, tuple(notes))
    )


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


def _of_repeated_tests(fitter: LossFitter, judged: DampingJudgement) -> DampingJudgement:
    """Return that nothing is missing where the ratios agree with the model as those of repeated tests do.

    Tests of one machine find ratios that scatter by more than each states, mode by mode.  A model that declares no
    loss says nothing about damping, so that a ratio common to all modes contradicts nothing either, and names no
    joint.  Nor does one that differs from the declared ratio by no more than repeated tests do.
    """
    if too_few(fitter):
        return judged
    enough = replace(judged, verdict=ADEQUATE, final=judged.base, places=(), rivals=(), p_values=())
    common = next((j for j, loss in enumerate(fitter.losses) if not loss.effect), None)
    if any(loss.declared for loss in fitter.losses):
        if judged.verdict is EFFECT_FOUND and (fit := _only_common(judged, common)) is not None:
            ratio, declared = words.ratio_of(fit, fit.causes[0]), float(fitter.declared[fit.causes[0]])
            if not declared or abs(math.log(ratio[0] / declared)) > fitter.criteria.damping.scatter:
                return judged
            return replace(
                enough, why=words.nearly_declared(*ratio, declared), scatter=_scatter(fitter, judged.base)
            )
        scatter = _scatter(fitter, judged.base)
        if judged.verdict not in OPEN or scatter > fitter.criteria.damping.scatter:
            return judged
        return replace(enough, why=words.scattered(None, scatter), scatter=scatter)
    if common is None or (judged.verdict is EFFECT_FOUND and judged.final.causes != (common,)):
        return judged
    fit = fitter.fit((common,))  # also where it is not among the chosen candidates
    value, scatter = words.ratio_of(fit, common), _scatter(fitter, fit)
    if judged.verdict is EFFECT_FOUND:
        return judged if fitter.losses[common].claimable else replace(enough, why=words.common_ratio(*value))
    if judged.verdict in OPEN and fit.p_value > fitter.criteria.gate.level:
        return replace(enough, why=words.common_ratio(*value))
    if judged.verdict in OPEN and scatter <= fitter.criteria.damping.scatter:
        return replace(enough, why=words.scattered(value[0], scatter), scatter=scatter)
    return judged


def _only_common(judged: DampingJudgement, common: int | None) -> LossFit | None:
    """Return the fit of the common ratio alone, if it is in the class of the only cause."""
    if len(judged.places) != 1 or common is None:
        return None
    return next((fit for fit in judged.places[0] if fit.causes == (common,)), None)


def _scatter(fitter: LossFitter, fit: LossFit) -> float:
    """Return how far ratios are from a fit beyond their stated errors: the standard deviation of the logarithm."""
    above = fitter.rows.above
    left = (fitter.measured - fitter.logarithms(fit.values))[above]
    beyond = float(np.mean(left**2)) - float(np.mean(fitter.rows.stated[above] ** 2))
    return math.sqrt(max(beyond, 0.0))


def _hundred(fitter: LossFitter, judged: DampingJudgement) -> str:
    """Return a note if measured ratios are about a hundred times those of the declared model, or a hundredth."""
    above = fitter.rows.above
    if not above.any() or not fitter.predicted(fitter.declared)[above].all():
        return ""
    away = float(np.median((fitter.measured - fitter.logarithms(fitter.declared))[above]))
    return words.factor_hundred(above=away > 0.0) if abs(abs(away) - HUNDRED) < CLOSE else ""
