"""The tables of rules: the documentation prints them, and adding a rule costs an entry and a function."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from helpers.diagnoses.diagnose_command import PUBLISHED, WIND_UP, diagnosed, measured
from pkmodes.diagnosis.verdict import rules, unexplained
from pkmodes.diagnosis.verdict.evidence import Evidence, Rule
from pkmodes.diagnosis.verdict.verdicts import AMBIGUOUS

PAGE = Path(__file__).parents[2] / "docs/diagnosis.md"
#: What the page calls the tables, in its order.
TABLES = {
    "Before a search": rules.before(),
    "Whatever a search found": rules.after(),
    "The declared model leaves noise": rules.ADEQUACY,
    "Causes leave noise": rules.CLAIMS,
    "Nothing leaves noise": unexplained.OPEN,
}
BEGIN, END = "<!-- begin: written by tests/diagnosis/test_rules.py --update-golden -->", "<!-- end -->"


def printed() -> str:
    parts = []
    for title, table in TABLES.items():
        rows = [
            f"| `{rule.name.partition('.')[2]}` | {rule.about} | `{rule.verdict.word}` |" for rule in table
        ]
        parts.append("\n".join([f"| {title} | when | verdict |", "| --- | --- | --- |", *rows]))
    return "\n\n".join(parts)


def test_the_documentation_prints_the_tables(pytestconfig: pytest.Config) -> None:
    page = PAGE.read_text(encoding="utf-8")
    between = re.compile(f"(?<={re.escape(BEGIN)}\n\n).*?(?=\n\n{re.escape(END)})", re.DOTALL)
    if pytestconfig.getoption("update_golden"):
        PAGE.write_text(between.sub(lambda _: printed(), page), encoding="utf-8")
    else:
        found = between.search(page)
        assert found is not None
        assert found.group() == printed()


def test_every_rule_says_when_it_applies() -> None:
    for table in TABLES.values():
        assert len({rule.name for rule in table}) == len(table)
        assert all(rule.about for rule in table)


def test_an_added_rule_decides_before_those_behind_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An entry in a table and a function: what it asks of the evidence, and what it says."""

    def wound_up(e: Evidence) -> str:
        """Somebody wound the gearboxes up."""
        causes = [cause.name for cause in e.final.causes]
        return f"somebody wound up {causes[0]}" if causes == ["gearbox_compliance"] else ""

    monkeypatch.setattr(rules, "CLAIMS", (Rule("claims.wound_up", AMBIGUOUS, wound_up), *rules.CLAIMS))
    options = ("--candidates", "gearbox_compliance,payload")
    found = diagnosed(tmp_path, PUBLISHED, measured(poses=7, effects=WIND_UP), *options)
    assert (found["verdict"], found["reason"]) == ("ambiguous", "somebody wound up gearbox_compliance")
    assert found["effects"] == []
    assert diagnosed(tmp_path, PUBLISHED, measured(), *options)["verdict"] == "adequate"
