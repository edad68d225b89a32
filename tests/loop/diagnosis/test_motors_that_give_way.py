"""Motors that give way are no candidate where all are held: a note says how to test for them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import ROBOTS
from pkmodes.loop.diagnosis import Diagnosis
from pkmodes.loop.updating.analyses import diagnose
from pkmodes.loop.updating.reading import read

PRINTER = ROBOTS / "corexy-printer.toml"
POSES = np.array([[0.05, 0.05], [0.15, 0.15], [0.25, 0.06], [0.06, 0.26], [0.2, 0.2], [0.1, 0.24]])
CANDIDATES = ("servo_stiffness", "gearbox_compliance", "belt_end_compliance")
NOTE = "with held motors servo_stiffness is no candidate"


@pytest.fixture(scope="module")
def rows(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The two lowest modes of the printer with its motors on springs, and with 0.1 % of noise."""
    sprung = pkmodes.load(PRINTER).with_values({"effects.servo_stiffness.stiffness": 15.0})
    frequencies = sprung.frequencies(POSES, drives="free")[:, :2]
    frequencies *= 1.0 + 0.001 * np.random.default_rng(20261201).standard_normal(frequencies.shape)
    lines = ["pose,x,y,frequency,sigma"]
    for i, (x, y) in enumerate(POSES.tolist()):
        lines += [f"P{i + 1},{x},{y},{f:.4f},{0.001 * f:.4f}" for f in frequencies[i].tolist()]
    path = tmp_path_factory.mktemp("rows") / "modes.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def diagnosed(rows: Path, drives: str | None) -> Diagnosis:
    robot = pkmodes.read_robot(PRINTER)
    return diagnose(robot, read(rows, robot=robot, drives=drives), candidates=CANDIDATES)


def test_a_note_says_how_to_test_for_them_and_doing_so_finds_them(rows: Path) -> None:
    as_in_use, free = diagnosed(rows, None), diagnosed(rows, "free")
    assert {row.drives for row in as_in_use.rows} == {"held"}
    assert "servo_stiffness" not in {name for effect in as_in_use.effects for name in effect.members}
    (note,) = [note for note in as_in_use.notes if note.startswith(NOTE)]
    assert "--drives free" in note
    (cause,) = free.effects
    assert cause.members == ("servo_stiffness",)
    assert not [note for note in free.notes if note.startswith(NOTE)]


def test_where_the_model_is_adequate_there_is_nothing_to_test(tmp_path: Path) -> None:
    frequencies = pkmodes.load(PRINTER).frequencies(POSES)
    path = tmp_path / "modes.csv"
    path.write_text(
        "pose,x,y,frequency,sigma\n"
        + "".join(
            f"P{i + 1},{x},{y},{f:.4f},{0.002 * f:.4f}\n"
            for i, (x, y) in enumerate(POSES.tolist())
            for f in frequencies[i].tolist()
        ),
        encoding="utf-8",
    )
    result = diagnosed(path, None)
    assert result.verdict == "adequate"
    assert not [note for note in result.notes if note.startswith(NOTE)]
