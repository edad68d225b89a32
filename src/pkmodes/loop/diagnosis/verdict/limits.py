"""Limits of the candidates that are not claimed, and what these unseen candidates could do to the saved values.

A limit is that of a candidate beside the result of the diagnosis: the declared model with its nuisances refitted, the
claimed causes, or each of the explanations that remain.  If the residual is not explained, errors are scaled to the
residual that each candidate leaves.

Saved values
------------
A refitted value makes up for whatever is missing from the model.  When an unseen candidate moves to its limit, a
value moves by D; a normal deviate that exceeds D on that side with a probability of 5 % has the standard deviation
D / 1.645, which is what a joint fit of both would add to its variance (JCGM 100:2008, 5.1.2).  A candidate that the
data do not bound within its plausible range moves to the end of that range; this counts for values held by priors.
Other values, such as the size of a cause, could move anywhere with it: their standard deviation omits it, and a note
states this.  Of all candidates only the one that moves the value most is counted, not their sum: like the diagnosis
itself, this assumes one missing cause, and many candidates move the values in the same way, which a sum would count
several times (the envelope over alternative models; Dauncey, Kenzie, Wardle and Davies, Journal of Instrumentation
10, 2015, P04015).

A default on which a claimed value rests, because its value was not declared, such as the mass of a frame that yields,
is moved likewise.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.matrices import slow_call_remark
from pkmodes.loop.diagnosis.problem import Array, Assumption, Candidate, Parameter
from pkmodes.loop.diagnosis.search.limits import ONE_SIDED_SIGMAS, Bound, bounds, value_shifts_by_default
from pkmodes.loop.diagnosis.verdict.findings import MIN_NOTICEABLE_RATIO, Limit, Unseen

#: Largest number of remaining explanations for which limits are determined.
MAX_EXPLANATIONS = 4


@dataclass(frozen=True)
class CandidateLimits:
    """The limits of all candidates that are not claimed.

    - by_parameter: limits by the names of parameters
    - unseen: possible effects of the candidates on the fitted values, by parameter
    - max_deviations: largest plausible deviations, by parameter
    - candidates, unbounded: names of the candidates, and of those with a parameter that the data do not bound
    """

    by_parameter: Mapping[str, Limit]
    unseen: Mapping[int, Unseen]
    max_deviations: Mapping[int, float]
    candidates: frozenset[str]
    unbounded: frozenset[str]

    @property
    def limited(self) -> frozenset[str]:
        """Names of the candidates of which some parameter has a limit."""
        return frozenset(limit.candidate for limit in self.by_parameter.values() if limit.value is not None)


#: Limits where no candidate was bounded.
NO_LIMITS = CandidateLimits({}, {}, {}, frozenset(), frozenset())


def unknown_limits(store: FitStore, candidates: Iterable[Candidate]) -> CandidateLimits:
    """Return the limits where the data are uninformative because of an obvious mistake."""
    fitter = store.fitter
    index = [(candidate, i) for candidate in candidates for i in fitter.parameter_indices(candidate)]
    names = frozenset(candidate.name for candidate, _ in index)
    limits = {limit_key(p := fitter.parameters[i]): Limit(c.name, None, p.unit) for c, i in index}
    return CandidateLimits(limits, {}, {}, names, names)


def limits_beside(
    store: FitStore, fits: Sequence[Fit], candidates: Iterable[Candidate], *, residual_is_noise: bool
) -> CandidateLimits:
    """Return the limits of candidates added to fits that explain the measurements: the largest over all of them.

    - candidates: a candidate that is a cause of some of the fits is bounded in those alone
    - residual_is_noise: whether the residuals of the fits are noise
    """
    fitter = store.fitter
    use_linear_model = bool(slow_call_remark(fitter.structure))
    all_bounds: list[Bound] = []
    all_candidates, fits = list(candidates), fits[:MAX_EXPLANATIONS]
    causes = {cause for fit in fits for cause in fit.causes}
    for fit in fits:
        bounded_candidates = [c for c in all_candidates if c not in causes or c in fit.causes]
        all_bounds += bounds(store, fit, bounded_candidates, noise=residual_is_noise, linear=use_linear_model)
    by_name: dict[str, Limit] = {}
    for bound in all_bounds:
        p = fitter.parameters[bound.index]
        name, limit = limit_key(p), Limit(bound.candidate.name, bound.size, p.unit, bound.frequency_change)
        by_name[name] = max(
            by_name.get(name, limit),
            limit,
            key=lambda limit: math.inf if limit.value is None else limit.value,
        )
    unseen = {}
    if residual_is_noise and len(fits) == 1:
        unseen = _unseen_effects(fits[0], all_bounds, value_shifts_by_default(store, fits[0]))
    ordered = (limit_key(fitter.parameters[i]) for c in all_candidates for i in fitter.parameter_indices(c))
    return CandidateLimits(
        {name: by_name[name] for name in ordered if name in by_name},
        unseen,
        {bound.index: bound.max_deviation for bound in all_bounds},
        frozenset(bound.candidate.name for bound in all_bounds),
        frozenset(bound.candidate.name for bound in all_bounds if bound.size is None),
    )


def limit_key(p: Parameter) -> str:
    """Return the key of a parameter among the limits: of an effect its name and parameter, else the path."""
    return p.name.removeprefix("effects.")


def _unseen_effects(
    fit: Fit, all_bounds: Collection[Bound], shifts_by_default: Mapping[Assumption, Array]
) -> dict[int, Unseen]:
    """Return the largest movement of each fitted value as a standard deviation, and its origin."""
    effects = {}
    for i in fit.free if all_bounds else ():
        largest_shift = max(all_bounds, key=lambda bound: bound.value_shifts[i])
        largest_unbounded = max(all_bounds, key=lambda bound: bound.unbounded_shifts[i])
        sigma = float(largest_shift.value_shifts[i]) / ONE_SIDED_SIGMAS
        farther_sigma = float(largest_unbounded.unbounded_shifts[i]) / ONE_SIDED_SIGMAS
        total_sigma = math.hypot(fit.sigma_of(i), sigma)
        is_farther = (
            farther_sigma > sigma
            and math.hypot(fit.sigma_of(i), farther_sigma) > MIN_NOTICEABLE_RATIO * total_sigma
        )
        effects[i] = Unseen(
            sigma, largest_shift.candidate.name, largest_unbounded.candidate.name if is_farther else ""
        )
        for default, shifts in shifts_by_default.items():
            if shifts[i] / ONE_SIDED_SIGMAS > effects[i].sigma:
                sigma = float(shifts[i]) / ONE_SIDED_SIGMAS
                effects[i] = replace(effects[i], sigma=sigma, candidate="", default=default.words)
    return effects
