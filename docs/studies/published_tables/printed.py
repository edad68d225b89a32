"""The printed tables: every number with the resolution of its last digit."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

TABLES = Path(__file__).with_name("tables.csv")
#: Components below this are zeros of the eigensolver: symmetry holds the coordinate still.
ZERO = 1e-9
#: Half of the last digit of a printed frequency [Hz].
HALF_HERTZ = 0.0005


@dataclass(frozen=True)
class Row:
    """One printed row.

    Attributes
    ----------
    point, mode : str, int
        ``minimum`` (Table 1) or ``maximum`` (Table 2), and the vibration mode from 1 to 6.
    frequency : float
        [Hz].
    shape : ndarray, shape (9,)
        Components as printed, in the order of the coordinates.
    unit : ndarray, shape (9,)
        One unit of the last printed digit; 0 where the component is exact: the component of size 1 used for
        normalisation, and components that symmetry holds at zero.
    """

    point: str
    mode: int
    frequency: float
    shape: Array
    unit: Array

    @property
    def name(self) -> str:
        """Point and mode."""
        return f"{self.point} {self.mode}"

    @property
    def eigenvalue(self) -> float:
        """(2 pi f)^2 [1/s^2]."""
        return float((2.0 * np.pi * self.frequency) ** 2)

    def axis(self, axis: int) -> slice:
        """Return the slice of the components x, theta_1, theta_2 of an axis."""
        return slice(axis, None, 3)

    def moves(self, axis: int) -> bool:
        """Return whether the axis moves in this mode."""
        return bool((np.abs(self.shape[self.axis(axis)]) > ZERO).all())

    def middle(self, cut: bool) -> Array:
        """Return the midpoint of the range of each component: truncated digits enlarge it, rounding does not."""
        return self.shape + 0.5 * self.unit * np.sign(self.shape) * cut


def read_rows(path: Path = TABLES) -> list[Row]:
    """Read Tables 1 and 2."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = []
    for point, mode, frequency, *components in list(csv.reader(lines))[1:]:
        shape = np.array([float(text) for text in components])
        unit = np.array([_last_digit(text) for text in components])
        unit[(np.abs(shape) < ZERO) | (np.abs(shape) == 1.0)] = 0.0
        shape[np.abs(shape) < ZERO] = 0.0
        rows.append(Row(point, int(mode), float(frequency), shape, unit))
    return rows


def _last_digit(text: str) -> float:
    mantissa, _, exponent = text.lower().partition("e")
    return float(10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2])))
