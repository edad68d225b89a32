"""Evidence from the printed rows one by one, without a fit: units, belts, poses, masses, links."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

import pkmodes
from carriage_rows import Links, links, moving_masses
from geometry import Geometry
from grid import Interval, carriage_1_ahead, carriages, grid_step, position_2
from printed import Array, Row
from pulley_rows import AXES, READINGS, Belt, Lengths, agreed_span, allowed, lengths_of


@dataclass(frozen=True)
class FirstLook:
    """Evidence from single rows.

    Attributes
    ----------
    belts : mapping of int to Belt
    lengths : tuple of Lengths
        Free lengths implied by each row and axis, in both readings of the x column.
    span : Interval
        The span max - min that most rows allow [m].
    readings : mapping of str to str
        The reading in which each of these rows allows the span.
    strays : tuple of str
        Rows that allow the span in neither reading.
    positions : mapping of str to mapping
        Carriage positions of each row and axis [m].
    ahead : Interval
        x_1 - x_2 [m].
    x_2 : mapping of str to Interval
        Position of carriage 2 in each row [m].
    step : Interval
        Largest step of a grid that contains all poses [m].
    index : mapping of str to int
        Points of that grid, from 0 at the smallest x_2.
    masses : ndarray, shape (4,)
        M_11, M_12, M_22 + M_23, M_22 - M_23 [kg].
    links : list of Links
        Link directions that give these masses, best first.
    start : Geometry
        Geometry that combines these values.
    """

    belts: Mapping[int, Belt]
    lengths: tuple[Lengths, ...]
    span: Interval
    readings: Mapping[str, str]
    strays: tuple[str, ...]
    positions: Mapping[str, Mapping[int, Interval]]
    ahead: Interval
    x_2: Mapping[str, Interval]
    step: Interval
    index: Mapping[str, int]
    masses: Array
    links: list[Links]
    start: Geometry


def first_look(declared: pkmodes.Robot, rows: Sequence[Row]) -> FirstLook:
    """Read the rows one after the other, with the declared belts, pulleys, masses and link length."""
    belts = {axis: Belt.of(declared, axis) for axis in AXES}
    lengths = tuple(
        one
        for row in rows
        for axis in AXES
        if row.moves(axis)
        for reading in READINGS
        for one in lengths_of(row, axis, reading, belts[axis])
    )
    low, high, names = agreed_span(rows, lengths)
    span = 0.5 * (low + high)
    kept = [row for row in rows if row.name in names]
    readings = {row.name: next(r for r in READINGS if allowed(row, r, lengths, span)) for row in kept}

    positions = {row.name: carriages(row, readings[row.name], belts, span) for row in kept}
    ahead = carriage_1_ahead(list(positions.values()))
    x_2 = {name: position_2(found, ahead) for name, found in positions.items()}
    step = grid_step(list(x_2.values()))
    origin = min((x for x in x_2.values()), key=lambda x: x.middle).middle
    index = {name: round((x.middle - origin) / step.middle) for name, x in x_2.items()}

    both = {name: np.array([x.middle + ahead.middle, x.middle]) for name, x in x_2.items()}
    masses = moving_masses(kept, readings, both, span, belts[0])
    directions = links(declared, masses)
    best = directions[0]
    start = Geometry(span, best.across, 0.0, best.z, 0.0, step.middle, best.sides)
    in_front, behind = start.reaches(declared)
    start = start.moved(
        offset=best.sides[0] * (in_front + behind) - ahead.middle, first=origin + best.sides[0] * behind
    )
    return FirstLook(
        belts=belts,
        lengths=lengths,
        span=Interval(low, high),
        readings=readings,
        strays=tuple(row.name for row in rows if row.name not in names),
        positions=positions,
        ahead=ahead,
        x_2=x_2,
        step=step,
        index=index,
        masses=masses,
        links=directions,
        start=start,
    )
