"""What input shapers leave of the vibration after moves: simulated, for belts as declared and 6 % softer.

``python docs/studies/shaped_moves/table.py`` writes the table of docs/how-to/shapers.md; ``--moves N`` prints it for
fewer.

A hundred straight moves between random poses of a box, as fast as 1 m/s and 15 m/s^2 allow, of the identified linear
delta with a damping ratio of 1 %.  Fixed shapers are the best ones over a grid in the box; the others are designed
for the pose commanded at each moment.  All are designed for the belts as declared.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.machine.shaping import Shaper
from pkmodes_rig.moves import StraightMove

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs/how-to/shapers.md"
BEGIN, END = "<!-- begin: written by docs/studies/shaped_moves/table.py -->", "<!-- end -->"
ROBOT = ROOT / "robots/linear-delta-2022-identified.toml"
BOX = {"x": (0.32, 0.82), "y": (-0.1, 0.1), "z": (-0.24, -0.16)}
GRID = (11, 5, 5)
SEED, MOVES, SHORTEST = 20261123, 100, 0.05
TICK, SETTLING = 1e-3, 0.3
KINDS = ("zv", "mzv", "zvd", "2hump_ei", "3hump_ei", "zv*zv*zv")
#: Belts that are softer than declared, of which the shapers do not know.
SOFTER = 0.94


@dataclass(frozen=True)
class Left:
    """What one shaper leaves, relative to the worst move without one.

    Attributes
    ----------
    predicted : float
        At the worst pose of the grid; NaN where it follows the pose.
    worst, rms : float
        Largest and root mean square deviation after the moves.
    softer : float
        The largest one with softer belts.
    longest : float
        Duration of the longest shaper [s].
    """

    predicted: float
    worst: float
    rms: float
    softer: float
    longest: float


def moves(count: int, model: pkmodes.Model) -> Iterator[StraightMove]:
    """Yield random moves inside the box."""
    rng = np.random.default_rng(SEED)
    low, high = np.array(list(BOX.values())).T
    while count:
        start, target = rng.uniform(low, high, (2, 3))
        move = StraightMove(start, target)
        if move.distance > SHORTEST and model.check(np.linspace(start, target, 30)).valid.all():
            count -= 1
            yield move


def study(count: int = MOVES) -> dict[tuple[str, bool], Left]:
    """Return what shapers leave, by kind and by whether they follow the pose."""
    declared = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.01})
    stiffness = declared.robot.quantities["belt.specific_stiffness"].value
    softer = declared.with_values({"belt.specific_stiffness": SOFTER * stiffness})
    axes = [np.linspace(*ends, n) for ends, n in zip(BOX.values(), GRID, strict=True)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    fixed = {one.kind: one for one in declared.shapers(grid, KINDS).candidates if not one.follows_pose}
    unshaped: dict[str, list[float]] = {"declared": [], "softer": []}
    after: dict[tuple[str, bool], dict[str, list[float]]] = {}
    longest: dict[tuple[str, bool], float] = {}
    for move in moves(count, declared):
        time = np.arange(0.0, move.duration + SETTLING, TICK)
        poses = move.poses(time)
        shapers: dict[tuple[str, bool], Shaper] = {(kind, False): one.shaper for kind, one in fixed.items()}
        shapers |= {(kind, True): declared.shaper(kind, poses) for kind in KINDS}
        for belts, model in (("declared", declared), ("softer", softer)):
            unshaped[belts].append(model.simulate(time, poses).largest(move.duration))
            for key, one in shapers.items():
                end = move.duration + float(np.max(one.durations))
                left = model.simulate(time, poses, shaper=one).largest(end)
                after.setdefault(key, {"declared": [], "softer": []})[belts].append(left)
                longest[key] = max(longest.get(key, 0.0), float(np.max(one.durations)))
    return {
        (kind, follows): Left(
            fixed[kind].left.worst if not follows else float("nan"),
            max(values["declared"]) / max(unshaped["declared"]),
            _rms(values["declared"]) / _rms(unshaped["declared"]),
            max(values["softer"]) / max(unshaped["softer"]),
            longest[kind, follows],
        )
        for (kind, follows), values in after.items()
    }


def _rms(values: list[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def table(found: dict[tuple[str, bool], Left]) -> str:
    """Return the table in Markdown."""
    lines = [
        "| shaper | lasts [ms] | predicted, worst pose | simulated, worst move | rms | worst, belts 6 % softer |",
        "| --- | ---: | ---: | ---: | ---: | ---: |",
    ]
    for (kind, follows), left in sorted(found.items(), key=lambda item: item[0][1]):
        name = f"`{kind}`, {'of the pose' if follows else 'fixed'}"
        predicted = "-" if np.isnan(left.predicted) else f"{left.predicted:.3f}"
        numbers = f"{predicted} | {left.worst:.3f} | {left.rms:.3f} | {left.softer:.3f}"
        lines.append(f"| {name} | {1e3 * left.longest:.1f} | {numbers} |")
    return "\n".join(lines)


def main() -> None:
    """Write the page, or print the table for fewer moves."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--moves", type=int, help="print the table for so many moves")
    count = parser.parse_args().moves
    if count is not None:
        print(table(study(count)))
        return
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    _, after = rest.split(END)
    PAGE.write_text(f"{before}{BEGIN}\n{table(study())}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
