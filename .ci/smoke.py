"""Run an installed pkmodes from another folder: what works without extras (``core``), or what an extra adds.

Robot files and measurements are those that it brings (``pkmodes examples``).
``.ci/floors`` runs it with the oldest and with the newest versions that may be installed.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from importlib.metadata import metadata, requires, version
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.cli import run
from pkmodes.mechanism import names

ROOT = Path(__file__).resolve().parents[1]
DELTA = "robots/linear-delta-2022.toml"
LOOP = "examples/closed_loop"
POSE = (0.6, 0.0, -0.245)
AT = f"{DELTA} --pose 0.6,0,-0.245"
GRID = f"{DELTA} --grid x=0.5:0.6:4,y=0:0.1:4,z=-0.245"
#: Frequencies that README.md shows at that pose [Hz].
EXPECTED = 55.559, 60.316, 61.545, 130.801, 133.831, 134.257
COMMANDS = {
    "core": f"""
        modes {AT} --json modes.json
        sensitivities {AT} --parameters platform.mass,axis.span
        response {AT} --drives held --inputs motor_1,force_x --outputs p_x,p_z --frequencies 5:400:100
        show {DELTA} --out robot.html
        shaper {GRID}
        identify examples/campaign/campaign.toml --out identified.csv
        compare {LOOP}/robot.toml {LOOP}/measured.csv
        diagnose {LOOP}/robot.toml {LOOP}/measured.csv --save-robot corrected.toml
        """,
    "map": "\n".join(f"map {GRID} --out map{suffix}" for suffix in (".nc", ".zarr", ".csv")),
    "parquet": f"map {GRID} --out map.parquet",
    "cluster": "",
    "plot": f"""
        figures {GRID} --out figures
        show {AT} --mode 2 --out mode.gif
        """,
    "report": f"""
        map {GRID} --report map.html
        diagnose {LOOP}/robot.toml {LOOP}/measured.csv --report diagnosis.html
        """,
    "control": "",
    "hdf5": "",
    "zstd": "",
    "derive": f"""
        generate {DELTA} --out generated
        check generated
        """,
}


def main(extra: str, resolution: str) -> None:
    """Run the commands of an extra, and compare frequencies with those that are documented."""
    if ROOT in Path(pkmodes.__file__).parents:
        sys.exit("error: this is the checkout, not an installed pkmodes (smoke.py)")
    python = f"Programming Language :: Python :: {sys.version_info.major}.{sys.version_info.minor}"
    if resolution == "lowest-direct" and python in metadata("pkmodes").get_all("Classifier"):
        expect_floors(extra)
    subprocess.run(
        [Path(sys.executable).with_name("pkmodes"), "--help"], check=True, stdout=subprocess.DEVNULL
    )
    assert run([]) == run(["modes"]) == 2, "a mistake is an error of one line, or the help"
    assert run(["examples", "all"]) == 0
    for file in (*(ROOT / "robots").iterdir(), *(ROOT / LOOP).iterdir()):
        assert file.read_bytes() == Path(file.relative_to(ROOT)).read_bytes()
    for mechanism in names() if extra == "core" else ():
        assert run(["new", mechanism, "--out", f"{mechanism}.toml"]) == 0
        assert run(["show", f"{mechanism}.toml"]) == 0
    for command in COMMANDS[extra].strip().splitlines():
        if code := run(shlex.split(command)):
            sys.exit(f"error: exit code {code} (pkmodes {command.strip()})")
    model = pkmodes.load(DELTA)
    for backend in ("numpy",) if sys.platform == "win32" else ("compiled", "numpy"):
        np.testing.assert_allclose(model.frequencies(POSE, backend=backend)[3:], EXPECTED, atol=1e-3)
    if extra == "cluster":
        on_workers(model)
    if extra == "control":
        system = model.state_space(POSE, inputs="torque_1", outputs="p_x").to_control()
        assert abs(np.abs(system.poles()).max() / (2 * np.pi) - EXPECTED[-1]) < 1e-3


def expect_floors(extra: str) -> None:
    """Expect of everything needed exactly the oldest version that is declared."""
    for need in requires("pkmodes") or ():
        name, floor, where = re.fullmatch(
            r"([\w-]+)(?:>=([\d.]+))?[^;]*(?:; extra == '(\w+)')?", need
        ).groups()
        if floor and (where or "core") in ("core", extra):
            found, declared = (re.sub(r"(\.0)+$", "", text) for text in (version(name), floor))
            assert found == declared, f"{name} {found} is installed where {floor} is declared"


def on_workers(model: pkmodes.Model) -> None:
    """Evaluate a map on a scheduler of Dask."""
    from distributed import LocalCluster

    with LocalCluster(n_workers=1, processes=False, dashboard_address=None, protocol="tcp://") as cluster:
        here = model.map({"x": [0.5, 0.6], "y": 0.0, "z": -0.245})
        there = model.map({"x": [0.5, 0.6], "y": 0.0, "z": -0.245}, scheduler=cluster.scheduler_address)
    assert here.identical(there)


if __name__ == "__main__":
    main(*sys.argv[1:])
