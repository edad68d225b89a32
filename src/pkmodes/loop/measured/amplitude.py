"""Frequencies that depend on the level of excitation, as no linear machine's do.

Setups that differ in nothing but their level are regressed: ln f of each mode on the logarithm of the level.  Modes
of one setup may share an error, such as a warmer machine, so the analysis of variance has two strata, as of split
plots: what the modes of a setup have in common, and how they differ from each other.  In each, the trend is compared
with the stated errors and, where a level was repeated, with the scatter of its setups.  Where none was, how well
setups repeat is not known: the trend must be clear even with errors twice as large, and shared by the modes of each.
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
DIFFER = 1.25
#: Largest p-value of a dependence that is reported.
SURE = 1e-3
#: Degrees of freedom that the stated errors are worth, beside the scatter of setups at one level.
WORTH = 4.0
#: Factor by which the true errors may exceed the stated ones where no level was repeated.
UNKNOWN = 2.0
#: Standard deviations from which a change is clear; a change whose standard deviation is more than this fraction of
#: the clearest change is not reported.
CLEAR, KNOWN = 3.0, 0.5


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
    - changes: of each mode at each position
    - squares: what the trend explains of the scatter, in units of the stated variances
    - p_value: of so clear a trend if nothing depends on the level
    - repeated: whether the scatter of setups at one level was known
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
        return self.p_value < SURE

    @property
    def clearest(self) -> FrequencyChange:
        """The change that is clearest against its error."""
        return max(self.changes, key=lambda change: abs(change.sigmas))

    @property
    def range(self) -> tuple[float, float]:
        """Smallest and largest relative change, of the modes for which it is known well enough."""
        limit = KNOWN * abs(self.clearest.relative)
        reliable = [change.relative for change in self.changes if change.sigma <= limit] or [
            self.clearest.relative
        ]
        return min(reliable), max(reliable)

    @property
    def direction(self) -> int:
        """1 where all clear changes are upwards, -1 where all are downwards, else 0."""
        clear = [change.relative for change in self.changes if abs(change.sigmas) > CLEAR] or [
            self.clearest.relative
        ]
        return 0 if min(clear) < 0.0 < max(clear) else int(np.sign(clear[0]))


class Stratum(NamedTuple):
    """Sums of squares and degrees of freedom, of the trend and of the scatter at one level."""

    trend: float
    of_trend: int
    scatter: float
    of_scatter: int

    def p_value(self, usual: float) -> float:
        """Return the p-value of the trend; `usual` is the expected variance relative to the stated one."""
        if not self.of_scatter:
            return float(stats.chi2.sf(self.trend / (UNKNOWN**2 * usual), self.of_trend))
        worth = WORTH + self.of_scatter
        variance = max((WORTH * usual + self.scatter) / worth, 1.0)
        return float(stats.f.sf(self.trend / self.of_trend / variance, self.of_trend, worth))


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
    plots = [_Plots.of(data, group, partner, motion) for group in groups]
    usable = [plot for plot in plots if plot is not None]
    if not usable:
        return None
    common, rest = ([plot.strata[k] for plot in usable] for k in (0, 1))
    # Modes of a setup that share an error as large as the stated one scatter together by that, not by their mean.
    modes = float(np.mean([plot.modes_of_a_setup for plot in usable]))
    p_values = [_sum(common).p_value(modes)]
    if any(stratum.of_trend for stratum in rest):
        p_values.append(_sum(rest).p_value(1.0))
    levels = np.concatenate([data.level[data.pose[plot.rows]] for plot in usable])
    return AmplitudeDependence(
        low=float(levels.min()),
        high=float(levels.max()),
        changes=tuple(change for plot in usable for change in plot.changes()),
        squares=sum(stratum.trend for stratum in (*common, *rest)),
        p_value=min(len(p_values) * min(p_values), 1.0),
        repeated=any(stratum.of_scatter for stratum in (*common, *rest)),
    )


def _sum(strata: Sequence[Stratum]) -> Stratum:
    trend, of_trend, scatter, of_scatter = (sum(column) for column in zip(*strata, strict=True))
    return Stratum(trend, int(of_trend), scatter, int(of_scatter))


class _Plots:
    """The modes of setups that differ in their level alone.

    - rows, mode: rows, and which mode of the position each is, (n,)
    - root: Cholesky factor of the covariance of their ln f, (n, n)
    """

    def __init__(self, data: Measurements, rows: Rows, mode: Rows, root: Array) -> None:
        self.rows, self._mode, self._root = rows, mode, root
        self._setup, level = data.pose[rows], data.level[data.pose[rows]]
        self._along = np.log(level)
        self._step = level_steps(level)
        self._log = self._white(np.log(data.frequency[rows])[:, None])[:, 0]

    @classmethod
    def of(
        cls, data: Measurements, setups: Sequence[int], partner: Rows, motion: Array | None
    ) -> _Plots | None:
        """Return the modes that were measured at two levels or more; None if there are none."""
        excited = [i for i in setups if np.isfinite(data.level[i])]
        if len(excited) < 2 or data.level[excited].max() < DIFFER * data.level[excited].min():
            return None
        pairs = list(_same_modes(data, excited, partner))
        steps = level_steps(data.level[data.pose[[row for row, _ in pairs]]])
        at: dict[int, set[int]] = {}
        for (_, mode), step in zip(pairs, steps, strict=True):
            at.setdefault(mode, set()).add(int(step))
        pairs = [pair for pair in pairs if len(at[pair[1]]) > 1]
        if not pairs:
            return None
        rows, mode = np.array(pairs, dtype=np.intp).T
        V = np.diag((data.sigma[rows] / data.frequency[rows]) ** 2)
        if motion is not None:
            same_setup = data.pose[rows][:, None] == data.pose[rows]
            V += same_setup * ((motion[rows] * data.point_sigma[data.pose[rows]] ** 2) @ motion[rows].T)
        return cls(data, rows, mode, np.linalg.cholesky(V))

    @property
    def modes_of_a_setup(self) -> float:
        """Mean number of modes."""
        return len(self.rows) / len(set(self._setup.tolist()))

    @property
    def strata(self) -> tuple[Stratum, Stratum]:
        """What the modes of a setup have in common, and how they differ from each other."""
        modes, setups = _columns(self._mode), _columns(self._setup)
        cells = _columns(self._mode * (1 + self._step.max()) + self._step)
        along, slopes = self._along[:, None], modes * (self._along - self._along.mean())[:, None]
        plain, beside = self._residual_sum(modes), self._residual_sum(modes, setups)
        trend, individual = self._residual_sum(modes, along), self._residual_sum(modes, setups, slopes)
        within, within_setups = self._residual_sum(cells), self._residual_sum(cells, setups)
        common = Stratum(
            plain[0] - trend[0],
            plain[1] - trend[1],
            within[0] - within_setups[0],
            within[1] - within_setups[1],
        )
        return common, Stratum(beside[0] - individual[0], beside[1] - individual[1], *within_setups)

    def changes(self) -> Iterator[FrequencyChange]:
        """Yield the change of each mode."""
        modes = _columns(self._mode)
        slopes = modes * (self._along - self._along.mean())[:, None]
        design = self._white(np.hstack([modes, slopes]))
        values, *_ = np.linalg.lstsq(design, self._log, rcond=None)
        covariance, count = np.linalg.inv(design.T @ design), modes.shape[1]
        for k in range(count):
            of_mode = np.flatnonzero(modes[:, k])
            span = float(np.ptp(self._along[of_mode]))
            sigma = span * float(np.sqrt(covariance[count + k, count + k]))
            highest = of_mode[int(self._along[of_mode].argmax())]
            yield FrequencyChange(int(self.rows[highest]), float(np.expm1(span * values[count + k])), sigma)

    def _residual_sum(self, *designs: Array) -> tuple[float, int]:
        """Return the sum of squares that a linear model leaves, and its degrees of freedom."""
        design = self._white(np.hstack(designs))
        values, _, rank, _ = np.linalg.lstsq(design, self._log, rcond=1e-10)
        residuals = self._log - design @ values
        return float(residuals @ residuals), len(residuals) - int(rank)

    def _white(self, columns: Array) -> Array:
        return np.asarray(solve_triangular(self._root, columns, lower=True))


def _columns(labels: NDArray[np.int_]) -> Array:
    """Return a column of ones and zeros for each label."""
    return np.asarray(labels[:, None] == np.unique(labels), dtype=float)


def level_steps(level: Array) -> NDArray[np.int_]:
    """Return the number of each level among those that differ, the lowest first."""
    order = np.argsort(level, kind="stable")
    steps, lowest, step = np.empty(len(level), dtype=int), np.inf, -1
    for i in order:
        if step < 0 or level[i] >= DIFFER * lowest:
            lowest, step = level[i], step + 1
        steps[i] = step
    return steps


def _same_modes(data: Measurements, setups: Sequence[int], partner: Rows) -> Iterator[tuple[int, int]]:
    """Yield the rows of some setups with the number of their mode, from those of the setup with most modes."""
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
