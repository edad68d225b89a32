"""Titles of rows and columns belong to the numbers beside them, and a report says what its numbers mean."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from helpers.pages.page_reading import Element, read
from helpers.pages.report_examples import diagnosed, made_up
from helpers.pages.without_drawing import without_drawing
from pkmodes import Model, read_robot, updating
from pkmodes.loop.diagnosis.verdict.findings import Examined, NextMeasurement, Stability
from pkmodes.pages.report import report
from pkmodes.pages.report.model_view import view_of_result

ROOT = Path(__file__).parents[3]
LOOP = [ROOT / "examples" / "closed_loop" / name for name in ("robot.toml", "measured.csv")]


@pytest.fixture(scope="module", autouse=True)
def _no_drawing() -> Iterator[None]:
    with without_drawing():
        yield


@pytest.fixture(scope="module")
def page() -> Element:
    """The report of a result whose errors were 2 and 2.1 % before, 1 and 1.1 % refitted, 0.2 and 0.3 % after."""
    result, data = made_up(6, 3)
    assert result.after is not None
    after = structs.replace(result.after, held_out_rms_relative=0.003)
    return read(report(replace(result, after=after), data=data))


def table(section: Element, number: int = 0) -> tuple[list[str], list[list[str]]]:
    """Column titles, each after that of its group, and rows of a table of a section."""
    found = section.all("table")[number]
    *groups, heads = found.all("thead")[0].all("tr")
    above = [
        cell.text
        for row in groups
        for cell in row.children
        if isinstance(cell, Element)
        for _ in range(int(cell.attributes["colspan"]))
    ]
    titles = [cell.text for cell in heads.all("th")]
    if above:
        titles = [f"{group}: {title}" if group else title for group, title in zip(above, titles, strict=True)]
    rows = [
        [cell.text for cell in row.children if isinstance(cell, Element)]
        for row in found.all("tbody")[0].all("tr")
    ]
    return titles, rows


def facts(section: Element) -> dict[str, str]:
    names, values = section.all("dt"), section.all("dd")
    return {name.text: value.text for name, value in zip(names, values, strict=True)}


def test_each_stage_has_its_errors(page: Element) -> None:
    titles, rows = table(page.by_id("errors"))
    assert titles == ["model", "rms [%]", "held out [%]", "chi\u00b2 per dof"]
    assert rows == [
        ["before: as declared", "2.000", "2.100", "180"],
        ["refit of the uncertain values only", "1.000", "1.100", "61.0"],
        ["after: with the cause", "0.200", "0.300", "1.02"],
    ]


def test_the_head_has_the_first_and_the_last_error(page: Element) -> None:
    head, to_do = facts(page.by_id("summary")), facts(page.by_id("action"))
    assert {name: text for name, text in head.items() if name not in to_do} == {
        "mass [kg]": "0.300 \u00b1 0.010",
        "rms difference as declared [%]": "2.000",
        "rms difference with the cause [%]": "0.200",
        "rms of held-out poses with the cause [%]": "0.300",
        "chi\u00b2 per degree of freedom of all 15 fitted modes, with the cause": "1.02",
    }


def test_a_fitted_value_stands_below_what_it_is(page: Element) -> None:
    titles, (row,) = table(page.by_id("values"))
    assert dict(zip(titles, row, strict=True)) == {
        "value": "payload.mass",
        "role": "cause",
        "before": "0",
        "after": "0.300 \u00b1 0.010",
        "\u03c3 of fit": "0.01",
        "unit": "kg",
        "prior \u03c3": "0.2",
        "moved [prior \u03c3]": "+1.5",
    }


def test_each_measured_mode_stands_beside_each_stage(page: Element) -> None:
    result, _ = made_up(6, 3)
    titles, rows = table(page.by_id("rows"))
    by_line = {int(cells["line"]): cells for row in rows if (cells := dict(zip(titles, row, strict=True)))}
    assert len(by_line) == len(result.rows) == 18
    for row in result.rows:
        cells = by_line[row.line]
        assert cells["setup"] == row.pose
        assert cells["measured: f [Hz]"] == f"{row.measured:.3f}"
        assert cells["measured: \u03c3 [Hz]"] == f"{row.sigma:.3f}"
        for name, predicted in (("model as declared", row.before), ("model with the cause", row.after)):
            if predicted is None:
                assert cells[f"{name}: f [Hz]"] == "\u2013"
                continue
            assert cells[f"{name}: f [Hz]"] == f"{predicted:.3f}"
            percent = float(cells[f"{name}: diff. [%]"].replace("\u2212", "-"))
            assert percent == pytest.approx(100.0 * (predicted - row.measured) / row.measured, abs=0.0051)
            sigmas = float(cells[f"{name}: diff. [\u03c3]"].replace("\u2212", "-"))
            assert sigmas == pytest.approx(np.log(predicted / row.measured) / 0.002, abs=0.051)
        assert cells["MAC"] == ("\u2013" if row.mac is None else f"{row.mac:.3f}")
        assert ("held out" in cells["remark"]) == row.held_out


def test_candidates_have_their_standing(page: Element) -> None:
    titles, rows = table(page.by_id("candidates"))
    found = [dict(zip(titles, row, strict=True)) for row in rows]
    assert [(one["candidate"], one["standing"]) for one in found] == [
        ("payload", "found"),
        ("belt_mass", "not claimed"),
    ]
    assert {(one["p of its score"], one["visible from"]) for one in found} == {("0.1", "0.3")}
    assert "In every row: unit kg, detectable yes." in page.by_id("candidates").text
    assert not {"unit", "detectable", "limit (95 %)"} & set(titles)


@pytest.fixture(scope="module")
def undecided() -> Element:
    """The report of a result in which two explanations remain, one of them of two causes."""
    result, data = made_up(6, 3)
    robot = read_robot(LOOP[0])
    tested = tuple(
        Examined(name, p, (), True) for name, p in (("belt_mass", 1e-3), ("payload", 1e-2), ("link", 0.5))
    )
    load = {"effects.payload.mass": 0.2}
    result = replace(
        result,
        verdict="ambiguous",
        effects=(),
        survivors=(("payload",), ("belt_mass + gearbox_inertia", "link_compliance")),
        candidates=tested,
        next_measurement=NextMeasurement(
            (0.6, -0.05, -0.245), ("payload", "belt_mass"), 7.0, None, load=load
        ),
        stability=(
            Stability("sigma x 0.5", "unexplained", ("payload",)),
            Stability("sigma x 2", "adequate", ()),
            Stability("priors x 2", "effect_found", ("belt_mass", "payload")),
        ),
    )
    return read(report(result, robot=robot, data=data))


def test_what_remains_has_the_number_of_its_explanation(undecided: Element) -> None:
    titles, rows = table(undecided.by_id("candidates"))
    standing = {row[titles.index("candidate")]: row[titles.index("standing")] for row in rows}
    assert standing == {"belt_mass": "remains (2)", "payload": "remains (1)", "link": "not claimed"}
    assert [item.text for item in undecided.by_id("causes").all("li")] == [
        *("payload", "belt_mass + gearbox_inertia or link_compliance")
    ]


def test_the_stability_says_what_was_changed(undecided: Element) -> None:
    (paragraph,) = undecided.by_id("stability").all("p")
    assert paragraph.text == (
        "Stability: unexplained with sigma halved (usual where the stated sigma is right); adequate with sigma "
        "doubled (errors twice as large would explain the residual); the best explanation, which is not claimed, is "
        "belt_mass and payload with priors twice as wide."
    )


def test_the_next_measurement_has_its_pose_and_load(undecided: Element) -> None:
    assert facts(undecided.by_id("action"))["measure next"] == (
        "At x = 0.6000 m, y = \u22120.0500 m, z = \u22120.2450 m, which is expected to separate the explanations "
        "best: payload and belt_mass differ there by 7 standard deviations. Set effects.payload.mass = 0.2 kg"
    )


def test_the_documentation_lists_the_sections() -> None:
    text = (ROOT / "docs" / "how-to/report.md").read_text(encoding="utf-8")
    result, data = made_up(4, 3)
    titles = [title.text for title in read(report(result, data=data)).all("h2")][1:]
    table = re.findall(r"^\| ([^|]+?) \|", text, re.M)[1:]
    listed = [part for cell in table for part in re.split(", or |, ", cell)]
    assert set(titles) <= set(listed)
    # the made-up result has neither rivals, terms nor damping, no robot with poses to show, and no campaign
    missing = {"Pose by pose", "Remaining explanations", "Damping", "In three dimensions"}
    missing |= {"Beyond the catalogue", "Where it is", "Frequency responses"}
    assert set(listed) - set(titles) == {"---", "Summary", *missing}
    assert [t for t in listed if t in titles] == titles


def test_data_and_versions_name_the_files_by_their_content() -> None:
    robot = read_robot(LOOP[0])
    data = updating.read(LOOP[1], None, robot)
    given = facts(read(report(updating.compare(robot, data), robot=robot, data=data)).by_id("origin"))
    for role, file in zip(("robot file", "measurement file"), LOOP, strict=True):
        assert given[role] == file.name
        assert given[f"SHA-256 of the {role}"] == hashlib.sha256(file.read_bytes()).hexdigest()


def test_a_model_that_the_noise_explains_is_said_to_be_within_the_errors(tmp_path: Path) -> None:
    _, robot, data = diagnosed("adequate", tmp_path)
    compared = updating.compare(robot, data)
    assert compared.p_value is not None
    assert compared.p_value > 0.05
    said = read(report(compared, robot=robot, data=data)).by_id("summary")
    assert "The differences are within the measurement errors" in said.text
    assert "tone-good" in said.attributes["class"]


def test_the_view_of_a_diagnosis_is_that_of_the_robot_with_the_cause(tmp_path: Path) -> None:
    result, robot, data = diagnosed("effect_found", tmp_path)
    updating.save_robot(robot, result, tmp_path / "saved.toml")
    html = view_of_result(result, robot, data)
    assert html is not None
    (text,) = re.findall(r'<script type="application/json">(.*?)</script>', html)
    shown = json.loads(text)
    assert [name for name in shown["springs"] if name.startswith("wind-up")] == [
        f"wind-up of gearbox {j}" for j in (1, 2, 3)
    ]
    places = [data.labels.index(label) for label in shown["labels"]]
    assert sorted(places) == list(range(len(data.labels)))
    np.testing.assert_allclose(shown["poses"], data.points[places], atol=1e-6)
    saved = Model(read_robot(tmp_path / "saved.toml"))
    np.testing.assert_allclose(shown["frequencies"], saved.frequencies(data.points[places]), atol=1e-4)
    assert "Model with the cause: the gearboxes wind up" in html
    # Beside every measured mode stands the mode of the model that the result gives as its partner.
    assert len(shown["measured"]["modes"]) == len(result.rows)
    for one, row in zip(shown["measured"]["modes"], result.rows, strict=True):
        assert shown["labels"][one["pose"]] == row.pose
        assert one["frequency"] == pytest.approx(row.measured, abs=1e-4)
        assert shown["frequencies"][one["pose"]][one["mode"]] == pytest.approx(row.after, rel=2e-6)
        assert one["mac"] == (None if row.mac is None else pytest.approx(row.mac, abs=1e-4))
    compared = view_of_result(updating.compare(robot, data), robot, data.points)
    assert compared is not None
    assert "wind-up of gearbox" not in compared
