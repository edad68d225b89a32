"""Read a list of poses from a CSV file."""

from __future__ import annotations

from decimal import Decimal
from os import PathLike, fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.columns import parse_heading
from pkmodes.loop.measured.cells import TableNotation
from pkmodes.loop.measured.csv_format import read_text
from pkmodes.loop.measured.csv_rows import read_lines
from pkmodes.loop.measured.rules import PRINTABLE_REMEDY
from pkmodes.machine.maps.poses import Poses

LABEL_COLUMN = "pose"


def read_poses(path: str | PathLike[str], mechanism: Mechanism) -> Poses:
    """Read poses: one row each.

    - path: table with the components of the pose as columns, in SI units or with a unit in the header (``x [mm]``),
      and optionally their labels in a column ``pose``.  Other columns, such as load cases, are ignored,
      and so are repeated rows; a file of measurements therefore also serves as a list of poses.

    Returns them in the order of the file.
    Raises MeasurementError if the file cannot be read or is invalid, with line and column.
    """
    source = fspath(path)
    units = {component.name: component.unit for component in mechanism.pose}
    remedy = f"start with the columns {','.join(units)}"
    lines = read_lines(read_text(Path(path), source, "the poses", "give a CSV file of poses"), source)
    where, header = lines.header(source, remedy)
    columns = [parse_heading(cell, f"{where}, column {i + 1}", units) for i, cell in enumerate(header)]
    column_of_component = {}
    for name in units:
        matching = [i for i, (column_name, _) in enumerate(columns) if column_name == name]
        if len(matching) != 1:
            problem = f'expected one column "{name}", found {len(matching) or "none"}'
            raise MeasurementError(problem, where, remedy)
        column_of_component[name] = matching[0]
    names = [name for name, _ in columns]
    labelled = names.count(LABEL_COLUMN) == 1
    unique_poses: dict[tuple[str, ...], tuple[float, ...]] = {}
    pose_of_label: dict[str, tuple[float, ...]] = {}
    for where, cells in lines.rows(source, len(columns)):
        pose = tuple(
            _coordinate_value(cells[i], columns[i][1], lines.notation, f"{where}, column {name}")
            for name, i in column_of_component.items()
        )
        label = cells[names.index(LABEL_COLUMN)] if labelled else ""
        if not label.isprintable():
            raise MeasurementError(
                f"expected a label, found {shown(label)}", f"{where}, column {LABEL_COLUMN}", PRINTABLE_REMEDY
            )
        unique_poses[(label, *map(repr, pose))] = pose
        if labelled and pose_of_label.setdefault(label, pose) != pose:
            problem = f"the label {shown(label)} stands for two different poses"
            raise MeasurementError(problem, where, "give each pose a label of its own")
    if not unique_poses:
        raise MeasurementError("expected a row for each pose, found only a header", source, "add the rows")
    labels = tuple(key[0] for key in unique_poses) if labelled else None
    return Poses(np.array(list(unique_poses.values())), tuple(units), labels)


def _coordinate_value(cell: str, factor: Decimal | None, notation: TableNotation, where: str) -> float:
    value = notation.number(cell, factor)
    if value is None:
        problem = f"expected a finite number, found {shown(cell) if cell else 'nothing'}"
        raise MeasurementError(problem, where, f"write a plain number with {notation.decimal}")
    return value
