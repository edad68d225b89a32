"""Tables of signals, frequency responses or spectra in text, such as data loggers, Klipper and pkmodes write."""

from __future__ import annotations

import re
from collections.abc import Sequence
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.signals.checks import FEWEST, outside_coherence
from pkmodes.signals.formats import Asked, SignalFormat
from pkmodes.signals.functions import Array, Complex, Function, Kind, SignalFile
from pkmodes.signals.table_columns import Column, Layout, layout_of
from pkmodes.signals.table_text import TableText, check_text, split_table
from pkmodes.signals.units import hertz_in, quotient, seconds_in, unit_text

#: Larger tables would not fit into memory as text and as numbers.
LARGEST_FILE = 1_000_000_000
#: Bytes from which binary data are told from text.
HEAD = 4096
LOSS = re.compile(r"\b(?:drop|overflow|over-?run|overrange|lost|loss|miss(?:ed|ing)|gap|clip)", re.IGNORECASE)
NONE_LOST = re.compile(r"\b(?:no|none|without|never)\b", re.IGNORECASE)
NUMBERS = re.compile(r"\d+(?:\.\d+)?")
UNIT = re.compile(r"#\s*unit\s*:\s*(.+?)\s*=\s*(.+?)\s*", re.IGNORECASE)


def read(path: Path, asked: Asked) -> SignalFile:
    """Read a table.

    Raises
    ------
    MeasurementError
        If it has no header, or its columns cannot be read, with line and column.
    """
    source = fspath(path)
    if path.stat().st_size > LARGEST_FILE:
        remedy = "give a binary universal file, or split the table"
        raise MeasurementError("cannot read the table: it is larger than 1 GB", source, remedy)
    with path.open("rb") as file:
        check_text(file.read(HEAD), source)  # before gigabytes of something else are read
        file.seek(0)
        text = split_table(file.read(), source)
    layout = layout_of(text.names, f"{source}: line {text.header_line}", asked)
    wanted = [place for column in layout.columns for place in column.places]
    read_places = ([] if layout.abscissa is None else [layout.abscissa]) + wanted
    if not read_places:  # still checked, so that a damaged table is not taken for one without these sensors
        read_places = [0]
    numbers = dict(zip(read_places, text.columns(read_places), strict=True))
    rows = numbers[read_places[0]].size
    abscissa = _abscissa(layout, numbers, rows, text, asked)
    for column in layout.columns:
        if column.kind is Kind.COHERENCE:
            _check_coherence(column, numbers, text)
    stated = _units(text.comments)
    functions = tuple(_function(column, numbers, abscissa, stated) for column in layout.columns)
    return SignalFile(source, functions, (), tuple(f"{source}: {one}" for one in _losses(text.comments)))


def _abscissa(layout: Layout, numbers: dict[int, Array], rows: int, text: TableText, asked: Asked) -> Array:
    """Return the times or frequencies of all rows."""
    if rows < FEWEST:
        what = f"expected at least {FEWEST} rows, found {rows}"
        raise MeasurementError(what, text.source, "export the whole measurement")
    if layout.abscissa is None:
        assert asked.rate is not None
        return np.arange(rows) / asked.rate
    name = text.names[layout.abscissa]
    factor: float | None = 1.0
    if layout.label:
        factor = (seconds_in if layout.kind is Kind.TIME else hertz_in)(layout.label)
    if factor is None:
        where = f"{text.source}: line {text.header_line}, column {name}"
        expected = "time" if layout.kind is Kind.TIME else "frequency"
        raise MeasurementError(
            f"expected a unit of {expected}, found {shown(layout.label)}", where, "correct it"
        )
    abscissa = numbers[layout.abscissa] * factor
    late = np.flatnonzero(np.diff(abscissa) <= 0.0)
    if late.size:
        row = int(late[0]) + 1
        what = f"expected ascending values, found {abscissa[row]:.10g} after {abscissa[row - 1]:.10g}"
        where = f"{text.source}: line {text.line_of(row)}, column {name}"
        raise MeasurementError(what, where, "sort the rows, and give each value once, with enough digits")
    return abscissa


def _check_coherence(column: Column, numbers: dict[int, Array], text: TableText) -> None:
    """Refuse a coherence outside 0 to 1, with its line."""
    (place,) = column.places
    found = outside_coherence(numbers[place])
    if found is not None:
        row, what, remedy = found
        where = f"{text.source}: line {text.line_of(row)}, column {text.names[place]}"
        raise MeasurementError(what, where, remedy)


def _function(column: Column, numbers: dict[int, Array], abscissa: Array, stated: dict[str, str]) -> Function:
    values: Array | Complex = numbers[column.places[0]]
    unit, reference_unit = unit_text(column.label), None
    if column.kind is Kind.FRF:
        values = values + 1j * numbers[column.places[1]]
        channel = f"{column.response}/{column.reference}".removesuffix("/")
        unit, reference_unit = quotient(column.label or stated.get(channel, ""))
    if column.kind is Kind.COHERENCE:
        unit = None
    return Function(
        kind=column.kind,
        response=column.response,
        reference=column.reference,
        abscissa=abscissa,
        values=values,
        unit=unit,
        reference_unit=reference_unit,
        force=column.force,
    )


def _units(comments: Sequence[str]) -> dict[str, str]:
    """Return the units by channel in comments such as pkmodes itself writes."""
    matches = (UNIT.fullmatch(text.rstrip(" ,;\t")) for text in comments)
    return {match[1]: match[2] for match in matches if match is not None}


def _losses(comments: Sequence[str]) -> list[str]:
    """Return the lines beginning with ``##`` that state lost or overloaded samples, other than none."""
    found = []
    for text in comments:
        for clause in re.split(r"[,;|]", text.lstrip("#")) if text.startswith("##") else ():
            counts = [float(number) for number in NUMBERS.findall(clause)]
            if LOSS.search(clause) and not NONE_LOST.search(clause) and (any(counts) or not counts):
                found.append(f"the file states: {text.lstrip('# ').strip()}")
                break
    return found


def looks_like_text(head: bytes) -> bool:
    """Return whether a file begins with printable text that has letters: a header or a comment."""
    if not head.strip() or b"\0" in head:
        return False
    try:
        text = head.decode("utf-8-sig", "strict" if len(head) < 4000 else "ignore")
    except UnicodeDecodeError:
        text = head.decode("latin-1")
    strange = sum(not (one.isprintable() or one in "\t\r\n") for one in text)
    return strange == 0 and any(one.isalpha() for one in text)


TABLE = SignalFormat("table", (".csv", ".tsv", ".txt", ".dat"), looks_like_text, read)
