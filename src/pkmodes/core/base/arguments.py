"""Constraints on arguments: each in words, for the message, and as a condition."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError, shown

#: The word that stands for all names where names are listed.
ALL = "all"


@dataclass(frozen=True)
class Constraint:
    """What an argument has to be.

    - expected: in words: "a positive integer"
    - holds: whether a value of any type is one
    """

    expected: str
    holds: Callable[[Any], bool]


def check_argument(
    value: object, constraint: Constraint, where: str, remedy: str, error: type[PkmodesError] = PkmodesError
) -> None:
    """Refuse a value that does not meet a constraint.

    - where: name of the argument
    - remedy: what to do, such as an example
    - error: the error to raise

    Raises PkmodesError: "expected ..., found ...".
    """
    if not constraint.holds(value):
        raise error(f"expected {constraint.expected}, found {shown(value)}", where, remedy)


def is_integer(value: object) -> bool:
    """Whether a value is an integer of Python or NumPy; booleans are not."""
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def is_number(value: object) -> bool:
    """Whether a value is a real number of Python or NumPy; booleans are not."""
    return is_integer(value) or isinstance(value, float | np.floating)


def real_numbers(values: ArrayLike, expected: str, where: str, remedy: str) -> NDArray[np.float64]:
    """Return real numbers as an array of any shape, NaN where masked; texts and booleans are refused.

    - expected: what is expected, in words
    - where, remedy: as for `check_argument`

    Raises PkmodesError: "expected ..., found ...".
    """
    try:
        array = np.asarray(values)
    except ValueError:  # rows of different lengths
        array = np.asarray(None)
    if array.dtype.kind not in "iuf":
        raise PkmodesError(f"expected {expected}, found {shown(values)}", where, remedy)
    numbers = array.astype(float)
    return (
        np.ma.filled(np.ma.asanyarray(values).astype(float), np.nan) if np.ma.is_masked(values) else numbers
    )


def alternatives(words: Iterable[str]) -> str:
    """Return words as text: "svg, png or pdf"."""
    *leading, last = words
    return f"{', '.join(leading)} or {last}" if leading else last


def one_of(words: Iterable[str]) -> Constraint:
    """Return the constraint to one of a few words."""
    choices = tuple(words)
    return Constraint(alternatives(choices), lambda value: isinstance(value, str) and value in choices)


POSITIVE_INTEGER = Constraint("a positive integer", lambda value: is_integer(value) and value >= 1)
NATURAL_NUMBER = Constraint("an integer of at least 0", lambda value: is_integer(value) and value >= 0)
POSITIVE_NUMBER = Constraint("a positive number", lambda value: is_number(value) and value > 0.0)
FILE_NAME = Constraint(
    "the name of a file",
    lambda value: isinstance(value, str | os.PathLike) and isinstance(os.fspath(value), str),
)


def is_all(names: object) -> bool:
    """Return whether an argument that takes a list of names is the word "all", which stands for every one of them."""
    return isinstance(names, str) and names == ALL
