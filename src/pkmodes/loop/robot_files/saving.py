"""Write a corrected robot: the robot file with some values changed and everything else kept.

The correction of a parameter group is split into those of single values of the file.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NoReturn

import numpy as np

from pkmodes.core.base.errors import OutputError, PkmodesError, RobotFileError, nearest_name, shown
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.covariance import CORRELATION, COVARIANCE, PATHS, SIGMA, Covariance
from pkmodes.core.robot.declaration import Declaration, changeable_units
from pkmodes.core.robot.layout import EFFECTS, items_by_path, table_sources
from pkmodes.core.robot.parameter_groups import elements_at_value, groups_by_path
from pkmodes.core.robot.reading import read_robot, robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.units import Quantity
from pkmodes.core.support.covariance import joined_covariance, sigmas_by_path
from pkmodes.core.support.writing import write_file
from pkmodes.loop.robot_files.editing import Keys, TomlText, ValueNotation, sigma_text

DIGITS = 10
#: Elements of a group are written with more digits, because their rounding errors add up.
DIGITS_OF_ELEMENTS = 12
VALUE_TOLERANCE, SIGMA_TOLERANCE = (
    1e-9,
    1e-2,
)  # tolerances for the digits written; standard deviations have three
#: Digits of standard deviations in a table of correlations, where large parts of a variance may cancel.
SIGMA_DIGITS = 8
CORRELATIONS_COMMENT = "correlations of the errors of the fitted values, used for frequencies and samples"
BY_HAND_REMEDY = "change the robot file by hand"
__all__ = ["Correction", "corrected_text", "save_corrected"]


@dataclass(frozen=True)
class Correction:
    """A value to write.

    - value: in SI units
    - sigma: one standard deviation in SI units; None keeps the one declared in the file, if any
    - note: the comment to write after the value, such as "was 1.5 kg: refitted"
    - digits: significant digits of the value
    """

    value: float
    sigma: float | None = None
    note: str = ""
    digits: int = DIGITS


def _edits_of(changes: Mapping[str, Correction], robot: Declaration) -> dict[str, Correction]:
    """Return the corrections of single values of the file, by dotted path.

    - changes: by path of a value or of a parameter group
    - robot: the robot as declared in its file

    Raises OutputError if a path cannot be changed, two corrections change one value, a number is not finite, or a
    vector has no direction along which its radius could change.
    """
    edits: dict[str, Correction] = {}
    groups = groups_by_path(robot.mechanism)
    for path, correction in changes.items():
        value, sigma = correction.value, correction.sigma
        if not math.isfinite(value) or not (sigma is None or (math.isfinite(sigma) and sigma >= 0.0)):
            _refuse(
                f"expected a finite value and a standard deviation of at least 0, found {value:g} and {sigma}",
                f"{robot.source}: {path}",
                "use finite numbers",
            )
        if path in groups:
            # The standard deviation of a group goes into the comment.
            deviation = "" if sigma is None else f"sigma of {path} {sigma_text(sigma)} {groups[path].unit}"
            note = "; ".join(part for part in (correction.note, deviation) if part)
            try:
                values = elements_at_value(robot, groups[path], value)
            except PkmodesError as error:
                _refuse(error.what, error.where, error.remedy)
            changed = {
                element: Correction(number, None, note, DIGITS_OF_ELEMENTS)
                for element, number in values.items()
            }
        elif path in changeable_units(robot):
            changed = {path: replace(correction, value=float(value))}
        else:
            remedy = nearest_name(
                path, changeable_units(robot), "see docs/reference/robot-file.md for the values"
            )
            _refuse(f"there is no value {shown(path)} to change", robot.source, remedy)
        for element in changed:
            if element in edits:
                _refuse(
                    "the value would be changed twice", f"{robot.source}: {element}", "change it only once"
                )
        edits |= changed
    return edits


def _refuse(problem: str, where: str, remedy: str) -> NoReturn:
    """Raise the error of a robot that cannot be saved."""
    raise OutputError(problem, where, remedy) from None


def save_corrected(
    source: Path, target: Path, changes: Mapping[str, Correction], covariance: Covariance | None = None
) -> None:
    """Write the corrected robot into another file, completely or not at all.

    - source: the robot file
    - target: output file; an existing file is replaced, but never the robot file itself
    - covariance: as for `corrected_text`

    Raises OutputError if the target is the robot file or cannot be written, or as for `corrected_text`.
    Raises RobotFileError if the robot file cannot be read.
    """
    if "\0" in str(target) or target.is_dir() or not target.parent.is_dir():
        remedy = (
            "choose another place" if "\0" in str(target) or target.is_dir() else "create the folder first"
        )
        _refuse("expected a file in an existing folder", shown(str(target)), remedy)
    if source.exists() and target.exists() and source.samefile(target):
        _refuse("the corrected robot would replace its own input", str(target), "choose another file")
    write_file(target, corrected_text(source, changes, covariance))


def corrected_text(
    source: Path, changes: Mapping[str, Correction], covariance: Covariance | None = None
) -> str:
    """Return the text of a robot file with some values changed.

    - source: the robot file
    - changes: by path: a declared value (``platform.mass``, ``axis.1.origin.x``); an override for one axis
      (``axis.1.belt.width``); ``frame.mass``; an effect parameter (``effects.payload.mass``); or a group such as
      ``axis.span``: its value is that of the first element, and its change applies to all
    - covariance: the correlations of the errors of changed values.  Tables of the file that correlate any of these
      become one, in the place of the first: these values, and the others as they were.

    The values are in the units of the file.  Lines without a changed value are unchanged.  The standard deviation of
    a group is written in a comment, because its elements cannot carry it.
    Raises OutputError if a path cannot be changed, a value would be rejected by the reader, or the result does not
    read back as intended.
    Raises RobotFileError if the robot file cannot be read.
    """
    robot = read_robot(source)
    edits = _edits_of(changes, robot)
    document = TomlText(source.read_bytes().decode("utf-8"), robot.source)
    units = changeable_units(robot)
    appended: dict[str, dict[str, Correction]] = {}
    for path, edit in edits.items():
        keys = _keys(robot.mechanism, path)
        if document.find(keys) is not None:
            _rewrite(document, keys, edit, robot.quantities[path])
        elif (
            document.find(keys[:-1]) is None
            and not any(isinstance(key, int) for key in keys)  # the table of an entry cannot be at the end
            and not document.is_inline(keys[:1])
        ):
            appended.setdefault(path.rpartition(".")[0], {})[path] = edit
        else:
            document.insert(keys, _new_value(document, robot.mechanism, path, units[path], edit))
            document.comment(keys, edit.note)
    for table, group in appended.items():
        values = {
            path.rpartition(".")[2]: _new_value(document, robot.mechanism, path, units[path], edit)
            for path, edit in group.items()
        }
        notes = dict.fromkeys(edit.note for edit in group.values() if edit.note)
        document.append_table(table, values, "; ".join(notes))
    tables = robot.covariance if covariance is None else _correlate(document, robot, covariance, edits)
    text = document.text
    _check(text, robot, edits, tables)
    return text


def _correlate(
    document: TomlText, robot: Robot, new: Covariance, edits: Mapping[str, Correction]
) -> tuple[Covariance, ...]:
    """Write a table of correlations, and return all tables of the text."""
    tables = list(robot.covariance)
    overlapping = [i for i, table in enumerate(tables) if set(table.paths) & set(new.paths)]
    reduced_tables = [rest for i in overlapping if (rest := tables[i].without(new.paths)).paths]
    sigmas = {**sigmas_by_path(robot), **{path: edit.sigma for path, edit in edits.items() if edit.sigma}}
    merged = joined_covariance([new, *reduced_tables], sigmas)
    values = {
        PATHS: _toml_list(f'"{path}"' for path in merged.paths),
        **(
            {}
            if merged.sigmas is None
            else {SIGMA: _toml_list(f"{s:.{SIGMA_DIGITS}g}" for s in merged.sigmas)}
        ),
        CORRELATION: _toml_list(
            # Rounded, so that what is 0 except for the rounding of a fit is written as 0.
            (
                f"[{', '.join(f'{round(coefficient, DIGITS) + 0.0:.{DIGITS}g}' for coefficient in row)}]"
                for row in merged.correlation
            ),
            one_per_line=True,
        ),
    }
    if not overlapping:
        document.append_table(COVARIANCE, values, CORRELATIONS_COMMENT, repeated=True)
        return (*tables, merged)
    for i in reversed(overlapping[1:]):
        document.remove_entry(COVARIANCE, i)
        del tables[i]
    document.rewrite((COVARIANCE, overlapping[0]), values)
    tables[overlapping[0]] = merged
    return tuple(tables)


def _toml_list(texts: Iterable[str], *, one_per_line: bool = False) -> str:
    """Return a list as TOML, on one line, or with a line for each element."""
    return (
        "[\n" + "".join(f"    {text},\n" for text in texts) + "]" if one_per_line else f"[{', '.join(texts)}]"
    )


def _keys(mechanism: Mechanism, path: str) -> Keys:
    """Return the keys of the document for a dotted path: entries and elements by index."""
    item = items_by_path(mechanism).get(path)
    if item is None:  # an effect parameter
        return tuple(path.split("."))
    return next(number.key_path for number in item.numbers if number.path == path)


def _rewrite(document: TomlText, keys: Keys, edit: Correction, declared: Quantity) -> None:
    """Change an existing value, keeping its notation."""
    written = document.find(keys)
    if isinstance(written, dict):
        notation = ValueNotation.of(written["value"], declared.unit)
        relative = "%" in str(written.get("sigma", ""))
        has_new_sigma = edit.sigma is not None or (relative and declared.sigma is not None)
        value_notation = notation.beside_sigma if has_new_sigma else notation
        document.replace((*keys, "value"), value_notation.number(edit.value, edit.digits))
        if edit.sigma is not None and "sigma" not in written:
            document.insert((*keys, "sigma"), notation.sigma(edit.sigma))
        elif edit.sigma is not None:
            document.replace((*keys, "sigma"), notation.sigma(edit.sigma))
        elif (
            relative and declared.sigma is not None
        ):  # a fraction of the new value would be another deviation
            document.replace((*keys, "sigma"), notation.sigma(declared.sigma))
        document.comment((*keys, "value"), edit.note)
    else:
        document.replace(
            keys, ValueNotation.of(written, declared.unit).quantity(edit.value, edit.sigma, edit.digits)
        )
        document.comment(keys, edit.note)


def _new_value(document: TomlText, mechanism: Mechanism, path: str, unit: str, edit: Correction) -> str:
    """Format a value that is new in the file: in the notation of the shared value, or in SI units."""
    item = items_by_path(mechanism).get(path)
    shared = document.find(_keys(mechanism, item.shared)) if item is not None and item.shared else None
    shared = shared["value"] if isinstance(shared, dict) else shared
    notation = ValueNotation.si(unit) if shared is None else ValueNotation.of(shared, unit)
    return notation.quantity(edit.value, edit.sigma, edit.digits)


def _check(text: str, robot: Robot, edits: Mapping[str, Correction], tables: Sequence[Covariance]) -> None:
    """Read the text back and check that changed values are as intended and all others as before."""
    try:
        read_back = robot_from_document(tomllib.loads(text.removeprefix("\ufeff")), robot.source)
    except RobotFileError as error:
        _refuse(f"the corrected robot would be rejected: {error.what}", error.where, "use another value")
    except ValueError as error:
        _refuse(f"the corrected robot is not valid TOML: {error}", robot.source, BY_HAND_REMEDY)
    expected = {**robot.declared, **{path: edit.value for path, edit in edits.items()}}
    sigmas = {path: quantity.sigma for path, quantity in robot.quantities.items()}
    sigmas.update({path: edit.sigma for path, edit in edits.items() if edit.sigma is not None})
    changed = set(edits)
    for borrowed, table_path in table_sources(robot.mechanism).items():
        if table_path in edits and borrowed in expected:  # the effect takes the value from the table
            expected[borrowed], sigmas[borrowed] = expected[table_path], sigmas.get(table_path)
            changed.add(borrowed)
    # A new effect has all its parameters; those not given are at their defaults.
    added = tuple(path.rpartition(".")[0] + "." for path in edits if path.startswith(EFFECTS))
    declared = {
        path: value
        for path, value in read_back.declared.items()
        if path in expected or not path.startswith(added)
    }
    for path in {**expected, **declared}:
        value, intended = declared.get(path), expected.get(path)
        sigma = read_back.quantities[path].sigma if path in read_back.quantities else None
        is_same = _is_close(value, intended, VALUE_TOLERANCE) if path in changed else value == intended
        if not is_same or not _is_close(sigma, sigmas.get(path), SIGMA_TOLERANCE):
            problem = f"expected {intended} with sigma {sigmas.get(path)}, found {value} with {sigma}"
            _refuse(
                f"the corrected value does not read back: {problem}",
                f"{robot.source}: {path}",
                BY_HAND_REMEDY,
            )
    # Tables are the same to the digits written.
    is_same = [table.paths for table in read_back.covariance] == [table.paths for table in tables] and all(
        np.allclose(first.correlation, second.correlation, rtol=0.0, atol=VALUE_TOLERANCE)
        and (first.sigmas is None) == (second.sigmas is None)
        and np.allclose(first.sigmas or (), second.sigmas or (), rtol=10.0 ** (1 - SIGMA_DIGITS), atol=0.0)
        for first, second in zip(read_back.covariance, tables, strict=True)
    )
    if not is_same:
        problem = "the correlations do not read back"
        _refuse(problem, f"{robot.source}: {COVARIANCE}", BY_HAND_REMEDY)


def _is_close(value: object, expected: object, tolerance: float) -> bool:
    if isinstance(value, float) and isinstance(expected, float):
        return abs(value - expected) <= tolerance * abs(expected)
    return value == expected
