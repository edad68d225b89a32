"""The head of every page says for whom and on what it is, as the robot file and the campaign file do."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest

from helpers.pages.page_reading import Element, read
from helpers.pages.report_examples import HOSTILE
from pkmodes import read_robot
from pkmodes.cli import run
from pkmodes.codegen.generation import specification
from pkmodes.core.base.errors import MeasurementError, RobotFileError
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.robot_files.saving import Correction, corrected_text
from pkmodes.machine.dataset.robot_text import robot_file_text
from pkmodes.modaltest.campaign.campaign import read_campaign

ROOT = Path(__file__).parents[3]
LOOP, CAMPAIGN = ROOT / "examples" / "closed_loop", ROOT / "examples" / "campaign"
TABLE = """
[report]
operator = "A. Berg"
customer = "M\u00fcller & S\u00f6hne <GmbH>"
serial = "00123"
"""
#: In the order of the head, whatever the order in the file.
HEAD = [("Customer", "M\u00fcller & S\u00f6hne <GmbH>"), ("Serial number", "00123"), ("Operator", "A. Berg")]


def robot_with(folder: Path, table: str = TABLE, of: Path = LOOP / "robot.toml") -> Path:
    (folder / "robot.toml").write_text(of.read_text("utf-8") + table, encoding="utf-8")
    return folder / "robot.toml"


def head(page: Path) -> list[tuple[str, str]]:
    (header,) = read(page.read_text("utf-8")).all("header")
    lists: list[Element] = header.all("dl")
    return [
        (term.text, text.text)
        for one in lists
        for term, text in zip(one.all("dt"), one.all("dd"), strict=True)
    ]


def pages(robot: Path, folder: Path) -> dict[str, Sequence[str]]:
    corexy = folder / "corexy.toml"
    corexy.write_text((ROOT / "robots" / "corexy-printer.toml").read_text("utf-8") + TABLE, encoding="utf-8")
    few = ["--pose", "x=0.05:0.2:3,y=0.05:0.2:3"]
    return {
        "compare": ["compare", str(robot), str(LOOP / "measured.csv"), "--report"],
        "diagnose": [
            "diagnose",
            str(robot),
            str(LOOP / "measured.csv"),
            "--candidates",
            "payload",
            "--report",
        ],
        "map": ["map", str(corexy), "--grid", few[1], "--out", str(folder / "map.nc"), "--report"],
        "shaper": ["shaper", str(corexy), "--grid", few[1], "--report"],
        "sensitivities": ["sensitivities", str(corexy), "--pose", "0.1,0.15", "--report"],
        "response": [
            *("response", str(corexy), "--pose", "0.1,0.15", "--inputs", "force_x", "--outputs", "p_x"),
            *("--frequencies", "50:150:11", "--report"),
        ],
        "show": ["show", str(corexy), "--out"],
    }


@pytest.mark.parametrize(
    "command", ["compare", "diagnose", "map", "shaper", "sensitivities", "response", "show"]
)
def test_every_page_of_a_robot_has_what_its_file_says(command: str, tmp_path: Path) -> None:
    target = tmp_path / "page.html"
    arguments = pages(robot_with(tmp_path), tmp_path)[command]
    assert run([*arguments, str(target)]) == 0
    assert head(target) == HEAD
    first = target.read_bytes()
    assert run([*arguments, str(target), *(["--overwrite"] if command == "map" else [])]) == 0
    assert target.read_bytes() == first


@pytest.mark.usefixtures("no_drawing")
def test_a_page_on_two_robots_has_what_both_files_say(tmp_path: Path) -> None:
    text = (ROOT / "robots" / "corexy-printer.toml").read_text("utf-8") + TABLE
    (tmp_path / "first.toml").write_text(text, encoding="utf-8")
    (tmp_path / "second.toml").write_text(text.replace("00123", "00124"), encoding="utf-8")
    robots, target = [str(tmp_path / f"{name}.toml") for name in ("first", "second")], tmp_path / "page.html"
    assert run(["compare", *robots, "--grid", "x=0.05:0.2:3,y=0.05:0.2:3", "--report", str(target)]) == 0
    assert head(target) == [HEAD[0], HEAD[2]]


@pytest.mark.usefixtures("no_drawing")
def test_without_the_table_there_is_no_head(tmp_path: Path) -> None:
    target = tmp_path / "page.html"
    robot = robot_with(tmp_path, "")
    assert run(["compare", str(robot), str(LOOP / "measured.csv"), "--report", str(target)]) == 0
    assert head(target) == []


@pytest.mark.usefixtures("no_drawing")
def test_what_the_campaign_says_prevails_over_the_robot(tmp_path: Path) -> None:
    folder = tmp_path / "campaign"
    shutil.copytree(CAMPAIGN, folder)
    robot_with(folder, TABLE, folder / "robot.toml")
    sensors, first, *_ = (folder / "campaign.toml").read_text("utf-8").split("[[record]]")
    own = '\n[report]\noperator = "C. Diaz"\nmachine = "Cell 4"\n'
    (folder / "campaign.toml").write_text(f"{sensors}[[record]]{first}{own}", encoding="utf-8")
    target = tmp_path / "page.html"
    command = ["identify", str(folder / "campaign.toml"), "--out", str(tmp_path / "modes.csv"), "--report"]
    assert run([*command, str(target)]) == 0
    assert head(target) == [HEAD[0], ("Machine", "Cell 4"), HEAD[1], ("Operator", "C. Diaz")]


@pytest.mark.usefixtures("no_drawing")
@pytest.mark.parametrize("given", HOSTILE[:-1])
def test_hostile_text_is_shown_as_text(given: str, tmp_path: Path) -> None:
    if "\x00" in given:
        pytest.skip("TOML has no such characters")
    quoted = given.replace("\\", "\\\\").replace('"', '\\"')
    robot = robot_with(tmp_path, f'\n[report]\ncustomer = "{quoted}"\n')
    target = tmp_path / "page.html"
    assert run(["compare", str(robot), str(LOOP / "measured.csv"), "--report", str(target)]) == 0
    ((title, shown),) = head(target)
    assert title == "Customer"
    assert shown.isprintable()
    if given.isprintable():
        assert shown == given


@pytest.mark.parametrize(
    ("table", "place", "remedy"),
    [
        ('[report]\ncustommer = "x"', "report.custommer", '"customer"'),
        ("[report]\nserial = 123", "report.serial", 'serial = "..."'),
        ('[report]\nmachine = ""', "report.machine", "leave it out"),
        (f'[report]\nmachine = "{"x" * 121}"', "report.machine", "leave it out"),
        ("report = 1", "report", "[report]"),
    ],
)
def test_other_keys_and_values_are_refused_in_both_files(
    table: str, place: str, remedy: str, tmp_path: Path
) -> None:
    text = (LOOP / "robot.toml").read_text("utf-8")
    joined = f"{table}\n{text}" if table.startswith("report =") else f"{text}\n{table}\n"
    (tmp_path / "robot.toml").write_text(joined, encoding="utf-8")
    with pytest.raises(RobotFileError) as refused:
        read_robot(tmp_path / "robot.toml")
    (problem,) = refused.value.problems
    assert problem.where.endswith(f": {place}")
    assert remedy in problem.remedy
    if table == "report = 1":
        return  # the kinds of values of a campaign file are tested with it
    shutil.copy(CAMPAIGN / "robot.toml", tmp_path / "robot.toml")
    text = (CAMPAIGN / "campaign.toml").read_text("utf-8")
    (tmp_path / "campaign.toml").write_text(f"{text}\n{table}\n", encoding="utf-8")
    with pytest.raises(MeasurementError) as wrong:
        read_campaign(tmp_path / "campaign.toml")
    assert str(wrong.value.where).endswith(f": {place}")
    assert remedy in wrong.value.remedy


def test_generated_code_does_not_depend_on_the_table(tmp_path: Path) -> None:
    plain = read_robot(LOOP / "robot.toml")
    named = read_robot(robot_with(tmp_path))
    assert specification(named, "robot.toml") == specification(plain, "robot.toml")


def test_other_values_and_written_robots_keep_the_table(tmp_path: Path) -> None:
    path = robot_with(tmp_path)
    robot = read_robot(path)
    assert dict(robot.report) == {"customer": HEAD[0][1], "serial": "00123", "operator": "A. Berg"}
    other: Robot = robot.with_values({"platform.mass": 2.0})
    assert other.report == robot.report
    (tmp_path / "other.toml").write_text(robot_file_text(other), encoding="utf-8")
    assert read_robot(tmp_path / "other.toml").report == robot.report
    saved = corrected_text(path, {"platform.mass": Correction(2.0)})
    assert TABLE in saved
