"""Times of maps of the published robot, in one run: ``python benchmarks/map.py``.

The ratios are those of docs/how-to/maps.md.  Calls alternate, and each time is the best of three; the ratios compare
with the modes alone at the same poses (frequencies, motions of the platform and joint positions, all cores).
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import pkmodes
from pkmodes.core.solve.backends import available_cores
from timing import WALL, interleaved

ROBOT = Path(__file__).parents[1] / "robots" / "linear-delta-2022.toml"
FIELDS = ("frequencies", "platform_shapes", "joint_positions")
REPEATS = 3


def grid(count: int) -> dict[str, Any]:
    return {"x": np.linspace(0.3, 0.8, count), "y": np.linspace(-0.1, 0.1, count), "z": -0.245}


def main() -> None:
    """Measure and print the table."""
    model = pkmodes.load(ROBOT)
    uncertain = model.with_values({"platform.mass": {"sigma": "3 %"}, "link.length": {"sigma": "1 mm"}})
    large, small = grid(1000), grid(300)

    def modes(count: int) -> Callable[[], Any]:
        x, y = np.meshgrid(np.linspace(0.3, 0.8, count), np.linspace(-0.1, 0.1, count))
        poses = np.stack([x, y, np.full_like(x, -0.245)], axis=-1)
        return lambda: model.modes(poses, "nan", fields=FIELDS)

    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        model.map(grid(2), out=place / "first.nc").close()  # load the libraries
        model.map(grid(2), out=place / "first.zarr").close()
        large_jobs = {
            "modes alone": modes(1000),
            "map in memory": lambda: model.map(large),
            "written as NetCDF": lambda: model.map(large, out=place / "map.nc", overwrite=True).close(),
            "written as Zarr": lambda: model.map(large, out=place / "map.zarr", overwrite=True).close(),
        }
        small_jobs = {
            "modes alone": modes(300),
            "map in memory": lambda: model.map(small),
            "tracked": lambda: model.map(small, tracked=True),
            "200 samples of 450 poses": lambda: uncertain.map(samples_grid(), samples=200),
        }
        print(f"{available_cores()} cores\n")
        print("| | poses | time [s] | against modes alone |\n| --- | --- | --- | --- |")
        for poses, jobs in ((1_000_000, large_jobs), (90_000, small_jobs)):
            took = interleaved(jobs, REPEATS, WALL)
            for name, seconds in took.items():
                print(
                    f"| {name} | {poses:,} | {seconds:.2f} | {seconds / took['modes alone']:.1f} |",
                    flush=True,
                )


def samples_grid() -> dict[str, Any]:
    return {"x": np.linspace(0.3, 0.8, 30), "y": np.linspace(-0.1, 0.1, 15), "z": -0.245}


if __name__ == "__main__":
    main()
