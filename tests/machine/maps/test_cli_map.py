"""``pkmodes map``: what it prints and writes."""

from __future__ import annotations

import json
import os
import pty
import re
import select
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.answers import printed, refused
from helpers.commands.map_runs import PROGRAM
from helpers.commands.printed_tables import printed_table
from helpers.robots.robot_text import PUBLISHED, edited
from helpers.runs.processes import ROOT, environment
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.machine.maps.ranges import parse_settings

ROBOT = str(PUBLISHED)
LINE = "x=0.3:0.8:11,y=0,z=-0.245"


def test_the_table_says_where_each_mode_is_lowest_and_highest() -> None:
    out = printed("map", ROBOT, "--grid", LINE)
    assert out.startswith("linear-delta-2022, motors free: The lowest frequency of vibration lies between")
    assert "  Mapped with motors free: x 300 to 800 mm (11 values), y 0 mm, z -245 mm.\n" in out
    assert "  poses: 11\n  can be evaluated: 11 (100 %)\n" in out
    x = np.linspace(0.3, 0.8, 11)
    frequencies = pkmodes.load(PUBLISHED).frequencies([[value, 0.0, -0.245] for value in x])[:, 3:]
    first = frequencies[:, 0]
    assert f"lies between {first.min():.3f} and {first.max():.3f} Hz " in " ".join(out.split())
    rows = printed_table(out, "mode", "2 %", "median", "98 %", *(2 * ("f [Hz]", "x [mm]")))
    for mode, column in enumerate(frequencies.T):
        low, high = column.argmin(), column.argmax()
        shares = [f"{value:.3f}" for value in np.quantile(column, [0.02, 0.5, 0.98])]
        ends = [part for k in (low, high) for part in (f"{column[k]:.3f}", f"{1e3 * x[k]:.6g}")]
        assert rows[mode] == [str(mode + 1), *shares, *ends]
    assert len(rows) == 6
    assert "near-singular" not in out
    assert "unstable" not in out


def test_one_pose_has_frequencies_and_no_quantiles() -> None:
    out = printed("map", ROBOT, "--grid", "x=0.6,y=0.03,z=-0.245")
    frequencies = [f"{f:.3f}" for f in pkmodes.load(PUBLISHED).frequencies([0.6, 0.03, -0.245])[3:]]
    assert out.startswith(
        f"linear-delta-2022, motors free: The lowest frequency of vibration is {frequencies[0]} Hz\n"
    )
    assert "  Mapped with motors free: x 600 mm, y 30 mm, z -245 mm.\n" in out
    assert "Frequencies at the pose.\n" in out
    assert printed_table(out, "mode", "f [Hz]") == [[str(k), f] for k, f in enumerate(frequencies, 1)]


def test_a_frequency_beyond_all_others_does_not_lead_the_table(monkeypatch: pytest.MonkeyPatch) -> None:
    """In the workspace of this robot a belt span vanishes but for rounding at one pose: mode 6 has 9e9 Hz there."""
    monkeypatch.setenv("COLUMNS", "80")
    out = printed("map", str(ROOT / "robots/linear-delta-2022-identified.toml"))
    lines = out.splitlines()
    assert max(map(len, lines)) <= 80
    content = json.loads(
        printed("map", str(ROOT / "robots/linear-delta-2022-identified.toml"), "--json", "-")
    )
    found = content["modes"][5]
    assert 1e3 < found["maximum_hz"] < 10.0 * found["median_hz"]
    assert 100.0 < found["quantile_2_hz"] < found["median_hz"] < found["quantile_98_hz"] < 1000.0
    first = next(line.split() for line in lines if line.split()[:1] == ["6"])
    assert first[:4] == [
        "6",
        *(f"{found[key]:.3f}" for key in ("quantile_2_hz", "median_hz", "quantile_98_hz")),
    ]
    assert not re.search(r"\d{5}\.|\de\d", out)
    said = re.search(
        r"(\d+) poses are near-singular and not in these numbers: the condition", " ".join(lines)
    )
    assert said is not None
    assert int(said[1]) == content["near_singular"]["poses"] == content["valid"] - content["counted"]
    assert content["near_singular"]["at"] == pytest.approx({"x": 0.28, "y": 0.0, "z": -0.32})


def test_poses_that_cannot_be_evaluated_are_counted_by_reason() -> None:
    out = printed("map", ROBOT, "--grid", "x=0:0.8:5,y=0,z=-0.5:-0.245:2")
    assert "  poses: 10\n  can be evaluated: 3 (30 %)\n" in out
    # Links of 0.4 m do not reach half a metre down, and the carriages would be below x = 0 for small x.
    said = dict(re.findall(r"note: (\d+) poses cannot be evaluated: (.*)", out))
    assert {number: text.partition(":")[0] for number, text in said.items()} == {
        "5": "the pose is out of reach",
        "2": "a carriage is beyond its limits",
    }


def test_units_sweeps_and_a_file(tmp_path: Path) -> None:
    out = tmp_path / "map.nc"
    grid = "x=300 mm:80 cm:11, y=0, z=-245 mm"
    arguments = ["--set", "platform.mass=1 kg:2000 g:3", "--set", "belt.width=10 mm,15 mm", "--out", str(out)]
    text = printed("map", ROBOT, "--grid", grid, *arguments)
    assert f"wrote {out}" in text
    assert (
        "Mapped with motors free: platform.mass 1 to 2 kg (3 values), belt.width 0.01 to 0.015 m (2 values)"
        in " ".join(text.split())
    )
    with xarray.open_dataset(out) as found:
        assert found["frequency"].dims == ("platform.mass", "belt.width", "z", "y", "x", "mode")
        np.testing.assert_allclose(found["x"], np.linspace(0.3, 0.8, 11))
        np.testing.assert_allclose(found["platform.mass"], [1.0, 1.5, 2.0])
        np.testing.assert_allclose(found["belt.width"], [0.01, 0.015])


def test_every_changeable_path_can_be_swept() -> None:
    for file in sorted((ROOT / "robots").glob("*.toml")):
        units = changeable_units(pkmodes.load(file).robot)
        assert units
        for path in units:
            assert parse_settings((f"{path}=1:2:3",), units, "--set")[path].tolist() == [1.0, 1.5, 2.0]


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_a_file_of_measurements_is_a_list_of_poses(tmp_path: Path, separator: str) -> None:
    poses, decimal = tmp_path / "poses.csv", "." if separator == "," else ","
    text = "pose|y|x [mm]|z|frequency\nA|0|600|-0,245|55\nA|0|600|-0,245|60\nB|0,05|500|-0,245|50\n||||\n"
    written = text.replace(",", decimal).replace("|", separator)
    poses.write_text(f"# taken in May\n{written}", encoding="utf-8")
    found = json.loads(printed("map", ROBOT, "--poses", str(poses), "--json", "-"))
    assert found["poses"] == found["valid"] == 2
    assert found["ranges"] == {"pose": ["A", "B"]}
    assert {row["minimum_at"]["x"] for row in found["modes"]} <= {0.5, 0.6}
    poses.write_text(written.replace("B", "B\x1b[2J"), encoding="utf-8")
    where = rf'expected a label, found "B\x1b[2J" ({poses}: line 4, column pose)'
    assert f"error: {where}; write a name in printable characters" in refused("map", ROBOT, "--poses", poses)
    poses.write_text(written.replace(f"0{decimal}05", "5%"), encoding="utf-8")
    where = f'expected a finite number, found "5%" ({poses}: line 4, column y)'
    said = f"error: {where}; write a plain number with a decimal point"
    assert said in refused("map", ROBOT, "--poses", poses)


def test_samples(tmp_path: Path) -> None:
    robot = tmp_path / "robot.toml"
    robot.write_text(
        edited('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "2 %" }'), encoding="utf-8"
    )
    arguments = [str(robot), "--grid", LINE, "--samples", "3", "--json", "-"]
    first, other = (json.loads(printed("map", *arguments, "--seed", seed)) for seed in ("1", "2"))
    assert first["dimensions"]["sample"] == 3
    assert first["poses"] == 33
    assert first["modes"] != other["modes"]
    assert "platform.mass" in first["modes"][0]["minimum_at"]


def test_the_workspace_without_a_grid() -> None:
    found = json.loads(printed("map", str(ROOT / "robots/corexy-printer.toml"), "--json", "-"))
    assert found["valid"] > 20_000
    assert found["ranges"]["x"][0] < 0.01


def test_a_terminal_shows_progress_with_the_time_left() -> None:
    master, slave = pty.openpty()
    command = [sys.executable, "-c", PROGRAM, "map", ROBOT, "--grid", "x=0.3:0.8:33,y=0:0.1:3,z=-0.245"]
    process = subprocess.Popen(
        [*command, "--threads", "1"],
        env=environment(TERM="xterm", COLUMNS="100"),
        stderr=slave,
        stdout=subprocess.PIPE,
    )
    os.close(slave)
    shown = b""
    while select.select([master], [], [], 600)[0]:
        try:
            part = os.read(master, 4096)
        except OSError:  # the terminal is closed
            break
        if not part:
            break
        shown += part
    assert process.stdout is not None
    assert b"  can be evaluated: 99 (100 %)\n" in process.stdout.read()
    process.stdout.close()
    assert process.wait() == 0
    os.close(master)
    assert re.search(rb"\d+ of 99 poses, about \d+ s left", shown)


@pytest.mark.usefixtures("no_drawing")
def test_motors_are_held_if_asked(tmp_path: Path) -> None:
    """In the numbers, in the file, and on the page with its pictures and its machine."""
    page, file = tmp_path / "map.html", tmp_path / "map.nc"
    grid = ("--grid", "x=0.5:0.6:3,y=-0.02:0.02:3,z=-0.245", "--drives", "held")
    out = printed("map", ROBOT, *grid, "--out", str(file), "--report", str(page))
    assert "  Mapped with motors held: " in out
    assert "  can be evaluated: 9 (100 %)\n" in out
    with xarray.open_dataset(file) as found:
        assert (found.attrs["drives"], found.attrs["rigid_modes"]) == ("held", 0)
        expected = pkmodes.load(PUBLISHED).frequencies([0.55, 0.0, -0.245], drives="held")
        np.testing.assert_allclose(found["frequency"].sel(x=0.55, y=0.0).squeeze(), expected, rtol=1e-10)
    text = page.read_text(encoding="utf-8")
    assert "Mapped with motors held: " in text
    assert "The robot as declared, its motors held, in the plane of the map" in text
    assert "Modes with motors held:" in text
    assert text.count("motors held, z =") > 3
    content = json.loads(printed("map", ROBOT, *grid, "--json", "-"))
    assert (content["drives"], content["rigid_modes"], len(content["modes"])) == ("held", 0, 6)


def test_long_names_of_swept_parameters_do_not_widen_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    payload, gearbox = "effects.payload.mass", "effects.gearbox_compliance.compliance"
    swept = ("--set", f"{payload}=0:1:2", "--set", f"{gearbox}=1e-5:1e-4:2")
    given = ("--grid", "x=0.6:0.7:2,y=0,z=-0.245:-0.2:2", *swept)
    out = printed("map", ROBOT, *given)
    assert max(map(len, out.splitlines())) <= 80
    place = ("f [Hz]", f"{payload} [kg]", f"{gearbox} [rad/(N*m)]", "x [mm]", "z [mm]")
    rows = printed_table(out, "mode", "2 %", "median", "98 %", *place, *place)
    assert [row[0] for row in rows] == list("123456789")
    content = json.loads(printed("map", ROBOT, *given, "--json", "-"))
    for row, mode in zip(rows, content["modes"], strict=True):
        for cells, kind in ((row[4:9], "minimum"), (row[9:], "maximum")):
            at = mode[f"{kind}_at"]
            place = (at[payload], at[gearbox], 1e3 * at["x"], 1e3 * at["z"])
            assert cells == [f"{mode[f'{kind}_hz']:.3f}", *(f"{value:.6g}" for value in place)]
