"""Checks that measured signals of every format must pass."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import Array

#: Minimum number of points: a frequency response needs two lines for a spacing, a signal two samples for a rate.
MIN_POINTS = 2
#: Largest distance of a coherence from the range 0 to 1: rounding of sums over a thousand averages in single
#: precision, or of four decimals.  More is another quantity, or another unit.
ROUNDING = 1e-4
#: Range of the largest value of a coherence in per cent: a coherence below 2 % everywhere would be no measurement.
PER_CENT = (2.0, 100.0 * (1.0 + ROUNDING))


def check_finite(values: NDArray[Any], where: str, preceding: int = 0) -> None:
    """Refuse values that are not finite.

    - preceding: number of values of the same signal before them

    Raises MeasurementError with the number of the first bad value.
    """
    invalid = np.flatnonzero(~np.isfinite(values))
    if invalid.size:
        with np.errstate(invalid="ignore"):  # some NaN of single precision
            problem = (
                f"expected finite numbers, found {values[invalid[0]]} as value {preceding + invalid[0] + 1}"
            )
        raise MeasurementError(problem, where, "export the file again, or leave this signal out of it")


def band_slice(abscissa: Array, band: tuple[float, float] | None) -> slice:
    """Return the points of an ascending abscissa in a band; all points if the band is None."""
    if band is None:
        return slice(0, abscissa.size)
    return slice(int(np.searchsorted(abscissa, band[0])), int(np.searchsorted(abscissa, band[1], "right")))


def check_abscissa(abscissa: Array, where: str) -> None:
    """Refuse an abscissa that is too short, not finite or not ascending.

    Raises MeasurementError with the number of the first wrong point.
    """
    if abscissa.size < MIN_POINTS:
        problem = f"expected at least {MIN_POINTS} points, found {abscissa.size or 'none'}"
        raise MeasurementError(problem, where, "export the whole measurement")
    check_finite(abscissa, where)
    descending = np.flatnonzero(np.diff(abscissa) <= 0.0)
    if descending.size:
        before, after = abscissa[descending[0]], abscissa[descending[0] + 1]
        problem = f"expected ascending times or frequencies, found {after:.10g} after {before:.10g}"
        remedy = "sort the points, and give each time or frequency once, with enough digits"
        raise MeasurementError(problem, f"{where}, point {descending[0] + 2}", remedy)


def find_invalid_coherence(values: NDArray[Any]) -> tuple[int, str, str] | None:
    """Return the index of the first invalid coherence, the problem and its remedy; None if all are valid.

    - values: finite, (n,)
    """
    invalid = np.flatnonzero((values < -ROUNDING) | (values > 1.0 + ROUNDING))
    if not invalid.size:
        return None
    per_cent = values.min() >= 0.0 and PER_CENT[0] < values.max() <= PER_CENT[1]
    remedy = "divide it by 100 if it is in per cent" if per_cent else "export the coherence again"
    return int(invalid[0]), f"expected a coherence from 0 to 1, found {values[invalid[0]]:.10g}", remedy


def check_coherence(values: NDArray[Any], where: str) -> None:
    """Refuse a coherence outside 0 to 1.

    Raises MeasurementError with the number of the first wrong value.
    """
    fault = find_invalid_coherence(values)
    if fault is not None:
        index, problem, remedy = fault
        raise MeasurementError(f"{problem} as value {index + 1}", where, remedy)
