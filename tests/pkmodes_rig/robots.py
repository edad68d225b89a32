"""Robots and poses for the virtual test rig: robot files as a user would write them, and measurement poses.

There are three very different robots: the published one, a tower printer, and one with three different axes.  All
declare the uncertainty of the same three values; the other values have none, so they are held fixed but may be
suspected.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from pkmodes.core.robot.reading import robot_from_document
from pkmodes.core.robot.robot import Robot

PUBLISHED = Path(__file__).resolve().parents[2] / "robots" / "linear-delta-2022.toml"

#: Relative uncertainty of measured values, by the text that declares them in the published file.
DECLARED = {
    '[platform]\nmass = "1.5 kg"': "1 %",
    'specific_stiffness = "2.42e6 N/m"': "2 %",
    '[motor]\ninertia = "0.017e-3 kg*m^2"': "2 %",
}


def with_free_motors(file: Path) -> str:
    """Return the text of a robot file, with free motors whatever it says of its use: the suites state the others."""
    return re.sub(
        r'^drives = "held".*$', 'drives = "free"', file.read_text(encoding="utf-8"), flags=re.MULTILINE
    )


def declared(file: Path, sigmas: Mapping[str, str]) -> str:
    """Return the text of a robot file in which some lines declare an uncertainty, by what they end with."""
    text = with_free_motors(file)
    for line, sigma in sigmas.items():
        if text.count(line) != 1:
            raise ValueError(f"{line!r} is not in {file.name}")
        key, value = line.rsplit(" = ", 1)
        text = text.replace(line, f'{key} = {{ value = {value}, sigma = "{sigma}" }}')
    return text


TOWER = """\
format = 1
name = "tower"
mechanism = "linear_delta"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]

[platform]
mass = { value = "0.3 kg", sigma = "1 %" }

[link]
length = "300 mm"
mass = "60 g"

[carriage]
mass = "150 g"
length = "40 mm"

[belt]
specific_stiffness = { value = "0.9e6 N/m", sigma = "2 %" }
width = "6 mm"

[pulley]
radius = "6 mm"
inertia = "0.3e-6 kg*m^2"

[motor]
inertia = { value = "5e-6 kg*m^2", sigma = "2 %" }
gear_ratio = 1

[[axis]]
origin = ["170 mm", "0 mm", "0 mm"]
direction = [0, 0, 1]
joint = ["30 mm", "0 mm", "0 mm"]
limits = ["0 mm", "900 mm"]
driven_pulley = 1
branch = 1

[[axis]]
origin = ["-85 mm", "147.224319 mm", "0 mm"]
direction = [0, 0, 1]
joint = ["-15 mm", "25.980762 mm", "0 mm"]
limits = ["0 mm", "900 mm"]
driven_pulley = 1
branch = 1

[[axis]]
origin = ["-85 mm", "-147.224319 mm", "0 mm"]
direction = [0, 0, 1]
joint = ["-15 mm", "-25.980762 mm", "0 mm"]
limits = ["0 mm", "900 mm"]
driven_pulley = 1
branch = 1
"""

ASYMMETRIC = """\
format = 1
name = "asymmetric"
mechanism = "linear_delta"
gravity = ["0.6 m/s^2", "-0.4 m/s^2", "-9.78 m/s^2"]

[platform]
mass = { value = "0.9 kg", sigma = "1 %" }

[link]
length = "420 mm"
mass = "310 g"

[carriage]
mass = "650 g"
length = "60 mm"

[belt]
specific_stiffness = { value = "1.6e6 N/m", sigma = "2 %" }
width = "16 mm"

[pulley]
radius = "20 mm"
inertia = "45e-6 kg*m^2"

[motor]
inertia = { value = "30e-6 kg*m^2", sigma = "2 %" }
gear_ratio = 3

[frame]
mass = "80 kg"

[[axis]]
origin = ["310 mm", "20 mm", "10 mm"]
direction = [0.2, 0.05, 1]
joint = ["45 mm", "5 mm", "12 mm"]
limits = ["0 mm", "800 mm"]
driven_pulley = 1
branch = 1

[[axis]]
origin = ["-150 mm", "260 mm", "-40 mm"]
direction = [-0.1, 0.25, 1]
joint = ["-20 mm", "38 mm", "-6 mm"]
limits = ["-50 mm", "900 mm"]
driven_pulley = 2
branch = 1

[axis.belt]
width = "12 mm"

[[axis]]
origin = ["-170 mm", "-240 mm", "30 mm"]
direction = [0.15, -0.1, 1]
joint = ["-28 mm", "-33 mm", "4 mm"]
limits = ["20 mm", "850 mm"]
driven_pulley = 1
branch = 1

[axis.link]
length = "440 mm"

[axis.carriage]
mass = "800 g"
"""

#: Text of the robot files.
ROBOTS: dict[str, str] = {
    "published": declared(PUBLISHED, DECLARED),
    "tower": TOWER,
    "asymmetric": ASYMMETRIC,
}

#: Centre and half size of the measured part of the workspace [m].
REGIONS = {
    "published": ((0.6, 0.012, -0.24), (0.17, 0.08, 0.03)),
    "tower": ((0.006, -0.004, 0.25), (0.06, 0.06, 0.15)),
    "asymmetric": ((0.03, 0.0, 0.13), (0.09, 0.08, 0.12)),
}


def read(name: str, effects: Mapping[str, float] = {}) -> Robot:
    """Read one of `ROBOTS` with effects added to its file."""
    return robot_from_document(tomllib.loads(with_effects(name, effects)), name)


def with_effects(name: str, effects: Mapping[str, float]) -> str:
    """Return the text of a robot file with effects, given by ``"<effect>.<parameter>"`` in SI units."""
    tables: dict[str, list[str]] = {}
    for path, value in effects.items():
        effect, parameter = path.split(".")
        tables.setdefault(effect, []).append(f"{parameter} = {float(value)!r}\n")
    parts = [f"\n[effects.{effect}]\n{''.join(lines)}" for effect, lines in tables.items()]
    return ROBOTS[name] + "".join(parts)


def _poses(name: str) -> dict[str, tuple[np.ndarray, ...]]:
    """Return four plans of twelve poses: a grid in a plane, scattered in space, along a line, and near the middle.

    Near the middle of a tower printer, modes in x and y have nearly equal frequencies.
    """
    middle, half = np.array(REGIONS[name])
    grid = [(x, y, 0.1) for y in (-0.9, 0.15, 0.85) for x in (-0.95, -0.35, 0.3, 0.9)]
    scattered = np.random.default_rng(2022).uniform(-1, 1, (12, 3))
    line = np.linspace(-0.95, 0.95, 12)[:, None] * [1.0, 0.45, -0.6] + [0.0, 0.3, 0.1]
    near = scattered * [0.1, 0.1, 1.0]
    plans = {"grid": np.array(grid), "scattered": scattered, "line": line, "middle": near}
    return {plan: tuple(middle + half * np.clip(place, -1, 1)) for plan, place in plans.items()}


#: Poses [m] by robot and plan.
POSES: dict[str, dict[str, tuple[np.ndarray, ...]]] = {name: _poses(name) for name in ROBOTS}


def drawn_values(robot: Robot, rng: np.random.Generator) -> dict[str, float]:
    """Draw the true values of the uncertain parameters of a robot from their priors, by path."""
    uncertain = {path: q for path, q in robot.quantities.items() if q.sigma}
    return {path: q.value + (q.sigma or 0.0) * rng.standard_normal() for path, q in uncertain.items()}
