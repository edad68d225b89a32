"""The posterior probabilities that nothing is missing, of each class, of each pair, and of something outside.

The best fits of a search are weighed by their evidence and by a prior, the same for each candidate, and for each
pair.  A cause that the search did not refit, because the linear model promised little, gets the evidence of the
linear model; so does a second cause beside the best single one if that pair was not refitted.  Causes with several
parameters are penalised by their Occam factors alone.  Remote candidates, such as those of a single joint, are part
of what is outside.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import comb

import numpy as np
from scipy import special

from pkmodes.core.support.grouping import grouped
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.posterior.document import ClassProbability, PairProbability, Probabilities
from pkmodes.loop.diagnosis.posterior.linearised import (
    MAX_SIGNAL,
    MIN_SIGNAL_RATIO,
    LinearisedFit,
    capped_deviance,
    linearise,
)
from pkmodes.loop.diagnosis.posterior.marginal import log_occam_factor
from pkmodes.loop.diagnosis.posterior.outside import log_evidence_outside
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.score import Score, allowed_sign
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.search.unmeasured import p_unmeasured

#: Prior probabilities that nothing is missing, one cause, two, or something outside the catalogue.
P_NOTHING, P_ONE_CAUSE, P_TWO_CAUSES, P_OUTSIDE = 0.55, 0.25, 0.04, 0.16
#: Doubts: the part of its probability that every explanation loses to something outside, which may look like it: if
#: the diagnosis accepts an explanation, if one leaves only noise but is not accepted, and if none leaves only noise.
#: With these the most probable explanation of 266 cases, not those of the published table, had the best logarithmic
#: score.
DOUBT_IF_ACCEPTED, DOUBT_IF_REFUSED, DOUBT_IF_UNEXPLAINED = 0.03, 0.25, 0.55
#: Fits are weighed up to this capped deviance above the smallest, and at most this many of them; something outside is
#: tried beside this many fits without causes, and as many with causes.
MAX_DEVIANCE_ABOVE_BEST, MAX_FITS, MAX_FITS_BESIDE_OUTSIDE = 60.0, 24, 3
#: Prior probability, given something outside, that it is in a single joint.
P_SINGLE_JOINT = 0.1
#: Classes less probable than the first are not reported, and members less probable than the second are left out.
MIN_CLASS_PROBABILITY, MIN_MEMBER_PROBABILITY = 1e-3, 1e-4
#: Smaller probabilities are reported as 0.
MIN_PROBABILITY = 1e-6
#: Explanations whose log weight is lower than the best one's by more than the first are not examined for unmeasured
#: modes; lower limit of the probability that such modes were missed.
MAX_WEIGHT_DEFICIT, MIN_P_MISSED = 15.0, 1e-12
#: Largest number of members of a class with which another explanation is compared.
MAX_MEMBERS_COMPARED = 4


@dataclass(frozen=True)
class WeightedExplanation:
    """An explanation with its weight.

    - causes: names of its causes
    - weight: logarithm of prior times evidence, not normalised
    - data: its fit, or its whitened effect on the data in the linear model, (D,)
    """

    causes: tuple[str, ...]
    weight: float
    data: Fit | Array


def probabilities(
    search: Search, max_deviations: Mapping[int, float], outcome: Outcome, *, accepted: bool
) -> Probabilities | None:
    """Return the probabilities of all explanations; None if no fit is plausible.

    - max_deviations: largest plausible deviations of parameters of candidates
    - outcome: of the search
    - accepted: whether the verdict accepts an explanation, or leaves a few
    """
    fitter, nuisance_fit, count = search.store.fitter, outcome.nuisance_fit, max(len(search.candidates), 1)
    priors = np.log([P_NOTHING, P_ONE_CAUSE / count, P_TWO_CAUSES / max(comb(count, 2), 1)])
    ranked = sorted(
        (
            (capped_deviance(fitter, fit), k, fit)
            for k, fit in enumerate(search.store.all_fits())
            if not fit.at_bound and len(fit.causes) <= 2
        ),
        key=lambda entry: entry[:2],
    )
    fits = [
        fit for deviance, _, fit in ranked[:MAX_FITS] if deviance <= ranked[0][0] + MAX_DEVIANCE_ABOVE_BEST
    ]
    fits += [] if any(fit is nuisance_fit for fit in fits) else [nuisance_fit]
    models = [
        model for fit in fits if np.isfinite((model := linearise(fitter, fit, max_deviations)).log_factor)
    ]
    models.sort(key=lambda model: -model.log_evidence)
    catalogue_models = [model for model in models if not model.fit.hypothesis.remote]
    explanations = [
        WeightedExplanation(_names(model.fit), priors[len(model.fit.causes)] + model.log_evidence, model.fit)
        for model in catalogue_models
    ]
    for cause_count in (0, 1):
        base = next((model for model in catalogue_models if len(model.fit.causes) == cause_count), None)
        if base is not None:
            explanations += _linear_explanations(search, max_deviations, base, priors[cause_count + 1])
    log_weight_outside = _log_weight_outside(search, nuisance_fit, priors, models)
    doubt = DOUBT_IF_REFUSED if outcome.last_gate.passed else DOUBT_IF_UNEXPLAINED
    merged = _merge_same_causes(search, nuisance_fit, explanations)
    return _normalise(fitter, merged, log_weight_outside, DOUBT_IF_ACCEPTED if accepted else doubt)


def _names(fit: Fit, *added: str) -> tuple[str, ...]:
    return tuple(sorted([*(cause.name for cause in fit.causes), *added]))


def _linear_explanations(
    search: Search, max_deviations: Mapping[int, float], base: LinearisedFit, prior: float
) -> list[WeightedExplanation]:
    """Return the explanations with one more cause than a fit that were not fitted, in the linear model.

    A second cause whose effect the data cannot distinguish from none counts as the first cause alone.

    - max_deviations: largest plausible deviations of parameters of candidates
    - prior: logarithm of the prior of each
    """
    fitted_names = {_names(fit) for fit in search.store.all_fits()}
    scores = search.scores(base.fit)
    directions = zip(
        (candidate_score for candidate_score in scores.by_candidate if candidate_score.visible),
        scores.directions,
        strict=True,
    )
    untried = [
        (candidate_score, axes)
        for candidate_score, (axes, _) in directions
        if _names(base.fit, candidate_score.candidate.name) not in fitted_names
    ]
    if not untried:
        return []
    removed_residuals = np.stack(
        [axes @ (axes.T @ base.white) * (candidate_score.gain > 0.0) for candidate_score, axes in untried],
        axis=1,
    )
    leverages = np.stack([(axes**2).sum(axis=1) for _, axes in untried], axis=1)
    weights = (
        prior
        + base.log_evidence_with(removed_residuals, leverages)
        + _log_occam_factors(search, [candidate_score for candidate_score, _ in untried], max_deviations)
    )
    is_hidden = (removed_residuals**2).sum(axis=0) < search.criteria.claim.told_apart
    return [
        WeightedExplanation(_names(base.fit), weight, base.fit)
        if base.fit.causes and is_unseen
        else WeightedExplanation(_names(base.fit, candidate_score.candidate.name), weight, effect)
        for (candidate_score, _), weight, effect, is_unseen in zip(
            untried, weights.tolist(), removed_residuals.T, is_hidden, strict=True
        )
    ]


def _log_occam_factors(search: Search, scores: Sequence[Score], max_deviations: Mapping[int, float]) -> Array:
    """Return the logarithms of the Occam factors of n causes in the linear model, (n,)."""
    fitter, signal = search.store.fitter, np.sqrt([candidate_score.gain for candidate_score in scores])
    signals = [
        [
            min(max_deviations.get(i, np.inf) / sigma, MAX_SIGNAL)
            for i, sigma in zip(
                fitter.parameter_indices(candidate_score.candidate),
                candidate_score.sigma.tolist(),
                strict=True,
            )
            if np.isfinite(sigma)
        ]
        for candidate_score in scores
    ]
    max_signals = np.maximum(
        [max(limits, default=MAX_SIGNAL) for limits in signals], MIN_SIGNAL_RATIO * signal
    )
    degrees = np.array([max(len(limits), 1) for limits in signals])
    signs = np.array([allowed_sign(fitter, candidate_score.candidate) != 0 for candidate_score in scores])
    log_factors = log_occam_factor(signal, degrees, max_signals, signs)
    width = fitter.priors.sigmas_in_units(fitter.declared)
    for k, candidate_score in enumerate(scores):
        if candidate_score.candidate.sigma is not None:
            rows = fitter.priors.rows(fitter.parameter_indices(candidate_score.candidate))
            log_factors[k] = float(np.log(candidate_score.sigma / width[rows]).sum())
    return log_factors


def _log_p_missed(search: Search, nuisance_fit: Fit, fit: Fit) -> float:
    """Return the logarithm of the probability that the modes added by causes were missed."""
    p = p_unmeasured(search.store.fitter, nuisance_fit, fit) if fit.causes else 1.0
    return float(np.log(max(p, MIN_P_MISSED)))


def _log_weight_outside(
    search: Search, nuisance_fit: Fit, priors: Array, models: Sequence[LinearisedFit]
) -> float:
    """Return the log of prior times evidence of something outside: changes beside the best fits, and remote causes.

    Changes are independent of the causes beside them.

    - priors: logarithms of the priors of fits with no cause, one and two, (3,)
    """
    fitter, remote_models = search.store.fitter, [model for model in models if model.fit.hypothesis.remote]
    without_causes = [model for model in models if not model.fit.causes]
    with_causes = [model for model in models if model.fit.causes and not model.fit.hypothesis.remote]
    log_p_change, log_p_joint = np.log(
        [
            (1.0 - P_SINGLE_JOINT) * P_OUTSIDE / (1.0 - P_OUTSIDE),
            P_SINGLE_JOINT * P_OUTSIDE / max(len(search.remote_candidates), 1),
        ]
    )
    weights_and_models = [(log_p_joint + model.log_evidence, model) for model in remote_models]
    for model in (*without_causes[:MAX_FITS_BESIDE_OUTSIDE], *with_causes[:MAX_FITS_BESIDE_OUTSIDE]):
        weight = log_p_change + priors[len(model.fit.causes)] + log_evidence_outside(fitter, model)
        weights_and_models.append((weight, model))
    weights = [
        weight + _log_p_missed(search, nuisance_fit, model.fit) for weight, model in weights_and_models
    ]
    return float(special.logsumexp(weights))


def _merge_same_causes(
    search: Search, nuisance_fit: Fit, explanations: Sequence[WeightedExplanation]
) -> list[WeightedExplanation]:
    """Return the explanations, the weights of all fits with the same causes added up, the most probable first."""
    explanations_by_causes: dict[tuple[str, ...], list[WeightedExplanation]] = {}
    for explanation in sorted(explanations, key=lambda explanation: -explanation.weight):
        explanations_by_causes.setdefault(explanation.causes, []).append(explanation)
    merged = [
        WeightedExplanation(
            causes, float(special.logsumexp([explanation.weight for explanation in group])), group[0].data
        )
        for causes, group in explanations_by_causes.items()
    ]
    min_weight = max((explanation.weight for explanation in merged), default=0.0) - MAX_WEIGHT_DEFICIT
    weighted = [
        WeightedExplanation(
            explanation.causes,
            explanation.weight + _log_p_missed(search, nuisance_fit, explanation.data),
            explanation.data,
        )
        if isinstance(explanation.data, Fit) and explanation.weight > min_weight
        else explanation
        for explanation in merged
    ]
    return sorted(weighted, key=lambda explanation: -explanation.weight)


def _normalise(
    fitter: Fitter, explanations: Sequence[WeightedExplanation], log_weight_outside: float, doubt: float
) -> Probabilities | None:
    """Return the normalised probabilities; explanations that the data cannot tell apart share one.

    - log_weight_outside: logarithm of prior times evidence of something outside
    - doubt: additional probability of something outside
    """
    total = float(
        special.logsumexp([log_weight_outside, *(explanation.weight for explanation in explanations)])
    )
    if not np.isfinite(total):
        return None
    probability_of = {
        explanation.causes: (1.0 - doubt) * _probability(explanation.weight - total)
        for explanation in explanations
    }
    with_causes = [
        explanation
        for explanation in explanations
        if explanation.causes and probability_of[explanation.causes] >= MIN_MEMBER_PROBABILITY
    ]
    groups = grouped(with_causes, functools.partial(_are_indistinguishable, fitter), MAX_MEMBERS_COMPARED)
    groups_and_probabilities = [
        (group, sum(probability_of[explanation.causes] for explanation in group)) for group in groups
    ]
    reported = sorted(
        (pair for pair in groups_and_probabilities if pair[1] >= MIN_CLASS_PROBABILITY),
        key=lambda pair: -pair[1],
    )
    p_nothing = probability_of.get((), 0.0)
    p_outside = doubt + (1.0 - doubt) * _probability(log_weight_outside - total)
    total_reported = p_nothing + p_outside + sum(probability for _, probability in reported)
    return Probabilities(
        nothing_missing=p_nothing / total_reported,
        outside=p_outside / total_reported,
        classes=tuple(
            ClassProbability(
                tuple(explanation.causes[0] for explanation in group), probability / total_reported
            )
            for group, probability in reported
            if len(group[0].causes) == 1
        ),
        pairs=tuple(
            PairProbability(
                tuple((explanation.causes[0], explanation.causes[1]) for explanation in group),
                probability / total_reported,
            )
            for group, probability in reported
            if len(group[0].causes) == 2
        ),
    )


def _probability(logarithm: float) -> float:
    """Return a probability from its logarithm; 0 if it is below the accuracy of the evidence."""
    return float(np.exp(logarithm)) if logarithm > np.log(MIN_PROBABILITY) else 0.0


def _are_indistinguishable(fitter: Fitter, first: WeightedExplanation, second: WeightedExplanation) -> bool:
    """Return whether the data cannot tell two explanations apart that are both fitted or both linear."""
    if len(first.causes) != len(second.causes):
        return False
    if isinstance(first.data, Fit) and isinstance(second.data, Fit):
        difference = fitter.squared_difference(first.data, second.data)
    elif isinstance(first.data, Fit) or isinstance(second.data, Fit):
        return False
    else:
        difference = float(((first.data - second.data) ** 2).sum())
    return difference < fitter.criteria.claim.told_apart
