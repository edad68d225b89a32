"""Time of the functions that controllers call, per pose: modes of motors free to turn, and of motors held.

    python benchmarks/controller.py

Compiled by `cc -O2`, on one core.  `vibration` (motors held) takes at most the time of `modes`.
"""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.codegen.generation import generate

HERE = Path(__file__).parent
#: Each robot with a box of poses.
ROBOTS = {
    "linear-delta-2022": ((0.3, -0.1, -0.25), (0.9, 0.1, -0.16)),
    "linear-delta-2022-identified": ((0.3, -0.1, -0.25), (0.9, 0.1, -0.16)),
    "clavel-delta": ((-0.3, -0.3, -0.7), (0.3, 0.3, -0.4)),
    "corexy-printer": ((0.02, 0.02), (0.28, 0.28)),
}
FUNCTIONS = ("natural_frequencies", "modes", "vibration")


def times(robot: Path, box: tuple[tuple[float, ...], tuple[float, ...]], folder: Path) -> list[float]:
    """Return the time of each function [us]."""
    generate(robot, folder)
    name = robot.stem.replace("-", "_")
    poses = np.random.default_rng(7).uniform(*box, (1000, len(box[0])))
    poses = poses[pkmodes.load(robot).check(poses).valid]
    rows = ",\n".join("    {" + ", ".join(map(repr, p)) + "}" for p in poses.tolist())
    text = f'#include "{name}.h"\n' + "".join(f"#define robot_{f} {name}_{f}\n" for f in FUNCTIONS)
    upper = name.upper()
    text += f"enum {{ MODES = {upper}_COORDINATES, HELD = {upper}_HELD_MODES, POSES = {len(poses)} }};\n"
    text += f"static const double poses[POSES][{upper}_POSE] = {{\n{rows}}};\n"
    (folder / "robot.h").write_text(text, encoding="utf-8")
    files = [str(HERE / "controller.c"), str(folder / f"{name}.c")]
    subprocess.run(
        ["cc", "-std=c99", "-O2", f"-I{folder}", *files, "-lm", "-o", str(folder / "program")], check=True
    )
    printed = subprocess.run([str(folder / "program")], check=True, capture_output=True, text=True).stdout
    return [float(each) for each in printed.split()]


def main() -> None:
    print(f"{'us per pose':30s}" + "".join(f"{f:>21s}" for f in FUNCTIONS) + f"{'vibration / modes':>20s}")
    for name, box in ROBOTS.items():
        with tempfile.TemporaryDirectory() as folder:
            found = times(Path(f"robots/{name}.toml"), box, Path(folder))
        print(f"{name:30s}" + "".join(f"{t:21.2f}" for t in found) + f"{found[2] / found[1]:20.2f}")


if __name__ == "__main__":
    main()
