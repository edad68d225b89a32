"""Calls of ``pkmodes diagnose`` with files as a user writes them."""

from __future__ import annotations

import csv
import io
import os
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from helpers.commands.answers import Answer, answer
from pkmodes.core.robot.reading import robot_from_document
from pkmodes_rig.measurements import measure
from pkmodes_rig.robots import POSES, ROBOTS

PUBLISHED, TOWER = ROBOTS["published"], ROBOTS["tower"]
HEADER = "pose,x,y,z,frequency,sigma"
SHAPES = ("x_1", "x_2", "x_3", "p_x", "p_y", "p_z")
#: Belts that are 10 % too soft on one axis, and 5 % too stiff on another.
UNEQUAL = {
    "axis_belt_stiffness.factor_1": -0.1,
    "axis_belt_stiffness.factor_2": 0.05,
    "axis_belt_stiffness.factor_3": 0.0,
}
WIND_UP = {"gearbox_compliance.compliance": 5e-4}


def call(*arguments: object) -> Answer:
    return answer("diagnose", *arguments)


def edited(text: str, *changes: tuple[str, str]) -> str:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return text


@cache
def _measured(robot: str, name: str, poses: int, effects: tuple[tuple[str, float], ...], **rest: Any) -> str:
    return measure(
        robot_from_document(tomllib.loads(robot), "truth").parameters,
        POSES[name]["scattered"][:poses],
        effects=dict(effects),
        rng=np.random.default_rng(4),
        **rest,
    )


def measured(
    robot: str = PUBLISHED,
    *,
    name: str = "published",
    poses: int = 4,
    effects: Mapping[str, float] = {},
    shapes: tuple[str, ...] = SHAPES,
    modes: int = 6,
) -> str:
    """Measurements on the virtual rig of a robot that is as declared except for some effects."""
    return _measured(robot, name, poses, tuple(effects.items()), shapes=shapes, modes=modes)


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def bare(rows: list[dict[str, str]]) -> list[dict[str, str]]:
    """The same rows without shapes."""
    return [{name: cell for name, cell in row.items() if not name.startswith("shape:")} for row in rows]


def csv_of(rows: list[dict[str, str]]) -> str:
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]))
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def write(folder: Path, text: str, name: str = "modes.csv") -> Path:
    path = folder / name
    path.write_bytes(text.encode("utf-8"))
    return path


def unwritable(folder: Path, name: str) -> Path:
    """Return a place at which no file can be written."""
    if os.geteuid() == 0:
        return Path("/proc") / name  # nobody can make a file there
    (folder / "locked").mkdir(mode=0o500)
    return folder / "locked" / name


def files(folder: Path, robot: str = PUBLISHED, modes: str | None = None) -> tuple[Path, Path]:
    return write(folder, robot, "robot.toml"), write(folder, modes or measured())


def refusal(found: Answer, *parts: str) -> None:
    assert found.code == 2
    assert found.out == ""
    assert found.err.startswith("error: ")
    assert found.err.count("\n") == 1
    assert re.search(r" \([^;]*\); \S", found.err), "where or what to do is missing"
    for part in parts:
        assert part in found.err


def diagnosed(folder: Path, robot: str, modes: str, *options: str) -> dict[str, Any]:
    found = call(*files(folder, robot, modes), *options, "--json", "-")
    assert (found.code, found.err) == (0, "")
    return found.json
