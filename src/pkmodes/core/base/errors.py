"""Errors that the user can fix: each says what is wrong, where, and what to do."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from typing import Any

MAX_SHOWN_LENGTH = 60


def shown(value: object) -> str:
    """Format a value for a message: on one line, printable, not too long."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list | tuple):
        return "a list"
    try:
        text = str(value)
    except ValueError:  # an integer with more digits than the interpreter converts
        return "a very large number"
    except Exception:  # an object of the caller that cannot be converted to text
        text = f"an object of type {type(value).__name__}"
    text = printable(text[: MAX_SHOWN_LENGTH + 1])
    text = text if len(text) <= MAX_SHOWN_LENGTH else f"{text[:MAX_SHOWN_LENGTH]}..."
    return f'"{text}"' if isinstance(value, str) else text


def printable(text: str) -> str:
    """Write characters that are not visible, such as line breaks and marks of text direction, as escapes."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)


def nearest_name(name: object, candidates: Iterable[str], otherwise: str = "") -> str:
    """Return the remedy for an unknown name: the nearest known name, `otherwise`, or all known names."""
    names = list(candidates)
    by_lower = {candidate.lower(): candidate for candidate in reversed(names)}
    close = (
        difflib.get_close_matches(name.lower(), by_lower, n=1, cutoff=0.5) if isinstance(name, str) else []
    )
    matches = [by_lower[lower] for lower in close]
    return f'did you mean "{matches[0]}"?' if matches else otherwise or f"known: {', '.join(names)}"


class PkmodesError(Exception):
    """A mistake in input or usage.

    Parameters
    ----------
    what : str
        What was expected and what was found.
    where : str
        The file and the place in it, or the pose index.
    remedy : str
        What to do about it.
    """

    def __init__(self, what: str, where: str, remedy: str) -> None:
        super().__init__(what, where, remedy)
        self.what, self.where, self.remedy = what, where, remedy

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.what, self.where, self.remedy)

    def __str__(self) -> str:
        return printable(f"{self.what} ({self.where}); {self.remedy}")

    @property
    def lines(self) -> tuple[str, ...]:
        """One line for each problem."""
        return (str(self),)


class RobotFileError(PkmodesError):
    """All problems of a robot file, so that they can be fixed in one go.

    Attributes
    ----------
    problems : tuple of PkmodesError
        In the order of the tables in the file.
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
    """A pose that cannot be evaluated, or an array that does not hold poses.

    Attributes
    ----------
    index : int or None
        Flat index of the first bad pose, None when the array as a whole is invalid.
    """

    def __init__(self, what: str, where: str, remedy: str, index: int | None = None) -> None:
        super().__init__(what, where, remedy)
        self.index = index

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.what, self.where, self.remedy, self.index)


class NotComputedError(PkmodesError, AttributeError):
    """A field of a result that was not requested."""


class MissingExtraError(PkmodesError):
    """An optional library is not installed."""


class OutputError(PkmodesError):
    """A result cannot be written."""


class MeasurementError(PkmodesError):
    """Modal measurements that cannot be read or used with a robot."""


def checked_list(
    values: Iterable[Any],
    plural: str,
    where: str,
    example: str,
    kind: type | tuple[type, ...] = object,
    error: type[PkmodesError] = PkmodesError,
) -> list[Any]:
    """Check a list from the caller; a string is not accepted as a list of its characters.

    - plural: name of the elements, in the plural
    - where: name of the argument
    - example: one element, as the caller would write it
    - kind: type of the elements
    - error: the error to raise
    """
    try:
        elements = None if isinstance(values, str | bytes | bytearray) else list(values)
    except TypeError:
        elements = None
    if elements is None:
        accepted = isinstance(values, str) and isinstance(values, kind)
        remedy = f"write [{shown(values)}]" if accepted else f"for example: [{example}]"
        raise error(f"expected a list of {plural}, found {shown(values)}", where, remedy)
    for element in elements:
        if not isinstance(element, kind):
            raise error(f"expected {plural}, found {shown(element)}", where, f"for example: [{example}]")
    return elements
