"""Lay out a model as C99: one source and one header, no allocation, no dependency but the C library's sqrt."""

from __future__ import annotations

from dataclasses import dataclass
from math import prod

from pkmodes_derive.emit import layout, printers
from pkmodes_derive.emit.numpy_code import glossary, operations, used_groups
from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templates import render
from pkmodes_derive.functions import FieldGroup, Function, Model


@dataclass(frozen=True)
class _Block:
    """One function as the templates see it: text only."""

    comment: list[str]
    prototype: list[str]
    body: list[str]


def source_and_header(model: Model, programs: dict[str, Program], provenance: Provenance) -> tuple[str, str]:
    """Return the texts of the C source and of its header."""
    groups = model.groups if provenance.parametric else ()
    values = {
        "provenance": provenance,
        "title": layout.prose(provenance.title, " * "),
        "guard": f"{provenance.name.upper()}_H",
        "name": provenance.name,
        "coordinates": [f" *   {name} [{unit}]" for name, unit in model.coordinates],
        "notes": [layout.prose(note, " * ") for note in model.notes],
        "constants": [
            line for text in provenance.constants for line in layout.prose(text, " *     ", first=" *   ")
        ],
        "names": [
            line
            for text in glossary(model, {f.name: programs[f.name] for f in model.functions if f.in_c})
            for line in layout.prose(text, " *     ", first=" *   ")
        ],
        "includes": [f"{model.mechanism}.h" for group in groups if not group.declared],
        "groups": [
            (
                _type(group, model),
                [
                    (f"double {f.name}{_extent(f.shape)};", f"[{f.unit}] {f.description}")
                    for f in group.fields
                ],
            )
            for group in groups
            if group.declared
        ],
        "functions": [
            _function(f, programs[f.name], model, groups, provenance.name) for f in model.functions if f.in_c
        ],
    }
    return render("source.c.j2", **values), render("header.h.j2", **values)


def _extent(shape: tuple[int, ...]) -> str:
    return "".join(f"[{n}]" for n in shape)


def _type(group: FieldGroup, model: Model) -> str:
    return f"{model.mechanism}_{group.argument}"


def _function(
    function: Function, program: Program, model: Model, groups: tuple[FieldGroup, ...], prefix: str
) -> _Block:
    used = used_groups(program, groups)
    arguments = [
        f"double {a.name}" if a.scalar else f"const double {a.name}[{len(a.symbols)}]"
        for a in function.arguments
    ]
    arguments += [f"const {_type(group, model)} *{group.argument}" for group in used]
    arguments += [
        f"double {o.name}{_extent(o.shape)}" if o.shape else f"double *{o.name}" for o in function.outputs
    ]
    head = f"void {prefix}_{function.name}("
    prototype = layout.prose(", ".join(arguments) + ")", "    ", first=head, room=len(";"))
    return _Block(_comment(function, program), prototype, _body(function, program, used))


def _comment(function: Function, program: Program) -> list[str]:
    lines = [f"/* {function.summary}", " *"]
    if function.details:
        lines += [*layout.prose(function.details, " * "), " *"]
    for argument in function.arguments:
        lines += layout.prose(
            f"{argument.name} [{argument.unit}]: {argument.description}", " *     ", " *   in  "
        )
    for output in function.outputs:
        lines += layout.prose(f"{output.name} [{output.unit}]: {output.description}", " *     ", " *   out ")
    lines += [" *", *layout.prose(f"Source: {function.source}.", " * "), f" * {operations(program)}"]
    return [*lines, " */"]


def _body(function: Function, program: Program, groups: list[FieldGroup]) -> list[str]:
    inputs, lines = set(program.inputs), []
    for argument in function.arguments:
        for i, symbol in enumerate(argument.symbols):
            if symbol in inputs and not (argument.scalar and symbol.name == argument.name):
                place = argument.name if argument.scalar else f"{argument.name}[{i}]"
                lines.append(f"    const double {symbol.name} = {place};")
        if not inputs & set(argument.symbols):
            lines.append(f"    (void){argument.name};")
    for group in groups:
        for field in group.fields:
            for i, symbol in enumerate(field.symbols):
                if symbol in inputs:
                    source = f"{group.argument}->{field.name}{_place(field.shape, i)}"
                    lines.append(f"    const double {symbol.name} = {source};")
    for symbol, expression in program.steps:
        lines += layout.assignment(
            f"const double {symbol.name}", printers.c_expression(expression), "    ", end=";"
        )
    for output, entries in program.results:
        for i, entry in enumerate(entries):
            target = f"{output.name}{_place(output.shape, i)}" if output.shape else f"*{output.name}"
            lines += layout.assignment(target, printers.c_expression(entry), "    ", end=";")
    return lines


def _place(shape: tuple[int, ...], index: int) -> str:
    """C index of entry `index` in row-major order."""
    text = ""
    for axis, extent in enumerate(shape):
        text += f"[{index // prod(shape[axis + 1 :]) % extent}]"
    return text
