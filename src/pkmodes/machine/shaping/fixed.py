"""The best fixed shaper of a kind: frequencies that leave the least vibration at the worst pose."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations_with_replacement, product
from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize, minimize_scalar

from pkmodes.machine.shaping.firmware_impulses import centre_of_equal_impulses, firmware_shaper
from pkmodes.machine.shaping.kinds import factor_names
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.machine.shaping.shapers import Shaper, shaper

Array = NDArray[np.float64]
#: Maximum number of frequencies tried for each factor, and of combinations of them.
TRIED, COMBINATIONS = 160, 20_000
#: Maximum number of modes at poses that the search considers: half from the poses that ring most, the rest spread
#: evenly over the other poses.
MOST = 3600
#: The frequencies tried reach beyond those of the machine by this factor: robust shapers work best slightly off them.
BEYOND = 1.5
#: Relative accuracy of the frequencies: finer than any shaper needs.
CLOSE = 1e-5
#: Combinations evaluated at once.
TOGETHER = 100
#: Number of best combinations from which the search continues, and minimum number of steps between them.
STARTS, APART = 5, 3


def best_fixed(
    kind: str, at: Ringing, version: str | None = None, zeta: float | None = None
) -> tuple[tuple[float, ...], Shaper]:
    """Return design frequencies [Hz], one for each factor, and the shaper, for the mean damping ratio.

    - at: ringing of the machine
    - zeta: the damping ratio of the design, if it is another one
    - version: version of the firmware whose impulses count, a key of `pkmodes.machine.shaping.firmware.VERSIONS`; by
      default those of `pkmodes.shaping.shaper`, as for products
    """
    names, zeta = factor_names(kind), at.mean_ratio if zeta is None else zeta
    k, alike = len(names), len(set(names)) == 1
    version = None if k > 1 else version
    chosen = _chosen(at.unshaped, MOST // at.frequencies.shape[1])
    modes, weights = (at.frequencies[chosen], at.damping_ratios[chosen]), at.weights[chosen]

    def worst(log_frequencies: Array) -> float:
        remaining = residual(_fixed(kind, np.exp(log_frequencies), zeta, version), *modes)
        return float(np.linalg.norm(weights * remaining, axis=-1).max())

    low, high = modes[0].min() / BEYOND, modes[0].max() * BEYOND
    count = TRIED  # frequencies for each factor
    while (comb(count + k - 1, k) if alike else count**k) > COMBINATIONS:
        count -= 1
    tried = np.geomspace(low, high, count)
    # The squared vibration that a factor leaves, for every frequency that is tried: (count, N, m).
    tables = {
        name: np.stack([residual(_fixed(name, f, zeta, version), *modes) ** 2 for f in tried[:, None]])
        for name in names
    }
    starts = _best_combinations([tables[name] for name in names], weights, alike=alike)
    refined = [_refined(worst, np.log(tried), start) for start in starts]
    best = np.exp(min(refined, key=worst))
    if alike:
        best = np.sort(best)
    if version is not None:
        best = np.array([centre_of_equal_impulses(version, kind, float(best[0]), zeta)])
    return tuple(best.tolist()), _fixed(kind, best, zeta, version)


def _fixed(kind: str, frequencies: Array, zeta: float, version: str | None) -> Shaper:
    """Return the shaper with one frequency for each factor, as a version of a firmware makes it if there is one."""
    if version is not None:
        return firmware_shaper(version, kind, float(frequencies[0]), zeta)
    return shaper(kind, frequencies if len(frequencies) > 1 else frequencies[0], zeta)


def _chosen(unshaped: Array, count: int) -> NDArray[np.intp]:
    """Return the poses that the search considers, at most `count`."""
    if len(unshaped) <= count:
        return np.arange(len(unshaped))
    order = np.argsort(-unshaped)
    strongest, rest = order[: count // 2], order[count // 2 :]
    even = rest[np.linspace(0, len(rest) - 1, count - len(strongest)).astype(int)]
    return np.concatenate([strongest, even])


def _best_combinations(tables: list[Array], weights: Array, *, alike: bool) -> list[tuple[int, ...]]:
    """Return the best combinations of frequencies by index, none next to another: what factors leave multiplies."""
    count, k = len(tables[0]), len(tables)
    combinations = (
        combinations_with_replacement(range(count), k) if alike else product(range(count), repeat=k)
    )
    indices = np.array(list(combinations))
    worst = np.empty(len(indices))
    squares = (weights**2).astype(np.float32)
    small = [table.astype(np.float32) for table in tables]  # a start need not be exact
    for first in range(0, len(indices), TOGETHER):
        batch = indices[first : first + TOGETHER]
        remaining = small[0][batch[:, 0]]
        for table, index in zip(small[1:], batch.T[1:], strict=True):
            remaining = remaining * table[index]
        worst[first : first + TOGETHER] = np.einsum("cnm,nm->cn", remaining, squares).max(axis=1)
    ranked = indices[np.argsort(worst, kind="stable")]
    chosen = [ranked[0]]
    for combination in ranked[1:]:
        if len(chosen) == STARTS:
            break
        if all(np.abs(combination - accepted).max() >= APART for accepted in chosen):
            chosen.append(combination)
    return [tuple(combination.tolist()) for combination in chosen]


def _refined(worst: Callable[[Array], float], tried: Array, start: tuple[int, ...]) -> Array:
    """Return the logarithms of the best frequencies near a start."""
    step = float(tried[1] - tried[0])
    if len(start) == 1:
        middle = float(tried[start[0]])
        along = minimize_scalar(
            lambda x: worst(np.array([x])),
            bounds=(middle - step, middle + step),
            method="bounded",
            options={"xatol": CLOSE},
        )
        return np.array([along.x])
    begin = tried[list(start)]
    simplex = np.vstack([begin, begin + 0.5 * step * np.eye(len(start))])
    options: Any = {"xatol": CLOSE, "fatol": 0.0, "maxfev": 150 * len(start), "initial_simplex": simplex}
    minimum = minimize(worst, begin, method="Nelder-Mead", options=options)
    return np.asarray(minimum.x)
