"""Line wrapping of long expressions and prose, the same for every language."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

WIDTH = 110


def prose(text: str, indent: str, first: str | None = None, room: int = 0) -> list[str]:
    """Wrap words; `first` is the indentation of the first line if it differs, `room` the columns left free."""
    return textwrap.wrap(
        text,
        WIDTH - room,
        initial_indent=indent if first is None else first,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def assignment(
    target: str, expression: str, indent: str, end: str = "", parentheses: bool = False
) -> list[str]:
    """Write ``target = expression`` on as many lines as needed, broken before operators.

    Parameters
    ----------
    end : str
        End of a statement, ``";"`` in C.
    parentheses : bool
        Whether the language needs parentheses around a multi-line expression, as Python does.
    """
    line = f"{indent}{target} = {expression}{end}"
    if len(line) <= WIDTH:
        return [line]
    inner = indent + "    "
    pieces = _break_before_operators(expression)
    lines, current = [], inner
    for piece in pieces:
        if current.strip() and len(current) + 1 + len(piece) + len(end) > WIDTH:
            lines.append(current)
            current = inner
        current += piece if not current.strip() else f" {piece}"
    lines.append(current)
    if parentheses:
        return [f"{indent}{target} = (", *lines, f"{indent}){end}"]
    lines[-1] += end
    return [f"{indent}{target} =", *lines]


def listing(entries: Iterable[str], indent: str) -> list[str]:
    """Write entries one after the other, each followed by a comma, long ones on separate lines."""
    lines, current = [], indent
    for entry in entries:
        if current.strip() and len(current) + len(entry) + 2 > WIDTH:
            lines.append(current)
            current = indent
        if len(indent) + len(entry) + 1 > WIDTH:
            inner, *rest = assignment("", entry, indent)[1:]
            lines += [inner.replace(" ", "", 4), *(line.replace(" ", "", 4) for line in rest)]
            lines[-1] += ","
        else:
            current += f"{entry}," if not current.strip() else f" {entry},"
    return [*lines, current] if current.strip() else lines


def _break_before_operators(expression: str) -> list[str]:
    """Split at the spaces around + and - so that each piece begins with its operator."""
    pieces: list[str] = []
    for word in expression.split(" "):
        if pieces and pieces[-1] in ("+", "-"):
            pieces[-1] += f" {word}"
        else:
            pieces.append(word)
    return pieces
