"""Where two outcomes of one command differ: words and keys exactly, numbers to rounding.

The same calculation differs in its last digits between processors and libraries of linear algebra, and that of a fit
in more.  A printed number may therefore differ by one unit of its last digit, and any number by a relative tolerance;
the elements of an array by that share of its largest one.
"""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterator
from typing import Any

#: Numbers by themselves: those within names, such as p_1 or SHA-256 digests, are words.
NUMBER = re.compile(r"(?<![\w.])[-+\u2212]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.]*[A-Za-z_])")
#: Relative tolerance of numbers that no fit has touched.
CALCULATED = 1e-7
#: Of those that a fit has found: the kernels of linear algebra for other processors move what is identified by 1e-4.
FITTED = 1e-3
#: A number below it is what rounding leaves of zero.
NOTHING = 1e-13
#: Most differences that are listed.
LISTED = 8


def differences(name: str, golden: str, found: str, tolerance: float = CALCULATED) -> list[str]:
    """Return where a file of an outcome differs from the golden one; at most `LISTED` places.

    Parameters
    ----------
    name : str
        Of the file; ``.json`` is compared as a document, ``.csv`` as a table, anything else line by line.
    tolerance : float
        Relative tolerance of numbers.
    """
    if name.endswith(".json"):
        places = _in_documents(json.loads(golden), json.loads(found), tolerance, "")
    elif name.endswith(".csv"):
        places = _in_tables(_rows(golden), _rows(found), tolerance)
    else:
        places = _in_lines(golden.splitlines(), found.splitlines(), tolerance)
    return [f"{name}: {place}" for place, _ in zip(places, range(LISTED), strict=False)]


def _in_lines(golden: list[str], found: list[str], tolerance: float) -> Iterator[str]:
    for i, (old, new) in enumerate(zip(golden, found, strict=False), start=1):
        if not _alike(old, new, tolerance):
            yield f"line {i}: {new!r} instead of {old!r}"
    if len(golden) != len(found):
        yield f"{len(found)} lines instead of {len(golden)}"


def _alike(old: str, new: str, tolerance: float) -> bool:
    if old == new:
        return True
    # Numbers may have more or fewer characters, so that columns move.
    if NUMBER.sub("#", old).split() != NUMBER.sub("#", new).split():
        return False
    numbers = zip(NUMBER.findall(old), NUMBER.findall(new), strict=True)
    return all(abs(_value(a) - _value(b)) <= _allowed(a, tolerance) for a, b in numbers)


def _value(text: str) -> float:
    return float(text.replace("\u2212", "-"))


def _allowed(text: str, tolerance: float) -> float:
    """Return by how much another number may differ: by a unit of the last digit, but a whole number by nothing."""
    digits, _, power = text.lower().partition("e")
    _, point, decimals = digits.partition(".")
    if not point and not power:
        return 0.0
    unit = 10.0 ** (int(power or 0) - len(decimals))
    return max(1.01 * unit, tolerance * abs(_value(text)))


def _rows(text: str) -> list[list[str]]:
    return list(csv.reader(text.splitlines()))


def _in_tables(old: list[list[str]], new: list[list[str]], tolerance: float) -> Iterator[str]:
    """Compare cells; numbers differ by a share of the largest in their column, as elements of an array do."""
    if [len(row) for row in old] != [len(row) for row in new]:
        yield f"a table of {len(new)} rows, of other lengths, instead of {len(old)}"
        return
    largest: dict[int, float] = {}
    for row in old:
        for i, cell in enumerate(row):
            if NUMBER.fullmatch(cell):
                largest[i] = max(largest.get(i, 0.0), abs(float(cell)))
    for line, (a, b) in enumerate(zip(old, new, strict=True), start=1):
        for i, (x, y) in enumerate(zip(a, b, strict=True)):
            numbers = NUMBER.fullmatch(x) and NUMBER.fullmatch(y)
            if x != y and not (numbers and abs(float(x) - float(y)) <= tolerance * largest[i]):
                yield f"row {line}, column {i + 1}: {y} instead of {x}"


def _in_documents(old: Any, new: Any, tolerance: float, place: str) -> Iterator[str]:
    if isinstance(old, dict) and isinstance(new, dict):
        if list(old) != list(new):
            yield f"{place or '/'}: the keys {list(new)} instead of {list(old)}"
        for key in old.keys() & new.keys():
            yield from _in_documents(old[key], new[key], tolerance, f"{place}/{key}")
    elif _numbers(old) and _numbers(new):
        yield from _in_arrays(old, new, tolerance, place)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{place}: {len(new)} elements instead of {len(old)}"
        for i, (a, b) in enumerate(zip(old, new, strict=False)):
            yield from _in_documents(a, b, tolerance, f"{place}/{i}")
    elif isinstance(old, str) and isinstance(new, str):
        yield from (f"{place}: {line}" for line in _in_lines([old], [new], tolerance))
    elif isinstance(old, float) and isinstance(new, int | float):
        if not abs(old - new) <= max(tolerance * abs(old), NOTHING):
            yield f"{place}: {new} instead of {old}"
    elif type(old) is not type(new) or old != new:
        yield f"{place}: {new!r} instead of {old!r}"


def _numbers(value: Any) -> bool:
    """Whether a value is an array of numbers, of any dimension."""
    return isinstance(value, list) and bool(value) and all(isinstance(v, float) or _numbers(v) for v in value)


def _in_arrays(old: list[Any], new: list[Any], tolerance: float, place: str) -> Iterator[str]:
    a, b = list(_leaves(old, "")), list(_leaves(new, ""))
    if [where for where, _ in a] != [where for where, _ in b]:
        yield f"{place}: an array of another shape"
        return
    allowed = tolerance * max(abs(value) for _, value in a)
    for (where, x), (_, y) in zip(a, b, strict=True):
        if not abs(x - y) <= allowed:
            yield f"{place}{where}: {y} instead of {x}"


def _leaves(value: Any, place: str) -> Iterator[tuple[str, float]]:
    if isinstance(value, list):
        for i, one in enumerate(value):
            yield from _leaves(one, f"{place}/{i}")
    else:
        yield place, value
