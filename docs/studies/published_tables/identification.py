"""Identify the geometry and the poses behind Tables 1 and 2 of the paper, from the declared robot and the tables.

1. Each row by itself (`first_look`): the two pulley equations of an axis give the length of its belt, the unit of
   the x column and the pose; the carriage equations give the moving masses, and these the links.
2. A fit of six unknowns to the rows whose shape and frequency belong together (`fits`).  It predicts the points of
   the frequencies of the other two rows.
3. The same fit to all twelve frequencies (`twelve`), which shows that five of the six unknowns are round numbers;
   with these fixed, one remains (`last`), and the interval in which it reproduces every printed digit.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

import pkmodes
from first_look import FirstLook, first_look
from fitting import Found, Tables, as_printed
from geometry import Geometry, in_robot_file, joint_radius
from grid import Interval
from printed import HALF_HERTZ, Array, Row
from pulley_rows import READINGS
from rounding import Round, roundest

T = TypeVar("T")
UNKNOWNS = ("z", "across", "offset", "first", "step", "span")
#: Points of the grid that are searched, relative to point 0 at the smallest x_2 of `first_look`.
AROUND = np.arange(-5, 30)
#: Offsets from the fitted z at which every digit is compared [m].
NEAR = np.arange(-1e-6, 1e-6, 1e-8)


@dataclass(frozen=True)
class Stray:
    """A row whose frequency and shape do not belong together, placed by the fit to the other rows.

    Attributes
    ----------
    frequency : mapping of int to float
        Points of the grid at which the printed frequency is predicted, and the prediction [Hz].
    shape : list of (int, str)
        Points, and readings of the x column, that reproduce every digit of the printed shape.
    """

    frequency: Mapping[int, float]
    shape: list[tuple[int, str]]


@dataclass(frozen=True)
class Identified:
    """Result of the identification.

    Attributes
    ----------
    declared : Robot
    rows : tuple of Row
    look : FirstLook
    fits : mapping of bool to Found
        Fit of six unknowns to the self-consistent rows, with the digits of the shapes truncated (True) or
        rounded (False).
    strays : mapping of str to Stray
        The other rows.
    tables, shapes : Tables
        All rows at the points of their frequencies, without the shapes of the strays; and at the points of their
        shapes.
    twelve : Found
        Fit to `tables`.
    radius : tuple of float
        Radius of the joints' circle and its standard error [m].
    rounded : mapping of str to Round
        Round numbers [mm], ``radius`` among them.
    last : Found
        Fit of z with these round numbers.
    z : Interval
        Interval that reproduces every printed digit [m].
    geometry : Geometry
        Geometry with the round numbers and the midpoint of that interval, to 0.01 um.
    """

    declared: pkmodes.Robot
    rows: tuple[Row, ...]
    look: FirstLook
    fits: Mapping[bool, Found]
    strays: Mapping[str, Stray]
    tables: Tables
    shapes: Tables
    twelve: Found
    radius: tuple[float, float]
    rounded: Mapping[str, Round]
    last: Found
    z: Interval
    geometry: Geometry

    @property
    def cut(self) -> bool:
        """Whether the digits of the shapes were truncated."""
        return _better(self.fits)

    @property
    def area(self) -> Array:
        """Points of the grid from the first to the last with a row: the useful working area."""
        return np.arange(self.tables.index.min(), self.tables.index.max() + 1)

    @property
    def in_robot_file(self) -> tuple[Array, Array, float]:
        """Joints (3, 3), limits (3, 2) and x of point 0 in the frame of the robot file [m]."""
        return in_robot_file(self.geometry, 1e-3 * self.rounded["radius"].value)


def identify(declared: pkmodes.Robot, rows: Sequence[Row]) -> Identified:
    """Identify geometry and poses.

    Parameters
    ----------
    declared : Robot
        Robot with the values declared in the paper.
    rows : sequence of Row
        The printed tables.

    Raises
    ------
    LookupError
        If the rows do not agree on one robot.
    """
    look = first_look(declared, rows)
    kept = [row for row in rows if row.name not in look.strays]
    fits = {
        cut: Tables(declared, kept, look.readings, look.index, cut=cut).fit(look.start, UNKNOWNS)
        for cut in (True, False)
    }
    cut = _better(fits)
    strays = {row.name: _placed(row, declared, fits[cut].geometry, cut) for row in rows if row not in kept}
    readings = {**look.readings, **{name: stray.shape[0][1] for name, stray in strays.items()}}
    index = {**look.index, **{name: min(stray.frequency) for name, stray in strays.items()}}
    tables = Tables(declared, rows, readings, index, strays, cut)
    index = {**look.index, **{name: stray.shape[0][0] for name, stray in strays.items()}}
    shapes = Tables(declared, rows, readings, index, cut=cut)

    twelve = tables.fit(fits[cut].geometry, UNKNOWNS)
    rails = float(declared.parameters.origin[2, 1])
    radius = joint_radius(twelve.geometry.across, rails), twelve.sigma["across"] / np.sin(np.pi / 3.0)
    fitted = {name: (twelve.geometry.value(name, declared), twelve.sigma[name]) for name in UNKNOWNS}
    rounded = {
        name: roundest(1e3 * value, 1e3 * sigma)
        for name, (value, sigma) in {**fitted, "radius": radius}.items()
    }
    values = {name: 1e-3 * rounded[name].value for name in ("offset", "first", "step", "span")}
    values["across"] = rails - 1e-3 * rounded["radius"].value * float(np.sin(np.pi / 3.0))
    last = tables.fit(twelve.geometry.moved(**values), ("z",))
    z = _required(every_digit(tables, shapes, last.geometry), "every printed digit")
    return Identified(
        declared=declared,
        rows=tuple(rows),
        look=look,
        fits=fits,
        strays=strays,
        tables=tables,
        shapes=shapes,
        twelve=twelve,
        radius=radius,
        rounded=rounded,
        last=last,
        z=z,
        geometry=last.geometry.moved(z=round(z.middle, 8)),
    )


def every_digit(frequencies: Tables, shapes: Tables, geometry: Geometry) -> Interval | None:
    """Return the interval of z near a geometry's that reproduces every printed digit, or None."""
    good = []
    for z in geometry.z + NEAR:
        trial = geometry.moved(z=float(z))
        if max(np.abs(frequencies.misses(trial)[0]).max(), np.abs(shapes.misses(trial)[1]).max()) <= 1.0:
            good.append(float(z))
    return Interval(good[0], good[-1]) if good else None


def _required(found: T | None, what: str) -> T:
    """Return what was found; raise an error if nothing was."""
    if not found:
        raise LookupError(f"nothing on the grid gives {what}")
    return found


def _better(fits: Mapping[bool, Found]) -> bool:
    return min(fits, key=lambda cut: fits[cut].rms)


def _placed(row: Row, declared: pkmodes.Robot, geometry: Geometry, cut: bool) -> Stray:
    """Locate the frequency and the shape of a row, each by itself."""
    frequencies, shapes = (values[:, row.mode - 1] for values in geometry.modes(declared, AROUND))
    # To within a digit: the accuracy of the fit, which does not use this row.
    close = np.flatnonzero(np.abs(frequencies - row.frequency) < 2.0 * HALF_HERTZ)
    frequency = {int(AROUND[i]): float(frequencies[i]) for i in close}
    radius, known, shape = float(declared.parameters.pulley_radius[0]), row.unit > 0.0, []
    for k, reading in itertools.product(range(len(AROUND)), READINGS):
        off = np.abs(as_printed(shapes[k], row, reading, radius) - row.middle(cut))
        if (off[known] <= 0.55 * row.unit[known]).all():
            shape.append((int(AROUND[k]), reading))
    return Stray(
        _required(frequency, f"the frequency of {row.name}"), _required(shape, f"the shape of {row.name}")
    )
