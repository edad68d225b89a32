"""Rules for a residual that nothing explains: `OPEN`, a table (`rules`)."""

from __future__ import annotations

from collections.abc import Callable

from pkmodes.core.base.numbers import p_in_words, plain
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Misfit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.gate import Gate
from pkmodes.loop.diagnosis.verdict import misfit
from pkmodes.loop.diagnosis.verdict.evidence import Evidence, Rule, Says
from pkmodes.loop.diagnosis.verdict.reasons import larger, names, uneven
from pkmodes.loop.diagnosis.verdict.verdicts import UNEXPLAINED


def added_modes(e: Evidence) -> str:
    """The best causes leave noise, but add modes between the measured ones that were not measured."""
    last = e.outcome.last
    if not last.p_unmeasured <= last.level < min(last.p_value, last.p_candidates):
        return ""
    causes = e.final.causes
    verb = "add" if len(causes) > 1 else "adds"
    return f"{names(causes)} would explain the measured modes, but {verb} modes between them that were not measured"


def unmatched_modes(e: Evidence) -> Says | None:
    """Measured modes are unmatched, and no candidate adds one there."""
    count = e.outcome.last.unpaired
    if not count:
        return None
    which = "1 measured mode is" if count == 1 else f"{count} measured modes are"
    return _beside_best(e, f"{which} unmatched: the model has no mode there, and no candidate adds one")


def value_far_away(e: Evidence) -> Says | None:
    """Frequencies and shapes agree, but an uncertain value is more than three sigma from its declared value."""
    store, fit, first, c = e.store, e.outcome.nuisances, e.outcome.first, e.criteria
    if min(part.p_value for part in _misfits(store, fit)) <= c.gate.surely:
        return None
    name, away = misfit.far_away(store, fit, e.fitter.nuisances)
    if first.p_value > c.gate.level or away <= c.reasons.far:
        return None
    text = (
        f"the data agree with the model, but only with {name} {away:.1f} sigma from its declared value: that value "
        "or its sigma is wrong, or something outside the candidates has the same effect"
    )
    return _beside_best(e, text)


def shapes_differ(e: Evidence) -> Says | None:
    """The frequencies agree with the model, and nothing explains the shapes too."""
    frequencies, shapes = _misfits(e.store, e.outcome.nuisances)
    if (
        min(frequencies.p_value, shapes.p_value) > e.criteria.gate.surely
        or frequencies.p_value <= e.criteria.gate.level
    ):
        return None
    line = misfit.worst_shape(e.store, e.outcome.nuisances)
    text = (
        f"the frequencies agree with the model, but the shapes do not (chi2 per degree of freedom "
        f"{plain(shapes.ratio, 3)}, worst in line {line}), and no candidate or pair of candidates explains both"
    )
    return _beside_best(e, text)


def beyond_prior(e: Evidence) -> Says | None:
    """A single candidate would explain the data, but only with a value beyond its prior."""
    store, c = e.store, e.criteria
    explanations = []
    for fit in _without_errors(store):
        if len(fit.causes) != 1:
            continue
        index = e.fitter.indices(fit.causes[0])
        _, away = misfit.far_away(store, fit, index)
        explained = min(part.p_value for part in _misfits(store, fit))
        if away > c.reasons.far and explained > c.gate.level:
            explanations.append((store.criterion(fit), fit.causes[0].name, float(fit.values[index[0]]), away))
    if not explanations:
        return None
    _, name, value, away = min(explanations)
    text = (
        f"{name} = {plain(value, 4)} would explain the data, but this is {away:.1f} sigma outside the range declared "
        "plausible for it, and nothing else explains them"
    )
    return Says(text, frozenset({name}))


def nearly_all(e: Evidence) -> Says | None:
    """One cause, or two if the data clearly ask for a second, would explain nearly all of the residual."""
    store, (part, limit) = e.store, e.criteria.reasons.nearly_all
    before = _larger(store, e.outcome.nuisances)
    explanations = []
    for fit in _without_errors(store):
        if fit.at_bound:
            continue
        after = _larger(store, fit)
        if after > min(part * before, limit):
            continue
        gate = e.search.gate(fit)
        if not gate.passed and gate.p_unmeasured > e.criteria.gate.surely:
            explanations.append((fit, after))
    if not explanations:
        return None
    order = _priced(e)
    best, after = min(explanations, key=lambda entry: order(entry[0]))
    # Two causes are found in both orders, which fit alike up to rounding: name them in the order of the candidates.
    places = {candidate.name: k for k, candidate in enumerate(e.search.candidates)}
    causes = sorted(best.causes, key=lambda cause: places.get(cause.name, len(places)))
    verb = "explain" if len(causes) > 1 else "explains"
    gate, (why, pointed) = e.search.gate(best), left_by(e, best)
    but = f"this explanation is not claimed: {why}"
    if gate.p_value <= gate.level:
        but = (
            f"the rest exceeds the stated errors ({p_in_words(gate.p_value)}): it is {larger(after**0.5)} these, or "
            "something else is missing as well"
        )
    text = (
        f"{names(causes)} {verb} nearly all of the residual (chi2 per degree of freedom from {plain(before, 3)} to "
        f"{plain(after, 3)}), but {but}"
    )
    return Says.naming(text, [*causes, *pointed])


def no_direction(e: Evidence) -> Says | None:
    """The residual, scaled to the size of noise, points to no candidate: perhaps the stated errors are too small."""
    frequencies, _ = _misfits(e.store, e.outcome.nuisances)
    scale, (least, largest), c = frequencies.ratio, e.criteria.reasons.dispersed, e.criteria
    gains = (
        s.gain / scale / max(len(s.candidate.parameters), 1) for s in e.outcome.first.scores.by_candidate
    )
    if not (least < scale < largest and max(gains, default=0.0) < c.reasons.no_direction):
        return None
    best = _best_of_all(e)
    perhaps = "perhaps the stated sigma is too small"
    if len(e.fitter.observations.log_frequencies) < c.search.rows_to_set_aside:
        perhaps = "something outside the candidates, or stated errors that are too small"
    nowhere = "" if best is not None else " and points to no candidate"
    detail = uneven(e.fitter, e.outcome.nuisances) or perhaps
    return _beside_best(e, f"the residual is {larger(scale**0.5)} the stated errors{nowhere}: {detail}")


def small(e: Evidence) -> Says | None:
    """The residual is hardly more than noise, but points to a candidate."""
    first = e.outcome.first
    if first.p_value <= e.criteria.gate.level:
        return None
    pointed = _pointed(first)
    text = (
        f"the residual is small but points to a candidate, {pointed.name} ({p_in_words(first.p_candidates)}), and no "
        "candidate explains it well enough for a claim: measure more"
    )
    return _beside_best(e, text, pointed)


def real(e: Evidence) -> Says:
    """No candidate or pair of candidates reduces the residual to noise."""
    size, pattern = _larger(e.store, e.outcome.nuisances), uneven(e.fitter, e.outcome.nuisances)
    suffix = f"; {pattern}" if pattern else ""
    text = (
        f"the residual is real, {larger(size**0.5)} the stated errors, and no candidate or pair of candidates "
        f"reduces it to noise{suffix}"
    )
    return _beside_best(e, text)


#: Tried if nothing leaves noise.
OPEN: tuple[Rule[Evidence, Says], ...] = (
    Rule("open.added_modes", UNEXPLAINED, added_modes),
    Rule("open.unmatched", UNEXPLAINED, unmatched_modes),
    Rule("open.value_far_away", UNEXPLAINED, value_far_away),
    Rule("open.shapes_differ", UNEXPLAINED, shapes_differ),
    Rule("open.beyond_prior", UNEXPLAINED, beyond_prior),
    Rule("open.nearly_all", UNEXPLAINED, nearly_all),
    Rule("open.no_direction", UNEXPLAINED, no_direction),
    Rule("open.small", UNEXPLAINED, small),
    Rule("open.real", UNEXPLAINED, real),
)


def _beside_best(e: Evidence, text: str, *pointed: Candidate) -> Says:
    """Return a description of the residual, with the explanation that reduces it most and why that is not claimed."""
    best = _best_of_all(e)
    if best is None:
        return Says.naming(text, pointed)
    clause, named = best
    return Says.naming(f"{text}; {clause}", [*pointed, *named])


def _best_of_all(e: Evidence) -> tuple[str, list[Candidate]] | None:
    """Return which explanation reduces the residual most, why it is not claimed, and the candidates that this names.

    None if none reduces it clearly.  A second cause is named if the data clearly require it.
    """
    store = e.store
    better = store.criterion(e.outcome.nuisances) - e.criteria.search.survives
    improving = [fit for fit in _without_errors(store) if not fit.at_bound and store.criterion(fit) < better]
    best = min(improving, key=_priced(e), default=None)
    if best is None:
        return None
    why, pointed = left_by(e, best)
    if not why:
        return None
    sentences = " and ".join(
        f"{cause.sentence} ({cause.name})" if cause.sentence else cause.name for cause in best.causes
    )
    that = "that " if best.causes[0].sentence else ""
    return f"the best explanation, {that}{sentences}, is not claimed: {why}", [*best.causes, *pointed]


def left_by(e: Evidence, fit: Fit) -> tuple[str, list[Candidate]]:
    """Return why the gate refuses an explanation, empty if it does not, and the candidates to which this points."""
    gate = e.search.gate(fit)
    if gate.unpaired:
        return f"it leaves {gate.unpaired} measured mode{'' if gate.unpaired == 1 else 's'} unmatched", []
    if gate.p_value <= gate.level:
        factor = larger(_larger(e.store, fit) ** 0.5)
        return f"it leaves a residual {factor} the stated errors ({p_in_words(gate.p_value)})", []
    if gate.p_unmeasured <= gate.level:
        return "it adds modes between the measured ones that were not measured", []
    if gate.p_candidates <= gate.level:
        candidate = _pointed(gate)
        clause = (
            f"what it leaves still points to a candidate, {candidate.name} ({p_in_words(gate.p_candidates)})"
        )
        return clause, [candidate]
    return "", []


def _pointed(gate: Gate) -> Candidate:
    """Return the candidate to which a residual points most clearly."""
    return min(gate.scores.by_candidate, key=lambda entry: entry.p_value).candidate


def _without_errors(store: FitStore) -> list[Fit]:
    """Return the explanations tried without errors of the measurement and without remote causes."""
    fits = store.all_fits()
    return [fit for fit in fits if (h := fit.hypothesis).causes and not (h.remote or h.excluded or h.scatter)]


def _priced(e: Evidence) -> Callable[[Fit], float]:
    """Return the sort key of explanations: their criterion, penalising a second cause unless the data require it."""
    store, price = e.store, e.criteria.claim.told_apart
    return lambda fit: store.criterion(fit) + price * len(fit.causes)


def _larger(store: FitStore, fit: Fit) -> float:
    """Return the larger of chi2 per degree of freedom of the frequencies and of the shapes."""
    return max(part.ratio for part in _misfits(store, fit))


def _misfits(store: FitStore, fit: Fit) -> tuple[Misfit, Misfit]:
    """Return the misfit of the frequencies, without the priors, and of the shapes with stated errors."""
    return misfit.of_frequencies(store, fit), store.fitter.misfit(fit, SHAPE, stated=True)
