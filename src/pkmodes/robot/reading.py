"""Read a robot file: TOML, schema, merged tables, or every problem in it, each with its place."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from pkmodes.errors import PkmodesError, RobotFileError, shown
from pkmodes.robot import schema
from pkmodes.robot.effects import read_effects
from pkmodes.robot.robot import Robot
from pkmodes.robot.units import DIMENSIONS, Quantity, article
from pkmodes_generated.linear_delta import Parameters

LARGEST_FILE = 1_000_000
FORMAT_HELP = "see docs/robot-file.md for the format"

#: Tables that the axes share and may override, with their keys and an example of each.
SHARED: dict[str, dict[str, str]] = {
    "link": {"length": "length", "mass": "mass"},
    "carriage": {"mass": "mass", "length": "length"},
    "belt": {"specific_stiffness": "specific stiffness", "width": "length"},
    "pulley": {"radius": "length", "inertia": "moment of inertia"},
    "motor": {"inertia": "moment of inertia", "gear_ratio": "number"},
}
COMPONENTS = ("x", "y", "z")
#: The frame's mass, which `frame_compliance` takes from [frame], and its default.
FRAME_MASS = "frame_compliance.mass"
DEFAULT_FRAME_MASS = Quantity(50.0, "kg")


def read_robot(path: str | PathLike[str]) -> Robot:
    """Read and validate a robot file.

    Parameters
    ----------
    path : path-like
        A TOML file, format 1.

    Returns
    -------
    Robot
        All values in SI units.

    Raises
    ------
    RobotFileError
        If the file cannot be read or anything in it is wrong: one problem for each thing to mend, with the
        dotted path, what was expected and what was found.
    """
    name = fspath(path) if isinstance(path, str | PathLike) else None
    if not isinstance(name, str):
        _refuse(
            f"expected the path of a robot file, found {shown(path)}", "robot file", "give its path as text"
        )
    return robot_from_document(_document(Path(path), name), name)


def robot_from_document(document: Mapping[str, Any], source: str) -> Robot:
    """Validate a robot file that has been parsed already; `source` names it in messages."""
    try:
        content = schema.RobotFile.model_validate(document)
    except ValidationError as error:
        details = error.errors(include_url=False)
        raise RobotFileError([_problem(entry, source) for entry in details if not _echo(entry)]) from None
    problems: list[PkmodesError] = []
    effects = _effects(content, source, problems)
    axes = [_merged(content, j, source, problems) for j in range(3)]
    if not problems:
        problems = _short_travels(content, axes, source)
    if problems:
        raise RobotFileError(problems)
    return Robot(
        name=content.name,
        mechanism=content.mechanism,
        source=source,
        parameters=_parameters(content, axes),
        quantities={**_quantities(content), **{f"effects.{path}": q for path, q in effects.items()}},
        effects={path: quantity.value for path, quantity in effects.items()},
        constants={FRAME_MASS: (effects.get(FRAME_MASS) or content.frame.mass or DEFAULT_FRAME_MASS).value},
    )


def _document(path: Path, name: str) -> dict[str, Any]:
    try:
        if path.exists() and not path.is_file():
            kind = "a folder" if path.is_dir() else "not a regular file"
            _refuse(f"cannot read the robot file: it is {kind}", name, "give a robot file in TOML")
        if path.stat().st_size > LARGEST_FILE:
            _refuse("cannot read the robot file: it has more than 1 MB", name, "give a robot file in TOML")
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        _refuse(f"expected UTF-8 text, found byte {error.start} that is not", name, "save the file as UTF-8")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = getattr(error, "strerror", None) or str(error)
        _refuse(f"cannot read the robot file: {reason.lower()}", name, "check the path")
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also integers of too many digits, tables too deep
        _refuse(f"not valid TOML: {error}", name, "mend the syntax at that place")


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise RobotFileError([PkmodesError(what, where, remedy)]) from None


def _merged(
    content: schema.RobotFile, j: int, source: str, problems: list[PkmodesError]
) -> dict[tuple[str, str], Quantity]:
    """Values of the shared tables for axis `j`, its own first."""
    merged = {}
    for table, keys in SHARED.items():
        for key, dimension in keys.items():
            own = getattr(getattr(content.axis[j], table), key)
            shared = getattr(getattr(content, table), key)
            value = own if own is not None else shared
            if value is not None:
                merged[table, key] = value
            elif all(problem.where != f"{source}: {table}.{key}" for problem in problems):
                problems.append(_missing(f"{table}.{key}", dimension, source))
    return merged


def _missing(path: str, dimension: str, source: str) -> PkmodesError:
    return PkmodesError(
        f'expected {article(dimension)} such as "{DIMENSIONS[dimension][1]}", found nothing',
        f"{source}: {path}",
        f"add the key {path.rsplit('.', 1)[-1]}; {FORMAT_HELP}",
    )


def _effects(content: schema.RobotFile, source: str, problems: list[PkmodesError]) -> dict[str, Quantity]:
    """The effects; the frame's mass is declared with the frame, or with the effect, but not twice."""
    declared = content.frame.mass
    table = content.effects.get("frame_compliance")
    if declared is not None and isinstance(table, dict) and "mass" in table:
        problems.append(
            PkmodesError(
                "the mass of the frame is declared twice",
                f"{source}: effects.{FRAME_MASS}",
                "keep it in [frame] and remove it here",
            )
        )
    return read_effects(content.effects, {FRAME_MASS: declared or DEFAULT_FRAME_MASS}, source, problems)


def _short_travels(
    content: schema.RobotFile, axes: list[dict[tuple[str, str], Quantity]], source: str
) -> list[PkmodesError]:
    """A carriage as long as its travel leaves no room for a belt span at any pose."""
    problems = []
    for j, (axis, merged) in enumerate(zip(content.axis, axes, strict=True), start=1):
        low, high = axis.limits
        length, travel = merged["carriage", "length"].value, high.value - low.value
        if length >= travel:
            problems.append(
                PkmodesError(
                    f"expected a carriage shorter than the travel of {travel:g} m, found a length of {length:g} m",
                    f"{source}: axis.{j}.limits",
                    "check the limits and carriage.length",
                )
            )
    return problems


def _parameters(content: schema.RobotFile, axes: list[dict[tuple[str, str], Quantity]]) -> Parameters:
    def shared(table: str, key: str) -> np.ndarray:
        return _frozen([axis[table, key].value for axis in axes])

    def vectors(rows: list[tuple[Quantity, ...]]) -> np.ndarray:
        return _frozen([[element.value for element in row] for row in rows])

    return Parameters(
        platform_mass=content.platform.mass.value,
        gravity=_frozen([element.value for element in content.gravity]),
        origin=vectors([axis.origin for axis in content.axis]),
        direction=_frozen([axis.direction for axis in content.axis]),
        joint=vectors([axis.joint for axis in content.axis]),
        link_length=shared("link", "length"),
        link_mass=shared("link", "mass"),
        carriage_mass=shared("carriage", "mass"),
        carriage_length=shared("carriage", "length"),
        belt_specific_stiffness=shared("belt", "specific_stiffness"),
        belt_width=shared("belt", "width"),
        pulley_radius=shared("pulley", "radius"),
        pulley_inertia=shared("pulley", "inertia"),
        motor_inertia=shared("motor", "inertia"),
        gear_ratio=shared("motor", "gear_ratio"),
        drive=_frozen([[float(axis.driven_pulley == k) for k in (1, 2)] for axis in content.axis]),
        limits=vectors([axis.limits for axis in content.axis]),
        branch=_frozen([float(axis.branch) for axis in content.axis]),
    )


def _frozen(values: Any) -> np.ndarray:
    array = np.array(values, dtype=float)
    array.flags.writeable = False
    return array


def _quantities(content: schema.RobotFile) -> dict[str, Quantity]:
    """Every declared value by its dotted path, in the order of the file's format."""
    found: dict[str, Quantity] = {}

    def add(prefix: str, table: BaseModel) -> None:
        for key in type(table).model_fields:
            value = getattr(table, key)
            if isinstance(value, Quantity):
                found[f"{prefix}{key}"] = value
            elif isinstance(value, BaseModel):
                add(f"{prefix}{key}.", value)
            elif key != "axis" and isinstance(value, tuple) and isinstance(value[0], Quantity):
                names = COMPONENTS if len(value) == 3 else ("min", "max")
                found.update({f"{prefix}{key}.{n}": v for n, v in zip(names, value, strict=True)})

    add("", content)
    for j, axis in enumerate(content.axis, start=1):
        add(f"axis.{j}.", axis)
    return found


def _echo(details: ErrorDetails) -> bool:
    """Whether this only repeats that some of the three axes, which were counted without it, are wrong."""
    count = details.get("input")
    return (
        details["loc"] == ("axis",)
        and details["type"] == "too_short"
        and isinstance(count, list)
        and len(count) == 3
    )


def _problem(details: ErrorDetails, source: str) -> PkmodesError:
    """Translate one of pydantic's errors: expected, found, remedy."""
    location = details["loc"]
    path = ".".join(str(part + 1) if isinstance(part, int) else _key(part) for part in location)
    where = f"{source}: {path}" if path else source
    kind, found = details["type"], details.get("input")
    if kind == "refused":
        context = details["ctx"]
        place = f"{where}.{context['element']}" if context["element"] else where
        return PkmodesError(str(details["msg"]), place, context["remedy"])
    if kind == "extra_forbidden":
        return _unknown_key(location, where)
    if kind == "missing":
        return PkmodesError(f"the key {path} is missing", where, f"add it; {FORMAT_HELP}")
    if location == ("axis",):
        count = len(found) if isinstance(found, list | tuple) else shown(found)
        return PkmodesError(
            f"expected exactly three [[axis]] tables, found {count}",
            where,
            "describe each of the three axes once",
        )
    if kind in ("model_type", "model_attributes_type", "dict_type"):
        return PkmodesError(f"expected a table, found {shown(found)}", where, FORMAT_HELP)
    message = str(details["msg"])
    return PkmodesError(f"{message[0].lower()}{message[1:]}, found {shown(found)}", where, FORMAT_HELP)


def _unknown_key(location: tuple[int | str, ...], where: str) -> PkmodesError:
    key = str(location[-1])
    known = _known_keys(location[:-1])
    nearest = difflib.get_close_matches(key, known, n=1, cutoff=0.5)
    remedy = f'did you mean "{nearest[0]}"?' if nearest else f"known keys here: {', '.join(known)}"
    return PkmodesError(f"unknown key {shown(key)}", where, remedy)


def _key(part: str) -> str:
    """A key as part of a path: bare when it can be written so in TOML."""
    return part if re.fullmatch(r"[A-Za-z0-9_-]{1,60}", part) else shown(part)


def _known_keys(location: tuple[int | str, ...]) -> list[str]:
    table: type[BaseModel] = schema.RobotFile
    for part in location:
        if part == "axis":
            table = schema.Axis
        elif isinstance(part, str):
            annotation = table.model_fields[part].annotation
            if isinstance(annotation, type) and issubclass(annotation, BaseModel):
                table = annotation
    return list(table.model_fields)
