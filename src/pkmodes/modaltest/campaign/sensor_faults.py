"""Sensors at fault in a record of signals in time: cut off at the ends of their range, silent, or stopped."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.sensor_functions import dead_channel_messages
from pkmodes.modaltest.signals.functions import Array, Function
from pkmodes.modaltest.signals.sensor_faults import find_clipping

#: Minimum number of samples at an extreme value that are examined in records of blows, whose pulses are short.
MIN_CLIPPED_OF_BLOWS = 3
#: A sensor keeps running while another has stopped if it shows this fraction of its usual standard deviation there.
MIN_RUNNING_SHARE = 0.5


def overload_messages(name: str, values: Array, source: str, *, of_blows: bool) -> list[str]:
    """Return a message about a signal (N,) whose range was exceeded, none otherwise."""
    levels, share = find_clipping(values, MIN_CLIPPED_OF_BLOWS) if of_blows else find_clipping(values)
    if not levels:
        return []
    level_text = " and ".join(f"{level:.4g}" for level in levels)
    return [
        f"{source}: {name} is overloaded: {plain(100.0 * share, 2)} % of its samples are clipped at {level_text}, "
        "which changes shapes and damping: measure again with a larger range"
    ]


def find_silent_sensors(
    used: Sequence[Function], rests: Mapping[int, slice], time: Array, source: str
) -> tuple[set[int], list[str]]:
    """Return which signals are constant, or stopped while others went on, and a message about each.

    - rests: where signals keep one value, by index
    """
    faulty, messages = set[int](), list[str]()
    running = [signal for i, signal in enumerate(used) if i not in rests]
    for i, rest in rests.items():
        name = used[i].response
        if rest.stop - rest.start == time.size:
            faulty.add(i)
            messages += dead_channel_messages([name], source)
        elif any(
            np.std((values := signal.values.real)[rest]) >= MIN_RUNNING_SHARE * np.std(values)
            for signal in running
        ):
            faulty.add(i)
            first, last = time[rest.start], time[rest.stop - 1]
            messages.append(
                f"{source}: {name} keeps one value from {first:.4g} s to {last:.4g} s while others go on: this file "
                "gives no shape component of it"
            )
    return faulty, messages
