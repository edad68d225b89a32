"""Without the libraries of the extra ``map`` all else works, and a map names the command that installs them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from helpers.commands.map_runs import ROOT
from helpers.robots.robot_text import PUBLISHED

BLOCKED = """
import sys
for name in {names!r}:
    sys.modules[name] = None
from pkmodes.cli import main
main()
"""


def ran(names: list[str], *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    paths = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    return subprocess.run(
        [sys.executable, "-c", BLOCKED.format(names=names), *arguments],
        env={**os.environ, "PYTHONPATH": paths},
        cwd=folder,
        capture_output=True,
        text=True,
    )


@pytest.mark.parametrize(
    ("library", "options"),
    [
        ("xarray", []),
        ("xarray", ["--out", "map.nc"]),
        ("netCDF4", ["--out", "map.nc"]),
        ("dask", ["--out", "map.nc"]),
        ("zarr", ["--out", "map.zarr"]),
        ("pyarrow", ["--out", "map.csv"]),
        ("pyarrow", ["--out", "map.parquet"]),
        ("pandas", ["--out", "map.csv"]),
        ("distributed", ["--scheduler", "tcp://127.0.0.1:9"]),
    ],
)
def test_a_missing_library_is_named_before_anything_is_computed(
    tmp_path: Path, library: str, options: list[str]
) -> None:
    grid = ["--grid", "x=0.6,y=0,z=-0.245"]
    done = ran([library], "map", str(PUBLISHED), *grid, *options, folder=tmp_path)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert f"error: {library} is not installed; " in done.stderr, done.stderr
    assert "pip install 'pkmodes[map]'" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_other_commands_do_without(tmp_path: Path) -> None:
    names = ["xarray", "netCDF4", "zarr", "dask", "distributed", "pandas", "pyarrow"]
    done = ran(names, "modes", str(PUBLISHED), "--pose", "0.6,0,-0.245", folder=tmp_path)
    assert done.returncode == 0, done.stderr


def test_importing_pkmodes_imports_none_of_them(tmp_path: Path) -> None:
    code = (
        "import sys, pkmodes, pkmodes.cli; pkmodes.load(sys.argv[1]).frequencies([0.6, 0.0, -0.245]);"
        "print(*({'xarray', 'pandas', 'distributed', 'zarr', 'netCDF4', 'pyarrow', 'pkmodes.maps.mapping'}"
        " & set(sys.modules)))"
    )
    paths = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    done = subprocess.run(
        [sys.executable, "-c", code, str(PUBLISHED)],
        env={**os.environ, "PYTHONPATH": paths},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == "\n"
