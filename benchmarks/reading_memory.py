"""Memory that reading a file of measured signals takes, in sizes of the file (docs/reference/campaign-file.md).

    PYTHONPATH=tests python benchmarks/reading_memory.py

Each file has about 20 MB, and is read in a process of its own; what unpacks to very much more is a small file.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from signals.hostile import CAN_MEASURE, CASES, taken

SIZE, LIMIT, MEGABYTE = 20_000_000, 600.0, 1e6


def main() -> None:
    print("| file | size | memory | comes to |\n| --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for number, (name, of) in enumerate(CASES.items()):
            path = Path(folder) / f"{number}{of.suffix}"
            of.write(path, SIZE)
            size = path.stat().st_size
            (found,) = taken({path: of}, LIMIT)
            memory = f"{found.memory / size:.1f} times" if of.sound else f"{found.memory / MEGABYTE:.0f} MB"
            print(
                f"| {name} | {size / MEGABYTE:.2g} MB | {memory} | {'refused' if found.outcome else 'read'} |"
            )
            path.unlink()


if __name__ == "__main__":
    if CAN_MEASURE:
        main()
    else:
        print("needs the memory of a process as Linux tells it")
