"""``pkmodes shaper``: what it prints and writes, and what it refuses."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.printed_tables import printed_table
from helpers.pages.browser import opened
from helpers.pages.page_reading import source_of
from pkmodes.cli import run

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022-identified.toml"
GRID = ("--grid", "x=0.36:0.8:5,y=0,z=-0.22:-0.18:2")
TITLES = ("shaper", "design [Hz]", "lasts [ms]", "rms [%]", "worst [%]")
LAST_TITLES = ("largest [%]", "max_accel")
DAMPING = """
[damping]
ratio = "1 %"
"""


@pytest.fixture
def robot(tmp_path: Path) -> str:
    path = tmp_path / "robot.toml"
    path.write_text(ROBOT.read_text(encoding="utf-8") + DAMPING, encoding="utf-8")
    return str(path)


def test_the_numbers_are_those_of_python(
    robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, page = tmp_path / "s.json", tmp_path / "s.html"
    arguments = [
        "shaper",
        robot,
        *GRID,
        "--shapers",
        "zv,2hump_ei,zv*zv",
        "--json",
        str(file),
        "--report",
        str(page),
    ]
    assert run(arguments) == 0
    printed = capsys.readouterr().out
    found = json.loads(file.read_text(encoding="utf-8"))
    model = pkmodes.load(robot)
    x, z = np.meshgrid(np.linspace(0.36, 0.8, 5), np.linspace(-0.22, -0.18, 2), indexing="ij")
    choice = model.shapers(np.stack([x, 0.0 * x, z], axis=-1).reshape(-1, 3), ["zv", "2hump_ei", "zv*zv"])
    assert found["drives"] == "held"
    assert found["poses"] == len(choice.ringing.poses)
    assert found["modes"] == 3
    assert found["unshaped"]["worst"] == pytest.approx(choice.unshaped.worst, rel=1e-12)
    assert found["recommended"] == choice.recommended
    assert [one["follows_pose"] for one in found["shapers"]] == [False] * 3 + [True] * 3
    for one, expected in zip(found["shapers"], choice.candidates, strict=True):
        assert one["kind"] == expected.kind
        assert one["duration_s"] == pytest.approx(expected.duration, rel=1e-12)
        assert one["left"]["worst"] == pytest.approx(expected.left.worst, rel=1e-9, abs=1e-12)
        assert one["left"]["rms_uncertain"] is None
        fixed = not expected.follows_pose
        assert (one["frequencies_hz"] is None, one["amplitudes"] is None) == (not fixed, not fixed)
        if fixed:
            assert sum(one["amplitudes"]) == pytest.approx(1.0)
            assert len(one["damping_ratios"]) == len(one["frequencies_hz"])
    assert set(found["firmware"]) == {"klipper", "marlin", "reprapfirmware"}
    rows = printed_table(printed, *TITLES, *LAST_TITLES)
    for number, (cells, one) in enumerate(zip(rows, found["shapers"], strict=True)):
        assert cells[0] == one["kind"] + " *" * (number == found["recommended"])
        design = ", ".join(f"{f:.2f}" for f in one["frequencies_hz"] or ())
        assert cells[1] == (design or "of the pose")
        assert cells[2:] == [
            f"{1e3 * one['duration_s']:.1f}",
            *(f"{100.0 * one['left_at_pose'][key]:.2f}" for key in ("rms", "worst")),
            f"{100.0 * one['left']['worst']:.2f}",
            "-" if one["max_acceleration"] is None else f"{100 * round(10 * one['max_acceleration']):,}",
        ]
        assert one["left_at_pose"]["worst"] >= max(one["left_at_pose"]["rms"], one["left"]["worst"]) - 1e-12
    best = found["shapers"][found["recommended"]]
    worst = f"{100.0 * best['left_at_pose']['worst']:.2g} % of the vibration at the worst pose"
    assert f"{best['kind']} leaves up to {worst}" in " ".join(printed.split())
    assert "motors held" in printed
    text = page.read_text(encoding="utf-8")
    assert "Left over the workspace" in text
    assert "Against frequency error" in text


def test_a_robot_file_with_standard_deviations_has_an_uncertain_column(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "s.json"
    arguments = ("--grid", "x=0.1:0.2:3,y=0.1:0.2:2", "--shapers", "zv", "--json", str(file))
    assert run(["shaper", str(ROOT / "robots/corexy-printer.toml"), *arguments]) == 0
    rows = printed_table(capsys.readouterr().out, *TITLES, "rms, uncertain [%]", *LAST_TITLES)
    shapers = json.loads(file.read_text(encoding="utf-8"))["shapers"]
    assert [cells[5] for cells in rows] == [
        f"{100.0 * one['left_at_pose']['rms_uncertain']:.2f}" for one in shapers
    ]
    for left in (shapers[0]["left"], shapers[0]["left_at_pose"]):
        assert left["rms_uncertain"] > left["rms"]


def test_poses_from_a_table_and_the_whole_workspace(
    robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "poses.csv"
    table.write_text("x [mm],y,z\n600,0,-0.22\n650,0.05,-0.2\n", encoding="utf-8")
    assert run(["shaper", robot, "--poses", str(table), "--shapers", "mzv", "--modes", "2"]) == 0
    assert "\n  poses: 2\n" in capsys.readouterr().out
    assert run(["shaper", str(ROOT / "robots/corexy-printer.toml"), "--shapers", "zv"]) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert "shaper_type: zv" in printed
    assert "M593 F" in printed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--shapers", "zv,,ei"], 'expected names separated by commas, found "zv,,ei" (--shapers)'),
        (["--shapers", "zvx"], 'found "zvx" (--shapers); did you mean'),
        (
            ["--modes", "9"],
            "expected at most the 6 modes that the machine has with motors held, found 9 (--modes)",
        ),
        (["--left", "2"], "expected a share above 0 and at most 1, found 2.0 (--left)"),
        (["--tick", "0"], "expected a positive time in s, found 0.0 (--tick)"),
        (["--left", "50 ms"], 'whose unit "ms" does not belong there (--left); for example: --left "10 %"'),
        (
            ["--length", "60 mm"],
            'expected a time such as "60 ms", found "60 mm", which is a length (--length)',
        ),
        (["--grid", "x=0.3:0.8:9999,y=-0.1:0.1:9999,z=-0.2"], "is given more than once"),
        (["--length", "0.001"], "no fixed shaper lasts at most 1 ms (--length)"),
        (["--tick", "0.1"], "less than two ticks of 100 ms (--tick)"),
        (["--poses", "poses.csv"], "--grid and --poses exclude each other"),
    ],
)
def test_wrong_options_are_refused(
    robot: str, arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["shaper", robot, *GRID, *arguments]) == 2
    assert message in " ".join(capsys.readouterr().err.split())


def test_values_may_have_units(robot: str, tmp_path: Path) -> None:
    found = []
    for options in (
        ["--left", "4 %", "--length", "46 ms", "--tick", "2 ms"],
        ["--left", "0.04", "--length", "0.046", "--tick", "0.002"],
    ):
        file = tmp_path / "s.json"
        assert (
            run(
                [
                    "shaper",
                    robot,
                    *GRID,
                    "--shapers",
                    "zv,mzv,2hump_ei,3hump_ei",
                    *options,
                    "--json",
                    str(file),
                ]
            )
            == 0
        )
        found.append(json.loads(file.read_text(encoding="utf-8")))
    assert found[0] == found[1]
    assert found[0]["shapers"][found[0]["recommended"]]["duration_s"] <= 0.046


def test_more_poses_than_fit_into_memory_are_refused(robot: str, capsys: pytest.CaptureFixture[str]) -> None:
    grid = "x=0.3:0.8:100000,y=-0.1:0.1:100000,z=-0.2"
    assert run(["shaper", robot, "--grid", grid]) == 2
    assert "expected at most 1,000,000 poses, found 10,000,000,000 (--grid)" in capsys.readouterr().err


def test_firmware_without_the_recommended_shaper_is_told_which_it_has(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "s.json"
    arguments = [
        "--grid",
        "x=0.05:0.25:5,y=0.05:0.25:5",
        "--shapers",
        "ei,zv*zv",
        "--left",
        "6 %",
        "--json",
        str(file),
    ]
    assert run(["shaper", str(ROOT / "robots/corexy-printer.toml"), *arguments]) == 0
    found = json.loads(file.read_text(encoding="utf-8"))
    assert found["shapers"][found["recommended"]]["kind"] == "zv*zv"
    assert found["firmware"]["klipper"] is found["firmware"]["marlin"] is None
    # What firmware makes of it leaves is beside each line alone: a second number would contradict it.
    lacking = "Klipper and Marlin have no zv*zv: their lines set ei, and say beside it what that leaves there"
    assert lacking in found["notes"]
    lines = {version["option"]: version for version in found["firmware_versions"]}
    assert (lines["klipper"]["shaper"], lines["klipper"]["instead"]) == ("ei", True)
    assert f"shaper_freq_x: {found['shapers'][0]['frequencies_hz'][0]:.2f}" in lines["klipper"]["lines"]
    assert (lines["reprapfirmware"]["shaper"], lines["reprapfirmware"]["instead"]) == ("zv*zv", False)
    assert "ei instead" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("grid", "said"),
    [
        ("x=0.6,y=0,z=-0.22", "There is only one pose"),
        ("x=0.4:0.8:9,y=0,z=-0.22", "Left over the workspace"),
        ("x=0.6,y=-0.05:0.05:5,z=-0.24:-0.2:5", "Left over the workspace"),
    ],
)
def test_the_page_shows_what_varies(robot: str, tmp_path: Path, grid: str, said: str) -> None:
    page = tmp_path / "s.html"
    assert run(["shaper", robot, "--grid", grid, "--shapers", "mzv,zv*zv*zv", "--report", str(page)]) == 0
    text = source_of(page)
    assert said in text
    assert ("y [mm]" in text and "z [mm]" in text) == ("y=-0.05" in grid)
    assert ">\u2212240 to \u2212200 mm<" in text or "z=-0.24" not in grid
    assert "that leaves at most 10 %." in text or "No fixed one leaves at most 10 %; this one leaves" in text
    assert "for a step of 1 m/s\u00b2" in text
    assert "\u00b5m" in text
    assert "/s^2" not in text
    assert " um<" not in text
    assert "shaper_type: mzv" in text
    with opened(page) as browser:
        assert browser.problems == []
        assert browser.outside == []
