"""The section on damping of a report: its numbers are those of ``--json``, and it is there only where it belongs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from helpers.diagnoses.damped_cases import columns, made
from helpers.pages.page_reading import Element, at, read, shown
from helpers.pages.without_drawing import without_drawing
from pkmodes import read_robot, updating
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.pages.report import report

ROBOT = read_robot(Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml")
RATIOS = ("damping", "sigma_damping", "sigma_damping_used", "damping_after")


def made_of(rows: dict[str, Any]) -> tuple[Diagnosis, dict[str, Any], Element]:
    data = made(rows)
    result = updating.diagnose(ROBOT, data)
    with without_drawing():
        page = read(report(result, robot=ROBOT, data=data))
    return result, json.loads(json.dumps(result.as_json())), page


@pytest.fixture(scope="module")
def damped() -> tuple[Diagnosis, dict[str, Any], Element]:
    return made_of(columns({"rails": 50.0}))


def test_the_section_has_every_ratio_of_the_json(damped: tuple[Diagnosis, dict[str, Any], Element]) -> None:
    result, content, page = damped
    cells = {
        e.attributes["data-at"]: e for e in page.by_id("damping").all("data") if "data-at" in e.attributes
    }
    assert len(content["rows"]) == len(result.rows) == 48
    assert "In every row: as declared [%] 0." in page.by_id("damping").text
    for i, row in enumerate(content["rows"]):
        assert row["damping_before"] == 0.0  # the robot file declares none, which is said once
        for key in RATIOS:
            cell = cells[f"/rows/{i}/{key}"]
            assert float(cell.attributes["value"]) == at(content, f"/rows/{i}/{key}") == row[key]
            seen, half = shown(cell.text)
            assert abs(seen - 100.0 * row[key]) <= half * (1.0 + 1e-9)  # rounded, in per cent


def test_the_section_says_what_the_result_says(damped: tuple[Diagnosis, dict[str, Any], Element]) -> None:
    result, content, page = damped
    assert f"The verdict is that of frequencies and shapes; {result.damping.reason}." in page.text
    text = page.by_id("damping").text
    assert "Verdict on the damping: effect_found." in text
    assert result.damping.reason[1:] in text
    assert "The model as declared has no damping: it predicts no ratios to compare these with." in text
    assert f"{result.damping.fitted} ratios fitted" in text
    assert result.damping.fitted == sum(row["damping_used"] for row in content["rows"])
    assert f"{result.damping.after:.3g} as diagnosed" in text
    held_out = sum(row["held_out"] for row in content["rows"])
    assert held_out
    assert text.count("held out") == held_out


def test_without_damping_there_is_no_section() -> None:
    rows = columns({"rails": 50.0})
    result, _, page = made_of({name: column for name, column in rows.items() if name != "damping"})
    assert result.damping.verdict == "not_measured"
    assert "damping" not in page.ids()
