"""What the diagnosis makes of cases on the virtual rig is frozen: verdict and its rule, classes, values of causes.

Here a few of each suite are run; in tests/loop/diagnosis, where outcomes are held against the truth, each of them
is compared, too.  With ``--whole-suites`` every case runs: an hour and a half on one core.
A change that is meant is written by ``--update-golden``, and reviewed.
"""

from __future__ import annotations

from typing import Any

import pytest

from helpers.golden.case_book import check, said
from helpers.golden.outcomes import GOLDEN
from studies import one_place, one_place_judging
from studies.deciding import SUITES, Line, line_of, read, write

#: The rule that decided each case.
RULES = GOLDEN / "rules.jsonl"
#: Which share of the cases of each suite is run every time: one in this many.
EVERY = {"diagnosis": 400, "mechanisms": 200, "damping": 80, "clear": 120, "one_place": 300}


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("suite", SUITES)
def test_cases_on_the_rig_are_diagnosed_as_they_were(suite: str, pytestconfig: pytest.Config) -> None:
    cases, run = SUITES[suite]
    chosen, every = list(cases()), EVERY[suite]
    if not pytestconfig.getoption("whole_suites"):
        chosen = chosen[every // 2 :: every]
    found: dict[str, Any] = {}
    lines: list[Line] = []
    for case in chosen:
        outcome = run(case)
        found |= said(case, outcome)
        lines.append(line_of(suite, case, outcome))
    assert len(found) == len(chosen)
    check(suite, found, pytestconfig)
    if pytestconfig.getoption("update_golden"):
        write(RULES, lines)
    decided = {line[:2]: line for line in read(RULES)}
    # Of some suites only a part is in the book of rules.
    known = [line for line in lines if line[:2] in decided]
    assert known
    assert known == [decided[line[:2]] for line in known]


@pytest.mark.slow
@pytest.mark.compiler
def test_faults_at_one_place_are_diagnosed_as_they_were(pytestconfig: pytest.Config) -> None:
    """Terms and what they say; the rules of the verdict are counted on the other suites."""
    chosen, every = list(one_place.cases()), EVERY["one_place"]
    if not pytestconfig.getoption("whole_suites"):
        chosen = chosen[every // 2 :: every]
    outcomes = [one_place_judging.run(case) for case in chosen]
    # The errors of shapes, and with them the last digits of values, depend on the signs that LAPACK gives these.
    found = {key: {**one, "values": {}} for o in outcomes for key, one in said(o.case, o).items()}
    check("one_place", found, pytestconfig)
