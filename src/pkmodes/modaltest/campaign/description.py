"""The campaign file as it is written: its keys, the kinds of their values, and its quantities in SI units and Hz."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any, Literal, NoReturn

import msgspec
from msgspec import Struct, field

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.base.toml import MAX_KEY_PARTS, line_of_long_key
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import (
    NUMBER,
    QuantityError,
    check_plain_number,
    dimension_of,
    likely_unit,
    parse,
)
from pkmodes.loop.measured.cells import number_in
from pkmodes.loop.measured.csv_format import read_text

MAX_FILE_SIZE = 1_000_000
#: Messages of msgspec: an unknown or missing key, and the place of an error.
UNKNOWN_KEY = re.compile(r"Object contains unknown field `(.*)`")
MISSING_KEY = re.compile(r"Object missing required field `(.*)`")
VALUE_TYPES = re.compile(r"`([a-z]+(?: \| [a-z]+)*)`")
#: Its names of value types in plain words.
PLAIN_TYPES = {
    "str": "text",
    "int": "an integer",
    "float": "a number",
    "array": "a list",
    "object": "a table",
}
#: Values allowed for keys with few possible values.
CHOICES = {"format": "1", "drives": '"free" or "held"', "signs": '"file"'}
ERROR_PATH = re.compile(r"(.*) - at `\$(.*)`")
RawValue = str | int | float


class CampaignPart(Struct, frozen=True, forbid_unknown_fields=True):
    """A table of the file: another key than its attributes is an error."""


class Uncertain(CampaignPart, frozen=True):
    """A quantity with its standard deviation."""

    value: str | int | float
    sigma: str | int | float = 0


class SensorTable(CampaignPart, frozen=True):
    """``[[sensor]]``: one measured direction."""

    name: str
    channel: str | None = None
    direction: list[float] | None = None
    at: list[str | int | float] | None = None
    unit: str | None = None
    sensitivity: str | None = None
    setup: str | None = None


class ForceTable(CampaignPart, frozen=True):
    """``[[force]]``: where a reference of the files acts: a point of a roving hammer, or one that is `fixed`."""

    name: str
    channel: str | None = None
    direction: list[float] | None = None
    at: list[str | int | float] | None = None
    setup: str | None = None
    fixed: bool = False


class RecordTable(CampaignPart, frozen=True):
    """``[[record]]``: what was measured at one pose, in one load case."""

    pose: str
    kind: str
    files: list[str] | dict[str, list[str]]
    at: dict[str, str | int | float | Uncertain] = {}
    settings: dict[str, str | int | float] = field(name="set", default_factory=dict)
    averages: int | None = None
    exponential: str | None = None
    hits: int = 1
    band: list[str] | None = None
    drives: Literal["free", "held"] | None = None
    rate: str | None = None
    columns: dict[str, str] | list[str] = {}
    names: dict[str, str] = {}
    invert: bool = False
    conjugate: bool = False
    clock: str | dict[str, str | int | float | Uncertain] | None = None


class EditTable(CampaignPart, frozen=True):
    """``[[edit]]``: what the user decides about the modes of a record."""

    pose: str
    strike: list[str] = []
    add: list[str] = []


class CampaignTable(CampaignPart, frozen=True):
    """The whole file."""

    format: Literal[1]
    band: list[str]
    record: list[RecordTable]
    robot: str | None = None
    channels: list[str] | None = None
    repeatability: str = "0.2 %"
    tones: list[str] = []
    drives: Literal["free", "held"] | None = None
    signs: Literal["file"] | None = None
    sensor: list[SensorTable] = []
    force: list[ForceTable] = []
    edit: list[EditTable] = []
    report: dict[str, Any] = {}


#: Tables by the last part of their path in the file.
TABLES: dict[str, type[CampaignPart]] = {
    "sensor": SensorTable,
    "force": ForceTable,
    "record": RecordTable,
    "edit": EditTable,
    "": CampaignTable,
}


def read_description(path: Path) -> CampaignTable:
    """Read a campaign file.

    Raises MeasurementError if it cannot be read, is no TOML, or a key is unknown, missing or of another kind.
    """
    source = str(path)
    text = read_text(path, source, "the campaign", "give a campaign file in TOML", MAX_FILE_SIZE)
    if (line := line_of_long_key(text)) is not None:
        problem = f"expected a key of at most {MAX_KEY_PARTS} parts, found more"
        _refuse(problem, f"{source}: line {line}", "shorten the key")
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also integers with too many digits
        _refuse(f"not valid TOML: {error}", source, "fix the syntax at that place")
    return campaign_tables(document, source)


def campaign_tables(document: dict[str, Any], source: str) -> CampaignTable:
    """Return the tables of a parsed file; `source` names it in messages.

    Raises MeasurementError if a key is unknown, missing or of another kind: msgspec's error, reworded.
    """
    try:
        return msgspec.convert(document, CampaignTable)
    except msgspec.ValidationError as error:
        text = str(error)
    error_path = ERROR_PATH.fullmatch(text)
    problem, path = (error_path[1], error_path[2]) if error_path else (text, "")
    path = re.sub(r"\[(\d+)\]", lambda index: f".{int(index[1]) + 1}", path).lstrip(".")
    where = f"{source}: {path}" if path else source
    keys = re.sub(r"\.?\d+$", "", path)
    table = TABLES.get(keys.rpartition(".")[2])
    known_keys = [attribute.encode_name for attribute in msgspec.structs.fields(table)] if table else []
    if match := UNKNOWN_KEY.fullmatch(problem):
        _refuse(
            f"unknown key {shown(match[1])}",
            where,
            nearest_name(match[1], known_keys) if known_keys else "remove it",
        )
    if match := MISSING_KEY.fullmatch(problem):
        _refuse(
            f'expected the key "{match[1]}", found none',
            where,
            f"add it; known keys: {', '.join(known_keys)}",
        )
    key = path.rpartition(".")[2]
    if problem.startswith("Invalid enum value") and key in CHOICES:
        problem = f"expected {CHOICES[key]}, found {problem.removeprefix('Invalid enum value ')}"
    problem = VALUE_TYPES.sub(
        lambda types: " or ".join(
            dict.fromkeys(PLAIN_TYPES.get(name, name) for name in types[1].split(" | ") if name != "null")
        ),
        problem,
    )
    problem = problem.replace(", got ", ", found ").replace("`", '"').replace(" | ", " or ")
    remedy = "see docs/reference/campaign-file.md"
    raise MeasurementError(f"{problem[0].lower()}{problem[1:]}", where, remedy)


def _refuse(what: str, where: str, remedy: str) -> NoReturn:
    raise MeasurementError(what, where, remedy) from None


def parse_frequency(text: str, where: str, example: str = "50 Hz") -> float:
    """Return a frequency above 0 [Hz]; one in rad/s is converted.

    Raises MeasurementError if the text is not a frequency above 0 with its unit.
    """
    remedy = f'for example: "{example}"'
    match = NUMBER.fullmatch(text)
    try:
        check_plain_number(text, "a frequency")
        if match is None or not match[2]:
            raise QuantityError(f"expected a frequency with its unit, found {shown(text)}")
        value = number_in(match[1], frequency_factor(match[2]))
    except QuantityError as error:
        suggested_unit = likely_unit(match[2], "Hz") if match is not None and not error.remedy else None
        remedy = error.remedy or (
            remedy if suggested_unit is None or match is None else f'write "{match[1]} {suggested_unit}"'
        )
        raise MeasurementError(str(error), where, remedy) from None
    if value is None or value <= 0.0:
        raise MeasurementError(f"expected a frequency above 0, found {shown(text)}", where, remedy)
    return value


def parse_band(frequencies: list[str], where: str) -> tuple[float, float]:
    """Return a band [Hz].

    Raises MeasurementError if it is not two frequencies, the lower one first.
    """
    remedy = 'for example: band = ["10 Hz", "400 Hz"]'
    if len(frequencies) != 2:
        raise MeasurementError(f"expected two frequencies, found {len(frequencies)}", where, remedy)
    low, high = (parse_frequency(text, where) for text in frequencies)
    if low >= high:
        raise MeasurementError(
            f"expected the lower frequency first, found {low:g} Hz, {high:g} Hz", where, remedy
        )
    return low, high


def parse_fraction(text: str, where: str) -> float:
    """Return a ratio of at least 0 and below 1, such as ``"0.2 %"``.

    Raises MeasurementError if it is not one.
    """
    value = parse_quantity(text, "1", where)
    if not 0.0 <= value < 1.0:
        problem = f"expected a share of at least 0 and below 100 %, found {shown(text)}"
        raise MeasurementError(problem, where, 'for example: "0.2 %"')
    return value


def parse_quantity(raw_value: RawValue, unit: str, where: str) -> float:
    """Return a quantity in SI units; a bare number only where the unit is 1.

    Raises MeasurementError if it is not a quantity of this unit.
    """
    try:
        return parse(raw_value if isinstance(raw_value, str) else repr(raw_value), dimension_of(unit))
    except QuantityError as error:
        remedy = error.remedy or "write the number with its unit, as text"
        raise MeasurementError(str(error), where, remedy) from None


def parse_uncertain(raw_value: RawValue | Uncertain, unit: str, where: str) -> tuple[float, float]:
    """Return a quantity in SI units and its standard deviation, 0 where none is given.

    Raises MeasurementError if one of them is not a quantity of this unit, or the standard deviation is negative.
    """
    if not isinstance(raw_value, Uncertain):
        return parse_quantity(raw_value, unit, where), 0.0
    sigma = 0.0 if raw_value.sigma == 0 else parse_quantity(raw_value.sigma, unit, f"{where}.sigma")
    if sigma < 0.0:
        problem = f"expected a standard deviation of at least 0, found {shown(raw_value.sigma)}"
        raise MeasurementError(problem, f"{where}.sigma", "give its size")
    return parse_quantity(raw_value.value, unit, f"{where}.value"), sigma
