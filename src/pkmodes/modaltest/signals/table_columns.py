"""The meaning of a table's columns: by their names, the units in these, and the request for the file.

A name is ``time``, ``force``, ``re:acc_1/hammer``, ``mag:acc_1``, ``psd_x``, or that of a sensor.  Units are in
square brackets; many programs write them in parentheses, or those of times after an underscore.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.columns import split_heading
from pkmodes.core.support.ordering import listed
from pkmodes.loop.measured.meanings import split_unit
from pkmodes.modaltest.signals.functions import FORCE, MAX_NAMES, FunctionKind, SignalRequest
from pkmodes.modaltest.signals.units import hertz_in, seconds_in, unit_text

TIME = "time"
FREQUENCIES = ("frequency", "freq")
#: Other names for times and frequencies, used if no column has one of those above.
OTHER_TIMES, OTHER_FREQUENCIES = ("t", "timestamp", "datetime", "clock"), ("f", "frequencies")
REAL, IMAGINARY, MAGNITUDE, PHASE, COHERENCE, POWER = "re:", "im:", "mag:", "phase:", "coh:", "psd_"
#: The two parts of a frequency response, by pairs of prefixes.
RESPONSE_PARTS = ((REAL, IMAGINARY), (MAGNITUDE, PHASE))
#: A name of a function of frequency: its kind, its sensor, and a reference.
SPECTRAL = re.compile(r"(re:|im:|mag:|phase:|coh:|psd_)([^/]*)(.*)", re.IGNORECASE)
BODE = re.compile(r"(?:(?P<mag>mag(?:nitude)?|ampl(?:itude)?)|phase)[ _]?(?P<name>.*)", re.IGNORECASE)
POWERS = ("psd_x", "psd_y", "psd_z")
IN_PARENTHESES = re.compile(r"(.*?)\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)")
AFTER_UNDERSCORE = re.compile(r"(.*)_([A-Za-z]+)")
DECIBELS = "db"


@dataclass(frozen=True)
class FunctionColumn:
    """A function in a table.

    - indices: indices of its one or two columns
    - labels: labels of their units
    - polar: whether the two columns are magnitude and phase
    """

    kind: FunctionKind
    response: str
    reference: str
    indices: tuple[int, ...]
    labels: tuple[str, ...]
    force: bool = False
    polar: bool = False

    @property
    def decibels(self) -> bool:
        """Whether the magnitude is in decibels."""
        return self.polar and self.labels[0].lower().startswith(DECIBELS)

    @property
    def unit(self) -> str:
        """The label of the unit of its values."""
        return "" if self.decibels else self.labels[0]


@dataclass(frozen=True)
class TableLayout:
    """The columns of a table.

    - abscissa: index of the column of times or frequencies; None without one
    - abscissa_unit: the label of its unit
    - columns: the functions
    """

    abscissa: int | None
    abscissa_unit: str
    kind: FunctionKind
    columns: tuple[FunctionColumn, ...]


def find_layout(
    cells: Sequence[str], where: str, request: SignalRequest, *, has_rate: bool = False
) -> TableLayout:
    """Return the layout of a table's columns.

    - cells: cells of the header, with units
    - where: the line of the header, for messages
    - request: the request for the file
    - has_rate: whether the file states a rate, which stands in for times

    Raises MeasurementError if there is no time or frequency, or more than one; if a requested column is repeated or
    lacks its other part.
    """
    heads = _rename_heads([_head(cell, request) for cell in cells], where, request)
    times = _columns_named(heads, (TIME,), seconds_in)
    frequencies = _columns_named(heads, FREQUENCIES, hertz_in)
    if not times and not frequencies and request.rate is None:
        unclaimed = [
            ("", "") if request.sensors and name in request.sensors else (name, label)
            for name, label in heads
        ]
        times = _columns_named(unclaimed, OTHER_TIMES, seconds_in)
        frequencies = {} if times else _columns_named(unclaimed, OTHER_FREQUENCIES, hertz_in)
    abscissas = times | frequencies
    if len(abscissas) > 1:
        problem = f"expected one column of times or frequencies, found {len(abscissas)}"
        raise MeasurementError(problem, where, "leave one of them out")
    if not abscissas and request.rate is None and not has_rate:
        problem = (
            f"expected a column of times or frequencies, found {listed([*map(shown, cells)], MAX_NAMES)}"
        )
        remedy = 'state in the record which it is, names = { time = "NAME" } or { frequency = "NAME" }'
        raise MeasurementError(problem, where, f'{remedy}, or give the rate there, rate = "3200 Hz"')
    names = {i: name for i, (name, _) in enumerate(heads) if i not in abscissas and name}
    labels = [label for _, label in heads]
    if frequencies:
        columns = _spectral_columns(names, labels, where, request)
    else:
        columns = [
            FunctionColumn(FunctionKind.TIME, name, "", (i,), (labels[i],), name == FORCE)
            for i, name in names.items()
            if name == FORCE or request.wants(name)
        ]
    _refuse_repeated(columns, cells, where)
    abscissa, abscissa_unit = next(iter(abscissas.items()), (None, ""))
    return TableLayout(
        abscissa, abscissa_unit, FunctionKind.FRF if frequencies else FunctionKind.TIME, tuple(columns)
    )


def _head(cell: str, request: SignalRequest) -> tuple[str, str]:
    """Return the name in a cell and the label of its unit, "" without one; the whole cell may name a sensor."""
    name, label = split_heading(cell, ())
    if label is None and (match := IN_PARENTHESES.fullmatch(cell)) is not None:
        has_unit = unit_text(match[2]) is not None or match[2].lower().startswith(DECIBELS)
        name, label = (match[1], match[2]) if has_unit else (cell, None)
    if label is None and unit_text(split_unit(cell)[1]) is not None:
        name, label = split_unit(cell)
    is_name = cell in (request.sensors or ()) or cell in request.names.values()
    return (cell if is_name else name), label or ""


def _rename_heads(
    heads: Sequence[tuple[str, str]], where: str, request: SignalRequest
) -> list[tuple[str, str]]:
    """Return the names used here, "" for columns that are not read, and the labels of their units."""
    matches = [SPECTRAL.fullmatch(name) for name, _ in heads]
    plain_names = [
        match[2].strip() if match else name for (name, _), match in zip(heads, matches, strict=True)
    ]
    own_names = request.own_names(dict.fromkeys(plain_names), where)
    renamed = []
    for (name, label), match, plain in zip(heads, matches, plain_names, strict=True):
        parts = AFTER_UNDERSCORE.fullmatch(name)
        if (
            not label
            and own_names.get(plain) in (TIME, FREQUENCIES[0])
            and parts
            and (seconds_in(parts[2]) is not None or hertz_in(parts[2]) is not None)
        ):
            label = parts[2]
        new_name = own_names.get(plain, plain)
        renamed.append((f"{match[1].lower()}{new_name}{match[3]}" if match else new_name, label))
    return renamed


def _columns_named(
    heads: Sequence[tuple[str, str]], names: Sequence[str], factor_in: Callable[[str], float | None]
) -> dict[int, str]:
    """Return the columns with one of some names, and the label of their unit, perhaps after an underscore."""
    labelled = {}
    for i, (name, label) in enumerate(heads):
        parts = AFTER_UNDERSCORE.fullmatch(name)
        if name.lower() in names:
            labelled[i] = label
        elif parts and parts[1].lower() in names and factor_in(parts[2]) is not None:
            labelled[i] = parts[2]
    return labelled


def _spectral_columns(
    names: Mapping[int, str], labels: Sequence[str], where: str, request: SignalRequest
) -> list[FunctionColumn]:
    """Return the columns of a table of functions of frequency."""
    columns = _bode_columns(names, labels, request)
    used = {index for column in columns for index in column.indices}
    takes_plain_names = request.sensors is not None or not any(
        name.startswith((REAL, MAGNITUDE, COHERENCE, POWER)) for name in names.values()
    )
    indices_by_name: dict[str, list[int]] = {}
    for i, name in names.items():
        indices_by_name.setdefault(name, []).append(i)
    for i, name in names.items():
        if i in used:
            continue
        channel = name.partition(":")[2]
        response, _, reference = (part.strip() for part in channel.partition("/"))
        parts = next((parts for parts in RESPONSE_PARTS if name.startswith(parts)), None)
        if parts is not None:
            if not request.wants(response):
                continue
            pair = [indices_by_name.get(f"{part}{channel}", []) for part in parts]
            if [len(candidates) for candidates in pair] != [1, 1]:
                problem = (
                    f"expected one column {shown(parts[0] + channel)} and one {shown(parts[1] + channel)}"
                )
                raise MeasurementError(problem, where, "give both parts of each frequency response once")
            if name.startswith(parts[0]):
                pair_indices = (pair[0][0], pair[1][0])
                pair_labels = (labels[pair_indices[0]], labels[pair_indices[1]])
                polar = parts[0] == MAGNITUDE
                columns.append(
                    FunctionColumn(
                        FunctionKind.FRF, response, reference, pair_indices, pair_labels, polar=polar
                    )
                )
        elif name.startswith(COHERENCE):
            if request.wants(response):
                columns.append(
                    FunctionColumn(FunctionKind.COHERENCE, response, reference, (i,), (labels[i],))
                )
        elif name.lower() in POWERS or (name.startswith(POWER) and request.sensors is not None):
            power = name[len(POWER) :]
            if request.wants(name, power):
                columns.append(FunctionColumn(FunctionKind.SPECTRUM, power, "", (i,), (labels[i],)))
        elif takes_plain_names and request.wants(name):
            columns.append(FunctionColumn(FunctionKind.SPECTRUM, name, "", (i,), (labels[i],)))
    return columns


def _bode_columns(
    names: Mapping[int, str], labels: Sequence[str], request: SignalRequest
) -> list[FunctionColumn]:
    """Return the frequency responses in columns such as ``Mag1 (dB)`` and ``Phase1 (deg)``.

    The sensor is named by the column of the magnitude, or by what follows the word in it.
    """
    magnitudes: dict[str, tuple[int, str]] = {}
    phases: dict[str, tuple[int, str]] = {}
    for i, name in names.items():
        if (match := BODE.fullmatch(name)) is not None and ":" not in name:
            (magnitudes if match["mag"] else phases)[match["name"].lower()] = i, match["name"]
    columns = []
    for key, (i, suffix) in magnitudes.items():
        requested = [candidate for candidate in (names[i], suffix) if candidate and request.wants(candidate)]
        if key in phases and requested:
            j, _ = phases[key]
            columns.append(
                FunctionColumn(FunctionKind.FRF, requested[0], "", (i, j), (labels[i], labels[j]), polar=True)
            )
    return columns


def _refuse_repeated(columns: Sequence[FunctionColumn], cells: Sequence[str], where: str) -> None:
    """Refuse two columns of one function."""
    by_function: dict[tuple[FunctionKind, str, str], FunctionColumn] = {}
    for column in columns:
        first = by_function.setdefault((column.kind, column.response, column.reference), column)
        if first is not column:
            name = shown(cells[column.indices[0]])
            problem = f"the column {name} is repeated, first as column {first.indices[0] + 1}"
            raise MeasurementError(problem, f"{where}, column {column.indices[0] + 1}", "remove one of them")
