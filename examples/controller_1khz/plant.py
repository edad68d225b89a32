"""The machine behind the loop: what vibration the commands that the C program wrote leave, by `Model.simulate`.

    python examples/controller_1khz/plant.py ROBOT.toml COMMANDS.csv

The motors follow the commands exactly, and the machine rings about them in the modes of held motors.  `--softer 0.06`
makes the belts of the machine 6 % softer than those of the model that the shapers know.
"""

from __future__ import annotations

import argparse
import csv
from pathlib import Path

import numpy as np

import pkmodes

#: Damping ratio of the machine where the robot file has none.
DAMPING = 0.01
BELT = "belt.specific_stiffness"


def commands(path: Path) -> dict[str, list[tuple[np.ndarray, np.ndarray, float]]]:
    """Return, by shaper, the times and poses of every move, and when its last impulse has arrived."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    axes = [name for name in rows[0] if name not in ("shaper", "move", "time", "arrived")]
    moves: dict[tuple[str, str], list[list[float]]] = {}
    for row in rows:
        key = row["shaper"], row["move"]
        moves.setdefault(key, []).append([float(row[name]) for name in ("time", "arrived", *axes)])
    found: dict[str, list[tuple[np.ndarray, np.ndarray, float]]] = {}
    for (shaper, _), table in moves.items():
        values = np.array(table)
        end = float(values[values[:, 1] == 1.0, 0].min())
        found.setdefault(shaper, []).append((values[:, 0], values[:, 2:], end))
    return found


def main() -> None:
    """Simulate all moves and print, by shaper, the deviation that is left after them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robot", type=Path)
    parser.add_argument("commands", type=Path)
    parser.add_argument("--softer", type=float, default=0.0)
    given = parser.parse_args()
    model = pkmodes.load(given.robot)
    damping = None if model.robot.dissipates else DAMPING
    stiffness = model.robot.quantities[BELT].value
    model = model.with_values({BELT: (1.0 - given.softer) * stiffness})
    print(f"{'shaper':<24} {'worst [um]':>10} {'of none':>8} {'rms [um]':>9} {'of none':>8}")
    none: tuple[float, float] | None = None
    for shaper, moves in commands(given.commands).items():
        left = [model.simulate(t, p, damping=damping).largest(after=end) for t, p, end in moves]
        worst, rms = max(left), float(np.sqrt(np.mean(np.square(left))))
        none = none or (worst, rms)
        print(
            f"{shaper:<24} {1e6 * worst:10.1f} {worst / none[0]:8.4f} {1e6 * rms:9.1f} {rms / none[1]:8.4f}"
        )


if __name__ == "__main__":
    main()
