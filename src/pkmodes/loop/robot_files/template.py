"""The commented robot file to begin with: every key that the reader accepts, its unit, and how to find it.

It follows from the description of the mechanism.  What is required has the value of an example.  Everything else
follows a ``#`` without a space, so that removing the ``#`` makes it part of the file.
"""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import deepcopy
from typing import Any

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.regular import sample_parameters
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import CORRELATION, COVARIANCE, PATHS, SIGMA
from pkmodes.core.robot.layout import EFFECTS, GRAVITY, QUANTITY_KINDS, Item, items, table_sources
from pkmodes.core.robot.report_fields import REPORT, TITLES
from pkmodes.core.robot.tables import FORMAT, STATE_OF_MOTORS, dimension_of_effect
from pkmodes.core.robot.units import DIMENSIONS, DISPLAY_UNITS, with_unit
from pkmodes.core.robot.usable import RADIUS, SINGULAR_ANGLE, USABLE, limit_examples
from pkmodes.core.robot.variants import document_of
from pkmodes.core.support.ordering import joined
from pkmodes.loop.robot_files.measuring import measuring_method
from pkmodes.loop.robot_files.supplied import robot_of
from pkmodes_description import Effect, Key, Table

WIDTH = 110
#: Notes on the notation, before the first key.
NOTATION = (
    "Replace the values of the example by your own, a table at a time.  The comment of a value says, after "
    "the brackets, how to find it.",
    "A line that begins with # and no space is optional: remove the # to use it.  The value there is the "
    "default, or an example where there is none.",
    'A quantity is text with any unit of its kind, such as "400 mm", or a number in the SI unit that its '
    "comment has in brackets.  With its standard deviation it is { value = ..., sigma = ... }; sigma is "
    "absolute, in per cent, or 0 for what is exact.  Each sigma below is a usual one: state your own.",
    "docs/how-to/writing-a-robot-file.md says in which order to proceed, docs/reference/robot-file.md "
    "defines every key.",
)
#: Texts of sections that no table of a mechanism describes.
OVERRIDES_TEXT = "Where this {} differs from the tables that all share:"
USABLE_TEXT = "where the machine is used; without limits, wherever it can go"
LIMIT_TEXTS = {
    RADIUS: "largest distance from the z axis",
    SINGULAR_ANGLE: "least angle of every rod to its singular direction",
}
REPORT_TEXT = "what the head of every report says; nothing is computed from it"
COVARIANCE_TEXT = "values of this file with correlated errors; without this table they are independent"
MOTORS_TEXT = (
    'Motors of the machine in use: "held" where position loops or stepper motors hold the shafts, "free" where '
    "they turn freely, as in the paper.  Every command takes this unless --drives, or a file of measurements, "
    "says otherwise."
)
SERVO_STIFFNESS = "servo_stiffness"
SERVO_TEXT = (
    f"  A motor that gives way is on a spring, [{EFFECTS}.{SERVO_STIFFNESS}] below, which takes "
    f'{STATE_OF_MOTORS}="{FREE}".'
)
EFFECTS_TEXT = (
    "Effects: physical causes beyond the model above; 0 is none.  They need not be known: pkmodes diagnose finds "
    "which of them measured modes show, and how large they are."
)


def template(mechanism: Mechanism, commands: Sequence[str] = ()) -> str:
    """Return the commented robot file of a mechanism.

    - commands: commands that show what the file describes, for its head
    """
    document = _with_usual_sigmas(mechanism, example_document(mechanism))
    lines = [*_comment_lines(f"A robot file of the mechanism {mechanism.name}: {mechanism.title}."), "#"]
    for paragraph in NOTATION:
        lines += [*_comment_lines(paragraph), "#"]
    if commands:
        lines += [
            *_comment_lines("The file works at every step:"),
            *(f"#   {command}" for command in commands),
        ]
    lines += ["", f"format = {FORMAT}", f"name = {_toml(document['name'])}"]
    lines += [f"mechanism = {_toml(mechanism.name)}"]
    if STATE_OF_MOTORS not in [table.name for table in mechanism.tables]:
        drives = document.get(STATE_OF_MOTORS)
        servo_text = SERVO_TEXT if SERVO_STIFFNESS in mechanism.effects else ""
        lines += ["", *_comment_lines(MOTORS_TEXT + servo_text)]
        lines += [f"{'' if drives else '#'}{STATE_OF_MOTORS} = {_toml(drives or FREE)}"]
    lines += ["", *_key_lines(GRAVITY, GRAVITY.name, document)]
    for table in mechanism.tables:
        lines += (
            _repeated_table_lines(mechanism, table, document)
            if table.count
            else _table_lines(table, document)
        )
    lines += _common_lines(mechanism, document)
    lines += ["", *_comment_lines(EFFECTS_TEXT)]
    for effect in mechanism.effects.values():
        lines += _effect_lines(mechanism, effect, document.get(EFFECTS, {}))
    return "\n".join(lines) + "\n"


def example_document(mechanism: Mechanism) -> dict[str, Any]:
    """Return a robot file, parsed: one that comes with pkmodes, or the sample that the checks of a mechanism use."""
    name = f"my-{mechanism.name.replace('_', '-')}"
    supplied = robot_of(mechanism.name)
    if supplied is not None:
        return {**supplied, "name": name}
    values: dict[str, Any] = {}
    parameters = sample_parameters(mechanism)
    for item in items(mechanism):
        if item.index is not None and item.key.field:
            raw = _sample_value(item, getattr(parameters, item.key.field))
            # Values that the entries of a repeated table share are those of the first entry.
            if values.setdefault(item.shared or item.path, raw) != raw:
                values[item.path] = raw
    return document_of(mechanism, name, values)


def _sample_value(item: Item, field: Any) -> Any:
    """Return the value of a sample as a robot file has it."""
    numbers = np.asarray(field, dtype=float)[item.index].tolist()
    if item.key.kind == "one_of":
        return item.key.choices[int(np.argmax(numbers))]
    if item.key.kind in ("choice", "signs"):
        return [int(number) for number in numbers] if isinstance(numbers, list) else int(numbers)
    if item.key.kind not in QUANTITY_KINDS:
        return numbers
    return (
        [_si(number, item.key) for number in numbers] if isinstance(numbers, list) else _si(numbers, item.key)
    )


def _si(value: float, key: Key) -> Any:
    """Return a number in SI units as a robot file has it."""
    unit, number = DIMENSIONS[key.dimension][0].replace(" ", "*"), int(value) if value.is_integer() else value
    return number if unit == "1" else f"{number!r} {unit}"


def _with_usual_sigmas(mechanism: Mechanism, document: Mapping[str, Any]) -> dict[str, Any]:
    """Return the document with a standard deviation of each quantity that usually has one and is not 0."""
    completed = deepcopy(dict(document))
    for item in items(mechanism):
        raw, key = _value_in(completed, item), item.key
        path = item.shared or ".".join(part for part in item.key_path if isinstance(part, str))
        sigma = measuring_method(path, key.dimension).sigma
        if raw is None or isinstance(raw, Mapping) or key.kind != "quantity" or not sigma:
            continue
        if schema.parse_quantity(raw, key.dimension).value:
            _value_in(completed, item, levels_up=1)[key.name] = {"value": raw, "sigma": sigma}
    return completed


def _value_in(document: Mapping[str, Any], item: Item, levels_up: int = 0) -> Any:
    """Return the value of a key in a parsed file, or the table that has it; None if there is none."""
    node: Any = document
    for part in item.key_path[: len(item.key_path) - levels_up]:
        node = node[part] if isinstance(part, int) else node.get(part)
        if node is None:
            return None
    return node


def _table_lines(table: Table, document: Mapping[str, Any]) -> Iterator[str]:
    section = document.get(table.name)
    yield ""
    scope = f"; of each [[{table.shared_by}]] without its own" if table.shared_by else ""
    yield f"{'' if section else '#'}[{table.name}]  # {table.description}{scope}"
    for key in table.keys:
        yield from _key_lines(key, f"{table.name}.{key.name}", section or {}, table.description)


def _repeated_table_lines(mechanism: Mechanism, table: Table, document: Mapping[str, Any]) -> Iterator[str]:
    """Yield the entries of a repeated table; the first explains the keys, and what else an entry may have."""
    for j, entry in enumerate(document[table.name]):
        yield ""
        yield f"[[{table.name}]]  # {table.description}; {j + 1} of {table.count}"
        for key in table.keys:
            lines = list(_key_lines(key, f"{table.name}.{key.name}", entry, table.description))
            yield from lines if j == 0 else lines[-1:]
        overriding = [candidate for candidate in mechanism.tables if candidate.shared_by == table.name]
        if overriding and j == 0:
            yield from _comment_lines(OVERRIDES_TEXT.format(table.name.replace("_", " ")))
        for shared_table in overriding:
            override, shared = entry.get(shared_table.name, {}), document.get(shared_table.name, {})
            if override or j == 0:
                yield f"{'' if override else '#'}[{table.name}.{shared_table.name}]"
                for key in shared_table.keys:
                    if override.get(key.name) is not None or j == 0:
                        yield _line(key, override.get(key.name), shared.get(key.name))


def _key_lines(key: Key, path: str, section: Mapping[str, Any], table_description: str = "") -> Iterator[str]:
    """Yield the comment of a key and its line; `table_description` is what the comment of its table says already."""
    description = key.name if key.description == table_description else key.description
    instruction = measuring_method(path, key.dimension).instruction
    description += f"; by default the middle of {key.middle_of}" if key.middle_of else ""
    comment = f"{description} [{_accepted_values(key)}]" + (f"; {instruction}" if instruction else "")
    yield from (
        _comment_lines(comment)
        if len(comment) <= WIDTH - 2
        else [
            *_comment_lines(f"{description} [{_accepted_values(key)}];"),
            *_comment_lines(instruction, "#   "),
        ]
    )
    yield _line(key, section.get(key.name))


def _accepted_values(key: Key) -> str:
    """Return the SI unit of a key and its bounds, or its choices."""
    if key.kind in ("choice", "one_of", "signs"):
        return f"{'each ' if key.kind == 'signs' else ''}{' or '.join(map(str, key.choices))}"
    if key.kind == "direction":
        return "a unit vector"
    unit = DIMENSIONS[key.dimension][0]
    shown, factor = DISPLAY_UNITS.get(unit, (unit, 1.0))
    bounds = {">": key.above, ">=": key.at_least, "<": key.below, "<=": key.at_most}
    parts = [
        f"{sign} {with_unit(bound * factor, shown)}" if bound else f"{sign} 0"
        for sign, bound in bounds.items()
        if bound is not None
    ]
    element_names = (
        ", ".join(key.elements) if all(map(str.isalpha, key.elements)) else f"{len(key.elements)} values"
    )
    names = "" if key.kind == "quantity" else f"{element_names}; "
    return ", ".join([names + ("a number" if unit == "1" else unit), *parts])


def _line(key: Key, raw: Any, default: Any = None) -> str:
    """Return the line of a key, commented out if its value is not given."""
    if raw is not None:
        return f"{key.name} = {_toml(raw)}"
    if default is None:
        # The inertia of a beam has the default 0, with which it cannot turn: no value that a file may give.
        default_value = None if key.middle_of or (key.effect and key.default == key.above) else key.default
        default = DIMENSIONS[key.dimension][1] if default_value is None else _si(default_value, key)
        default = [default] * len(key.elements) if key.kind == "vector" else default
    return f"#{key.name} = {_toml(default)}"


def _effect_lines(mechanism: Mechanism, effect: Effect, section: Mapping[str, Any]) -> Iterator[str]:
    """Yield the table of an effect, without a parameter that another table declares or that replaces another."""
    name, values = f"{EFFECTS}.{effect.name}", section.get(effect.name)
    present: Mapping[str, Any] = values or {}
    yield ""
    yield f"{'#' if values is None else ''}[{name}]  # {effect.sentence}"
    for parameter in effect.parameters:
        path, excluded = (
            f"{name}.{parameter.name}",
            [alternative.name for alternative in effect.excluded(parameter.name)],
        )
        replaced = parameter.in_place_of or not present.keys().isdisjoint(excluded)
        if replaced and parameter.name not in present:
            continue
        if path in table_sources(mechanism):
            yield from _comment_lines(
                f"{parameter.name} is that of [{table_sources(mechanism)[path].rpartition('.')[0]}]"
            )
            continue
        key = Key(
            parameter.name,
            "quantity",
            "",
            dimension_of_effect(parameter.unit),
            parameter.description + (f"; in its place, {joined(excluded)}" if excluded else ""),
            above=parameter.greater_than,
            below=parameter.less_than,
            default=0.0,
        )
        yield from _key_lines(key, path, present)


def _common_lines(mechanism: Mechanism, document: Mapping[str, Any]) -> Iterator[str]:
    """Yield the optional tables of every robot file, without one whose name the mechanism uses for its own."""
    descriptions = LIMIT_TEXTS | {component.name: component.description for component in mechanism.pose}
    limits = [f"{line}  # {descriptions[name]}" for name, line in limit_examples(mechanism).items()]
    sigmas: dict[str, Any] = {}
    for item in items(mechanism):
        raw = _value_in(document, item)
        if isinstance(raw, Mapping) and raw.get("sigma"):
            sigmas[item.path] = raw["sigma"]
    correlated_paths = list(sigmas)[:2]
    correlations = [
        f"{PATHS} = {_toml(correlated_paths)}",
        f"{CORRELATION} = {_toml(np.eye(len(correlated_paths), dtype=int).tolist())}",
        f"{SIGMA} = {_toml([sigmas[path] for path in correlated_paths])}  # by default those of the values",
    ]
    tables: dict[str, tuple[str, Iterable[str]]] = {
        f"[{USABLE}]": (USABLE_TEXT, limits),
        f"[{REPORT}]": (REPORT_TEXT, (f'{name} = "..."' for name in TITLES)),
        f"[[{COVARIANCE}]]": (COVARIANCE_TEXT, correlations),
    }
    for head, (description, lines) in tables.items():
        if head.strip("[]") not in [table.name for table in mechanism.tables]:
            yield from ("", f"#{head}  # {description}", *(f"#{line}" for line in lines))


def _comment_lines(text: str, indent: str = "# ") -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)


def _toml(raw: Any) -> str:
    """Return a value of a parsed file as TOML."""
    if isinstance(raw, Mapping):
        return f"{{ {', '.join(f'{key} = {_toml(value)}' for key, value in raw.items())} }}"
    if isinstance(raw, list | tuple):
        return f"[{', '.join(map(_toml, raw))}]"
    return json.dumps(raw, ensure_ascii=False)  # texts and numbers are the same in both
