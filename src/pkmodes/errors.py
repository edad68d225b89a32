"""Errors that are a user's to mend: each says what, where, and what to do."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from typing import Any

LONGEST_SHOWN = 60


def shown(value: object) -> str:
    """How something that was found is shown in a message: on one line, printable, not too long."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list | tuple):
        return "a list"
    try:
        text = str(value)
    except ValueError:  # integers beyond the interpreter's limit of digits
        return "a very large number"
    except Exception:  # an object of the caller's that cannot be shown
        text = f"an object of type {type(value).__name__}"
    text = "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)
    text = text if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]}..."
    return f'"{text}"' if isinstance(value, str) else text


def nearest(name: object, known: Iterable[str], otherwise: str = "") -> str:
    """What to do about an unknown name: the nearest known one, something else, or all that are known."""
    names = list(known)
    found = difflib.get_close_matches(name, names, n=1, cutoff=0.5) if isinstance(name, str) else []
    return f'did you mean "{found[0]}"?' if found else otherwise or f"known: {', '.join(names)}"


class PkmodesError(Exception):
    """A mistake in input or usage.

    Parameters
    ----------
    what : str
        What is wrong: what was expected and what was found.
    where : str
        File and place in it, or pose index.
    remedy : str
        What to do about it.
    """

    def __init__(self, what: str, where: str, remedy: str) -> None:
        super().__init__(what, where, remedy)
        self.what, self.where, self.remedy = what, where, remedy

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.what, self.where, self.remedy)

    def __str__(self) -> str:
        return f"{self.what} ({self.where}); {self.remedy}"

    @property
    def lines(self) -> tuple[str, ...]:
        """One line for each thing that is wrong."""
        return (str(self),)


class RobotFileError(PkmodesError):
    """Everything that is wrong with a robot file, so that it can be mended in one go.

    Attributes
    ----------
    problems : tuple of PkmodesError
        In the order of the file's tables.
    """

    def __init__(self, problems: Sequence[PkmodesError]) -> None:
        first = problems[0]
        super().__init__(first.what, first.where, first.remedy)
        self.problems = tuple(problems)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problems,)

    def __str__(self) -> str:
        return "\n".join(self.lines)

    @property
    def lines(self) -> tuple[str, ...]:
        """One line for each problem."""
        return tuple(str(problem) for problem in self.problems)


class PoseError(PkmodesError):
    """A pose that cannot be evaluated, or an array that is not one of poses.

    Attributes
    ----------
    index : int or None
        Flat index of the first bad pose, None when the array as a whole is wrong.
    """

    def __init__(self, what: str, where: str, remedy: str, index: int | None = None) -> None:
        super().__init__(what, where, remedy)
        self.index = index

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.what, self.where, self.remedy, self.index)


class NotComputedError(PkmodesError, AttributeError):
    """A field of a result that was not asked for."""


class MissingExtraError(PkmodesError):
    """An optional library is not installed."""


class OutputError(PkmodesError):
    """A result cannot be written."""


class MeasurementError(PkmodesError):
    """Modal measurements that cannot be read, or that cannot be used with a robot."""


def listed(
    given: Iterable[Any],
    what: str,
    where: str,
    example: str,
    kind: type | tuple[type, ...] = object,
    error: type[PkmodesError] = PkmodesError,
) -> list[Any]:
    """Check a list that a caller gives: a text is no list of its letters.

    Parameters
    ----------
    given : iterable
    what : str
        What it is a list of, in the plural.
    where : str
        The argument.
    example : str
        One element, as it is written.
    kind : type or tuple of types
        That of the elements.
    error : type
        The error to raise.
    """
    try:
        found = None if isinstance(given, str | bytes | bytearray) else list(given)
    except TypeError:
        found = None
    if found is None:
        remedy = f"write [{shown(given)}]" if isinstance(given, str) else f"write such as [{example}]"
        raise error(f"expected a list of {what}, found {shown(given)}", where, remedy)
    for one in found:
        if not isinstance(one, kind):
            raise error(f"expected {what}, found {shown(one)}", where, f"write such as [{example}]")
    return found
