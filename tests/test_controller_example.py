"""The controller example: its program, and what the simulated machine makes of the commands."""

from __future__ import annotations

import csv
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.generated.compiled import COMPILER, FLAGS
from helpers.runs.shared import Shared
from pkmodes.codegen.generation import generate
from pkmodes.machine.shaping import shaper

pytestmark = pytest.mark.compiler

ROOT = Path(__file__).parents[1]
EXAMPLE = ROOT / "examples/controller_1khz"
ROBOT = ROOT / "robots/linear-delta-2022.toml"
STRICT = [flag for flag in FLAGS if flag not in ("-shared", "-fPIC")] + ["-Wconversion", "-Wdouble-promotion"]
FOLLOWING = "zv*zv*zv, of the pose"
MOVES = 6


@pytest.fixture(scope="module")
def model(shared: Shared) -> Path:
    return shared.folder("controller_model", lambda folder: generate(ROBOT, folder))


def program(model: Path, folder: Path, *precision: str) -> Path:
    built = folder / "loop"
    files = [EXAMPLE / "main.c", model / "linear_delta_2022.c"]
    command = [str(COMPILER), *STRICT, *precision, f"-I{model}", *map(str, files), "-o", str(built), "-lm"]
    subprocess.run(command, check=True)
    return built


def left(commands: Path, *further: str) -> dict[str, float]:
    """Return what the simulated machine has left after the worst move, relative to no shaper."""
    command = [sys.executable, str(EXAMPLE / "plant.py"), str(ROBOT), str(commands), *further]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = re.findall(r"^(\w\S*(?:, [\w ]+?)?) +[\d.]+ +([\d.]+) +[\d.]+ +[\d.]+$", printed, re.M)
    return {name: float(part) for name, part in rows}


@pytest.mark.parametrize("precision", [[], ["-DPKMODES_FLOAT"]])
def test_the_shaper_of_the_pose_leaves_a_hundredth(tmp_path: Path, model: Path, precision: list[str]) -> None:
    commands = tmp_path / "commands.csv"
    loop = program(model, tmp_path, *precision)
    printed = subprocess.run(
        [str(loop), str(commands), str(MOVES)], check=True, capture_output=True, text=True
    )
    assert printed.stdout.endswith("could not follow the pose: 0\n")
    found = left(commands)
    assert found["none"] == 1.0
    assert found[FOLLOWING] < 0.02
    assert found[FOLLOWING] < 0.25 * found["zv*zv*zv, fixed"]
    # One of three modes is not enough, wherever it is.
    assert 0.2 < found["zv, of the pose"] < 1.0
    softer = left(commands, "--softer", "0.06")
    assert found[FOLLOWING] < softer[FOLLOWING] < 0.1


def test_the_commands_are_those_of_the_shapers_of_pkmodes(tmp_path: Path, model: Path) -> None:
    """The program's C against `Model.modes`, `shaper` and `Model.simulate`, from the moves without a shaper."""
    commands = tmp_path / "commands.csv"
    subprocess.run([str(program(model, tmp_path)), str(commands), "2"], check=True, capture_output=True)
    with commands.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))

    def of(shaper: str, move: int) -> np.ndarray:
        chosen = [row for row in rows if (row["shaper"], row["move"]) == (shaper, str(move))]
        return np.array([[float(row[key]) for key in ("time", "arrived", "x", "y", "z")] for row in chosen])

    robot = pkmodes.load(ROBOT)
    for move in (0, 1):
        plain, shaped = of("none", move), of(FOLLOWING, move)
        time, arrived, found = shaped[:, 0], shaped[:, 1] == 1, shaped[:, 2:]
        command = np.stack([np.interp(time, plain[:, 0], axis) for axis in plain[:, 2:].T], axis=-1)
        f = robot.modes(command, drives="held").frequencies[:, :3]
        of_pose = shaper("zv*zv*zv", f, np.full(f.shape, 0.01))
        expected = robot.simulate(time, command, shaper=of_pose).poses
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-8)
        np.testing.assert_array_equal(found[arrived], command[arrived])


def test_wrong_arguments_are_explained(tmp_path: Path, model: Path) -> None:
    loop = str(program(model, tmp_path))
    for arguments in ([], ["a.csv", "0"], ["a.csv", "3", "4"], ["a.csv", "100000"]):
        result = subprocess.run([loop, *arguments], capture_output=True, text=True, cwd=tmp_path)
        assert result.returncode == 2
        assert result.stderr.startswith("usage: ")
    nowhere = subprocess.run([loop, str(tmp_path / "no/c.csv")], capture_output=True, text=True)
    assert nowhere.returncode == 1
    assert "no/c.csv: No such file" in nowhere.stderr
