"""The report of frequency responses: its numbers are those of the table, and it is usable in a real browser."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from helpers.pages.page_reading import Element, read, shown
from pkmodes.cli import run

ROOT = Path(__file__).parents[3]
DELTA = ROOT / "robots" / "linear-delta-2022.toml"
PRINTER = ROOT / "robots" / "corexy-printer.toml"
WITH_DAMPING = '\n[damping]\nratio = "2 %"\n'


def made(
    folder: Path, robot: Path, pose: str, inputs: str, outputs: str, *more: str, drives: str = "held"
) -> Element:
    """Write the report, the table and the JSON of a response; return the page."""
    given = ["--inputs", inputs, "--outputs", outputs, "--frequencies", "5:200:391", "--drives", drives]
    files = {"report": "page.html", "json": "page.json", "out": "table.csv"}
    written = [part for name, file in files.items() for part in (f"--{name}", str(folder / file))]
    assert run(["response", str(robot), "--pose", pose, *given, *written, *more]) == 0
    return read((folder / "page.html").read_text("utf-8"))


def damped(folder: Path, of: Path = DELTA, name: str = "robot.toml") -> Path:
    (folder / name).write_text(of.read_text("utf-8") + WITH_DAMPING, encoding="utf-8")
    return folder / name


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("response")


@pytest.fixture(scope="module")
def page(folder: Path) -> Element:
    """Measured here is the same machine with belts that are 10 % softer, and only one channel of it."""
    robot = damped(folder)
    softer = folder / "softer.toml"
    softer.write_text(robot.read_text("utf-8").replace("2.42e6", "2.178e6"), encoding="utf-8")
    (folder / "softer").mkdir()
    made(folder / "softer", softer, "0.6,0,-0.245", "force_x", "p_x")
    table = folder / "softer" / "table.csv"
    return made(folder, robot, "0.6,0,-0.245", "force_x,force_z", "p_x,p_z", "--measured", str(table))


def rows_of(section: Element) -> list[list[Element]]:
    (table,) = section.all("table")
    (body,) = table.all("tbody")
    return [[*row.all("th"), *row.all("td")] for row in body.all("tr")]


def column(table: Path, channel: str) -> tuple[Any, Any]:
    """Return frequencies and responses of a channel of the table, read by other means than those of the report."""
    with table.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    f = np.array([float(row["frequency"]) for row in rows])
    return f, np.array([complex(float(row[f"re:{channel}"]), float(row[f"im:{channel}"])) for row in rows])


def test_the_largest_responses_are_those_of_the_tables(page: Element, folder: Path) -> None:
    rows = rows_of(page.by_id("responses"))
    names = [row[0].text.strip() for row in rows]
    assert "In every row: unit m/N." in page.by_id("responses").text
    assert sorted(names) == ["p_x/force_x", "p_x/force_z", "p_z/force_x", "p_z/force_z"]
    assert names[0] == "p_x/force_x"  # the measured one
    for name, row in zip(names, rows, strict=True):
        cases = [(folder / "table.csv", row[2:5])]
        if name == "p_x/force_x":
            cases.append((folder / "softer" / "table.csv", row[5:8]))
        else:
            assert [cell.text.strip() for cell in row[5:8]] == ["\u2013"] * 3
        f, values = column(folder / "table.csv", name)
        (begin,) = row[1].all("data")
        assert float(begin.attributes["value"]) == pytest.approx(abs(values[0]), rel=1e-12)
        for table, cells in cases:
            f, values = column(table, name)
            peak = np.abs(values).argmax()
            exact = (abs(values[peak]), f[peak], np.degrees(np.angle(values[peak])))
            for cell, expected in zip(cells, exact, strict=True):
                (data,) = cell.all("data")
                assert float(data.attributes["value"]) == pytest.approx(expected, rel=1e-12)
                seen, half = shown(data.text)
                assert abs(seen - expected) <= 1.01 * half


def test_the_head_says_where_the_first_channel_answers_most(page: Element, folder: Path) -> None:
    f, values = column(folder / "table.csv", "p_x/force_x")
    g, softer = column(folder / "softer" / "table.csv", "p_x/force_x")
    peak, second = f[np.abs(values).argmax()], g[np.abs(softer).argmax()]
    modes = pkmodes.load(DELTA).modes([0.6, 0.0, -0.245], drives="held").frequencies
    nearest = int(np.abs(modes - peak).argmin())
    first = modes[nearest]
    assert 0.0 < abs(first - peak) < 0.5  # a line of the table is near the mode, not at it
    assert first - second > 1.0
    said = f"p_x resonates most with force_x in mode {nearest + 1}, at {first:.3f} Hz, measured at {second:.3f} Hz"
    assert said in page.by_id("summary").text


def test_what_was_measured_beyond_the_frequencies_of_the_model_is_no_peak(tmp_path: Path) -> None:
    beyond = tmp_path / "beyond.csv"
    beyond.write_text("frequency,re:p_x/force_x,im:p_x/force_x\n500,1,0\n501,2,0\n", encoding="utf-8")
    page = made(tmp_path, damped(tmp_path), "0.6,0,-0.245", "force_x", "p_x", "--measured", str(beyond))
    summary = page.by_id("summary").text
    assert "p_x resonates most with force_x in mode" in summary
    assert "measured at" not in summary
    (row,) = rows_of(page.by_id("responses"))
    assert len(row) == 6  # channel and unit, and sizes, frequency and phase of the model


def test_places_in_the_json_hold_the_numbers(page: Element, folder: Path) -> None:
    content = json.loads((folder / "page.json").read_text("utf-8"))
    placed = [one for one in page.all("data") if "data-at" in one.attributes]
    assert len(placed) == 5
    for one in placed:
        _, key, index = one.attributes["data-at"].split("/")
        place = int(index) if isinstance(content[key], list) else index
        assert float(one.attributes["value"]) == content[key][place]


def test_modes_have_their_frequency_damping_and_direction(page: Element) -> None:
    modes = pkmodes.load(DELTA).modes([0.6, 0.0, -0.245], drives="held")
    rows = rows_of(page.by_id("modes"))
    assert len(rows) == len(modes.frequencies) == 6
    for row, f, shape in zip(rows, modes.frequencies, modes.platform_shapes, strict=True):
        assert shown(row[1].text.strip())[0] == pytest.approx(f, abs=5e-4)
        assert row[2].text.strip() == "2.00"
        direction = [shown(cell.text.strip())[0] for cell in row[3:]]
        assert direction == pytest.approx(shape / np.linalg.norm(shape), abs=5.01e-4)


def test_frequencies_have_the_standard_deviations_of_the_file(tmp_path: Path) -> None:
    page = made(tmp_path, PRINTER, "0.1,0.15", "force_x", "p_x")
    sigmas = pkmodes.load(PRINTER).frequency_sigmas([0.1, 0.15], drives="held")
    for row, sigma in zip(rows_of(page.by_id("modes")), sigmas, strict=True):
        _, its = row[1].all("data")
        assert float(its.attributes["value"]) == pytest.approx(sigma)
    summary = page.by_id("summary").text
    assert "has no damping" in summary
    # The head has the frequency of the mode that it names with the same standard deviation.
    found = re.search(r"in mode (\d), at ([\d.]+) \u00b1 ([\d.]+) Hz \(from the standard deviations", summary)
    assert found is not None
    sigma = sigmas[int(found[1]) - 1]
    assert float(found[3]) == pytest.approx(sigma, rel=0.06)
    frequencies = pkmodes.load(PRINTER).modes([0.1, 0.15], drives="held").frequencies
    assert float(found[2]) == pytest.approx(frequencies[int(found[1]) - 1], abs=0.06 * sigma)


def test_the_largest_response_of_free_motors_is_a_resonance(tmp_path: Path) -> None:
    """Towards 0 Hz the machine moves as a rigid body, with 1 / f^2, by more than at any resonance."""
    page = made(tmp_path, damped(tmp_path), "0.6,0,-0.245", "torque_1", "p_x", drives="free")
    f, values = column(tmp_path / "table.csv", "p_x/torque_1")
    magnitude = np.abs(values)
    assert magnitude.argmax() == 0
    assert magnitude[1] / magnitude[0] == pytest.approx((f[0] / f[1]) ** 2, rel=0.02)
    elastic = f > 20.0
    expected = f[elastic][magnitude[elastic].argmax()]
    (row,) = rows_of(page.by_id("responses"))
    assert shown(row[4].text.strip())[0] == pytest.approx(expected, abs=1e-3)


def test_a_prescribed_motion_is_no_response_to_itself(tmp_path: Path) -> None:
    page = made(tmp_path, damped(tmp_path), "0.6,0,-0.245", "motor_1,force_x", "p_x,motor_1")
    names = [row[0].text.strip() for row in rows_of(page.by_id("responses"))]
    assert names == ["p_x/motor_1", "p_x/force_x"]
    said = page.by_id("summary").text
    assert "motor_1/motor_1 is left out: the motion is prescribed." in said
    assert "No response in motor_1/force_x." in said
    assert "p_x is the motion of the platform along x, motor_1 is the angle of motor 1." in said


def test_the_head_names_the_channel_that_responds_most_of_one_unit(tmp_path: Path) -> None:
    """Not the first one, nor one in which there is only rounding."""
    page = made(tmp_path, damped(tmp_path), "0.6,0,-0.245", "force_z,force_x", "p_z,p_y,p_x,motor_1")
    sizes = {}
    for output in ("x", "z"):
        f, values = column(tmp_path / "table.csv", f"p_{output}/force_{output}")
        sizes[np.abs(values).max()] = output, f[np.abs(values).argmax()]
    output, at = sizes[max(sizes)]
    assert output == "x"
    said = page.by_id("summary").text
    modes = pkmodes.load(DELTA).modes([0.6, 0.0, -0.245], drives="held").frequencies
    nearest = int(np.abs(modes - at).argmin())
    assert f"p_x resonates most with force_x in mode {nearest + 1}, at {modes[nearest]:.3f} Hz" in said
    assert "Of the channels in m/N this one has the strongest resonance." in said
    assert "p_y/force_x" in said[said.index("No response in") :]  # by symmetry
    shown_there = [row[0].text.strip() for row in rows_of(page.by_id("responses"))]
    assert not any(name.startswith("p_y/") for name in shown_there)


def test_many_channels_are_in_figures_of_four(tmp_path: Path) -> None:
    page = made(tmp_path, damped(tmp_path), "0.6,0,-0.245", "force_x,force_z", "p_x,p_z,x_1,x_2,x_3")
    titles = [one.text for one in page.by_id("responses").all("title")]
    assert list(dict.fromkeys(titles)) == ["Responses, 1 to 4", "Responses, 5 to 8", "Responses, 9 to 10"]
    assert len(rows_of(page.by_id("responses"))) == 10


def test_the_same_input_gives_the_same_bytes_without_folders(page: Element, folder: Path) -> None:
    first = (folder / "page.html").read_bytes()
    table = ["--measured", str(folder / "softer" / "table.csv")]
    made(folder, folder / "robot.toml", "0.6,0,-0.245", "force_x,force_z", "p_x,p_z", *table)
    assert (folder / "page.html").read_bytes() == first
    assert str(folder).encode() not in first


def test_refused_measurements_leave_no_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = damped(tmp_path)
    (tmp_path / "m.csv").write_text(
        "frequency,re:p_y/force_y,im:p_y/force_y\n1,2,3\n2,2,3\n", encoding="utf-8"
    )
    command = ["response", str(robot), "--pose", "0.6,0,-0.245", "--drives", "held", "--inputs", "force_x"]
    command += ["--outputs", "p_x", "--frequencies", "5:60:40", "--measured", str(tmp_path / "m.csv")]
    assert run([*command, "--report", str(tmp_path / "page.html"), "--out", str(tmp_path / "r.csv")]) == 2
    assert "expected a channel of p_x/force_x, found p_y/force_y" in capsys.readouterr().err
    assert not (tmp_path / "page.html").exists()
    assert not (tmp_path / "r.csv").exists()
    assert run([*command[:-2], "--report", str(tmp_path / "page.pdf")]) == 2
    assert "expected a name that ends in .html" in capsys.readouterr().err


def test_in_a_browser_it_asks_for_nothing_and_axe_finds_nothing(page: Element, folder: Path) -> None:
    with opened(folder / "page.html") as browser:
        assert browser.findings_in_light_and_dark() == []
        assert browser.problems == []
        assert browser.outside == []
        assert browser.page.get_by_role("button", name="Save Responses as").count() == 2
    assert (folder / "page.html").stat().st_size < 6_000_000


def test_on_a_phone_nothing_is_wider_than_the_screen(page: Element, folder: Path) -> None:
    with opened(folder / "page.html", width=360) as browser:
        assert not browser.sideways
        assert browser.page.locator(".narrow svg").first.is_visible()


def test_a_hostile_name_of_the_robot_is_shown_as_text(tmp_path: Path) -> None:
    name, robot = "</script><img src=x onerror=alert(2)>", damped(tmp_path)
    text = re.sub(r"^name = .*$", f'name = "{name}"', robot.read_text("utf-8"), flags=re.M)
    robot.write_text(text, encoding="utf-8")
    page = made(tmp_path, robot, "0.6,0,-0.245", "force_x", "p_x")
    (heading,) = page.all("h1")
    assert heading.text.strip() == f"{name}, motors held"
    assert page.all("img") == []
