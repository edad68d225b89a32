"""Errors that are a user's to mend: each says what, where, and what to do."""

from __future__ import annotations

from collections.abc import Sequence
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
    text = "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)
    text = text if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]}..."
    return f'"{text}"' if isinstance(value, str) else text


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


class MissingExtraError(PkmodesError):
    """An optional library is not installed."""


class OutputError(PkmodesError):
    """A result cannot be written."""


class MeasurementError(PkmodesError):
    """Modal measurements that cannot be read, or that cannot be used with a robot."""
