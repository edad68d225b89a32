"""What a wrong wiring is called (reversed, exchanged, turned), and what to change in the file.

The axes of a sensor in the directions of the model are the rows of a signed permutation W.  If det W = 1, the sensor
is mounted in another direction: it is turned by R = W^T, by an angle with 1 + 2 cos(angle) = trace(R).  Otherwise
cables are exchanged or reversed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.diagnosis.match.wirings import Wiring
from pkmodes.diagnosis.problem import Array, Sensor


def described(wiring: Wiring, columns: Sequence[str], sensors: Sequence[Sensor]) -> str:
    """Return what is wrong, for a sentence: "p_y is reversed".

    Parameters
    ----------
    columns : sequence of str
        The shape columns of the file.
    """
    wrong = [k for k, name in enumerate(columns) if (wiring.channels[k], wiring.signs[k]) != (name, 1)]
    reverse = [columns[k] for k in wrong if wiring.signs[k] < 0]
    moved = [columns[k] for k in wrong if wiring.channels[k] != columns[k]]
    if not moved and len(reverse) == 1:
        return f"{reverse[0]} is reversed"
    measures = ", ".join(
        f"{columns[k]} measures {'-' if wiring.signs[k] < 0 else ''}{wiring.channels[k]}" for k in wrong
    )
    if {wiring.channels[columns.index(name)] for name in moved} != set(moved):
        return measures  # one of them measures an axis that is not in the file
    if len(moved) == 2 and not reverse:
        return f"{words(moved)} are exchanged"
    if len(moved) > 2 and not reverse:
        return f"{words(moved)} are exchanged cyclically ({measures})"
    sensor = next((s for s in sensors if all(columns[k] in s.channels for k in wrong)), None)
    W = None if sensor is None else _axes(wiring, columns, sensor)
    if sensor is not None and W is not None and round(float(np.linalg.det(W))) == 1:
        which = (
            f"the sensor at the {sensor.place}" if sensor.place else f"the sensor of {words(sensor.channels)}"
        )
        return f"{which} is turned{_turn(W, sensor)} ({measures})"
    if not moved:
        return f"{words(reverse)} are {'both' if len(reverse) == 2 else 'all'} reversed"
    return f"{words(moved)} are exchanged and {words(reverse)} reversed ({measures})"


def simplicity(wiring: Wiring, columns: Sequence[str]) -> tuple[int, int]:
    """Return the numbers of columns that measure another channel, and that are reversed: fewest for the simplest."""
    moved = sum(channel != name for channel, name in zip(wiring.channels, columns, strict=True))
    return moved, sum(sign < 0 for sign in wiring.signs)


def remedy(wiring: Wiring, columns: Sequence[str]) -> str:
    """Return what to change in the file."""
    heads = [f"shape:{name}" for name in columns]
    reverse = [
        heads[k] for k, name in enumerate(wiring.channels) if name == columns[k] and wiring.signs[k] < 0
    ]
    changes = []
    for k, name in enumerate(wiring.channels):
        if name != columns[k]:
            sign = " and change the sign of its values" if wiring.signs[k] < 0 else ""
            changes.append(f"rename the column {heads[k]} to shape:{name}{sign}")
    if reverse:
        changes.append(f"change the sign of the column{'s' * (len(reverse) > 1)} {words(reverse)}")
    return ", ".join(changes)


def words(names: Sequence[str], last: str = "and") -> str:
    """Return names as words: "a, b and c"."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} {last} {names[-1]}"


def _turn(W: Array, sensor: Sensor) -> str:
    """Return the angle and axis of a turn about one of the sensor's axes or the normal of its plane; else empty."""
    trace = round(float(np.trace(W)))
    if trace == 1:
        about = 0.5 * np.array([W[1, 2] - W[2, 1], W[2, 0] - W[0, 2], W[0, 1] - W[1, 0]])
        angle = 90 * round(float(about.sum()))
    elif trace == -1 and np.count_nonzero(np.diag(W)) == 3:
        about, angle = (np.diag(W) > 0).astype(float), 180
    else:
        return ""
    axis = [*sensor.axes, _normal(sensor)][int(np.flatnonzero(about)[0])]
    return f" by {angle} degrees about {axis}"


def _axes(wiring: Wiring, columns: Sequence[str], sensor: Sensor) -> Array | None:
    """Return the sensor's axes as rows, (3, 3): of a right-handed sensor if one is not measured; None if unknown."""
    W: Array = np.zeros((3, 3))
    measured = [k for k, name in enumerate(columns) if name in sensor.channels]
    for k in measured:
        W[sensor.channels.index(columns[k]), sensor.channels.index(wiring.channels[k])] = wiring.signs[k]
    missing = np.flatnonzero(~W.any(axis=1))
    if len(missing) > 1:
        return None
    for row in missing:
        W[row] = np.cross(W[(row + 1) % 3], W[(row + 2) % 3])
        if len(sensor.channels) == 2:
            W[row, row] = 1.0
    return W


def _normal(sensor: Sensor) -> str:
    rest = {"x", "y", "z"} - set(sensor.axes)
    return rest.pop() if len(rest) == 1 else "the normal of its plane"
