r"""How large candidates added to a fit may still be, and what they would do to the fitted values.

The limit of a parameter is the end, at 95 % and one-sided, of its profile likelihood (`fit.profile`): the largest
size at which the candidate, fitted together with everything that was fitted before, leaves a sum of squares at most
:math:`1.645^2` above its least.  A parameter that may have both signs is bounded on both sides, and its limit is the
larger size: the same test of :math:`|\theta|`.  At a physical bound, such as no compliance at all, the test is that
of Cowan, Cranmer, Gross and Vitells (Asymptotic formulae for likelihood-based tests of new physics, European Physical
Journal C 71, 2011, 1554, equation 16): the limit covers too often rather than too seldom.

The prior of a candidate takes no part in its limit, which is what these data exclude.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.profile import (
    MIN_SINGULAR_VALUE,
    End,
    ModelRequest,
    ProfilePoint,
    Profiles,
    Side,
    without_priors,
)
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array, Assumption, Candidate
from pkmodes.loop.diagnosis.search.ranges import largest_rates, max_plausible_deviation

#: Standard deviations of a one-sided bound at 95 %.
ONE_SIDED_SIGMAS = float(stats.norm.ppf(0.95))
#: Factor by which a value that nobody declared may be wrong, such as the mass of the frame of a small printer.
DEFAULT_FACTOR = 10.0
#: If the linear model promises less than this sum of squares, the fit without the candidate is as good as with it.
MIN_GAIN = 0.5
#: The linear model suffices if its second order, the square of the largest relative change of a frequency, is below
#: this part of the smallest standard deviation.
MAX_SECOND_ORDER = 0.1


@dataclass(frozen=True)
class Bound:
    """How large one parameter of a candidate may still be.

    - index: the parameter
    - size: largest deviation from the declared value at 95 %; None if the data do not bound it within its plausible
      range
    - max_deviation: largest plausible deviation; infinite if unknown
    - frequency_change: relative change of some frequency at the limit, in the linear model; 0 without a limit
    - value_shifts: how far all fitted values move when the candidate has this size, (P,); for values with a prior,
      which limits them, also when it has the largest plausible size
    - unbounded_shifts: how far, at least, values without a prior move if the data do not bound the candidate, (P,)
    """

    candidate: Candidate
    index: int
    size: float | None
    max_deviation: float
    frequency_change: float
    value_shifts: Array
    unbounded_shifts: Array


@dataclass(frozen=True)
class _AddedCandidate:
    """A candidate added to a fit.

    - free, without_prior, rates: free parameters, those to be taken without their priors, and the largest derivatives
      of ln f by parameter
    - start: the model at that fit
    - gain: decrease of the sum of squares that the linear model promises
    - step: the corresponding change of all values, (P,)
    """

    candidate: Candidate
    free: tuple[int, ...]
    without_prior: tuple[int, ...]
    rates: dict[int, float]
    start: ProfilePoint
    gain: float
    step: Array

    @property
    def linear_minimum(self) -> ProfilePoint:
        """The minimum of the linear model."""
        white = self.start.white + self.start.jacobian @ self.step[list(self.free)]
        return ProfilePoint(self.start.values + self.step, white, self.start.jacobian)


def bounds(
    store: FitStore, fit: Fit, candidates: Sequence[Candidate], *, noise: bool = True, linear: bool = False
) -> list[Bound]:
    """Return the bounds of all parameters of some candidates added to a fit.

    - noise: whether the residual of the fit is noise.  If not, errors are scaled to what each candidate leaves.
    - linear: whether to use the model linearised at the fit only, for models that are slow to evaluate
    """
    fitter = store.fitter
    if not candidates:
        return []
    profiles = Profiles(fitter, fit)
    additions = _added_candidates(fitter, fit, candidates)
    minima = (
        [(addition.linear_minimum, 0.0) for addition in additions]
        if linear
        else _minima(store, profiles, additions, fit)
    )
    sides, owners = [], []
    for addition, (point, gain) in zip(additions, minima, strict=True):
        variance_ratio = 1.0
        if not noise:  # chi2 per degree of freedom that the candidate leaves
            free = sum(fitter.priors.row_of(i) is None for i in addition.free if i not in fit.free)
            variance_ratio = max(1.0, point.squares / max(store.degrees(fit) - free, 1))
        for i in fitter.parameter_indices(addition.candidate):
            for sign in (1, -1):
                side = _side(fitter, addition, point, i, sign, variance_ratio * ONE_SIDED_SIGMAS**2 - gain)
                if side is not None:
                    sides.append(side)
                    owners.append(addition)
    side_ends = [profiles.linear_end(side) for side in sides]
    sides_owners_and_ends = zip(sides, owners, side_ends, strict=True)
    sides_to_refine = [
        k
        for k, (side, addition, end) in enumerate(sides_owners_and_ends)
        if not linear and not _linear_model_suffices(fitter, side, addition, end)
    ]
    for k, end in zip(sides_to_refine, profiles.ends([sides[k] for k in sides_to_refine]), strict=True):
        side_ends[k] = end
    ends_by_parameter: dict[tuple[str, int], list[tuple[Side, End]]] = {}
    for addition, side, end in zip(owners, sides, side_ends, strict=True):
        ends_by_parameter.setdefault((addition.candidate.name, side.index), []).append((side, end))
    return [
        _bound(fitter, fit, addition, i, ends_by_parameter.get((addition.candidate.name, i), []))
        for addition in additions
        for i in fitter.parameter_indices(addition.candidate)
    ]


def value_shifts_by_default(store: FitStore, fit: Fit) -> dict[Assumption, Array]:
    """Return how far the values of a fit move when a default that its causes assume is wrong, (P,) for each.

    The default moves to its own limit at 95 %, but at most by a factor of `DEFAULT_FACTOR`, in both directions.
    """
    fitter = store.fitter
    indices = {p.name: i for i, p in enumerate(fitter.parameters)}
    shifts = {}
    for assumption in dict.fromkeys(default for cause in fit.causes for default in cause.assumes):
        index = indices.get(assumption.parameter)
        if index is None or index in fit.free:
            continue
        declared = fitter.parameters[index].value
        default_as_candidate = Candidate(assumption.parameter, (assumption.parameter,))
        (addition,) = _added_candidates(fitter, fit, [default_as_candidate])
        signs_and_ranges = (
            (1, (DEFAULT_FACTOR - 1.0) * declared),
            (-1, (1.0 - 1.0 / DEFAULT_FACTOR) * declared),
        )
        start, limit = addition.start, addition.start.squares + ONE_SIDED_SIGMAS**2
        sides = [
            Side(index, declared, sign, addition.free, (), max_deviation, start, limit)
            for sign, max_deviation in signs_and_ranges
        ]
        ends = Profiles(fitter, fit).ends(sides)
        shift = np.max([np.abs(end.values - fit.values) for end in ends], axis=0)
        shift[index] = 0.0
        shifts[assumption] = shift
    return shifts


def _added_candidates(fitter: Fitter, fit: Fit, candidates: Sequence[Candidate]) -> list[_AddedCandidate]:
    indices = list(dict.fromkeys(i for candidate in candidates for i in fitter.parameter_indices(candidate)))
    _, signatures = fitter.signatures(fit, indices)
    prediction = fitter.structure.predict(fit.values, indices, shape_rates=fitter.observations.shape_rates)
    rates = dict(zip(indices, largest_rates(prediction).tolist(), strict=True))
    additions = []
    for candidate in candidates:
        candidate_indices = fitter.parameter_indices(candidate)
        new_parameters = [i for i in candidate_indices if i not in fit.free]
        free = (*fit.free, *new_parameters)
        without_prior = candidate_indices if candidate.sigma is not None else ()
        jacobian = np.hstack([fit.jacobian, -signatures[:, [indices.index(i) for i in new_parameters]]])
        white, jacobian = without_priors(fitter, fit.white, jacobian, without_prior)
        step = np.zeros_like(fit.values)
        length = np.linalg.norm(jacobian, axis=0)
        scale = 1.0 / np.where(length > 0.0, length, 1.0)
        step[list(free)] = -np.linalg.lstsq(jacobian * scale, white, rcond=MIN_SINGULAR_VALUE)[0] * scale
        residual = white + jacobian @ step[list(free)]
        gain = float(white @ white - residual @ residual)
        p = fitter.parameters[candidate_indices[0]]
        if (
            len(candidate_indices) == 1
            and not p.lower <= fit.values[candidate_indices[0]] + step[candidate_indices[0]] <= p.upper
        ):
            gain, step = 0.0, np.zeros_like(step)
        start = ProfilePoint(fit.values, white, jacobian)
        additions.append(
            _AddedCandidate(
                candidate, free, without_prior, {i: rates[i] for i in candidate_indices}, start, gain, step
            )
        )
    return additions


def _minima(
    store: FitStore, profiles: Profiles, additions: Sequence[_AddedCandidate], fit: Fit
) -> list[tuple[ProfilePoint, float]]:
    """Return the point where each candidate leaves the smallest sum of squares, and the decrease still possible.

    It is the fit itself if a candidate promises little.
    """
    fitter = store.fitter
    minima = [(addition.start, addition.gain if addition.gain <= MIN_GAIN else 0.0) for addition in additions]
    worthwhile = [
        k
        for k, addition in enumerate(additions)
        if addition.gain > MIN_GAIN and set(addition.free) != set(fit.free)
    ]
    values: dict[int, Array] = {}
    starts = []
    for k in worthwhile:
        hypothesis = fit.hypothesis.with_cause(additions[k].candidate)
        previous = store.fit(hypothesis) if store.is_fitted(hypothesis) else None
        if previous is not None:
            values[k] = previous.values
        else:
            start = np.clip(fit.values + additions[k].step, fitter.lower, fitter.upper)
            starts.append((k, hypothesis, start))
    descents = fitter.rough_descents([(hypothesis, start) for _, hypothesis, start in starts])
    values |= {k: descent.values for (k, _, _), descent in zip(starts, descents, strict=True)}
    points = profiles.points(
        [ModelRequest(values[k], additions[k].free, additions[k].without_prior) for k in worthwhile]
    )
    for k, point in zip(worthwhile, points, strict=True):
        if point is not None and point.squares < minima[k][0].squares:
            minima[k] = point, 0.0
    return minima


def _side(
    fitter: Fitter, addition: _AddedCandidate, minimum: ProfilePoint, i: int, sign: int, rise: float
) -> Side | None:
    """Return one side of a parameter; None if there is nothing on that side."""
    p, max_deviation = (
        fitter.parameters[i],
        max_plausible_deviation(fitter, addition.candidate, i, sign, addition.rates[i]),
    )
    if not 0.0 < max_deviation < np.inf:
        return None
    return Side(
        i,
        p.value,
        sign,
        addition.free,
        addition.without_prior,
        max_deviation,
        minimum,
        minimum.squares + rise,
    )


def _linear_model_suffices(fitter: Fitter, side: Side, addition: _AddedCandidate, end: End) -> bool:
    """Return whether the end of the linear model is accurate: a small change of a declared value, or no change."""
    column = side.minimum.jacobian[:, side.free.index(side.index)]
    if not column[: fitter.prior_slice.start].any():
        return True
    p = fitter.parameters[side.index]
    starts_at_bound = p.value <= p.lower or p.value >= p.upper
    change = end.size * addition.rates[side.index]
    return (
        not starts_at_bound
        and end.bounded
        and change**2 < MAX_SECOND_ORDER * float(fitter.observations.sigma.min())
    )


def _bound(
    fitter: Fitter, fit: Fit, addition: _AddedCandidate, i: int, ends: Sequence[tuple[Side, End]]
) -> Bound:
    bounded = bool(ends) and all(end.bounded for _, end in ends)
    size = max(end.size for _, end in ends) if bounded else None
    value_shifts, unbounded_shifts = np.zeros((2, len(fit.values)))
    nuisances = [k for k in fit.free if k != i]
    has_prior = np.array([fitter.priors.row_of(k) is not None for k in nuisances], dtype=bool)
    for _, end in ends:
        factor = 1.0
        if addition.without_prior:  # the prior of the candidate limits its effect
            row = fitter.priors.row_of(i)
            prior_limit = (
                np.inf if row is None else ONE_SIDED_SIGMAS * fitter.priors.sigmas_in_units(fit.values)[row]
            )
            factor = float(1.0 / np.hypot(1.0, end.size / prior_limit))
        shift = factor * np.abs(end.values - fit.values)[nuisances]
        is_determined = has_prior | (end.bounded and end.reached)
        value_shifts[nuisances] = np.maximum(value_shifts[nuisances], np.where(is_determined, shift, 0.0))
        unbounded_shifts[nuisances] = np.maximum(
            unbounded_shifts[nuisances], np.where(is_determined, 0.0, shift)
        )
    max_deviation = max((side.max_size for side, _ in ends), default=np.inf)
    return Bound(
        addition.candidate,
        i,
        size,
        max_deviation,
        addition.rates[i] * (size or 0.0),
        value_shifts,
        unbounded_shifts,
    )
