"""The table of ``pkmodes modes``: decimals, zeros, rigid modes, and a terminal of 80 columns."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.answers import printed
from helpers.robots.robot_text import published

pytestmark = pytest.mark.usefixtures("eighty")

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
#: A zero but for rounding, or three decimals; a frequency of 100 kHz or more has an exponent.
NUMBER = re.compile(r"0|-?\d+\.\d{3}|-?\d\.\d\de\+\d\d")
#: Two digits, and no decimals that frequencies do not have.
SIGMA = re.compile(r"<0\.001|0\.00[1-9]|0\.0[1-9]\d?|0\.[1-9]\d|\d\.\d|[1-9]\d+")
#: Poses on and off the planes of symmetry.
POSES = {
    "linear-delta-2022": ("0.6,0,-0.245", "0.7,0.05,-0.2"),
    "linear-delta-2022-identified": ("0.6,0,-0.2", "0.55,-0.03,-0.22"),
    "clavel-delta": ("0,0,-0.4", "0.05,0.02,-0.45"),
    "corexy-printer": ("0.15,0.15", "0.1,0.23"),
}
#: Effects with coordinates of their own: 18 modes, which 80 columns do not hold.
SOFT = """
[effects.gearbox_compliance]
compliance = "2e-4 rad/(N*m)"

[effects.link_compliance]
compliance = "1e-7 m/N"

[effects.frame_compliance]
compliance = "1e-7 m/N"
"""


def cells(out: str) -> dict[str, list[str]]:
    """Return the cells of each row of the table, its parts side by side."""
    found: dict[str, list[str]] = {}
    body = re.split("\n\n(?:motors |p: )", out)[0].split("\n\n", 1)[1]
    for line in body.splitlines():
        if line:
            name, *rest = line.replace("[Hz]", "").replace("[%]", "").split()
            found.setdefault(name, []).extend(rest)
    return found


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize(("robot", "pose"), [(robot, pose) for robot in POSES for pose in POSES[robot]])
def test_numbers_have_fixed_decimals_and_zeros_are_zeros(
    robot: str,
    pose: str,
    drives: str,
) -> None:
    file = str(ROBOTS / f"{robot}.toml")
    out = printed("modes", file, "--pose", pose, "--drives", drives)
    assert max(map(len, out.splitlines())) <= 80
    assert "-0.000" not in out
    modes = pkmodes.load(file).modes([float(c) for c in pose.split(",")], drives=drives)
    table = cells(out)
    sigmas = table.pop("+-", [])
    assert all(map(SIGMA.fullmatch, sigmas)), sigmas
    for name, row in table.items():
        assert len(row) == len(modes.frequencies), name
        assert name == "mode" or all(map(NUMBER.fullmatch, row)), row
    assert [float(f) for f in table["f"]] == pytest.approx(modes.frequencies, abs=5.001e-4)
    directions = np.array([row for name, row in table.items() if name.startswith("p_")], dtype=float).T
    size = np.linalg.norm(modes.platform_shapes, axis=1, keepdims=True)
    np.testing.assert_allclose(directions, modes.platform_shapes / size, atol=5.001e-4)
    # What symmetry makes zero is 0 and not 0.000: on the plane y = 0 of a linear delta no mode moves it askew.
    if robot.startswith("linear") and ",0," in pose:
        assert "0.000" not in (*table["p_x"], *table["p_y"], *table["p_z"])
        assert table["p_y"].count("0") >= 4


def test_a_zero_stands_where_the_other_numbers_have_their_ones() -> None:
    out = printed("modes", str(ROBOTS / "linear-delta-2022.toml"), "--pose", POSES["linear-delta-2022"][0])
    rows = [line for line in out.splitlines() if line.startswith("p_")]
    points = {match.start() for line in rows for match in re.finditer(r"\.", line)}
    zeros = {match.start() + 1 for line in rows for match in re.finditer(r"(?<=\s)0(?=\s|$)", line)}
    assert zeros
    assert zeros <= points


def test_one_line_says_why_rigid_modes_have_frequencies() -> None:
    arguments = str(ROBOTS / "linear-delta-2022.toml"), "--pose", POSES["linear-delta-2022"][0]
    free = printed("modes", *arguments)
    (line,) = [line for line in free.splitlines() if line.startswith("rigid: ")]
    assert "gravity" in line
    assert "sqrt(|lambda|)/(2 pi)" in line
    assert "rigid: " not in printed("modes", *arguments, "--drives", "held")
    # Gravity does not act along the rails of a printer: its rigid modes are at 0 Hz, and there is nothing to explain.
    level = printed("modes", str(ROBOTS / "corexy-printer.toml"), "--pose", "0.15,0.15", "--drives", "free")
    assert cells(level)["f"][:2] == ["0", "0"]
    assert "rigid: " not in level


def test_more_modes_than_columns_are_printed_in_parts(tmp_path: Path) -> None:
    file = tmp_path / "soft.toml"
    file.write_text(published() + SOFT, encoding="utf-8")
    out = printed("modes", str(file), "--pose", "0.6,0.03,-0.245")
    frequencies = pkmodes.load(file).modes([0.6, 0.03, -0.245]).frequencies
    assert len(frequencies) > 12
    assert max(map(len, out.splitlines())) <= 80
    table = cells(out)
    numbers = [str(number) for number in range(1, len(frequencies) - 2)]
    titles = [cell for cell in table["mode"] if cell != "mode"]
    assert titles == ["rigid", "rigid", "rigid", *numbers]
    shown = [float(f) for f in table["f"]]
    assert shown == pytest.approx(frequencies, rel=0.005, abs=5.001e-4)
