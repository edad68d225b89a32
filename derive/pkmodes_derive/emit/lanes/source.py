"""Lay out what the compiled evaluator needs of a mechanism: one header in C with vector types.

A pose occupies one lane of a vector, so that the same statements evaluate several poses at once.  What depends on the
parameters alone is a double; the rest is a `lane`.  `pkmodes.compiled` has the linear algebra and the entry points.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sympy import Symbol

from pkmodes_derive.description import Description
from pkmodes_derive.emit import commentary, layout
from pkmodes_derive.emit.lanes import functions
from pkmodes_derive.emit.lanes.printer import expression
from pkmodes_derive.emit.program import Entry, Program, Result, arrange
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model

FILE_NAME = "lanes.h"
#: How a margin must compare, by its rule: what the C code knows it by.
RULES = {
    "at_least_zero": "LANES_AT_LEAST_ZERO",
    "above_zero": "LANES_ABOVE_ZERO",
    "at_most_limit": "LANES_AT_MOST_LIMIT",
}


@dataclass(frozen=True)
class _Block:
    """One function as the template sees it: text only."""

    comment: list[str]
    name: str
    outputs: str
    body: list[str]


def files(
    base: Model, extended: Model, description: Description, provenance: Provenance
) -> tuple[dict[str, str], dict[str, Program]]:
    """Return the text of the header by its file name, and the programs that it prints."""
    emitted = (
        functions.position(base, description),
        functions.base(base, description),
        functions.extended(extended),
    )
    programs = {f"lanes_{f.name}": arrange(f) for f in emitted}
    groups = [base.groups[0], *(group for group in extended.groups if group.declared)]
    margins = functions.margins_of(base, description)
    text = render(
        __package__,
        f"{FILE_NAME}.j2",
        provenance=provenance,
        title=layout.prose(provenance.title, " * "),
        indices=layout.prose(commentary.indices(extended.vocabulary, programs.values()), " * "),
        names=[
            line
            for entry in commentary.glossary(extended.vocabulary, programs.values())
            for line in layout.prose(entry, " *     ", first=" *   ")
        ],
        sizes=[
            ("POSE", len(description.pose)),
            ("INDEPENDENT", len(description.independent)),
            ("DIRECTIONS", len(description.directions)),
            ("BASE", len(base.coordinates)),
            ("ALL", len(extended.coordinates)),
            ("RIGID", description.rigid_modes),
            ("PARAMETERS", sum(len(f.symbols) for f in groups[0].fields)),
            ("EFFECTS", sum(len(f.symbols) for group in groups[1:] for f in group.fields)),
            ("MARGINS", sum(count for count, _ in margins)),
        ],
        rules=layout.listing((f"{{{count}, {RULES[rule]}}}" for count, rule in margins), "    "),
        functions=[_function(f, programs[f"lanes_{f.name}"], groups) for f in emitted],
    )
    return {FILE_NAME: text}, programs


def _function(function: Function, program: Program, groups: Sequence[FieldGroup]) -> _Block:
    comment = [
        f"/* {function.summary}",
        " *",
        *layout.prose(f"Source: {function.source}.", " * "),
        f" * {commentary.operations(program)}",
        " */",
    ]
    outputs = ", ".join(f"lane *restrict {output.name}" for output in function.outputs)
    return _Block(comment, function.name, outputs, _body(function, program, groups))


def _body(function: Function, program: Program, groups: Sequence[FieldGroup]) -> list[str]:
    inputs, lines = set(program.inputs), []
    moving: set[Symbol] = set()
    for argument in function.arguments:
        moving |= set(argument.symbols)
        for i, symbol in enumerate(argument.symbols):
            if symbol in inputs:
                lines.append(f"    const lane {symbol.name} = pose[{i}];")
    for group in groups:
        places = (symbol for field in group.fields for symbol in field.symbols)
        for i, symbol in enumerate(places):
            if symbol in inputs:
                lines.append(f"    const double {symbol.name} = {group.argument}[{i}];")
    for symbol, value in program.steps:
        kind = "lane" if value.free_symbols & moving else "double"
        if kind == "lane":
            moving.add(symbol)
        lines += layout.assignment(f"const {kind} {symbol.name}", expression(value), "    ", end=";")
    for result in program.results:
        lines += _result(result)
    return lines


def _result(result: Result) -> list[str]:
    lines = (
        [f"    lanes_clear({result.output.name}, {len(result.output.entries)});"] if result.has_zeros else []
    )
    for entry in result.entries:
        text = " = ".join(_places(result, entry))
        lines += layout.assignment(text, f"LANES({expression(entry.value)})", "    ", end=";")
    return lines


def _places(result: Result, entry: Entry) -> Iterable[str]:
    """Entries in row-major order."""
    for index in entry.places:
        place = 0
        for at, extent in zip(index, result.output.shape, strict=True):
            place = place * extent + at
        yield f"{result.output.name}[{place}]"
