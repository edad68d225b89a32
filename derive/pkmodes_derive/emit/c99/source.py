"""Layout of a model as C99: one source and one header, without allocation, depending only on the C library."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from pkmodes_derive.emit import commentary, layout
from pkmodes_derive.emit.c99 import modes, shaper
from pkmodes_derive.emit.c99.printer import expression
from pkmodes_derive.emit.constants import pose
from pkmodes_derive.emit.program import Program, Result
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model, Output

#: Type of every number, double or float.
REAL = "pkmodes_real"
#: A space at which lines are not broken.
UNBROKEN = "\N{NO-BREAK SPACE}"


@dataclass(frozen=True)
class _Block:
    """One function for the templates, as text."""

    comment: list[str]
    prototype: list[str]
    body: list[str]


def files(model: Model, programs: Mapping[str, Program], provenance: Provenance) -> dict[str, str]:
    """Return the texts of source and header by file name, if the model has functions for controllers."""
    if not any(f.in_c for f in model.functions):
        return {}
    groups = model.groups if provenance.parametric else ()
    emitted = [f for f in model.functions if f.in_c]
    used = {f.name: programs[f.name] for f in emitted}
    values = {
        "provenance": provenance,
        "title": layout.prose(provenance.title, " * "),
        "guard": f"{provenance.name.upper()}_H",
        "name": provenance.name,
        "coordinates": [f" *   {name} [{unit}]" for name, unit in model.coordinates],
        "notes": [layout.prose(note, " * ") for note in model.notes],
        "constants": _items(provenance.constants),
        "indices": layout.prose(commentary.indices(model.vocabulary, used.values()), " * "),
        "names": _items(commentary.glossary(model.vocabulary, used.values())),
        "includes": [f"{model.mechanism}.h" for group in groups if not group.declared],
        "headers": ["math.h", *(["string.h"] if any(map(_needs_clearing, used.values())) else [])],
        "groups": [
            (
                _type(group, model),
                [
                    (f"{REAL} {f.name}{_brackets(f.shape)};", f"[{f.unit}] {f.description}")
                    for f in group.fields
                ],
            )
            for group in groups
            if group.declared
        ],
        "functions": [_function(f, used[f.name], model, groups, provenance.name) for f in emitted],
        "callable": [f.name for f in emitted],
        "definitions": [],
        "controller": "",
        "held": None,
    }
    if model.conditions:
        values["controller"] = modes.source(model, provenance.name, groups)
        values["example"] = modes.example(model, provenance.name, groups)
        values["arguments"] = modes.arguments(model, groups)
        values["callable"] = [*(f.name for f in emitted), *modes.functions(model)]
        if model.held is not None:
            values["held"] = model.held
            values["shaper"] = shaper.declarations(provenance.name, len(pose(model).symbols))
        values["n"] = len(model.coordinates)
        values["headers"] = ["math.h", "stddef.h", "string.h"]
    source = render(__package__, "source.c.j2", **values)
    if model.conditions:
        values["definitions"] = modes.definitions(model, provenance.of_source(source))
    return {
        f"{provenance.name}.c": source,
        f"{provenance.name}.h": render(__package__, "header.h.j2", **values),
    }


def _items(texts: Iterable[str]) -> list[str]:
    return [line for text in texts for line in layout.prose(text, " *     ", first=" *   ")]


def _brackets(numbers: Iterable[int]) -> str:
    """Return the brackets of an extent or an index."""
    return "".join(f"[{n}]" for n in numbers)


def _type(group: FieldGroup, model: Model) -> str:
    return f"{model.mechanism}_{group.argument}"


def _needs_clearing(program: Program) -> bool:
    return any(result.output.shape and result.has_zeros for result in program.results)


def _function(
    function: Function, program: Program, model: Model, groups: Sequence[FieldGroup], prefix: str
) -> _Block:
    used = program.groups(function, groups)
    arguments = [
        f"{REAL} {a.name}" if a.scalar else f"const {REAL} {a.name}[{len(a.symbols)}]"
        for a in function.arguments
    ]
    arguments += [f"const {_type(group, model)} *{group.argument}" for group in used]
    arguments += [
        f"{REAL} {o.name}{_brackets(o.shape)}" if o.shape else f"{REAL} *{o.name}" for o in function.outputs
    ]
    head = f"void {prefix}_{function.name}("
    # Break lines between arguments, not within one.
    text = ", ".join(argument.replace(" ", UNBROKEN) for argument in arguments) + ")"
    lines = layout.prose(text, "    ", first=head, room=len(";"))
    prototype = [line.replace(UNBROKEN, " ") for line in lines]
    advice = modes.call_status_first(function, model, prefix)
    return _Block(_comment(function, program, advice), prototype, _body(function, program, used))


def _comment(function: Function, program: Program, advice: str) -> list[str]:
    lines = [f"/* {function.summary}", " *"]
    for paragraph in filter(None, (function.details, advice)):
        lines += [*layout.prose(paragraph, " * "), " *"]
    for argument in function.arguments:
        lines += layout.prose(
            f"{argument.name} [{argument.unit}]: {argument.description}", " *     ", " *   in  "
        )
    for output in function.outputs:
        lines += layout.prose(f"{output.name} [{output.unit}]: {output.description}", " *     ", " *   out ")
    lines += [" *", *layout.prose(f"Source: {function.source}.", " * ")]
    return [*lines, f" * {commentary.operations(program)}", " */"]


def _body(function: Function, program: Program, groups: Sequence[FieldGroup]) -> list[str]:
    inputs, lines = set(program.inputs), []
    for argument in function.arguments:
        for i, symbol in enumerate(argument.symbols):
            if symbol in inputs and not (argument.scalar and symbol.name == argument.name):
                place = argument.name if argument.scalar else f"{argument.name}[{i}]"
                lines.append(f"    const {REAL} {symbol.name} = {place};")
        if not inputs & set(argument.symbols):
            lines.append(f"    (void){argument.name};")
    for group in groups:
        if not any(inputs & set(field.symbols) for field in group.fields):
            lines.append(f"    (void){group.argument};")
        for field in group.fields:
            for index, symbol in zip(field.indices, field.symbols, strict=True):
                if symbol in inputs:
                    source = f"{group.argument}->{field.name}{_brackets(index)}"
                    lines.append(f"    const {REAL} {symbol.name} = {source};")
    for symbol, value in program.steps:
        lines += layout.assignment(f"const {REAL} {symbol.name}", expression(value), "    ", end=";")
    for result in program.results:
        lines += _result(result)
    return lines


def _result(result: Result) -> list[str]:
    """Return the lines that write one result: all zeros first, then the entries with a value."""
    output, lines = result.output, []
    if result.has_zeros:
        lines.append(f"    {_zeros(output)};")
    for entry in result.entries:
        places = (
            f"{output.name}{_brackets(index)}" if index else f"*{output.name}" for index in entry.places
        )
        lines += layout.assignment(" = ".join(places), expression(entry.value), "    ", end=";")
    return lines


def _zeros(output: Output) -> str:
    # The size of the type: sizeof the argument would be that of a pointer.
    if output.shape:
        return f"memset({output.name}, 0, sizeof({REAL}{_brackets(output.shape)}))"
    return f"*{output.name} = 0"
