"""Shapers for each axis of a machine whose axes are independent: modes by hand, lines, schedules, other machines."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.page_reading import read
from pkmodes.cli import run
from pkmodes.machine.shaping import residual
from pkmodes.machine.shaping.results import Choice
from pkmodes.machine.shaping.version_lines import lines_by_version

ROOT = Path(__file__).parents[3]
BED_SLINGER = ROOT / "robots/bed-slinger.toml"
PAYLOAD = "effects.payload.mass"
#: On both sides of the poses at which the modes of the axes cross.
POSES = np.array([[0.03, 0.2], [0.125, 0.1], [0.24, 0.05], [0.2, 0.01]])
DAMPING = {"damping.ratio": 0.03}
KINDS = ["zv", "mzv", "ei", "zv*zv"]


def by_hand(pose: np.ndarray, payload: float = 0.0) -> np.ndarray:
    """Frequencies of tool head and bed, each on the two runs of its own belt with motors held [Hz]."""
    x, y = pose
    stiffness = (
        6e-3 * 2.6e6 * np.array([1.0 / (0.06 + x) + 1.0 / (0.68 - x), 1.0 / (0.08 + y) + 1.0 / (0.66 - y)])
    )
    return np.sqrt(stiffness / np.array([0.5, 1.0 + payload])) / (2.0 * np.pi)


@pytest.fixture(scope="module")
def choice() -> Choice:
    return pkmodes.load(BED_SLINGER).with_values(DAMPING).shapers(POSES, KINDS)


def test_each_axis_has_the_modes_that_its_belt_makes(choice: Choice) -> None:
    assert list(choice.by_axis) == ["x", "y"]
    expected = np.array([by_hand(pose) for pose in POSES])
    assert (expected[:, 0] < expected[:, 1]).any()
    assert (expected[:, 0] > expected[:, 1]).any()
    for k, part in enumerate(choice.by_axis.values()):
        np.testing.assert_allclose(part.ringing.frequencies[:, 0], expected[:, k], rtol=1e-6)
        # A step of 1 m/s^2 displaces the mass by 1 / omega^2.
        np.testing.assert_allclose(
            part.ringing.weights[:, 0], 1.0 / (2.0 * np.pi * expected[:, k]) ** 2, rtol=1e-6
        )
        assert {candidate.kind for candidate in part.candidates} == {"zv", "mzv", "ei"}
        left = residual(part.best.shaper, expected[:, k], 0.03)
        assert part.best.left_at_pose.worst == pytest.approx(left.max(), rel=1e-4)


def test_a_shaper_for_each_axis_is_shorter_than_one_for_both(choice: Choice) -> None:
    assert max(part.best.duration for part in choice.by_axis.values()) <= choice.best.duration
    assert all(part.best.left.worst <= choice.left for part in choice.by_axis.values())


def test_notes_on_what_is_recommended_are_those_of_each_axis(choice: Choice) -> None:
    assert not any("no fixed shaper" in note for note in choice.notes)
    strict = pkmodes.load(BED_SLINGER).with_values(DAMPING).shapers(POSES, ["zv"], left=0.01)
    said = [note for note in strict.notes if "no fixed shaper" in note]
    assert [note.partition(" no fixed shaper leaves at most 1 %")[0] for note in said] == ["on x", "on y"]


def test_machines_whose_axes_share_modes_have_one_shaper() -> None:
    for robot, poses in (("corexy-printer", POSES), ("linear-delta-2022", [[0.6, 0.03, -0.25]])):
        assert pkmodes.load(ROOT / f"robots/{robot}.toml").shapers(poses, "zv").by_axis == {}


def test_lines_have_a_shaper_for_each_axis_where_the_firmware_has(choice: Choice) -> None:
    lines = {version.option: version for version in lines_by_version(choice)}
    kinds = {axis: part.best.kind for axis, part in choice.by_axis.items()}
    f = {axis: f"{part.best.frequencies[0]:.2f}" for axis, part in choice.by_axis.items()}
    assert f["x"] != f["y"]
    assert str(lines["klipper"].lines).splitlines() == [
        "[input_shaper]",
        *(
            line
            for axis in "xy"
            for line in (
                f"shaper_type_{axis}: {kinds[axis]}",
                f"shaper_freq_{axis}: {f[axis]}",
                f"damping_ratio_{axis}: 0.0300",
            )
        ),
    ]
    assert kinds == {"x": "mzv", "y": "mzv"}
    assert lines["marlin"].lines == f"M493 S1 X C8 A{f['x']} I0.0300\nM493 S1 Y C8 A{f['y']} I0.0300"
    assert lines["marlin-2025-09"].lines == f"M493 S1 X8 A{f['x']} I0.0300\nM493 S1 Y8 B{f['y']} J0.0300"
    assert not lines["klipper"].instead
    # RepRapFirmware shapes all axes alike.
    assert lines["reprapfirmware"].instead
    assert str(lines["reprapfirmware"].lines).count("M593") == 1


def test_marlin_gets_no_mixture_of_m593_and_fixed_time_motion() -> None:
    model = pkmodes.load(BED_SLINGER).with_values(DAMPING)
    mixed = model.shapers([[0.03, 0.03], [0.034, 0.2]], ["zv", "mzv"], left=0.12)
    assert {part.best.kind for part in mixed.by_axis.values()} == {"zv", "mzv"}
    lines = {version.option: str(version.lines) for version in lines_by_version(mixed)}
    assert "shaper_type_x: zv" in lines["klipper"]
    assert "M593" not in lines["marlin"]
    assert lines["marlin"].count("M493 S1") == 2


def test_a_payload_on_the_bed_leaves_the_tool_head_alone(tmp_path: Path) -> None:
    masses = [0.0, 0.5, 1.0]
    model = pkmodes.load(BED_SLINGER).with_values(DAMPING)
    choice = model.shapers(POSES, ["zv", "mzv"], settings={PAYLOAD: masses}, height=(0.0, 0.2))
    assert choice.by_axis["x"].schedule is None
    schedule = choice.by_axis["y"].schedule
    assert schedule is not None
    for mass, step in zip(masses, schedule.steps, strict=True):
        expected = [[by_hand(pose, mass)[1]] for pose in POSES]
        np.testing.assert_allclose(step.choice.ringing.frequencies, expected, rtol=1e-6)
        assert step.at_ends is not None
    for version in ("klipper", "marlin"):
        commands = str(schedule.commands(version)).splitlines()[1::2]
        assert len(commands) == len(masses)
        assert not any("X" in command.replace("MAX", "") for command in commands)
    assert schedule.commands("klipper") == "\n".join(
        line
        for height, values, step in zip(
            ("0.0", "50.0", "150.0"), ("0 to 0.25", "0.25 to 0.75", "0.75 to 1"), schedule.steps, strict=True
        )
        for line in (
            f"; from the layer at {height} mm on: {PAYLOAD} {values} kg",
            f"SET_INPUT_SHAPER SHAPER_TYPE_Y={step.best.kind} SHAPER_FREQ_Y={step.best.frequencies[0]:.2f} "
            "DAMPING_RATIO_Y=0.0300",
        )
    )


def test_the_page_says_the_shaper_of_each_axis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, page = tmp_path / "s.json", tmp_path / "s.html"
    arguments = ["--grid", "x=0.03:0.2:3,y=0.05:0.2:3", "--shapers", "zv,mzv", "--set", f"{PAYLOAD}=0:1kg:2"]
    assert run(["shaper", str(BED_SLINGER), *arguments, "--json", str(file), "--report", str(page)]) == 0
    content = json.loads(file.read_text(encoding="utf-8"))
    said = " ".join(capsys.readouterr().out.split())
    best = {part["axis"]: part["shapers"][part["recommended"]] for part in content["axes"]}
    shapers = " and ".join(
        f"{one['kind']} on {axis} ({one['frequencies_hz'][0]:.1f} Hz)" for axis, one in best.items()
    )
    worst = max(one["left_at_pose"]["worst"] for one in best.values())
    assert f"{shapers} leave up to {100 * worst:.2g} % of the vibration at the worst pose" in said
    for axis, one in best.items():
        assert f"{axis}: lasts: {1e3 * one['duration_s']:.3g} ms" in said
        assert f"mm: {round(10 * one['max_acceleration']) * 100:,} mm/s^2" in said
    assert [part["schedule"] is None for part in content["axes"]] == [True, False]
    assert "No line changes another axis than y." in said
    text = page.read_text(encoding="utf-8")
    assert "Left over the workspace along x" in text
    assert "Against frequency error along y" in text
    # So that it opens on six screens.
    folded = {section.attributes["id"] for section in read(text).all("section") if section.all("details")}
    assert folded == {"together", "machine", "errors", "firmware", "origin"}
    largest = said.partition("largest without a shaper at: ")[2]
    assert re.match(r"x = \d+ mm, y = \d+ mm", largest)  # as the poses below it
