"""Frequencies that change with the level of excitation: while a vibration decays, and between files.

Within a file the decays show it (`pkmodes.modaltest.identification.level`), and so do repeats whose levels differ:
the logarithm of the frequency is regressed on that of the level, and Student's t decides, with the scatter
about the regressions pooled over the modes of a record, as a few repeats do not determine their own.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from pkmodes.core.base.numbers import plain
from pkmodes.loop.measured.amplitude import MIN_LEVEL_RATIO
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate
from pkmodes.modaltest.identification.level import FALSE_ALARM, MIN_CHANGE, LevelShift

Array = NDArray[np.float64]

#: Minimum number of files for a regression.
MIN_FILES = 3
#: Weight of the pooled scatter against that of a single mode, in degrees of freedom: the value of Smyth (see
#: `averaging`) for similar variances.
PRIOR_DOF = 4.0


@dataclass(frozen=True, eq=False)
class _Regression:
    """Regression of a mode's ln f on the level of the files, both (n,), and the variance of ln f from the fits."""

    level: Array
    fitted: Array
    squares: float
    fit_variance: float

    @property
    def freedom(self) -> int:
        return len(self.level) - 2


def shifts_between_files(groups: Sequence[Mapping[int, ModeEstimate]]) -> list[LevelShift | None]:
    """Return, for each mode, how its frequency changes with the level of the files; None for no detectable change."""
    fits = [_regression(list(group.values())) for group in groups]
    usable = [fit for fit in fits if fit is not None]
    freedom = sum(fit.freedom for fit in usable)
    pooled = sum(fit.squares for fit in usable) / max(freedom, 1)
    shifts: list[LevelShift | None] = []
    for fit in fits:
        if fit is None:
            shifts.append(None)
            continue
        high, low = math.exp(fit.fitted[fit.level.argmax()]), math.exp(fit.fitted[fit.level.argmin()])
        prior_dof = min(PRIOR_DOF, freedom) if freedom > fit.freedom else 0.0
        variance = (prior_dof * pooled + fit.squares) / (prior_dof + fit.freedom)
        t = math.sqrt(
            float(((fit.fitted - fit.fitted.mean()) ** 2).sum()) / max(variance, fit.fit_variance, 1e-300)
        )
        shift = LevelShift(high, low, math.exp(float(np.ptp(fit.level))))
        significant = 2.0 * student.sf(t, prior_dof + fit.freedom) < FALSE_ALARM
        shifts.append(shift if significant and shift.spread > MIN_CHANGE * low else None)
    return shifts


def _regression(modes: Sequence[ModeEstimate]) -> _Regression | None:
    """Return the regression of a mode over its files, None if their levels agree or are unknown."""
    if len(modes) < MIN_FILES or not all(mode.level > 0.0 for mode in modes):
        return None
    level, f = (np.log([getattr(mode, name) for mode in modes]) for name in ("level", "frequency"))
    if np.ptp(level) < math.log(MIN_LEVEL_RATIO):
        return None
    slope, constant = np.polyfit(level - level.mean(), f, 1)
    fitted = constant + slope * (level - level.mean())
    fit_variance = float(np.mean([(mode.sigma_frequency / mode.frequency) ** 2 for mode in modes]))
    return _Regression(level, fitted, float(((f - fitted) ** 2).sum()), fit_variance)


def largest_shift(shifts: Sequence[LevelShift | None]) -> LevelShift | None:
    """Return the change with the largest spread, None for none."""
    changes = [shift for shift in shifts if shift is not None]
    return max(changes, key=lambda shift: shift.spread, default=None)


def add_half_spread(sigma: float, shift: LevelShift | None) -> float:
    """Return a standard deviation with half the spread of a change added in quadrature [Hz]."""
    return sigma if shift is None else math.hypot(sigma, 0.5 * shift.spread)


def level_messages(pose: str, mode: ModeEstimate) -> list[str]:
    """Return messages about a mode whose frequency changes with the level."""
    return [
        f"{pose}: the mode at {mode.frequency:.4g} Hz changes with the level: {shift.high:.5g} to {shift.low:.5g} Hz "
        f"while {falls} {plain(shift.fall, 2)}-fold; half the difference is in sigma"
        for shift, falls in (
            (mode.shift, "its amplitude falls"),
            (mode.shift_between_files, "the level of the files falls"),
        )
        if shift is not None
    ]
