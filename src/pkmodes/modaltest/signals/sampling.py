"""Times of samples: even parts of a record, and the gaps between them.

Steps that differ by less than 1 % are even.  Loggers write times in whole microseconds, which moves a step by up to
one of them; over a record this averages out, so that the mean step is that of the clock.  The uneven abscissa of a
universal file has six digits: the steps of a whole record then differ, by no more than the last digit.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.signals.checks import FEWEST
from pkmodes.modaltest.signals.functions import Array

TOLERANCE = 0.01
#: Resolutions of times in files [s], and the largest possible resolution as a fraction of a step.
MICROSECOND, COARSE, FINE = 1e-6, (1e-2, 1e-3, 1e-4, 1e-5), 0.25
#: Last digits of rounded times [s], and largest distance of such a time from an even one, in last digits.
ROUNDED, HALF = tuple(10.0**-k for k in range(10)), 0.55
#: Samples at the end of a record from which its resolution is determined: late times have the fewest digits.
TAIL = 1000
#: Share of uneven steps above which a record is sampled unevenly rather than interrupted.
MOST_GAPS = 0.05
#: Bridged gaps: largest distance from a whole number of steps, in steps; largest share of missing samples; and the
#: neighbours on either side from which these are interpolated.
WHOLE, MOST_MISSING, NEIGHBOURS = 0.2, 0.1, 8
#: Delay across a gap in uneven times of even samples, in samples, by which all times after it are later than all
#: before it; and the fraction of the record examined on either side.
LATER, AROUND = 2.0, 0.1
#: Most gaps that are reported one by one.
MOST_NAMED = 3
#: Samples examined at once.
PART = 100_000


@dataclass(frozen=True)
class Piece:
    """An evenly sampled part of a record.

    - part: its samples
    - step: mean interval of sampling [s]
    - numbers: number of each sample in even steps, (n,), if some are missing between them
    """

    part: slice
    step: float
    numbers: NDArray[np.intp] | None = None

    def filled(self, signal: Array) -> Array:
        """Return the samples of a signal at every step, missing ones from a cubic spline through their neighbours."""
        values = signal[self.part]
        if self.numbers is None:
            return values
        samples = np.empty(self.numbers[-1] + 1)
        samples[self.numbers] = values
        for i in np.flatnonzero(np.diff(self.numbers) > 1):
            near = slice(max(0, i + 1 - NEIGHBOURS), i + 1 + NEIGHBOURS)
            missing = np.arange(self.numbers[i] + 1, self.numbers[i + 1])
            samples[missing] = CubicSpline(self.numbers[near], values[near])(missing)
        return samples

    def reinterpolated(self, filled: Array) -> Array:
        """Return filled samples with as many further ones removed, half way between the gaps, and interpolated.

        Their difference from the filled samples resembles the error of the filled samples.
        """
        numbers = np.arange(len(filled)) if self.numbers is None else self.numbers
        refilled, gaps = filled.copy(), np.flatnonzero(np.diff(numbers) > 1)
        for begin, end, after in zip(numbers[gaps], numbers[gaps + 1], numbers[[*gaps[1:], -1]], strict=True):
            first = (end + after - (end - begin)) // 2 + 1
            lost = np.arange(first, first + end - begin - 1)
            near = np.r_[max(0, first - NEIGHBOURS) : first, lost[-1] + 1 : lost[-1] + 1 + NEIGHBOURS]
            near = near[near < len(filled)]
            if lost[-1] < len(filled):
                refilled[lost] = CubicSpline(near, filled[near])(lost)
        return refilled


def even_pieces(time: Array, where: str, bridged: float = 0.0) -> tuple[tuple[Piece, ...], tuple[str, ...]]:
    """Split a record at its gaps.

    - time: strictly ascending, (n,) [s]
    - where: the record, for messages
    - bridged: longest gap, of whole missing samples, that does not split the record [s]

    Returns, in this order:
    - pieces: in time order; single samples between two gaps are left out
    - messages: about the gaps

    Raises MeasurementError if there are fewer than two samples, the sampling is uneven throughout, or too many
    samples are missing.
    """
    if time.size < FEWEST:
        raise MeasurementError(
            f"expected at least {FEWEST} samples, found {time.size}", where, "measure longer"
        )
    usual, most_breaks = _usual_step(time), max(1.0, MOST_GAPS * (time.size - 1))
    tolerance = TOLERANCE * usual + 4.0 * _precision(time)
    fine = MICROSECOND if _are_multiples(time, MICROSECOND) and FINE * usual >= MICROSECOND else 0.0
    breaks = _breaks(time, usual, tolerance + fine)
    if breaks.size > most_breaks:  # uneven throughout: perhaps times were written with few digits
        coarse = [
            resolution
            for resolution in COARSE
            if resolution <= FINE * usual and _are_multiples(time[-TAIL:], resolution)
        ]
        breaks = _breaks(time, usual, tolerance + coarse[0]) if coarse else breaks
    steps = time[breaks + 1] - time[breaks]
    counts = np.round(steps / usual).astype(np.intp)
    short = (counts > 1) & (steps - usual <= bridged) & (np.abs(steps - counts * usual) <= WHOLE * usual)
    missing = int((counts[short] - 1).sum())
    splits = breaks[~short]
    if splits.size > most_breaks:
        worst = time[splits[0] + 1] - time[splits[0]]
        problem = (
            f"expected even sampling, found {splits.size} of {time.size - 1} steps that differ by 1 % or more"
        )
        problem += f" from {usual:.6g} s, first {worst:.6g} s after {time[splits[0]]:.6g} s"
        remedy = "resample the signals evenly, or give the rate in the record if only the times are wrong"
        raise MeasurementError(problem, where, remedy)
    if missing > MOST_MISSING * time.size:
        problem = f"expected a whole record, found {missing} samples missing beside {time.size}"
        raise MeasurementError(
            problem, where, "measure again, with a lower sampling rate if samples are lost"
        )
    edges = [0, *(int(i) + 1 for i in splits), time.size]
    pieces = [
        _piece(time, slice(low, high), breaks[short], counts[short])
        for low, high in pairwise(edges)
        if high - low >= FEWEST
    ]
    of_bridged = _summed(time, breaks[short], usual, where)
    messages = [f"{of_bridged}: {missing} samples are interpolated"] if missing else []
    return tuple(pieces), (*messages, *_split_messages(time, splits, usual, where))


def stated_pieces(time: Array, rate: float, where: str) -> tuple[tuple[Piece, ...], tuple[str, ...]]:
    """Split a record of even samples with uneven times, such as arrival times, where samples are missing.

    From there on, all times are later.

    - time: strictly ascending, (n,) [s]
    - rate: of sampling [Hz]
    - where: the record, for messages

    Returns, in this order:
    - pieces: in time order
    - messages: about the gaps
    """
    number = np.arange(time.size)
    slope, start = np.polyfit(number, time, 1)
    late, half = time - (start + slope * number), int(0.5 * AROUND * time.size)
    i = np.arange(half, time.size - 1 - half)
    after, before = minimum_filter1d(late, 2 * half + 1), maximum_filter1d(late, 2 * half + 1)
    gaps = i[(after[i + 1 + half] - before[i - half]) * rate >= LATER]
    edges = [0, *(int(k) + 1 for k in gaps), time.size]
    pieces = tuple(
        Piece(slice(low, high), 1.0 / rate) for low, high in pairwise(edges) if high - low >= FEWEST
    )
    return pieces, _split_messages(time, gaps, 1.0 / rate, where)


def _piece(time: Array, part: slice, gaps: NDArray[np.intp], steps: NDArray[np.intp]) -> Piece:
    """Return a part of a record with samples missing after `gaps`, each followed by the next one after `steps`."""
    inside = (gaps >= part.start) & (gaps < part.stop - 1)
    count, numbers = part.stop - part.start, None
    last = count - 1
    if inside.any():
        step_counts = np.ones(count, dtype=np.intp)
        step_counts[0] = 0
        step_counts[gaps[inside] + 1 - part.start] = steps[inside]
        numbers = np.cumsum(step_counts)
        last = int(numbers[-1])
    return Piece(part, float(time[part.stop - 1] - time[part.start]) / last, numbers)


def _split_messages(time: Array, breaks: NDArray[np.intp], usual: float, where: str) -> tuple[str, ...]:
    """Return a message for each gap that splits the record, or one for all of many gaps."""
    if breaks.size <= MOST_NAMED:
        return tuple(
            f"{where}: the step from {time[i]:.6g} s to {time[i + 1]:.6g} s is"
            f" {(time[i + 1] - time[i]) / usual:.4g} times the usual one: the record is split there"
            for i in breaks
        )
    return (f"{_summed(time, breaks, usual, where)}: the record is split there",)


def _summed(time: Array, breaks: NDArray[np.intp], usual: float, where: str) -> str:
    """Describe the number of gaps, their length, and their share of the record."""
    if not breaks.size:
        return ""
    lost = time[breaks + 1] - time[breaks] - usual
    share = 100.0 * lost.sum() / (time[-1] - time[0])
    least, longest = 1e3 * lost.min(), 1e3 * lost.max()
    size = (
        f"{plain(longest, 3)} ms"
        if longest <= 1.05 * least
        else f"{plain(least, 3)} to {plain(longest, 3)} ms"
    )
    gaps = "1 gap" if breaks.size == 1 else f"{breaks.size} gaps"
    return (
        f"{where}: {gaps} of {size}, {plain(share, 2)} % of the record, the first at {time[breaks[0]]:.6g} s"
    )


def even_times(count: int, rate: float) -> Array:
    """Return the times of samples at a rate [Hz], from 0 [s], without a temporary array."""
    times: Array = np.arange(count, dtype=np.float64)
    times /= rate
    return times


def as_sampled(time: Array) -> Array:
    """Return the even times of a record whose times were rounded; the times themselves if they have enough digits.

    Times printed with few digits differ from even ones by up to half the last digit, and may repeat.

    - time: (n,) [s]
    """
    if time.size <= FEWEST:
        return time
    mean = float(time[-1] - time[0]) / (time.size - 1)
    if not mean > 0.0 or all(
        np.all(np.abs(np.diff(part) - mean) <= TOLERANCE * mean) for _, part in _parts(time)
    ):
        return time
    last_digit = next((digit for digit in ROUNDED if _are_multiples(time[-TAIL:], digit)), 0.0)
    even: Array = np.arange(time.size, dtype=float)  # in place: a long record fills much of the memory
    even -= 0.5 * (time.size - 1)
    even *= float(even @ time) / float(even @ even)
    even += float(time.mean())
    apart = max(float(np.abs(part - even[low : low + part.size]).max()) for low, part in _parts(time))
    return even if apart <= HALF * last_digit else time


def counts_samples(time: Array) -> bool:
    """Return whether so-called times are sample numbers: whole, consecutive, from 0 or 1."""
    return bool(time.size > FEWEST and time[0] in (0.0, 1.0) and np.all(np.diff(time) == 1.0))


def _breaks(time: Array, usual: float, tolerance: float) -> NDArray[np.intp]:
    """Return the samples after which a step differs from the usual one by more than a tolerance."""
    breaks = [low + np.flatnonzero(np.abs(np.diff(part) - usual) > tolerance) for low, part in _parts(time)]
    return np.concatenate(breaks)


def _are_multiples(time: Array, unit: float) -> bool:
    """Return whether times are whole multiples of a unit, within the precision of numbers of their size."""
    doubt = 0.05 + 4.0 * _precision(time) / unit
    counts = (part / unit for _, part in _parts(time))
    return doubt < 0.5 and not any(np.any(np.abs(count - np.round(count)) > doubt) for count in counts)


def _precision(time: Array) -> float:
    """Return the spacing of floating-point numbers at the largest time, of single precision if all times fit it."""
    tail = time[[0, *range(-min(TAIL, time.size), 0)]]
    single = tail.astype(np.float32)
    largest = int(np.abs(tail).argmax())
    return float(np.spacing((single if np.array_equal(single, tail) else tail)[largest]))


def _usual_step(time: Array) -> float:
    """Return the median of the steps, or of a sample of them for a long record."""
    first = np.arange(0, time.size - 1, 1 + time.size // PART)
    return float(np.median(time[first + 1] - time[first]))


def _parts(time: Array) -> Iterator[tuple[int, Array]]:
    """Yield parts of the times that share a sample with the next, and the number of their first one.

    A long record fills much of the memory: nothing else here is as long.
    """
    for low in range(0, time.size - 1, PART):
        yield low, time[low : low + PART + 1]
