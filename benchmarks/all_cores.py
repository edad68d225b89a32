"""The ways that can use several cores, on all of them: what `backends.py` runs second, writing JSON.

Time on the wall says what a second core is worth only if both are idle, so the processor time of two threads is
measured too: it says how many cores they got.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np

import ours
from peers import MissingError, ways
from pkmodes.core.solve.backends import available_cores
from published import published, valid_poses
from timing import REPETITIONS, WALL, interleaved


def main(target: Path, quick: bool) -> None:
    cores = available_cores()
    sizes = {True: 200_000, False: 1_000_000}
    poses = np.resize(valid_poses(20_000), (sizes[quick], 3))
    frequencies = np.zeros((len(poses), len(published().coordinates)))
    some = 20_480
    runs, counts, missing = {}, {}, []
    for way in ways(cores):
        if isinstance(way, MissingError):
            missing.append(str(way))
            continue
        runs[way.label] = lambda way=way: way.run(poses[:some], frequencies[:some], None)
        counts[way.label] = some
    for threads in sorted({1, 2, cores}):
        way = ours.compiled(threads)
        name = f"{way.label}, {threads}"
        runs[name] = lambda way=way: way.run(poses, frequencies, None)
        counts[name] = len(poses)
    for run in runs.values():
        run()
    times = interleaved(runs, 5 if quick else 2 * REPETITIONS, WALL)
    found = {"cores": cores, "poses": len(poses), "missing": missing}
    found["processor"] = processor(poses, frequencies)
    found["times"] = {name: 1e6 * time / counts[name] for name, time in times.items()}
    target.write_text(json.dumps(found, indent=1), encoding="utf-8")


def processor(poses: np.ndarray, frequencies: np.ndarray) -> float:
    """Return the processor time of two threads [s]."""
    best = float("inf")
    for _ in range(5):
        start = time.process_time()
        ours.compiled(2).run(poses, frequencies, None)
        best = min(best, time.process_time() - start)
    return best


if __name__ == "__main__":
    main(Path(sys.argv[1]), "--quick" in sys.argv)
