"""What the columns of a table are, by their names: ``time``, ``force``, ``re:acc_1/hammer``, ``psd_x``, a sensor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import IN_BRACKETS
from pkmodes.signals.formats import Asked
from pkmodes.signals.functions import Kind

TIME, FORCE = "time", "force"
FREQUENCIES = ("frequency", "freq")
REAL, IMAGINARY, COHERENCE, POWER = "re:", "im:", "coh:", "psd_"
POWERS = ("psd_x", "psd_y", "psd_z")


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
    parts = [_parted(cell) for cell in cells]
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
    labels = [label for _, label in parts]
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


def _parted(cell: str) -> tuple[str, str]:
    """Split a cell into its name and the label of its unit."""
    match = IN_BRACKETS.fullmatch(cell)
    return (cell, "") if match is None else (match[1].strip(), match[2].strip())
