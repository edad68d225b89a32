"""What a report says is what ``--json`` says: every number, the verdict, the rows, and the correction."""

from __future__ import annotations

import json
import math
from collections import Counter
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from helpers.diagnoses.verdict_examples import VERDICTS
from helpers.pages.page_reading import Element, at, powers, read, shown
from helpers.pages.report_examples import diagnosed, made_up, many_modes, page_of
from helpers.runs.shared import Shared
from pkmodes import read_robot, updating
from pkmodes.cli import run
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis import Comparison, Diagnosis, Measurements
from pkmodes.pages.report import report

ROOT = Path(__file__).parents[3]
LOOP = [ROOT / "examples" / "closed_loop" / name for name in ("robot.toml", "measured.csv")]
#: What a report shows in per cent.
PER_CENT = {"rms_relative", "held_out_rms_relative", "residual", "pose_scatter", "shape_scatter"}


class Made(NamedTuple):
    """A report with the result in both forms."""

    result: Diagnosis | Comparison
    content: dict[str, Any]
    html: str
    page: Element


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> tuple[Diagnosis, Robot, Measurements]:
    """A diagnosis that found a cause."""
    return diagnosed("effect_found", tmp_path_factory.mktemp("found"))


@pytest.fixture(scope="module", params=VERDICTS)
def made(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, shared: Shared) -> Made:
    folder = tmp_path_factory.mktemp(request.param)
    result, _, _ = diagnosed(request.param, folder)
    html = page_of(request.param, folder, shared)
    return Made(result, json.loads(json.dumps(result.as_json())), html, read(html))


def placed(page: Element) -> dict[str, list[Element]]:
    found: dict[str, list[Element]] = {}
    for element in page.all("data"):
        if "data-at" in element.attributes:
            found.setdefault(element.attributes["data-at"], []).append(element)
    return found


def leaves(content: Any, pointer: str = "") -> dict[str, Any]:
    if isinstance(content, dict):
        parts = [(key.replace("~", "~0").replace("/", "~1"), value) for key, value in content.items()]
    elif isinstance(content, list):
        parts = [(str(i), value) for i, value in enumerate(content)]
    else:
        return {pointer: content}
    return {k: v for key, value in parts for k, v in leaves(value, f"{pointer}/{key}").items()}


def expect_equal_numbers(content: dict[str, Any], page: Element) -> dict[str, list[Element]]:
    found, exponents = placed(page), powers(page)
    for pointer, elements in found.items():
        for element in elements:
            exact = float(element.attributes["value"])
            assert exact == at(content, pointer), pointer
            if element.text.startswith("<"):  # a p-value that is not told from 0
                assert exact < 1e-6
                continue
            seen, half = (10.0 ** exponents.get(id(element), 0) * part for part in shown(element.text))
            factor = 100.0 if pointer.rsplit("/", 1)[1] in PER_CENT else 1.0
            assert abs(seen - factor * exact) <= 1.001 * half, (pointer, element.text, exact)
    return found


def test_every_number_is_that_of_the_json(made: Made) -> None:
    found = expect_equal_numbers(made.content, made.page)
    # Nothing is left out: all numbers of the JSON are on the page, besides some that it shows in another form.
    numbers = {k for k, v in leaves(made.content).items() if isinstance(v, float)}
    stage = "after_hz" if made.content["error"]["after"] else "refit_hz"
    shown_hz = ("frequency_hz", "sigma_hz", "before_hz", stage)
    unused = {k for k in numbers if k.endswith("_hz") and k.rsplit("/", 1)[1] not in shown_hz}
    parameters = {k for k in numbers if "/parameters/" in k}  # repeated in the alternatives, also shown
    covariances = {k for k in numbers if "/covariance/" in k}  # shown as standard deviations
    assert numbers - unused - set(found) <= parameters | covariances | {"/pose_scatter", "/damping/scatter"}


def test_the_same_result_gives_the_same_bytes(
    found: tuple[Diagnosis, Robot, Measurements], tmp_path: Path, shared: Shared
) -> None:
    result, robot, data = found
    assert page_of("effect_found", tmp_path, shared) == report(result, robot=robot, data=data)


def test_the_verdict_comes_first(made: Made) -> None:
    (main,) = made.page.all("main")
    summary = next(child for child in main.children if isinstance(child, Element))
    assert summary.attributes["id"] == "summary"
    assert f"Verdict: {made.content['verdict']}" in summary.text
    printed = made.content["reason"][1:].replace("1e-6", "10\u207b\u2076").replace("chi2", "chi\u00b2")
    assert printed in summary.text
    assert [item.text[1:].rstrip(".") for item in summary.all("li")] == [
        note[1:].rstrip(".") for note in made.content["notes"]
    ]


def test_captions_name_the_marks_that_are_there_and_no_others(made: Made) -> None:
    captions = " ".join(caption.text for caption in made.page.all("figcaption"))
    rows = made.content["rows"]
    assert ("open diamonds are held out" in captions) == any(row["held_out"] for row in rows)
    assert ("purple crosses were set aside" in captions) == any(row["outlier"] for row in rows)


def test_advice_fits_the_verdict(made: Made) -> None:
    verdict = made.content["verdict"]
    halved = {entry["verdict"] for entry in made.content["stability"] if entry["change"] == "sigma x 0.5"}
    assert ("usual where the stated sigma is right" in made.page.all("main")[0].text) == (
        halved == {"unexplained"} and verdict != "unexplained"
    )
    advice, why = made.page.by_id("action").text, made.content["next_measurement_reason"]
    assert (
        ("No next measurement is proposed" in advice)
        == (made.content["next_measurement"] is None)
        == (why is not None)
    )
    assert why is None or why in advice
    assert ("no explanations of it to separate" in advice) == (verdict == "adequate")


def test_only_what_can_be_detected_has_a_smallest_visible_size(made: Made) -> None:
    for row in (row for body in made.page.by_id("candidates").all("tbody") for row in body.all("tr")):
        cells = row.all("td")
        if cells[-1].text.strip() == "no":
            assert cells[-4].text.strip() == "\u2013"


def test_rows_of_the_stability_that_say_the_same_are_one_sentence(made: Made) -> None:
    entries, verdict = made.content["stability"], made.content["verdict"]
    claimed = {member for effect in made.content["effects"] for member in effect["class"]}
    same = [one["verdict"] == verdict and (not claimed or set(one["effects"]) <= claimed) for one in entries]
    if entries and verdict != "insufficient_data":
        section = made.page.by_id("stability")
        said = " ".join(section.text.split())
        # "Stable" stands beside no other verdict, not even one that the errors explain.
        assert said.startswith("Stability Stable: " if all(same) else "Stability Stability: "), said
        words = {
            "sigma x 0.5": "sigma halved",
            "sigma x 2": "sigma doubled",
            "priors x 2": "priors twice as wide",
        }
        assert all(said.count(words[entry["change"]]) == 1 for entry in entries)
        # What stays comes first, in one part; of an ambiguous verdict the best explanation is named instead.
        first = said.partition(";")[0]
        if any(same) and verdict != "ambiguous":
            assert [words[entry["change"]] in first for entry in entries] == same


def test_every_measured_mode_is_in_the_table(made: Made) -> None:
    lines = [
        int(float(cell.attributes["value"]))
        for cell in made.page.by_id("rows").all("data")
        if cell.attributes.get("data-at", "").endswith("/line")
    ]
    assert sorted(lines) == sorted(row["line"] for row in made.content["rows"])


def test_causes_survivors_and_what_is_not_detectable_are_named(made: Made) -> None:
    content, page = made.content, made.page
    sections = {section.attributes["id"] for section in page.all("section")}
    assert ("causes" in sections) == bool(content["effects"] or content["survivors"])
    for effect in content["effects"]:
        assert all(member in page.by_id("causes").text for member in effect["class"])
    listed = [item.text for item in page.by_id("causes").all("li")] if content["survivors"] else []
    assert len(listed) == len(content["survivors"])
    for said, group in zip(listed, content["survivors"], strict=True):
        assert all(name in said for each in group for name in each.split(" + "))
    unseen = [item.text for item in page.by_id("candidates").all("li")]  # in words, and their names
    assert [said.rpartition(" ")[2].strip("()") for said in unseen] == content["undetectable"]
    sentences = {one.name: one.sentence for one in made.result.candidates}
    assert all(
        said.startswith(sentences.get(name) or name)
        for said, name in zip(unseen, content["undetectable"], strict=True)
    )
    rows = page.by_id("candidates").all("tbody")[:1]  # the probabilities have another table
    named = {row.all("th")[0].text.split()[-1] for body in rows for row in body.all("tr")}
    assert named == {one["name"] for one in content["candidates"]}


def test_differences_are_those_of_the_frequencies(made: Made) -> None:
    """In per cent of the measurement and in standard deviations, from the JSON by the definition."""
    stage = "after_hz" if made.content["error"]["after"] else "refit_hz"
    for row in made.page.by_id("rows").all("tbody")[0].all("tr"):
        cells = {
            e.attributes["data-at"].rsplit("/", 1)[1]: e for e in row.all("data") if "data-at" in e.attributes
        }
        measured, sigma = (float(cells[name].attributes["value"]) for name in ("frequency_hz", "sigma_hz"))
        plain = [float(e.attributes["value"]) for e in row.all("data") if "data-at" not in e.attributes]
        expected = []
        for name in ("before_hz", stage):
            if name in cells:
                ratio = float(cells[name].attributes["value"]) / measured
                expected += [ratio - 1.0, math.log(ratio) * measured / sigma]
        assert plain == pytest.approx(expected, rel=1e-6, abs=1e-9)


def test_a_page_is_well_formed_and_its_ids_are_unique(made: Made) -> None:
    ids = Counter(made.page.ids())
    assert set(ids.values()) == {1}
    referred = {
        value.removeprefix("#")
        for element in made.page._every()
        for name, value in element.attributes.items()
        if name in ("href", "aria-labelledby", "aria-describedby")
        and (name != "href" or value.startswith("#"))
    }
    assert referred <= set(ids)
    levels = [int(e.tag[1]) for e in made.page._every() if e.tag in ("h1", "h2", "h3", "h4")]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(b - a <= 1 for a, b in pairwise(levels))
    assert all(th.attributes.get("scope") in ("row", "col", "colgroup") for th in made.page.all("th"))


def test_every_box_that_may_scroll_has_a_name_and_is_reached_by_keyboard(made: Made) -> None:
    boxes = [e for e in made.page._every() if "box" in e.attributes.get("class", "").split()]
    assert boxes
    for box in boxes:
        assert box.attributes["tabindex"] == "0"
        assert box.attributes["role"] == "group"
        assert box.attributes.get("aria-label") or box.attributes["aria-labelledby"] in made.page.ids()


def test_a_page_is_self_contained_and_tells_no_folder(made: Made, tmp_path: Path) -> None:
    for element in made.page._every():
        if element.tag == "script":  # programs have no attributes, data only a type that is not executed
            assert element.attributes in ({}, {"type": "application/x-deflated-table"})
        assert element.tag not in ("link", "iframe", "object", "embed", "base")
        for name, value in element.attributes.items():
            assert not name.startswith("on")
            if name in ("href", "src"):
                assert value.startswith(("#", "data:image/png;base64,")), value
    assert "@import" not in made.html
    assert str(tmp_path.parent.parent) not in made.html
    assert "robot.toml" in made.page.by_id("origin").text


def applied(text: str, difference: list[str]) -> str:
    """Apply a unified difference, as `patch` does, but only where every line agrees."""
    before, after, place = text.split("\n"), [], 0
    if before[-1] == "":
        before.pop()
    ended = True
    for k, line in enumerate(difference[2:], start=2):
        if line.startswith("@@"):
            start = int(line.split()[1].split(",")[0][1:]) - 1
            after += before[place:start]
            place = start
        elif line.startswith("\\"):
            ended = ended and difference[k - 1].startswith("-")
        else:
            if line[0] in " -":
                assert before[place] == line[1:]
                place += 1
            if line[0] in " +":
                after.append(line[1:])
    after += before[place:]
    return "\n".join(after) + ("\n" if ended else "")


@pytest.mark.usefixtures("no_drawing")
@pytest.mark.parametrize("end", ["", "\n", "\n\n", '\n# no end of line: \u00e4 "<b>"\tx'])
def test_the_correction_is_the_file_that_is_saved(
    found: tuple[Diagnosis, Robot, Measurements], tmp_path: Path, end: str
) -> None:
    result, declared, data = found
    text = Path(declared.source).read_text(encoding="utf-8").rstrip("\n") + end
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    robot = read_robot(tmp_path / "robot.toml")
    page = read(report(result, robot=robot, data=data))
    lines = page.by_id("correction").all("code")[0].text.split("\n")[:-1]
    assert lines[:2] == ["--- robot.toml", "+++ robot.toml"]
    updating.save_robot(robot, result, tmp_path / "saved.toml")
    assert applied(text, lines) == (tmp_path / "saved.toml").read_text(encoding="utf-8")


def test_nothing_is_corrected_where_nothing_was_found(made: Made) -> None:
    section, verdict = made.page.by_id("correction"), made.content["verdict"]
    if verdict in ("adequate", "effect_found"):
        assert section.all("code")
    else:
        assert not section.all("code")
        assert f"No correction: the verdict is {verdict}." in section.text


@pytest.mark.usefixtures("no_drawing")
def test_a_comparison_shows_the_numbers_of_its_json(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "report.html"
    assert run(["compare", *map(str, LOOP), "--json", "-", "--report", str(target)]) == 0
    captured = capsys.readouterr()
    content = json.loads(captured.out)
    page = read(target.read_text(encoding="utf-8"))
    found = expect_equal_numbers(content, page)
    numbers = {k for k, v in leaves(content).items() if isinstance(v, float)}
    assert numbers <= set(found)
    assert "larger than the measurement errors" in page.by_id("summary").text
    assert captured.err == f"\nwrote {target}\n"


def test_the_declared_model_differs_as_much_in_a_diagnosis_as_in_a_comparison(tmp_path: Path) -> None:
    """With uncertain poses too: their errors count in the standard deviations of both."""
    robot = read_robot(LOOP[0])
    data = updating.read(LOOP[1], None, robot)
    object.__setattr__(data, "point_sigma", np.full(data.points.shape, 2e-4))
    result = updating.diagnose(robot, data, candidates=["gearbox_compliance"])
    compared = updating.compare(robot, data)
    assert result.stages is not None
    assert result.stages.before.normalised_differences == pytest.approx(
        [row.sigmas for row in compared.rows], rel=1e-9
    )
    assert result.stages.before.partner_mode.tolist() == [
        0 if row.partner is None else row.partner - compared.rigid for row in compared.rows
    ]
    stated = np.log(result.stages.before.frequency / data.frequency) / (data.sigma / data.frequency)
    assert (np.abs(result.stages.before.normalised_differences) <= np.abs(stated)).all()
    assert (np.abs(result.stages.before.normalised_differences) < 0.99 * np.abs(stated)).any()


def nearest(data: Any, row: int) -> float:
    """Distance of a measured mode to the nearest other one at its pose, in ln f."""
    others = (data.pose == data.pose[row]) & (np.arange(len(data.pose)) != row)
    return float(np.abs(np.log(data.frequency[others] / data.frequency[row])).min())


def test_the_mac_of_all_modes_has_that_of_the_pair(
    found: tuple[Diagnosis, Robot, Measurements],
) -> None:
    result, _, data = found
    assert result.stages is not None
    for stage in (result.stages.before, result.stages.refit, result.stages.after):
        assert stage is not None
        rows = np.arange(len(data.frequency))
        alone = stage.mac_by_mode[rows, stage.partner_mode - 1]
        apart = np.array([nearest(data, i) for i in rows])
        single = apart > 0.05  # close modes are compared as one subspace
        assert single.sum() > 10
        assert stage.partner_mac[single] == pytest.approx(alone[single], abs=1e-12)
        assert stage.elastic_frequencies[data.pose, stage.partner_mode - 1] == pytest.approx(
            stage.frequency, rel=1e-12
        )


def test_many_rows_are_cut_to_the_worst_and_the_page_stays_small(shared: Shared) -> None:
    result, _ = made_up(500, 20)
    html = many_modes(shared)
    # A quarter of it is the numbers of the figures, to be saved, and as much the figures for narrow screens.
    assert len(html.encode()) < 4_000_000
    section = read(html).by_id("rows")
    assert "300 measured modes that differ most" in section.text
    assert "10\u202f000 modes are in the output of --json" in section.text
    bodies = section.all("tbody")[0].all("tr")
    assert len(bodies) == 300
    assert result.stages is not None
    assert result.stages.after is not None
    sigmas = np.abs(result.stages.after.normalised_differences)
    lost = int(np.isnan(sigmas).sum())
    assert [("unmatched" in row.text) for row in bodies] == [True] * lost + [False] * (300 - lost)
    last = [float(row.all("data")[-2].attributes["value"]) for row in bodies[lost:]]
    assert np.abs(last) == pytest.approx(np.sort(sigmas[~np.isnan(sigmas)])[::-1][: 300 - lost])
