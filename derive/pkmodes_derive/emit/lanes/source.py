"""Lay out what the compiled evaluator needs of a mechanism: one header in C with vector types.

A pose occupies one lane of a vector, so that the same statements evaluate several poses at once.  What depends on the
parameters alone is a double; the rest is a `lane`.  `pkmodes.core.compiled` has the linear algebra and the entries.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from pkmodes_derive.emit import commentary, layout
from pkmodes_derive.emit.lanes import functions
from pkmodes_derive.emit.lanes.adjoint import gradient
from pkmodes_derive.emit.lanes.pieces import MAX_LINES, Piece, Statement, in_pieces
from pkmodes_derive.emit.lanes.printer import expression
from pkmodes_derive.emit.lanes.tangent import tangent
from pkmodes_derive.emit.program import Entry, Program, Result, arrange
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model
from pkmodes_description import Description

FILE_NAME = "lanes.h"
#: How a margin must compare, by its rule: what the C code knows it by.
RULES = {
    "at_least_zero": "LANES_AT_LEAST_ZERO",
    "above_zero": "LANES_ABOVE_ZERO",
    "at_most_limit": "LANES_AT_MOST_LIMIT",
}
INDENT = "    "


@dataclass(frozen=True)
class _Block:
    """One function as the template sees it: text only; `each` is evaluated for every mode or path.

    In a long function, `body` and `each` call its `pieces`.
    """

    comment: list[str]
    name: str
    arguments: list[str]
    body: list[str]
    each: list[str]
    coordinates: int
    pieces: list[Piece]


def files(
    base: Model, extended: Model, description: Description, provenance: Provenance
) -> tuple[dict[str, str], dict[str, Program]]:
    """Return the text of the header by its file name, and the programs that it prints."""
    groups = [base.groups[0], *(group for group in extended.groups if group.declared)]
    matrices = functions.base(base, description), functions.extended(extended)
    pose = matrices[0].arguments[0].symbols
    inputs = [*(s for group in groups for field in group.fields for s in field.symbols), *pose]
    variables = set(inputs) - functions.choices(base, description)
    gradients = [gradient(f, inputs, variables) for f in matrices]
    equilibria = functions.statics(base), functions.extended_statics(extended)
    pose_functions = functions.position(base, description), *matrices, *equilibria
    tangents = [tangent(matrices[1], inputs, variables)]
    programs = {f"lanes_{f.name}": arrange(f) for f in (*pose_functions, *gradients, *tangents)}
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
            ("DIRECTIONS", len(description.platform)),
            ("LINEAR", len(description.directions)),
            ("DRIVES", len(description.drives)),
            ("DEPENDENT", len(base.coordinates) - len(description.independent)),
            ("BASE", len(base.coordinates)),
            ("ALL", len(extended.coordinates)),
            ("GRADIENT", len(inputs)),
            ("MARGINS", sum(count for count, _ in margins)),
        ],
        rules=layout.listing((f"{{{count}, {RULES[rule]}}}" for count, rule in margins), "    "),
        indices_of=[
            (name, ", ".join(map(str, index_list)))
            for name, index_list in functions.coordinate_indices(description).items()
        ],
        functions=[_function(f, programs[f"lanes_{f.name}"], groups) for f in pose_functions],
        gradients=[_function(f, programs[f"lanes_{f.name}"], groups) for f in gradients],
        tangents=[_function(f, programs[f"lanes_{f.name}"], groups) for f in tangents],
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
    names = [
        "const double *restrict effects",
        *(f"lane *restrict {output.name}" for output in function.outputs),
    ]
    arguments = layout.listing(names, INDENT)
    arguments[-1] = arguments[-1].removesuffix(",") + ")"
    pose_inputs, repeated_inputs, statements = _statements(function, program, groups)
    (_, *of_mode) = function.arguments
    count = len(of_mode[0].symbols) if of_mode else 0
    body = [f"{INDENT}{text};" for text in pose_inputs.values()]
    repeated = [f"{2 * INDENT}{text};" for text in repeated_inputs.values()]
    for statement in statements:
        body += [] if statement.repeated else statement.lines(INDENT)
        repeated += statement.lines(2 * INDENT) if statement.repeated else []
    pieces: list[Piece] = []
    if of_mode and len(body) + len(repeated) > MAX_LINES:
        given = {
            statement.name: "lane " if statement.scalar else "const lane *restrict " for statement in of_mode
        }
        given |= {output.name: "lane *restrict " for output in function.outputs}
        pieces, body, repeated = in_pieces(
            function.name, statements, {**pose_inputs, **repeated_inputs}, given
        )
    return _Block(comment, function.name, arguments, body, repeated, count, pieces)


def _statements(
    function: Function, program: Program, groups: Sequence[FieldGroup]
) -> tuple[dict[str, str], dict[str, str], list[Statement]]:
    """Return the declarations of the arguments of a pose and of each mode or path, and all statements.

    Those for each mode or path come last.
    """
    pose, *of_mode = function.arguments
    inputs = set(program.inputs)
    pose_inputs = {
        s.name: f"const lane {s.name} = pose[{i}]" for i, s in enumerate(pose.symbols) if s in inputs
    }
    for group in groups:
        places = (symbol for field in group.fields for symbol in field.symbols)
        for i, symbol in enumerate(places):
            if symbol in inputs:
                pose_inputs[symbol.name] = f"const double {symbol.name} = {group.argument}[{i}]"
    repeated_inputs = {
        symbol.name: f"const lane {symbol.name} = {argument.name}[{i}]"
        for argument in of_mode
        for i, symbol in enumerate(argument.symbols)
        if symbol in inputs and not argument.scalar
    }
    by_pose = set(pose.symbols)
    by_mode = {symbol for argument in of_mode for symbol in argument.symbols}
    statements = []
    for symbol, value in program.steps:
        names = value.free_symbols
        if names & by_mode:
            by_mode.add(symbol)
        elif names & by_pose:
            by_pose.add(symbol)
        kind = "lane" if symbol in by_mode | by_pose else "double"
        uses = frozenset(symbol_used.name for symbol_used in names)
        target = f"const {kind} {symbol.name}"
        statements.append(Statement(symbol.name, kind, target, expression(value), uses, symbol in by_mode))
    for result in program.results:
        statements += _result(result, bool(of_mode))
    return pose_inputs, repeated_inputs, sorted(statements, key=lambda symbol_used: symbol_used.repeated)


def _result(result: Result, repeated: bool) -> Iterator[Statement]:
    if result.has_zeros:
        clear = f"lanes_clear({result.output.name}, {len(result.output.entries)})"
        yield Statement("", "", "", clear, frozenset(), repeated)
    for entry in result.entries:
        target = " = ".join(_places(result, entry))
        uses = frozenset(symbol.name for symbol in entry.value.free_symbols)
        yield Statement("", "", target, f"LANES({expression(entry.value)})", uses, repeated)


def _places(result: Result, entry: Entry) -> Iterable[str]:
    """Entries in row-major order."""
    for index in entry.places:
        offset = 0
        for i, extent in zip(index, result.output.shape, strict=True):
            offset = offset * extent + i
        yield f"{result.output.name}[{offset}]"
