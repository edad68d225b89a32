"""Records of modes that another program has identified: dataset 55 of universal files, and tables.

Tables have the columns of a measurement file, under any names.  The campaign states where the machine was, so that
only the frequency is required.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from pathlib import Path
from typing import NoReturn

import numpy as np

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.robot.columns import frequency_factor, split_heading
from pkmodes.core.robot.units import QuantityError, base_units
from pkmodes.core.support.ordering import joined
from pkmodes.loop.measured.cells import TableNotation
from pkmodes.loop.measured.csv_format import read_text
from pkmodes.loop.measured.csv_rows import read_lines
from pkmodes.loop.measured.meanings import likely_meaning, split_unit
from pkmodes.loop.measured.rules import SHAPE
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.grouping import MAX_FREQUENCY_DIFFERENCE
from pkmodes.modaltest.campaign.mode_estimates import FileModes, ModeEstimate, check_shape
from pkmodes.modaltest.campaign.shapes import UNDETERMINED, blank_messages, combine_sensors
from pkmodes.modaltest.signals.reading import HEAD_SIZE, read_signals
from pkmodes.modaltest.signals.universal_file import UNIVERSAL_FILE

#: Maximum number of modes of one file within the width in which modes of two files may be the same: far more than any
#: test can resolve, and few enough to compare all pairs in seconds.
MAX_MODES_NEARBY = 200
#: Numeric columns, with the kind of their units.
NUMERIC_COLUMNS = {"frequency": "Hz", "sigma": "Hz", "damping": "1", "sigma_damping": "1", "sigma_shape": "1"}
PER_CENT = Decimal("0.01")


def identified_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes in a file, their shapes by channel.

    Raises MeasurementError if the file is faulty, or has no modes.
    """
    if not _is_universal(path):
        table_modes = tuple(read_mode_table(path, record.columns, campaign.channels, record.pose))
        _check_density(table_modes, str(path))
        return FileModes(table_modes, (), None)
    file = read_signals(path)
    if not file.modes:
        problem = f"expected identified modes (dataset 55 or 2414), found {len(file.functions)} functions and no mode"
        problem += f"; skipped: {'; '.join(file.skipped)}" if file.skipped else ""
        remedy = 'choose another kind of record, such as kind = "frf"'
        raise MeasurementError(problem, file.source, remedy)
    for mode in file.modes:
        where = f"{file.source}: mode at {mode.frequency:g} Hz"
        if mode.damping is not None and not 0.0 <= mode.damping < 1.0:
            problem = f"expected a damping ratio of at least 0 and below 1, found {mode.damping:g}"
            raise MeasurementError(problem, where, "correct it, or export the modes again")
        check_shape(mode.shape, where)
    transducers = campaign.transducers_at(record)
    sensors = {name: transducers[sensor.key] for name, sensor in campaign.sensors_in(setup).items()}
    names_in_file = {name for mode in file.modes for name in mode.shape}
    # Programs write exactly 0 in every mode for nodes without a sensor.
    unmeasured = [
        name
        for name in sensors
        if name in names_in_file and not any(mode.shape.get(name) for mode in file.modes)
    ]
    measured_sensors = {name: transducer for name, transducer in sensors.items() if name not in unmeasured}
    shapes = [
        combine_sensors(
            {name: value for name, value in mode.shape.items() if name in measured_sensors}, measured_sensors
        )
        for mode in file.modes
    ]
    modes = tuple(
        ModeEstimate(mode.frequency, np.nan if mode.damping is None else mode.damping, shape.values)
        for mode, shape in zip(file.modes, shapes, strict=True)
    )
    _check_density(modes, file.source)
    blank = [(mode.frequency, shape.blank) for mode, shape in zip(modes, shapes, strict=True)]
    messages = blank_messages(file.source, UNDETERMINED, blank)
    if unmeasured:
        predicate = "is 0 in every mode" if len(unmeasured) == 1 else "are 0 in every mode"
        zeros = f"{joined(unmeasured)} {predicate}: taken as not measured, and left out of the shapes"
        messages = [f"{file.source}: {zeros}", *messages]
    return FileModes(modes, (*file.messages, *messages), frozenset(names_in_file))


def _check_density(modes: Sequence[ModeEstimate], source: str) -> None:
    """Refuse a list with more modes in a narrow range than a structure can have."""
    f = np.sort([mode.frequency for mode in modes])
    counts = np.searchsorted(f, f * (1.0 + MAX_FREQUENCY_DIFFERENCE), side="right") - np.arange(len(f))
    densest = int(np.argmax(counts))
    if counts[densest] > MAX_MODES_NEARBY:
        width = f"{100.0 * MAX_FREQUENCY_DIFFERENCE:g} % from {f[densest]:.4g} Hz"
        problem = f"expected modes, found {counts[densest]} within {width}"
        remedy = "list each mode once, and each pose as a record of its own"
        raise MeasurementError(problem, source, remedy)


def _is_universal(path: Path) -> bool:
    """Return whether a file is a universal file."""
    try:
        with path.open("rb") as file:
            head = file.read(HEAD_SIZE)
    except (OSError, ValueError):  # the reader reports the reason
        head = b""
    return UNIVERSAL_FILE.recognises(head) or path.suffix.lower() in UNIVERSAL_FILE.suffixes


def read_mode_table(
    path: Path, columns: Mapping[str, str], channels: Mapping[str, str], pose: str
) -> list[ModeEstimate]:
    """Read identified modes.

    - columns: names of the table's columns, by those of a measurement file
    - channels: names that a shape column may have, and their units
    - pose: label: if the table has a column ``pose``, only the rows with this label count

    Raises MeasurementError if the file cannot be read or is invalid, with line and column.
    """
    source = str(path)
    text = read_text(path, source, "the modes", "give a table of modes")
    lines = read_lines(text, source)
    remedy = "start with the names of the columns"
    where, names = lines.header(source, remedy)
    if len(lines.records) < 2:
        _refuse("expected a header and rows, found none", source, remedy)
    column_indices = _column_indices(names, columns, channels, where)
    modes, labels = [], set()
    for where, cells in lines.rows(source, len(names)):
        if "pose" in column_indices:
            label = cells[column_indices["pose"][0]]
            labels.add(label)
            if label != pose:
                continue
        modes.append(_mode_of_row(cells, column_indices, names, lines.notation, where))
    if not modes:
        problem = f"expected rows of the pose {shown(pose)}, found {', '.join(sorted(labels)) or 'none'}"
        _refuse(problem, source, "correct the label of the record, or leave the column out")
    return modes


def _column_indices(
    names: list[str], columns: Mapping[str, str], channels: Mapping[str, str], where: str
) -> dict[str, tuple[int, Decimal | None]]:
    """Return the index of each known column, and its factor to SI units or Hz."""
    functions = [name for name in names if name.startswith(("re:", "im:"))]
    if functions:
        problem = f"expected modes, found frequency responses, {shown(functions[0])}"
        _refuse(problem, where, 'the kind of this record is "frf"')
    unknown = [
        key for key in columns if key not in NUMERIC_COLUMNS and key != "pose" and not key.startswith(SHAPE)
    ]
    if unknown:
        known_columns = ["pose", *NUMERIC_COLUMNS, *(f"{SHAPE}{name}" for name in channels)]
        _refuse(
            f"unknown column {shown(unknown[0])} in columns", where, nearest_name(unknown[0], known_columns)
        )
    key_by_name = {name: key for key, name in columns.items()}
    if len(key_by_name) < len(columns):
        _refuse("two entries of columns name the same column", where, "give each its own")
    indices: dict[str, tuple[int, Decimal | None]] = {}
    for i, cell in enumerate(names):
        name, unit = split_heading(cell, [*key_by_name, *NUMERIC_COLUMNS, "pose"])
        if name in key_by_name and unit is None:
            unit = split_unit(cell)[1] or None  # "Damping ratio in %"
        name = key_by_name.get(name, key_by_name.get(cell, name))
        if name.startswith(SHAPE) and name.removeprefix(SHAPE) not in channels:
            channel = name.removeprefix(SHAPE)
            _refuse(
                f"unknown channel {shown(channel)}",
                f"{where}, column {i + 1}",
                nearest_name(channel, channels),
            )
        if name in NUMERIC_COLUMNS or name == "pose" or name.startswith(SHAPE):
            if name in indices:
                _refuse(
                    f"the column {shown(name)} is repeated", f"{where}, column {i + 1}", "remove one of them"
                )
            indices[name] = (i, _factor(name, unit, f"{where}, column {i + 1}") if unit else None)
    present = {*names, *(split_heading(cell, list(key_by_name))[0] for cell in names)}
    missing = [name for name in columns.values() if name not in present]
    if missing:
        _refuse(
            f"expected the column {shown(missing[0])}, found none", where, nearest_name(missing[0], names)
        )
    if "frequency" not in indices:
        standard_columns = [*NUMERIC_COLUMNS, *(f"{SHAPE}{name}" for name in channels)]
        meanings: dict[str, str] = {}
        for cell in names:
            meaning = split_unit(likely_meaning(cell, standard_columns, {*indices, *meanings}))[0]
            meanings |= {meaning: cell} if meaning else {}
        likely = meanings if "frequency" in meanings else {"frequency": "f0", **meanings}
        example = ", ".join(
            f"{shown(key) if ':' in key else key} = {shown(cell)}" for key, cell in likely.items()
        )
        remedy = (
            f"name it in the record: columns = {{ {example} }}; the table has {', '.join(map(shown, names))}"
        )
        _refuse("expected a column of frequencies, found none", where, remedy)
    return indices


def _factor(name: str, unit: str, where: str) -> Decimal:
    try:
        if NUMERIC_COLUMNS.get(name) == "Hz":
            return frequency_factor(unit)
        if name in NUMERIC_COLUMNS:
            if unit != "%":
                raise QuantityError(f"{shown(unit)} is not the unit of a ratio")
            return PER_CENT
        return base_units(unit)[0]
    except QuantityError as error:
        _refuse(str(error), where, "correct the unit")


def _mode_of_row(
    cells: list[str],
    column_indices: Mapping[str, tuple[int, Decimal | None]],
    names: list[str],
    notation: TableNotation,
    where: str,
) -> ModeEstimate:
    values: dict[str, float] = {}
    shape: dict[str, complex] = {}
    for name, (i, factor) in column_indices.items():
        if name == "pose" or not cells[i]:
            continue
        value = notation.number(cells[i], factor)
        if value is None:
            remedy = "write a plain number, or leave the cell blank"
            _refuse(
                f"expected a finite number, found {shown(cells[i])}", f"{where}, column {names[i]}", remedy
            )
        if name.startswith(SHAPE):
            shape[name.removeprefix(SHAPE)] = complex(value)
        else:
            values[name] = value
    frequency_cell = f"{where}, column {names[column_indices['frequency'][0]]}"
    if values.get("frequency", 0.0) <= 0.0:
        _refuse(
            f"expected a frequency above 0, found {shown(cells[column_indices['frequency'][0]])}",
            frequency_cell,
            "correct it",
        )
    for name in ("sigma", "sigma_damping", "sigma_shape"):
        if values.get(name, 1.0) <= 0.0:
            _refuse(
                "expected a standard deviation above 0",
                f"{where}, column {name}",
                "leave it blank if unknown",
            )
    check_shape(shape, where)
    if not 0.0 <= values.get("damping", 0.0) < 1.0:
        _refuse(
            "expected a damping ratio of at least 0 and below 1", f"{where}, column damping", "2 % is 0.02"
        )
    return ModeEstimate(
        values["frequency"],
        values.get("damping") or np.nan,  # programs that know no damping write 0
        shape,
        values.get("sigma", 0.0),
        values.get("sigma_damping", 0.0),
        values.get("sigma_shape", np.nan),
    )


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(what, where, remedy) from None
