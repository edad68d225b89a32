"""Texts of robot files before and after corrections, and which lines differ."""

from __future__ import annotations

import difflib
import itertools
from pathlib import Path

from helpers.robots.robot_text import published
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.robot_files.saving import Correction, corrected_text

#: Joints of a tower printer, instead of joints at the centre.
JOINTS = ('["30 mm", "40 mm", 0]', "[0.0, 0.06, 0]", '["-3 cm", "0 mm", "-4 cm"]')


def correct(tmp_path: Path, text: str, **changes: Correction) -> str:
    """Return the text after corrections; in the keywords, __ stands for the dots of paths."""
    path = tmp_path / "robot.toml"
    path.write_bytes(text.encode("utf-8"))
    return corrected_text(path, {name.replace("__", "."): change for name, change in changes.items()})


def reread(tmp_path: Path, text: str) -> Robot:
    path = tmp_path / "corrected.toml"
    path.write_bytes(text.encode("utf-8"))
    return read_robot(path)


def changed_lines(before: str, after: str) -> tuple[list[str], list[str]]:
    """Return the lines that are in only one of the texts, with their line endings."""
    changes = list(difflib.ndiff(before.splitlines(keepends=True), after.splitlines(keepends=True)))
    return tuple([line[2:] for line in changes if line[0] == mark] for mark in "-+")


def with_joints() -> str:
    parts = published().split('joint = ["0 mm", "0 mm", "0 mm"]')
    assert len(parts) == 4
    return "".join(itertools.chain(*zip(parts, [*(f"joint = {joint}" for joint in JOINTS), ""], strict=True)))
