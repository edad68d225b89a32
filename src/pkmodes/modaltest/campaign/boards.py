"""Files that boards with clocks of their own recorded together: brought to the clock of the first, on one grid.

The uncertainty of a clock rotates a shape: 1 ms is 18 degrees at 50 Hz.  Up to `MAX_CLOCK_PHASE` the rotation enters
the standard deviation of the shape; beyond it the sign is unknown, and the components of that board are left out.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.modaltest.campaign.description import RecordTable, parse_uncertain
from pkmodes.modaltest.identification.clocks import Delay, delay, rough_delay
from pkmodes.modaltest.identification.estimates import Mode, rotate_to_real
from pkmodes.modaltest.signals.checks import MIN_POINTS

Array = NDArray[np.float64]
Spans = list[tuple[float, float]]
#: Kind of record that boards share: responses in time.
RESPONSES = "ambient"
#: Standard deviation of the times with which a host stamps the samples of several boards [s].
HOST_TIME_SIGMA = 2e-4
#: Largest rotation of a shape by one standard deviation of a clock: at twice this, its sign is lost [rad].
MAX_CLOCK_PHASE = math.pi / 4.0
#: Largest drift of clocks whose files state their rates, such as 1300 Hz rounded to whole numbers.
MAX_DRIFT = 5e-4
#: Search range of a clock offset: after a rough comparison, in stated standard deviations, and when checking a common
#: clock [s, -, s].
ROUGH_RANGE, SEARCH_SIGMAS, COMMON_CLOCK_RANGE = 0.1, 4.0, 0.01
#: Highest frequency used to compare clocks: the grid of delays and drifts grows with its square [Hz].
MAX_COMPARED_FREQUENCY = 250.0
#: A common clock that is off by less is not reported [s].
MIN_REPORTED_OFFSET = 1e-3
#: Longest part of a record over which separate clocks are compared [s].
MAX_COMPARED_TIME = 300.0
#: Highest frequency, relative to the sampling rate, at which splines of this degree are accurate to 0.3 %.
MAX_RELATIVE_FREQUENCY, SPLINE_DEGREE = 0.25, 5
#: Samples that a spline includes on either side of the requested times.
SPLINE_MARGIN = 32


@dataclass(frozen=True)
class Clock:
    """The clock of a board relative to that of the first.

    - offset, sigma: offset to add to its times to get those of the first board, and its standard deviation, infinite
      if unknown [s]
    - common: whether both boards have one clock
    """

    offset: float
    sigma: float
    common: bool = False


def read_clocks(table: RecordTable, files: Mapping[str, Sequence[str]], where: str) -> dict[str, Clock]:
    """Return the clocks of all boards except the first.

    Raises MeasurementError if they are invalid, or the boards have different numbers of files.
    """
    where = f"{where}.clock"
    first, *other_boards = files
    if table.kind != RESPONSES or not other_boards or len({len(listed) for listed in files.values()}) > 1:
        problem = f"expected the kind {RESPONSES}, and as many files of each board, with clock"
        counts = ", ".join(f"{len(listed)} of {shown(name)}" for name, listed in files.items())
        remedy = (
            'write files = { head = ["head_1.csv"], bed = ["bed_1.csv"] }, recorded together in this order'
        )
        raise MeasurementError(f"{problem}, found {shown(table.kind)} and {counts}", where, remedy)
    if table.clock == "common":
        return {name: Clock(0.0, HOST_TIME_SIGMA, common=True) for name in other_boards}
    if table.clock == "own":
        return {name: Clock(0.0, math.inf) for name in other_boards}
    if not isinstance(table.clock, dict) or set(table.clock) != set(other_boards):
        stated_clock = (
            shown(table.clock) if isinstance(table.clock, str) else ", ".join(map(shown, table.clock or ()))
        )
        problem = f'expected "common", "own", or a table of {", ".join(other_boards)}, found {stated_clock or "none"}'
        remedy = (
            f"for example, to have times of {first}: "
            f'{{ {other_boards[0]} = {{ value = "12 ms", sigma = "3 ms" }} }}'
        )
        raise MeasurementError(problem, where, remedy)
    return {name: Clock(*parse_uncertain(table.clock[name], "s", f"{where}.{name}")) for name in other_boards}


class UnknownOffsetError(Exception):
    """The offset between the clocks of two files cannot be determined."""


@dataclass(frozen=True, eq=False)
class Board:
    """The signals of a board.

    - file: name of the file, for messages
    - step: between samples [s]
    - starts: time of the first sample of each piece [s]
    - pieces: each (n_i, S)
    """

    file: str
    step: float
    starts: tuple[float, ...]
    pieces: tuple[Array, ...]

    @property
    def spans(self) -> Spans:
        """First and last time of each piece."""
        return [
            (start, start + (len(piece) - 1) * self.step)
            for start, piece in zip(self.starts, self.pieces, strict=True)
        ]

    def with_delay(self, added: Delay) -> Board:
        """Return the board with a delay added to its times."""
        starts = tuple(start + added.seconds + added.drift * (start - added.middle) for start in self.starts)
        return replace(self, starts=starts, step=self.step * (1.0 + added.drift))

    def resample(self, first: float, step: float, count: int) -> Array:
        """Return the signals at even times within a piece."""
        i = int(np.searchsorted(self.starts, first, side="right")) - 1
        samples = (first - self.starts[i] + step * np.arange(count)) / self.step
        low = max(math.floor(samples[0]) - SPLINE_MARGIN, 0)
        values = self.pieces[i][low : math.ceil(samples[-1]) + SPLINE_MARGIN]
        last = len(values) - 1
        spline = make_interp_spline(np.arange(last + 1), values, k=min(SPLINE_DEGREE, last))
        return np.asarray(spline((samples - low).clip(0.0, last)))


@dataclass(frozen=True, eq=False)
class AlignedBoards:
    """Signals of several boards on one grid.

    - step: [s]
    - starts: [s]
    - pieces: pieces of all boards, in their order, each (n_i, S)
    - delays: delay added to the times of each board except the first, by setup
    """

    step: float
    starts: tuple[float, ...]
    pieces: tuple[Array, ...]
    delays: Mapping[str, Delay]
    messages: tuple[str, ...]


def align_boards(
    boards: Mapping[str, Board], clocks: Mapping[str, Clock], band: tuple[float, float]
) -> AlignedBoards:
    """Return the signals of all boards by the clock of the first one.

    Raises MeasurementError if a board samples too slowly, or the times of the boards have nothing in common.
    Raises UnknownOffsetError if a clock of its own cannot be compared with the first.
    """
    for board in boards.values():
        highest = MAX_RELATIVE_FREQUENCY / board.step
        if band[1] > highest * (1.0 + 1e-6):  # the rate may have been reduced to exactly that
            problem = f"expected a band up to a quarter of the sampling rate, {highest:.4g} Hz"
            remedy = "narrow the band of the record, or sample faster"
            raise MeasurementError(f"{problem}, found {band[1]:g} Hz", board.file, remedy)
        if board.starts[0] == 0.0 and any(clock.common for clock in clocks.values()):
            problem = "expected times of one clock, found ones that are counted from the first sample"
            remedy = (
                'write clock = "own", or what is known: clock = { bed = { value = "0 ms", sigma = "2 ms" } }'
            )
            raise MeasurementError(problem, board.file, remedy)
    aligned = [next(iter(boards.values()))]
    delays, messages = dict[str, Delay](), list[str]()
    for setup, clock in clocks.items():
        board_delay, message = _compare_clocks(aligned[0], boards[setup], clock, band)
        aligned.append(boards[setup].with_delay(board_delay))
        delays[setup] = board_delay
        messages += [message] if message else []
    max_time = math.inf if all(clock.common for clock in clocks.values()) else MAX_COMPARED_TIME
    step, parts = _common_parts(aligned, max_time)
    if parts[-1][0] + parts[-1][1] * step > parts[0][0] + max_time:
        messages.append(
            f"{aligned[0].file}: {max_time:g} s are used: over longer times, separate clocks drift apart"
        )
    pieces = tuple(
        np.hstack([board.resample(start, step, count) for board in aligned]) for start, count in parts
    )
    return AlignedBoards(step, tuple(start for start, _ in parts), pieces, delays, tuple(messages))


def _common_parts(boards: Sequence[Board], max_time: float) -> tuple[float, list[tuple[float, int]]]:
    """Return the finest step of boards, and the start time and sample count of each part that all of them recorded.

    Raises MeasurementError if there is no common part.
    """
    step = min(board.step for board in boards)
    spans = boards[0].spans
    for board in boards[1:]:
        spans = _intersection(spans, board.spans)
    end = spans[0][0] + max_time if spans else 0.0
    counts = [(low, math.floor((min(high, end) - low) / step) + 1) for low, high in spans]
    parts = [(low, count) for low, count in counts if count >= MIN_POINTS]
    if not parts:
        found_spans = " and ".join(
            f"{b.file} from {b.spans[0][0]:.6g} to {b.spans[-1][1]:.6g} s" for b in boards
        )
        problem = f"expected files that were recorded together, found {found_spans}"
        raise MeasurementError(problem, boards[0].file, 'if each has a clock of its own, write clock = "own"')
    return step, parts


def _intersection(first: Spans, second: Spans) -> Spans:
    """Return the intersection of two lists of spans in time order."""
    common, i, k = list[tuple[float, float]](), 0, 0
    while i < len(first) and k < len(second):
        low, high = max(first[i][0], second[k][0]), min(first[i][1], second[k][1])
        common += [(low, high)] if high > low else []
        i, k = (i + 1, k) if first[i][1] < second[k][1] else (i, k + 1)
    return common


def _compare_clocks(first: Board, board: Board, clock: Clock, band: tuple[float, float]) -> tuple[Delay, str]:
    """Return the delay to add to the times of a board, and a message about it."""
    stated_delay = Delay(clock.offset, 0.0, 0.0, np.array(band), np.full(2, clock.sigma))
    if clock.sigma == 0.0:
        return stated_delay, ""
    own_clock = not clock.common and SEARCH_SIGMAS * clock.sigma > ROUGH_RANGE
    search_range = (
        ROUGH_RANGE if own_clock else COMMON_CLOCK_RANGE if clock.common else SEARCH_SIGMAS * clock.sigma
    )
    compared_band = (band[0], min(band[1], MAX_COMPARED_FREQUENCY))
    try:
        if own_clock:
            stated_delay = replace(stated_delay, seconds=_rough_offset(first, board, compared_band))
        shifted = board.with_delay(stated_delay)
        step, parts = _common_parts([first, shifted], MAX_COMPARED_TIME)
        pieces = [
            (low, first.resample(low, step, count), shifted.resample(low, step, count))
            for low, count in parts
        ]
        estimate = delay(
            step, pieces, compared_band, max_delay=search_range, max_drift=0.0 if clock.common else MAX_DRIFT
        )
        reason = "" if (estimate.phase_sigmas <= MAX_CLOCK_PHASE).any() else "the vibrations do not tell"
    except MeasurementError as error:
        reason = error.what
    if reason and own_clock:
        raise UnknownOffsetError(f"what to add to the times of {board.file} is unknown: {reason}")
    if reason:
        return stated_delay, ""
    sigma, difference = float(np.median(estimate.sigmas)), abs(estimate.seconds)
    total = replace(
        estimate,
        seconds=stated_delay.seconds + estimate.seconds,
        middle=estimate.middle - stated_delay.seconds,
    )
    offset_text = f"{1e3 * total.seconds:.2f} +- {1e3 * sigma:.2f} ms"
    if clock.common and difference > max(MIN_REPORTED_OFFSET, SEARCH_SIGMAS * sigma):
        doubt = f"{board.file}: the campaign says that its clock is that of {first.file}, the vibrations that it is"
        return replace(
            stated_delay, sigmas=np.full(2, difference)
        ), f'{doubt} {offset_text} off: if so, write clock = "own"'
    if clock.common or sigma > clock.sigma:
        return stated_delay, ""
    offset_text += f", and {1e6 * total.drift:.0f} ppm" if total.drift else ""
    return total, f"{board.file}: so that the shapes are real, {offset_text} is added to its times"


def _rough_offset(first: Board, board: Board, band: tuple[float, float]) -> float:
    """Return a rough offset for the times of a board, from the longest piece of each."""
    step, starts, longest_pieces = min(first.step, board.step), list[float](), list[Array]()
    for recording in (first, board):
        low, high = max(recording.spans, key=lambda span: span[1] - span[0])
        starts.append(low)
        longest_pieces.append(recording.resample(low, step, math.floor((high - low) / step) + 1))
    return starts[0] - starts[1] + rough_delay(step, longest_pieces[0], longest_pieces[1], band)


def add_clock_uncertainty(
    mode: Mode, columns: Mapping[str, slice], delays: Mapping[str, Delay]
) -> tuple[Mode, list[str]]:
    """Return a mode with the clocks' uncertainty in its shape's sigma, and the setups whose signs are unknown.

    - columns: the components of each board
    """
    phases = {setup: board_delay.phase_sigma(mode.frequency) for setup, board_delay in delays.items()}
    unsigned_setups = [setup for setup, phase in phases.items() if phase > MAX_CLOCK_PHASE]
    shape = mode.shape.copy()
    for setup in unsigned_setups:
        shape[columns[setup]] = np.nan
    real_shape = rotate_to_real(shape).real
    if not np.isfinite(real_shape).any():
        return replace(mode, shape=shape), unsigned_setups
    largest = int(np.nanargmax(np.abs(real_shape)))
    variance = np.zeros(len(shape))
    for setup, phase in phases.items():
        for sign in () if setup in unsigned_setups else (-1.0, 1.0):
            rotated = shape.copy()
            rotated[columns[setup]] *= np.exp(1j * sign * phase)
            rotated_real = rotate_to_real(rotated).real
            variance += 0.5 * (rotated_real / rotated_real[largest] - real_shape) ** 2
    sigma = float(np.sqrt(np.nanmax(variance)))
    return replace(mode, shape=shape, sigma_shape=float(np.hypot(mode.sigma_shape, sigma))), unsigned_setups
