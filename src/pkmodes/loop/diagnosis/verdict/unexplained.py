"""Rules for a residual that nothing explains (the table UNEXPLAINED_RULES; `rules.py` uses it)."""

from __future__ import annotations

from collections.abc import Callable

from pkmodes.core.base.numbers import p_in_words, plain, three_digits
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Misfit
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.gate import Gate
from pkmodes.loop.diagnosis.verdict import misfit
from pkmodes.loop.diagnosis.verdict.evidence import Answer, Evidence, Rule
from pkmodes.loop.diagnosis.verdict.reasons import names, variation_with_pose, without_mode
from pkmodes.loop.diagnosis.verdict.verdicts import UNEXPLAINED


def added_modes(e: Evidence) -> str:
    """The best causes reduce the residual to noise, but add unmeasured modes between the measured ones."""
    gate = e.outcome.last_gate
    if not gate.p_unmeasured <= gate.level < min(gate.p_value, gate.p_candidates):
        return ""
    causes = e.final.causes
    verb = "add" if len(causes) > 1 else "adds"
    return f"{names(causes)} would explain the measured modes, but {verb} modes between them that were not measured"


def unmatched_modes(e: Evidence) -> Answer | None:
    """The model has no mode left for some measured ones, and no candidate adds one there."""
    count = e.outcome.last_gate.unpaired_count
    if not count:
        return None
    return _with_best_explanation(e, f"the model has {without_mode(count)}, and no candidate adds one")


def value_far_away(e: Evidence) -> Answer | None:
    """Frequencies and shapes agree, but an uncertain value is more than three sigma from its declared value."""
    store, nuisance_fit, gate, c = e.store, e.outcome.nuisance_fit, e.outcome.first_gate, e.criteria
    if min(part.p_value for part in _misfits(store, nuisance_fit)) <= c.gate.surely:
        return None
    name, sigmas = misfit.farthest_value(store, nuisance_fit, e.fitter.nuisance_indices)
    if gate.p_value > c.gate.level or sigmas <= c.reasons.far:
        return None
    text = (
        f"the data agree with the model, but only with {name} {sigmas:.1f} sigma from its declared value: that value "
        "or its sigma is wrong, or something outside the candidates has the same effect"
    )
    return _with_best_explanation(e, text)


def shapes_differ(e: Evidence) -> Answer | None:
    """The frequencies agree with the model, and nothing explains the shapes too."""
    frequencies, shapes = _misfits(e.store, e.outcome.nuisance_fit)
    if (
        min(frequencies.p_value, shapes.p_value) > e.criteria.gate.surely
        or frequencies.p_value <= e.criteria.gate.level
    ):
        return None
    line = misfit.worst_shape(e.store, e.outcome.nuisance_fit)
    text = (
        f"the frequencies agree with the model, but the shapes do not (their chi2 per degree of freedom is "
        f"{three_digits(shapes.ratio)}; worst in line {line}), and no candidate or pair of candidates explains both"
    )
    return _with_best_explanation(e, text)


def beyond_prior(e: Evidence) -> Answer | None:
    """A single candidate would explain the data, but only with a value beyond its prior."""
    store, c = e.store, e.criteria
    explanations = []
    for fit in _fits_without_errors(store):
        if len(fit.causes) != 1:
            continue
        index = e.fitter.parameter_indices(fit.causes[0])
        _, sigmas = misfit.farthest_value(store, fit, index)
        p_value = min(part.p_value for part in _misfits(store, fit))
        if sigmas > c.reasons.far and p_value > c.gate.level:
            explanations.append(
                (store.criterion(fit), fit.causes[0].name, float(fit.values[index[0]]), sigmas)
            )
    if not explanations:
        return None
    _, name, value, sigmas = min(explanations)
    text = (
        f"{name} = {plain(value, 4)} would explain the data, but this is {sigmas:.1f} sigma from its "
        "declared value, and nothing else explains them"
    )
    return Answer(text, frozenset({name}))


def nearly_all(e: Evidence) -> Answer | None:
    """One cause, or two if the data clearly ask for a second, would explain nearly all of the residual."""
    store, (max_part, max_ratio) = e.store, e.criteria.reasons.nearly_all
    ratio_before = _larger_ratio(store, e.outcome.nuisance_fit)
    explanations = []
    for fit in _fits_without_errors(store):
        if fit.at_bound:
            continue
        ratio_after = _larger_ratio(store, fit)
        if ratio_after > min(max_part * ratio_before, max_ratio):
            continue
        gate = e.search.gate(fit)
        if not gate.passed and gate.p_unmeasured > e.criteria.gate.surely:
            explanations.append(fit)
    if not explanations:
        return None
    (before, whose), sort_key = misfit.larger_misfit(store, e.outcome.nuisance_fit), _penalised_criterion(e)
    best = min(explanations, key=sort_key)
    # A pair of causes is fitted in either order, with the same result up to rounding: name them in the order of the
    # candidates.
    order_of_candidates = {candidate.name: k for k, candidate in enumerate(e.search.candidates)}
    causes = sorted(
        best.causes, key=lambda cause: order_of_candidates.get(cause.name, len(order_of_candidates))
    )
    verb = "explain" if len(causes) > 1 else "explains"
    after = _misfits(store, best)[1] if whose else store.frequency_misfit(best)
    gate, (refusal, indicated_candidates) = e.search.gate(best), reason_of_refusal(e, best)
    objection = f"this explanation is not claimed: {refusal}"
    if gate.p_value <= gate.level:
        objection = (
            f"the rest is {misfit.residual_in_words(store, best, gate.p_value)}: either these are too small, or "
            "something else is missing as well"
        )
    text = (
        f"{names(causes)} {verb} nearly all of the residual (chi2 per degree of freedom{whose} from "
        f"{three_digits(before.ratio)} to {three_digits(after.ratio)}), but {objection}"
    )
    return Answer.naming(text, [*causes, *indicated_candidates])


def points_to_no_candidate(e: Evidence) -> Answer | None:
    """The residual, scaled to the size of noise, points to no candidate: perhaps the stated errors are too small."""
    frequencies, _ = _misfits(e.store, e.outcome.nuisance_fit)
    chi2_per_dof, (min_ratio, max_ratio), c = frequencies.ratio, e.criteria.reasons.dispersed, e.criteria
    gains = (
        s.gain / chi2_per_dof / max(len(s.candidate.parameters), 1)
        for s in e.outcome.first_gate.scores.by_candidate
    )
    if not (min_ratio < chi2_per_dof < max_ratio and max(gains, default=0.0) < c.reasons.no_direction):
        return None
    best = _unclaimed_explanation(e)
    alternative = "perhaps the stated sigma is too small"
    if len(e.fitter.observations.log_frequencies) < c.search.rows_to_set_aside:
        alternative = "something outside the candidates, or stated errors that are too small"
    no_candidate_clause = "" if best is not None else " and points to no candidate"
    detail = variation_with_pose(e.fitter, e.outcome.nuisance_fit) or alternative
    return _with_best_explanation(
        e,
        f"the residual is {misfit.size_in_words(e.store.frequency_misfit(e.outcome.nuisance_fit))}"
        f"{no_candidate_clause}: {detail}",
    )


def small_residual(e: Evidence) -> Answer | None:
    """The residual is hardly more than noise, but points to a candidate."""
    gate = e.outcome.first_gate
    if gate.p_value <= e.criteria.gate.level:
        return None
    indicated_candidate = _indicated_candidate(gate)
    text = (
        f"the residual is small but points to a candidate, {indicated_candidate.name} "
        f"({p_in_words(gate.p_candidates)}), and no candidate explains it well enough for a claim: measure more"
    )
    return _with_best_explanation(e, text, indicated_candidate)


def real_residual(e: Evidence) -> Answer:
    """No candidate or pair of candidates reduces the residual to noise."""
    size = misfit.residual_in_words(e.store, e.outcome.nuisance_fit)
    pattern = variation_with_pose(e.fitter, e.outcome.nuisance_fit)
    suffix = f"; {pattern}" if pattern else ""
    text = f"the residual is significant: {size}, and no candidate or pair of candidates reduces it to noise{suffix}"
    return _with_best_explanation(e, text)


#: Tried in this order if no explanation reduces the residual to noise.
UNEXPLAINED_RULES: tuple[Rule[Evidence, Answer], ...] = (
    Rule("open.added_modes", UNEXPLAINED, added_modes),
    Rule("open.unmatched", UNEXPLAINED, unmatched_modes),
    Rule("open.value_far_away", UNEXPLAINED, value_far_away),
    Rule("open.shapes_differ", UNEXPLAINED, shapes_differ),
    Rule("open.beyond_prior", UNEXPLAINED, beyond_prior),
    Rule("open.nearly_all", UNEXPLAINED, nearly_all),
    Rule("open.no_direction", UNEXPLAINED, points_to_no_candidate),
    Rule("open.small", UNEXPLAINED, small_residual),
    Rule("open.real", UNEXPLAINED, real_residual),
)


def _with_best_explanation(e: Evidence, text: str, *indicated_candidates: Candidate) -> Answer:
    """Return a description of the residual, with the explanation that reduces it most and why that is not claimed."""
    best = _unclaimed_explanation(e)
    if best is None:
        return Answer.naming(text, indicated_candidates)
    clause, named = best
    return Answer.naming(f"{text}; {clause}", [*indicated_candidates, *named])


def _unclaimed_explanation(e: Evidence) -> tuple[str, list[Candidate]] | None:
    """Return which explanation reduces the residual most and why it is not claimed; and the candidates named in it.

    None if none reduces it clearly, or if the gate does not refuse the best one.
    """
    best = best_explanation(e)
    if best is None:
        return None
    refusal, indicated_candidates = reason_of_refusal(e, best)
    if not refusal:
        return None
    sentences = " and ".join(
        f"{cause.sentence} ({cause.name})" if cause.sentence else cause.name for cause in best.causes
    )
    conjunction = "that " if best.causes[0].sentence else ""
    clause = f"the best explanation, {conjunction}{sentences}, is not claimed: {refusal}"
    return clause, [*best.causes, *indicated_candidates]


def best_explanation(e: Evidence) -> Fit | None:
    """Return the fit whose causes reduce the residual most; None if none reduces it clearly.

    It has a second cause if the data clearly require one, and no errors of the measurement.
    """
    store = e.store
    limit = store.criterion(e.outcome.nuisance_fit) - e.criteria.search.survives
    improving = [
        fit for fit in _fits_without_errors(store) if not fit.at_bound and store.criterion(fit) < limit
    ]
    return min(improving, key=_penalised_criterion(e), default=None)


def reason_of_refusal(e: Evidence, fit: Fit) -> tuple[str, list[Candidate]]:
    """Return why the gate refuses an explanation, empty if it does not, and the candidates to which this points."""
    gate = e.search.gate(fit)
    if gate.unpaired_count:
        return f"with it the model has {without_mode(gate.unpaired_count)}", []
    if gate.p_value <= gate.level:
        return f"it leaves a residual {misfit.residual_in_words(e.store, fit, gate.p_value)}", []
    if gate.p_unmeasured <= gate.level:
        return "it adds modes between the measured ones that were not measured", []
    if gate.p_candidates <= gate.level:
        candidate = _indicated_candidate(gate)
        clause = (
            f"what it leaves still points to a candidate, {candidate.name} ({p_in_words(gate.p_candidates)})"
        )
        return clause, [candidate]
    return "", []


def _indicated_candidate(gate: Gate) -> Candidate:
    """Return the candidate to which a residual points most clearly."""
    return min(gate.scores.by_candidate, key=lambda entry: entry.p_value).candidate


def _fits_without_errors(store: FitStore) -> list[Fit]:
    """Return the explanations tried without errors of the measurement and without remote causes."""
    fits = store.all_fits()
    return [
        fit
        for fit in fits
        if (h := fit.hypothesis).causes and not (h.remote or h.excluded_rows or h.has_shared_error)
    ]


def _penalised_criterion(e: Evidence) -> Callable[[Fit], float]:
    """Return the sort key of explanations: their criterion, penalising a second cause unless the data require it."""
    store, penalty = e.store, e.criteria.claim.told_apart
    return lambda fit: store.criterion(fit) + penalty * len(fit.causes)


def _larger_ratio(store: FitStore, fit: Fit) -> float:
    """Return the larger of chi2 per degree of freedom of the frequencies and of the shapes."""
    return max(part.ratio for part in _misfits(store, fit))


def _misfits(store: FitStore, fit: Fit) -> tuple[Misfit, Misfit]:
    """Return the misfit of the frequencies, without the priors, and of the shapes with stated errors."""
    return misfit.frequency_misfit_without_priors(store, fit), store.fitter.misfit(fit, SHAPE, stated=True)
