"""Read modal measurements: CSV with a header, or the first thing that is wrong, with its line and column."""

from __future__ import annotations

import csv
import difflib
import io
import math
import re
from collections.abc import Collection, Iterator
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from pkmodes.errors import MeasurementError, PoseError, shown
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.rules import COMPONENTS, SHAPE, Problem, refuse
from pkmodes.poses import check_poses

if TYPE_CHECKING:
    from pkmodes.model import Model

LARGEST_FILE = 50_000_000
REQUIRED = ("pose", "x", "y", "z", "frequency", "sigma")
OPTIONAL = ("sigma_x", "sigma_y", "sigma_z", "damping", "mode")
TEXT = ("pose", "mode")
#: What a blank cell means, in the columns where one is allowed.
BLANK = {"sigma_x": 0.0, "sigma_y": 0.0, "sigma_z": 0.0, "damping": math.nan}

# Stricter than float(): no "nan", no "1_000", no digits of other scripts.
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
HEADER_HELP = f"begin with a header such as {','.join(REQUIRED)}"


def read_measurements(path: str | PathLike[str], channels: Collection[str]) -> Measurements:
    """Read modal measurements.

    Parameters
    ----------
    path : path-like
        A CSV file in UTF-8 with one row for each identified mode: the columns ``pose``, ``x``, ``y``, ``z`` [m],
        ``frequency``, ``sigma`` [Hz], and where known ``sigma_x``, ``sigma_y``, ``sigma_z`` [m], ``damping``,
        ``mode`` and ``shape:<coordinate>``.  Blank lines and lines that begin with ``#`` are passed over.
    channels : collection of str
        Coordinates that a shape column may name.

    Returns
    -------
    Measurements
        The rows in the order of the file.

    Raises
    ------
    MeasurementError
        If the file cannot be read or anything in it is wrong, with line, column, what was expected and what
        was found.
    """
    source = fspath(path)
    records = _records(_text(Path(path), source), source)
    line, header = next(records, (0, []))
    if not header:
        _refuse("expected a header and rows, found none", source, HEADER_HELP)
    _check_header(header, f"{source}: line {line}", channels)
    return _table(header, list(records), source)


def check_reachable(measurements: Measurements, model: Model) -> None:
    """Refuse measurements at poses that the robot cannot take.

    Raises
    ------
    MeasurementError
        If a pose is out of reach, singular, or has a carriage beyond its limits: for the first such pose, with
        the line of its first row.
    """
    if not measurements.labels:
        return
    parameters = model.robot.parameters
    valid = check_poses(measurements.points, parameters, "nan", model.max_condition).valid
    if valid.all():
        return
    first = int(np.argmin(valid))
    line = measurements.lines[int(np.argmax(measurements.pose == first))]
    where = f"{measurements.source}: line {line}, columns x, y and z"
    if (bad := int((~valid).sum())) > 1:
        where += f", the first of {bad} bad poses"
    try:
        check_poses(measurements.points[first], parameters, "raise", model.max_condition)
    except PoseError as error:
        position = ", ".join(f"{c:.6g}" for c in measurements.points[first])
        raise MeasurementError(
            f"pose {shown(measurements.labels[first])} at [{position}] m cannot be reached: {error.what}",
            where,
            f"{error.remedy}; check the row and {model.robot.source}",
        ) from None


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(what, where, remedy) from None


def _text(path: Path, source: str) -> str:
    remedy = "give a CSV file of modal measurements"
    try:
        if path.exists() and not path.is_file():
            kind = "a folder" if path.is_dir() else "not a regular file"
            _refuse(f"cannot read the measurements: it is {kind}", source, remedy)
        if path.stat().st_size > LARGEST_FILE:
            _refuse("cannot read the measurements: it has more than 50 MB", source, remedy)
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        what = f"expected UTF-8 text, found the byte 0x{error.object[error.start]:02x}"
        _refuse(what, f"{source}: line {line}", "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or str(error)
        _refuse(f"cannot read the measurements: {reason.lower()}", source, "check the path")


def _records(text: str, source: str) -> Iterator[tuple[int, list[str]]]:
    """Cells of the lines that hold any, with the number of the line.

    Line by line, because a cell that went on in the next line would only be a quote that is not closed.
    """
    for number, line in enumerate(io.StringIO(text, newline=None), start=1):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        try:
            (cells,) = csv.reader([line], strict=True, skipinitialspace=True)
        except csv.Error as error:
            remedy = "close every quote on its line, and put a comma right after it"
            _refuse(f"not valid CSV: {error}", f"{source}: line {number}", remedy)
        yield number, [cell.strip() for cell in cells]


def _check_header(header: list[str], where: str, channels: Collection[str]) -> None:
    known = [*REQUIRED, *OPTIONAL, *(f"{SHAPE}{name}" for name in channels)]
    if len(header) == 1 and re.search(r"[;\t|]", header[0]):
        _refuse(f"expected columns separated by commas, found {shown(header[0])}", where, HEADER_HELP)
    if not set(header) & set(REQUIRED):
        _refuse(f"expected the names of the columns, found {shown(','.join(header))}", where, HEADER_HELP)
    for i, name in enumerate(header):
        place = f"{where}, column {i + 1}"
        if not name:
            _refuse("expected the name of a column, found nothing", place, "name the column or remove it")
        if name not in known:
            nearest = difflib.get_close_matches(name, known, n=1, cutoff=0.5)
            fallback = f"known are: {', '.join(known)}"
            shape = name.startswith(SHAPE)
            what = f"{shown(name)} names no coordinate" if shape else f"unknown column {shown(name)}"
            _refuse(what, place, f'did you mean "{nearest[0]}"?' if nearest else fallback)
        if name in header[:i]:
            what = f"the column {shown(name)} is there twice, first as column {header.index(name) + 1}"
            _refuse(what, place, "remove one of them")
    for name in REQUIRED:
        if name not in header:
            _refuse(f'the column "{name}" is missing', where, HEADER_HELP)


def _table(header: list[str], records: list[tuple[int, list[str]]], source: str) -> Measurements:
    """Convert the cells; every cell that is not what its column holds is a problem of its own."""
    if not records:
        _refuse("expected a row for each identified mode, found a header only", source, "add the rows")
    lines = np.array([line for line, _ in records])
    texts: dict[str, list[str]] = {name: [] for name in TEXT}
    numbers: dict[str, list[float]] = {name: [] for name in header if name not in TEXT}
    problems: list[Problem] = []
    for row, (_, cells) in enumerate(records):
        if len(cells) != len(header):
            short = len(cells) < len(header)
            column = header[len(cells)] if short else str(len(header) + 1)
            what = f"expected {len(header)} cells, found {len(cells)}"
            remedy = "leave the cells of optional columns blank, but keep their commas"
            problems.append(Problem(row, column, what, remedy if short else "remove what is too much"))
            continue
        for name, cell in zip(header, cells, strict=True):
            if name in TEXT:
                texts[name].append(cell)
            else:
                value = _number(name, cell)
                if isinstance(value, str):
                    remedy = "write a plain number in SI units, with a point for the decimals"
                    problems.append(Problem(row, name, value, remedy))
                else:
                    numbers[name].append(value)
    refuse(problems, source, lines)
    rows = len(records)
    blank = [0.0] * rows
    return Measurements.from_rows(
        texts["pose"],
        numbers["frequency"],
        numbers["sigma"],
        points=np.array([numbers[name] for name in COMPONENTS]).T,
        point_sigma=np.array([numbers.get(f"sigma_{name}", blank) for name in COMPONENTS]).T,
        damping=numbers.get("damping"),
        mode=texts["mode"] if "mode" in header else None,
        shapes={
            name.removeprefix(SHAPE): column for name, column in numbers.items() if name.startswith(SHAPE)
        },
        source=source,
        lines=lines,
    )


def _number(column: str, cell: str) -> float | str:
    """The number in a cell, or what is wrong with it."""
    if not cell and column not in REQUIRED:
        return BLANK.get(column, math.nan)
    value = float(cell) if NUMBER.fullmatch(cell) else math.nan
    return (
        value
        if math.isfinite(value)
        else f"expected a finite number, found {shown(cell) if cell else 'nothing'}"
    )
