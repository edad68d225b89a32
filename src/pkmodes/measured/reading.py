"""Read modal measurements: CSV with a header, or the first thing that is wrong, with its line and column."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from pkmodes.errors import MeasurementError, PoseError, shown
from pkmodes.measured.header import read_header
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.table import cells_of, read_lines, read_table
from pkmodes.poses import check_poses

if TYPE_CHECKING:
    from pkmodes.model import Model

LARGEST_FILE = 50_000_000
#: How files of spreadsheets begin: an archive, and the older format of Excel.
WORKBOOKS = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")
#: What positions in another unit than they are said to be are multiplied with, and what then is to be done.
OTHER_LENGTHS = {
    1e-3: "the numbers look like millimetres: write x [mm],y [mm],z [mm] in the header",
    1e3: "the numbers look like metres, and the header says otherwise: write x,y,z in it",
}


def read_measurements(
    path: str | PathLike[str], channels: Collection[str] | Mapping[str, str], *, positions: bool = True
) -> Measurements:
    """Read modal measurements of a machine whose setups are poses.

    Parameters
    ----------
    path : path-like
        A CSV file in UTF-8 with one row for each identified mode: the columns ``pose``, ``x``, ``y``, ``z`` [m],
        ``frequency``, ``sigma`` [Hz], and where known ``sigma_x``, ``sigma_y``, ``sigma_z`` [m], ``damping``,
        ``sigma_damping``, ``mode``, ``shape:<coordinate>`` and ``sigma_shape``.  A header may carry a unit,
        ``frequency [rad/s]``.  A comment line ``# band: 10 Hz, 400 Hz`` says where modes were looked for; other
        lines that begin with ``#`` are passed over, and so are blank ones.
    channels : collection of str, or mapping of str to str
        Coordinates that a shape column may name; a mapping gives their SI units, without which a unit of a
        shape column may be one of length or angle.
    positions : bool
        Whether ``x``, ``y`` and ``z`` have to be there.  Where not, they are there together or not at all.

    Returns
    -------
    Measurements
        The rows in the order of the file, in SI units.

    Raises
    ------
    MeasurementError
        If the file cannot be read or anything in it is wrong, with line, column, what was expected and what
        was found.
    """
    source = fspath(path)
    lines = read_lines(_text(Path(path), source), source)
    if not lines.records:
        remedy = "begin with the names of the columns"
        raise MeasurementError("expected a header and rows, found none", source, remedy)
    number, line = lines.records[0]
    where = f"{source}: line {number}"
    columns = read_header(cells_of(line, where), where, channels, positions)
    return read_table(columns, lines, source)


def read_modes(path: str | PathLike[str], channels: Collection[str] | Mapping[str, str]) -> Measurements:
    """Read modal measurements of any structure.

    Parameters
    ----------
    path : path-like
        A CSV file in UTF-8 with one row for each identified mode: the columns ``pose`` (the label of a setup),
        ``frequency``, ``sigma`` [Hz], and where known ``damping``, ``sigma_damping``, ``mode``,
        ``shape:<channel>`` and ``sigma_shape``.  A header may carry a unit, ``frequency [rad/s]``.  A comment
        line ``# band: 10 Hz, 400 Hz`` says where modes were looked for.
    channels : collection of str, or mapping of str to str
        Channels of the structure, which the shape columns name; a mapping gives their SI units, without which a
        unit of a shape column may be one of length or angle.

    Returns
    -------
    Measurements
        The rows in the order of the file, in SI units.

    Raises
    ------
    MeasurementError
        If the file cannot be read or anything in it is wrong, with line, column, what was expected and what
        was found.
    """
    return read_measurements(path, channels, positions=False)


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
    for factor, remedy in OTHER_LENGTHS.items():
        scaled = check_poses(measurements.points * factor, parameters, "nan", model.max_condition)
        if scaled.valid.all() and not valid.any():
            _refuse(f"no pose can be reached, but every one if it is multiplied by {factor:g}", where, remedy)
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
        content = path.read_bytes()
        if content.startswith(WORKBOOKS):
            remedy = "open it there and save it as CSV UTF-8"
            _refuse("expected CSV text, found an Excel workbook or another archive", source, remedy)
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        what = f"expected UTF-8 text, found the byte 0x{error.object[error.start]:02x}"
        _refuse(what, f"{source}: line {line}", "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or str(error)
        remedy = "check its permissions" if isinstance(error, PermissionError) else "check the path"
        _refuse(f"cannot read the measurements: {reason.lower()}", source, remedy)
