"""Mistakes of the experimenter that corrupt a measurement file between the analyser and the diagnosis.

Each mistake changes the text of a correct file as a spreadsheet, a wrong cable or a wrong unit would.
"""

from __future__ import annotations

import csv
import io
import itertools
import re
from collections.abc import Callable, Sequence

import numpy as np

Rows = list[dict[str, str]]

#: Offset of all poses along z [m], and rotation about z of the frame in which they were measured [rad].
OFFSET, YAW = 0.020, np.radians(2.0)
#: The triaxial sensor on the platform, and the angle about z of one that is mounted askew [rad].
PLATFORM, SKEW = ("p_x", "p_y", "p_z"), np.radians(40.0)
#: Ratio of stated to correct standard deviations that are far too large and far too small.
CAUTIOUS, BOLD = 100.0, 0.1


def parsed(text: str) -> tuple[list[str], Rows]:
    """Split a file into comment lines and rows."""
    lines = text.splitlines()
    comments = [line for line in lines if line.startswith("#")]
    return comments, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def joined(comments: Sequence[str], rows: Rows) -> str:
    """Join comment lines and rows into the text of a file."""
    text = io.StringIO()
    text.writelines(f"{line}\n" for line in comments)
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def shape_columns(rows: Rows) -> list[str]:
    """Return the names of the shape columns."""
    return [name for name in rows[0] if name.startswith("shape:")]


def _times(rows: Rows, column: str, factor: float) -> None:
    for row in rows:
        if row[column]:
            row[column] = _digits(float(row[column]) * factor)


def _unit(factor: float) -> Callable[[Rows, np.random.Generator], None]:
    def change(rows: Rows, rng: np.random.Generator) -> None:
        _times(rows, "frequency", factor)
        _times(rows, "sigma", factor)

    return change


def _sigma(factor: float) -> Callable[[Rows, np.random.Generator], None]:
    return lambda rows, rng: _times(rows, "sigma", factor)


def _exchanged(a: str, b: str) -> Callable[[Rows, np.random.Generator], None]:
    def change(rows: Rows, rng: np.random.Generator) -> None:
        one, other = f"shape:{a}", f"shape:{b}"
        for row in rows:
            row[one], row[other] = row[other], row[one]

    return change


def _flipped(rows: Rows, rng: np.random.Generator) -> None:
    _times(rows, str(rng.choice(shape_columns(rows))), -1.0)


def _ordered(order: Sequence[str], signs: Sequence[int]) -> Callable[[Rows, np.random.Generator], None]:
    """Return the mistake with which each column of the platform's sensor has what another one should have."""

    def change(rows: Rows, rng: np.random.Generator) -> None:
        for row in rows:
            right = {name: row[f"shape:{name}"] for name in order}
            for column, name, sign in zip(PLATFORM, order, signs, strict=True):
                row[f"shape:{column}"] = _digits(sign * float(right[name])) if right[name] else ""

    return change


def _skewed(rows: Rows, rng: np.random.Generator) -> None:
    cos, sin = np.cos(SKEW), np.sin(SKEW)
    for row in rows:
        if row["shape:p_x"] and row["shape:p_y"]:
            x, y = float(row["shape:p_x"]), float(row["shape:p_y"])
            row["shape:p_x"], row["shape:p_y"] = _digits(cos * x + sin * y), _digits(cos * y - sin * x)


def _copied_shapes(rows: Rows, rng: np.random.Generator) -> None:
    for row in rows:
        row |= {name: rows[0][name] for name in shape_columns(rows)}


def _offset(rows: Rows, rng: np.random.Generator) -> None:
    for row in rows:
        row["z"] = _digits(float(row["z"]) + OFFSET)


def _turned(rows: Rows, rng: np.random.Generator) -> None:
    cos, sin = np.cos(YAW), np.sin(YAW)
    for row in rows:
        x, y = float(row["x"]), float(row["y"])
        row["x"], row["y"] = _digits(cos * x - sin * y), _digits(sin * x + cos * y)


def _copied_pose(rows: Rows, rng: np.random.Generator) -> None:
    """Replace the rows of one pose by copies of the previous pose's rows."""
    labels = sorted({row["pose"] for row in rows}, key=lambda label: int(label[1:]))
    place = int(rng.integers(len(labels) - 1))
    source, target = labels[place], labels[place + 1]
    at = next({k: row[k] for k in ("pose", "x", "y", "z")} for row in rows if row["pose"] == target)
    copies = [{**row, **at} for row in rows if row["pose"] == source]
    rows[:] = [row for row in rows if row["pose"] != target] + copies


#: Mistakes by name.  Mistakes of sensors need shapes at the six default sensors.
MISTAKES: dict[str, Callable[[Rows, np.random.Generator], None]] = {
    "rad/s for Hz": _unit(2.0 * np.pi),
    "rpm for Hz": _unit(60.0),
    "x_1 and x_2 exchanged": _exchanged("x_1", "x_2"),
    "p_y and p_z exchanged": _exchanged("p_y", "p_z"),
    "sign of one channel": _flipped,
    "all shapes equal": _copied_shapes,
    "sigma far too large": _sigma(CAUTIOUS),
    "sigma far too small": _sigma(BOLD),
    "poses too high": _offset,
    "poses turned": _turned,
    "one pose copied": _copied_pose,
}


#: The 47 wrong signed orders of the platform's sensor: what its columns have, such as "p_y, -p_x, p_z".
ORDERS = {
    ", ".join(f"{'-' if sign < 0 else ''}{name}" for name, sign in zip(order, signs, strict=True)): (
        order,
        signs,
    )
    for order in itertools.permutations(PLATFORM)
    for signs in itertools.product((1, -1), repeat=3)
    if (order, signs) != (PLATFORM, (1, 1, 1))
}
#: The platform's sensor mounted askew, which is no signed order.
ASKEW = "sensor askew"
#: Mistakes of the platform's sensor by name.
MOUNTINGS = {**{name: _ordered(*order) for name, order in ORDERS.items()}, ASKEW: _skewed}


def mistaken(text: str, mistake: str, rng: np.random.Generator) -> str:
    """Return the text of a file with one of `MISTAKES` or `MOUNTINGS`."""
    comments, rows = parsed(text)
    {**MISTAKES, **MOUNTINGS}[mistake](rows, rng)
    return joined(comments, rows)


def followed(order: Sequence[str], advice: str) -> list[str]:
    """Return what columns have after the advice of a note was followed: the right order if that was right.

    Parameters
    ----------
    order : sequence of str
        What the platform's columns have, such as ``["p_y", "-p_x", "p_z"]``.
    advice : str
        With parts "rename the column shape:p_x to shape:p_y and change the sign of its values", and "change the sign
        of the columns shape:p_x and shape:p_z".
    """
    has = dict(zip(PLATFORM, order, strict=True))
    head, change = r"shape:(\w+)", r" and change the sign of its values"
    reverse = re.findall(rf"rename the column {head} to {head}{change}", advice)
    negated = {new for _, new in reverse}
    renamed = {
        new: has.get(old, "") for old, new in re.findall(rf"rename the column {head} to {head}", advice)
    }
    for part in re.findall(rf"change the sign of the columns? ((?:{head}(?:, | and )?)+)", advice):
        negated |= set(re.findall(head, part[0]))
    corrected = {**has, **renamed}
    signed = [f"-{corrected[name]}" if name in negated else corrected[name] for name in PLATFORM]
    others = negated - set(PLATFORM)
    if others:  # reversing all other channels is reversing these
        signed = [f"-{name}" for name in signed]
    return [name.replace("--", "") for name in signed]


def _digits(number: float) -> str:
    return f"{number:.9g}"
