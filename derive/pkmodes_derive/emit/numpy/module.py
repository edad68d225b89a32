"""Layout of a model as a NumPy module, batch first."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pprint import pformat

from sympy import Symbol

from pkmodes_derive.emit import commentary, layout
from pkmodes_derive.emit.numpy import modes
from pkmodes_derive.emit.numpy.printer import ARCTAN2, expression
from pkmodes_derive.emit.program import Program, Result
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model
from pkmodes_derive.vocabulary import Field


@dataclass(frozen=True)
class _Block:
    """One function for the template, as text."""

    name: str
    signature: str
    docstring: list[str]
    body: list[str]


def files(model: Model, programs: Mapping[str, Program], provenance: Provenance) -> dict[str, str]:
    """Return the text of the module by its file name."""
    groups = model.groups if provenance.parametric else ()
    functions = [_function(f, programs[f.name], groups) for f in model.functions]
    has_solver = bool(model.conditions) and not provenance.parametric
    own_constants = modes.own_constants(model, provenance) if has_solver else []
    text = render(
        __package__,
        "module.py.j2",
        provenance=provenance,
        title=layout.prose(provenance.title, ""),
        notes=[layout.prose(note, "") for note in model.notes],
        constants=[line for text in provenance.constants for line in layout.prose(text, "    ", first="* ")],
        indices=layout.prose(commentary.indices(model.vocabulary, programs.values()), ""),
        names=[
            line
            for text in commentary.glossary(model.vocabulary, programs.values())
            for line in layout.prose(text, "    ", first="* ")
        ],
        coordinates=[name for name, _ in model.coordinates],
        coordinate_units=[unit for _, unit in model.coordinates],
        rigid_modes=model.rigid_modes,
        exported=_exported(
            model, groups, [constant.name for constant in own_constants] if has_solver else None
        ),
        own=own_constants,
        controller=modes.source(model) if has_solver else "",
        literals=[
            (layout.prose(comment, "#: "), name, _literal(value)) for comment, name, value in model.constants
        ],
        groups=[_group(group) for group in groups if group.declared],
        listed=any(output.listed for f in model.functions for output in f.outputs),
        arctan2=any(ARCTAN2 in line for function in functions for line in function.body),
        functions=functions,
    )
    return {f"{provenance.module}.py": text}


def _exported(model: Model, groups: Sequence[FieldGroup], own: Sequence[str] | None) -> list[str]:
    """Return the public names; `own` are further constants of a module that solves the eigenproblem, else None."""
    further = modes.FUNCTIONS if own is not None else ()
    return [
        *(own or ()),
        *(("POSE", "STATUSES") if own is not None else ()),
        "COORDINATES",
        "COORDINATE_UNITS",
        *(group.name for group in groups if group.declared),
        *(name for _, name, _ in model.constants),
        *([] if model.rigid_modes is None else ["RIGID_MODES"]),
        *sorted([*(f.name for f in model.functions), *further]),
    ]


def _literal(items: tuple[object, ...]) -> str:
    """Return a tuple as Python source, one item after the other."""
    width = layout.WIDTH - 10
    lines = [textwrap.indent(pformat(item, width=width, compact=True), "    ") + "," for item in items]
    return "\n".join(["(", *lines, ")"])


def _group(group: FieldGroup) -> tuple[str, str, list[tuple[str, str, list[str]]]]:
    """Return the name of the type, the default value, and the fields as name, type and text."""
    fields = [(f.name, "np.ndarray" if f.shape else "float", _field_text(f)) for f in group.fields]
    return group.name, "" if group.null is None else f" = {group.null}", fields


def _field_text(field: Field) -> list[str]:
    shape = ", ".join(map(str, field.shape))
    kind = f"array, shape (..., {shape})" if field.shape else "float or array, shape (...)"
    return [
        f"    {field.name} : {kind} [{field.unit}]",
        *layout.prose(_sentence(field.description), " " * 8),
    ]


def _function(function: Function, program: Program, groups: Sequence[FieldGroup]) -> _Block:
    used = program.groups(function, groups)
    names = [argument.name for argument in function.arguments] + [group.argument for group in used]
    return _Block(
        function.name,
        ", ".join(names),
        _docstring(function, program, used),
        _body(function, program, used),
    )


def _docstring(function: Function, program: Program, groups: Sequence[FieldGroup]) -> list[str]:
    lines = [f'    """{function.summary}', ""]
    if function.details:
        lines += [*layout.prose(function.details, "    "), ""]
    lines += ["    Parameters", "    ----------"]
    for argument in function.arguments:
        shape = "array, shape (...)" if argument.scalar else f"array, shape (..., {len(argument.symbols)})"
        lines += [f"    {argument.name} : {shape} [{argument.unit}]"]
        lines += layout.prose(_sentence(argument.description), " " * 8)
    for group in groups:
        lines += [f"    {group.argument} : {group.name}", f"        The robot's {group.argument}."]
    lines += ["", "    Returns", "    -------"]
    for output in function.outputs:
        shape = ", ".join(["...", *map(str, output.shape)])
        lines += [f"    {output.name} : array, shape ({shape}) [{output.unit}]"]
        lines += layout.prose(_sentence(output.description), " " * 8)
    lines += ["", "    Notes", "    -----"]
    lines += layout.prose(_sentence(function.source), "    ")
    return [*lines, f"    {commentary.operations(program)}", '    """']


def _body(function: Function, program: Program, groups: Sequence[FieldGroup]) -> list[str]:
    inputs, lines = set(program.inputs), []
    representatives: list[str] = []
    for argument in function.arguments:
        if argument.scalar:
            source = f"_entries({argument.name}, ())"
        else:
            source = f"_entries({argument.name}, ({len(argument.symbols)},))"
        lines += _unpack(argument.symbols, inputs, source, representatives)
    for group in groups:
        for field in group.fields:
            if inputs & set(field.symbols):
                shape = ", ".join(map(str, field.shape)) + ("," if len(field.shape) == 1 else "")
                source = f"_entries({group.argument}.{field.name}, ({shape}))"
                lines += _unpack(field.symbols, inputs, source, representatives)
    lines += layout.prose(f"{', '.join(representatives)})", " " * 8, first="    batch, dtype = _batch(")
    for symbol, value in program.steps:
        lines += layout.assignment(symbol.name, expression(value), "    ", parentheses=True)
    for result in program.results:
        lines += _result(result)
    names = [_local(o.name) if o.shape else f"{_local(o.name)}[()]" for o in function.outputs]
    lines.append(f"    return {', '.join(names)}")
    return lines


def _result(result: Result) -> list[str]:
    """Return the lines that fill the array of one result."""
    output, name = result.output, _local(result.output.name)
    if output.listed:
        entries = layout.listing((expression(entry.value) for entry in result.entries), " " * 8)
        return [f"    {name} = _listed(batch, dtype, (", *entries, "    ))"]
    shape = f"({', '.join(['*batch', *map(str, output.shape)])})" if output.shape else "batch"
    lines = [f"    {name} = np.{'zeros' if result.has_zeros else 'empty'}({shape}, dtype)"]
    for entry in result.entries:
        places = (", ".join(["...", *map(str, index)]) for index in entry.places)
        target = " = ".join(f"{name}[{place}]" for place in places)
        lines += layout.assignment(target, expression(entry.value), "    ", parentheses=True)
    return lines


def _unpack(
    symbols: tuple[Symbol, ...], inputs: set[Symbol], source: str, representatives: list[str]
) -> list[str]:
    """Return the lines that unpack an array; unused entries go to ``_``, but the first gives the batch shape."""
    names = [s.name if s in inputs or i == 0 else "_" for i, s in enumerate(symbols)]
    representatives.append(names[0])
    left = ", ".join(names) if len(names) > 1 else f"({names[0]},)"
    line = f"    {left} = {source}"
    if len(line) <= layout.WIDTH:
        return [line]
    return ["    (", *layout.prose(f"{left},", " " * 8), f"    ) = {source}"]


def _local(name: str) -> str:
    """Return the name of the result array, which no scalar has."""
    return f"{name}_out"


def _sentence(text: str) -> str:
    word = text.split(" ")[0].rstrip(",:;")
    if len(word) > 1 and word.isalpha() and word.islower():  # a symbol keeps its case
        text = text[0].upper() + text[1:]
    return text if text.endswith(".") else f"{text}."
