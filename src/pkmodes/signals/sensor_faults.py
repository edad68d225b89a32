"""What the numbers of a signal show of its sensor: that its range was exceeded, or that it stopped."""

from __future__ import annotations

import numpy as np

from pkmodes.signals.functions import Array

#: Samples at an extreme value from which it is looked at, and how many times as many they are as at any of the next
#: values where the range was exceeded.  A sine has at most 2.4 times as many, noise has fewer.
FEWEST, MORE, NEXT = 10, 4.0, 3
#: Values are the same that differ by less than this part of the range: files round them.
ALIKE = 1e-6
#: An extreme value within this part of the range from the median is where the signal rests.
RESTING = 0.05
#: Part of a record for which a sensor that stopped keeps its value, and how many times as long as at any other time.
STOPPED, LONGER = 0.1, 10.0


def clipped(values: Array, fewest: int = FEWEST) -> tuple[tuple[float, ...], float]:
    """Return the extreme values at which a signal (N,) is cut off, and the share of its samples there.

    Many samples, at least the `fewest`, are at such a value, and few at the next ones.
    """
    cut, count, alike = list[float](), 0, ALIKE * float(np.ptp(values))
    for sign in (1.0, -1.0):
        level = sign * float((sign * values).max())
        there = int((np.abs(values - level) <= alike).sum())
        if there < fewest or abs(level - np.median(values)) <= RESTING * np.ptp(values):
            continue
        beside, most = level, 0
        for _ in range(NEXT):
            beyond = sign * values >= sign * beside - alike
            beside = sign * float(np.max(sign * values, where=~beyond, initial=-np.inf))
            most = max(most, int((np.abs(values - beside) <= alike).sum()))
        if there >= MORE * most:
            cut.append(level)
            count += there
    return tuple(cut), count / len(values)


def stopped(values: Array) -> slice | None:
    """Return the part of a signal (N,) in which it keeps one value, far longer than anywhere else; None for none."""
    changes = np.concatenate([[0], np.flatnonzero(values[1:] != values[:-1]) + 1, [len(values)]])
    lengths = np.diff(changes)
    longest = int(np.argmax(lengths))
    others = np.delete(lengths, longest)
    if lengths[longest] < STOPPED * len(values) or lengths[longest] < LONGER * others.max(initial=1):
        return None
    return slice(int(changes[longest]), int(changes[longest + 1]))
