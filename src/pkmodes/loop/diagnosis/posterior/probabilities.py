"""The posterior probabilities of nothing missing, of each class and pair, and of something outside the catalogue.

The best fits of a search are weighed by their evidence and by a prior, the same for each candidate, and for each
pair.  A cause that the search did not refit, because the linear model predicted little improvement, gets the
evidence of the linear model; so does a second cause added to the best single one if that pair was not refitted.
Causes with several parameters are penalised by their Occam factors alone.  Remote candidates, such as those of a
single joint, are part of what is outside.
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
#: Fraction of every explanation's probability given to something outside that may mimic it, when the diagnosis
#: accepts an explanation, accepts none although one leaves only noise, or finds none that leaves only noise.  Chosen
#: for the best logarithmic score over 266 cases that are not in the published table.
DOUBT_IF_ACCEPTED, DOUBT_IF_REFUSED, DOUBT_IF_UNEXPLAINED = 0.03, 0.25, 0.55
#: Fits are weighed if their capped deviance exceeds the smallest by at most the first, and at most the second number
#: of them.  Something outside is combined with the best fits, the third number each with and without causes.
MAX_DEVIANCE_ABOVE_BEST, MAX_FITS, MAX_FITS_WITH_OUTSIDE = 60.0, 24, 3
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
    - log_weight: logarithm of prior times evidence, not normalised
    - fit_or_effect: its fit, or its whitened effect on the data in the linear model, (D,)
    """

    causes: tuple[str, ...]
    log_weight: float
    fit_or_effect: Fit | Array


def probabilities(
    search: Search, max_deviations: Mapping[int, float], outcome: Outcome, *, accepted: bool
) -> Probabilities | None:
    """Return the probabilities of all explanations; None if no fit is plausible.

    - max_deviations: largest plausible deviations of parameters of candidates
    - outcome: outcome of the search
    - accepted: whether the verdict accepts one explanation or narrows the choice to a few
    """
    fitter, nuisance_fit, candidate_count = (
        search.store.fitter,
        outcome.nuisance_fit,
        max(len(search.candidates), 1),
    )
    log_priors = np.log(
        [P_NOTHING, P_ONE_CAUSE / candidate_count, P_TWO_CAUSES / max(comb(candidate_count, 2), 1)]
    )
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
        WeightedExplanation(
            _cause_names(model.fit), log_priors[len(model.fit.causes)] + model.log_evidence, model.fit
        )
        for model in catalogue_models
    ]
    for cause_count in (0, 1):
        base_model = next((model for model in catalogue_models if len(model.fit.causes) == cause_count), None)
        if base_model is not None:
            explanations += _linear_explanations(
                search, max_deviations, base_model, log_priors[cause_count + 1]
            )
    log_weight_outside = _log_weight_outside(search, nuisance_fit, log_priors, models)
    doubt = DOUBT_IF_REFUSED if outcome.last_gate.passed else DOUBT_IF_UNEXPLAINED
    merged = _merge_same_causes(search, nuisance_fit, explanations)
    return _normalise(fitter, merged, log_weight_outside, DOUBT_IF_ACCEPTED if accepted else doubt)


def _cause_names(fit: Fit, *added: str) -> tuple[str, ...]:
    return tuple(sorted([*(cause.name for cause in fit.causes), *added]))


def _linear_explanations(
    search: Search, max_deviations: Mapping[int, float], base_model: LinearisedFit, log_prior: float
) -> list[WeightedExplanation]:
    """Return, from the linear model, the explanations that add one unfitted cause to a fit.

    A second cause whose effect the data cannot distinguish from none counts as the first cause alone.

    - max_deviations: largest plausible deviations of parameters of candidates
    - log_prior: logarithm of the prior of each
    """
    fitted_names = {_cause_names(fit) for fit in search.store.all_fits()}
    scores = search.scores(base_model.fit)
    visible_scores = [
        candidate_score for candidate_score in scores.by_candidate if candidate_score.is_visible
    ]
    untried = [
        (candidate_score, axes)
        for candidate_score, (axes, _) in zip(visible_scores, scores.directions, strict=True)
        if _cause_names(base_model.fit, candidate_score.candidate.name) not in fitted_names
    ]
    if not untried:
        return []
    effects = np.stack(
        [
            axes @ (axes.T @ base_model.white) * (candidate_score.gain > 0.0)
            for candidate_score, axes in untried
        ],
        axis=1,
    )
    leverages = np.stack([(axes**2).sum(axis=1) for _, axes in untried], axis=1)
    log_weights = (
        log_prior
        + base_model.log_evidence_with(effects, leverages)
        + _log_occam_factors(search, [candidate_score for candidate_score, _ in untried], max_deviations)
    )
    is_undetectable = (effects**2).sum(axis=0) < search.criteria.claim.told_apart
    explanations = []
    for k, (candidate_score, _) in enumerate(untried):
        fit_or_effect: Fit | Array
        if base_model.fit.causes and is_undetectable[k]:
            causes, fit_or_effect = _cause_names(base_model.fit), base_model.fit
        else:
            causes = _cause_names(base_model.fit, candidate_score.candidate.name)
            fit_or_effect = effects[:, k]
        explanations.append(WeightedExplanation(causes, float(log_weights[k]), fit_or_effect))
    return explanations


def _log_occam_factors(search: Search, scores: Sequence[Score], max_deviations: Mapping[int, float]) -> Array:
    """Return the logarithms of the Occam factors of n causes in the linear model, (n,)."""
    fitter, signal = search.store.fitter, np.sqrt([candidate_score.gain for candidate_score in scores])
    max_signals_by_cause = [
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
        [max(parameter_max_signals, default=MAX_SIGNAL) for parameter_max_signals in max_signals_by_cause],
        MIN_SIGNAL_RATIO * signal,
    )
    dimensions = np.array(
        [max(len(parameter_max_signals), 1) for parameter_max_signals in max_signals_by_cause]
    )
    is_one_sided = np.array(
        [allowed_sign(fitter, candidate_score.candidate) != 0 for candidate_score in scores]
    )
    log_factors = log_occam_factor(signal, dimensions, max_signals, is_one_sided)
    prior_sigmas = fitter.priors.sigmas_in_units(fitter.declared)
    for k, candidate_score in enumerate(scores):
        if candidate_score.candidate.sigma is not None:
            prior_indices = fitter.priors.rows(fitter.parameter_indices(candidate_score.candidate))
            log_factors[k] = float(np.log(candidate_score.sigma / prior_sigmas[prior_indices]).sum())
    return log_factors


def _log_p_missed(search: Search, nuisance_fit: Fit, fit: Fit) -> float:
    """Return the logarithm of the probability that the modes added by causes were missed."""
    p = p_unmeasured(search.store.fitter, nuisance_fit, fit) if fit.causes else 1.0
    return float(np.log(max(p, MIN_P_MISSED)))


def _log_weight_outside(
    search: Search, nuisance_fit: Fit, log_priors: Array, models: Sequence[LinearisedFit]
) -> float:
    """Return the log of prior times evidence of something outside: changes added to the best fits, and remote causes.

    A change outside the catalogue is taken as independent of the causes in the fit.

    - log_priors: logarithms of the priors of fits with no cause, one and two, (3,)
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
    log_weights_and_models = [(log_p_joint + model.log_evidence, model) for model in remote_models]
    for model in (*without_causes[:MAX_FITS_WITH_OUTSIDE], *with_causes[:MAX_FITS_WITH_OUTSIDE]):
        log_weight = log_p_change + log_priors[len(model.fit.causes)] + log_evidence_outside(fitter, model)
        log_weights_and_models.append((log_weight, model))
    log_weights = [
        log_weight + _log_p_missed(search, nuisance_fit, model.fit)
        for log_weight, model in log_weights_and_models
    ]
    return float(special.logsumexp(log_weights))


def _merge_same_causes(
    search: Search, nuisance_fit: Fit, explanations: Sequence[WeightedExplanation]
) -> list[WeightedExplanation]:
    """Return the explanations, the weights of all fits with the same causes added up, the most probable first."""
    explanations_by_causes: dict[tuple[str, ...], list[WeightedExplanation]] = {}
    for explanation in sorted(explanations, key=lambda explanation: -explanation.log_weight):
        explanations_by_causes.setdefault(explanation.causes, []).append(explanation)
    merged = [
        WeightedExplanation(
            causes,
            float(special.logsumexp([explanation.log_weight for explanation in group])),
            group[0].fit_or_effect,
        )
        for causes, group in explanations_by_causes.items()
    ]
    min_log_weight = max((explanation.log_weight for explanation in merged), default=0.0) - MAX_WEIGHT_DEFICIT
    weighted = [
        WeightedExplanation(
            explanation.causes,
            explanation.log_weight + _log_p_missed(search, nuisance_fit, explanation.fit_or_effect),
            explanation.fit_or_effect,
        )
        if isinstance(explanation.fit_or_effect, Fit) and explanation.log_weight > min_log_weight
        else explanation
        for explanation in merged
    ]
    return sorted(weighted, key=lambda explanation: -explanation.log_weight)


def _normalise(
    fitter: Fitter, explanations: Sequence[WeightedExplanation], log_weight_outside: float, doubt: float
) -> Probabilities | None:
    """Return the normalised probabilities; explanations that the data cannot tell apart share one.

    - log_weight_outside: logarithm of prior times evidence of something outside
    - doubt: additional probability of something outside
    """
    log_total = float(
        special.logsumexp([log_weight_outside, *(explanation.log_weight for explanation in explanations)])
    )
    if not np.isfinite(log_total):
        return None
    probability_by_causes = {
        explanation.causes: (1.0 - doubt) * _probability(explanation.log_weight - log_total)
        for explanation in explanations
    }
    with_causes = [
        explanation
        for explanation in explanations
        if explanation.causes and probability_by_causes[explanation.causes] >= MIN_MEMBER_PROBABILITY
    ]
    groups = grouped(with_causes, functools.partial(_are_indistinguishable, fitter), MAX_MEMBERS_COMPARED)
    groups_and_probabilities = [
        (group, sum(probability_by_causes[explanation.causes] for explanation in group)) for group in groups
    ]
    reported = sorted(
        (entry for entry in groups_and_probabilities if entry[1] >= MIN_CLASS_PROBABILITY),
        key=lambda group_and_probability: -group_and_probability[1],
    )
    p_nothing = probability_by_causes.get((), 0.0)
    p_outside = doubt + (1.0 - doubt) * _probability(log_weight_outside - log_total)
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
    """Return whether the data cannot distinguish two explanations; False if one is fitted and the other linear."""
    if len(first.causes) != len(second.causes):
        return False
    if isinstance(first.fit_or_effect, Fit) and isinstance(second.fit_or_effect, Fit):
        difference = fitter.squared_difference(first.fit_or_effect, second.fit_or_effect)
    elif isinstance(first.fit_or_effect, Fit) or isinstance(second.fit_or_effect, Fit):
        return False
    else:
        difference = float(((first.fit_or_effect - second.fit_or_effect) ** 2).sum())
    return difference < fitter.criteria.claim.told_apart
