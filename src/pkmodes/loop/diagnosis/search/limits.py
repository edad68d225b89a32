r"""How large candidates may still be beside a fit, and what they would do to the fitted values.

The limit of a parameter is the end, at 95 % and one-sided, of its profile likelihood (`fit.profile`): the largest
size at which the candidate, fitted together with everything that was fitted before, leaves a sum of squares at most
:math:`1.645^2` above its least.  A parameter that may have both signs is bounded on both sides, and its limit is the
larger size: the same test of :math:`|\theta|`.  At a physical bound, such as no compliance at all, the test is that
of Cowan, Cranmer, Gross and Vitells (Asymptotic formulae for likelihood-based tests of new physics, European Physical
Journal C 71, 2011, 1554, equation 16): the limit covers too often rather than too seldom.

The prior of a candidate takes no part in its limit, which says what these data exclude.
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
from pkmodes.loop.diagnosis.search.ranges import largest_rates, plausible_size

#: Standard deviations of a one-sided bound at 95 %.
ONE_SIDED = float(stats.norm.ppf(0.95))
#: Factor by which a value that nobody declared may be wrong, such as the mass of the frame of a small printer.
DEFAULT_FACTOR = 10.0
#: If the linear model promises less than this sum of squares, the fit without the candidate is as good as with it.
SMALL = 0.5
#: The linear model suffices if its second order, the square of the largest relative change of a frequency, is below
#: this part of the smallest standard deviation.
SECOND_ORDER = 0.1


@dataclass(frozen=True)
class Bound:
    """How large one parameter of a candidate may still be.

    - index: the parameter
    - size: largest deviation from the declared value at 95 %; None if the data do not bound it within its plausible
      range
    - plausible: largest plausible deviation; infinite if unknown
    - change: relative change of some frequency at the limit, in the linear model; 0 without a limit
    - moved: how far all fitted values move when the candidate has this size, (P,); values with a prior also if it has
      the largest plausible size, because their priors hold them
    - farther: how far, at least, values without a prior move if the data do not bound the candidate, (P,)
    """

    candidate: Candidate
    index: int
    size: float | None
    plausible: float
    change: float
    moved: Array
    farther: Array


@dataclass(frozen=True)
class _Beside:
    """A candidate beside a fit.

    - free, without_prior, rates: free parameters, those to be taken without their priors, and the largest derivatives
      of ln f by parameter
    - at: the model at that fit
    - gain: decrease of the sum of squares that the linear model promises
    - step: the corresponding change of all values, (P,)
    """

    candidate: Candidate
    free: tuple[int, ...]
    without_prior: tuple[int, ...]
    rates: dict[int, float]
    at: ProfilePoint
    gain: float
    step: Array

    @property
    def linear(self) -> ProfilePoint:
        """The minimum of the linear model."""
        white = self.at.white + self.at.jacobian @ self.step[list(self.free)]
        return ProfilePoint(self.at.values + self.step, white, self.at.jacobian)


def bounds(
    store: FitStore, fit: Fit, candidates: Sequence[Candidate], *, noise: bool = True, linear: bool = False
) -> list[Bound]:
    """Return the bounds of all parameters of some candidates beside a fit.

    - noise: whether the residual of the fit is noise.  If not, errors are scaled to what each candidate leaves.
    - linear: whether to use the model linearised at the fit only, for models that are slow to evaluate
    """
    fitter = store.fitter
    if not candidates:
        return []
    profiles = Profiles(fitter, fit)
    beside = _beside(fitter, fit, candidates)
    least = [(entry.linear, 0.0) for entry in beside] if linear else _least(store, profiles, beside, fit)
    sides, owners = [], []
    for entry, (point, gain) in zip(beside, least, strict=True):
        ratio = 1.0
        if not noise:  # chi2 per degree of freedom that the candidate leaves
            free = sum(fitter.priors.row_of(i) is None for i in entry.free if i not in fit.free)
            ratio = max(1.0, point.squares / max(store.degrees(fit) - free, 1))
        for i in fitter.indices(entry.candidate):
            for sign in (1, -1):
                side = _side(fitter, entry, point, i, sign, ratio * ONE_SIDED**2 - gain)
                if side is not None:
                    sides.append(side)
                    owners.append(entry)
    located = [profiles.linear_end(side) for side in sides]
    triples = zip(sides, owners, located, strict=True)
    refined = [
        k for k, (s, entry, e) in enumerate(triples) if not linear and not _suffices(fitter, s, entry, e)
    ]
    for k, end in zip(refined, profiles.ends([sides[k] for k in refined]), strict=True):
        located[k] = end
    ends: dict[tuple[str, int], list[tuple[Side, End]]] = {}
    for entry, side, end in zip(owners, sides, located, strict=True):
        ends.setdefault((entry.candidate.name, side.index), []).append((side, end))
    return [
        _bound(fitter, fit, entry, i, ends.get((entry.candidate.name, i), []))
        for entry in beside
        for i in fitter.indices(entry.candidate)
    ]


def moved_by_defaults(store: FitStore, fit: Fit) -> dict[Assumption, Array]:
    """Return how far the values of a fit move when a default that its causes assume is wrong, (P,) for each.

    The default moves to its own limit at 95 %, but at most by a factor of `DEFAULT_FACTOR`, in both directions.
    """
    fitter = store.fitter
    indices = {p.name: i for i, p in enumerate(fitter.parameters)}
    moved = {}
    for assumption in dict.fromkeys(default for cause in fit.causes for default in cause.assumes):
        index = indices.get(assumption.parameter)
        if index is None or index in fit.free:
            continue
        declared = fitter.parameters[index].value
        constant = Candidate(assumption.parameter, (assumption.parameter,))
        (beside,) = _beside(fitter, fit, [constant])
        sides = [
            Side(index, declared, sign, beside.free, (), largest, beside.at, beside.at.squares + ONE_SIDED**2)
            for sign, largest in (
                (1, (DEFAULT_FACTOR - 1.0) * declared),
                (-1, (1.0 - 1.0 / DEFAULT_FACTOR) * declared),
            )
        ]
        ends = Profiles(fitter, fit).ends(sides)
        away = np.max([np.abs(end.values - fit.values) for end in ends], axis=0)
        away[index] = 0.0
        moved[assumption] = away
    return moved


def _beside(fitter: Fitter, fit: Fit, candidates: Sequence[Candidate]) -> list[_Beside]:
    by = list(dict.fromkeys(i for candidate in candidates for i in fitter.indices(candidate)))
    _, raw = fitter.signatures(fit, by)
    prediction = fitter.structure.predict(fit.values, by, shape_rates=fitter.observations.shape_rates)
    rates = dict(zip(by, largest_rates(prediction).tolist(), strict=True))
    entries = []
    for candidate in candidates:
        index = fitter.indices(candidate)
        new = [i for i in index if i not in fit.free]
        free, without_prior = (*fit.free, *new), index if candidate.sigma is not None else ()
        jacobian = np.hstack([fit.jacobian, -raw[:, [by.index(i) for i in new]]])
        white, jacobian = without_priors(fitter, fit.white, jacobian, without_prior)
        step = np.zeros_like(fit.values)
        length = np.linalg.norm(jacobian, axis=0)
        scale = 1.0 / np.where(length > 0.0, length, 1.0)
        step[list(free)] = -np.linalg.lstsq(jacobian * scale, white, rcond=MIN_SINGULAR_VALUE)[0] * scale
        residual = white + jacobian @ step[list(free)]
        gain = float(white @ white - residual @ residual)
        p = fitter.parameters[index[0]]
        if len(index) == 1 and not p.lower <= fit.values[index[0]] + step[index[0]] <= p.upper:
            gain, step = 0.0, np.zeros_like(step)
        at = ProfilePoint(fit.values, white, jacobian)
        entries.append(_Beside(candidate, free, without_prior, {i: rates[i] for i in index}, at, gain, step))
    return entries


def _least(
    store: FitStore, profiles: Profiles, beside: Sequence[_Beside], fit: Fit
) -> list[tuple[ProfilePoint, float]]:
    """Return the point where each candidate leaves the smallest sum of squares, and the decrease still possible.

    It is the fit itself if a candidate promises little.
    """
    fitter = store.fitter
    least = [(entry.at, entry.gain if entry.gain <= SMALL else 0.0) for entry in beside]
    worthwhile = [
        k for k, entry in enumerate(beside) if entry.gain > SMALL and set(entry.free) != set(fit.free)
    ]
    values: dict[int, Array] = {}
    starts = []
    for k in worthwhile:
        hypothesis = fit.hypothesis.with_cause(beside[k].candidate)
        previous = store.fit(hypothesis) if store.is_fitted(hypothesis) else None
        if previous is not None:
            values[k] = previous.values
        else:
            start = np.clip(fit.values + beside[k].step, fitter.lower, fitter.upper)
            starts.append((k, hypothesis, start))
    descents = fitter.rough_descents([(hypothesis, start) for _, hypothesis, start in starts])
    values |= {k: descent.values for (k, _, _), descent in zip(starts, descents, strict=True)}
    points = profiles.points(
        [ModelRequest(values[k], beside[k].free, beside[k].without_prior) for k in worthwhile]
    )
    for k, point in zip(worthwhile, points, strict=True):
        if point is not None and point.squares < least[k][0].squares:
            least[k] = point, 0.0
    return least


def _side(
    fitter: Fitter, beside: _Beside, least: ProfilePoint, i: int, sign: int, rise: float
) -> Side | None:
    """Return one side of a parameter; None if there is nothing on that side."""
    p, largest = fitter.parameters[i], plausible_size(fitter, beside.candidate, i, sign, beside.rates[i])
    if not 0.0 < largest < np.inf:
        return None
    return Side(i, p.value, sign, beside.free, beside.without_prior, largest, least, least.squares + rise)


def _suffices(fitter: Fitter, side: Side, beside: _Beside, end: End) -> bool:
    """Return whether the end of the linear model is accurate: a small change of a declared value, or no change."""
    column = side.minimum.jacobian[:, side.free.index(side.index)]
    if not column[: fitter.prior_rows.start].any():
        return True
    p = fitter.parameters[side.index]
    absent = p.value <= p.lower or p.value >= p.upper
    change = end.size * beside.rates[side.index]
    return not absent and end.bounded and change**2 < SECOND_ORDER * float(fitter.observations.sigma.min())


def _bound(fitter: Fitter, fit: Fit, beside: _Beside, i: int, ends: Sequence[tuple[Side, End]]) -> Bound:
    bounded = bool(ends) and all(end.bounded for _, end in ends)
    size = max(end.size for _, end in ends) if bounded else None
    moved, farther = np.zeros((2, len(fit.values)))
    nuisances = [k for k in fit.free if k != i]
    held = np.array([fitter.priors.row_of(k) is not None for k in nuisances], dtype=bool)
    for _, end in ends:
        part = 1.0
        if beside.without_prior:  # the prior of the candidate limits its effect
            row = fitter.priors.row_of(i)
            width = np.inf if row is None else ONE_SIDED * fitter.priors.sigmas_in_units(fit.values)[row]
            part = float(1.0 / np.hypot(1.0, end.size / width))
        by = part * np.abs(end.values - fit.values)[nuisances]
        at_end = held | (end.bounded and end.reached)
        moved[nuisances] = np.maximum(moved[nuisances], np.where(at_end, by, 0.0))
        farther[nuisances] = np.maximum(farther[nuisances], np.where(at_end, 0.0, by))
    plausible = max((side.largest for side, _ in ends), default=np.inf)
    return Bound(beside.candidate, i, size, plausible, beside.rates[i] * (size or 0.0), moved, farther)
