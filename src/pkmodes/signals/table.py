"""Tables of signals, frequency responses or spectra in text, such as data loggers, Klipper and pkmodes write.

The name of a column says what it is: ``time``, ``force``, ``re:acc_1/hammer``, ``psd_x``, or a sensor.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import parted
from pkmodes.measured.formats import Format
from pkmodes.signals.checks import FEWEST, outside_coherence
from pkmodes.signals.functions import Array, Asked, Complex, Function, Kind, SignalFile
from pkmodes.signals.table_text import TableText, check_text, split_table
from pkmodes.signals.units import hertz_in, quotient, seconds_in, unit_text

TIME, FORCE = "time", "force"
FREQUENCIES = ("frequency", "freq")
REAL, IMAGINARY, COHERENCE, POWER = "re:", "im:", "coh:", "psd_"
POWERS = ("psd_x", "psd_y", "psd_z")
#: Larger tables would not fit into memory as text and as numbers.
LARGEST_FILE = 1_000_000_000
#: Bytes from which binary data are told from text.
HEAD = 4096
LOSS = re.compile(r"\b(?:drop|overflow|over-?run|overrange|lost|loss|miss(?:ed|ing)|gap|clip)", re.IGNORECASE)
NONE_LOST = re.compile(r"\b(?:no|none|without|never)\b", re.IGNORECASE)
NUMBERS = re.compile(r"\d+(?:\.\d+)?")
STATEMENT = re.compile(r"#\s*(unit|quantity|drives)\s*:\s*(.+?)\s*", re.IGNORECASE)


@dataclass(frozen=True)
class Column:
    """A function in a table: its kind and names, the places of its one or two columns, and the label of its unit."""

    kind: Kind
    response: str
    reference: str
    places: tuple[int, ...]
    label: str
    force: bool = False


@dataclass(frozen=True)
class Layout:
    """The columns of a table: that of the abscissa, None without one, with the label of its unit, and the others."""

    abscissa: int | None
    label: str
    kind: Kind
    columns: tuple[Column, ...]


def layout_of(cells: Sequence[str], where: str, asked: Asked) -> Layout:
    """Return what the columns of a table are.

    Parameters
    ----------
    cells : sequence of str
        Of the header, with units in brackets.
    where : str
        The line of the header, for messages.
    asked : Asked
        What is wanted of the file.

    Raises
    ------
    MeasurementError
        If there is no time or frequency, or more than one; if a wanted column occurs twice or lacks its other part.
    """
    parts = [parted(cell, ()) for cell in cells]
    times = [i for i, (name, _) in enumerate(parts) if name.lower() == TIME]
    frequencies = [i for i, (name, _) in enumerate(parts) if name.lower() in FREQUENCIES]
    found = times + frequencies
    if len(found) > 1:
        what = f"expected one column of times or frequencies, found {len(found)}"
        raise MeasurementError(what, where, "leave one of them out")
    if not found and asked.rate is None:
        remedy = 'name the column of times "time" or that of frequencies "frequency", or give the rate in the record'
        raise MeasurementError("expected a column of times or frequencies, found none", where, remedy)
    others = {i: name for i, (name, _) in enumerate(parts) if i not in found and name}
    labels = [label or "" for _, label in parts]
    columns = _spectral(others, labels, where, asked) if frequencies else _signals(others, labels, asked)
    _refuse_repeated(columns, cells, where)
    kind = Kind.FRF if frequencies else Kind.TIME
    return Layout(found[0] if found else None, labels[found[0]] if found else "", kind, tuple(columns))


def _signals(names: Mapping[int, str], labels: Sequence[str], asked: Asked) -> list[Column]:
    """Return the columns of a table of signals."""
    return [
        Column(Kind.TIME, name, "", (i,), labels[i], name == FORCE)
        for i, name in names.items()
        if name == FORCE or asked.wants(name)
    ]


def _spectral(names: Mapping[int, str], labels: Sequence[str], where: str, asked: Asked) -> list[Column]:
    """Return the columns of a table of functions of frequency."""
    columns: list[Column] = []
    plain = asked.sensors is not None or not any(
        name.startswith((REAL, COHERENCE, POWER)) for name in names.values()
    )
    for i, name in names.items():
        channel = name.partition(":")[2]
        response, _, reference = (part.strip() for part in channel.partition("/"))
        if name.startswith((REAL, IMAGINARY)):
            if not asked.wants(response):
                continue
            pair = [
                [j for j, other in names.items() if other == f"{prefix}{channel}"]
                for prefix in (REAL, IMAGINARY)
            ]
            if [len(one) for one in pair] != [1, 1]:
                what = f"expected one column {shown(REAL + channel)} and one {shown(IMAGINARY + channel)}"
                raise MeasurementError(what, where, "give both parts of each frequency response once")
            if name.startswith(REAL):
                columns.append(Column(Kind.FRF, response, reference, (pair[0][0], pair[1][0]), labels[i]))
        elif name.startswith(COHERENCE):
            if asked.wants(response):
                columns.append(Column(Kind.COHERENCE, response, reference, (i,), labels[i]))
        elif name.lower() in POWERS or (name.startswith(POWER) and asked.sensors is not None):
            power = name[len(POWER) :]
            if asked.wants(name, power):
                columns.append(Column(Kind.SPECTRUM, power, "", (i,), labels[i]))
        elif plain and asked.wants(name):
            columns.append(Column(Kind.SPECTRUM, name, "", (i,), labels[i]))
    return columns


def _refuse_repeated(columns: Sequence[Column], cells: Sequence[str], where: str) -> None:
    """Refuse two columns of one function."""
    seen: dict[tuple[Kind, str, str], Column] = {}
    for column in columns:
        first = seen.setdefault((column.kind, column.response, column.reference), column)
        if first is not column:
            what = f"the column {shown(cells[column.places[0]])} is repeated, first as column {first.places[0] + 1}"
            raise MeasurementError(what, f"{where}, column {column.places[0] + 1}", "remove one of them")


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
    stated = _stated(text.comments)
    functions = tuple(_function(column, numbers, abscissa, stated) for column in layout.columns)
    messages = tuple(f"{source}: {one}" for one in _losses(text.comments))
    return SignalFile(source, functions, (), messages, stated)


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
        unit, reference_unit = quotient(column.label or stated.get(f"unit {channel}", ""))
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


def _stated(comments: Sequence[str]) -> dict[str, str]:
    """Return what comments such as pkmodes itself writes state: quantity, drives, and the unit of each channel."""
    found = {}
    for match in (STATEMENT.fullmatch(text.rstrip(" ,;\t")) for text in comments):
        if match is None:
            continue
        word, value = match[1].lower(), match[2]
        if word == "unit":
            channel, equals, value = (part.strip() for part in value.partition("="))
            if not equals:
                continue
            word = f"unit {channel}"
        found[word] = value
    return found


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


TABLE = Format("table", (".csv", ".tsv", ".txt", ".dat"), looks_like_text, read)
