"""Tables of signals, frequency responses or spectra in text, such as data loggers, Klipper and pkmodes write."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Set
from dataclasses import replace
from functools import partial
from itertools import islice
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.checks import MIN_POINTS, find_invalid_coherence
from pkmodes.modaltest.signals.clock import is_clock, parse_times
from pkmodes.modaltest.signals.functions import (
    Array,
    Complex,
    Function,
    FunctionKind,
    SignalFile,
    SignalRequest,
    StoredFunction,
)
from pkmodes.modaltest.signals.sampling import counts_samples, even_times, restore_even_times
from pkmodes.modaltest.signals.table_columns import FunctionColumn, TableLayout, find_layout
from pkmodes.modaltest.signals.table_programs import remove_frame
from pkmodes.modaltest.signals.table_rates import (
    find_counter,
    find_rates,
    same_rate,
    sample_positions,
    stated_rate,
)
from pkmodes.modaltest.signals.table_text import TableText, check_text, split_table
from pkmodes.modaltest.signals.units import hertz_in, quotient_units, radians_in, seconds_in, unit_text

#: Most bytes of a table: larger ones would not fit into memory as text and as numbers.
MAX_FILE_SIZE = 1_000_000_000
#: Phases without a unit are radians up to the first (from -pi to pi, or up to 2 pi), and degrees from the second.
MAX_RADIANS, MIN_DEGREES = 2.0 * np.pi, 40.0
#: Number of first bytes by which binary data are distinguished from text.
HEAD_SIZE = 4096
#: Statement of lost samples in any comment; other wordings are looked for only in lines beginning with ``##``.
LOST_SAMPLES = re.compile(
    r"\b(?:skipped|lost|missed|missing|dropped)[ _]samples?[ \t]*[:=][ \t]*0*[1-9]", re.IGNORECASE
)
LOSS = re.compile(r"\b(?:drop|overflow|over-?run|overrange|lost|loss|miss(?:ed|ing)|gap|clip)", re.IGNORECASE)
NONE_LOST = re.compile(r"\b(?:no|none|without|never)\b", re.IGNORECASE)
NUMBERS = re.compile(r"\d+(?:\.\d+)?")
STATEMENT = re.compile(r"#\s*(unit|quantity|drives)\s*:(.*)", re.IGNORECASE)
#: Most lines about lost samples that are reported, and most letters of each.
MAX_LOSSES, MAX_LOSS_LENGTH = 20, 500
#: A column: whole numbers may have a smaller type than double precision.
Numbers = NDArray[Any]


def read_table(path: Path, request: SignalRequest) -> SignalFile:
    """Read a table.

    Raises MeasurementError if it has no header, or its columns cannot be read, with line and column.
    """
    source = fspath(path)
    if path.stat().st_size > MAX_FILE_SIZE:
        remedy = "give a binary universal file, or split the table"
        raise MeasurementError("cannot read the table: it is larger than 1 GB", source, remedy)
    with path.open("rb") as file:
        check_text(file.read(HEAD_SIZE), source)  # before gigabytes of something else are read
        file.seek(0)
        return parse_table(file.read(), source, request)


def parse_table(content: bytes, source: str, request: SignalRequest) -> SignalFile:
    """Return the signals in the content of a table: see `read_table`."""
    frame = remove_frame(content, source)
    del content
    text = split_table(frame.content, source, request.columns)
    frame_rate, losses = frame.rate, frame.losses
    del frame  # other copies of the table
    remarks = list[str]()
    if request.rate is None:
        request = replace(request, rate=frame_rate)
    elif frame_rate not in (None, request.rate):
        remarks = [_rate_message(frame_rate, request.rate)]
    has_rate = bool(find_rates(text.comments))
    layout = find_layout(text.names, f"{source}: line {text.header_line}", request, has_rate=has_rate)
    column_indices = [index for column in layout.columns for index in column.indices]
    if layout.kind is FunctionKind.FRF and layout.abscissa is not None and text.may_have_gaps:
        factor = _factor(layout, text)
        text = text.without_gaps(
            layout.abscissa, column_indices, lambda number: _needs_values(factor * number, request.band)
        )
    read_columns = ([] if layout.abscissa is None else [layout.abscissa]) + column_indices
    # The first column is still checked, so that a damaged table is not mistaken for one without these sensors.
    if not read_columns:
        read_columns = [0]
    clock = layout.abscissa is not None and is_clock(text.cell(layout.abscissa))
    numeric_columns = column_indices if clock and column_indices else read_columns
    numbers: dict[int, Numbers] = dict(zip(numeric_columns, text.columns(numeric_columns), strict=True))
    if clock:
        assert layout.abscissa is not None
        numbers[layout.abscissa] = _clock_times(layout.abscissa, text)
    rows = numbers[read_columns[0]].size
    if rows < MIN_POINTS:
        problem = f"expected at least {MIN_POINTS} rows, found {rows}"
        raise MeasurementError(problem, source, "export the whole measurement")
    may_count = not (clock or layout.label) and layout.kind is FunctionKind.TIME
    abscissa = None
    if layout.abscissa is None or (may_count and counts_samples(numbers[layout.abscissa])):
        abscissa, notes = _times_by_rate(layout, rows, text, request, frame_rate)
        remarks += notes
    if abscissa is None:  # without any statement to the contrary, times that count samples are seconds
        abscissa = _abscissa(layout, numbers, text)
    for column in layout.columns:
        if column.kind is FunctionKind.COHERENCE:
            _check_coherence(column, numbers, text)
    channels = {f"{column.response}/{column.reference}".removesuffix("/") for column in layout.columns}
    statements = _find_statements(text.comments, channels)
    functions = tuple(_function(column, numbers, abscissa, statements, source) for column in layout.columns)
    messages = tuple(f"{source}: {remark}" for remark in (*remarks, *_loss_messages(text.comments), *losses))
    return SignalFile(source, functions, (), messages, statements)


def _times_by_rate(
    layout: TableLayout, rows: int, text: TableText, request: SignalRequest, frame_rate: float | None
) -> tuple[Array | None, list[str]]:
    """Return the times of all rows by the rate of the record, or else of the file, and remarks; None without a rate.

    A column that counts samples shows which are missing.
    """
    rate, remarks = request.rate, list[str]()
    if rate is None:
        rate, remarks = stated_rate(text.comments, text.source)
        if rate is None:
            return None, remarks
    elif rate != frame_rate:
        contradicting = [stated for stated, _ in find_rates(text.comments) if not same_rate(stated, rate)]
        remarks += [_rate_message(contradicting[0], rate)] if contradicting else []
    if layout.abscissa is not None:
        remarks.append(f"its column {shown(text.names[layout.abscissa])} counts samples, of {rate:g} Hz")
        return even_times(rows, rate), remarks
    index = find_counter(text.names, [index for column in layout.columns for index in column.indices])
    if index is None:
        return even_times(rows, rate), remarks
    try:
        (numbers,) = text.columns([index])
    except MeasurementError:  # no column of the campaign: it may hold anything
        return even_times(rows, rate), remarks
    positions = sample_positions(np.asarray(numbers, np.float64))
    if positions is None or positions[-1] == rows - 1:
        return even_times(rows, rate), remarks
    missing = positions[-1] - rows + 1
    remarks.append(f"its column {shown(text.names[index])} shows that {missing:.0f} samples are missing")
    return positions / rate, remarks


def _abscissa(layout: TableLayout, numbers: dict[int, Numbers], text: TableText) -> Array:
    """Return the times or frequencies of all rows."""
    assert layout.abscissa is not None
    name = text.names[layout.abscissa]
    abscissa = np.asarray(numbers[layout.abscissa], np.float64)
    abscissa *= _factor(layout, text)  # in place: a long table fills much of the memory
    if layout.kind is FunctionKind.TIME:
        abscissa = restore_even_times(abscissa)
    descending = np.flatnonzero(abscissa[1:] <= abscissa[:-1])
    if descending.size:
        row = int(descending[0]) + 1
        problem = f"expected ascending values, found {abscissa[row]:.10g} after {abscissa[row - 1]:.10g}"
        where = f"{text.source}: line {text.line_of(row)}, column {name}"
        raise MeasurementError(problem, where, "sort the rows, and give each value once, with enough digits")
    return abscissa


def _factor(layout: TableLayout, text: TableText) -> float:
    """Return the factor of the times or frequencies to s or Hz."""
    assert layout.abscissa is not None
    factor = (
        (seconds_in if layout.kind is FunctionKind.TIME else hertz_in)(layout.label) if layout.label else 1.0
    )
    if factor is None:
        where = f"{text.source}: line {text.header_line}, column {text.names[layout.abscissa]}"
        expected = "time" if layout.kind is FunctionKind.TIME else "frequency"
        raise MeasurementError(
            f"expected a unit of {expected}, found {shown(layout.label)}", where, "correct it"
        )
    return factor


def _needs_values(frequency: float, band: tuple[float, float] | None) -> bool:
    """Return whether a line must have values: in the band or, without a band, above 0 Hz."""
    return frequency > 0.0 if band is None else band[0] <= frequency <= band[1]


def _rate_message(stated: float | None, requested: float) -> str:
    return f"the file states a rate of {stated:g} Hz; that of the record, {requested:g} Hz, is used"


def _clock_times(column: int, text: TableText) -> Array:
    """Return the seconds since the first time of a column of times of day."""
    times, bad_row = parse_times(text.texts(column))
    if bad_row is not None:
        cell = next(islice(text.texts(column), bad_row, None))
        problem = f"expected a time, found {shown(cell) or 'nothing'}"
        where = f"{text.source}: line {text.line_of(bad_row)}, column {text.names[column]}"
        raise MeasurementError(problem, where, "write each time as 2024-05-03 10:00:00.005, or in seconds")
    return times


def _check_coherence(column: FunctionColumn, numbers: dict[int, Numbers], text: TableText) -> None:
    """Refuse a coherence outside 0 to 1, with its line."""
    (index,) = column.indices
    fault = find_invalid_coherence(numbers[index])
    if fault is not None:
        row, problem, remedy = fault
        where = f"{text.source}: line {text.line_of(row)}, column {text.names[index]}"
        raise MeasurementError(problem, where, remedy)


def _function(
    column: FunctionColumn,
    numbers: dict[int, Numbers],
    abscissa: Array,
    statements: dict[str, str],
    source: str,
) -> Function:
    """Return a function, whose values are computed from the numbers of the table at each access."""
    parts = [numbers[index] for index in column.indices]
    unit, reference_unit = unit_text(column.unit), None
    load: Callable[[], Array | Complex] = partial(np.asarray, parts[0], np.float64)
    if column.kind is FunctionKind.FRF:
        load = partial(_complex, parts[0], parts[1])
        if column.polar:
            load = partial(
                _polar, parts[0], parts[1], _phase_factor(column, parts[1], source), column.decibels
            )
        channel = f"{column.response}/{column.reference}".removesuffix("/")
        unit, reference_unit = quotient_units(column.unit or statements.get(f"unit {channel}", ""))
    if column.kind is FunctionKind.COHERENCE:
        unit = None
    return StoredFunction(
        kind=column.kind,
        response=column.response,
        reference=column.reference,
        abscissa=abscissa,
        unit=unit,
        reference_unit=reference_unit,
        force=column.force,
        load=load,
    )


def _complex(real: Numbers, imaginary: Numbers) -> Complex:
    values = np.empty(real.size, np.complex128)
    values.real, values.imag = real, imaginary
    return values


def _phase_factor(column: FunctionColumn, phase: Numbers, source: str) -> float:
    """Return the factor of a phase to radians; without a unit, it is in degrees if it is too large for radians."""
    label, largest = column.labels[1], float(max(phase.max(initial=0), -float(phase.min(initial=0))))
    where = f"{source}: phase of {column.response}"
    if not label and MAX_RADIANS < largest < MIN_DEGREES:
        problem = f"expected the unit of the phase, found none, and phases up to {largest:.4g}"
        raise MeasurementError(problem, where, "write it in the header: [deg] or [rad]")
    factor = radians_in(label or ("rad" if largest <= MAX_RADIANS else "deg"))
    if factor is None:
        raise MeasurementError(f"expected a unit of angle, found {shown(label)}", where, "write deg or rad")
    return factor


def _polar(magnitude: Numbers, phase: Numbers, factor: float, decibels: bool) -> Complex:
    """Return a frequency response from magnitude and phase."""
    amplitude = 10.0 ** (magnitude / 20.0) if decibels else magnitude
    return np.asarray(amplitude * np.exp(1j * factor * phase))


def _find_statements(comments: Iterable[str], channels: Set[str]) -> dict[str, str]:
    """Return statements in comments as written by pkmodes: quantity, drives, and the unit of each channel."""
    statements = {}
    for match in (STATEMENT.fullmatch(text.rstrip(" ,;\t")) for text in comments):
        if match is None:
            continue
        word, value = match[1].lower(), match[2].strip()
        if word == "unit":
            channel, equals, value = (part.strip() for part in value.partition("="))
            if not equals or channel not in channels:
                continue
            word = f"unit {channel}"
        if value:
            statements[word] = value
    return statements


def _loss_messages(comments: Iterable[str]) -> list[str]:
    """Return the comments that state lost or overloaded samples, unless they state that there are none."""
    losses, omitted = list[str](), 0
    for text in comments:
        if not (_states_losses(text) if text.startswith("##") else LOST_SAMPLES.search(text)):
            continue
        if len(losses) < MAX_LOSSES:
            losses.append(f"the file states: {text.lstrip('# ').strip()[:MAX_LOSS_LENGTH]}")
        else:
            omitted += 1
    return [*losses, f"{omitted} more lines of it state such losses"] if omitted else losses


def _states_losses(text: str) -> bool:
    """Return whether some clause of a comment states losses."""
    for clause in re.split(r"[,;|]", text.lstrip("#")):
        counts = [float(number) for number in NUMBERS.findall(clause)]
        if LOSS.search(clause) and not NONE_LOST.search(clause) and (any(counts) or not counts):
            return True
    return False


def looks_like_text(head: bytes) -> bool:
    """Return whether a file begins with printable text that has letters: a header or a comment."""
    if not head.strip() or b"\0" in head:
        return False
    try:
        text = head.decode("utf-8-sig", "strict" if len(head) < 4000 else "ignore")
    except UnicodeDecodeError:
        text = head.decode("latin-1")
    unprintable = sum(not (character.isprintable() or character in "\t\r\n") for character in text)
    return unprintable == 0 and any(character.isalpha() for character in text)


TABLE = Format("table", (".csv", ".tsv", ".txt", ".dat", ".lvm"), looks_like_text, read_table)
