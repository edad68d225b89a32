"""The identified and the declared robot, and their modes on the useful working area of figures 7 to 20."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.machine.maps.workspace import box_of

ROOT = Path(__file__).parents[3]
#: Length of the line over which a change counts as sudden.
SUDDEN = 0.05
#: Distance of the poses over which the condition number is averaged [m].
STEP = 0.005


@dataclass(frozen=True)
class Case:
    """A robot on its useful working area: the plane without boundary effects.

    Attributes
    ----------
    name : str
    ends : tuple of float
        Range of x [m]: docs/explanation/published-tables.md.
    side : float
        Largest distance from the central axis [m].
    z : float
        Height of the plane [m].
    """

    name: str
    ends: tuple[float, float]
    side: float
    z: float


CASES = (
    Case("linear-delta-2022-identified", (0.35, 1.1375), 0.15, -0.24383544),
    Case("linear-delta-2022", (0.365, 0.764), 0.10, -0.245),
)


@dataclass(frozen=True, eq=False)
class Area:
    """The modes over a working area; y has an odd number of values, the middle one on the central axis.

    Attributes
    ----------
    f, in_plane, out_of_plane : ndarray, shape (x, y, mode)
    p : ndarray, shape (x, y, mode, 3)
        Directions of the platform's motion, unit vectors.
    shape : ndarray, shape (x, y, mode, 9)
    condition : float
        Mean condition number of the whole plane, every 5 mm.
    radius : float
        Of the pulleys [m].
    """

    f: np.ndarray
    in_plane: np.ndarray
    out_of_plane: np.ndarray
    p: np.ndarray
    shape: np.ndarray
    condition: float
    radius: float

    def line(self, values: np.ndarray, mode: int) -> np.ndarray:
        """Return values of a mode, from 1, along the central axis."""
        return values[:, values.shape[1] // 2, mode - 1]

    def place(self, index: int) -> float:
        """Return a place along the axis from 0, the lower end, to 1, the upper end."""
        return index / (len(self.f) - 1)

    def halves(self, values: np.ndarray, mode: int) -> tuple[float, float]:
        """Return the means of a mode, from 1, over the lower and the upper half of the area."""
        one, half = values[..., mode - 1], len(self.f) // 2
        return float(np.nanmean(one[:half])), float(np.nanmean(one[-half:]))

    def jump(self, values: np.ndarray, mode: int) -> tuple[float, float]:
        """Return the largest change over 5 % of the axis, relative to the range, and where it is."""
        line, step = self.line(values, mode), max(1, round(SUDDEN * (len(self.f) - 1)))
        change = np.abs(line[step:] - line[:-step])
        return float(change.max() / np.ptp(line)), self.place(int(change.argmax()) + step // 2)


@cache
def area_of(case: Case) -> Area:
    """Evaluate a robot over its working area."""
    model = pkmodes.load(ROOT / "robots" / f"{case.name}.toml")
    grid = {"x": np.linspace(*case.ends, 211), "y": np.linspace(-case.side, case.side, 41), "z": case.z}
    found = model.map(grid, shapes=True).squeeze("z").transpose("x", "y", ...)
    low, high = box_of(model)
    steps = [np.arange(np.ceil(a / STEP), b / STEP) * STEP for a, b in zip(low[:2], high[:2], strict=True)]
    plane = model.map({"x": steps[0], "y": steps[1], "z": case.z})
    motion = found["platform_shape"].values
    return Area(
        found["frequency"].values,
        found["in_plane"].values,
        found["out_of_plane"].values,
        motion / np.linalg.norm(motion, axis=-1, keepdims=True),
        found["shape"].values,
        float(plane["condition"].mean()),
        model.robot.quantities["pulley.radius"].value,
    )
