"""Time and memory of `pkmodes identify`: a campaign of some size, and a universal file of 1 GB.

    python benchmarks/campaign.py

The campaign has 4 poses, 4 repeats and 6 sensors, 1,560 lines each, and a robot; the file of 1 GB has 8 channels in
single precision, of which the campaign names one or all.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.signal import lfilter

import pkmodes
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.identify import identify
from timing import seconds

ROBOT = Path(__file__).parents[1] / "robots/linear-delta-2022.toml"
POSES = [[0.5, 0.0, -0.245], [0.6, 0.05, -0.245], [0.7, -0.05, -0.22], [0.8, 0.03, -0.24]]
OUTPUTS = ["p_x", "p_y", "p_z", "x_1", "x_2", "x_3"]
REPEATS, LINES, NOISE, SEED = 4, np.arange(10.0, 400.0, 0.25), 0.01, 20261123
MEGABYTE = 1e6
#: Channels of the large file, samples of each, and samples a second.
CHANNELS, SAMPLES, RATE = 8, 32_000_000, 12_800
MEASURE = """
import resource, sys
from pkmodes.cli import run
code = run(sys.argv[1:])
print(code, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def write_campaign(folder: Path) -> Path:
    """Write frequency response functions of a linear delta with held motors, with noise."""
    machine = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.01})
    rng, records = np.random.default_rng(SEED), []
    for p, pose in enumerate(POSES):
        H = machine.frf(pose, LINES, ["force_x"], OUTPUTS, drives="held", quantity="acceleration").values[
            :, :, 0
        ]
        names = [f"P{p}_{repeat}.csv" for repeat in range(REPEATS)]
        for name in names:
            level = NOISE * np.sqrt((np.abs(H) ** 2).mean(axis=0) / 2.0)
            parts = H + level * (rng.normal(size=H.shape) + 1j * rng.normal(size=H.shape))
            columns = [LINES, *(part for h in parts.T for part in (h.real, h.imag))]
            head = ["frequency", *(f"{part}:{output}" for output in OUTPUTS for part in ("re", "im"))]
            np.savetxt(
                folder / name, np.column_stack(columns), delimiter=",", header=",".join(head), comments=""
            )
        at = ", ".join(f'{axis} = "{value} m"' for axis, value in zip("xyz", pose, strict=True))
        records.append(f'[[record]]\npose = "P{p}"\nat = {{ {at} }}\nkind = "frf"\nfiles = {names}\n')
    sensors = [f'[[sensor]]\nname = "{name}"\nchannel = "{name}"\nunit = "m/s^2"\n' for name in OUTPUTS]
    head = f'format = 1\nrobot = "{ROBOT}"\nband = ["15 Hz", "390 Hz"]\ndrives = "held"\n'
    path = folder / "campaign.toml"
    path.write_text("\n".join([head, *sensors, *records]), encoding="utf-8")
    return path


def write_large(path: Path) -> None:
    """Write a universal file 58b: responses of an oscillator at 40 Hz to noise, in every channel with other noise."""
    rng = np.random.default_rng(SEED)
    pole = np.exp(2.0 * np.pi * 40.0 * (-0.01 + 1j) / RATE)
    recursion = [1.0, -2.0 * pole.real, abs(pole) ** 2]
    with path.open("wb") as file:
        for channel in range(CHANNELS):
            state, force = np.zeros(2), np.random.default_rng(SEED + 1)
            header = [
                f"    58b{1:6d}{2:6d}{11:12d}{4 * SAMPLES:12d}{0:6d}{0:6d}{0:12d}{0:12d}",
                *["NONE"] * 5,
                f"{1:5d}{1:10d}{0:5d}{0:10d} {'NONE':>10}{channel + 1:10d}{1:4d} {'NONE':>10}{0:10d}{0:4d}",
                f"{2:10d}{SAMPLES:10d}{1:10d}{0.0:13.5E}{1.0 / RATE:13.5E}{0.0:13.5E}",
                f"{17:10d}{0:5d}{0:5d}{0:5d} {'NONE':20} {'s':20}",
                f"{12:10d}{0:5d}{0:5d}{0:5d} {'NONE':20} {'m/s^2':20}",
                *[f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':20} {'NONE':20}"] * 2,
            ]
            file.write(("    -1\n" + "\n".join(header) + "\n").encode())
            for _ in range(SAMPLES // 1_000_000):
                moved, state = lfilter([1.0, -1.0], recursion, force.standard_normal(1_000_000), zi=state)
                noisy = (channel + 1) * moved + rng.standard_normal(1_000_000)
                file.write(noisy.astype(np.float32).tobytes())
            file.write(b"\n    -1\n")


def memory(folder: Path, sensors: Sequence[int]) -> tuple[float, float]:
    """Return the most memory of `identify` for some channels of the large file [bytes], and its time [s]."""
    listed = [f'[[sensor]]\nname = "{n}:+X"\nchannel = "c_{n}"\nunit = "m/s^2"\n' for n in sensors]
    names = [f"c_{n}" for n in sensors]
    path = folder / "large.toml"
    record = '[[record]]\npose = "A"\nkind = "ambient"\nfiles = ["large.uff"]\n'
    head = f'format = 1\nchannels = {names}\nband = ["20 Hz", "100 Hz"]\n'
    path.write_text("\n".join([head, *listed, record]), encoding="utf-8")
    arguments = ["identify", str(path), "--out", str(folder / "modes.csv")]
    start = time.perf_counter()
    run = subprocess.run(
        [sys.executable, "-c", MEASURE, *arguments], capture_output=True, text=True, check=True
    )
    code, kilobytes = run.stdout.split()[-2:]
    if code != "0":
        raise RuntimeError(run.stderr)
    return 1024.0 * float(kilobytes), time.perf_counter() - start


def main() -> None:
    with tempfile.TemporaryDirectory() as name, one_blas_thread():
        folder = Path(name)
        declared = write_campaign(folder)
        taken = seconds(lambda: identify(read_campaign(declared)))
        print(f"{len(POSES)} poses, {REPEATS} repeats, {len(OUTPUTS)} sensors: {taken:.1f} s on one core")
        large = folder / "large.uff"
        write_large(large)
        for sensors in ([1], range(1, CHANNELS + 1)):
            most, wall = memory(folder, list(sensors))
            print(
                f"universal file of {large.stat().st_size / MEGABYTE:.0f} MB, {len(sensors)} of {CHANNELS} channels: "
                f"{most / MEGABYTE:.0f} MB, {wall:.0f} s"
            )


if __name__ == "__main__":
    main()
