"""Judgement of measured damping: what is claimed about losses, and if nothing, why.

Hypotheses are the declared losses, each suspected loss alone and each pair.  The rules are those of the frequencies:
an explanation leaves noise, has no distinguishable rival, improves significantly on the declared losses, and is
specific.  Friction that depends on the amplitude, such as Coulomb friction, is not a loss of the catalogue; it is
refused because it leaves more than noise, or a trend with frequency.

Specific is what few laws outside the candidates look like: the damping ratio of each mode differs from what was found
by a factor of its own, the same at all setups, and the measurements scatter as stated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import comb

import numpy as np
from scipy import stats

from pkmodes.diagnosis.damping.fit import NEARLY, PARTS, LossFit, LossFitter
from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
    Verdict,
)

#: Squared difference below which two explanations are the same to any measurement.
SAME = 1.0
#: Number of laws drawn, and their seed.
DRAWS, SEED = 200, 5
#: Steps of Gauss and Newton, and the largest change of a logarithm in one.
STEPS, LARGEST = 20, 1.0
#: Smallest curvature of a logarithm that a step trusts: of a loss that has become nothing.
FLAT = 1e-3


@dataclass(frozen=True, eq=False)
class DampingJudgement:
    """A verdict on damping and its evidence.

    Attributes
    ----------
    base : LossFit
        With the declared losses.
    final : LossFit
        With the causes; the base where none is claimed.
    places : tuple of tuple of LossFit
        For each cause, the fits of its class; its own is first.
    rivals : tuple of LossFit
        Explanations that remain where several do, the best first.
    p_values : tuple of float
        One for each cause.
    why : str
        Why nothing is claimed; empty for a claim.  Where nothing is missing, what the ratios agree with, if that is
        not the declared damping within the errors.
    scatter : float
        How far the ratios scatter about the model beyond their stated errors, where the verdict allows for that: the
        standard deviation of their logarithm.
    """

    verdict: Verdict
    base: LossFit
    final: LossFit
    places: tuple[tuple[LossFit, ...], ...] = ()
    rivals: tuple[LossFit, ...] = ()
    p_values: tuple[float, ...] = ()
    why: str = ""
    scatter: float = 0.0


def judge_damping(fitter: LossFitter, *, roughly: bool = False) -> DampingJudgement:
    """Judge what the damping says about losses.

    Parameters
    ----------
    roughly : bool
        Without the tests of what an explanation leaves, and of how specific it is.
    """
    c, base = fitter.criteria, fitter.fit()
    count = int(fitter.rows.above.sum())
    if too_few(fitter):
        what = "1 resolved damping ratio is" if count == 1 else f"{count} resolved damping ratios are"
        return DampingJudgement(INSUFFICIENT_DATA, base, base, why=f"{what} too few")
    singles = [fitter.fit((j,)) for j in fitter.candidates]
    chance = min((_p_value(fitter, base, fit, 1) for fit in singles), default=1.0)
    if base.p_value > c.gate.level and chance > c.gate.level:
        return DampingJudgement(ADEQUATE, base, base)
    sizes = (1, 2) if count >= c.claim.rows_for_two else (1,)
    for size in sizes:
        fits = singles if size == 1 else _pairs(fitter)
        passing = [fit for fit in fits if _explains(fitter, fit, c.gate.level)]
        if passing:
            return _claimed(fitter, base, fits, min(passing, key=lambda fit: fit.criterion), roughly)
    return DampingJudgement(UNEXPLAINED, base, base, why=nearest(fitter))


def too_few(fitter: LossFitter) -> bool:
    """Return whether the resolved ratios are too few for the uncertain losses, a cause, and a test of it."""
    return int(fitter.rows.above.sum()) < len(fitter.nuisances) + 1 + fitter.criteria.claim.redundancy


def _claimed(
    fitter: LossFitter, base: LossFit, fits: Sequence[LossFit], best: LossFit, roughly: bool
) -> DampingJudgement:
    """Judge the best explanation among its rivals of the same size."""
    c = fitter.criteria
    near = [fit for fit in fits if fit.criterion < best.criterion + c.search.survives]
    survivors = [fit for fit in near if fit is best or _explains(fitter, fit, c.gate.surely)]
    alike = [fit for fit in survivors if fitter.difference(best, fit) < c.claim.told_apart]
    alike.sort(key=lambda fit: (not _is_effect(fitter, fit), fit.criterion))
    # Of explanations that are the same to any measurement, an effect names the class; and of any class in which the
    # best is not a cause.
    claimable = all(fitter.losses[j].claimable for j in best.causes)
    same = [fit for fit in alike if not claimable or fitter.difference(best, fit) < SAME]
    best = same[0] if same else best
    places = tuple(
        (best, *(fit for fit in alike if fit is not best and set(best.causes) - {cause} < set(fit.causes)))
        for cause in best.causes
    )
    others = [fit for fit in survivors if not any(fit is one for place in places for one in place)]
    p_values = tuple(_p_of_place(fitter, base, best, cause) for cause in best.causes)
    given = base, best, places
    if others:
        rivals = (best, *sorted(others, key=lambda fit: fit.criterion))
        return DampingJudgement(AMBIGUOUS, *given, rivals=rivals, p_values=p_values)
    if len(best.causes) == 1 and _tells_nothing(fitter, places[0]):
        why = "the damping ratios are too few or too uncertain to tell any of the losses apart"
        return DampingJudgement(INSUFFICIENT_DATA, base, base, why=why)
    doubt = "" if roughly else _doubt(fitter, best, p_values)
    if doubt:
        return DampingJudgement(UNEXPLAINED, base, base, why=f"{names_of(fitter, best)} {doubt}")
    return DampingJudgement(EFFECT_FOUND, *given, p_values=p_values)


def _explains(fitter: LossFitter, fit: LossFit, level: float) -> bool:
    """Return whether a fit leaves noise, and each of its causes is there."""
    causes = [j for j in fit.causes if j in fit.absent and not fitter.declared[j]]
    at_bound = [j for j in fit.causes if fit.values[j] > NEARLY * fitter.losses[j].parameter.upper]
    return fit.p_value > level and not causes and not at_bound


def _pairs(fitter: LossFitter) -> list[LossFit]:
    """Return the fits of pairs in which each loss is needed beside the other."""
    c, number = fitter.criteria, comb(len(fitter.candidates), 2)
    pairs = [fitter.fit(pair) for pair in combinations(fitter.candidates, 2)]
    return [
        fit
        for fit in pairs
        if all(_p_value(fitter, fitter.fit((j,)), fit, number) <= c.claim.claimed for j in fit.causes)
    ]


def p_of_loss(fitter: LossFitter, loss: int) -> float:
    """Return the p-value of one loss beside the declared ones, for this candidate alone."""
    return _p_value(fitter, fitter.fit(), fitter.fit((loss,)), 1) / max(len(fitter.candidates), 1)


def _p_of_place(fitter: LossFitter, base: LossFit, fit: LossFit, cause: int) -> float:
    rest = tuple(j for j in fit.causes if j != cause)
    without = fitter.fit(rest) if rest else base
    return _p_value(fitter, without, fit, comb(len(fitter.candidates), len(fit.causes)))


def _p_value(fitter: LossFitter, less: LossFit, more: LossFit, number: int | None = None) -> float:
    """Return the p-value of a likelihood-ratio test of one more loss, corrected for the number of candidates."""
    number = len(fitter.candidates) if number is None or number == 1 else number
    (added,) = set(more.causes) - set(less.causes)
    gain = max(less.squares + less.price - more.squares - more.price, 0.0)
    one_sided = 1.0 if fitter.declared[added] else 0.5
    return min(1.0, one_sided * float(stats.chi2.sf(gain, 1)) * number)


def _is_effect(fitter: LossFitter, fit: LossFit) -> bool:
    return all(fitter.losses[j].effect for j in fit.causes)


def _tells_nothing(fitter: LossFitter, alike: Sequence[LossFit]) -> bool:
    """Return whether the class has all candidates although these are not the same thing."""
    members = {fit.causes[0] for fit in alike}
    differ = any(fitter.difference(alike[0], fit) >= SAME for fit in alike)
    return differ and members == set(fitter.candidates)


def _doubt(fitter: LossFitter, fit: LossFit, p_values: Sequence[float]) -> str:
    """Return why an explanation is not claimed; empty if nothing contradicts it."""
    c = fitter.criteria
    if max(p_values) > c.claim.claimed:
        return f"would explain it, but the improvement may be chance (p = {max(p_values):.2g})"
    if p_of_trend(fitter, fit) <= c.gate.level:
        return (
            "would explain it, but what it leaves follows the frequency: friction that depends on the amplitude, "
            "or something outside the candidates"
        )
    coincidence = p_coincidence(fitter, fit)
    if coincidence > c.damping.specific[len(fit.causes) - 1]:
        return (
            "would explain it, but the damping ratios are too few or too uncertain to rule out something outside "
            f"the candidates: {100 * coincidence:.2g} % of such laws would look like a candidate"
        )
    return ""


def p_of_trend(fitter: LossFitter, fit: LossFit) -> float:
    """Return the p-value of a trend of the residuals with the logarithm of the frequency."""
    rows = fitter.rows
    used = rows.above & (np.arange(len(rows.ratio)) != (-1 if fit.outlier is None else fit.outlier))
    ratio = fitter.predicted(fit.values) + fitter.least
    fitted = (
        rows.rates[:, list(fit.free)] * fit.values[list(fit.free)] / ratio[:, None] / rows.sigma[:, None]
    )[used]
    trend = ((np.log(rows.frequency) - np.log(rows.frequency).mean()) / rows.sigma)[used]
    trend = trend - fitted @ np.linalg.lstsq(fitted, trend)[0]
    size = float(trend @ trend)
    if size < SAME:
        return 1.0
    return float(stats.chi2.sf((trend @ fit.white[used]) ** 2 / size, 1))


def nearest(fitter: LossFitter) -> str:
    """Return how far the nearest single loss is from the damping, in words."""
    fits = [fit for fit in (fitter.fit((j,)) for j in fitter.candidates) if fit.causes]
    if not fits:
        return "no loss shows in these modes"
    best = min(fits, key=lambda fit: fit.squares)
    left = (fitter.measured - fitter.logarithms(best.values))[fitter.rows.above]
    factor = float(np.exp(np.sqrt(np.mean(np.minimum(np.abs(left), 10.0) ** 2))))
    name = names_of(fitter, best)
    return f"no loss or pair of losses explains it; the nearest, {name}, leaves a factor of {factor:.2g}"


def names_of(fitter: LossFitter, fit: LossFit) -> str:
    """Return the names of the causes of a fit."""
    return " + ".join(fitter.losses[j].candidate for j in fit.causes)


def p_coincidence(fitter: LossFitter, fit: LossFit) -> float:
    """Return the fraction of laws outside the candidates that as many candidates as were found explain."""
    c, fitter = fitter.criteria, replace(fitter, rows=fitter.rows.some(fitter.rows.above), _fits={})
    rows = fitter.rows
    rng = np.random.default_rng(SEED)
    numbers, mode = np.unique(rows.mode, return_inverse=True)
    levels = c.damping.spread * rng.standard_normal((DRAWS, len(numbers)))
    noise = rows.sigma * rng.standard_normal((DRAWS, len(mode)))
    drawn = fitter.logarithms(fit.values) + levels[:, mode] + noise
    least = np.min(
        [
            _squares(fitter, fit, causes, drawn, start)
            for causes in combinations(fitter.candidates, len(fit.causes))
            for start in range(len(causes))
        ],
        axis=0,
    )
    return float(np.mean(least < stats.chi2.isf(c.gate.level, max(len(mode) - len(fit.causes), 1))))


def _squares(fitter: LossFitter, fit: LossFit, causes: tuple[int, ...], drawn: Array, largest: int) -> Array:
    """Return the least sum of squares of each draw over the values of some losses, (draws,)."""
    index, weight = list(causes), 1.0 / fitter.rows.sigma
    of_others = np.where(np.isin(np.arange(len(fitter.losses)), fit.causes), fitter.declared, fit.values)
    of_others[index] = 0.0
    rest = fitter.predicted(of_others) + fitter.least
    by_unit = fitter.rows.rates[:, index] * fitter.typical[index]
    parts = np.where(np.arange(len(causes)) == largest, PARTS[0], PARTS[1])
    x = np.tile(np.log(parts), (len(drawn), 1))
    for _ in range(STEPS):
        each = np.exp(x)[:, None, :] * by_unit
        ratio = each.sum(axis=-1) + rest
        left = weight * (drawn - np.log(ratio))
        rates = weight[:, None] * each / ratio[..., None]
        square = np.swapaxes(rates, 1, 2) @ rates + FLAT * np.eye(len(causes))
        step = np.linalg.solve(square, np.swapaxes(rates, 1, 2) @ left[..., None])[..., 0]
        x = x + np.clip(step, -LARGEST, LARGEST)
    left = weight * (drawn - np.log((np.exp(x)[:, None, :] * by_unit).sum(axis=-1) + rest))
    return np.asarray(np.einsum("dr,dr->d", left, left))
