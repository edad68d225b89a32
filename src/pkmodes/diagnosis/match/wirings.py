"""Wirings: what each shape column of a file really measures, and with which sign.

A sensor with three axes has 48 signed orders, 24 of them turned mountings (rotations) and 24 of the other hand, which
only exchanged or reversed cables give; in a plane there are 8.  If some of its axes are not in the file, a column may
also measure one of those.  Shapes have any sign, so wirings that differ by the sign of all columns are the same.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from pkmodes.diagnosis.problem import Sensor
from pkmodes.measured.measurements import Measurements


@dataclass(frozen=True)
class Wiring:
    """What the C shape columns of a file measure.

    Attributes
    ----------
    channels : tuple of str
        For each column, the channel of the model that it measures.
    signs : tuple of int
        For each column, 1, or -1 if it measures the opposite direction.
    """

    channels: tuple[str, ...]
    signs: tuple[int, ...]

    def of(self, data: Measurements) -> Measurements:
        """Return the measurements with columns that say what they measure."""
        return replace(data, channels=self.channels, shapes=data.shapes * self.signs)

    @property
    def up_to_sign(self) -> Wiring:
        """The same wiring with the first column of positive sign: shapes do not tell the two apart."""
        return Wiring(self.channels, tuple(sign * self.signs[0] for sign in self.signs))


def as_in_file(columns: Sequence[str]) -> Wiring:
    """Return the wiring in which each column measures what its header says."""
    return Wiring(tuple(columns), (1,) * len(columns))


def wirings(columns: Sequence[str], sensors: Sequence[Sensor]) -> dict[Wiring, list[Wiring]]:
    """Return all wirings that a single mistake gives, except that of the file.

    Parameters
    ----------
    columns : sequence of str
        Channels of the shape columns.
    sensors : sequence of Sensor
        Sensors with several axes.

    Returns
    -------
    dict of Wiring to list of Wiring
        For each wiring, up to the sign of all columns, the mistakes that give it, the simplest first.
    """
    right = as_in_file(columns)
    found: dict[Wiring, list[Wiring]] = {}
    for wiring in (*_reversed(right), *_exchanged(right), *_turned(right, sensors)):
        same = found.setdefault(wiring.up_to_sign, [])
        if wiring not in same:
            same.append(wiring)
    found.pop(right.up_to_sign, None)
    return found


def _reversed(right: Wiring) -> Iterator[Wiring]:
    for i in range(len(right.channels)):
        yield Wiring(right.channels, tuple(-1 if k == i else 1 for k in range(len(right.channels))))


def _exchanged(right: Wiring) -> Iterator[Wiring]:
    for i, k in itertools.combinations(range(len(right.channels)), 2):
        channels = list(right.channels)
        channels[i], channels[k] = channels[k], channels[i]
        yield Wiring(tuple(channels), right.signs)


def _turned(right: Wiring, sensors: Sequence[Sensor]) -> Iterator[Wiring]:
    for sensor in sensors:
        place = [i for i, name in enumerate(right.channels) if name in sensor.channels]
        for order in itertools.permutations(sensor.channels, len(place)):
            for signs in itertools.product((1, -1), repeat=len(place)):
                channels, each = list(right.channels), list(right.signs)
                for i, name, sign in zip(place, order, signs, strict=True):
                    channels[i], each[i] = name, sign
                yield Wiring(tuple(channels), tuple(each))
