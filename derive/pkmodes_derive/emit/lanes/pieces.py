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
LONG, ENOUGH = 2400, 250
#: The arrays by the type of their elements.
ARRAYS = {"double": "numbers", "lane": "kept"}
#: The types of what every piece takes, by name.
TAKEN = {
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
    each : bool
        Whether it depends on the mode or path.
    """

    name: str
    kind: str
    target: str
    expression: str
    uses: frozenset[str]
    each: bool

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
    last = {used: i for i, part in enumerate(parts) for one in part for used in one.uses}
    slots: dict[str, tuple[str, str]] = {}
    counts = dict.fromkeys(ARRAYS, 0)
    for i, part in enumerate(parts):
        for one in part:
            if one.name and last.get(one.name, i) > i:
                slots[one.name] = one.kind, f"{ARRAYS[one.kind]}[{counts[one.kind]}]"
                counts[one.kind] += 1
    known = {**inputs, **{own: f"const {kind} {own} = {slot}" for own, (kind, slot) in slots.items()}}
    pieces = []
    body = [f"{INDENT}{kind} {array}[{max(counts[kind], 1)}];" for kind, array in ARRAYS.items()]
    calls: tuple[list[str], list[str]] = body, []
    for number, part in enumerate(parts, start=1):
        of_each = part[0].each
        taken = {**TAKEN, **(given if of_each else {})}
        arguments = layout.listing((f"{kind}{own}" for own, kind in taken.items()), INDENT)
        arguments[-1] = arguments[-1].removesuffix(",") + ")"
        pieces.append(Piece(number, arguments, list(_lines(part, known, slots))))
        indent = INDENT * (2 if of_each else 1)
        calls[of_each].append(f"{indent}lanes_{name}_{number}({', '.join(taken)});")
    return pieces, *calls


def _lines(
    part: Sequence[Statement], known: Mapping[str, str], slots: Mapping[str, tuple[str, str]]
) -> Iterator[str]:
    """Yield the lines of a piece, each value read before its first use, and kept where it is found."""
    own: set[str] = set()
    for one in part:
        for name in sorted(one.uses - own):
            if name in known:
                yield f"{INDENT}{known[name]};"
        own |= {one.name, *one.uses}
        yield from one.lines(INDENT)
        if one.name in slots:
            yield f"{INDENT}{slots[one.name][1]} = {one.name};"


def _parts(statements: Sequence[Statement]) -> Iterator[list[Statement]]:
    """Yield statements until there are enough lines, or those for each mode or path begin."""
    part: list[Statement] = []
    lines = 0
    for one in statements:
        if part and (lines >= ENOUGH or one.each != part[0].each):
            yield part
            part, lines = [], 0
        part.append(one)
        lines += len(one.lines(INDENT))
    if part:
        yield part
