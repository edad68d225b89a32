"""Memory that the compiled evaluator takes besides poses and results: one number of poses, JSON on standard output.

python benchmarks/memory.py 1000000
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from published import published, valid_poses

STATUS = Path("/proc/self/status")


def largest() -> int:
    """Return the most memory that this process has used [bytes]; its parent's does not count."""
    (line,) = (line for line in STATUS.read_text(encoding="ascii").splitlines() if line.startswith("VmHWM"))
    return 1024 * int(line.split()[1])


def main(count: int) -> None:
    poses = np.resize(valid_poses(20_000), (count, 3))
    out = np.zeros((count, len(published().coordinates)))
    out[:] = 1.0  # all of its pages are there
    published().frequencies(poses[:30_000], out=out[:30_000], backend="compiled")
    before = largest()
    published().frequencies(poses, out=out, backend="compiled")
    print(json.dumps({"poses": count, "output": out.nbytes, "more": largest() - before}))


if __name__ == "__main__":
    if STATUS.is_file():
        main(int(sys.argv[1]))
    else:
        print("null")
