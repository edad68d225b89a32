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
MAX_TRIAL_FREQUENCIES, MAX_COMBINATIONS = 160, 20_000
#: Maximum number of modes at poses that the search considers: half from the poses that ring most, the rest spread
#: evenly over the other poses.
MAX_MODES_SEARCHED = 3600
#: The frequencies tried reach beyond those of the machine by this factor: robust shapers work best slightly off them.
RANGE_FACTOR = 1.5
#: Relative accuracy of the frequencies: finer than any shaper needs.
FREQUENCY_ACCURACY = 1e-5
#: Number of combinations evaluated at once.
BATCH_SIZE = 100
#: Number of best combinations from which the search continues, and minimum number of steps between them.
START_COUNT, MIN_START_DISTANCE = 5, 3


def best_fixed(
    kind: str, ringing: Ringing, version: str | None = None, zeta: float | None = None
) -> tuple[tuple[float, ...], Shaper]:
    """Return design frequencies [Hz], one for each factor, and the shaper, for the mean damping ratio.

    - ringing: ringing of the machine
    - zeta: the damping ratio of the design, if it is another one
    - version: version of the firmware whose impulses count, a key of `pkmodes.machine.shaping.firmware.VERSIONS`; by
      default those of `pkmodes.shaping.shaper`, as for products
    """
    names, zeta = factor_names(kind), ringing.mean_ratio if zeta is None else zeta
    factor_count, same_factors = len(names), len(set(names)) == 1
    version = None if factor_count > 1 else version
    pose_indices = np.arange(len(ringing.unshaped))
    max_poses = MAX_MODES_SEARCHED // ringing.frequencies.shape[1]
    if len(pose_indices) > max_poses:  # those that ring most, and some of the others
        order = np.argsort(-ringing.unshaped)
        strongest, rest = order[: max_poses // 2], order[max_poses // 2 :]
        even = rest[np.linspace(0, len(rest) - 1, max_poses - len(strongest)).astype(int)]
        pose_indices = np.concatenate([strongest, even])
    modes, weights = (
        (ringing.frequencies[pose_indices], ringing.damping_ratios[pose_indices]),
        ringing.weights[pose_indices],
    )

    def worst(log_frequencies: Array) -> float:
        remaining = residual(_design(kind, np.exp(log_frequencies), zeta, version), *modes)
        return float(np.linalg.norm(weights * remaining, axis=-1).max())

    low, high = modes[0].min() / RANGE_FACTOR, modes[0].max() * RANGE_FACTOR
    count = MAX_TRIAL_FREQUENCIES  # frequencies for each factor
    while (
        comb(count + factor_count - 1, factor_count) if same_factors else count**factor_count
    ) > MAX_COMBINATIONS:
        count -= 1
    trial_frequencies = np.geomspace(low, high, count)
    # The squared vibration that a factor leaves, for every frequency that is tried: (count, N, m).
    tables = {
        name: np.stack(
            [residual(_design(name, f, zeta, version), *modes) ** 2 for f in trial_frequencies[:, None]]
        )
        for name in names
    }
    starts = _best_combinations([tables[name] for name in names], weights, same_factors=same_factors)
    refined_starts = [_refine_start(worst, np.log(trial_frequencies), start) for start in starts]
    best = np.exp(min(refined_starts, key=worst))
    if same_factors:
        best = np.sort(best)
    if version is not None:
        best = np.array([centre_of_equal_impulses(version, kind, float(best[0]), zeta)])
    return tuple(best.tolist()), _design(kind, best, zeta, version)


def _design(kind: str, frequencies: Array, zeta: float, version: str | None) -> Shaper:
    """Return the shaper with one frequency for each factor, as a version of a firmware makes it if there is one."""
    if version is not None:
        return firmware_shaper(version, kind, float(frequencies[0]), zeta)
    return shaper(kind, frequencies if len(frequencies) > 1 else frequencies[0], zeta)


def _best_combinations(tables: list[Array], weights: Array, *, same_factors: bool) -> list[tuple[int, ...]]:
    """Return the best combinations of frequencies by index, none next to another: what factors leave multiplies."""
    count, factor_count = len(tables[0]), len(tables)
    combinations = (
        combinations_with_replacement(range(count), factor_count)
        if same_factors
        else product(range(count), repeat=factor_count)
    )
    indices = np.array(list(combinations))
    worst = np.empty(len(indices))
    squares = (weights**2).astype(np.float32)
    single_tables = [table.astype(np.float32) for table in tables]  # a start need not be exact
    for begin in range(0, len(indices), BATCH_SIZE):
        batch = indices[begin : begin + BATCH_SIZE]
        remaining = single_tables[0][batch[:, 0]]
        for table, index in zip(single_tables[1:], batch.T[1:], strict=True):
            remaining = remaining * table[index]
        worst[begin : begin + BATCH_SIZE] = np.einsum("cnm,nm->cn", remaining, squares).max(axis=1)
    ranked = indices[np.argsort(worst, kind="stable")]
    starts = [ranked[0]]
    for combination in ranked[1:]:
        if len(starts) == START_COUNT:
            break
        if all(np.abs(combination - accepted).max() >= MIN_START_DISTANCE for accepted in starts):
            starts.append(combination)
    return [tuple(combination.tolist()) for combination in starts]


def _refine_start(worst: Callable[[Array], float], log_frequencies: Array, start: tuple[int, ...]) -> Array:
    """Return the logarithms of the best frequencies near a start."""
    step = float(log_frequencies[1] - log_frequencies[0])
    if len(start) == 1:
        middle = float(log_frequencies[start[0]])
        scalar_minimum = minimize_scalar(
            lambda x: worst(np.array([x])),
            bounds=(middle - step, middle + step),
            method="bounded",
            options={"xatol": FREQUENCY_ACCURACY},
        )
        return np.array([scalar_minimum.x])
    start_point = log_frequencies[list(start)]
    simplex = np.vstack([start_point, start_point + 0.5 * step * np.eye(len(start))])
    options: Any = {
        "xatol": FREQUENCY_ACCURACY,
        "fatol": 0.0,
        "maxfev": 150 * len(start),
        "initial_simplex": simplex,
    }
    minimum = minimize(worst, start_point, method="Nelder-Mead", options=options)
    return np.asarray(minimum.x)
