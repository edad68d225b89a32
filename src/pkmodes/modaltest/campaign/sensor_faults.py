"""Sensors at fault in a record of signals in time: cut off at the ends of their range, silent, or stopped."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.sensor_functions import dead_channels
from pkmodes.modaltest.signals.functions import Array, Function
from pkmodes.modaltest.signals.sensor_faults import clipped

#: Fewest samples at an extreme value that are examined in records of blows, whose pulses are short.
OF_BLOWS = 3
#: A sensor keeps running while another has stopped if it shows this fraction of its usual standard deviation there.
GOES_ON = 0.5


def overloads(name: str, values: Array, source: str, *, of_blows: bool) -> list[str]:
    """Return a message about a signal (N,) whose range was exceeded, none otherwise."""
    levels, share = clipped(values, OF_BLOWS) if of_blows else clipped(values)
    if not levels:
        return []
    at = " and ".join(f"{level:.4g}" for level in levels)
    return [
        f"{source}: {name} is overloaded: {plain(100.0 * share, 2)} % of its samples are clipped at {at}, which "
        "changes shapes and damping: measure again with a larger range"
    ]


def silent(
    used: Sequence[Function], rests: Mapping[int, slice], time: Array, source: str
) -> tuple[set[int], list[str]]:
    """Return which signals are constant, or stopped while others went on, and a message about each.

    - rests: where signals keep one value, by index
    """
    faulty, messages = set[int](), list[str]()
    moving = [signal for i, signal in enumerate(used) if i not in rests]
    for i, rest in rests.items():
        name = used[i].response
        if rest.stop - rest.start == time.size:
            faulty.add(i)
            messages += dead_channels([name], source)
        elif any(_goes_on(signal.values.real, rest) for signal in moving):
            faulty.add(i)
            first, last = time[rest.start], time[rest.stop - 1]
            messages.append(
                f"{source}: {name} keeps one value from {first:.4g} s to {last:.4g} s while others go on: this file "
                "gives no shape component of it"
            )
    return faulty, messages


def _goes_on(values: Array, rest: slice) -> bool:
    return bool(np.std(values[rest]) >= GOES_ON * np.std(values))
