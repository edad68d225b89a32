"""The tables of rules: the documentation prints them, and adding a rule costs an entry and a function."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest

from helpers.diagnoses.diagnose_command import PUBLISHED, WIND_UP, diagnosed, measured
from helpers.golden.outcomes import GOLDEN
from pkmodes.loop.diagnosis.beyond.rules import BEYOND_RULES
from pkmodes.loop.diagnosis.damping.rules import DAMPING_RULES
from pkmodes.loop.diagnosis.verdict import rules, unexplained
from pkmodes.loop.diagnosis.verdict.evidence import Evidence, Rule
from pkmodes.loop.diagnosis.verdict.verdicts import AMBIGUOUS
from studies.deciding import SUITES, counts, name_of, read

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs/reference/verdicts.md"
#: What the page calls the tables, in its order.
TABLES = {
    "Before a search": rules.rules_before_search(),
    "Whatever a search found": rules.rules_after_search(),
    "The declared model leaves noise": rules.ADEQUACY_RULES,
    "Causes leave noise": rules.CLAIM_RULES,
    "Nothing leaves noise": unexplained.UNEXPLAINED_RULES,
}
#: The rules beyond the catalogue, on a page of their own.
TERMS_PAGE = ROOT / "docs/reference/terms.md"
#: Tests in which they decide; the others are those of the catalogue, asked of terms.
TERMS_SHOWN_BY = dict.fromkeys(
    (
        *("beyond.nothing", "beyond.leaves_more", "beyond.one_row", "beyond.errors", "beyond.implausible"),
        *("beyond.several", "beyond.law", "beyond.not_specific", "beyond.held_out", "beyond.found"),
    ),
    "tests/loop/diagnosis/test_beyond.py",
)
#: Tests of the rules that decide no case of the suites.
SHOWN_BY = {
    "after.amplitude": "tests/loop/diagnosis/test_amplitude.py",
    "after.dead_channel": "tests/loop/diagnosis/test_notes.py",
    "claims.default": "tests/loop/diagnosis/test_what_a_value_includes.py",
    "claims.dispersion": "tests/loop/diagnosis/test_dispersion.py",
    "claims.more_general": "tests/loop/diagnosis/test_nested.py",
    "claims.one_term": "tests/loop/diagnosis/test_terms_and_causes.py",
    **dict.fromkeys(
        (
            *("claims.better_shapes", "claims.not_settled"),
            *("claims.priors", "open.unmatched", "open.value_far_away", "open.beyond_prior", "open.small"),
        ),
        "tests/loop/diagnosis/test_what_a_claim_rests_on.py",
    ),
}
BEGIN, END = "<!-- begin: written by tests/loop/diagnosis/test_rules.py --update-golden -->", "<!-- end -->"


def printed() -> str:
    lines = read(GOLDEN / "rules.jsonl")
    cases = ", ".join(
        f"{number} of `{suite}`" for suite, number in Counter(line.suite for line in lines).items()
    )
    decided, parts = counts(lines), [f"Cases counted: {cases}."]
    for title, table in TABLES.items():
        rows = [f"| {title} | when | verdict | decided | rightly |", "| --- | --- | --- | ---: | ---: |"]
        for rule in table:
            cells = [f"`{rule.name.partition('.')[2]}`", rule.applies_when, f"`{rule.verdict.word}`"]
            shown = ("0", f"`{Path(SHOWN_BY.get(rule.name, '')).name}`")
            often = map(str, decided[rule.name]) if rule.name in decided else shown
            rows.append(f"| {' | '.join([*cells, *often])} |")
        parts.append("\n".join(rows))
    rows = ["| Measured damping | when | verdict on the damping |", "| --- | --- | --- |"]
    rows += [
        f"| `{rule.name.partition('.')[2]}` | {rule.applies_when} | `{rule.verdict.word}` |"
        for rule in DAMPING_RULES
    ]
    return "\n\n".join([*parts, "\n".join(rows)])


def printed_terms() -> str:
    rows = ["| rule | when | status | shown by |", "| --- | --- | --- | --- |"]
    for rule in BEYOND_RULES:
        shown = Path(TERMS_SHOWN_BY.get(rule.name, "")).name
        cells = [f"`{rule.name.partition('.')[2]}`", rule.applies_when, f"`{rule.verdict.word}`"]
        rows.append(f"| {' | '.join([*cells, f'`{shown}`' if shown else ''])} |")
    return "\n".join(rows)


@pytest.mark.parametrize(("path", "text"), [(PAGE, printed), (TERMS_PAGE, printed_terms)])
def test_the_documentation_prints_the_tables(
    path: Path, text: Callable[[], str], pytestconfig: pytest.Config
) -> None:
    page = path.read_text(encoding="utf-8")
    between = re.compile(f"(?<={re.escape(BEGIN)}\n\n).*?(?=\n*{re.escape(END)})", re.DOTALL)
    if pytestconfig.getoption("update_golden"):
        path.write_text(between.sub(lambda _: text(), page), encoding="utf-8")
    else:
        found = between.search(page)
        assert found is not None
        assert found.group().rstrip() == text()


def test_every_rule_beyond_the_catalogue_is_shown_by_a_test_or_asked_of_causes_too() -> None:
    of_causes = {rule.ask for rule in rules.CLAIM_RULES}
    own = {rule.name for rule in BEYOND_RULES if rule.ask not in of_causes} - {"beyond.in_the_catalogue"}
    assert own <= {*TERMS_SHOWN_BY} <= {rule.name for rule in BEYOND_RULES}
    for name, test in TERMS_SHOWN_BY.items():
        assert f'"{name}"' in (ROOT / test).read_text(encoding="utf-8"), name


def test_every_rule_decides_a_case_of_the_suites_or_of_a_test() -> None:
    names = {rule.name for table in TABLES.values() for rule in table}
    decided = set(counts(read(GOLDEN / "rules.jsonl")))
    assert decided <= names
    assert names - decided == {*SHOWN_BY}
    for name, test in SHOWN_BY.items():
        assert f'"{name}"' in (ROOT / test).read_text(encoding="utf-8"), name


def test_every_counted_case_is_one_of_its_suite_and_counted_once() -> None:
    counted = [line[:2] for line in read(GOLDEN / "rules.jsonl")]
    assert len(counted) == len({*counted})
    assert {*counted} <= {(suite, name_of(case)) for suite, (cases, _) in SUITES.items() for case in cases()}


def test_every_rule_says_when_it_applies() -> None:
    for table in (*TABLES.values(), DAMPING_RULES, BEYOND_RULES):
        assert len({rule.name for rule in table}) == len(table)
        assert len({rule.name.partition(".")[0] for rule in table}) == 1
        assert all(rule.applies_when for rule in table)


def test_an_added_rule_decides_before_those_behind_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An entry in a table and a function: what it asks of the evidence, and what it says."""

    def wound_up(e: Evidence) -> str:
        """Somebody wound the gearboxes up."""
        causes = [cause.name for cause in e.final.causes]
        return f"somebody wound up {causes[0]}" if causes == ["gearbox_compliance"] else ""

    monkeypatch.setattr(
        rules, "CLAIM_RULES", (Rule("claims.wound_up", AMBIGUOUS, wound_up), *rules.CLAIM_RULES)
    )
    options = ("--candidates", "gearbox_compliance,payload")
    found = diagnosed(tmp_path, PUBLISHED, measured(poses=7, effects=WIND_UP), *options)
    assert (found["verdict"], found["reason"]) == ("ambiguous", "somebody wound up gearbox_compliance")
    assert found["effects"] == []
    assert diagnosed(tmp_path, PUBLISHED, measured(), *options)["verdict"] == "adequate"
