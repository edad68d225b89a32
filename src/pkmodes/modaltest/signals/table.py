"""Text tables of signals, frequency responses or spectra, as written by data loggers, Klipper and pkmodes."""

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

#: Maximum size of a table in bytes: a larger one would not fit into memory both as text and as numbers.
MAX_FILE_SIZE = 1_000_000_000
#: Phases without a unit are taken as radians up to MAX_RADIANS (from -pi to pi, or up to 2 pi), and as degrees from
#: MIN_DEGREES; between the two, the file is refused.
MAX_RADIANS, MIN_DEGREES = 2.0 * np.pi, 40.0
#: Number of bytes read from the start of a file to tell text from binary data.
HEAD_SIZE = 4096
#: A comment that states lost samples.  Looser wordings (LOSS_WORD) count only in lines beginning with ``##``.
LOST_SAMPLES = re.compile(
    r"\b(?:skipped|lost|missed|missing|dropped)[ _]samples?[ \t]*[:=][ \t]*0*[1-9]", re.IGNORECASE
)
LOSS_WORD = re.compile(
    r"\b(?:drop|overflow|over-?run|overrange|lost|loss|miss(?:ed|ing)|gap|clip)", re.IGNORECASE
)
NEGATION = re.compile(r"\b(?:no|none|without|never)\b", re.IGNORECASE)
NUMBER = re.compile(r"\d+(?:\.\d+)?")
STATEMENT_COMMENT = re.compile(r"#\s*(unit|quantity|drives)\s*:(.*)", re.IGNORECASE)
#: Maximum number of comments about lost samples that are reported, and of letters of each.
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
    unframed = remove_frame(content, source)
    del content
    table = split_table(unframed.content, source, request.columns)
    program_rate, losses = unframed.rate, unframed.losses
    del unframed  # frees its copy of the content
    remarks = list[str]()
    if request.rate is None:
        request = replace(request, rate=program_rate)
    elif program_rate not in (None, request.rate):
        remarks = [_rate_message(program_rate, request.rate)]
    has_rate = bool(find_rates(table.comments))
    layout = find_layout(table.names, f"{source}: line {table.header_line}", request, has_rate=has_rate)
    if layout.kind is FunctionKind.FRF and layout.abscissa is not None and table.may_have_gaps:
        factor = _abscissa_unit_factor(layout, table)
        table = table.without_gaps(
            layout.abscissa,
            _column_indices(layout),
            lambda number: _is_required_line(factor * number, request.band),
        )
    numbers = _read_numbers(layout, table)
    abscissa = _make_abscissa(layout, numbers, table, request, program_rate, remarks)
    for column in layout.columns:
        if column.kind is FunctionKind.COHERENCE:
            _check_coherence(column, numbers, table)
    channels = {f"{column.response}/{column.reference}".removesuffix("/") for column in layout.columns}
    statements = _find_statements(table.comments, channels)
    functions = tuple(
        _make_function(column, numbers, abscissa, statements, source) for column in layout.columns
    )
    messages = tuple(f"{source}: {remark}" for remark in (*remarks, *_loss_messages(table.comments), *losses))
    return SignalFile(source, functions, (), messages, statements)


def _column_indices(layout: TableLayout) -> list[int]:
    """Return the indices of the columns of all functions."""
    return [index for column in layout.columns for index in column.indices]


def _has_clock_times(layout: TableLayout, table: TableText) -> bool:
    """Return whether the times are times of day."""
    return layout.abscissa is not None and is_clock(table.cell(layout.abscissa))


def _read_numbers(layout: TableLayout, table: TableText) -> dict[int, Numbers]:
    """Return the numbers in the columns of the abscissa and of all functions, by the index of the column."""
    column_indices = _column_indices(layout)
    # The first column is still checked, so that a damaged table is not mistaken for one without these sensors.
    read_columns = ([] if layout.abscissa is None else [layout.abscissa]) + column_indices or [0]
    has_clock_times = _has_clock_times(layout, table)
    numeric_columns = column_indices if has_clock_times and column_indices else read_columns
    numbers: dict[int, Numbers] = dict(zip(numeric_columns, table.columns(numeric_columns), strict=True))
    if has_clock_times:
        assert layout.abscissa is not None
        numbers[layout.abscissa] = _clock_times(layout.abscissa, table)
    row_count = numbers[read_columns[0]].size
    if row_count < MIN_POINTS:
        problem = f"expected at least {MIN_POINTS} rows, found {row_count}"
        raise MeasurementError(problem, table.source, "export the whole measurement")
    return numbers


def _make_abscissa(
    layout: TableLayout,
    numbers: dict[int, Numbers],
    table: TableText,
    request: SignalRequest,
    program_rate: float | None,
    remarks: list[str],
) -> Array:
    """Return the times or frequencies of all rows, and add remarks about their rate.

    - program_rate: rate [Hz] that the program stated outside the table
    """
    may_be_sample_numbers = layout.kind is FunctionKind.TIME and not (
        _has_clock_times(layout, table) or layout.abscissa_unit
    )
    rate = None
    if layout.abscissa is None or (may_be_sample_numbers and counts_samples(numbers[layout.abscissa])):
        rate = _choose_rate(table, request, program_rate, remarks)
    if rate is None:  # without a stated rate, even sample numbers are taken as seconds
        return _scaled_abscissa(layout, numbers, table)
    row_count = next(iter(numbers.values())).size
    return _times_by_rate(rate, layout, row_count, table, remarks)


def _choose_rate(
    table: TableText, request: SignalRequest, program_rate: float | None, remarks: list[str]
) -> float | None:
    """Return the rate that the campaign states for the record, or else the one stated in the file [Hz]."""
    if request.rate is None:
        rate, notes = stated_rate(table.comments, table.source)
        remarks += notes
        return rate
    contradicting = [rate for rate, _ in find_rates(table.comments) if not same_rate(rate, request.rate)]
    if contradicting and request.rate != program_rate:
        remarks.append(_rate_message(contradicting[0], request.rate))
    return request.rate


def _times_by_rate(
    rate: float, layout: TableLayout, row_count: int, table: TableText, remarks: list[str]
) -> Array:
    """Return the times of all rows at a rate [Hz]; a column that counts samples shows which samples are missing."""
    if layout.abscissa is not None:
        name = shown(table.names[layout.abscissa])
        remarks.append(f"its column {name} counts samples: the rate of {rate:g} Hz gives the times")
        return even_times(row_count, rate)
    index = find_counter(table.names, [index for column in layout.columns for index in column.indices])
    if index is None:
        return even_times(row_count, rate)
    try:
        (numbers,) = table.columns([index])
    except MeasurementError:  # the campaign does not use this column, so unreadable cells do not matter
        return even_times(row_count, rate)
    positions = sample_positions(np.asarray(numbers, np.float64))
    if positions is None or positions[-1] == row_count - 1:
        return even_times(row_count, rate)
    missing = positions[-1] - row_count + 1
    remarks.append(f"its column {shown(table.names[index])} shows that {missing:.0f} samples are missing")
    return positions / rate


def _scaled_abscissa(layout: TableLayout, numbers: dict[int, Numbers], table: TableText) -> Array:
    """Return the times or frequencies of all rows."""
    assert layout.abscissa is not None
    name = table.names[layout.abscissa]
    abscissa = np.asarray(numbers[layout.abscissa], np.float64)
    abscissa *= _abscissa_unit_factor(layout, table)  # in place: a long table fills much of the memory
    if layout.kind is FunctionKind.TIME:
        abscissa = restore_even_times(abscissa)
    descending = np.flatnonzero(abscissa[1:] <= abscissa[:-1])
    if descending.size:
        row = int(descending[0]) + 1
        problem = f"expected ascending values, found {abscissa[row]:.10g} after {abscissa[row - 1]:.10g}"
        where = f"{table.source}: line {table.line_of(row)}, column {name}"
        raise MeasurementError(problem, where, "sort the rows, and give each value once, with enough digits")
    return abscissa


def _abscissa_unit_factor(layout: TableLayout, table: TableText) -> float:
    """Return the factor from the unit of the times or frequencies to s or Hz."""
    assert layout.abscissa is not None
    factor = (
        (seconds_in if layout.kind is FunctionKind.TIME else hertz_in)(layout.abscissa_unit)
        if layout.abscissa_unit
        else 1.0
    )
    if factor is None:
        where = f"{table.source}: line {table.header_line}, column {table.names[layout.abscissa]}"
        expected = "time" if layout.kind is FunctionKind.TIME else "frequency"
        raise MeasurementError(
            f"expected a unit of {expected}, found {shown(layout.abscissa_unit)}", where, "correct it"
        )
    return factor


def _is_required_line(frequency: float, band: tuple[float, float] | None) -> bool:
    """Return whether a frequency line must have values: in the band or, without a band, above 0 Hz."""
    return frequency > 0.0 if band is None else band[0] <= frequency <= band[1]


def _rate_message(stated: float | None, requested: float) -> str:
    in_use = f"the rate given in the campaign's record, {requested:g} Hz, is used"
    return f"the file states a rate of {stated:g} Hz; {in_use}"


def _clock_times(column: int, table: TableText) -> Array:
    """Return the seconds since the first row, from a column of times of day."""
    times, bad_row = parse_times(table.texts(column))
    if bad_row is not None:
        cell = next(islice(table.texts(column), bad_row, None))
        problem = f"expected a time, found {shown(cell) or 'nothing'}"
        where = f"{table.source}: line {table.line_of(bad_row)}, column {table.names[column]}"
        raise MeasurementError(problem, where, "write each time as 2024-05-03 10:00:00.005, or in seconds")
    return times


def _check_coherence(column: FunctionColumn, numbers: dict[int, Numbers], table: TableText) -> None:
    """Refuse a coherence outside 0 to 1, with its line."""
    (index,) = column.indices
    fault = find_invalid_coherence(numbers[index])
    if fault is not None:
        row, problem, remedy = fault
        where = f"{table.source}: line {table.line_of(row)}, column {table.names[index]}"
        raise MeasurementError(problem, where, remedy)


def _make_function(
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
        load = partial(_from_real_imaginary, parts[0], parts[1])
        if column.polar:
            load = partial(
                _from_polar, parts[0], parts[1], _phase_factor(column, parts[1], source), column.decibels
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


def _from_real_imaginary(real: Numbers, imaginary: Numbers) -> Complex:
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


def _from_polar(magnitude: Numbers, phase: Numbers, factor: float, decibels: bool) -> Complex:
    """Return a frequency response from magnitude and phase."""
    amplitude = 10.0 ** (magnitude / 20.0) if decibels else magnitude
    return np.asarray(amplitude * np.exp(1j * factor * phase))


def _find_statements(comments: Iterable[str], channels: Set[str]) -> dict[str, str]:
    """Return statements in comments as written by pkmodes: quantity, drives, and the unit of each channel."""
    statements = {}
    for match in (STATEMENT_COMMENT.fullmatch(comment.rstrip(" ,;\t")) for comment in comments):
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
    for comment in comments:
        if not (_states_losses(comment) if comment.startswith("##") else LOST_SAMPLES.search(comment)):
            continue
        if len(losses) < MAX_LOSSES:
            losses.append(f"the file states: {comment.lstrip('# ').strip()[:MAX_LOSS_LENGTH]}")
        else:
            omitted += 1
    return [*losses, f"{omitted} more lines of the file state lost samples"] if omitted else losses


def _states_losses(comment: str) -> bool:
    """Return whether some clause of a comment states losses."""
    for clause in re.split(r"[,;|]", comment.lstrip("#")):
        counts = [float(number) for number in NUMBER.findall(clause)]
        states_loss = LOSS_WORD.search(clause) and not NEGATION.search(clause)
        if states_loss and (not counts or any(counts)):  # a count of 0 is no loss
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
