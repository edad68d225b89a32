"""A long function in pieces, because the time that compilers take for a function grows with the square of its length.

Each piece is a function of its own.  It reads its arguments, and the values of earlier pieces from two arrays, in
which it stores the values that later pieces need.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from pkmodes_derive.emit import layout

INDENT = "    "
#: Longest function that is written in one piece, and shortest piece of the others [lines].
MAX_LINES, MIN_PIECE_LINES = 2400, 250
#: The arrays by the type of their elements.
ARRAYS = {"double": "numbers", "lane": "kept"}
#: The types of what every piece takes, by name.
COMMON_ARGUMENTS = {
    "pose": "const lane *restrict ",
    "parameters": "const double *restrict ",
    "effects": "const double *restrict ",
    "numbers": "double *restrict ",
    "kept": "lane *restrict ",
}


@dataclass(frozen=True)
class Statement:
    """A statement of a function.

    Attributes
    ----------
    name, kind : str
        What it defines, and its type; empty for a result.
    target, expression : str
        What is assigned to what; a call has no target.
    uses : frozenset of str
        Names in the expression.
    repeated : bool
        Whether it depends on the mode or path.
    """

    name: str
    kind: str
    target: str
    expression: str
    uses: frozenset[str]
    repeated: bool

    def lines(self, indent: str) -> list[str]:
        """Return its lines."""
        if not self.target:
            return [f"{indent}{self.expression};"]
        return layout.assignment(self.target, self.expression, indent, end=";")


@dataclass(frozen=True)
class Piece:
    """A part of a function, counted from 1, as the template sees it."""

    number: int
    arguments: list[str]
    lines: list[str]


def in_pieces(
    name: str, statements: Sequence[Statement], inputs: Mapping[str, str], given: Mapping[str, str]
) -> tuple[list[Piece], list[str], list[str]]:
    """Divide a function.

    Parameters
    ----------
    name : str
        Of the function.
    statements : sequence of Statement
        Those for each mode or path last.
    inputs : mapping of str to str
        The declaration of each number by its name, without the end of the statement.
    given : mapping of str to str
        The types of what pieces for each mode or path take besides, by name.

    Returns
    -------
    pieces : list of Piece
    body, each : list of str
        The lines that call them.
    """
    parts = list(_parts(statements))
    last_use = {used: i for i, part in enumerate(parts) for statement in part for used in statement.uses}
    slots: dict[str, tuple[str, str]] = {}
    counts = dict.fromkeys(ARRAYS, 0)
    for i, part in enumerate(parts):
        for statement in part:
            if statement.name and last_use.get(statement.name, i) > i:
                slots[statement.name] = statement.kind, f"{ARRAYS[statement.kind]}[{counts[statement.kind]}]"
                counts[statement.kind] += 1
    declarations = {
        **inputs,
        **{value: f"const {kind} {value} = {slot}" for value, (kind, slot) in slots.items()},
    }
    pieces = []
    body = [f"{INDENT}{kind} {array}[{max(counts[kind], 1)}];" for kind, array in ARRAYS.items()]
    calls: tuple[list[str], list[str]] = body, []
    for number, part in enumerate(parts, start=1):
        is_repeated = part[0].repeated
        argument_types = {**COMMON_ARGUMENTS, **(given if is_repeated else {})}
        arguments = layout.listing((f"{kind}{value}" for value, kind in argument_types.items()), INDENT)
        arguments[-1] = arguments[-1].removesuffix(",") + ")"
        pieces.append(Piece(number, arguments, list(_lines(part, declarations, slots))))
        indent = INDENT * (2 if is_repeated else 1)
        calls[is_repeated].append(f"{indent}lanes_{name}_{number}({', '.join(argument_types)});")
    return pieces, *calls


def _lines(
    part: Sequence[Statement], declarations: Mapping[str, str], slots: Mapping[str, tuple[str, str]]
) -> Iterator[str]:
    """Yield the lines of a piece, each value read before its first use and stored where it is computed."""
    defined: set[str] = set()
    for statement in part:
        for name in sorted(statement.uses - defined):
            if name in declarations:
                yield f"{INDENT}{declarations[name]};"
        defined |= {statement.name, *statement.uses}
        yield from statement.lines(INDENT)
        if statement.name in slots:
            yield f"{INDENT}{slots[statement.name][1]} = {statement.name};"


def _parts(statements: Sequence[Statement]) -> Iterator[list[Statement]]:
    """Yield statements until there are enough lines, or those for each mode or path begin."""
    part: list[Statement] = []
    lines = 0
    for statement in statements:
        if part and (lines >= MIN_PIECE_LINES or statement.repeated != part[0].repeated):
            yield part
            part, lines = [], 0
        part.append(statement)
        lines += len(statement.lines(INDENT))
    if part:
        yield part
