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
from pkmodes.loop.diagnosis.search.score import Score, allowed_sign

#: Sizes of a one-sided cause that are tried first, as the frequency change that the linear model predicts.
START_FREQUENCY_CHANGES = np.geomspace(0.003, 30.0, 12)
#: The same for a cause that adds modes: these change a frequency only when they come near it.  Neighbouring sizes
#: differ by a quarter, and the frequencies of the added modes by an eighth.
CLOSE_FREQUENCY_CHANGES = np.geomspace(5e-5, 0.5, 42)
#: The grid is refined by HALVINGS bisections around the best MAX_VALLEYS sizes with sums of squares up to
#: MAX_COST_RATIO times the least: such a mode fits in a narrow valley, and a grid hits only its slopes.
MAX_VALLEYS, MAX_COST_RATIO = 6, 4.0
HALVINGS = 3
#: Part of the size of a one-sided cause that is kept when another cause is tried in addition.
KEPT_PART_OF_SIZE = 0.4
#: Number of starts from which a cause that adds modes is refitted.
MAX_STARTS = 3


#: Values to compare, their sums of squares, and the resulting starts.
Trials = Generator[list[Array], list[float], list[Array]]


def starts(fitter: Fitter, additions: Sequence[tuple[Fit, Score, Hypothesis]]) -> list[list[Array]]:
    """Return start values of all parameters for refits, most promising first.

    The trials of all refits are evaluated together.

    - additions: fit to which a cause is added, score of that cause at this fit, and hypothesis with the cause
    """
    subsample_fitter, starts_of_addition = fitter.subsample_fitter, [list[Array]() for _ in additions]
    searches = {k: _search_starts(fitter, *addition) for k, addition in enumerate(additions)}
    costs: dict[int, list[float] | None] = dict.fromkeys(searches)
    while searches:
        trials: dict[int, list[Array]] = {}
        for k in list(searches):
            try:
                sums = costs[k]
                trials[k] = next(searches[k]) if sums is None else searches[k].send(sums)
            except StopIteration as search_end:
                starts_of_addition[k] = search_end.value
                del searches[k]
        # Excluded rows are dropped for fewer setups, where rows are numbered differently.
        hypotheses = {
            k: h if subsample_fitter is fitter else Hypothesis(h.causes)
            for k, (_, _, h) in enumerate(additions)
        }
        evaluated = subsample_fitter.chi2_of_many(
            [(hypotheses[k], values) for k, points in trials.items() for values in points]
        )
        results = iter(evaluated)
        costs = {k: [next(results) for _ in points] for k, points in trials.items()}
    return starts_of_addition


def _search_starts(fitter: Fitter, fit: Fit, candidate_score: Score, hypothesis: Hypothesis) -> Trials:
    """Yield trial values of one refit, and return its starts."""
    index = list(fitter.parameter_indices(candidate_score.candidate))
    # The first parameter of a cause determines its size.
    sign = allowed_sign(
        fitter, replace(candidate_score.candidate, parameters=candidate_score.candidate.parameters[:1])
    )
    unit, sizes = np.zeros(len(index)), START_FREQUENCY_CHANGES
    has_size = bool(sign) and candidate_score.largest_rates[0] > 0.0
    if has_size:
        unit[0] = sign / candidate_score.largest_rates[0]
        values = fit.values.copy()
        values[index[0]] += float(START_FREQUENCY_CHANGES[0] * unit[0])
        count = fitter.structure.predict(values, ()).eigenvalues.shape[1]
        if count > fit.prediction.eigenvalues.shape[1]:  # the cause adds modes
            sizes = CLOSE_FREQUENCY_CHANGES
    ranked: list[tuple[float, Array]] = []
    for origin in _origins(fitter, fit, sign):

        def values_at(step: Array, origin: Array = origin) -> Array:
            all_values = origin.copy()
            all_values[index] = np.clip(fit.values[index] + step, fitter.lower[index], fitter.upper[index])
            return all_values

        steps = [candidate_score.step, 0.5 * candidate_score.step]
        if has_size and sizes is CLOSE_FREQUENCY_CHANGES and not fit.causes:
            best = yield from _best_sizes(CLOSE_FREQUENCY_CHANGES, unit, values_at)
            steps += [size * unit for size in best]
        elif has_size:  # there are many pairs, and only those that the linear model favours are tried
            costs = yield [values_at(size * unit) for size in START_FREQUENCY_CHANGES]
            steps.append(START_FREQUENCY_CHANGES[int(np.argmin(costs))] * unit)
        trials = [values_at(step) for step in steps]
        sums = yield trials
        ranked_trials = sorted(zip(sums, trials, strict=True), key=lambda pair: pair[0])
        # Near the distorted values of the fit, a large cause ends where it began: one best start for each origin.
        ranked += ranked_trials if sizes is CLOSE_FREQUENCY_CHANGES and not fit.causes else ranked_trials[:1]
    ranked.sort(key=lambda pair: pair[0])
    return [values for _, values in ranked[:MAX_STARTS]]


def _origins(fitter: Fitter, fit: Fit, sign: int) -> list[Array]:
    """Return values of the other parameters for trying a cause: those of the fit, and less distorted ones."""
    less_distorted = fit.values.copy()
    if not fit.causes:  # a large missing cause drives the nuisances far from their declared values
        nuisances = list(fitter.nuisance_indices)
        less_distorted[nuisances] = fitter.declared[nuisances]
    elif sign:  # a cause fitted in place of two is too large
        for cause in fit.causes:
            if allowed_sign(fitter, cause):
                index = list(fitter.parameter_indices(cause))
                less_distorted[index] = fitter.declared[index] + KEPT_PART_OF_SIZE * (
                    fit.values[index] - fitter.declared[index]
                )
    return [fit.values] if np.array_equal(less_distorted, fit.values) else [fit.values, less_distorted]


def _best_sizes(
    sizes: Array, unit: Array, values_at: Callable[[Array], Array]
) -> Generator[list[Array], list[float], list[float]]:
    """Return the sizes of the best local minima on a grid, refined around them."""
    sums = dict(zip(sizes.tolist(), (yield [values_at(size * unit) for size in sizes]), strict=True))
    ordered = sorted(sums)
    costs = [np.inf, *(sums[size] for size in ordered), np.inf]
    minima = [size for i, size in enumerate(ordered, start=1) if costs[i] <= min(costs[i - 1], costs[i + 1])]
    minima.sort(key=lambda size: sums[size])
    centres = [size for size in minima[:MAX_VALLEYS] if sums[size] <= MAX_COST_RATIO * min(sums.values())]
    for _ in range(HALVINGS):
        ordered = sorted(sums)
        positions = [ordered.index(centre) for centre in centres]
        brackets = [
            ordered[k : k + 2]
            for position in positions
            for k in (position - 1, position)
            if 0 <= k < len(ordered) - 1
        ]
        midpoints = sorted({float(np.sqrt(low * high)) for low, high in brackets})
        sums |= dict(zip(midpoints, (yield [values_at(size * unit) for size in midpoints]), strict=True))
        ordered = sorted(sums)
        windows = [ordered[max(ordered.index(centre) - 1, 0) :][:3] for centre in centres]
        centres = [min(neighbours, key=lambda size: sums[size]) for neighbours in windows]
    return centres
