"""Sensors wired or mounted otherwise than the file says.

If the shapes disagree with the model, every wiring that a single mistake gives is tried, each with the modes paired
anew (`rewired`).  A mistake is reported if some wiring fits far better than the file's; it is named if no other
wiring fits nearly as well.

The axes of a sensor in the directions of the model are the rows of a signed permutation W.  If det W = 1, the sensor
is mounted in another direction: it is turned by R = W^T, by an angle with 1 + 2 cos(angle) = trace(R).  Otherwise
cables are exchanged or reversed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array, Instrumented, Sensor
from pkmodes.diagnosis.verdict.rewired import Misfit, Wiring, as_in_file, misfits, promising, wirings

#: Largest number of wirings that a sentence names.
MOST = 4


@dataclass(frozen=True)
class Rewired:
    """Wirings that fit far better than that of the file.

    Attributes
    ----------
    wirings : tuple of Wiring
        Up to the sign of all columns, the best one first.
    mistakes : tuple of tuple of str
        For each of them, the mistakes that give it, which shapes cannot tell apart.
    change : str
        What to change in the file for the first one.
    before, after : Misfit
        As in the file, and with the best wiring.
    certain : bool
        Whether the best one brings the shapes near to the errors of the measurement.
    explained : bool
        Whether it does so with the frequencies too.
    hint : str
        What else to check.
    """

    wirings: tuple[Wiring, ...]
    mistakes: tuple[tuple[str, ...], ...]
    change: str
    before: Misfit
    after: Misfit
    certain: bool
    explained: bool
    hint: str = ""

    @property
    def sentence(self) -> str:
        """What is wrong, how the misfit changes, and what to do."""
        size = (
            f"the shapes differ from the model by {_percent(self.before)} of their largest component as in the file, "
            f"by {_percent(self.after)} with this corrected"
        )
        some = [words(mistakes, "or") for mistakes in self.mistakes[:MOST]]
        if len(self.mistakes) == 1:
            seems = "" if self.certain else "it seems that "
            also = "" if self.explained else "; something else is wrong too: correct this, and diagnose again"
            same = " (for shapes, which have any sign, the same)" if len(self.mistakes[0]) > 1 else ""
            return f"{seems}{some[0]}{same}: {size}; {self.change}{self.hint}{also}"
        if len(self.mistakes) > MOST:
            some.append(f"{len(self.mistakes) - MOST} others")
        return (
            "sensors are exchanged, reversed or turned, and these data do not tell which: "
            f"{'; '.join(some[:-1])}; or {some[-1]} ({size}); "
            "check cables and mountings, then correct the columns of the shapes"
        )


def rewired(fitter: Fitter, fit: Fit) -> Rewired | None:
    """Return the wirings that fit far better than that of the file; None if there is none.

    Parameters
    ----------
    fit : Fit
        Of the file as it is.
    """
    if not _doubtful(fitter, fit):
        return None
    c, columns = fitter.criteria, fitter.data.channels
    sensors = tuple(fitter.structure.sensors) if isinstance(fitter.structure, Instrumented) else ()
    tried = wirings(columns, sensors)
    if not tried or not promising(fitter, fit, tuple(tried), c.readings.rewired_perhaps):
        return None
    found = misfits(fitter, fit, tuple(tried), c.readings.rewired_refits, c.readings.rewired_near)
    here = found.pop(as_in_file(columns))
    complete = min(misfit.per_value[0] for misfit in (here, *found.values())) < c.readings.rewired_noise
    evidence = {wiring: misfit.evidence(complete) for wiring, misfit in found.items()}
    order = sorted(evidence, key=evidence.__getitem__)
    best = found[order[0]]
    gain = here.evidence(complete) - evidence[order[0]]
    if here.shapes < c.readings.rewired * best.shapes or gain < c.readings.rewired_certain:
        return None
    remaining = [w for w in order if evidence[w] - evidence[order[0]] < c.readings.rewired_told_apart]
    mistakes = tuple(_mistakes(tried[wiring], columns, sensors) for wiring in remaining)
    certain = best.per_value[1] < c.readings.rewired_noise and best.difference < c.shapes.most_scatter / 2.0
    simplest = min(tried[order[0]], key=lambda wiring: simplicity(wiring, columns))
    return Rewired(
        tuple(remaining),
        mistakes,
        remedy(simplest, columns),
        here,
        best,
        certain,
        certain and best.per_value[0] < c.readings.rewired_noise,
        _hint(simplest, columns, sensors) if len(remaining) == 1 else "",
    )


def _mistakes(same: Sequence[Wiring], columns: Sequence[str], sensors: Sequence[Sensor]) -> tuple[str, ...]:
    """Return what is wrong: the simplest of several mistakes that shapes cannot tell apart, and turned sensors."""
    first, *others = sorted(same, key=lambda wiring: simplicity(wiring, columns))
    texts = [described(first, columns, sensors)]
    texts += [text for other in others if " is turned by " in (text := described(other, columns, sensors))]
    return tuple(texts)


def _doubtful(fitter: Fitter, fit: Fit) -> bool:
    """Return whether the shapes differ from the model by more than their stated errors, or visibly."""
    for stated, most in ((True, fitter.criteria.readings.rewired_misfit), (False, None)):
        squares, degrees = fitter.shape_misfit(fit, stated=stated)
        if degrees < 1.0:
            continue
        ratio = squares / degrees
        visible = (fitter.criteria.readings.rewired_scatter / fitter.shape_scatter) ** 2
        if ratio > (visible if most is None else most):
            return True
    return False


def _hint(wiring: Wiring, columns: Sequence[str], sensors: Sequence[Sensor]) -> str:
    """Return what else to check if one axis of a sensor is reversed."""
    if wiring.channels != tuple(columns) or sum(np.array(wiring.signs) < 0) != 1:
        return ""
    name = columns[wiring.signs.index(-1)]
    for sensor in sensors:
        if name in sensor.channels and sensor.place:
            axis = sensor.axes[sensor.channels.index(name)]
            return f", or check the sensor's direction and the sign of {axis} in the poses"
    return ", or check the sensor's direction"


def _percent(misfit: Misfit) -> str:
    return f"{100 * misfit.difference:.2g} %"


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
