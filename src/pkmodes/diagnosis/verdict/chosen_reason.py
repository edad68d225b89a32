"""The reason of a verdict, in one sentence."""

from __future__ import annotations

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.misfit import Misfit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import misfit, reasons
from pkmodes.diagnosis.verdict.builder import DiagnosisBuilder, remains
from pkmodes.diagnosis.verdict.judgement import Judgement
from pkmodes.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND


def reason_of(builder: DiagnosisBuilder, search: Search, outcome: Outcome, judged: Judgement) -> str:
    """Return why a verdict was given."""
    lines = search.store.fitter.data.lines
    noise = reasons.noise(judged.final, lines)
    if judged.verdict is ADEQUATE:
        return reasons.adequate(outcome.last, noise)
    if judged.verdict is EFFECT_FOUND:
        return reasons.effect_found(builder.findings(judged), outcome.first, noise)
    if judged.verdict is AMBIGUOUS:
        return reasons.ambiguous([[name for name, _ in named] for named in remains(judged)])
    return _unexplained(search, outcome, judged)


def _unexplained(search: Search, outcome: Outcome, judged: Judgement) -> str:
    """Return what the residual is, and in which part of the data."""
    store, fit, first, last = search.store, outcome.nuisances, outcome.first, outcome.last
    c, final = search.criteria, judged.final
    if last.p_unmeasured <= last.level < min(last.p_value, last.p_candidates):
        return reasons.added_modes(final.causes)
    if last.unpaired:
        return reasons.unpaired(last.unpaired)
    frequencies, shapes = _misfits(store, fit)
    if min(frequencies.p_value, shapes.p_value) > c.surely:
        name, away = misfit.far_away(store, fit, store.fitter.nuisances)
        if first.p_value <= c.gate and away > c.far:
            return reasons.declared_value(name, away)
    elif frequencies.p_value > c.gate:
        return reasons.shapes_left(shapes.ratio, misfit.worst_shape(store, fit))
    beyond = _beyond_prior(search)
    if beyond:
        return beyond
    nearly = _nearly(search, fit)
    if nearly:
        return nearly
    pattern = reasons.uneven(store.fitter, fit)
    if _dispersed(first, frequencies, c):
        few = len(store.fitter.log) < c.rows_to_set_aside
        return reasons.scattered(frequencies.ratio, pattern, few)
    if first.p_value > c.gate:
        return reasons.small(first.p_candidates)
    return reasons.real(frequencies.ratio, pattern)


def _beyond_prior(search: Search) -> str:
    """Return a reason if a single candidate would explain the data, but only with a value beyond its prior."""
    store, c = search.store, search.criteria
    explanations = []
    for fit in store.tried():
        h = fit.hypothesis
        if len(h.causes) != 1 or h.remote or h.excluded or h.scatter:
            continue
        index = store.fitter.indices(fit.causes[0])
        _, away = misfit.far_away(store, fit, index)
        explained = min(part.p_value for part in _misfits(store, fit))
        if away > c.far and explained > c.gate:
            explanations.append((store.criterion(fit), fit.causes[0].name, float(fit.values[index[0]]), away))
    return reasons.beyond_prior(*min(explanations)[1:]) if explanations else ""


def _nearly(search: Search, first: Fit) -> str:
    """Return a reason if one cause, or else two, would explain nearly all of the residual but not all.

    A second cause is named if the data clearly ask for it.
    """
    store, (part, most) = search.store, search.criteria.nearly_all
    before = _larger(store, first)
    explanations = []
    for fit in store.tried():
        h = fit.hypothesis
        if not h.causes or h.remote or h.excluded or h.scatter or fit.at_bound:
            continue
        after = _larger(store, fit)
        if after <= min(part * before, most) and search.gate(fit).p_unmeasured > search.criteria.surely:
            explanations.append((fit, after))
    if not explanations:
        return ""
    price = search.criteria.told_apart
    best, after = min(explanations, key=lambda one: store.criterion(one[0]) + price * len(one[0].causes))
    return reasons.nearly(best.causes, before, after, store.p_value(best))


def _larger(store: FitStore, fit: Fit) -> float:
    """Return the larger of chi2 per degree of freedom of the frequencies and of the shapes."""
    return max(part.ratio for part in _misfits(store, fit))


def _misfits(store: FitStore, fit: Fit) -> tuple[Misfit, Misfit]:
    """Return the misfit of the frequencies, without the priors, and of the shapes with stated errors."""
    return misfit.of_frequencies(store, fit), store.fitter.shape_misfit(fit, stated=True)


def _dispersed(gate: Gate, frequencies: Misfit, c: Criteria) -> bool:
    """Return whether the residual, scaled to unit chi2 per degree of freedom, has no direction: larger errors."""
    scale = frequencies.ratio
    most = max((s.gain / scale / max(len(s.candidate.parameters), 1) for s in gate.scores.each), default=0.0)
    return bool(c.dispersed[0] < scale < c.dispersed[1] and most < c.no_direction)
