"""What each shape column of a file may really measure, and with which sign.

A sensor with three axes has 48 signed orders: 24 are turned mountings (rotations), and 24 are left-handed, which only
exchanged or reversed cables produce; in a plane there are 8.  If some of its axes are not in the file, a column may
also measure one of those.  The sign of a shape is arbitrary, so wirings that differ by the sign of all columns are
the same.

The axes of a sensor in the directions of the model are the rows of a signed permutation W.  If det W = 1, the sensor
is mounted in another direction: it is turned by R = W^T.  Otherwise cables are exchanged or reversed.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.problem import Array, Sensor
from pkmodes.loop.measured.measurements import Measurements


@dataclass(frozen=True)
class Wiring:
    """What the C shape columns of a file measure.

    - channels: for each column, the channel of the model that it measures
    - signs: for each column, 1, or -1 if it measures the opposite direction
    """

    channels: tuple[str, ...]
    signs: tuple[int, ...]

    def applied_to(self, data: Measurements) -> Measurements:
        """Return the measurements with columns named and signed by what they measure."""
        return replace(data, channels=self.channels, shapes=data.shapes * self.signs)

    @property
    def up_to_sign(self) -> Wiring:
        """The same wiring with a positive first column: shapes do not tell the two apart."""
        return Wiring(self.channels, tuple(sign * self.signs[0] for sign in self.signs))


def as_in_file(columns: Sequence[str]) -> Wiring:
    """Return the wiring in which each column measures what its header says."""
    return Wiring(tuple(columns), (1,) * len(columns))


def wirings(columns: Sequence[str], sensors: Sequence[Sensor]) -> dict[Wiring, list[Wiring]]:
    """Return all wirings that result from a single mistake, except that of the file.

    They are unique up to the sign of all columns, each with the mistakes that lead to it.
    """
    as_filed = as_in_file(columns)
    by_wiring: dict[Wiring, list[Wiring]] = {}
    for wiring in _single_mistakes(as_filed, sensors):
        mistakes = by_wiring.setdefault(wiring.up_to_sign, [])
        if wiring not in mistakes:
            mistakes.append(wiring)
    by_wiring.pop(as_filed.up_to_sign, None)
    return by_wiring


def _single_mistakes(as_filed: Wiring, sensors: Sequence[Sensor]) -> Iterator[Wiring]:
    """Yield wirings with one column reversed, with two exchanged, and with a sensor of any signed order."""
    names, indices = as_filed.channels, range(len(as_filed.channels))
    for i in indices:
        yield Wiring(names, tuple(-1 if k == i else 1 for k in indices))
    for i, k in itertools.combinations(indices, 2):
        exchanged = {i: names[k], k: names[i]}
        yield Wiring(tuple(exchanged.get(j, names[j]) for j in indices), as_filed.signs)
    for sensor in sensors:
        columns = [i for i in indices if names[i] in sensor.channels]
        orders = itertools.permutations(sensor.channels, len(columns))
        for order, signs in itertools.product(orders, itertools.product((1, -1), repeat=len(columns))):
            channels, new_signs = list(names), list(as_filed.signs)
            for i, name, sign in zip(columns, order, signs, strict=True):
                channels[i], new_signs[i] = name, sign
            yield Wiring(tuple(channels), tuple(new_signs))


def simplicity(wiring: Wiring, columns: Sequence[str]) -> tuple[int, int]:
    """Return the numbers of columns that measure another channel, and that are reversed: fewest for the simplest."""
    moved_count = sum(channel != name for channel, name in zip(wiring.channels, columns, strict=True))
    return moved_count, sum(sign < 0 for sign in wiring.signs)


# Words ---------------------------------------------------------------------------------------------------------


def wiring_in_words(wiring: Wiring, columns: Sequence[str], sensors: Sequence[Sensor]) -> str:
    """Return what is wrong, for a sentence: "p_y is reversed"."""
    wrong_columns = [
        k for k, name in enumerate(columns) if (wiring.channels[k], wiring.signs[k]) != (name, 1)
    ]
    reversed_columns = [columns[k] for k in wrong_columns if wiring.signs[k] < 0]
    moved_columns = [columns[k] for k in wrong_columns if wiring.channels[k] != columns[k]]
    if not moved_columns and len(reversed_columns) == 1:
        return f"{reversed_columns[0]} is reversed"
    description = ", ".join(
        f"{columns[k]} measures {'-' if wiring.signs[k] < 0 else ''}{wiring.channels[k]}"
        for k in wrong_columns
    )
    if {wiring.channels[columns.index(name)] for name in moved_columns} != set(moved_columns):
        return description  # one of them measures an axis that is not in the file
    if len(moved_columns) == 2 and not reversed_columns:
        return f"{joined(moved_columns)} are exchanged"
    if len(moved_columns) > 2 and not reversed_columns:
        return f"{joined(moved_columns)} are exchanged cyclically ({description})"
    sensor = next((s for s in sensors if all(columns[k] in s.channels for k in wrong_columns)), None)
    W = None if sensor is None else _axis_matrix(wiring, columns, sensor)
    if sensor is not None and W is not None and round(float(np.linalg.det(W))) == 1:
        location = f"at the {sensor.place}" if sensor.place else f"of {joined(sensor.channels)}"
        return f"the sensor {location} is turned{_turn_in_words(W, sensor)} ({description})"
    if not moved_columns:
        return f"{joined(reversed_columns)} are {'both' if len(reversed_columns) == 2 else 'all'} reversed"
    return f"{joined(moved_columns)} are exchanged and {joined(reversed_columns)} reversed ({description})"


def remedy(wiring: Wiring, columns: Sequence[str]) -> str:
    """Return what to change in the file."""
    changes, reversed_columns = [], []
    for column, name, sign in zip(columns, wiring.channels, wiring.signs, strict=True):
        if name != column:
            sign_change = " and change the sign of its values" if sign < 0 else ""
            changes.append(f"rename the column shape:{column} to shape:{name}{sign_change}")
        elif sign < 0:
            reversed_columns.append(f"shape:{column}")
    if reversed_columns:
        changes.append(
            f"change the sign of the column{'s' * (len(reversed_columns) > 1)} {joined(reversed_columns)}"
        )
    return ", ".join(changes)


def hint(wiring: Wiring, columns: Sequence[str], sensors: Sequence[Sensor]) -> str:
    """Return what else to check if one axis of a sensor is reversed."""
    if simplicity(wiring, columns) != (0, 1):
        return ""
    name = columns[wiring.signs.index(-1)]
    for sensor in sensors:
        if name in sensor.channels and sensor.place:
            axis = sensor.axes[sensor.channels.index(name)]
            return f", or check the sensor's direction and the sign of {axis} in the poses"
    return ", or check the sensor's direction"


def _turn_in_words(W: Array, sensor: Sensor) -> str:
    """Return the angle and axis of a turn about one of the sensor's axes or the normal of its plane; else empty."""
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_matrix(W.T).as_rotvec(degrees=True).round().astype(int)
    axis_indices = np.flatnonzero(turn)
    if len(axis_indices) > 1:
        return ""
    missing_axes = {"x", "y", "z"} - set(sensor.axes)
    axes = [*sensor.axes, missing_axes.pop() if len(missing_axes) == 1 else "the normal of its plane"]
    angle = int(turn[axis_indices[0]])
    return f" by {180 if angle == -180 else angle} degrees about {axes[axis_indices[0]]}"


def _axis_matrix(wiring: Wiring, columns: Sequence[str], sensor: Sensor) -> Array | None:
    """Return the sensor's axes as rows, (3, 3): of a right-handed sensor if one is not measured; None if unknown."""
    W: Array = np.zeros((3, 3))
    measured = [k for k, name in enumerate(columns) if name in sensor.channels]
    for k in measured:
        W[sensor.channels.index(columns[k]), sensor.channels.index(wiring.channels[k])] = wiring.signs[k]
    missing_axes = np.flatnonzero(~W.any(axis=1))
    if len(missing_axes) > 1:
        return None
    for row in missing_axes:
        W[row] = np.cross(W[(row + 1) % 3], W[(row + 2) % 3])
        if len(sensor.channels) == 2:
            W[row, row] = 1.0
    return W
