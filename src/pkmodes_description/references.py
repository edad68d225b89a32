"""References within a description: names that occur once, and parts that name other parts of it.

What a description says about generated code can only be checked with that code: see
`pkmodes.core.mechanism.code_check`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from string import Formatter

from pkmodes_description.structure import (
    CHOICES,
    UNITS,
    Description,
    Drawing,
    Key,
    Margin,
    Requirement,
    Table,
)

#: The vector that every robot file has besides its tables.
GRAVITY = ("gravity.x", "gravity.y", "gravity.z")
#: Number of points of the elements of a drawing, for shapes that need a certain number.
POINTS = {"wheel": 2, "block": 2, "ball": 1}


def problems(description: Description) -> Iterator[str]:
    """Yield what is wrong with a description whose parts have the right types."""
    d = description
    names = [q.name for q in d.coordinates]
    released = [q.name for effect in d.effects_in_order for q in effect.coordinates]
    pose = [component.name for component in d.pose]
    yield from _repeated("pose", pose)
    yield from _repeated("coordinates", [*names, *released])
    yield from _repeated("drives", [drive.name for drive in d.drives])
    yield from _unknown("independent", d.independent, names)
    yield from _unknown("directions", d.directions, pose)
    yield from _unknown("rotations", d.components[len(d.directions) :], pose)
    yield from _unknown("scales", [scale.coordinate for scale in d.scales], [*names, *released])
    yield from _unknown("the units of pose", [component.unit for component in d.pose], ("m", "rad"))
    yield from _repeated("independent", d.independent)
    yield from _repeated("directions", d.directions)
    yield from _repeated("rotations", d.rotations)
    if d.rotations and tuple(pose) != d.components:
        yield f"the pose is {', '.join(pose)}, expected {', '.join(d.components)}: directions, then rotations"
    if d.rigid_modes > len(names):
        yield f"there are {d.rigid_modes} rigid modes of {len(names)} coordinates"
    yield from _tables(d)
    yield from _groups(d)
    for margin in d.margins:
        yield from _margin(margin)
    yield from _effects(d)
    for requirement in d.requirements:
        yield from _requirement(requirement, list(_numbers(d)))
    yield from _drawing(d.drawing, [*names, *released])


def _repeated(what: str, names: Iterable[str]) -> Iterator[str]:
    names = list(names)
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            yield f'"{name}" occurs twice in {what}'


def _unknown(what: str, names: Iterable[str], known: Iterable[str]) -> Iterator[str]:
    known = list(known)
    for name in names:
        if name not in known:
            yield f'"{name}" in {what} is none of {", ".join(known)}'


def _tables(d: Description) -> Iterator[str]:
    yield from _repeated("tables", [table.name for table in d.tables])
    yield from _unknown(
        "shared_by", filter(None, (t.shared_by for t in d.tables)), (t.name for t in d.tables if t.count)
    )
    parameters = [f"{effect.name}.{p.name}" for effect in d.effects_in_order for p in effect.parameters]
    for table in d.tables:
        if table.count and table.shared_by:
            yield f"the table {table.name} is both repeated and shared"
        yield from _repeated(table.name, [key.name for key in table.keys])
        middles = filter(None, (key.middle_of for key in table.keys))
        yield from _unknown(f"middle_of in {table.name}", middles, _pairs(d))
        for key in table.keys:
            for problem in _key(key, parameters):
                yield f"{table.name}.{key.name}: {problem}"


def _pairs(d: Description) -> list[str]:
    """Return the paths of the pairs of single tables."""
    return [f"{t.name}.{key.name}" for t in d.tables if not t.count for key in t.keys if key.kind == "pair"]


def _key(key: Key, parameters: Iterable[str]) -> Iterator[str]:
    yield from _unknown("dimension", [key.dimension], UNITS)
    yield from _repeated("elements", key.elements)
    if bool(key.effect) == bool(key.field):
        yield "it has to belong either to a field or to an effect"
    if key.effect:
        yield from _unknown("effect", [key.effect], parameters)
    if key.effect and key.kind != "quantity":
        yield f"a {key.kind} cannot belong to an effect"
    if key.default is not None and key.kind not in ("quantity", "vector"):
        yield f"a {key.kind} cannot have a default"
    if bool(key.elements) != (key.kind in ("vector", "pair", "signs")):
        yield f"{len(key.elements)} elements of a {key.kind}"
    if key.kind == "pair" and len(key.elements) != 2:
        yield f"{len(key.elements)} elements of a pair"
    if bool(key.choices) != (key.kind in CHOICES and key.kind != "direction"):
        yield f"{len(key.choices)} choices of a {key.kind}"


def _groups(d: Description) -> Iterator[str]:
    yield from _repeated("wholes", [group.path for group in d.parameter_groups])
    keys = [key for table in d.tables for key in table.keys]
    for group in d.parameter_groups:
        of_group = [key for key in keys if key.field == group.field]
        kind = "pair" if group.kind == "span" else "vector"
        if not of_group or any(
            key.kind != kind or UNITS[key.dimension] != group.unit
            for key in of_group
            if key.dimension in UNITS
        ):
            yield f'{group.path}: there is no field "{group.field}" of {kind}s in {group.unit}'


def _margin(margin: Margin) -> Iterator[str]:
    words = (
        ["value"]
        if margin.rule == "at_most_limit"
        else [*map(str, range(len(margin.names))), "missing", "short"]
    )
    try:
        holes = [hole for _, hole, *_ in Formatter().parse(margin.sentence) if hole is not None]
        margin.sentence.format(*("" for _ in margin.names), **dict.fromkeys(words, ""))
    except (LookupError, ValueError):
        yield f'the sentence of the margin {margin.code} cannot be formatted: "{margin.sentence}"'
    else:
        yield from _unknown(f"the sentence of the margin {margin.code}", holes, words)


def _effects(d: Description) -> Iterator[str]:
    yield from _repeated("effects", [effect.name for effect in d.effects_in_order])
    for effect in d.effects_in_order:
        paths = [f"effects.{effect.name}.{parameter.name}" for parameter in effect.parameters]
        yield from _repeated(f"the parameters of {effect.name}", paths)
        yield from _unknown(
            f"the units of {effect.name}", (parameter.unit for parameter in effect.parameters), UNITS.values()
        )
        own, names = [q.name for q in effect.coordinates], [parameter.name for parameter in effect.parameters]
        for parameter in effect.parameters:
            yield from _unknown(f"what {effect.name}.{parameter.name} releases", parameter.releases, own)
            others = filter(None, [parameter.in_place_of])
            yield from _unknown(f"in_place_of of {effect.name}.{parameter.name}", others, names)
        for requirement in effect.requirements:
            yield from _unknown(f"the places of {requirement.function}", requirement.places, paths)
            yield from _requirement(requirement, paths)


def _requirement(requirement: Requirement, paths: Iterable[str]) -> Iterator[str]:
    paths = list(paths)
    for place in requirement.places:
        above = f"{place.rpartition('.')[0]}."
        words = ["value", "missing", *(path.removeprefix(above) for path in paths)]
        for hole in re.findall(r"\{([\w.]+)\}", requirement.sentence):
            if hole not in words:
                yield f'"{{{hole}}}" in the sentence of {requirement.function} is no value beside {place}'


def _numbers(d: Description) -> Iterator[str]:
    """Yield the paths of all quantities of the robot file."""
    yield from GRAVITY
    for table in d.tables:
        for name in [f"{table.name}.{j + 1}" for j in range(table.count)] or [table.name]:
            yield from _paths(name, table)
            for other in d.tables:
                if other.shared_by == table.name:
                    yield from _paths(f"{name}.{other.name}", other)


def _paths(name: str, table: Table) -> Iterator[str]:
    for key in table.keys:
        if key.kind == "quantity":
            yield f"{name}.{key.name}"
        elif key.kind not in CHOICES:
            yield from (f"{name}.{key.name}.{element}" for element in key.elements)


def _drawing(drawing: Drawing, coordinates: Iterable[str]) -> Iterator[str]:
    if not drawing.motions:
        yield "the drawing has no points"
    if set(drawing.motions) != set(range(len(set(drawing.motions)))):
        yield "the motions of the drawing are not numbered from 0"
    for element in drawing.elements:
        wanted = POINTS.get(element.shape, len(element.points))
        if len(element.points) != wanted or max(element.points) >= len(drawing.motions):
            yield f"{element.name} in the drawing: the points {list(element.points)} of a {element.shape}"
        if element.spring >= len(drawing.springs):
            yield f"{element.name} in the drawing: there is no spring {element.spring}"
        if element.turns:
            yield from _unknown(f"turns of {element.name}", [element.turns], coordinates)
