"""Times that can be compared: interleaved repetitions, and the smallest of each."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

REPETITIONS = 9
#: A turn takes about this long [s], and a call at most, unless few poses take longer.
LONG = 0.15


#: Clocks: of this process, which other processes on the same core do not move, and of the wall, for several cores.
PROCESS, WALL = time.process_time, time.perf_counter
Clock = Callable[[], float]


def seconds(call: Callable[[], object], clock: Clock = PROCESS) -> float:
    start = clock()
    call()
    return clock() - start


def interleaved(
    calls: Mapping[str, Callable[[], object]], repetitions: int = REPETITIONS, clock: Clock = PROCESS
) -> dict[str, float]:
    """Time calls in turn, so that a disturbance meets all of them; return the smallest times [s].

    A turn takes as long as a long call: short calls are repeated in it, so the caches are theirs.
    """
    best = dict.fromkeys(calls, float("inf"))
    for _ in range(repetitions):
        for name, call in calls.items():
            end = time.perf_counter() + LONG
            while True:
                best[name] = min(best[name], seconds(call, clock))
                if time.perf_counter() > end:
                    break
    return best


def affordable(run: Callable[[int], object], most: int, least: int = 16) -> int:
    """Return how many poses `run` can evaluate in `LONG`; compilation is over afterwards."""
    run(least)
    each = min(seconds(lambda: run(least)) for _ in range(3)) / least
    count = int(min(max(LONG / each, least), most))
    run(count)
    return count
