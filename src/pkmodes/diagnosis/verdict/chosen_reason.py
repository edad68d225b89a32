"""The reason of a verdict, in one sentence, and the candidates to which it says that the data point."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.fit.hypothesis import Fit, Misfit
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.gate import Gate
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import misfit, reasons
from pkmodes.diagnosis.verdict.builder import DiagnosisBuilder, remains
from pkmodes.diagnosis.verdict.judgement import Judgement
from pkmodes.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND


@dataclass(frozen=True)
class Reason:
    """Why a verdict was given.

    Attributes
    ----------
    text : str
    named : frozenset of str
        Candidates to which it says that the data point, without a claim: what they show cannot be undetectable.
    """

    text: str = ""
    named: frozenset[str] = frozenset()

    @classmethod
    def naming(cls, text: str, causes: Iterable[Candidate]) -> Reason:
        """Return a reason that names some candidates."""
        return cls(text, frozenset(cause.name for cause in causes))


def reason_of(builder: DiagnosisBuilder, search: Search, outcome: Outcome, judged: Judgement) -> Reason:
    """Return why a verdict was given."""
    lines = search.store.fitter.data.lines
    noise = reasons.noise(judged.final, lines)
    if judged.doubt:
        return Reason.naming(judged.doubt, judged.final.causes)
    if judged.verdict is ADEQUATE:
        return Reason(reasons.adequate(outcome.last, noise, misfit.p_declared(search.store, judged.final)))
    if judged.verdict is EFFECT_FOUND:
        return Reason(reasons.effect_found(builder.findings(judged), outcome.first, noise))
    if judged.verdict is AMBIGUOUS:
        return Reason(reasons.ambiguous([[name for name, _ in named] for named in remains(judged)]))
    named = _named(search, outcome, judged)
    if named.text:
        return named
    best = _best_of_all(search, outcome)
    left = _left(search, outcome, explained=bool(best.text))
    return Reason(f"{left.text}; {best.text}", left.named | best.named) if best.text else left


def _named(search: Search, outcome: Outcome, judged: Judgement) -> Reason:
    """Return a reason that names an explanation which would nearly do; empty if none would."""
    last = outcome.last
    if last.p_unmeasured <= last.level < min(last.p_value, last.p_candidates):
        return Reason.naming(reasons.added_modes(judged.final.causes), judged.final.causes)
    if last.unpaired or _in_part(search, outcome):
        return Reason()
    beyond = _beyond_prior(search)
    return beyond if beyond.text else _nearly(search, outcome.nuisances)


def _in_part(search: Search, outcome: Outcome) -> str:
    """Return a reason if only one part of the data disagrees: an uncertain value, or the shapes."""
    store, fit, first, c = search.store, outcome.nuisances, outcome.first, search.criteria
    frequencies, shapes = _misfits(store, fit)
    if min(frequencies.p_value, shapes.p_value) > c.surely:
        name, away = misfit.far_away(store, fit, store.fitter.nuisances)
        if first.p_value <= c.gate and away > c.far:
            return reasons.declared_value(name, away)
    elif frequencies.p_value > c.gate:
        return reasons.shapes_left(shapes.ratio, misfit.worst_shape(store, fit))
    return ""


def _left(search: Search, outcome: Outcome, *, explained: bool) -> Reason:
    """Return what the residual is, and in which part of the data."""
    store, fit, first, last, c = search.store, outcome.nuisances, outcome.first, outcome.last, search.criteria
    if last.unpaired:
        return Reason(reasons.unpaired(last.unpaired))
    part = _in_part(search, outcome)
    if part:
        return Reason(part)
    frequencies, _ = _misfits(store, fit)
    pattern = reasons.uneven(store.fitter, fit)
    if _dispersed(first, frequencies, c):
        few = len(store.fitter.log) < c.rows_to_set_aside
        return Reason(reasons.scattered(frequencies.ratio, pattern, few=few, explained=explained))
    if first.p_value > c.gate:
        pointed = _pointed(first)
        return Reason.naming(reasons.small(pointed.name, first.p_candidates), [pointed])
    return Reason(reasons.real(frequencies.ratio, pattern))


def _best_of_all(search: Search, outcome: Outcome) -> Reason:
    """Return which explanation reduces the residual most, and why it is not claimed; empty if none does clearly.

    A second cause is named if the data clearly ask for it.
    """
    store, c = search.store, search.criteria
    better = store.criterion(outcome.nuisances) - c.survives
    some = [fit for fit in _plain(store) if not fit.at_bound and store.criterion(fit) < better]
    best = min(some, key=_priced(search), default=None)
    if best is None:
        return Reason()
    named, gate = list(best.causes), search.gate(best)
    if gate.unpaired:
        why = reasons.leaves_unmatched(gate.unpaired)
    elif gate.p_value <= gate.level:
        why = reasons.leaves(_larger(store, best), gate.p_value)
    elif gate.p_unmeasured <= gate.level:
        why = reasons.adds_modes()
    elif gate.p_candidates <= gate.level:
        named.append(_pointed(gate))
        why = reasons.leaves_direction(named[-1].name, gate.p_candidates)
    else:
        return Reason()
    return Reason.naming(reasons.best_of_all(best.causes, why), named)


def _pointed(gate: Gate) -> Candidate:
    """Return the candidate to which a residual points most clearly."""
    return min(gate.scores.each, key=lambda one: one.p_value).candidate


def _plain(store: FitStore) -> list[Fit]:
    """Return the explanations tried without errors of the measurement and without remote causes."""
    fits = store.tried()
    return [fit for fit in fits if (h := fit.hypothesis).causes and not (h.remote or h.excluded or h.scatter)]


def _priced(search: Search) -> Callable[[Fit], float]:
    """Return the order of explanations: by their criterion, a second cause only where the data ask for it."""
    store, price = search.store, search.criteria.told_apart
    return lambda fit: store.criterion(fit) + price * len(fit.causes)


def _beyond_prior(search: Search) -> Reason:
    """Return a reason if a single candidate would explain the data, but only with a value beyond its prior."""
    store, c = search.store, search.criteria
    explanations = []
    for fit in _plain(store):
        if len(fit.causes) != 1:
            continue
        index = store.fitter.indices(fit.causes[0])
        _, away = misfit.far_away(store, fit, index)
        explained = min(part.p_value for part in _misfits(store, fit))
        if away > c.far and explained > c.gate:
            explanations.append((store.criterion(fit), fit.causes[0].name, float(fit.values[index[0]]), away))
    if not explanations:
        return Reason()
    best = min(explanations)[1:]
    return Reason(reasons.beyond_prior(*best), frozenset({best[0]}))


def _nearly(search: Search, first: Fit) -> Reason:
    """Return a reason if one cause, or else two, would explain nearly all of the residual but not all.

    A second cause is named if the data clearly ask for it.
    """
    store, (part, most) = search.store, search.criteria.nearly_all
    before = _larger(store, first)
    explanations = []
    for fit in _plain(store):
        if fit.at_bound:
            continue
        after = _larger(store, fit)
        if after <= min(part * before, most) and search.gate(fit).p_unmeasured > search.criteria.surely:
            explanations.append((fit, after))
    if not explanations:
        return Reason()
    order = _priced(search)
    best, after = min(explanations, key=lambda one: order(one[0]))
    # Two causes were found in both orders, which fit alike but for rounding: name them as the candidates stand.
    places = {candidate.name: k for k, candidate in enumerate(search.candidates)}
    causes = sorted(best.causes, key=lambda cause: places.get(cause.name, len(places)))
    return Reason.naming(reasons.nearly(causes, before, after, store.p_value(best)), causes)


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
