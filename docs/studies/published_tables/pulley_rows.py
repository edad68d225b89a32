r"""Belt lengths from each printed shape, by the rows of the two pulleys in K phi = lambda M phi.

With a = x/R_p, b = theta_1, c = theta_2 of one axis and g = lambda / (R_p^2 w k_sp), the two rows are

.. math:: g I_1 b = (b - c)/l_1 + (b - a)/l_3, \qquad g I_2 c = (c - b)/l_1 + (c - a)/l_2 .

They contain printed numbers, the declared belt and pulleys, and the three free lengths, but neither the platform, the
links nor the pose.  A carriage without length adds l_2 + l_3 = l_1, and the lengths follow from a quadratic
equation.  So each row of the tables determines its own belts, before anything is known about the robot's geometry.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

import pkmodes
from printed import HALF_HERTZ, Array, Row

#: The two ways in which the column x may have been printed.
READINGS = ("x/R_p", "metres")
#: Independent axes: 3 repeats 2.
AXES = (0, 1)


@dataclass(frozen=True)
class Belt:
    """Belt and pulleys of an axis: unit stiffness w k_sp [N], radius, inertia of pulleys 1 and 2."""

    unit: float
    radius: float
    inertia: Array

    @classmethod
    def of(cls, robot: pkmodes.Robot, axis: int) -> Belt:
        """Return the belt of an axis; the motor's inertia, times the ratio squared, is on the driven pulley."""
        p = robot.parameters
        motor = p.gear_ratio[axis] ** 2 * p.motor_inertia[axis] * p.drive[axis]
        unit = float(p.belt_width[axis] * p.belt_specific_stiffness[axis])
        return cls(unit, float(p.pulley_radius[axis]), p.pulley_inertia[axis] + motor)


@dataclass(frozen=True)
class Lengths:
    """Free lengths l_1, l_2, l_3 of an axis [m]: the range that the printed digits of one row allow.

    `root` is the root of the quadratic.
    """

    row: str
    axis: int
    reading: str
    root: int
    low: Array
    high: Array

    def allows(self, span: float) -> bool:
        """Return whether max - min may have this value."""
        return bool(self.low[0] <= span <= self.high[0])

    @property
    def middle(self) -> Array:
        """Midpoints of the intervals."""
        return 0.5 * (self.low + self.high)


def lengths_of(row: Row, axis: int, reading: str, belt: Belt) -> list[Lengths]:
    """Return the lengths that a row implies, with the bounds that its printed digits allow."""
    found = []
    every = _free_lengths(belt, *_corners(row, axis, reading, belt))
    for root, lengths in enumerate(every):
        if np.isfinite(lengths).all():
            found.append(Lengths(row.name, axis, reading, root, lengths.min(axis=0), lengths.max(axis=0)))
    return found


def pose_of_shape(row: Row, axis: int, reading: str, belt: Belt, span: float) -> list[tuple[float, float]]:
    """Solve the rows of the pulleys for l_2 [m] and the frequency [Hz] instead: the pose of a shape."""
    _, (a, b, c) = _eigenvalue_and_shape(row, axis, reading, belt)
    p, q = belt.inertia * np.array([b, c]) / (belt.radius**2 * belt.unit)
    linear = ((b - a) * q + (c - a) * p - (b - c) * (p - q)) / span
    found = []
    for eigenvalue in np.roots([-p * q, linear, 2.0 * (b - c) ** 2 / span**2]):
        with np.errstate(divide="ignore"):
            l_2 = (c - a) / (eigenvalue * q + (b - c) / span)
        if np.isreal(eigenvalue) and eigenvalue > 0.0 and 0.0 < l_2 < span:
            found.append((float(np.real(l_2)), float(np.sqrt(np.real(eigenvalue)) / (2.0 * np.pi))))
    return found


def agreed_span(rows: Sequence[Row], every: Sequence[Lengths]) -> tuple[float, float, set[str]]:
    """Return the bounds of the span that most rows allow in some reading, and the names of those rows.

    A row counts if all its moving axes allow the span in the same reading of its x column.
    """
    ends = np.unique([end for one in every for end in (one.low[0], one.high[0])])
    best: tuple[float, float, set[str]] = (0.0, 0.0, set())
    for low, high in itertools.pairwise(ends):
        span = 0.5 * (low + high)
        names = {row.name for row in rows if any(allowed(row, r, every, span) for r in READINGS)}
        if len(names) > len(best[2]):
            best = (float(low), float(high), names)
    return best


def allowed(row: Row, reading: str, every: Sequence[Lengths], span: float) -> list[Lengths]:
    """Return the lengths of the moving axes if all of them allow a span; otherwise nothing."""
    found = [
        one
        for axis in AXES
        for one in every
        if (one.row, one.axis, one.reading) == (row.name, axis, reading) and one.allows(span)
    ]
    return found if {one.axis for one in found} == {axis for axis in AXES if row.moves(axis)} else []


def carriage_position(row: Row, reading: str, belt: Belt, axis: int, span: float) -> tuple[float, float]:
    """Return the bounds of l_2 of an axis [m] for a known span.

    Each pulley's row gives an estimate, of l_2 or of l_3 = span - l_2; the one with the tighter bounds is used.
    """
    g, (a, b, c) = _corners(row, axis, reading, belt)
    p, q = belt.inertia[0] * g * b, belt.inertia[1] * g * c
    estimates = ((c - a) / (q + (b - c) / span), span - (b - a) / (p - (b - c) / span))
    best = min(estimates, key=np.ptp)
    return float(best.min()), float(best.max())


def _eigenvalue_and_shape(row: Row, axis: int, reading: str, belt: Belt) -> tuple[float, Array]:
    shape = row.shape[row.axis(axis)] / np.array([belt.radius if reading == "metres" else 1.0, 1.0, 1.0])
    return row.eigenvalue / (belt.radius**2 * belt.unit), shape


def _corners(row: Row, axis: int, reading: str, belt: Belt) -> tuple[Array, Array]:
    """Return g (16,) and a, b, c (3, 16) at the corners of the range of the printed digits, rounded or truncated."""
    g, shape = _eigenvalue_and_shape(row, axis, reading, belt)
    unit = row.unit[row.axis(axis)] * shape / row.shape[row.axis(axis)]
    corners = np.array(list(itertools.product((-0.5, 1.0), (-0.5, 1.0), (-0.5, 1.0), (-1.0, 1.0))))
    shapes = shape + corners[:, :3] * np.abs(unit) * np.sign(shape)
    return g * (1.0 + 2.0 * corners[:, 3] * HALF_HERTZ / row.frequency), shapes.T


def _free_lengths(belt: Belt, g: Array, shapes: Array) -> Array:
    """Return (l_1, l_2, l_3) for each root and each of N shapes, (2, N, 3); NaN where a length is not positive.

    With y = 1/l_1, p = g I_1 b and q = g I_2 c, the rows and l_2 + l_3 = l_1 are
    2 (b - c)^2 y^2 + [(b - a) q + (c - a) p - (b - c)(p - q)] y - p q = 0.
    """
    a, b, c = shapes
    p, q = belt.inertia[0] * g * b, belt.inertia[1] * g * c
    square, product = 2.0 * (b - c) ** 2, -p * q
    linear = (b - a) * q + (c - a) * p - (b - c) * (p - q)
    found = []
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(linear**2 - 4.0 * square * product)
        for sign in (1.0, -1.0):
            y = 2.0 * product / (-linear + sign * root)  # also holds where b = c
            lengths = np.stack([1.0 / y, (c - a) / (q + (b - c) * y), (b - a) / (p - (b - c) * y)], axis=-1)
            found.append(np.where((lengths > 0.0).all(axis=-1, keepdims=True), lengths, np.nan))
    return np.array(found)
