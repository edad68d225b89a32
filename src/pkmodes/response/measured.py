"""Measured frequency responses from a table, as `pkmodes response` itself writes one."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import MeasurementError, PkmodesError, nearest, shown
from pkmodes.measured.cells import cells_of, number_in
from pkmodes.measured.csv_format import read_text
from pkmodes.measured.csv_rows import read_lines

Array = NDArray[np.float64]
FREQUENCY = ("frequency", "freq", "frequency [Hz]", "freq [Hz]")
REAL, IMAGINARY = "re:", "im:"
STATEMENT = re.compile(r"#\s*(unit|quantity|drives)\s*:\s*(.+?)\s*", re.IGNORECASE)
REMEDY = "a table has the columns frequency [Hz], and re:OUTPUT/INPUT and im:OUTPUT/INPUT for each channel"


@dataclass(frozen=True)
class MeasuredResponse:
    """Measured responses of F frequencies at a pose.

    Attributes
    ----------
    source : str
        The file.
    frequencies : ndarray, shape (F,)
        Ascending [Hz].
    channels : dict of str to ndarray, complex128, shape (F,)
        By ``OUTPUT/INPUT``, in the units of the model's response.
    stated : dict of str to str
        What the table's comments say of it: ``quantity``, ``drives``, and ``unit OUTPUT/INPUT``.
    """

    source: str
    frequencies: Array
    channels: dict[str, NDArray[np.complex128]]
    stated: dict[str, str] = field(default_factory=dict)

    def check(self, known: Mapping[str, str]) -> None:
        """Refuse a table that says itself that it is of something else.

        Parameters
        ----------
        known : mapping of str to str
            What the model's response is, by the words of `stated`.

        Raises
        ------
        PkmodesError
            If the table states another unit, quantity or state of the motors.
        """
        for name, value in self.stated.items():
            if name in known and value != known[name]:
                what = f"expected {name} {known[name]} as in the model's response, found {shown(value)}"
                raise PkmodesError(what, self.source, "ask the model for the same, or convert the table")

    def among(self, known: list[str]) -> dict[str, NDArray[np.complex128]]:
        """Return the channels that a response of the model has too.

        Raises
        ------
        PkmodesError
            If it has none of them.
        """
        common = {name: values for name, values in self.channels.items() if name in known}
        if not common:
            what = f"expected a channel of {', '.join(known)}, found {', '.join(self.channels)}"
            raise PkmodesError(what, self.source, nearest(next(iter(self.channels)), known))
        return common


def read_response(path: str | PathLike[str]) -> MeasuredResponse:
    """Read measured frequency responses.

    Parameters
    ----------
    path : path-like
        CSV with a column ``frequency`` [Hz], and ``re:OUTPUT/INPUT`` and ``im:OUTPUT/INPUT`` for each channel; other
        columns are ignored.  Comments may state ``# quantity: ...``, ``# drives: ...`` and ``# unit: OUTPUT/INPUT =
        ...``.

    Returns
    -------
    MeasuredResponse
        With all of its channels.

    Raises
    ------
    MeasurementError
        If the file cannot be read or is invalid, with line and column.
    """
    source = fspath(path)
    text = read_text(Path(path), source, "the responses", "give a CSV file of responses")
    lines = read_lines(text, source)
    if not lines.records:
        raise MeasurementError("expected a header and rows, found none", source, REMEDY)
    (number, header), records = lines.records[0], lines.records[1:]
    names = cells_of(header, f"{source}: line {number}")
    places = _places(names, f"{source}: line {number}")
    if not records:
        raise MeasurementError(
            "expected a row for each frequency, found only a header", source, "add the rows"
        )
    table = np.empty((len(records), 1 + 2 * (len(places) - 1)))
    for row, (number, line) in enumerate(records):
        cells = cells_of(line, f"{source}: line {number}")
        if len(cells) != len(names):
            what = f"expected {len(names)} cells, found {len(cells)}"
            raise MeasurementError(
                what, f"{source}: line {number}", "give each row as many cells as the header"
            )
        wanted = [column for pair in places.values() for column in pair]
        for k, column in enumerate(wanted):
            value = number_in(cells[column], None)
            if value is None:
                what = f"expected a finite number, found {shown(cells[column])}"
                where = f"{source}: line {number}, column {names[column]}"
                raise MeasurementError(what, where, "write a plain number with a decimal point")
            table[row, k] = value
    late = np.flatnonzero(np.diff(table[:, 0]) <= 0.0)
    if len(late):
        number = records[int(late[0]) + 1][0]
        what = f"expected ascending frequencies, found {table[late[0] + 1, 0]:g} Hz after {table[late[0], 0]:g} Hz"
        raise MeasurementError(
            what, f"{source}: line {number}", "sort the rows, and give each frequency once"
        )
    channels = {
        name: table[:, 1 + 2 * k] + 1j * table[:, 2 + 2 * k] for k, name in enumerate(list(places)[1:])
    }
    return MeasuredResponse(source, table[:, 0], channels, _stated(text))


def _stated(text: str) -> dict[str, str]:
    """Return what the comments of a table state."""
    found = {}
    for line in text.splitlines():
        match = STATEMENT.fullmatch(line.rstrip(" ,;\t"))
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


def _places(names: list[str], where: str) -> dict[str, tuple[int, ...]]:
    """Return the column of the frequency, then those of each channel."""
    frequency = [i for i, name in enumerate(names) if name in FREQUENCY]
    if len(frequency) != 1:
        raise MeasurementError(
            f"expected one column of frequencies, found {len(frequency) or 'none'}", where, REMEDY
        )
    found: dict[str, tuple[int, ...]] = {"": (frequency[0],)}
    for i, name in enumerate(names):
        if not name.startswith(REAL):
            continue
        channel = name.removeprefix(REAL)
        other = [j for j, each in enumerate(names) if each == IMAGINARY + channel]
        if len(other) != 1 or channel in found:
            what = f"expected one column {shown(name)} and one {shown(IMAGINARY + channel)}"
            raise MeasurementError(what, where, REMEDY)
        found[channel] = (i, other[0])
    if len(found) == 1:
        raise MeasurementError("expected a channel, found none", where, REMEDY)
    return found
