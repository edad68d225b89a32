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
from pkmodes.modaltest.signals.checks import MIN_POINTS
from pkmodes.modaltest.signals.functions import Array

TOLERANCE = 0.01
#: Resolutions of times in files [s], and the largest possible resolution as a fraction of a step.
MICROSECOND, COARSE_RESOLUTIONS, MAX_RESOLUTION = 1e-6, (1e-2, 1e-3, 1e-4, 1e-5), 0.25
#: Last digits of rounded times [s], and largest distance of such a time from an even one, in last digits.
LAST_DIGITS, MAX_ROUNDING = tuple(10.0**-k for k in range(10)), 0.55
#: Samples at the end of a record from which its resolution is determined: late times have the fewest digits.
TAIL_SAMPLES = 1000
#: Share of uneven steps above which a record is sampled unevenly rather than interrupted.
MAX_GAP_SHARE = 0.05
#: Bridged gaps: largest distance from a whole number of steps, in steps; largest share of missing samples; and the
#: neighbours on either side from which these are interpolated.
STEP_TOLERANCE, MAX_MISSING_SHARE, SPLINE_NEIGHBOURS = 0.2, 0.1, 8
#: Delay across a gap in uneven times of even samples, in samples, by which all times after it are later than all
#: before it; and the fraction of the record examined on either side.
MIN_DELAY, SIDE_SHARE = 2.0, 0.1
#: Maximum number of gaps that are reported one by one.
MAX_GAPS_NAMED = 3
#: Samples examined at once.
PART_SIZE = 100_000


@dataclass(frozen=True)
class Piece:
    """An evenly sampled part of a record.

    - samples: its samples
    - step: mean interval of sampling [s]
    - numbers: number of each sample in even steps, (n,), if some are missing between them
    """

    samples: slice
    step: float
    numbers: NDArray[np.intp] | None = None

    def fill_gaps(self, signal: Array) -> Array:
        """Return the samples of a signal at every step, missing ones from a cubic spline through their neighbours."""
        values = signal[self.samples]
        if self.numbers is None:
            return values
        samples = np.empty(self.numbers[-1] + 1)
        samples[self.numbers] = values
        for i in np.flatnonzero(np.diff(self.numbers) > 1):
            neighbours = slice(max(0, i + 1 - SPLINE_NEIGHBOURS), i + 1 + SPLINE_NEIGHBOURS)
            missing = np.arange(self.numbers[i] + 1, self.numbers[i + 1])
            samples[missing] = CubicSpline(self.numbers[neighbours], values[neighbours])(missing)
        return samples

    def reinterpolated(self, filled: Array) -> Array:
        """Return filled samples with as many further ones removed, half way between the gaps, and interpolated.

        Their difference from the filled samples resembles the error of the filled samples.
        """
        numbers = np.arange(len(filled)) if self.numbers is None else self.numbers
        refilled, gaps = filled.copy(), np.flatnonzero(np.diff(numbers) > 1)
        for begin, end, next_begin in zip(
            numbers[gaps], numbers[gaps + 1], numbers[[*gaps[1:], -1]], strict=True
        ):
            first = (end + next_begin - (end - begin)) // 2 + 1
            removed = np.arange(first, first + end - begin - 1)
            neighbours = np.r_[
                max(0, first - SPLINE_NEIGHBOURS) : first,
                removed[-1] + 1 : removed[-1] + 1 + SPLINE_NEIGHBOURS,
            ]
            neighbours = neighbours[neighbours < len(filled)]
            if removed[-1] < len(filled):
                refilled[removed] = CubicSpline(neighbours, filled[neighbours])(removed)
        return refilled


def even_pieces(
    time: Array, where: str, max_bridged: float = 0.0
) -> tuple[tuple[Piece, ...], tuple[str, ...]]:
    """Split a record at its gaps.

    - time: strictly ascending, (n,) [s]
    - where: the record, for messages
    - max_bridged: longest gap, of whole missing samples, that does not split the record [s]

    Returns, in this order:
    - pieces: in time order; single samples between two gaps are left out
    - messages: about the gaps

    Raises MeasurementError if there are fewer than two samples, the sampling is uneven throughout, or too many
    samples are missing.
    """
    if time.size < MIN_POINTS:
        raise MeasurementError(
            f"expected at least {MIN_POINTS} samples, found {time.size}", where, "measure longer"
        )
    usual_step, max_breaks = _usual_step(time), max(1.0, MAX_GAP_SHARE * (time.size - 1))
    tolerance = TOLERANCE * usual_step + 4.0 * _precision(time)
    resolution_error = (
        MICROSECOND
        if _are_multiples(time, MICROSECOND) and MAX_RESOLUTION * usual_step >= MICROSECOND
        else 0.0
    )
    breaks = _find_breaks(time, usual_step, tolerance + resolution_error)
    if breaks.size > max_breaks:  # uneven throughout: perhaps times were written with few digits
        resolutions = [
            resolution
            for resolution in COARSE_RESOLUTIONS
            if resolution <= MAX_RESOLUTION * usual_step and _are_multiples(time[-TAIL_SAMPLES:], resolution)
        ]
        breaks = _find_breaks(time, usual_step, tolerance + resolutions[0]) if resolutions else breaks
    steps = time[breaks + 1] - time[breaks]
    counts = np.round(steps / usual_step).astype(np.intp)
    is_bridged = (
        (counts > 1)
        & (steps - usual_step <= max_bridged)
        & (np.abs(steps - counts * usual_step) <= STEP_TOLERANCE * usual_step)
    )
    missing = int((counts[is_bridged] - 1).sum())
    splits = breaks[~is_bridged]
    if splits.size > max_breaks:
        first_step = time[splits[0] + 1] - time[splits[0]]
        problem = (
            f"expected even sampling, found {splits.size} of {time.size - 1} steps that differ by 1 % or more"
        )
        problem += f" from {usual_step:.6g} s, first {first_step:.6g} s after {time[splits[0]]:.6g} s"
        remedy = "resample the signals evenly, or give the rate in the record if only the times are wrong"
        raise MeasurementError(problem, where, remedy)
    if missing > MAX_MISSING_SHARE * time.size:
        problem = f"expected a whole record, found {missing} samples missing beside {time.size}"
        raise MeasurementError(
            problem, where, "measure again, with a lower sampling rate if samples are lost"
        )
    edges = [0, *(int(i) + 1 for i in splits), time.size]
    pieces = [
        _make_piece(time, slice(low, high), breaks[is_bridged], counts[is_bridged])
        for low, high in pairwise(edges)
        if high - low >= MIN_POINTS
    ]
    gap_summary = _describe_gaps(time, breaks[is_bridged], usual_step, where)
    messages = [f"{gap_summary}: {missing} samples are interpolated"] if missing else []
    return tuple(pieces), (*messages, *_split_messages(time, splits, usual_step, where))


def stated_pieces(time: Array, rate: float, where: str) -> tuple[tuple[Piece, ...], tuple[str, ...]]:
    """Split a record of even samples with uneven times, such as arrival times, where samples are missing.

    From there on, all times are later.

    - time: strictly ascending, (n,) [s]
    - rate: sampling rate [Hz]
    - where: the record, for messages

    Returns, in this order:
    - pieces: in time order
    - messages: about the gaps
    """
    number = np.arange(time.size)
    slope, start = np.polyfit(number, time, 1)
    delays, half_width = time - (start + slope * number), int(0.5 * SIDE_SHARE * time.size)
    candidates = np.arange(half_width, time.size - 1 - half_width)
    later_min, earlier_max = (
        minimum_filter1d(delays, 2 * half_width + 1),
        maximum_filter1d(delays, 2 * half_width + 1),
    )
    gaps = candidates[
        (later_min[candidates + 1 + half_width] - earlier_max[candidates - half_width]) * rate >= MIN_DELAY
    ]
    edges = [0, *(int(k) + 1 for k in gaps), time.size]
    pieces = tuple(
        Piece(slice(low, high), 1.0 / rate) for low, high in pairwise(edges) if high - low >= MIN_POINTS
    )
    return pieces, _split_messages(time, gaps, 1.0 / rate, where)


def _make_piece(time: Array, samples: slice, gaps: NDArray[np.intp], steps: NDArray[np.intp]) -> Piece:
    """Return a part of a record with samples missing after `gaps`, each followed by the next one after `steps`."""
    in_samples = (gaps >= samples.start) & (gaps < samples.stop - 1)
    count, numbers = samples.stop - samples.start, None
    last = count - 1
    if in_samples.any():
        step_counts = np.ones(count, dtype=np.intp)
        step_counts[0] = 0
        step_counts[gaps[in_samples] + 1 - samples.start] = steps[in_samples]
        numbers = np.cumsum(step_counts)
        last = int(numbers[-1])
    return Piece(samples, float(time[samples.stop - 1] - time[samples.start]) / last, numbers)


def _split_messages(time: Array, breaks: NDArray[np.intp], usual_step: float, where: str) -> tuple[str, ...]:
    """Return a message for each gap that splits the record, or one for all of many gaps."""
    if breaks.size <= MAX_GAPS_NAMED:
        return tuple(
            f"{where}: the step from {time[i]:.6g} s to {time[i + 1]:.6g} s is"
            f" {(time[i + 1] - time[i]) / usual_step:.4g} times the usual one: the record is split there"
            for i in breaks
        )
    return (f"{_describe_gaps(time, breaks, usual_step, where)}: the record is split there",)


def _describe_gaps(time: Array, breaks: NDArray[np.intp], usual_step: float, where: str) -> str:
    """Describe the number of gaps, their length, and their share of the record."""
    if not breaks.size:
        return ""
    gap_lengths = time[breaks + 1] - time[breaks] - usual_step
    share = 100.0 * gap_lengths.sum() / (time[-1] - time[0])
    shortest, longest = 1e3 * gap_lengths.min(), 1e3 * gap_lengths.max()
    length_text = (
        f"{plain(longest, 3)} ms"
        if longest <= 1.05 * shortest
        else f"{plain(shortest, 3)} to {plain(longest, 3)} ms"
    )
    gaps = "1 gap" if breaks.size == 1 else f"{breaks.size} gaps"
    first = f"the first at {time[breaks[0]]:.6g} s"
    return f"{where}: {gaps} of {length_text}, {plain(share, 2)} % of the record, {first}"


def even_times(count: int, rate: float) -> Array:
    """Return the times of samples at a rate [Hz], from 0 [s], without a temporary array."""
    times: Array = np.arange(count, dtype=np.float64)
    times /= rate
    return times


def restore_even_times(time: Array) -> Array:
    """Return the even times of a record whose times were rounded; the times themselves if they have enough digits.

    Times printed with few digits differ from even ones by up to half the last digit, and may repeat.

    - time: (n,) [s]
    """
    if time.size <= MIN_POINTS:
        return time
    mean_step = float(time[-1] - time[0]) / (time.size - 1)
    if not mean_step > 0.0 or all(
        np.all(np.abs(np.diff(part) - mean_step) <= TOLERANCE * mean_step)
        for _, part in _overlapping_parts(time)
    ):
        return time
    last_digit = next((digit for digit in LAST_DIGITS if _are_multiples(time[-TAIL_SAMPLES:], digit)), 0.0)
    restored: Array = np.arange(time.size, dtype=float)  # in place: a long record fills much of the memory
    restored -= 0.5 * (time.size - 1)
    restored *= float(restored @ time) / float(restored @ restored)
    restored += float(time.mean())
    deviation = max(
        float(np.abs(part - restored[low : low + part.size]).max()) for low, part in _overlapping_parts(time)
    )
    return restored if deviation <= MAX_ROUNDING * last_digit else time


def counts_samples(time: Array) -> bool:
    """Return whether so-called times are sample numbers: whole, consecutive, from 0 or 1."""
    return bool(time.size > MIN_POINTS and time[0] in (0.0, 1.0) and np.all(np.diff(time) == 1.0))


def _find_breaks(time: Array, usual_step: float, tolerance: float) -> NDArray[np.intp]:
    """Return the samples after which a step differs from the usual one by more than a tolerance."""
    breaks = [
        low + np.flatnonzero(np.abs(np.diff(part) - usual_step) > tolerance)
        for low, part in _overlapping_parts(time)
    ]
    return np.concatenate(breaks)


def _are_multiples(time: Array, unit: float) -> bool:
    """Return whether times are whole multiples of a unit, within the precision of numbers of their size."""
    tolerance = 0.05 + 4.0 * _precision(time) / unit
    counts = (part / unit for _, part in _overlapping_parts(time))
    return tolerance < 0.5 and not any(
        np.any(np.abs(count - np.round(count)) > tolerance) for count in counts
    )


def _precision(time: Array) -> float:
    """Return the spacing of floating-point numbers at the largest time, of single precision if all times fit it."""
    last_times = time[[0, *range(-min(TAIL_SAMPLES, time.size), 0)]]
    in_single_precision = last_times.astype(np.float32)
    largest = int(np.abs(last_times).argmax())
    return float(
        np.spacing(
            (in_single_precision if np.array_equal(in_single_precision, last_times) else last_times)[largest]
        )
    )


def _usual_step(time: Array) -> float:
    """Return the median of the steps, or of a sample of them for a long record."""
    first = np.arange(0, time.size - 1, 1 + time.size // PART_SIZE)
    return float(np.median(time[first + 1] - time[first]))


def _overlapping_parts(time: Array) -> Iterator[tuple[int, Array]]:
    """Yield parts of the times that share a sample with the next, and the number of their first one.

    A long record fills much of the memory: nothing else here is as long.
    """
    for low in range(0, time.size - 1, PART_SIZE):
        yield low, time[low : low + PART_SIZE + 1]
