"""Compare the published frequencies with the declared robot, and then with the identified robot.

Solves the declared robot along the centre line of the plane z = -245 mm, takes each mode's minimum and maximum
there, and prints them in the form of Tables 1 and 2 of the paper with their differences: the first residual.
Then prints the comparison with robots/linear-delta-2022-identified.toml at the poses of published-modes.csv, both
found by identify.py.

    python docs/studies/published_tables/residual.py robots/linear-delta-2022.toml
"""

from __future__ import annotations

import argparse
import importlib.util
import sys
from pathlib import Path

import numpy as np

import pkmodes
from before_after import print_before_after
from extremes import Extremes, centre_line, extremes, percent
from printed import Array, read_rows
from published_modes import frequencies

Z = -0.245
# The paper excludes "boundary effects" without saying where they begin.  Assumption: every free span of a
# belt is at least a tenth of the stroke long.
SHORTEST_SPAN = 0.12
IDENTIFIED = Path(__file__).parents[3] / "robots/linear-delta-2022-identified.toml"


def main() -> None:
    """Print the rows of Tables 1 and 2, the residual, and the comparison with the identified robot."""
    parser = argparse.ArgumentParser(description="Compare the published frequencies with the declared robot.")
    parser.add_argument("robot", type=Path)
    parser.add_argument("--generated", type=Path, help="folder of `pkmodes generate` to cross-check")
    arguments = parser.parse_args()

    robot = pkmodes.read_robot(arguments.robot)
    found = extremes(robot, centre_line(robot, Z, SHORTEST_SPAN))
    printed = {(row.point, row.mode): row.frequency for row in read_rows()}
    print_tables(robot, found, printed)
    rms, largest = percent(found.relative(printed))
    print(f"Residual of the declared robot: rms {rms:.1f} %, largest {largest:.1f} % (12 frequencies).")
    print(
        "The declared values, with the assumptions of the robot file, do not reproduce the paper's frequencies."
    )
    print_before_after(printed, found.frequency, frequencies(pkmodes.read_robot(IDENTIFIED)))
    print("For what changed and how it was found, see docs/explanation/published-tables.md.")
    if arguments.generated is not None:
        cross_check(arguments.generated, found.poses, found.modes.mass_matrix, found.modes.stiffness_matrix)


def print_tables(robot: pkmodes.Robot, found: Extremes, printed: dict[tuple[str, int], float]) -> None:
    """Print the extremes as the paper does, with the published frequencies."""
    x, modes = found.poses[:, 0], found.modes
    print(f"\n{robot.name}, centre line y = 0, z = {Z:g} m, x = {x[0]:.3f} to {x[-1]:.3f} m")
    print(f"(every free belt span at least {SHORTEST_SPAN:g} m: an assumption, the paper gives no bound)\n")
    radius = np.ones(len(modes.coordinates))
    radius[:3] = robot.parameters.pulley_radius
    names = [f"{name}/R_p" if name.startswith("x_") else name for name in modes.coordinates]
    for number, point in ((1, "minimum"), (2, "maximum")):
        print(f"Table {number}: modal vectors at the point of {point}")
        print("mode  x [m]   f [Hz]    paper     diff  " + " ".join(f"{name:>9}" for name in names))
        for mode in range(1, 7):
            index, f, paper = found.index[point, mode], found.frequency[point, mode], printed[point, mode]
            shape = modes.shapes[index, modes.rigid_modes + mode - 1] / radius
            shape /= np.abs(shape).max()
            components = " ".join(f"{0.0 if abs(c) < 1e-9 else c:9.2e}" for c in shape)
            print(
                f"{mode:4d} {x[index]:6.3f} {f:8.3f} {paper:8.3f} {100 * (f / paper - 1):+7.1f}%  {components}"
            )
        print()


def cross_check(folder: Path, poses: Array, mass: Array, stiffness: Array) -> None:
    """Import the generated module as a controller would, without pkmodes, and compare its matrices."""
    (module_file,) = folder.glob("*.py")
    spec = importlib.util.spec_from_file_location(module_file.stem, module_file)
    if spec is None or spec.loader is None:
        sys.exit(f"error: {module_file} cannot be imported")
    generated = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(generated)
    M, K = generated.modal_matrices(poses)
    error = max(
        np.abs(M - mass).max() / np.abs(mass).max(), np.abs(K - stiffness).max() / np.abs(stiffness).max()
    )
    print(f"\n{module_file} alone, at the same {len(poses)} poses: M and K equal to {error:.0e} relative.")


if __name__ == "__main__":
    main()
