"""Without the libraries of maps all else works, and a map names the command that installs what it lacks."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from helpers.robots.robot_text import PUBLISHED
from helpers.runs.processes import environment

BLOCKED = """
import sys
for name in {names!r}:
    sys.modules[name] = None
from pkmodes.cli import main
main()
"""


def python(code: str, *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code, *arguments],
        env=environment(),
        cwd=folder,
        capture_output=True,
        text=True,
    )


#: Each case is the library that is missing, and options of a map; a library that loads another comes after it.
CASES = [
    ("dask", ["--out", "map.nc"]),  # the first, because reading a robot loads it with pint
    ("distributed", ["--scheduler", "tcp://127.0.0.1:9"]),
    ("pyarrow", ["--out", "map.parquet"]),
    ("pandas", ["--out", "map.csv"]),
    ("xarray", []),
    ("xarray", ["--out", "map.nc"]),
    ("netCDF4", ["--out", "map.nc"]),
    ("zarr", ["--out", "map.zarr"]),
    ("zarr", ["--out", "map.nc"]),  # every map in progress is a Zarr group
    ("zarr", ["--out", "map.csv"]),
]
#: The extra of each library that is not one of ``map``.
EXTRAS = {"distributed": "cluster", "pyarrow": "parquet"}
#: Runs every case in a process of its own, forked before the library is loaded, and prints their exit codes.  What
#: was missing is loaded after its cases, so that the others need not load it each.
FORKED = """
import importlib, json, os, sys
import pkmodes.machine.maps.mapping
from pkmodes.cli import main
cases, arguments = json.loads(sys.argv[1]), sys.argv[2:]
codes = []
for number, (library, options) in enumerate(cases):
    child = os.fork()
    if not child:
        assert library not in sys.modules
        sys.modules[library] = None
        os.mkdir(f"work{number}")
        log = os.open(f"errors{number}", os.O_WRONLY | os.O_CREAT)
        os.dup2(log, 2)
        os.chdir(f"work{number}")
        main([*arguments, *options])
    codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    if library not in [name for name, _ in cases[number + 1 :]]:
        pkmodes.load(arguments[1])
        importlib.import_module(library)
print(json.dumps(codes))
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks")
def test_a_missing_library_is_named_before_anything_is_computed(tmp_path: Path) -> None:
    arguments = ["map", str(PUBLISHED), "--grid", "x=0.6,y=0,z=-0.245"]
    done = python(FORKED, json.dumps(CASES), *arguments, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1]) == [2] * len(CASES)
    for number, (library, options) in enumerate(CASES):
        case = (library, options)
        error = (tmp_path / f"errors{number}").read_text(encoding="utf-8")
        assert error.count("\n") == 1, case
        assert f"error: {library} is not installed; " in error, (case, error)
        assert f"pip install 'pkmodes[{EXTRAS.get(library, 'map')}]'" in error, case
        assert list((tmp_path / f"work{number}").iterdir()) == [], case


def test_other_commands_do_without(tmp_path: Path) -> None:
    names = ["xarray", "netCDF4", "zarr", "dask", "distributed", "pandas", "pyarrow"]
    command = ("modes", str(PUBLISHED), "--pose", "0.6,0,-0.245")
    done = python(BLOCKED.format(names=names), *command, folder=tmp_path)
    assert done.returncode == 0, done.stderr


def test_importing_pkmodes_imports_none_of_them(tmp_path: Path) -> None:
    code = (
        "import sys, pkmodes, pkmodes.cli; pkmodes.load(sys.argv[1]).frequencies([0.6, 0.0, -0.245]);"
        "print(*({'xarray', 'pandas', 'distributed', 'zarr', 'netCDF4', 'pyarrow', 'pkmodes.machine.maps.mapping'}"
        " & set(sys.modules)))"
    )
    done = python(code, str(PUBLISHED), folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, "\n"), done.stderr
