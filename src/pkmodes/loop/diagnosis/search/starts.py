"""Start values of a refit with one more cause.

The linear estimate is accurate for small changes.  An absent cause may be large: several sizes are tried, and refined
around the best, because an added mode fits at one size only.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.score import Score, one_sided

#: Sizes of a one-sided cause that are tried first, as the frequency change that the linear model predicts.
SIZES = np.geomspace(0.003, 30.0, 12)
#: The same for a cause that adds modes: these change a frequency only when they come near it.  Neighbouring sizes
#: differ by a quarter, and the frequencies of the added modes by an eighth.
CLOSE_SIZES = np.geomspace(5e-5, 0.5, 42)
#: The grid is refined by HALVINGS bisections around the best VALLEYS sizes with sums of squares up to SLOPE times the
#: least: such a mode fits in a narrow valley, and a grid hits only its slopes.
VALLEYS, SLOPE = 6, 4.0
HALVINGS = 3
#: Part of the size of a one-sided cause that is kept when another cause is tried beside it.
SHARE = 0.4
#: Number of starts from which a cause that adds modes is refitted.
FITTED = 3


#: Values to compare, their sums of squares, and the resulting starts.
Trials = Generator[list[Array], list[float], list[Array]]


def starts(fitter: Fitter, additions: Sequence[tuple[Fit, Score, Hypothesis]]) -> list[list[Array]]:
    """Return start values of all parameters for refits, most promising first.

    The trials of all refits are evaluated together.

    - additions: fit to which a cause is added, score of that cause at this fit, and hypothesis with the cause
    """
    scout, best = fitter.scout, [list[Array]() for _ in additions]
    searches = {k: _search(fitter, *addition) for k, addition in enumerate(additions)}
    costs: dict[int, list[float] | None] = dict.fromkeys(searches)
    while searches:
        trials: dict[int, list[Array]] = {}
        for k in list(searches):
            try:
                sums = costs[k]
                trials[k] = next(searches[k]) if sums is None else searches[k].send(sums)
            except StopIteration as end:
                best[k] = end.value
                del searches[k]
        # Excluded rows are dropped for fewer setups, where rows are numbered differently.
        bare = {k: h if scout is fitter else Hypothesis(h.causes) for k, (_, _, h) in enumerate(additions)}
        evaluated = scout.chi2_of_many(
            [(bare[k], values) for k, points in trials.items() for values in points]
        )
        results = iter(evaluated)
        costs = {k: [next(results) for _ in points] for k, points in trials.items()}
    return best


def _search(fitter: Fitter, fit: Fit, entry: Score, hypothesis: Hypothesis) -> Trials:
    """Yield trial values of one refit, and return its starts."""
    index = list(fitter.indices(entry.candidate))
    # The first parameter of a cause determines its size.
    sign = one_sided(fitter, replace(entry.candidate, parameters=entry.candidate.parameters[:1]))
    unit, sizes = np.zeros(len(index)), SIZES
    sized = bool(sign) and entry.largest[0] > 0.0
    if sized:
        unit[0] = sign / entry.largest[0]
        values = fit.values.copy()
        values[index[0]] += float(SIZES[0] * unit[0])
        count = fitter.structure.predict(values, ()).eigenvalues.shape[1]
        if count > fit.prediction.eigenvalues.shape[1]:  # the cause adds modes
            sizes = CLOSE_SIZES
    ranked: list[tuple[float, Array]] = []
    for origin in _origins(fitter, fit, sign):

        def at(step: Array, origin: Array = origin) -> Array:
            full = origin.copy()
            full[index] = np.clip(fit.values[index] + step, fitter.lower[index], fitter.upper[index])
            return full

        steps = [entry.step, 0.5 * entry.step]
        if sized and sizes is CLOSE_SIZES and not fit.causes:
            best = yield from _least(CLOSE_SIZES, unit, at)
            steps += [size * unit for size in best]
        elif sized:  # there are many pairs, and only those that the linear model favours are tried
            costs = yield [at(size * unit) for size in SIZES]
            steps.append(SIZES[int(np.argmin(costs))] * unit)
        trials = [at(step) for step in steps]
        sums = yield trials
        here = sorted(zip(sums, trials, strict=True), key=lambda pair: pair[0])
        # Near the distorted values of the fit, a large cause ends where it began: one best start for each origin.
        ranked += here if sizes is CLOSE_SIZES and not fit.causes else here[:1]
    ranked.sort(key=lambda pair: pair[0])
    return [values for _, values in ranked[:FITTED]]


def _origins(fitter: Fitter, fit: Fit, sign: int) -> list[Array]:
    """Return values of the other parameters for trying a cause: those of the fit, and less distorted ones."""
    undistorted = fit.values.copy()
    if not fit.causes:  # a large missing cause drives the nuisances far from their declared values
        nuisances = list(fitter.nuisances)
        undistorted[nuisances] = fitter.declared[nuisances]
    elif sign:  # a cause that stands for two is too large
        for cause in fit.causes:
            if one_sided(fitter, cause):
                index = list(fitter.indices(cause))
                undistorted[index] = fitter.declared[index] + SHARE * (
                    fit.values[index] - fitter.declared[index]
                )
    return [fit.values] if np.array_equal(undistorted, fit.values) else [fit.values, undistorted]


def _least(
    sizes: Array, unit: Array, at: Callable[[Array], Array]
) -> Generator[list[Array], list[float], list[float]]:
    """Return the sizes of the best local minima on a grid, refined around them."""
    sums = dict(zip(sizes.tolist(), (yield [at(size * unit) for size in sizes]), strict=True))
    centres = [size for size in _minima(sums)[:VALLEYS] if sums[size] <= SLOPE * min(sums.values())]
    for _ in range(HALVINGS):
        ordered = sorted(sums)
        places = [ordered.index(centre) for centre in centres]
        beside = [
            ordered[k : k + 2] for place in places for k in (place - 1, place) if 0 <= k < len(ordered) - 1
        ]
        middles = sorted({float(np.sqrt(low * high)) for low, high in beside})
        sums |= dict(zip(middles, (yield [at(size * unit) for size in middles]), strict=True))
        ordered = sorted(sums)
        around = [ordered[max(ordered.index(centre) - 1, 0) :][:3] for centre in centres]
        centres = [min(neighbours, key=lambda size: sums[size]) for neighbours in around]
    return centres


def _minima(sums: dict[float, float]) -> list[float]:
    """Return the sizes with smaller sums of squares than their neighbours, best first."""
    sizes = sorted(sums)
    costs = [np.inf, *(sums[size] for size in sizes), np.inf]
    minima = [size for i, size in enumerate(sizes, start=1) if costs[i] <= min(costs[i - 1], costs[i + 1])]
    return sorted(minima, key=lambda size: sums[size])
