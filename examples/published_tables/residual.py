"""The published frequencies beside those that the declared robot gives: the first residual.

Solves the robot along the centre line of the plane z = -245 mm, takes each mode's minimum and maximum
there, and prints them in the form of Tables 1 and 2 of the paper, differences and all.

    python examples/published_tables/residual.py robots/linear-delta-2022.toml
"""

from __future__ import annotations

import argparse
import csv
import importlib.util
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import pkmodes
from pkmodes_generated import linear_delta

Y, Z = 0.0, -0.245
# The paper excludes "boundary effects" without saying where they begin.  Assumption: every free span of a
# belt is at least a tenth of the stroke long.
SHORTEST_SPAN = 0.12
STEP = 0.0005
TABLES = Path(__file__).with_name("tables.csv")


def main() -> None:
    """Print the rows of Tables 1 and 2 and what they leave unexplained."""
    parser = argparse.ArgumentParser(description="Published frequencies beside those of the declared robot.")
    parser.add_argument("robot", type=Path)
    parser.add_argument("--generated", type=Path, help="folder of `pkmodes generate` to cross-check")
    arguments = parser.parse_args()

    model = pkmodes.load(arguments.robot)
    line = centre_line(model)
    modes = model.modes(line)
    first = modes.rigid_modes
    print(
        f"\n{model.robot.name}, centre line y = {Y:g}, z = {Z:g} m, x = {line[0, 0]:.3f} to {line[-1, 0]:.3f} m"
    )
    print(f"(every free belt span at least {SHORTEST_SPAN:g} m: an assumption, the paper gives no bound)\n")

    radius = np.ones(len(modes.coordinates))
    radius[:3] = model.robot.parameters.pulley_radius
    published = read_tables()
    relative = []
    for point, pick in (("minimum", np.argmin), ("maximum", np.argmax)):
        print(f"Table {1 if point == 'minimum' else 2}: modal vectors at the point of {point}")
        names = [f"{name}/R_p" if name.startswith("x_") else name for name in modes.coordinates]
        print("mode  x [m]   f [Hz]    paper     diff  " + " ".join(f"{name:>9}" for name in names))
        for mode in range(1, 7):
            index = int(pick(modes.frequencies[:, first + mode - 1]))
            f = modes.frequencies[index, first + mode - 1]
            paper = published[point, mode]
            relative.append(f / paper - 1.0)
            shape = modes.shapes[index, first + mode - 1] / radius
            shape /= np.abs(shape).max()
            components = " ".join(f"{0.0 if abs(c) < 1e-9 else c:9.2e}" for c in shape)
            print(
                f"{mode:4d} {line[index, 0]:6.3f} {f:8.3f} {paper:8.3f} {100 * relative[-1]:+7.1f}%  {components}"
            )
        print()
    print(
        f"Residual of the declared robot: rms {100 * np.sqrt(np.mean(np.square(relative))):.1f} %, ", end=""
    )
    print(f"largest {100 * np.max(np.abs(relative)):.1f} % (12 frequencies).  The declared values, with the")
    print("assumptions of the robot file, do not give the paper's frequencies: docs/published-residual.md.")
    if arguments.generated is not None:
        cross_check(arguments.generated, line, modes.mass_matrix, modes.stiffness_matrix)


def centre_line(model: pkmodes.Model) -> NDArray[np.float64]:
    """Poses on the centre line that are within the assumed bound."""
    parameters = model.robot.parameters
    reach = parameters.link_length.max()
    x = np.arange(parameters.limits.min() - reach, parameters.limits.max() + reach, STEP)
    poses = np.column_stack([x, np.full_like(x, Y), np.full_like(x, Z)])
    with np.errstate(invalid="ignore"):  # out of reach a span is not a number, and so not long enough
        spans = linear_delta.belt_spans(poses, parameters)
    return poses[(spans >= SHORTEST_SPAN).all(axis=(1, 2))]


def read_tables() -> dict[tuple[str, int], float]:
    """Read the printed frequencies [Hz] by point and mode."""
    rows = csv.DictReader(text for text in TABLES.read_text(encoding="utf-8").splitlines() if text[0] != "#")
    return {(row["point"], int(row["mode"])): float(row["frequency"]) for row in rows}


def cross_check(
    folder: Path, poses: NDArray[np.float64], mass: NDArray[np.float64], stiffness: NDArray[np.float64]
) -> None:
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
