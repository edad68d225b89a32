"""Frequencies that depend on the level of excitation, as no linear machine's do.

Setups that differ in nothing but their level are regressed: ln f of each mode on the logarithm of the level.  Modes
of one setup may share an error, such as a warmer machine, so the analysis of variance has two strata, as for split
plots: what the modes of a setup have in common, and how they differ from each other.  In each, the trend is compared
with the stated errors and, where a level was repeated, with the scatter of its setups.  If none was repeated, the
repeatability of setups is unknown: the trend must be clear even with errors twice as large, and shared by the modes
of each setup.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats
from scipy.linalg import solve_triangular

from pkmodes.loop.measured.compared import paired_rows
from pkmodes.loop.measured.measurements import Measurements

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

#: Levels differ if the higher is at least this multiple of the lower.
MIN_LEVEL_RATIO = 1.25
#: Largest p-value of a dependence that is reported.
SIGNIFICANCE_LEVEL = 1e-3
#: Degrees of freedom of the stated errors, where they are pooled with the scatter of setups at one level.
STATED_ERROR_DEGREES = 4.0
#: Factor by which the true errors may exceed the stated ones if no level was repeated.
UNREPEATED_FACTOR = 2.0
#: A change is clear from this many standard deviations.  A change is not reported if its standard deviation is more
#: than the fraction of the clearest change.
CLEAR_SIGMAS, MAX_RELATIVE_ERROR = 3.0, 0.5


@dataclass(frozen=True)
class FrequencyChange:
    """How the frequency of a mode changes from the lowest to the highest level at one position.

    - row: the mode at its highest level
    - relative, sigma: relative change of the frequency, and its standard deviation by the stated errors
    """

    row: int
    relative: float
    sigma: float

    @property
    def sigmas(self) -> float:
        """The change in standard deviations."""
        return self.relative / self.sigma


@dataclass(frozen=True)
class AmplitudeDependence:
    """How frequencies change with the level of excitation.

    - low, high: the lowest and the highest level of setups that can be compared
    - changes: change of each mode at each position
    - squares: sum of squares that the trend explains, in units of the stated variances
    - p_value: probability of so clear a trend if nothing depends on the level
    - repeated: whether some level was repeated, so that the scatter of its setups is known
    """

    low: float
    high: float
    changes: tuple[FrequencyChange, ...]
    squares: float
    p_value: float
    repeated: bool

    @property
    def significant(self) -> bool:
        """Whether the frequencies depend on the level."""
        return self.p_value < SIGNIFICANCE_LEVEL

    @property
    def clearest(self) -> FrequencyChange:
        """The change that is clearest against its error."""
        return max(self.changes, key=lambda change: abs(change.sigmas))

    @property
    def range(self) -> tuple[float, float]:
        """Smallest and largest relative change, of the modes with small enough errors."""
        limit = MAX_RELATIVE_ERROR * abs(self.clearest.relative)
        reliable = [change.relative for change in self.changes if change.sigma <= limit] or [
            self.clearest.relative
        ]
        return min(reliable), max(reliable)

    @property
    def direction(self) -> int:
        """1 where all clear changes are upwards, -1 where all are downwards, else 0."""
        clear_changes = [change.relative for change in self.changes if abs(change.sigmas) > CLEAR_SIGMAS] or [
            self.clearest.relative
        ]
        return 0 if min(clear_changes) < 0.0 < max(clear_changes) else int(np.sign(clear_changes[0]))


class Stratum(NamedTuple):
    """Sums of squares and degrees of freedom, of the trend and of the scatter at one level."""

    trend: float
    trend_degrees: int
    scatter: float
    scatter_degrees: int

    def p_value(self, expected_variance: float) -> float:
        """Return the p-value of the trend; `expected_variance` is relative to the stated one."""
        if not self.scatter_degrees:
            return float(
                stats.chi2.sf(self.trend / (UNREPEATED_FACTOR**2 * expected_variance), self.trend_degrees)
            )
        variance_degrees = STATED_ERROR_DEGREES + self.scatter_degrees
        variance = max((STATED_ERROR_DEGREES * expected_variance + self.scatter) / variance_degrees, 1.0)
        return float(
            stats.f.sf(self.trend / self.trend_degrees / variance, self.trend_degrees, variance_degrees)
        )


def amplitude_dependence(
    data: Measurements, groups: Sequence[Sequence[int]], partner: Rows, motion: Array | None = None
) -> AmplitudeDependence | None:
    """Return how frequencies change with the level; None if no setups differ in that alone.

    - groups: setups of the same position, drives and set values
    - partner: number of each row's mode in a model, -1 where unknown, (R,): modes with different numbers are not the
      same, however close their frequencies
    - motion: derivatives of ln f with respect to the position, (R, d), if the setups were positioned anew and it is
      uncertain
    """
    regressions = [_LevelRegression.of(data, group, partner, motion) for group in groups]
    usable_regressions = [regression for regression in regressions if regression is not None]
    if not usable_regressions:
        return None
    common_strata, other_strata = (
        [regression.strata[k] for regression in usable_regressions] for k in (0, 1)
    )
    # If the modes of a setup share an error as large as the stated one, their mean scatters by it, too.
    mean_mode_count = float(np.mean([regression.modes_of_a_setup for regression in usable_regressions]))
    p_values = [_sum_strata(common_strata).p_value(mean_mode_count)]
    if any(stratum.trend_degrees for stratum in other_strata):
        p_values.append(_sum_strata(other_strata).p_value(1.0))
    levels = np.concatenate([data.level[data.pose[regression.rows]] for regression in usable_regressions])
    return AmplitudeDependence(
        low=float(levels.min()),
        high=float(levels.max()),
        changes=tuple(change for regression in usable_regressions for change in regression.changes()),
        squares=sum(stratum.trend for stratum in (*common_strata, *other_strata)),
        p_value=min(len(p_values) * min(p_values), 1.0),
        repeated=any(stratum.scatter_degrees for stratum in (*common_strata, *other_strata)),
    )


def _sum_strata(strata: Sequence[Stratum]) -> Stratum:
    trend, trend_degrees, scatter, scatter_degrees = (sum(column) for column in zip(*strata, strict=True))
    return Stratum(trend, int(trend_degrees), scatter, int(scatter_degrees))


class _LevelRegression:
    """A regression of the modes of setups that differ only in their level.

    - rows, mode_number: rows, and which mode of the position each is, (n,)
    - cholesky: Cholesky factor of the covariance of their ln f, (n, n)
    """

    def __init__(self, data: Measurements, rows: Rows, mode_number: Rows, cholesky: Array) -> None:
        self.rows, self._mode_number, self._cholesky = rows, mode_number, cholesky
        self._setup, level = data.pose[rows], data.level[data.pose[rows]]
        self._log_level = np.log(level)
        self._level_step = level_steps(level)
        self._white_log_frequency = self._whitened(np.log(data.frequency[rows])[:, None])[:, 0]

    @classmethod
    def of(
        cls, data: Measurements, setups: Sequence[int], partner: Rows, motion: Array | None
    ) -> _LevelRegression | None:
        """Return the modes that were measured at two levels or more; None if there are none."""
        setups_with_level = [i for i in setups if np.isfinite(data.level[i])]
        if (
            len(setups_with_level) < 2
            or data.level[setups_with_level].max() < MIN_LEVEL_RATIO * data.level[setups_with_level].min()
        ):
            return None
        pairs = list(_same_modes(data, setups_with_level, partner))
        steps = level_steps(data.level[data.pose[[row for row, _ in pairs]]])
        steps_by_mode: dict[int, set[int]] = {}
        for (_, mode_number), step in zip(pairs, steps, strict=True):
            steps_by_mode.setdefault(mode_number, set()).add(int(step))
        pairs = [pair for pair in pairs if len(steps_by_mode[pair[1]]) > 1]
        if not pairs:
            return None
        rows, mode_number = np.array(pairs, dtype=np.intp).T
        V = np.diag((data.sigma[rows] / data.frequency[rows]) ** 2)
        if motion is not None:
            same_setup = data.pose[rows][:, None] == data.pose[rows]
            V += same_setup * ((motion[rows] * data.point_sigma[data.pose[rows]] ** 2) @ motion[rows].T)
        return cls(data, rows, mode_number, np.linalg.cholesky(V))

    @property
    def modes_of_a_setup(self) -> float:
        """Mean number of modes."""
        return len(self.rows) / len(set(self._setup.tolist()))

    @property
    def strata(self) -> tuple[Stratum, Stratum]:
        """What the modes of a setup have in common, and how they differ from each other."""
        modes, setups = _indicator_columns(self._mode_number), _indicator_columns(self._setup)
        mode_levels = _indicator_columns(self._mode_number * (1 + self._level_step.max()) + self._level_step)
        log_level, slopes = (
            self._log_level[:, None],
            modes * (self._log_level - self._log_level.mean())[:, None],
        )
        modes_only, modes_and_setups = self._residual_sum(modes), self._residual_sum(modes, setups)
        common_trend, trend_of_each_mode = (
            self._residual_sum(modes, log_level),
            self._residual_sum(modes, setups, slopes),
        )
        level_means, level_and_setup_means = (
            self._residual_sum(mode_levels),
            self._residual_sum(mode_levels, setups),
        )
        common_stratum = Stratum(
            modes_only[0] - common_trend[0],
            modes_only[1] - common_trend[1],
            level_means[0] - level_and_setup_means[0],
            level_means[1] - level_and_setup_means[1],
        )
        return common_stratum, Stratum(
            modes_and_setups[0] - trend_of_each_mode[0],
            modes_and_setups[1] - trend_of_each_mode[1],
            *level_and_setup_means,
        )

    def changes(self) -> Iterator[FrequencyChange]:
        """Yield the change of each mode."""
        modes = _indicator_columns(self._mode_number)
        slopes = modes * (self._log_level - self._log_level.mean())[:, None]
        design = self._whitened(np.hstack([modes, slopes]))
        values, *_ = np.linalg.lstsq(design, self._white_log_frequency, rcond=None)
        covariance, count = np.linalg.inv(design.T @ design), modes.shape[1]
        for k in range(count):
            mode_rows = np.flatnonzero(modes[:, k])
            span = float(np.ptp(self._log_level[mode_rows]))
            sigma = span * float(np.sqrt(covariance[count + k, count + k]))
            row_at_highest_level = mode_rows[int(self._log_level[mode_rows].argmax())]
            yield FrequencyChange(
                int(self.rows[row_at_highest_level]), float(np.expm1(span * values[count + k])), sigma
            )

    def _residual_sum(self, *designs: Array) -> tuple[float, int]:
        """Return the sum of squares of the residuals of a linear model, and its degrees of freedom."""
        design = self._whitened(np.hstack(designs))
        values, _, rank, _ = np.linalg.lstsq(design, self._white_log_frequency, rcond=1e-10)
        residuals = self._white_log_frequency - design @ values
        return float(residuals @ residuals), len(residuals) - int(rank)

    def _whitened(self, columns: Array) -> Array:
        return np.asarray(solve_triangular(self._cholesky, columns, lower=True))


def _indicator_columns(labels: NDArray[np.int_]) -> Array:
    """Return a column of ones and zeros for each label."""
    return np.asarray(labels[:, None] == np.unique(labels), dtype=float)


def level_steps(level: Array) -> NDArray[np.int_]:
    """Return the number of each level among the different ones, the lowest first."""
    order = np.argsort(level, kind="stable")
    steps, lowest_of_step, step = np.empty(len(level), dtype=int), np.inf, -1
    for i in order:
        if step < 0 or level[i] >= MIN_LEVEL_RATIO * lowest_of_step:
            lowest_of_step, step = level[i], step + 1
        steps[i] = step
    return steps


def _same_modes(data: Measurements, setups: Sequence[int], partner: Rows) -> Iterator[tuple[int, int]]:
    """Yield the rows of some setups, each with the number of its mode in the setup with most modes."""
    rows = [np.flatnonzero(data.pose == setup) for setup in setups]
    reference = max(rows, key=len)
    mode = {int(row): number for number, row in enumerate(reference)}
    yield from mode.items()
    for setup_rows in rows:
        if setup_rows is reference:
            continue
        for row, counterpart, _ in paired_rows(data, data, reference, setup_rows):
            if partner[row] == partner[counterpart]:
                yield counterpart, mode[row]
