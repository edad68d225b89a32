r"""Ends of profile-likelihood intervals of many parameters, found in lockstep.

The profile of a parameter :math:`\theta` is :math:`p(\theta) = \min_\nu \chi^2(\theta, \nu)`, its nuisances
:math:`\nu` refitted at each value.  An end of the interval is where it has risen from its least to a given sum of
squares.  With the whitened residual r and its derivatives g and N linearised at a point, and A and B the components
of r and g outside the span of N,

.. math:: p(\theta + d) \approx |A + B d|^2 ,

which is solved for d on the outer side, with the nuisances that belong to it: the step of Venzon and Moolgavkar (A
method for computing profile-likelihood-based confidence intervals, Applied Statistics 37, 1988) with the Gauss-Newton
Hessian.  The model is then evaluated there, until p is the required sum; a bracket safeguards steps of poor models.
Evaluating all ends together takes little longer than evaluating one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Array

#: Largest number of evaluations for an end.
MAX_EVALUATIONS = 12
#: An end is found if its sum of squares is wrong by less than this part of the rise, and the nuisances could lower it
#: by no more than this: a tenth moves the end by a twentieth.
END_TOLERANCE = 0.1
#: Largest step outwards, relative to the size reached.
MAX_GROWTH = 8.0
#: Part of a step that remains after a retreat, where the model cannot be evaluated, and where it is lost.
RETREAT_FRACTION = 0.5
FAR_RETREAT_FRACTION = 0.125
#: The model is lost where more than this part of the rise of its sum of squares comes from measured modes without a
#: partner: their residuals depend on no value, so no refit leads back.
LOST_FRACTION = 0.5
#: Relative singular value below which a combination of nuisances has no effect.
MIN_SINGULAR_VALUE = 1e-9


class ModelRequest(NamedTuple):
    """Values at which a model is requested, its free parameters, and those whose priors are left out."""

    values: Array
    free: tuple[int, ...]
    without_prior: tuple[int, ...]


class ProfilePoint(NamedTuple):
    """A model at some values: whitened residual (D,) and its derivatives (D, k) with respect to the free ones."""

    values: Array
    white: Array
    jacobian: Array

    @property
    def squares(self) -> float:
        """Sum of squares."""
        return float(self.white @ self.white)

    @property
    def fixed_squares(self) -> float:
        """Sum of the squares that depend on no value."""
        fixed_residual = self.white[~self.jacobian.any(axis=1)]
        return float(fixed_residual @ fixed_residual)


@dataclass(frozen=True)
class Side:
    """One end of an interval to be found.

    - index: the parameter, one of the free ones
    - declared: its declared value: sizes are distances from it
    - sign: side of the declared value
    - free: indices of all free parameters
    - without_prior: parameters to be taken without their priors
    - max_size: largest plausible size on this side
    - minimum: point of the smallest sum of squares
    - target: sum of squares at the end
    """

    index: int
    declared: float
    sign: int
    free: tuple[int, ...]
    without_prior: tuple[int, ...]
    max_size: float
    minimum: ProfilePoint
    target: float

    @property
    def rise(self) -> float:
        """Rise of the sum of squares to the end."""
        return self.target - self.minimum.squares

    def size(self, values: Array) -> float:
        """Return the size of the parameter on this side."""
        return float(self.sign * (values[self.index] - self.declared))


@dataclass(frozen=True)
class End:
    """An end that was found, or the largest plausible size if the sum of squares does not rise enough before it.

    - values: all parameters there, the nuisances refitted, (P,)
    - size: distance from the declared value
    - bounded: whether the data bound the parameter within its plausible range
    - reached: whether the values are those at the end.  Otherwise the size is the smallest known to be outside, and
      the values are the farthest known to be inside.
    """

    values: Array
    size: float
    bounded: bool
    reached: bool = True


class ProfileStep(NamedTuple):
    """The linear model of a profile at a point.

    - profile: least sum of squares with the parameter where it is
    - excess: sum of squares at the point less the profile
    - slope, curvature: the profile changes by 2 slope d + curvature d^2
    - nuisance_step: change of all parameters that refits the nuisances, (P,)
    - step_per_unit: change of all parameters per unit of the parameter, (P,)
    """

    profile: float
    excess: float
    slope: float
    curvature: float
    nuisance_step: Array
    step_per_unit: Array


class Profiles:
    """Profiles around one fit, with the covariance of the data as in that fit."""

    def __init__(self, fitter: Fitter, fit: Fit) -> None:
        self.fitter, self.fit = fitter, fit
        self._used_row_mask, self._whitening = fitter.used_row_mask(fit.hypothesis), fitter.whitening(fit)

    def points(self, requests: Sequence[ModelRequest]) -> list[ProfilePoint | None]:
        """Evaluate the model at several values, each with its free parameters and those without a prior."""
        points: list[ProfilePoint | None] = [None] * len(requests)
        fitter, free_parameters = self.fitter, [request.free for request in requests]
        values, used_row_masks = (
            np.array([request.values for request in requests]),
            [self._used_row_mask] * len(requests),
        )
        priors, whitened = fitter.priors, self._whitening.whitened
        for evaluation in fitter.observations.evaluate_many(
            fitter.structure, values, free_parameters, used_row_masks
        ):
            request = requests[evaluation.set_index]
            white = np.concatenate([whitened(evaluation.residual), priors.residual(request.values)])
            jacobian = np.vstack([-whitened(evaluation.rates), priors.rates(request.values, request.free)])
            points[evaluation.set_index] = ProfilePoint(
                request.values, *without_priors(fitter, white, jacobian, request.without_prior)
            )
        return points

    def linear_end(self, side: Side) -> End:
        """Return an end of the model linearised at the least sum of squares."""
        step = self._step(side, side.minimum)
        size = min(_outer_size(side, side.minimum, step), side.max_size)
        return End(self._values_at_size(side, side.minimum, step, size), size, size < side.max_size)

    def ends(self, sides: Sequence[Side]) -> list[End]:
        """Return the ends of all sides."""
        searches = [_EndSearch.start(side, self.linear_end(side)) for side in sides]
        for _ in range(MAX_EVALUATIONS):
            open_searches = [search for search in searches if search.end is None]
            if not open_searches:
                break
            points = self.points(
                [
                    ModelRequest(search.next_values, search.side.free, search.side.without_prior)
                    for search in open_searches
                ]
            )
            for search, point in zip(open_searches, points, strict=True):
                self._use_point(search, point)
        return [search.end or search.unreached_end() for search in searches]

    def _use_point(self, search: _EndSearch, point: ProfilePoint | None) -> None:
        """Use the model at the proposed values, None if it cannot be evaluated there, and propose the next ones."""
        side, size = search.side, search.size
        if point is None:
            search.outside, search.astray = size, False
            search.retreat(RETREAT_FRACTION)
            return
        step = self._step(side, point)
        refitted_values = self._values_at_size(side, point, step, size)
        error = step.profile - side.target
        if step.excess > END_TOLERANCE * side.rise:
            # The same size again: the linear model is poor this far from the refitted nuisances.
            search.next_values = refitted_values
        elif abs(error) <= END_TOLERANCE * side.rise:
            search.end = End(refitted_values, size, True)
        elif error < 0.0 and size >= side.max_size:
            search.end = End(refitted_values, size, False)
        else:
            search.bracket(refitted_values, error < 0.0)
            largest_size = size + MAX_GROWTH * max(abs(size), abs(search.linear_size))
            next_size = min(_outer_size(side, point, step), side.max_size, largest_size)
            is_lost = point.fixed_squares - side.minimum.fixed_squares > LOST_FRACTION * (
                point.squares - side.minimum.squares
            )
            if error > 0.0 and is_lost:
                search.astray |= search.outside == size
                search.retreat(FAR_RETREAT_FRACTION)
                return
            if not search.inside < next_size < search.outside:
                next_size = 0.5 * (search.inside + search.outside)
            search.next_values = self._values_at_size(side, point, step, next_size)

    def _step(self, side: Side, point: ProfilePoint) -> ProfileStep:
        """Return the linear model of a profile at a point."""
        column = side.free.index(side.index)
        nuisances = [k for k in range(len(side.free)) if k != column]
        index = [side.free[k] for k in nuisances]
        g, N = point.jacobian[:, column], point.jacobian[:, nuisances]
        nuisance_values, lower, upper = (
            point.values[index],
            self.fitter.lower[index],
            self.fitter.upper[index],
        )
        nuisance_step, step_per_unit = np.zeros(len(nuisances)), np.zeros(len(nuisances))
        is_free = np.ones(len(nuisances), dtype=bool)
        for _ in range(2):  # repeated without those that would leave their bounds
            columns = N[:, is_free]
            length = np.linalg.norm(columns, axis=0)
            scale = 1.0 / np.where(length > 0.0, length, 1.0)
            residual_and_gradient = np.stack([point.white, g], axis=1)
            solved = (
                -np.linalg.lstsq(columns * scale, residual_and_gradient, rcond=MIN_SINGULAR_VALUE)[0]
                * scale[:, None]
            )
            nuisance_step[:], step_per_unit[:] = 0.0, 0.0
            nuisance_step[is_free], step_per_unit[is_free] = solved.T
            reaches_bound = is_free & (
                ((nuisance_values <= lower) & (nuisance_step < 0.0))
                | ((nuisance_values >= upper) & (nuisance_step > 0.0))
            )
            if not reaches_bound.any():
                break
            is_free &= ~reaches_bound
        a, b = point.white + N @ nuisance_step, g + N @ step_per_unit
        changes = np.zeros((2, len(point.values)))
        changes[0, index], changes[1, index], changes[1, side.index] = nuisance_step, step_per_unit, 1.0
        profile = float(a @ a)
        return ProfileStep(profile, point.squares - profile, float(a @ b), float(b @ b), *changes)

    def _values_at_size(self, side: Side, point: ProfilePoint, step: ProfileStep, size: float) -> Array:
        """Return the values at a size of the parameter, with the nuisances refitted in the linear model."""
        value = side.declared + side.sign * size
        values = point.values + step.nuisance_step + step.step_per_unit * (value - point.values[side.index])
        bounded_values: Array = np.clip(values, self.fitter.lower, self.fitter.upper)
        bounded_values[side.index] = value
        return bounded_values


@dataclass
class _EndSearch:
    """The search for one end.

    - next_values: values to be evaluated next, (P,)
    - inside, outside: largest size known to be in the interval, and smallest one known not to be
    - inside_values: values at the size inside, (P,)
    - linear_size: size in the linear model
    - astray: whether the nuisances were not refitted at the smallest size outside: it may be inside after all
    """

    side: Side
    next_values: Array
    inside: float
    inside_values: Array
    linear_size: float
    outside: float = np.inf
    astray: bool = False
    end: End | None = None

    @classmethod
    def start(cls, side: Side, linear: End) -> _EndSearch:
        """Begin at the end of the linear model."""
        return cls(side, linear.values, side.size(side.minimum.values), side.minimum.values, linear.size)

    @property
    def size(self) -> float:
        """Size to be evaluated next."""
        return self.side.size(self.next_values)

    def bracket(self, values: Array, is_inside: bool) -> None:
        """Narrow the bracket at the size that was evaluated."""
        if is_inside:
            self.inside, self.inside_values = self.size, values
        elif self.size < self.outside:
            self.outside, self.astray = self.size, False

    def retreat(self, part: float) -> None:
        """Propose values nearer to those known to be in the interval, at a part of the way from these."""
        self.next_values = self.inside_values + part * (self.next_values - self.inside_values)

    def unreached_end(self) -> End:
        """Return the end as far as it is known, too large rather than too small."""
        bounded = bool(np.isfinite(self.outside)) and not self.astray
        return End(
            self.inside_values, self.outside if bounded else self.side.max_size, bounded, reached=False
        )


def without_priors(
    fitter: Fitter, white: Array, jacobian: Array, index: Sequence[int]
) -> tuple[Array, Array]:
    """Return residual and derivatives without the priors of some parameters."""
    rows = fitter.priors.rows(index)
    if rows:
        prior_rows = fitter.prior_slice.start + np.array(rows)
        white, jacobian = white.copy(), jacobian.copy()
        white[prior_rows], jacobian[prior_rows] = 0.0, 0.0
    return white, jacobian


def _outer_size(side: Side, point: ProfilePoint, step: ProfileStep) -> float:
    """Return the size at which the linear model reaches the required sum of squares on the outer side."""
    size, slope, excess = side.size(point.values), side.sign * step.slope, step.profile - side.target
    if step.curvature <= 0.0:
        return np.inf if excess < 0.0 else size
    root = slope**2 - step.curvature * excess
    return float(size + (-slope + np.sqrt(root)) / step.curvature) if root >= 0.0 else size
