"""The memory of a map that is written to a file does not grow with the number of poses."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from helpers.runs.processes import ROOT, environment

#: Prints by how much the largest memory of the process grows in a large map after a small one [MB].
PROGRAM = """
import resource, sys
import numpy as np, pkmodes
from pkmodes.machine.maps.summary import summary_of
out, options = sys.argv[1], eval(sys.argv[2])
model = pkmodes.load("robots/linear-delta-2022.toml")

def peak(n):
    grid = {"x": np.linspace(0.1, 0.8, n), "y": np.linspace(-0.1, 0.1, 1000), "z": -0.245}
    with model.map(grid, out=out, overwrite=True, **options) as found:
        assert summary_of(found, None).poses == 1000 * n
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

small = peak(200)
print(peak(700) - small)
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="reads the memory as Linux reports it")
@pytest.mark.parametrize(("name", "options"), [("map.nc", "{}"), ("map.zarr", "{'shapes': True}")])
def test_from_200_to_700_thousand_poses_memory_hardly_grows(tmp_path: Path, name: str, options: str) -> None:
    """The larger map has 280 MB, with shapes 560 MB: 200 MB and 400 MB more than the small one."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(tmp_path / name), options],
        cwd=ROOT,
        env=environment(),
        capture_output=True,
        text=True,
        check=True,
    )
    assert float(done.stdout) < 120.0
