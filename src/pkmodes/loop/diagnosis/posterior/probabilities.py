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
    BEYOND_SIGNAL,
    SIGNAL,
    Linearised,
    capped_deviance,
    linearised,
)
from pkmodes.loop.diagnosis.posterior.marginal import log_occam_factor
from pkmodes.loop.diagnosis.posterior.outside import log_evidence_outside
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.score import Score, one_sided
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.search.unmeasured import p_unmeasured

#: Prior probabilities that nothing is missing, one cause, two, or something outside the catalogue.
NOTHING, ONE, TWO, OUTSIDE = 0.55, 0.25, 0.04, 0.16
#: Doubts: the part of its probability that every explanation loses to something outside, which may look like it: if
#: the diagnosis accepts an explanation, if one leaves only noise but is not accepted, and if none leaves only noise.
#: With these the most probable explanation of 266 cases, not those of the published table, had the best logarithmic
#: score.
ACCEPTED, REFUSED, NONE = 0.03, 0.25, 0.55
#: Fits are weighed up to this capped deviance above the smallest, and at most this many of them; something outside is
#: tried beside this many fits without causes, and as many with causes.
NEAR, WEIGHED, BESIDE = 60.0, 24, 3
#: Prior probability, given something outside, that it is in a single joint.
IN_ONE = 0.1
#: Classes less probable than the first are not reported, and members less probable than the second are left out.
STATED, LEAST = 1e-3, 1e-4
#: Smaller probabilities are reported as 0.
NEVER = 1e-6
#: Explanations whose log weight is lower than the best one's by more than the first are not examined for unmeasured
#: modes; lower limit of the probability that such modes were missed.
COUNTS, MISSED = 15.0, 1e-12
#: Largest number of members of a class with which another explanation is compared.
COMPARED = 4


@dataclass(frozen=True)
class Weighed:
    """An explanation with its weight.

    - causes: names of its causes
    - weight: logarithm of prior times evidence, not normalised
    - data: its fit, or its whitened effect on the data in the linear model, (D,)
    """

    causes: tuple[str, ...]
    weight: float
    data: Fit | Array


def probabilities(
    search: Search, plausible: Mapping[int, float], outcome: Outcome, *, accepted: bool
) -> Probabilities | None:
    """Return the probabilities of all explanations; None if no fit is plausible.

    - plausible: largest plausible deviations of parameters of candidates
    - outcome: of the search
    - accepted: whether the verdict accepts an explanation, or leaves a few
    """
    fitter, first, count = search.store.fitter, outcome.nuisances, max(len(search.candidates), 1)
    priors = np.log([NOTHING, ONE / count, TWO / max(comb(count, 2), 1)])
    ranked = sorted(
        (
            (capped_deviance(fitter, fit), k, fit)
            for k, fit in enumerate(search.store.all_fits())
            if not fit.at_bound and len(fit.causes) <= 2
        ),
        key=lambda entry: entry[:2],
    )
    near = [fit for quick, _, fit in ranked[:WEIGHED] if quick <= ranked[0][0] + NEAR]
    near += [] if any(fit is first for fit in near) else [first]
    models = [model for fit in near if np.isfinite((model := linearised(fitter, fit, plausible)).log_factor)]
    models.sort(key=lambda model: -model.log_evidence)
    catalogued = [model for model in models if not model.fit.hypothesis.remote]
    explained = [
        Weighed(_names(model.fit), priors[len(model.fit.causes)] + model.log_evidence, model.fit)
        for model in catalogued
    ]
    for number in (0, 1):
        base = next((model for model in catalogued if len(model.fit.causes) == number), None)
        explained += [] if base is None else _beside(search, plausible, base, priors[number + 1])
    beyond = _outside(search, first, priors, models)
    doubt = ACCEPTED if accepted else REFUSED if outcome.last.passed else NONE
    return _normalised(fitter, _together(search, first, explained), beyond, doubt)


def _names(fit: Fit, *added: str) -> tuple[str, ...]:
    return tuple(sorted([*(cause.name for cause in fit.causes), *added]))


def _beside(search: Search, plausible: Mapping[int, float], base: Linearised, prior: float) -> list[Weighed]:
    """Return the explanations with one more cause than a fit that were not fitted, in the linear model.

    A second cause whose effect the data cannot distinguish from none counts as the first cause alone.

    - plausible: largest plausible deviations of parameters of candidates
    - prior: logarithm of the prior of each
    """
    fitted = {_names(fit) for fit in search.store.all_fits()}
    scores = search.scores(base.fit)
    directions = zip(
        (entry for entry in scores.by_candidate if entry.visible), scores.directions, strict=True
    )
    new = [
        (entry, axes)
        for entry, (axes, _) in directions
        if _names(base.fit, entry.candidate.name) not in fitted
    ]
    if not new:
        return []
    along = np.stack([axes @ (axes.T @ base.white) * (entry.gain > 0.0) for entry, axes in new], axis=1)
    taken = np.stack([(axes**2).sum(axis=1) for _, axes in new], axis=1)
    weights = (
        prior
        + base.log_evidence_with(along, taken)
        + _log_occam_factors(search, [entry for entry, _ in new], plausible)
    )
    hidden = (along**2).sum(axis=0) < search.criteria.claim.told_apart
    return [
        Weighed(_names(base.fit), weight, base.fit)
        if base.fit.causes and unseen
        else Weighed(_names(base.fit, entry.candidate.name), weight, effect)
        for (entry, _), weight, effect, unseen in zip(new, weights.tolist(), along.T, hidden, strict=True)
    ]


def _log_occam_factors(search: Search, scores: Sequence[Score], plausible: Mapping[int, float]) -> Array:
    """Return the logarithms of the Occam factors of n causes in the linear model, (n,)."""
    fitter, signal = search.store.fitter, np.sqrt([entry.gain for entry in scores])
    signals = [
        [
            min(plausible.get(i, np.inf) / sigma, SIGNAL)
            for i, sigma in zip(fitter.indices(entry.candidate), entry.sigma.tolist(), strict=True)
            if np.isfinite(sigma)
        ]
        for entry in scores
    ]
    largest = np.maximum([max(limits, default=SIGNAL) for limits in signals], BEYOND_SIGNAL * signal)
    degrees = np.array([max(len(limits), 1) for limits in signals])
    signs = np.array([one_sided(fitter, entry.candidate) != 0 for entry in scores])
    prices, width = (
        log_occam_factor(signal, degrees, largest, signs),
        fitter.priors.sigmas_in_units(fitter.declared),
    )
    for k, entry in enumerate(scores):
        if entry.candidate.sigma is not None:
            rows = fitter.priors.rows(fitter.indices(entry.candidate))
            prices[k] = float(np.log(entry.sigma / width[rows]).sum())
    return prices


def _missed(search: Search, first: Fit, fit: Fit) -> float:
    """Return the logarithm of the probability that the modes added by causes were missed."""
    p = p_unmeasured(search.store.fitter, first, fit) if fit.causes else 1.0
    return float(np.log(max(p, MISSED)))


def _outside(search: Search, first: Fit, priors: Array, models: Sequence[Linearised]) -> float:
    """Return the log of prior times evidence of something outside: changes beside the best fits, and remote causes.

    Changes are independent of the causes beside them.

    - priors: logarithms of the priors of fits with no cause, one and two, (3,)
    """
    fitter, remote = search.store.fitter, [model for model in models if model.fit.hypothesis.remote]
    plain = [model for model in models if not model.fit.causes][:BESIDE]
    caused = [model for model in models if model.fit.causes and not model.fit.hypothesis.remote][:BESIDE]
    changes, joint = np.log(
        [(1.0 - IN_ONE) * OUTSIDE / (1.0 - OUTSIDE), IN_ONE * OUTSIDE / max(len(search.remote), 1)]
    )
    weighed = [(joint + model.log_evidence, model) for model in remote]
    for model in (*plain, *caused):
        weighed.append((changes + priors[len(model.fit.causes)] + log_evidence_outside(fitter, model), model))
    return float(special.logsumexp([weight + _missed(search, first, model.fit) for weight, model in weighed]))


def _together(search: Search, first: Fit, explained: Sequence[Weighed]) -> list[Weighed]:
    """Return the explanations, the weights of all fits with the same causes added up, the most probable first."""
    of: dict[tuple[str, ...], list[Weighed]] = {}
    for explanation in sorted(explained, key=lambda explanation: -explanation.weight):
        of.setdefault(explanation.causes, []).append(explanation)
    merged = [
        Weighed(
            causes, float(special.logsumexp([explanation.weight for explanation in group])), group[0].data
        )
        for causes, group in of.items()
    ]
    least = max((explanation.weight for explanation in merged), default=0.0) - COUNTS
    weighed = [
        Weighed(
            explanation.causes,
            explanation.weight + _missed(search, first, explanation.data),
            explanation.data,
        )
        if isinstance(explanation.data, Fit) and explanation.weight > least
        else explanation
        for explanation in merged
    ]
    return sorted(weighed, key=lambda explanation: -explanation.weight)


def _normalised(
    fitter: Fitter, explained: Sequence[Weighed], beyond: float, doubt: float
) -> Probabilities | None:
    """Return the normalised probabilities; explanations that the data cannot tell apart share one.

    - beyond: logarithm of prior times evidence of something outside
    - doubt: additional probability of something outside
    """
    total = float(special.logsumexp([beyond, *(explanation.weight for explanation in explained)]))
    if not np.isfinite(total):
        return None
    mass = {
        explanation.causes: (1.0 - doubt) * _probability(explanation.weight - total)
        for explanation in explained
    }
    named = [
        explanation for explanation in explained if explanation.causes and mass[explanation.causes] >= LEAST
    ]
    groups = grouped(named, functools.partial(_alike, fitter), COMPARED)
    sums = [(group, sum(mass[explanation.causes] for explanation in group)) for group in groups]
    stated = sorted((pair for pair in sums if pair[1] >= STATED), key=lambda pair: -pair[1])
    nothing, away = mass.get((), 0.0), doubt + (1.0 - doubt) * _probability(beyond - total)
    whole = nothing + away + sum(share for _, share in stated)
    return Probabilities(
        nothing_missing=nothing / whole,
        outside=away / whole,
        classes=tuple(
            ClassProbability(tuple(explanation.causes[0] for explanation in group), share / whole)
            for group, share in stated
            if len(group[0].causes) == 1
        ),
        pairs=tuple(
            PairProbability(
                tuple((explanation.causes[0], explanation.causes[1]) for explanation in group), share / whole
            )
            for group, share in stated
            if len(group[0].causes) == 2
        ),
    )


def _probability(logarithm: float) -> float:
    """Return a probability from its logarithm; 0 if it is below the accuracy of the evidence."""
    return float(np.exp(logarithm)) if logarithm > np.log(NEVER) else 0.0


def _alike(fitter: Fitter, first: Weighed, second: Weighed) -> bool:
    """Return whether the data cannot tell two explanations apart that are both fitted or both linear."""
    if len(first.causes) != len(second.causes):
        return False
    if isinstance(first.data, Fit) and isinstance(second.data, Fit):
        apart = fitter.difference(first.data, second.data)
    elif isinstance(first.data, Fit) or isinstance(second.data, Fit):
        return False
    else:
        apart = float(((first.data - second.data) ** 2).sum())
    return apart < fitter.criteria.claim.told_apart
