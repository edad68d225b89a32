"""The page of results says what the CSV files of the suites say, and these have the columns that the suites write."""

from __future__ import annotations

import argparse
import re
from dataclasses import replace
from pathlib import Path

import pytest

from helpers.pages.documentation import ROOT
from studies import clear_cases, clear_suites, requirements, results, tables
from studies.campaigns import Campaigns
from studies.changed import Changed
from studies.clear_suites import ClearCauses
from studies.damping import Damping
from studies.diagnosis import Diagnosis
from studies.limits import Limits
from studies.mechanism_suites import Mechanisms
from studies.one_place import OnePlace
from studies.running import Outcome
from studies.six_legged_suites import SixLegs
from studies.suite import Suite
from studies.tables import Table

SUITES: dict[str, Suite] = {
    "changed": Changed(),
    "clear-causes": ClearCauses(),
    "damping": Damping(),
    "diagnosis": Diagnosis(),
    "limits": Limits(),
    "mechanisms": Mechanisms(),
    "one-place": OnePlace(),
    "six-legs": SixLegs(),
    "signals": Campaigns(),
}


def test_the_page_is_what_the_command_writes_of_the_files() -> None:
    page = results.PAGE.read_text(encoding="utf-8")
    assert page == results.page(), "run: python -m studies.results"
    assert len(page.split()) <= 3500


def test_the_page_has_every_suite_and_every_file() -> None:
    folders = {folder.name for folder in results.FOLDER.iterdir()}
    assert folders == {section.name for section in results.SECTIONS}
    page = results.PAGE.read_text(encoding="utf-8")
    for file in results.FOLDER.rglob("*.csv"):
        assert f"](../results/{file.relative_to(results.FOLDER).as_posix()})" in page, file


def test_the_page_has_every_requirement_and_marks_those_that_are_not_met() -> None:
    unmet = 0
    for section in results.SECTIONS:
        suite = tables.read(results.FOLDER / section.name)
        if "requirements" in suite:
            records = suite["requirements"].records()
            cells = [
                cell for table in section.tables(suite) for row in table.rows for cell in row[1:] if cell
            ]
            assert len(cells) == len(records) > 0, section.name
            unmet += sum(record["met"] == requirements.NOT_MET for record in records)
    page = results.PAGE.read_text(encoding="utf-8")
    assert page.count(f"{requirements.NOT_MET}**") == unmet > 0


@pytest.mark.parametrize("suite", SUITES)
def test_the_files_have_the_columns_that_a_suite_writes(suite: str) -> None:
    """What comes out of no cases has the columns of what comes out of many."""
    written, kept = SUITES[suite].tables([]), tables.read(results.FOLDER / suite)
    assert {*written, "summary"} == {*kept}
    for name, table in written.items():
        assert table.head == kept[name].head, name


def test_a_table_is_read_as_it_was_written(tmp_path: Path) -> None:
    table = Table.of(("group", "what"), [("a, b", 'says "no"'), ("", "x | y\n")])
    tables.publish({"one": table}, tmp_path / "folder")
    assert tables.read(tmp_path / "folder") == {"one": table}


def test_stacked_tables_have_the_columns_of_all() -> None:
    stacked = tables.stacked("by", {"x": Table.of("ab", ["12"]), "y": Table.of("ac", ["34"])})
    assert stacked == Table.of(("by", "a", "b", "c"), [("x", "1", "2", ""), ("y", "3", "", "4")])


class Numbers(Suite[int, Outcome[int]]):
    """A made-up family: the case n is named if n is even, and raises an exception if it is 3."""

    description = "Numbers."
    seed = 10
    failed = Outcome

    @staticmethod
    def run(case: int) -> Outcome[int]:
        return Outcome(case, "named" if case % 2 == 0 else "wrong" if case != 13 else {}["no"], seconds=case)

    def cases(self, arguments: argparse.Namespace) -> range:
        return range(arguments.seed, arguments.seed + 10)

    def label(self, case: int) -> str:
        return f"number {case}"

    def line(self, outcome: Outcome[int]) -> str:
        return f"{outcome.case}: {outcome.state}"

    def tables(self, outcomes: list[Outcome[int]]) -> tables.Tables:
        return {"outcomes": tables.confusion({"all": outcomes})}


def test_a_family_of_cases_runs_and_writes_its_tables(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "numbers"
    command = ["numbers", "--only", "number 1", "--every", "3", "--jobs", "1", "--out", str(out)]
    monkeypatch.setattr("sys.argv", command)
    Numbers().main()
    assert capsys.readouterr().err.splitlines() == [
        "1/4 10: named",
        "2/4 13: failed",
        "3/4 16: named",
        "4/4 19: wrong",
    ]
    written = tables.read(out)
    assert written["outcomes"].rows == (("all", "4", "2", "0", "1", "0", "0", "1"),)
    facts = written["summary"].values()
    assert facts == {
        "seed": "10",
        "cases": "4",
        "median [s]": "13.0",
        "longest [s]": "19.0",
        "minutes": "0",
        "run by": "1 process",
    }


def test_a_label_that_no_case_has_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.argv", ["numbers", "--only", "letter"])
    with pytest.raises(SystemExit, match='no case has "letter" in its label'):
        Numbers().main()


def test_no_page_speaks_of_a_page_of_a_suite() -> None:
    for page in (ROOT / "docs").rglob("*.md"):
        assert not re.search(r"\w-measured\.md", page.read_text(encoding="utf-8")), page


def test_the_readme_names_files_that_exist_and_every_suite() -> None:
    folder = ROOT / "tests/studies"
    named = set(re.findall(r"`(\w+\.py)`", (folder / "README.md").read_text(encoding="utf-8")))
    assert {*named} <= {file.name for file in folder.glob("*.py")}
    suites = {type(suite).__module__.rpartition(".")[2] + ".py" for suite in SUITES.values()}
    assert suites <= named


def test_the_case_of_the_readme_is_as_it_says() -> None:
    case = next(case for case in clear_suites.cases() if case.label == "corexy, one effect 1")
    specimen, rows, text = clear_cases.measured(replace(case, seed=20261207))
    readme = " ".join((ROOT / "tests/studies/README.md").read_text(encoding="utf-8").split())
    (compliance,) = specimen.effects.values()
    assert case.kinds == ("belt_end_compliance",)
    assert f"{compliance:.2e} m/N".replace("e-07", "e-7") in readme
    assert f"a file of {len(rows)} rows" in readme
    low, high = re.findall(r"[\d.]+(?= Hz)", text.splitlines()[1])
    assert f"a band of {float(low):.0f} to {float(high):.0f} Hz" in readme
    (asked,) = (
        row
        for row in tables.read(results.FOLDER / "clear-causes")["requirements"].records()
        if row["group"] == "corexy, one effect"
    )
    assert f"was {asked['number']} of {asked['cases']}, which is not met" in readme
    assert asked["met"] == requirements.NOT_MET
