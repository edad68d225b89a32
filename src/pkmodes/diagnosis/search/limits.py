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

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.fit.profile import NOTHING, Asked, End, Point, Profiles, Side, without_priors
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.problem import Array, Assumption, Candidate
from pkmodes.diagnosis.search.ranges import largest_rates, plausible_size

#: Standard deviations of a one-sided bound at 95 %.
ONE_SIDED = float(stats.norm.ppf(0.95))
#: A value that nobody declared may be another by this factor, such as the mass of the frame of a small printer.
DEFAULT_FACTOR = 10.0
#: If the linear model promises less than this sum of squares, the fit without the candidate is as good as with it.
SMALL = 0.5
#: The linear model suffices if its second order, the square of the largest relative change of a frequency, is below
#: this part of the smallest standard deviation.
SECOND_ORDER = 0.1


@dataclass(frozen=True)
class Bound:
    """How large one parameter of a candidate may still be.

    Attributes
    ----------
    index : int
        The parameter.
    size : float or None
        Largest deviation from the declared value at 95 %; None if the data do not bound it within its plausible
        range.
    plausible : float
        Largest plausible deviation; infinite if unknown.
    change : float
        Relative change of some frequency at the limit, in the linear model; 0 without a limit.
    moved : ndarray, shape (P,)
        By how much all fitted values move when the candidate has this size; values with a prior also if it has the
        largest plausible one, because their priors hold them.
    farther : ndarray, shape (P,)
        By how much values without a prior move, at least, if the data do not bound the candidate.
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

    Attributes
    ----------
    free, own, rates
        Free parameters, those without a prior, and the largest derivatives of ln f by parameter.
    at : Point
        At that fit.
    gain : float
        Decrease of the sum of squares that the linear model promises.
    step : ndarray, shape (P,)
        The change of all values that promises it.
    """

    candidate: Candidate
    free: tuple[int, ...]
    own: tuple[int, ...]
    rates: dict[int, float]
    at: Point
    gain: float
    step: Array

    @property
    def linear(self) -> Point:
        """The least of the linear model."""
        white = self.at.white + self.at.jacobian @ self.step[list(self.free)]
        return Point(self.at.values + self.step, white, self.at.jacobian)


def bounds(
    store: FitStore, fit: Fit, candidates: Sequence[Candidate], *, noise: bool = True, linear: bool = False
) -> list[Bound]:
    """Return the bounds of all parameters of some candidates beside a fit.

    Parameters
    ----------
    noise : bool
        Whether the residual of the fit is noise.  If not, the errors count as large as what each candidate leaves.
    linear : bool
        Whether to use the model linearised at the fit only, for models that are slow to evaluate.
    """
    fitter = store.fitter
    if not candidates:
        return []
    profiles = Profiles(fitter, fit)
    beside = _beside(fitter, fit, candidates)
    least = [(one.linear, 0.0) for one in beside] if linear else _least(store, profiles, beside, fit)
    sides, owners = [], []
    for one, (point, gain) in zip(beside, least, strict=True):
        ratio = 1.0 if noise else _ratio(store, fit, one, point)
        for i in fitter.indices(one.candidate):
            for sign in (1, -1):
                side = _side(fitter, one, point, i, sign, ratio * ONE_SIDED**2 - gain)
                if side is not None:
                    sides.append(side)
                    owners.append(one)
    found = [profiles.linear(side) for side in sides]
    each = zip(sides, owners, found, strict=True)
    refined = [k for k, (s, one, e) in enumerate(each) if not linear and not _suffices(fitter, s, one, e)]
    for k, end in zip(refined, profiles.ends([sides[k] for k in refined]), strict=True):
        found[k] = end
    ends: dict[tuple[str, int], list[tuple[Side, End]]] = {}
    for one, side, end in zip(owners, sides, found, strict=True):
        ends.setdefault((one.candidate.name, side.index), []).append((side, end))
    return [
        _bound(fitter, fit, one, i, ends.get((one.candidate.name, i), []))
        for one in beside
        for i in fitter.indices(one.candidate)
    ]


def moved_by_defaults(store: FitStore, fit: Fit) -> dict[Assumption, Array]:
    """Return by how much the values of a fit move when a default that its causes assume is another, (P,) each.

    The default moves to its own end at 95 %, but at most by a factor of `DEFAULT_FACTOR`, in both directions.
    """
    fitter = store.fitter
    known = {p.name: i for i, p in enumerate(fitter.parameters)}
    moved = {}
    for assumption in dict.fromkeys(one for cause in fit.causes for one in cause.assumes):
        index = known.get(assumption.parameter)
        if index is None or index in fit.free:
            continue
        declared = fitter.parameters[index].value
        constant = Candidate(assumption.parameter, (assumption.parameter,))
        (one,) = _beside(fitter, fit, [constant])
        sides = [
            Side(index, declared, sign, one.free, (), most, one.at, one.at.squares + ONE_SIDED**2)
            for sign, most in (
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
    found = []
    for candidate in candidates:
        index = fitter.indices(candidate)
        new = [i for i in index if i not in fit.free]
        free, own = (*fit.free, *new), index if candidate.sigma is not None else ()
        jacobian = np.hstack([fit.jacobian, -raw[:, [by.index(i) for i in new]]])
        white, jacobian = without_priors(fitter, fit.white, jacobian, own)
        step = np.zeros_like(fit.values)
        length = np.linalg.norm(jacobian, axis=0)
        scale = 1.0 / np.where(length > 0.0, length, 1.0)
        step[list(free)] = -np.linalg.lstsq(jacobian * scale, white, rcond=NOTHING)[0] * scale
        left = white + jacobian @ step[list(free)]
        gain = float(white @ white - left @ left)
        p = fitter.parameters[index[0]]
        if len(index) == 1 and not p.lower <= fit.values[index[0]] + step[index[0]] <= p.upper:
            gain, step = 0.0, np.zeros_like(step)
        at = Point(fit.values, white, jacobian)
        found.append(_Beside(candidate, free, own, {i: rates[i] for i in index}, at, gain, step))
    return found


def _least(
    store: FitStore, profiles: Profiles, beside: Sequence[_Beside], fit: Fit
) -> list[tuple[Point, float]]:
    """Return where each candidate leaves the least, and by how much less it could still be.

    It is the fit itself if a candidate promises little.
    """
    fitter = store.fitter
    least = [(one.at, one.gain if one.gain <= SMALL else 0.0) for one in beside]
    asked = [k for k, one in enumerate(beside) if one.gain > SMALL and set(one.free) != set(fit.free)]
    values: dict[int, Array] = {}
    starts = []
    for k in asked:
        hypothesis = fit.hypothesis.adding(beside[k].candidate)
        known = store.fit(hypothesis) if store.known(hypothesis) else None
        if known is not None:
            values[k] = known.values
        else:
            start = np.clip(fit.values + beside[k].step, fitter.lower, fitter.upper)
            starts.append((k, hypothesis, start))
    descents = fitter.roughly([(hypothesis, start) for _, hypothesis, start in starts])
    values |= {k: descent.values for (k, _, _), descent in zip(starts, descents, strict=True)}
    points = profiles.points([Asked(values[k], beside[k].free, beside[k].own) for k in asked])
    for k, point in zip(asked, points, strict=True):
        if point is not None and point.squares < least[k][0].squares:
            least[k] = point, 0.0
    return least


def _ratio(store: FitStore, fit: Fit, one: _Beside, least: Point) -> float:
    """Return chi2 per degree of freedom that a candidate leaves, at least 1."""
    free = sum(store.fitter.priors.of(i) is None for i in one.free if i not in fit.free)
    return max(1.0, least.squares / max(store.degrees(fit) - free, 1))


def _side(fitter: Fitter, one: _Beside, least: Point, i: int, sign: int, rise: float) -> Side | None:
    """Return one side of a parameter; None if there is nothing on that side."""
    p, most = fitter.parameters[i], plausible_size(fitter, one.candidate, i, sign, one.rates[i])
    if not 0.0 < most < np.inf:
        return None
    return Side(i, p.value, sign, one.free, one.own, most, least, least.squares + rise)


def _suffices(fitter: Fitter, side: Side, one: _Beside, end: End) -> bool:
    """Return whether the end of the linear model is accurate: a small change of a declared value, or no change."""
    column = side.least.jacobian[:, side.free.index(side.index)]
    if not column[: fitter.prior_rows.start].any():
        return True
    p = fitter.parameters[side.index]
    absent = p.value <= p.lower or p.value >= p.upper
    change = end.size * one.rates[side.index]
    return not absent and end.bounded and change**2 < SECOND_ORDER * float(fitter.observations.sigma.min())


def _bound(fitter: Fitter, fit: Fit, one: _Beside, i: int, ends: Sequence[tuple[Side, End]]) -> Bound:
    bounded = bool(ends) and all(end.bounded for _, end in ends)
    size = max(end.size for _, end in ends) if bounded else None
    moved, farther = np.zeros((2, len(fit.values)))
    others = [k for k in fit.free if k != i]
    held = np.array([fitter.priors.of(k) is not None for k in others], dtype=bool)
    for _, end in ends:
        part = 1.0
        if one.own:  # the prior of the candidate narrows what it may do
            row = fitter.priors.of(i)
            width = np.inf if row is None else ONE_SIDED * fitter.priors.width(fit.values)[row]
            part = float(1.0 / np.hypot(1.0, end.size / width))
        by = part * np.abs(end.values - fit.values)[others]
        at_end = held | (end.bounded and end.reached)
        moved[others] = np.maximum(moved[others], np.where(at_end, by, 0.0))
        farther[others] = np.maximum(farther[others], np.where(at_end, 0.0, by))
    most = max((side.most for side, _ in ends), default=np.inf)
    return Bound(one.candidate, i, size, most, one.rates[i] * (size or 0.0), moved, farther)
