"""Lay out a model as a NumPy module, batch first."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass
from pprint import pformat

from sympy import Symbol

from pkmodes_derive.emit import layout, printers
from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templates import render
from pkmodes_derive.functions import FieldGroup, Function, Model
from pkmodes_derive.vocabulary import Field


@dataclass(frozen=True)
class _Block:
    """One function as the template sees it: text only."""

    name: str
    signature: str
    docstring: list[str]
    body: list[str]


def module(model: Model, programs: dict[str, Program], provenance: Provenance) -> str:
    """Return the text of the module; `programs` holds one program for each function, by name."""
    groups = model.groups if provenance.parametric else ()
    return render(
        "module.py.j2",
        provenance=provenance,
        title=layout.prose(provenance.title, ""),
        notes=[layout.prose(note, "") for note in model.notes],
        constants=[line for text in provenance.constants for line in layout.prose(text, "    ", first="* ")],
        names=[line for text in glossary(model, programs) for line in layout.prose(text, "    ", first="* ")],
        coordinates=[name for name, _ in model.coordinates],
        coordinate_units=[unit for _, unit in model.coordinates],
        rigid_modes=model.rigid_modes,
        exported=[
            "COORDINATES",
            "COORDINATE_UNITS",
            *(group.name for group in groups if group.declared),
            *(name for _, name, _ in model.constants),
            *([] if model.rigid_modes is None else ["RIGID_MODES"]),
            *sorted(f.name for f in model.functions),
        ],
        literals=[
            (layout.prose(comment, "#: "), name, _literal(value)) for comment, name, value in model.constants
        ],
        groups=[
            (
                group.name,
                "" if group.null is None else f" = {group.null}",
                [
                    (field.name, "np.ndarray" if field.shape else "float", _field_text(field))
                    for field in group.fields
                ],
            )
            for group in groups
            if group.declared
        ],
        listed=any(output.listed for f in model.functions for output in f.outputs),
        functions=[_function(f, programs[f.name], groups) for f in model.functions],
    )


def glossary(model: Model, programs: dict[str, Program]) -> list[str]:
    """What the named values in the code are: one entry for all members of a family."""
    used = {symbol for program in programs.values() for symbol, _ in program.steps}
    families = {q.family: q.unit for q in model.vocabulary if q.symbol in used}
    return [f"{name} [{unit}]: {description}" for (name, description), unit in families.items()]


def _literal(items: tuple[object, ...]) -> str:
    """A tuple as Python source, one item after the other."""
    width = layout.WIDTH - 10
    lines = [textwrap.indent(pformat(item, width=width, compact=True), "    ") + "," for item in items]
    return "\n".join(["(", *lines, ")"])


def _field_text(field: Field) -> list[str]:
    shape = ", ".join(map(str, field.shape))
    kind = f"array, shape (..., {shape})" if field.shape else "float or array, shape (...)"
    return [
        f"    {field.name} : {kind} [{field.unit}]",
        *layout.prose(_sentence(field.description), " " * 8),
    ]


def _function(function: Function, program: Program, groups: tuple[FieldGroup, ...]) -> _Block:
    used = used_groups(program, groups)
    names = [argument.name for argument in function.arguments] + [group.argument for group in used]
    return _Block(
        function.name,
        ", ".join(names),
        _docstring(function, program, used),
        _body(function, program, used),
    )


def used_groups(program: Program, groups: tuple[FieldGroup, ...]) -> list[FieldGroup]:
    """The groups of parameters that a function takes: those that it needs."""
    inputs = set(program.inputs)
    return [group for group in groups if any(inputs & set(field.symbols) for field in group.fields)]


def _docstring(function: Function, program: Program, groups: list[FieldGroup]) -> list[str]:
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
    return [*lines, f"    {operations(program)}", '    """']


def operations(program: Program) -> str:
    """Sentence about the cost, the same in every language."""
    return f"{program.operations} operations; {program.operations_written_out} with every named value written out."


def _body(function: Function, program: Program, groups: list[FieldGroup]) -> list[str]:
    inputs, lines = set(program.inputs), []
    representatives = []
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
    for symbol, expression in program.steps:
        lines += layout.assignment(
            symbol.name, printers.numpy_expression(expression), "    ", parentheses=True
        )
    for output, entries in program.results:
        if output.listed:
            lines.append(f"    {_local(output.name)} = _listed(batch, dtype, (")
            lines += layout.listing(map(printers.numpy_expression, entries), " " * 8)
            lines.append("    ))")
            continue
        shape = ", ".join(["*batch", *map(str, output.shape)])
        lines.append(
            f"    {_local(output.name)} = np.zeros({f'({shape})' if output.shape else 'batch'}, dtype)"
        )
        for index, entry in zip(_indices(output.shape), entries, strict=True):
            if entry == 0:
                continue
            place = ", ".join(["...", *map(str, index)])
            lines += layout.assignment(
                f"{_local(output.name)}[{place}]", printers.numpy_expression(entry), "    ", parentheses=True
            )
    results = [_local(o.name) if o.shape else f"{_local(o.name)}[()]" for o, _ in program.results]
    lines.append(f"    return {', '.join(results)}")
    return lines


def _unpack(
    symbols: tuple[Symbol, ...], inputs: set[Symbol], source: str, representatives: list[str]
) -> list[str]:
    """Unpack an array; entries that are not needed go to ``_``, but the first still gives the batch shape."""
    names = [s.name if s in inputs or i == 0 else "_" for i, s in enumerate(symbols)]
    representatives.append(names[0])
    left = ", ".join(names) if len(names) > 1 else f"({names[0]},)"
    line = f"    {left} = {source}"
    if len(line) <= layout.WIDTH:
        return [line]
    return ["    (", *layout.prose(f"{left},", " " * 8), f"    ) = {source}"]


def _local(name: str) -> str:
    """Name of the result array; never that of a scalar."""
    return f"{name}_out"


def _indices(shape: tuple[int, ...]) -> list[tuple[int, ...]]:
    indices: list[tuple[int, ...]] = [()]
    for extent in shape:
        indices = [(*index, i) for index in indices for i in range(extent)]
    return indices


def _sentence(text: str) -> str:
    word = text.split(" ")[0].rstrip(",:;")
    if len(word) > 1 and word.isalpha() and word.islower():  # a symbol keeps its case
        text = text[0].upper() + text[1:]
    return text if text.endswith(".") else f"{text}."
