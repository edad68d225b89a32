"""Mistakes of the experimenter that corrupt a measurement file between the analyser and the diagnosis.

Each mistake changes the text of a correct file as a spreadsheet, a wrong cable or a wrong unit would.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Sequence

import numpy as np

Rows = list[dict[str, str]]

#: Offset of all poses along z [m], and rotation about z of the frame in which they were measured [rad].
OFFSET, YAW = 0.020, np.radians(2.0)
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


def mistaken(text: str, mistake: str, rng: np.random.Generator) -> str:
    """Return the text of a file with one of `MISTAKES`."""
    comments, rows = parsed(text)
    MISTAKES[mistake](rows, rng)
    return joined(comments, rows)


def _digits(number: float) -> str:
    return f"{number:.9g}"
